//! Pictures of surfaces: scenes, the directions that their pixels need, and shading on the CPU and on a GPU.
//!
//! # Conventions
//!
//! - **World.** x to the right of the picture, y up, z towards the camera. Directions handed to a BRDF are in the surface's own frame,
//!   as `diffraction-brdf` has them.
//! - **Order.** Pictures have shape `[rows, columns, 3]`, row 0 at the top; channels are X, Y, Z, linear, without exposure.
//! - **Light.** A light gives a white surface that faces it and reflects everything evenly Y = 1/π; sums run in a fixed order, so
//!   that pictures are the same on any number of threads.
//!
//! # Usage
//!
//! A ball of a white matt surface, lit from the camera:
//!
//! ```
//! use diffraction_render::render::cpu;
//! use diffraction_render::scene::model::{Light, Scene, Shape};
//! use std::f64::consts::FRAC_1_PI;
//!
//! let ball = Scene::still("ball", Shape::Sphere, vec![Light::point([0.0, 0.0, 1.0])], 32);
//! let picture = cpu::render(&ball, &|_wi, _wo| [FRAC_1_PI; 3])?;
//! // Towards the middle the light falls straight; beyond the ball there is none.
//! assert!((f64::from(picture[[16, 16, 1]]) * std::f64::consts::PI - 1.0).abs() < 0.01);
//! assert_eq!(picture[[0, 0, 1]], 0.0);
//! # Ok::<(), diffraction_brdf::Error>(())
//! ```
//!
//! # Floors
//!
//! A module uses those before it: [`error`], [`scene`], [`render`].

pub mod error;
pub mod render;
pub mod scene;
