//! `inspect`: what a scan or an atlas holds.

use std::path::{Path, PathBuf};

use serde::Serialize;

use crate::cli::commands::inspect_many;
use crate::cli::commands::inspect_verdict::{MATERIAL, WAVELENGTH_MAX_NM, WAVELENGTH_MIN_NM, verdict};
use crate::cli::destination;
use crate::cli::lengths::PitchNm;
use crate::cli::options::Global;
use crate::cli::output::{self, Outcome};
use crate::cli::terminal;
use crate::error::Result;
use crate::stages::archive::specimen_file;
use diffraction_brdf::atlas;
use diffraction_brdf::error::Error;
use diffraction_build::height::prepare::{Level, PrepareConfig, prepare};
use diffraction_build::height::quality::{Finding, Remedy, Verdict, advise};
use diffraction_build::height::read::{CallerWords, HeightScale, LengthUnit, Provenance, ReadConfig, read_scan};
use diffraction_build::height::statistics::{
    PsdRing, STEEP_SLOPE, Statistics, WAVES_MIN, is_whole_grating, least_uv_radius, radial_psd, seam_warning,
    statistics,
};
use diffraction_build::height::write::write_scan_tiff;
use diffraction_build::optics::config::{Factor, TILE_SIGMAS, smallest_side_nm};
use diffraction_build::optics::validity::doubts;
use diffraction_build::tables::model::{Basis, Storage};

/// Arguments of `inspect`.
#[derive(Debug, Clone, PartialEq, clap::Args)]
#[command(after_help = "Examples:
  diffraction-atlas inspect scans/snake.tif --pitch-nm 48.8 --full-scale-nm 375
  diffraction-atlas inspect scans/a.tif scans/b.tif
  diffraction-atlas inspect scans/
  diffraction-atlas inspect scans/snake.gsf --save-heights heights.tif
  diffraction-atlas inspect scans/snake.spm --channel \"Height Sensor\"
  diffraction-atlas inspect out/atlas/squamates/v0001 --json

Formats, told apart by their content: TIFF (plain, ImageJ, OME, Park, JPK), Gwyddion .gwy and .gsf, Nanoscope .spm and .001,
Asylum .ibw, Nanosurf .nid, Digital Surf .sur, X3P, WSxM .stp and .top, matrices as text. See docs/formats.md.")]
pub(crate) struct InspectArgs {
    /// A scan, a folder of scans, an atlas, or one version of it
    pub file: PathBuf,
    /// Further scans: a line for each then, all with the same options
    pub others: Vec<PathBuf>,
    /// Write the scan's heights as 32-bit floats in nm, row 0 at +y, before any levelling
    #[arg(long, value_name = "OUT.tif")]
    pub save_heights: Option<PathBuf>,
    /// Replace the file of `--save-heights` where it is there already
    #[arg(long, requires = "save_heights")]
    pub force: bool,
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
    /// Channel of a file with several: its name or a part of it
    #[arg(long, value_name = "NAME")]
    pub channel: Option<String>,
    /// Print as JSON
    #[arg(long)]
    pub json: bool,
}

/// Looks and prints.
///
/// # Errors
/// A file that is neither scan nor atlas.
pub(crate) fn run(args: &InspectArgs, global: &Global) -> Result<Outcome> {
    if let Some(path) = &args.save_heights {
        destination::check_file(path, &[&args.file], args.force)?;
    }
    if !args.others.is_empty() {
        if args.save_heights.is_some() {
            return Err(Error::Call("`--save-heights` is for one scan".into()).into());
        }
        let files = [std::slice::from_ref(&args.file), &args.others].concat();
        return inspect_many::run(&files, &read_config(args), WAVELENGTH_MIN_NM, args.json);
    }
    match args.file.is_dir() {
        false => inspect_scan(args),
        true if output::is_atlas(&args.file) => inspect_atlas(args),
        true => {
            let (files, others) = files_in(&args.file)?;
            if others > 0 && !global.quiet {
                terminal::say(&format!(
                    "{others} more, named as notes, tables and pictures are, were left out: to look at one, name it\n"
                ));
            }
            inspect_many::run(&files, &read_config(args), WAVELENGTH_MIN_NM, args.json)
        }
    }
}

