//! How far look-ups between texels are off, by the number of texels and the kind of look-up, and what a tolerance comes to: `cargo run
//! --release --example look_ups MANIFEST [SPECIMEN ...]`, with `--kept` for the second alone.
//!
//! What a tolerance comes to are tables for every direction as a run stores them where the manifest names no size, rounded to the number
//! format that it chooses, by the look-up that `FORMAT.md` describes.
//!
//! For every specimen and size, tables of X, Y, Z for every direction, with all their digits and point samples, against the
//! reference: the 95th percentile of errors in total (see `colour_error_quantiles`) over the directions above the floor, of the
//! whole hemisphere, near the mirror direction and at grazing angles. Look-ups are linear, through four texels a side by Lagrange's
//! cubic, and by cubic B-splines on coefficients, which graphics hardware makes of four linear ones; the lobe's own table is small,
//! fine, and looked up by Lagrange's cubic in both.

use std::error::Error;
use std::path::Path;

use diffraction_atlas::manifest;
use diffraction_atlas::stages::ingest::{Scans, ingest};
use diffraction_brdf::direction::Vec3;
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz, brdf_xyz_by_splines};
use diffraction_brdf::{Splines, Xyz};
use diffraction_build::accuracy::directions::ErrorDirections;
use diffraction_build::accuracy::reference::{Reference, evaluate};
use diffraction_build::accuracy::texels;
use diffraction_build::ground::metrics::colour_error_quantiles;
use diffraction_build::tables::build::build_planned;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::look_ups::tried_first;
use diffraction_build::tables::model::{Prefilter, Storage, TableSet, TablesConfig};
use diffraction_build::tables::plan::{automatic_size, plan};
use diffraction_build::tables::resolution::{lobe_radius, resolving_size};
use diffraction_build::tables::rounding::choose;
use rayon::prelude::*;

const SIZES: [usize; 6] = [301, 401, 501, 601, 801, 1001];

/// The 95th percentiles of the groups.
fn p95(reference: &Reference, found: &[Xyz]) -> Vec<f64> {
    let mut start = 0;
    let of_group = |group: &diffraction_build::accuracy::directions::ErrorGroup| {
        let range = start..start + group.len();
        start = range.end;
        colour_error_quantiles(&reference.xyz[range.clone()], &found[range], group.floor_per_sr).p95
    };
    reference.groups.iter().map(of_group).collect()
}

fn specimen(scans: &Scans, tables: &TablesConfig) -> Result<(), Box<dyn Error>> {
    let with_size = |size: usize| TablesConfig {
        size: Some(size),
        prefilter: Prefilter::None,
        memory_mib: 16 << 10,
        ..tables.clone()
    };
    let built = |size: usize| -> Result<TableSet, Box<dyn Error>> {
        let config = with_size(size);
        let input = BuildInput::new(&scans.fields, &scans.optics, &config);
        Ok(build_planned(&input, &plan(&input)?, &|_| ())?.0)
    };
    let finest = built(SIZES[SIZES.len() - 1])?;
    let config = with_size(SIZES[SIZES.len() - 1]);
    let input = BuildInput::new(&scans.fields, &scans.optics, &config);
    let directions = ErrorDirections::of_regions(&finest);
    let reference = evaluate(&scans.fields, &scans.optics, &plan(&input)?, finest.tables.len(), directions, [])?;
    for size in SIZES {
        let set = if size == finest.size() { finest.clone() } else { built(size)? };
        let splines = Splines::new(&set.tables);
        let by = |look_up: &(dyn Fn(Vec3, Vec3) -> Xyz + Sync)| {
            let found: Vec<Xyz> = reference.pairs.par_iter().map(|&(wi, wo)| look_up(wi, wo)).collect();
            let errors = p95(&reference, &found);
            errors.iter().map(|error| format!("{error:9.1e}")).collect::<Vec<_>>().join("")
        };
        println!(
            "  {size:5}  {}  {}  {}",
            by(&|wi, wo| brdf_xyz(&set, Interpolation::Bilinear, wi, wo)),
            by(&|wi, wo| brdf_xyz(&set, Interpolation::Cubic, wi, wo)),
            by(&|wi, wo| brdf_xyz_by_splines(&set, &splines, wi, wo))
        );
    }
    Ok(())
}

