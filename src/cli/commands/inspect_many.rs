//! Several scans at once for `inspect`: a line each.

use std::path::{Path, PathBuf};

use rayon::prelude::*;
use serde::Serialize;

use crate::cli::commands::inspect_verdict::verdict;
use crate::cli::output::{self, Outcome};
use crate::error::Result;
use diffraction_build::height::prepare::{Level, PrepareConfig, prepare};
use diffraction_build::height::quality::{Verdict, advise};
use diffraction_build::height::read::{ReadConfig, read_scan};
use diffraction_build::height::statistics::statistics;

/// One scan's line.
#[derive(Debug, Clone, PartialEq, Serialize)]
struct Line {
    file: String,
    /// What keeps it from being read; the figures are absent then.
    error: Option<String>,
    #[serde(flatten)]
    figures: Option<Figures>,
}

#[derive(Debug, Clone, PartialEq, Serialize)]
struct Figures {
    size: [usize; 2],
    pitch_nm: [f64; 2],
    /// Of the heights with the best plane taken away.
    rms_height_nm: f64,
    peak_to_valley_nm: f64,
    warnings: Vec<String>,
    /// What to do about it, as `inspect` of it alone says.
    verdict: Verdict,
}

/// Reads every file and prints one table; files that cannot be read are listed and stop no other.
///
/// # Errors
/// Those of printing.
pub(crate) fn run(files: &[PathBuf], config: &ReadConfig, shortest_nm: f64, json: bool) -> Result<Outcome> {
    // A few at a time, in the order given: scans may be large.
    let lines: Vec<Line> = files.par_iter().with_max_len(1).map(|file| line(file, config, shortest_nm)).collect();
    if json {
        output::print_json(&lines)?;
    } else {
        output::print(&to_text(&lines))?;
    }
    let failures: Vec<String> = lines.into_iter().filter_map(|line| line.error).collect();
    Ok(if failures.is_empty() { Outcome::Done } else { Outcome::Failures(failures) })
}

fn line(path: &Path, config: &ReadConfig, shortest_nm: f64) -> Line {
    let figures = || -> diffraction_brdf::Result<Figures> {
        let scan = read_scan(path, config)?;
        let plane = PrepareConfig { level: Level::Plane, despike: None, blend_nm: None };
        let (levelled, _) = prepare(&scan.field, &plane)?;
        let found = statistics(&levelled, shortest_nm);
        Ok(Figures {
            size: scan.provenance.size,
            pitch_nm: scan.provenance.pitch_nm,
            rms_height_nm: found.rms_height_nm,
            peak_to_valley_nm: found.peak_to_valley_nm,
            warnings: scan.provenance.warnings.into_iter().chain(found.warnings).collect(),
            verdict: verdict(&advise(&scan.field)?),
        })
    };
    let file = path.display().to_string();
    match figures() {
        Ok(figures) => Line { file, error: None, figures: Some(figures) },
        Err(error) => Line { file, error: Some(error.to_string()), figures: None },
    }
}

fn to_text(lines: &[Line]) -> String {
    let widest = lines.iter().map(|line| line.file.chars().count()).max().unwrap_or(0);
    let mut text = format!(
        "{:<widest$}  {:>11}  {:>19}  {:>9}  {:>9}  verdict\n",
        "file", "samples", "pitch in nm", "rms in nm", "p-v in nm"
    );
    for line in lines {
        text += &match &line.figures {
            None => format!("{:<widest$}  cannot be read, see below\n", line.file),
            Some(Figures { size: [nx, ny], pitch_nm: [px, py], rms_height_nm, peak_to_valley_nm, verdict, .. }) => {
                format!(
                    "{:<widest$}  {:>11}  {:>19}  {rms_height_nm:>9.2}  {peak_to_valley_nm:>9.1}  {}\n",
                    line.file,
                    format!("{nx} x {ny}"),
                    format!("{px:.3} x {py:.3}"),
                    verdict.sentence
                )
            }
        };
    }
    text
}
