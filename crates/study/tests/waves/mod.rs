//! What studies under test share: a surface, and settings that take seconds.

use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};
use diffraction_study::study::{SceneSamples, StudyConfig, StudySpecimen};
use ndarray::Array2;

/// Waves of up to about this height, either way from the mean, with these scenes.
pub fn specimen(height_nm: f64, scenes: Vec<Box<dyn SceneSamples>>) -> StudySpecimen {
    let heights_nm = Array2::from_shape_fn((128, 128), |(row, column)| {
        let (x, y) = (column as f64 / 128.0, row as f64 / 128.0);
        // Waves of many directions: dark gaps between orders would leave nothing to compare.
        (0..24)
            .map(|i| {
                let (a, b) = (2.0 * f64::from(i % 7) + 1.0, 2.0 * f64::from(i % 11) - 10.0);
                (std::f64::consts::TAU * (a * x + b * y) + f64::from(i * i)).sin()
            })
            .sum::<f64>()
            * height_nm
            / 28.0
    });
    StudySpecimen {
        name: format!("waves {height_nm} nm"),
        fields: vec![HeightField { heights_nm, pitch_nm: [90.0, 90.0] }],
        optics: OpticsConfig::ideal(Illuminant::D65, 900.0, Edge::Tile, Windows::Grid),
        scenes,
        lights: Vec::new(),
    }
}

/// A study of seconds.
pub fn config() -> StudyConfig {
    StudyConfig {
        directions: 40,
        timed_directions: 2_000,
        size: 141,
        chebyshev: vec![2, 6],
        taylor: vec![6, 24],
        harmonics: vec![4],
        light_fields: vec![[8, 32], [64, 256]],
        paths: vec![64, 4096],
        wavelength_steps_nm: vec![40.0, 5.0],
        sizes: vec![41, 141],
        equal_size: 101,
        tolerances: vec![1e-2],
        size_max: 201,
        picture_samples: 1_000,
        light_pixels: 6,
        light_points: 64,
        gpu: false,
        memory_mib: 512,
    }
}
