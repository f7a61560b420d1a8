//! `synthesize`: generated height fields as TIFF files.

use std::path::PathBuf;

use crate::cli::destination;
use crate::cli::lengths::{PitchNm, SizePx, finite, positive, share};
use crate::cli::options::Global;
use crate::cli::output::{self, Outcome};
use crate::cli::terminal;
use crate::error::Result;
use diffraction_build::height::HeightField;
use diffraction_build::height::synthesize::{Structure, synthesize};
use diffraction_build::height::write::write_scan_tiff;

/// Arguments of `synthesize`.
#[derive(Debug, Clone, PartialEq, clap::Args)]
#[command(after_help = "Examples:
  diffraction-atlas synthesize sinusoid --period-nm 1600 --amplitude-nm 60 --size 512,64 --pitch-nm 50 --out s.tif
  diffraction-atlas synthesize corn-snake --seed 7 --out snake.tif")]
pub(crate) struct SynthesizeArgs {
    /// What to generate
    #[command(subcommand)]
    pub structure: StructureArgs,
}

/// Size, spacing, and place of the file, for every structure.
#[derive(Debug, Clone, PartialEq, clap::Args)]
pub(crate) struct FieldArgs {
    /// Samples: one number, or X,Y
    #[arg(long, value_name = "N", default_value = "512")]
    pub size: SizePx,
    /// Sample spacing: one number, or X,Y
    #[arg(long, value_name = "NM", default_value = "62.5")]
    pub pitch_nm: PitchNm,
    /// The TIFF file to write
    #[arg(long, value_name = "OUT.tif")]
    pub out: PathBuf,
    /// Replace a file that is there already
    #[arg(long)]
    pub force: bool,
}

/// The structures, each with its own parameters.
#[derive(Debug, Clone, PartialEq, clap::Subcommand)]
pub(crate) enum StructureArgs {
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

/// Generates, writes, and says what was written.
pub(crate) fn run(args: &SynthesizeArgs, global: &Global) -> Result<Outcome> {
    let (structure, file) = args.structure.parts();
    destination::check_file(&file.out, &[], file.force)?;
    let (size, pitch) = (file.size.0, file.pitch_nm.0);
    let field = synthesize(&structure, size, pitch)?;
    destination::create_parent(&file.out)?;
    write_scan_tiff(&file.out, &field)?;
    output::print(&format!("{}: {}\n", file.out.display(), summary(&field)))?;
    if !structure.repeats(size, pitch) && !global.quiet {
        terminal::say("note: the tile does not hold whole periods; repeated, it has a seam\n");
    }
    Ok(Outcome::Done)
}

/// Size, pitch, and range of heights in one line.
fn summary(field: &HeightField) -> String {
    let [nx, ny] = field.size();
    let [px, py] = field.pitch_nm;
    let low = field.heights_nm.iter().copied().fold(f64::INFINITY, f64::min);
    let high = field.heights_nm.iter().copied().fold(f64::NEG_INFINITY, f64::max);
    format!("{nx} x {ny} samples, pitch {px} x {py} nm, heights {low:.1} to {high:.1} nm")
}

impl StructureArgs {
    /// The structure asked for, and where it goes.
    fn parts(&self) -> (Structure, &FieldArgs) {
        match self {
            Self::Sinusoid { period_nm, amplitude_nm, direction_deg, field } => (
                Structure::Sinusoid {
                    period_nm: *period_nm,
                    amplitude_nm: *amplitude_nm,
                    direction_deg: *direction_deg,
                },
                field,
            ),
            Self::Blazed { period_nm, depth_nm, field } => {
                (Structure::Blazed { period_nm: *period_nm, depth_nm: *depth_nm }, field)
            }
            Self::Lamellar { period_nm, depth_nm, duty, field } => {
                (Structure::Lamellar { period_nm: *period_nm, depth_nm: *depth_nm, duty: *duty }, field)
            }
            Self::CdTrack { seed, field } => (Structure::CdTrack { seed: *seed }, field),
            Self::CornSnake { seed, field } => (Structure::CornSnake { seed: *seed }, field),
            Self::SunbeamSnake { seed, field } => (Structure::SunbeamSnake { seed: *seed }, field),
            Self::GaussianRough { rms_nm, correlation_length_nm, seed, field } => (
                Structure::GaussianRough {
                    rms_nm: *rms_nm,
                    correlation_length_nm: *correlation_length_nm,
                    seed: *seed,
                },
                field,
            ),
            Self::Flat { field } => (Structure::Flat, field),
        }
    }
}