/// What lies beside scans and is none: notes, tables, pictures, programs.
const NO_SCANS: [&str; 22] = [
    "bib", "csv", "doc", "docx", "htm", "html", "ini", "jpeg", "jpg", "json", "log", "md", "odt", "ods", "pdf", "png",
    "py", "toml", "xls", "xlsx", "yaml", "yml",
];

/// The files of a folder that are not hidden and whose names may be scans', in the order of their names; and how many others there are.
fn files_in(folder: &Path) -> Result<(Vec<PathBuf>, usize)> {
    let unread = |error| Error::disk(folder, "list", error);
    let entries = std::fs::read_dir(folder).map_err(unread)?.collect::<std::io::Result<Vec<_>>>().map_err(unread)?;
    let is_hidden = |path: &PathBuf| path.file_name().is_some_and(|name| name.to_string_lossy().starts_with('.'));
    let is_none = |path: &PathBuf| {
        let ending = path.extension().map(|ending| ending.to_string_lossy().to_lowercase());
        ending.is_some_and(|ending| NO_SCANS.contains(&ending.as_str()))
    };
    let mut files: Vec<PathBuf> = entries.into_iter().map(|entry| entry.path()).filter(|path| path.is_file()).collect();
    files.retain(|path| !is_hidden(path));
    let all = files.len();
    files.retain(|path| !is_none(path));
    files.sort();
    if files.is_empty() {
        return Err(Error::Call(format!("{}: no atlas, and no scan to look at lies in it", folder.display())).into());
    }
    let others = all - files.len();
    Ok((files, others))
}

/// What the scan's reader calls the options.
const WORDS: CallerWords = CallerWords {
    source: "option",
    pitch: "--pitch-nm",
    add_pitch: "add `--pitch-nm N` (or `--pitch-nm X,Y`, nm per sample)",
    height: "--full-scale-nm",
    add_integer_height: "add `--full-scale-nm N` (nm from the smallest to the largest value of the integer type), or \
                         `--unit U` where the numbers are heights",
    add_float_height: "add `--unit U`, U being pm, nm, um, mm, cm, m, angstrom or inch",
    page: "`--page {}`",
    channel: "`--channel \"{}\"`",
    or_accept_missing: "",
};

/// A scan and what can be said of it.
#[derive(Debug, Serialize)]
struct ScanReport {
    /// Largest sigma of the coherence that the scan's size resolves, in µm; `null` where it resolves any.
    resolved_sigma_um: Option<f64>,
    /// `|(u, v)|` of the longest period that the scan holds often enough to tell it, at the shortest wavelength.
    least_uv_radius: f64,
    provenance: Provenance,
    extent_um: [f64; 2],
    /// Of the heights with the best plane taken away.
    statistics: Statistics,
    /// Power spectral density averaged over all directions, of the same heights.
    radial_psd: Vec<PsdRing>,
    /// What is wrong with the scan.
    findings: Vec<Finding>,
    /// The keys of a specimen that mend what can be mended, as they are written in a manifest.
    settings: Vec<String>,
    /// What to think of it.
    verdict: Verdict,
}

/// How the options say to read a scan.
fn read_config(args: &InspectArgs) -> ReadConfig {
    let height = match (args.full_scale_nm, &args.unit) {
        (Some(full_scale_nm), _) => Some(HeightScale::FullScaleNm(full_scale_nm)),
        (None, Some(unit)) => LengthUnit::parse(unit).map(HeightScale::Unit),
        (None, None) => None,
    };
    let pitch_nm = args.pitch_nm.map(|pitch| pitch.0);
    let words = CallerWords { height: if args.unit.is_some() { "--unit" } else { "--full-scale-nm" }, ..WORDS };
    ReadConfig { page: args.page, channel: args.channel.clone(), pitch_nm, height, words, ..ReadConfig::default() }
}