/// Tolerances of [`kept`].
const TOLERANCES: [f64; 2] = [1e-2, 1e-3];

/// What tolerances come to for one specimen.
fn kept(name: &str, scans: &Scans, tables: &TablesConfig) -> Result<(), Box<dyn Error>> {
    for tolerance in TOLERANCES {
        let asked = TablesConfig { tolerance, size: None, ..tables.clone() };
        let built = |config: &TablesConfig| -> Result<TableSet, Box<dyn Error>> {
            let input = BuildInput::new(&scans.fields, &scans.optics, config);
            Ok(build_planned(&input, &plan(&input)?, &|_| ())?.0)
        };
        let on = |size: usize| TablesConfig { size: Some(size), ..asked.clone() };
        let automatic = automatic_size(&scans.optics, tolerance);
        let set = match tried_first(&scans.optics, &asked) {
            None => built(&asked)?,
            Some(size) => {
                let fewer = built(&on(size))?;
                let error = texels::spline_error(&fewer);
                match texels::suffice(error, tolerance) {
                    true => fewer,
                    false => built(&on(texels::wanted(error, tolerance, size).min(automatic)))?,
                }
            }
        };
        let chosen = choose(&set, None, tolerance, lobe_radius(&scans.optics));
        let splines = Splines::new(&chosen.set.tables);
        let input = BuildInput::new(&scans.fields, &scans.optics, &asked);
        let directions = ErrorDirections::of_regions(&chosen.set);
        let reference = evaluate(&scans.fields, &scans.optics, &plan(&input)?, set.tables.len(), directions, [])?;
        let by = |look_up: &(dyn Fn(Vec3, Vec3) -> Xyz + Sync)| {
            let found: Vec<Xyz> = reference.pairs.par_iter().map(|&(wi, wo)| look_up(wi, wo)).collect();
            p95(&reference, &found)
        };
        let errors = by(&|wi, wo| brdf_xyz_by_splines(&chosen.set, &splines, wi, wo));
        let linear = by(&|wi, wo| brdf_xyz(&chosen.set, Interpolation::Bilinear, wi, wo));
        let worst = errors.iter().copied().filter(|error| error.is_finite()).fold(0.0, f64::max);
        let format = if chosen.storage == Storage::Half { "half" } else { "float" };
        println!(
            "| {name} | {tolerance:.0e} | {}{} | {} {format} | {:.1e} / {:.1e} / {:.1e} | {:.1e} / {:.1e} / {:.1e} | {} |",
            set.size(),
            if set.prefilter_width > 0.0 { ", means" } else { "" },
            set.tables.len(),
            errors[0],
            errors[1],
            errors[2],
            linear[0],
            linear[1],
            linear[2],
            if worst <= tolerance {
                "yes".to_owned()
            } else {
                format!("no, {} asked for", resolving_size(&scans.optics, tolerance))
            },
        );
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments: Vec<String> = std::env::args().skip(1).collect();
    let kept_alone = arguments.iter().any(|argument| argument == "--kept");
    arguments.retain(|argument| argument != "--kept");
    let mut arguments = arguments.into_iter();
    let path = arguments.next().ok_or("usage: look_ups [--kept] MANIFEST [SPECIMEN ...]")?;
    let wanted: Vec<String> = arguments.collect();
    let (manifest, _) = manifest::load(Path::new(&path))?;
    let specimens = || manifest.specimens.iter().filter(|config| wanted.is_empty() || wanted.contains(&config.name));
    println!("| specimen | tolerance | size | tables | splines: all, near, grazing | linear | kept |");
    println!("|---|---|---|---|---|---|---|");
    for config in specimens() {
        kept(&config.name, &ingest(config)?, &manifest.tables)?;
    }
    if kept_alone {
        return Ok(());
    }
    println!("   size  linear: all, near, grazing     Lagrange's cubic             cubic B-spline");
    for config in specimens() {
        println!("{}", config.name);
        specimen(&ingest(config)?, &manifest.tables)?;
    }
    Ok(())
}
