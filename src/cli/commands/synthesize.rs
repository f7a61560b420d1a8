//! `synthesize`: generated height fields as TIFF files.

use std::path::PathBuf;

use crate::cli::lengths::{PitchNm, SizePx, finite, positive, share};

/// Arguments of `synthesize`.
#[derive(Debug, Clone, PartialEq, clap::Args)]
#[command(after_help = "Examples:
  diffraction-atlas synthesize sinusoid --period-nm 1600 --amplitude-nm 60 --size 512,64 --pitch-nm 50 --out s.tif
  diffraction-atlas synthesize corn-snake --seed 7 --out snake.tif")]
pub struct SynthesizeArgs {
    /// What to generate
    #[command(subcommand)]
    pub structure: StructureArgs,
}

/// Size, spacing, and place of the file, for every structure.
#[derive(Debug, Clone, PartialEq, clap::Args)]
pub struct FieldArgs {
    /// Samples: one number, or X,Y
    #[arg(long, value_name = "N", default_value = "512")]
    pub size: SizePx,
    /// Sample spacing: one number, or X,Y
    #[arg(long, value_name = "NM", default_value = "62.5")]
    pub pitch_nm: PitchNm,
    /// The TIFF file to write; an existing one is replaced
    #[arg(long, value_name = "OUT.tif")]
    pub out: PathBuf,
}

/// The structures, each with its own parameters.
#[derive(Debug, Clone, PartialEq, clap::Subcommand)]
pub enum StructureArgs {
    /// Sinusoidal grating
    Sinusoid {
        /// Period
        #[arg(long, value_parser = positive)]
        period_nm: f64,
        /// Half the peak-to-valley height
        #[arg(long, value_parser = positive)]
        amplitude_nm: f64,
        /// Direction of the grating vector, counter-clockwise from +x
        #[arg(long, value_parser = finite, default_value_t = 0.0, allow_negative_numbers = true)]
        direction_deg: f64,
        /// Size, spacing, and file.
        #[command(flatten)]
        field: FieldArgs,
    },
    /// Sawtooth grating along x
    Blazed {
        /// Period
        #[arg(long, value_parser = positive)]
        period_nm: f64,
        /// Peak-to-valley height
        #[arg(long, value_parser = positive)]
        depth_nm: f64,
        /// Size, spacing, and file.
        #[command(flatten)]
        field: FieldArgs,
    },
    /// Rectangular grating along x
    Lamellar {
        /// Period
        #[arg(long, value_parser = positive)]
        period_nm: f64,
        /// Peak-to-valley height
        #[arg(long, value_parser = positive)]
        depth_nm: f64,
        /// Share of the period that is high
        #[arg(long, value_parser = share, default_value_t = 0.5)]
        duty: f64,
        /// Size, spacing, and file.
        #[command(flatten)]
        field: FieldArgs,
    },
    /// Tracks of pits as on a compact disc
    CdTrack {
        /// Chooses the pits
        #[arg(long, default_value_t = 1)]
        seed: u64,
        /// Size, spacing, and file.
        #[command(flatten)]
        field: FieldArgs,
    },
    /// Modelled on the scales of the corn snake
    CornSnake {
        /// Chooses the irregularities
        #[arg(long, default_value_t = 1)]
        seed: u64,
        /// Size, spacing, and file.
        #[command(flatten)]
        field: FieldArgs,
    },
    /// Modelled on the scales of the sunbeam snake
    SunbeamSnake {
        /// Chooses the irregularities
        #[arg(long, default_value_t = 1)]
        seed: u64,
        /// Size, spacing, and file.
        #[command(flatten)]
        field: FieldArgs,
    },
    /// Random surface with a Gaussian autocorrelation
    GaussianRough {
        /// Root mean square height
        #[arg(long, value_parser = positive)]
        rms_nm: f64,
        /// Distance at which the autocorrelation falls to 1/e
        #[arg(long, value_parser = positive)]
        correlation_length_nm: f64,
        /// Chooses the surface
        #[arg(long, default_value_t = 1)]
        seed: u64,
        /// Size, spacing, and file.
        #[command(flatten)]
        field: FieldArgs,
    },
    /// A plane at height 0
    Flat {
        /// Size, spacing, and file.
        #[command(flatten)]
        field: FieldArgs,
    },
}
