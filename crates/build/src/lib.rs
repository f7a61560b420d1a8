//! From height scans to BRDF tables: reading and preparing scans, the optics, building table sets, and how accurate they
//! are.
//!
//! # Conventions
//!
//! - **Directions.** `wi` and `wo` are unit vectors to the light and to the viewer, both away from the surface, in the frame
//!   x along scan columns, y up the image, z the outward normal. `q = (u, v, w) = -wi - wo`, hence `w <= 0`; `u = v = 0` is the
//!   mirror direction.
//! - **Sign.** Heights are positive outward. A height `h` turns the phase by `k w h`, and spectra are
//!   `P(ξ, η) = ∬ g exp(i k w h) exp(+2πi(ξx + ηy)) dx dy` with `ξ = u/λ`, `η = v/λ`, `k = 2π/λ`, window amplitude `g`.
//! - **Normalisation.** `f = D ⟨|P|²⟩ / (λ² A w²)`, `A = ∬ g²`, in 1/sr, with the front factor `D` (`R G` where it is scalar): a
//!   flat mirror has `∫ f cos θo dω = R`. XYZ are
//!   relative to the illuminant, `Y = ∫ S ȳ f dλ / ∫ S ȳ dλ`: a white Lambertian surface has `Y = 1/π`. `f` does not contain the
//!   cosine of the light.
//! - **Order.** Images have shape `[rows, columns]` or `[rows, columns, 3]`; row 0 is the top: the +y edge of a scan, `v = +2` of a
//!   table. The three channels are X, Y, Z.
//! - **Units.** Lengths in nm unless the last word of the name says otherwise (`sigma_um` in manifests), frequencies in
//!   1/nm, angles in radians except where named `_deg`, the BRDF in 1/sr.
//! - **Determinism.** The same input gives the same bits on any number of threads.
//!
//! # Usage
//!
//! Tables of a small sinusoidal grating, held against the direct sum over the scan:
//!
//! ```
//! use diffraction_brdf::direction::from_angles_deg;
//! use diffraction_brdf::spectrum::{Illuminant, Line};
//! use diffraction_build::height::synthesize::{Structure, synthesize};
//! use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};
//! use diffraction_build::optics::reference;
//! use diffraction_brdf::evaluate::{self, Interpolation};
//! use diffraction_build::tables::input::BuildInput;
//! use diffraction_build::tables::model::{Basis, Prefilter, Storage, TablesConfig};
//!
//! // 8 periods of 1.6 µm along x, 120 nm from valley to peak.
//! let grating = Structure::Sinusoid { period_nm: 1_600.0, amplitude_nm: 60.0, direction_deg: 0.0 };
//! let scan = synthesize(&grating, [128, 32], [100.0, 100.0])?;
//!
//! let laser = Illuminant::Lines(vec![Line { wavelength_nm: 550.0, power: 1.0 }]);
//! let optics = OpticsConfig::ideal(laser, 1_500.0, Edge::Tile, Windows::Grid);
//! let config = TablesConfig {
//!     basis: Basis::Chebyshev,
//!     tolerance: 1e-4,
//!     size: Some(401), // four texels per standard deviation of an order: look-ups err by 3e-4
//!     count: None,
//!     wavelength_step_nm: None,
//!     storage: Some(Storage::Float),
//!     prefilter: Prefilter::None,
//!     memory_mib: 256,
//! };
//! let scans = [scan];
//! let (tables, _) = diffraction_build::tables::build::build(&BuildInput::new(&scans, &optics, &config), &|_| ())?;
//!
//! // Light along the normal; the first order leaves at sin θ = λ / period.
//! let wi = [0.0, 0.0, 1.0];
//! let wo = from_angles_deg((550.0f64 / 1_600.0).asin().to_degrees(), 0.0);
//! let [_, y, _] = evaluate::brdf_xyz(&tables, Interpolation::Cubic, wi, wo);
//! let [_, exact, _] = reference::brdf_xyz(&scans, &optics, wi, wo)?;
//! assert!((y / exact - 1.0).abs() < 1e-3, "{y} {exact}");
//! # Ok::<(), diffraction_brdf::error::Error>(())
//! ```
//!
//! From files, [`height::read`] and [`height::prepare`] give height fields; `storage` of `diffraction-brdf` keeps tables as EXR.
//!
//! # Floors
//!
//! A module uses those before it: [`ground`], [`height`], [`optics`], [`tables`], [`accuracy`].

pub mod accuracy;
pub mod ground;
pub mod height;
pub mod optics;
pub mod tables;
