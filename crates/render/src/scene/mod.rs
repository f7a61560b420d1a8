//! Scene floor: shapes, lights and cameras, and the directions each pixel needs.
//!
//! World frame of every scene: x to the right of the picture, y up, z towards the camera.

pub mod animation;
pub(crate) mod bvh;
pub mod camera;
pub mod environment;
pub(crate) mod exr_foreign;
pub mod filtered;
pub mod frame;
pub mod gbuffer;
pub mod hemisphere;
pub mod hit;
pub mod light;
pub mod limits;
pub mod mesh;
pub mod mesh_file;
pub mod model;
pub mod patch;
pub mod reach;
pub mod row;
pub mod samples;
pub mod scales;
pub mod screen;
pub mod snake;
pub mod sphere;
pub mod surface;
pub mod surroundings;
pub mod tangents;
pub mod triangles;
pub mod turn;