fn inspect_scan(args: &InspectArgs) -> Result<Outcome> {
    let scan = read_scan(&args.file, &read_config(args))?;
    if let Some(path) = &args.save_heights {
        destination::create_parent(path)?;
        write_scan_tiff(path, &scan.field)?;
    }
    let plane = PrepareConfig { level: Level::Plane, despike: None, blend_nm: None };
    let (levelled, _) = prepare(&scan.field, &plane)?;
    let mut found = statistics(&levelled, WAVELENGTH_MIN_NM);
    let advice = advise(&scan.field)?;
    let verdict = verdict(&advice);
    // What is no surface has slopes and edges of its own: they are told of what is left once it is taken out.
    let told =
        if advice.findings.iter().any(|finding| finding.fault.hides_others()) { &advice.prepared } else { &levelled };
    found.warnings.extend(doubts(told, [WAVELENGTH_MIN_NM, WAVELENGTH_MAX_NM], MATERIAL, Factor::Vector));
    found.warnings.extend(seam_warning(told));
    let side_um = smallest_side_nm(&levelled) * 1e-3;
    let report = ScanReport {
        resolved_sigma_um: (!is_whole_grating(&levelled) && side_um.is_finite()).then_some(side_um / TILE_SIGMAS),
        least_uv_radius: least_uv_radius(side_um * 1e3, f64::INFINITY, WAVELENGTH_MIN_NM),
        extent_um: scan.field.extent_nm().map(|nm| nm * 1e-3),
        radial_psd: radial_psd(&levelled),
        statistics: found,
        provenance: scan.provenance,
        settings: advice.settings.iter().map(Remedy::toml).collect(),
        findings: advice.findings,
        verdict,
    };
    if args.json {
        output::print_json(&report)?;
    } else {
        output::print(&report.to_text())?;
    }
    Ok(Outcome::Done)
}

impl ScanReport {
    fn to_text(&self) -> String {
        let (p, s) = (&self.provenance, &self.statistics);
        let mut lines = vec![
            match &p.channel {
                Some(channel) => {
                    format!(
                        "{}: {}, page {}, channel \"{channel}\", {}",
                        p.file_name, p.format, p.page, p.sample_format
                    )
                }
                None => format!("{}: {}, page {}, {}", p.file_name, p.format, p.page, p.sample_format),
            },
            format!(
                "size          {} x {} samples, {:.4} x {:.4} µm",
                p.size[0], p.size[1], self.extent_um[0], self.extent_um[1]
            ),
            format!("pitch         {:.4} x {:.4} nm ({})", p.pitch_nm[0], p.pitch_nm[1], p.pitch_from),
            format!("heights       {}", p.height_from),
            format!("missing       {} samples", p.missing_samples),
            format!(
                "after a plane rms height {:.2} nm, rms slope {:.3}, peak to valley {:.1} nm",
                s.rms_height_nm, s.rms_slope, s.peak_to_valley_nm
            ),
            match s.autocorrelation_length_nm {
                length_nm if length_nm.is_nan() => "correlation   none".into(),
                length_nm => format!("correlation   {length_nm:.0} nm"),
            },
            match self.resolved_sigma_um {
                Some(sigma_um) => format!(
                    "coherence     resolved up to sigma = {sigma_um:.3} µm, a quarter of the shorter side, which sigma_um = \"auto\" takes; \
                     of more, edge = \"auto\" shows only the lobe"
                ),
                None => "coherence     any sigma: the scan holds whole periods of a grating; sigma_um = \"auto\" takes 16.25 µm".into(),
            },
            match self.least_uv_radius < s.usable_uv_radius {
                true => format!(
                    "good for      |(u, v)| from {:.3} to {:.3} at {WAVELENGTH_MIN_NM} nm: periods of at least two samples that fit \
                     {WAVES_MIN} times into the shorter side",
                    self.least_uv_radius, s.usable_uv_radius
                ),
                false => format!(
                    "good for      no |(u, v)| at {WAVELENGTH_MIN_NM} nm: no period of at least two samples fits {WAVES_MIN} times into \
                     the shorter side and diffracts that light"
                ),
            },
            format!(
                "steep         {:.2} % of the surface above {STEEP_SLOPE}; over a quarter of {WAVELENGTH_MIN_NM} nm rms slope {:.3}, \
                 {:.2} % walls",
                100.0 * s.steep_share,
                s.wave_slope,
                100.0 * s.wall_share
            ),
        ];
        if let Some(surface) = &s.surface {
            lines.push(format!("ISO 25178     {surface}"));
        }
        for period in &s.dominant_periods {
            lines.push(format!(
                "period        {:.1} nm at {:.1} deg, relative power {:.3}",
                period.period_nm, period.direction_deg, period.relative_power
            ));
        }
        let findings = self.findings.iter().map(|finding| &finding.sentence);
        let warnings = p.warnings.iter().chain(findings).chain(&s.warnings);
        lines.extend(warnings.map(|warning| format!("warning: {warning}")));
        lines.push(format!("verdict       {}", self.verdict.sentence));
        lines.join("\n") + "\n"
    }
}

