//! Optics floor: Fresnel reflectance, coherence windows, the transforms of `exp(i s h)`, the reference.

pub mod config;
