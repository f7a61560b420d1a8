//! What scenes may ask for: the one place that readers of scenes and their checks take limits from.

/// Largest picture side in pixels.
pub const SIZE_MAX_PX: usize = 8192;

/// Most samples of a light, a beam, or a pixel.
pub const SAMPLES_MAX: usize = 4096;

/// Most samples in one row of the picture, which is rendered at a time: 117 MB.
pub const ROW_SAMPLES_MAX: usize = 1 << 22;

/// Most lights of one scene.
pub const LIGHTS_MAX: usize = 64;

/// Most frames of an animation.
pub const FRAMES_MAX: usize = 1000;

/// Most frames per second.
pub const FPS_MAX: usize = 60;

/// Most pixels of all frames of an animation: 64 of 1024 x 1024.
pub const ANIMATION_PIXELS_MAX: usize = 1 << 26;

/// Shortest and longest length of a scene in mm.
pub const LENGTH_MM: [f64; 2] = [1e-3, 1e6];

/// Steepest tilt and incidence in degrees: at 90 nothing is lit.
pub const TILT_MAX_DEG: f64 = 89.0;

/// Largest turn in degrees, either way.
pub const TURN_MAX_DEG: f64 = 360.0;

/// Largest full angle of a light's disc in degrees: half of the hemisphere.
pub const DIAMETER_MAX_DEG: f64 = 90.0;

/// Largest relative irradiance, and factor on an environment.
pub const IRRADIANCE_MAX: f64 = 1e6;

/// Largest exposure value in stops, either way: far beyond any use and still a finite 32-bit number.
pub const EV_MAX: f64 = 40.0;
