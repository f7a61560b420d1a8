//! How far look-ups between texels are off, by the number of texels and the kind of look-up: `cargo run --release --example
//! look_ups MANIFEST [SPECIMEN ...]`.
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
use diffraction_brdf::Xyz;
use diffraction_brdf::chebyshev::shifted_values;
use diffraction_brdf::direction::{Vec3, normalised_abs_w, wave_vector_change};
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz, diffuse_window_power};
use diffraction_build::accuracy::directions::ErrorDirections;
use diffraction_build::accuracy::reference::{Reference, evaluate};
use diffraction_build::ground::metrics::colour_error_quantiles;
use diffraction_build::tables::build::build_planned;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Prefilter, TableSet, TablesConfig};
use diffraction_build::tables::plan::plan;
use ndarray::{Array3, Axis};
use rayon::prelude::*;

const SIZES: [usize; 6] = [301, 401, 501, 601, 801, 1001];

/// The pole of the filter that turns values into coefficients.
const POLE: f64 = -0.267_949_192_431_122_7;

/// In place, along a line that goes on mirrored at its ends: coefficients whose B-spline passes through the values.
fn to_coefficients(line: &mut [f64]) {
    let last = line.len() - 1;
    let mut sum = line[0];
    let mut power = POLE;
    for value in &line[1..line.len().min(40)] {
        sum += power * value;
        power *= POLE;
    }
    line[0] = sum;
    for k in 1..=last {
        line[k] += POLE * line[k - 1];
    }
    line[last] = POLE / (POLE * POLE - 1.0) * (line[last] + POLE * line[last - 1]);
    for k in (0..last).rev() {
        line[k] = POLE * (line[k + 1] - line[k]);
    }
    line.iter_mut().for_each(|value| *value *= 6.0);
}

/// A table's coefficients; beyond the rim it goes on as it is there, so that no step rings into the disc.
fn coefficients(table: &Array3<f32>) -> Array3<f64> {
    let size = table.dim().0;
    let middle = (size - 1) as f64 / 2.0;
    let held = middle + 2.0;
    let mut out = Array3::from_shape_fn((size, size, 3), |(row, column, c)| {
        let (y, x) = (row as f64 - middle, column as f64 - middle);
        let shrink = (held / y.hypot(x)).min(1.0);
        let at = |x: f64| ((middle + shrink * x).round() as usize).min(size - 1);
        f64::from(table[[at(y), at(x), c]])
    });
    for axis in [0, 1] {
        let lines: Vec<_> = out.lanes_mut(Axis(axis)).into_iter().collect();
        lines.into_par_iter().for_each(|mut lane| {
            let mut line = lane.to_vec();
            to_coefficients(&mut line);
            lane.iter_mut().zip(line).for_each(|(slot, value)| *slot = value);
        });
    }
    out
}

/// A B-spline at a position in texels (row, column); beyond the edge coefficients are mirrored.
fn spline(coefficients: &Array3<f64>, at: [f64; 2]) -> Xyz {
    let size = coefficients.dim().0 as i64;
    let weights = |x: f64| {
        let [f, g] = [x - x.floor(), 1.0 - (x - x.floor())];
        [g * g * g, 4.0 - 6.0 * f * f + 3.0 * f * f * f, 4.0 - 6.0 * g * g + 3.0 * g * g * g, f * f * f]
            .map(|w| w / 6.0)
    };
    let mirrored = |index: i64| (size - 1 - (size - 1 - index.abs()).abs()) as usize;
    let mut sum = [0.0; 3];
    for (dy, wy) in weights(at[0]).into_iter().enumerate() {
        for (dx, wx) in weights(at[1]).into_iter().enumerate() {
            let [row, column] =
                [at[0].floor() as i64 + dy as i64 - 1, at[1].floor() as i64 + dx as i64 - 1].map(mirrored);
            for (c, sum) in sum.iter_mut().enumerate() {
                *sum += wy * wx * coefficients[[row, column, c]];
            }
        }
    }
    sum
}

/// The BRDF with tables looked up by B-splines.
fn by_splines(set: &TableSet, splines: &[Array3<f64>], wi: Vec3, wo: Vec3) -> Xyz {
    let q = wave_vector_change(wi, wo);
    let scale = (set.size() - 1) as f64 / 4.0;
    let at = [(2.0 - q[1]) * scale, (q[0] + 2.0) * scale];
    let mut tables = [0.0; 3];
    for (table, b) in splines.iter().zip(shifted_values(splines.len(), normalised_abs_w(q))) {
        let value = spline(table, at);
        (0..3).for_each(|c| tables[c] += b * value[c]);
    }
    let (whole, diffuse) = (brdf_xyz(set, Interpolation::Cubic, wi, wo), set.front_factor.diffuse(wi, wo));
    let by_cubics = diffuse_window_power(set, Interpolation::Cubic, q);
    std::array::from_fn(|c| whole[c] + diffuse * (tables[c] - by_cubics[c]))
}

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
        let splines: Vec<Array3<f64>> = set.tables.iter().map(coefficients).collect();
        let by = |look_up: &(dyn Fn(Vec3, Vec3) -> Xyz + Sync)| {
            let found: Vec<Xyz> = reference.pairs.par_iter().map(|&(wi, wo)| look_up(wi, wo)).collect();
            let errors = p95(&reference, &found);
            errors.iter().map(|error| format!("{error:9.1e}")).collect::<Vec<_>>().join("")
        };
        println!(
            "  {size:5}  {}  {}  {}",
            by(&|wi, wo| brdf_xyz(&set, Interpolation::Bilinear, wi, wo)),
            by(&|wi, wo| brdf_xyz(&set, Interpolation::Cubic, wi, wo)),
            by(&|wi, wo| by_splines(&set, &splines, wi, wo))
        );
    }
    Ok(())
}

fn main() -> Result<(), Box<dyn Error>> {
    let mut arguments = std::env::args().skip(1);
    let path = arguments.next().ok_or("usage: look_ups MANIFEST [SPECIMEN ...]")?;
    let wanted: Vec<String> = arguments.collect();
    let (manifest, _) = manifest::load(Path::new(&path))?;
    println!("   size  linear: all, near, grazing     Lagrange's cubic             cubic B-spline");
    for config in manifest.specimens.iter().filter(|config| wanted.is_empty() || wanted.contains(&config.name)) {
        println!("{}", config.name);
        specimen(&ingest(config)?, &manifest.tables)?;
    }
    Ok(())
}
