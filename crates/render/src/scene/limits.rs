//! What a scene may ask for: one set of bounds, for scenes from manifests and for all others.

/// Largest side of a picture in pixels.
pub const SIZE_MAX_PX: usize = 8192;

/// Largest number of samples of a light, a beam, or a pixel.
pub const SAMPLES_MAX: usize = 4096;

/// Largest number of samples in one row of the picture, which is rendered at a time: 117 MB.
pub const ROW_SAMPLES_MAX: usize = 1 << 22;

/// Most pixels of all frames of an animation: 64 of 1024 x 1024.
pub const ANIMATION_PIXELS_MAX: usize = 1 << 26;

/// Shortest and longest length of a scene in mm.
pub const LENGTH_MM: [f64; 2] = [1e-3, 1e6];

/// Steepest tilt and incidence in degrees: at 90 nothing is lit.
pub const STEEPEST_DEG: f64 = 89.0;

/// Widest disc of a light in degrees.
pub const LIGHT_DIAMETER_MAX_DEG: f64 = 90.0;

/// Brightest light, as relative irradiance.
pub const IRRADIANCE_MAX: f64 = 1e6;

/// Strongest exposure either way, in stops.
pub const EXPOSURE_MAX_EV: f64 = 40.0;
