//! Generated height fields: gratings with known orders, random surfaces, and surfaces modelled on real ones.
//!
//! Nothing here was measured. The snake and disc structures follow published descriptions and pictures and are
//! named `..._like` wherever they are stored. All elementary functions come from `libm`, so that a
//! field has the same bits on every machine.

mod cd_track;
mod fingers;
mod gratings;
mod grid;
mod random;

use ndarray::Array2;
use serde::{Deserialize, Serialize};

use self::grid::Grid;
use crate::height::HeightField;
use diffraction_brdf::error::Result;

/// What to generate. Gratings have exactly the period asked for and repeat only on a tile that holds whole
/// periods, see [`Structure::repeats`]; all others repeat exactly on every tile.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
#[serde(tag = "structure", rename_all = "snake_case")]
pub enum Structure {
    /// `amplitude cos(2 pi s / period)`, `s` along the grating vector.
    Sinusoid {
        /// Period in nm.
        period_nm: f64,
        /// Half the peak-to-valley height in nm.
        amplitude_nm: f64,
        /// Direction of the grating vector in degrees, counter-clockwise from +x with y up.
        direction_deg: f64,
    },
    /// Sawtooth rising with x; each sample is the mean over its cell.
    Blazed {
        /// Period in nm.
        period_nm: f64,
        /// Peak-to-valley height in nm.
        depth_nm: f64,
    },
    /// Rectangular grooves along y; each sample is the mean over its cell.
    Lamellar {
        /// Period in nm.
        period_nm: f64,
        /// Height of the lands above the grooves in nm.
        depth_nm: f64,
        /// Share of the period that is land, between 0 and 1.
        duty: f64,
    },
    /// Tracks of pits along x, with the dimensions of a compact disc.
    CdTrack {
        /// Chooses the run lengths.
        seed: u64,
    },
    /// Modelled on a scale of the corn snake, *Elaphe guttata*: long tapered fingers 1.14 um apart.
    CornSnake {
        /// Chooses the irregularities.
        seed: u64,
    },
    /// Modelled on a scale of the sunbeam snake, *Xenopeltis unicolor*: rows 1.55 um apart of short fingers.
    SunbeamSnake {
        /// Chooses the irregularities.
        seed: u64,
    },
    /// Gaussian random surface with autocorrelation `exp(-(r / correlation_length)^2)`.
    GaussianRough {
        /// Root mean square of the heights about their mean in nm; met exactly.
        rms_nm: f64,
        /// Distance in nm at which the autocorrelation falls to 1/e.
        correlation_length_nm: f64,
        /// Chooses the surface.
        seed: u64,
    },
    /// All heights 0.
    Flat,
}

impl Structure {
    /// Whether the field of this structure continues without a seam when its tile is repeated: for a
    /// grating, whether the tile holds a whole number of periods along x and along y, within a
    /// millionth of a period.
    pub fn repeats(&self, size: [usize; 2], pitch_nm: [f64; 2]) -> bool {
        let vector = match *self {
            Self::Sinusoid { period_nm, direction_deg, .. } => gratings::vector(period_nm, direction_deg),
            Self::Blazed { period_nm, .. } | Self::Lamellar { period_nm, .. } => [1.0 / period_nm, 0.0],
            _ => return true,
        };
        (0..2).all(|axis| {
            let periods = vector[axis] * size[axis] as f64 * pitch_nm[axis];
            (periods - periods.round()).abs() < 1e-6
        })
    }
}

/// Generates a height field of `size` samples along x and y, `pitch_nm` apart.
///
/// The number of snake fingers and rows, disc tracks and channel bits is rounded to whole numbers per
/// tile, so their spacing is the published one up to half of one in that number.
///
/// # Errors
/// `Error::Call` for parameters out of reason, and where the pitch is too coarse for the structure or
/// the tile too small; `Error::Limit` for more than 2^26 samples.
pub fn synthesize(structure: &Structure, size: [usize; 2], pitch_nm: [f64; 2]) -> Result<HeightField> {
    let grid = Grid::new(size, pitch_nm)?;
    let heights_nm = match *structure {
        Structure::Sinusoid { period_nm, amplitude_nm, direction_deg } => {
            gratings::sinusoid(&grid, period_nm, amplitude_nm, direction_deg)?
        }
        Structure::Blazed { period_nm, depth_nm } => gratings::blazed(&grid, period_nm, depth_nm)?,
        Structure::Lamellar { period_nm, depth_nm, duty } => gratings::lamellar(&grid, period_nm, depth_nm, duty)?,
        Structure::CdTrack { seed } => cd_track::generate(&grid, seed)?,
        Structure::CornSnake { seed } => fingers::generate(&grid, &fingers::CORN_SNAKE, seed)?,
        Structure::SunbeamSnake { seed } => fingers::generate(&grid, &fingers::SUNBEAM_SNAKE, seed)?,
        Structure::GaussianRough { rms_nm, correlation_length_nm, seed } => {
            random::rough_checked(&grid, rms_nm, correlation_length_nm, seed)?
        }
        Structure::Flat => Array2::zeros([size[1], size[0]]),
    };
    Ok(HeightField { heights_nm, pitch_nm })
}

/// The generated files of `specimens/`: name without `.tif`, structure, size, pitch in nm. All repeat
/// exactly.
pub fn bundled() -> Vec<(&'static str, Structure, [usize; 2], [f64; 2])> {
    vec![
        // 28 fingers 1140 nm apart.
        ("corn_snake_like", Structure::CornSnake { seed: 1 }, [512, 512], [62.34375; 2]),
        // 20 rows 1550 nm apart.
        ("sunbeam_snake_like", Structure::SunbeamSnake { seed: 1 }, [512, 512], [60.546875; 2]),
        ("blazed_2500nm", Structure::Blazed { period_nm: 2500.0, depth_nm: 250.0 }, [500, 64], [50.0; 2]),
        (
            "sinusoid_1600nm",
            Structure::Sinusoid { period_nm: 1600.0, amplitude_nm: 60.0, direction_deg: 0.0 },
            [512, 64],
            [50.0; 2],
        ),
        // 20 tracks 1600 nm apart.
        ("cd_track_like", Structure::CdTrack { seed: 1 }, [512, 512], [62.5; 2]),
    ]
}

#[cfg(test)]
mod tests;
