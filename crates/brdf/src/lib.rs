//! Reads an atlas of diffraction tables, and evaluates and samples the BRDF that they hold.

pub mod atlas;
mod brdf;
pub mod chebyshev;
pub mod direction;
pub mod error;
pub mod evaluate;
mod exr_header;
pub mod exr_image;
pub mod files;
pub mod front_factor;
pub mod json;
pub mod material;
mod parallel;
mod reader;
mod sampling;
pub mod shader;
pub mod specimen;
pub mod storage;
pub mod table_set;

pub use brdf::{Brdf, Sample};
pub use direction::{Vec3, Xyz};
pub use error::{Error, Result};
pub use evaluate::Interpolation;
pub use front_factor::{Factor, FrontFactor};
pub use material::Material;
pub use reader::Atlas;
pub use table_set::{Basis, Lobe, Served, TableSet};
