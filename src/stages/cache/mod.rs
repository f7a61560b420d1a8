//! Whole results kept from run to run: tables before rounding, values of the reference and of the direct sum.

pub(crate) mod known;
pub(crate) mod store;
