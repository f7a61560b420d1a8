//! Optics floor: a pigment below, the light's coherence and its windows, the transforms of `exp(i s h)`, the reference.

mod axis_lines;
pub mod coherence;
pub mod config;
pub mod dispersive;
pub mod factors;
pub mod kernel;
pub mod left_out;
pub mod light;
pub mod lines;
pub mod materials;
pub mod pigment;
pub mod powers;
pub mod reference;
pub mod spectra;
pub mod spectral;
pub mod validity;
pub mod window;
