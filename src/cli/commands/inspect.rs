//! `inspect`: what a scan or an atlas holds.

use std::path::PathBuf;

use crate::cli::lengths::PitchNm;

/// Arguments of `inspect`.
#[derive(Debug, Clone, PartialEq, clap::Args)]
#[command(after_help = "Examples:
  diffraction-atlas inspect scans/snake.tif --pitch-nm 48.8 --full-scale-nm 375
  diffraction-atlas inspect scans/snake.gsf --save-heights heights.tif
  diffraction-atlas inspect out/atlas/squamates/v0001 --json")]
pub struct InspectArgs {
    /// A scan, an atlas, or one version of it
    pub file: PathBuf,
    /// Write the scan's heights as 32-bit floats in nm, row 0 at +y, before any levelling
    #[arg(long, value_name = "OUT.tif")]
    pub save_heights: Option<PathBuf>,
    /// Sample spacing where the scan does not say, or to overrule it: one number, or X,Y
    #[arg(long, value_name = "NM")]
    pub pitch_nm: Option<PitchNm>,
    /// Height that the whole integer range spans, likewise
    #[arg(long, value_name = "NM", conflicts_with = "unit", value_parser = crate::cli::lengths::positive)]
    pub full_scale_nm: Option<f64>,
    /// Unit of the stored heights, likewise
    #[arg(long, value_parser = ["pm", "nm", "um", "mm", "cm", "m", "angstrom", "inch"])]
    pub unit: Option<String>,
    /// Page of a file with several, from 0
    #[arg(long)]
    pub page: Option<usize>,
    /// Print as JSON
    #[arg(long)]
    pub json: bool,
}
