//! Tables restricted to what scenes look up: which texels, which `|w|` at each, and what follows for rings, nodes,
//! transforms and the lobe.
//!
//! One way in: [`find::cover`] asks scenes what they look up, [`super::plan::plan_for`] plans tables for that, and
//! [`budget::account`] tells what is saved.

pub mod budget;
pub mod find;
pub(super) mod nodes;
pub mod ranges;
pub(super) mod restrict;
mod rings;
pub(super) mod shares;
mod smooth;
