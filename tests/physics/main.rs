//! The optics against closed forms, symmetries and an independent evaluator.

#[macro_use]
#[path = "../common/skip.rs"]
mod skip;
#[path = "../common/mod.rs"]
mod common;

mod auto_edge;
mod body_width;
mod dispersion;
mod gratings;
mod mirror;
mod random;
mod reference_values;
mod source_size;
mod spectral;
mod symmetry;
mod table_values;
mod taylor;
