//! Diffraction atlas: BRDF tables of structural colour from height scans.
//!
//! A height scan of an iridescent surface goes in; a short stack of tables comes out, from which the BRDF for
//! any two directions is a handful of look-ups. The program of the same name runs this library from a
//! manifest and publishes an atlas of EXR files.
//!
//! Directions, signs, normalisation, order and units are those of [`diffraction_build`]; its page builds tables from a scan in
//! twenty lines, and that of [`diffraction_brdf`] reads an atlas.
//!
//! # Usage
//!
//! A manifest's text becomes plain data, checked and with every default filled in:
//!
//! ```
//! use diffraction_atlas::manifest;
//!
//! let text = r#"
//! schema = 1
//! [atlas]
//! name = "gratings"
//! [[specimen]]
//! name = "sinusoid"
//! scans = ["specimens/sinusoid_1600nm.tif"]
//! material = "ideal"
//! "#;
//! let manifest = manifest::parse(text, "pipeline.toml")?;
//! assert_eq!(manifest.tables.tolerance, 1e-3);
//!
//! let misspelt = manifest::parse(&text.replace("material", "materiel"), "pipeline.toml");
//! assert!(misspelt.unwrap_err().to_string().starts_with("pipeline.toml:8:1: "));
//! # Ok::<(), diffraction_atlas::error::Error>(())
//! ```
//!
//! [`stages::run::pipeline`] runs it, from scans to a published atlas.
//!
//! # Floors
//!
//! A module uses those before it: [`error`], [`stages`], [`manifest`] and [`report`], [`cli`]. Below them lie the crates
//! [`diffraction_brdf`], [`diffraction_build`] and [`diffraction_render`]; docs/architecture.md draws them all.

pub mod cli;
pub mod error;
pub mod manifest;
pub mod report;
pub mod stages;
