//! Reads an atlas of diffraction tables, and evaluates and samples the BRDF that they hold.
//!
//! # Conventions
//!
//! - **Frame.** `wi` and `wo` are unit vectors to the light and to the viewer, both away from the surface: x along the
//!   columns of the scan, y up the scan, z the outward normal. With `(u, v, w) = -wi - wo`, `u = v = 0` is the mirror
//!   direction, and `w <= 0`.
//! - **Sign.** Heights are positive outward. Look-ups in `w` go by its magnitude: `t = |w| / sqrt(4 - u² - v²)`, in [0, 1].
//! - **Normalisation.** Values are the BRDF `f(wi, wo)` without the cosine of the light: a light of irradiance `E` on a plane that
//!   faces it gives the radiance `f cos_theta_i E`. X, Y, Z are relative to the illuminant for which the tables were made:
//!   a white Lambertian surface has `Y = 1/π`, and `E` is a plain number, the light's luminous irradiance. Colours of
//!   gratings lie outside sRGB: convert after lights are summed.
//! - **Units.** The BRDF and densities in 1/sr, weights of samples and (u, v, w) without unit, angles in radians except
//!   where named `_deg`.
//! - **Order.** Images have shape `[rows, columns, 3]`; row 0 is the top, `v = +2`; channels are X, Y, Z.
//! - **No answer.** Tables may be made for certain scenes only. Where they have no answer the value is not a number, no
//!   direction is drawn, and [`Brdf::answers`] says so beforehand. Directions below the surface have the value 0.
//!
//! # Usage
//!
//! A complete reader, which holds every specimen against the values that the atlas states for it:
//!
//! ```
//! # mod tiny { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/tiny_atlas/mod.rs")); }
//! # let folder = tempfile::tempdir()?;
//! # tiny::write_tiny_atlas(folder.path());
//! # let path = folder.path();
//! use diffraction_brdf::Atlas;
//!
//! let atlas = Atlas::open(path)?;
//! for specimen in atlas.specimens() {
//!     let brdf = atlas.brdf(&specimen.name)?;
//!     for check in brdf.check_values() {
//!         let xyz = brdf.eval(check.wi, check.wo);
//!         assert!((xyz[1] - check.xyz[1]).abs() <= 1e-6 * check.xyz[1]);
//!     }
//! }
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! [`Brdf::sample`] and [`Brdf::pdf`] are for path tracers; the example `path_trace_ball` is one of about a hundred lines.
//! [`Brdf::eval_filtered`] takes a light with a size, or a pixel of a curved surface, in one look-up: a [`Footprint`].
//! [`shader::TABLES_WGSL`] evaluates the same tables on a GPU, and [`shader::table_image`] puts them into the layout that it
//! reads. [`shader_spectral::SPECTRAL_WGSL`] and [`shader_spectral::spectral_image`] do so for spectral tables:
//! `brdf_spectral(wi, wo, wavelength_nm)` in WGSL. [`shader_sampling::TABLES_SAMPLED_WGSL`] draws directions there.
//!
//! # Features
//!
//! - `rayon`: reads files and evaluates slices of directions on several threads. Off by default.
//!
//! # Errors
//!
//! An [`Error`] says whose fault it is, which file, and what to do. No file makes this crate panic; files that were changed
//! after they were published are told by their digests.

pub mod atlas;
mod brdf;
pub mod chebyshev;
mod cie_data;
pub mod derived;
pub mod direction;
pub mod dispersion;
mod dispersion_data;
pub mod energy;
pub mod error;
pub mod evaluate;
mod exr_header;
pub mod exr_image;
pub mod files;
pub mod filtered;
pub mod footprint;
pub mod front_factor;
pub mod json;
mod lobe_gaussians;
mod lobe_mean;
pub mod material;
mod mips;
mod parallel;
mod pyramid;
mod reader;
mod sampling;
pub mod shader;
pub mod shader_floats;
pub mod shader_sampling;
pub mod shader_spectral;
pub mod specimen;
pub mod spectral;
mod spectral_light;
pub mod spectral_storage;
pub mod spectrum;
pub mod splines;
pub mod storage;
mod stored_image;
pub mod table_set;

pub use brdf::{Brdf, Sample};
pub use direction::{Vec3, Xyz};
pub use dispersion::Dispersion;
pub use energy::EnergyLimit;
pub use error::{Error, Result};
pub use evaluate::Interpolation;
pub use filtered::FilteredSpectral;
pub use footprint::Footprint;
pub use front_factor::{Factor, FrontFactor};
pub use material::Material;
pub use reader::Atlas;
pub use spectral::SpectralTables;
pub use spectral_light::UnderLight;
pub use splines::Splines;
pub use table_set::{Basis, Lobe, Restriction, TableSet};
