//! Reads an atlas of diffraction tables, and evaluates the BRDF that they hold.

pub mod atlas;
pub mod chebyshev;
pub mod direction;
pub mod error;
pub mod evaluate;
pub mod exr_header;
pub mod exr_image;
pub mod files;
pub mod front_factor;
pub mod json;
pub mod material;
pub mod shader;
pub mod specimen;
pub mod storage;
pub mod table_set;