fn inspect_atlas(args: &InspectArgs) -> Result<Outcome> {
    let folder = output::version_folder(&args.file)?;
    let index = atlas::read_index(&folder)?;
    let specimens = index
        .specimens
        .iter()
        .map(|entry| specimen_file::read(&atlas::specimen_folder(&folder, &index, &entry.name)?))
        .collect::<diffraction_brdf::Result<Vec<_>>>()?;
    if args.json {
        output::print_json(&serde_json::json!({ "index": index, "specimens": specimens }))?;
        return Ok(Outcome::Done);
    }
    let bytes: u64 = index.files.iter().map(|file| file.bytes).sum();
    let mut text = format!(
        "{}: atlas \"{}\" by program version {}, {} files, {}\n",
        folder.display(),
        index.name,
        index.program_version,
        index.files.len(),
        output::bytes_in_words(bytes)
    );
    for file in &specimens {
        let is_derived = file.tables.derived_under.is_some();
        text += &format!(
            "{}: {}, {} {} tables of {}², stored as {}, {} wavelengths at the rim\n",
            file.name,
            if file.species.is_empty() { "no species named" } else { &file.species },
            file.spectral.as_ref().filter(|_| is_derived).map_or(file.tables.tables.len(), |spectral| spectral.tables),
            if is_derived { "spectral" } else { basis_in_words(file.tables.basis) },
            file.tables.restriction.as_ref().map_or(file.tables.u.samples, |restriction| restriction.size),
            storage_in_words(file.tables.storage),
            file.build.wavelengths_max
        );
        if let Some(restriction) = &file.tables.restriction {
            text += &format!(
                "  restricted to the scenes of its manifest: {} x {} of {} x {} texels\n",
                file.tables.u.samples, file.tables.v.samples, restriction.size, restriction.size
            );
        }
        text.extend(file.warnings.iter().map(|warning| format!("  warning: {warning}\n")));
    }
    output::print(&text)?;
    Ok(Outcome::Done)
}

fn basis_in_words(basis: Basis) -> &'static str {
    match basis {
        Basis::Chebyshev => "Chebyshev",
        Basis::Taylor => "Taylor",
    }
}

fn storage_in_words(storage: Storage) -> &'static str {
    match storage {
        Storage::Half => "16-bit floats",
        Storage::Float => "32-bit floats",
    }
}
