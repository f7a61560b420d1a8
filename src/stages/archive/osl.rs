//! A specimen as two shaders of the Open Shading Language, with the images that they read: what a lamp shows, and a closure for all light.
//!
//! OSL has no tables of numbers and no random numbers but noise, so the closure draws from a list of cells: as many entries as the image has
//! texels, each cell as often as the tables' share of it asks for. What it draws with is then known without error.

use std::fmt::Write;
use std::path::Path;

use diffraction_brdf::chebyshev;
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::exr_image::{Precision, write_rgb};
use diffraction_brdf::files;
use diffraction_brdf::front_factor::Factor;
use diffraction_brdf::storage::{StoredArray, write_tables};
use diffraction_brdf::table_set::{Basis, Storage, TableSet};
use diffraction_brdf::{Material, Splines, Xyz};
use ndarray::Array3;
use serde_json::json;

/// What to know of the shaders.
pub(crate) const README: &str = include_str!("osl/README.md");

/// Names of the shaders, and what follows evaluation in each.
const SHADERS: [(&str, &str); 2] = [
    ("diffraction_emission", include_str!("osl/emission.osl")),
    ("diffraction_closure", include_str!("osl/closure.osl")),
];
/// Evaluation, before and after the functions that name textures.
const OPTICS: &str = include_str!("osl/optics.osl");
const AFTER_TABLES: &str = "color lobe_at(";

/// Cells along (u, v), and texels along a side of the list of cells.
const CELLS: usize = 128;
const LIST_SIDE: usize = 512;
/// Values of `t` over which a cell's share is a mean.
const T_VALUES: usize = 5;
/// Share of the samples that are even over the hemisphere, and the least that lobe and cells get of the rest.
const SHARE_EVEN: f64 = 0.2;
const SHARE_MIN: f64 = 0.1;
/// The lobe ends where a Gaussian of this many widths does; of its wavelengths' widths, one in the middle.
const LOBE_WIDTHS: f64 = 4.55 / 0.8;

/// Writes `diffraction_emission.osl`, `diffraction_closure.osl` and their images into an existing folder. The shaders name the images by the
/// place where the folder will lie in the end, since textures have to be named by literals.
///
/// # Errors
/// `Error::Call` for tables made for certain scenes, tables in powers of w, and a folder whose name no shader can hold; the disk's.
pub(crate) fn write_osl(folder: &Path, place: &Path, set: &TableSet, pigment: Option<Xyz>) -> Result<()> {
    if set.basis == Basis::Taylor || set.restriction.is_some() {
        return Err(Error::Call(
            "these tables have no OSL shader: it takes basis = \"chebyshev\" and tables for every direction; make the atlas anew without `tables.serve`".into(),
        ));
    }
    let whole = std::path::absolute(place).map_err(|error| Error::disk(place, "find", error))?;
    let named = whole.to_str().map(|place| place.replace('\\', "/")).filter(|place| !place.contains(['"', '\n']));
    let place = named.ok_or_else(|| {
        Error::Call(format!("{}: OSL names textures by text without quotes; export to another folder", place.display()))
    })?;
    // Coefficients stand for values: what look-ups by splines want.
    let coefficients = TableSet { tables: Splines::new(&set.tables).coefficients().to_vec(), ..set.clone() };
    let stored = write_tables(folder, &coefficients, Storage::Float)?;
    let list = cell_list(set);
    write_rgb(&folder.join("cells.exr"), &list.cells, Precision::Float, &json!({}))?;
    write_rgb(&folder.join("density.exr"), &list.density, Precision::Float, &json!({}))?;
    let head = defines(set, pigment, &place, list.lobe_share)
        + &sum_of("tables_at", "spline", &stored.tables, &place, ["COLUMNS", "ROWS"])
        + &sum_of(
            "cross_at",
            "cubic",
            stored.lobe.as_ref().and_then(|lobe| lobe.cross.as_ref()).map_or(&[][..], |cross| &cross.patches),
            &place,
            ["CROSS_SIDE", "CROSS_SIDE"],
        );
    let (look_ups, evaluation) = OPTICS.split_at(OPTICS.find(AFTER_TABLES).unwrap_or(0));
    let (defines, sums) = head.split_at(head.find("color tables_at").unwrap_or(0));
    for (name, shader) in SHADERS {
        let text = [defines, look_ups, sums, evaluation, shader].concat();
        files::replace(&folder.join(format!("{name}.osl")), text.as_bytes())?;
    }
    Ok(())
}

/// What is this specimen's own.
fn defines(set: &TableSet, pigment: Option<Xyz>, place: &str, lobe_share: f64) -> String {
    let [n, k] = match set.front_factor.material {
        Material::Ideal => [1.0, 0.0],
        Material::Dielectric { n } => [n, 0.0],
        Material::Conductor { n, k } => [n, k],
    };
    let (rows, columns, _) = set.tables[0].dim();
    let lobe = set.lobe.as_ref();
    let (lobe_rows, lobe_columns) = lobe.map_or((1, 1), |lobe| (lobe.coherent.dim().0, lobe.coherent.dim().1));
    let radius = lobe.map_or(0.0, |lobe| lobe.radius_max);
    let cross = lobe.and_then(|lobe| lobe.cross.first()).map_or(1, |patch| patch.dim().0);
    let pigment = pigment.unwrap_or_default();
    let mut text = String::from(
        "// Made by `diffraction-atlas export --form osl`. Textures are named by the place they were exported to.\n",
    );
    let mut define = |name: &str, value: String| {
        let _ = writeln!(text, "#define {name} {value}");
    };
    let truth = |is: bool| u8::from(is).to_string();
    let number = |value: f64| format!("{value:?}");
    define("IDEAL", truth(set.front_factor.material == Material::Ideal));
    define("VECTOR", truth(set.front_factor.factor == Factor::Vector));
    define("SHADOWING", truth(set.front_factor.shadowing));
    define("EPS_RE", number(n * n - k * k));
    define("EPS_IM", number(2.0 * n * k));
    define("PIGMENT", format!("color({:?}, {:?}, {:?})", pigment[0], pigment[1], pigment[2]));
    define("COLUMNS", number(columns as f64));
    define("ROWS", number(rows as f64));
    define("LOBE_RADIUS", number(radius));
    define("LOBE_COLUMNS", number(lobe_columns as f64));
    define("LOBE_ROWS", number(lobe_rows as f64));
    define("LOBE_FILE", format!("\"{place}/lobe.exr\""));
    define("CROSS_SIDE", number(cross as f64));
    define("SHARE_EVEN", number(SHARE_EVEN));
    define("SHARE_LOBE", number(lobe_share));
    define("SHARE_CELLS", number(1.0 - SHARE_EVEN - lobe_share));
    // Without a lobe nothing is drawn from it, and any width will do.
    define("LOBE_WIDTH", number(if radius > 0.0 { radius / LOBE_WIDTHS } else { 1.0 }));
    define("CELLS", number(CELLS as f64));
    define("LIST_SIDE", number(LIST_SIDE as f64));
    define("LIST_FILE", format!("\"{place}/cells.exr\""));
    define("DENSITY_FILE", format!("\"{place}/density.exr\""));
    text.push('\n');
    text
}

/// A function that sums images times Chebyshev polynomials of x, each image by its own name.
fn sum_of(function: &str, look_up: &str, images: &[StoredArray], place: &str, [columns, rows]: [&str; 2]) -> String {
    let mut text = format!(
        "color {function}(float x, float s, float t) {{\n    color sum = color(0.0);\n    float before = 1.0;\n    float now = x;\n    float next;\n"
    );
    for (n, image) in images.iter().enumerate() {
        let factor = if n == 0 { "before" } else { "now" };
        if n > 1 {
            text += "    next = 2.0 * x * now - before;\n    before = now;\n    now = next;\n";
        }
        let _ = writeln!(
            text,
            "    sum += {factor} * {:?} * {look_up}(\"{place}/{}\", s, t, {columns}, {rows});",
            image.scale, image.file
        );
    }
    text + "    return sum;\n}\n\n"
}

/// What the closure draws from.
struct CellList {
    /// u, v of a cell's middle at each entry, shape `[LIST_SIDE, LIST_SIDE, 3]`.
    cells: Array3<f32>,
    /// How densely entries lie over (u, v), shape `[CELLS, CELLS, 3]` with three equal channels.
    density: Array3<f32>,
    /// Share of the samples that the lobe gets.
    lobe_share: f64,
}

fn cell_list(set: &TableSet) -> CellList {
    let (rows, columns, _) = set.tables[0].dim();
    let bases: Vec<Vec<f64>> =
        (1..=T_VALUES).map(|k| chebyshev::shifted_values(set.tables.len(), k as f64 / T_VALUES as f64)).collect();
    let mut power = vec![0.0; CELLS * CELLS];
    let cell_of = |texel: usize, count: usize| (texel * CELLS / (count - 1)).min(CELLS - 1);
    for row in 0..rows {
        for column in 0..columns {
            let sums: Vec<f64> =
                set.tables.iter().map(|table| (0..3).map(|c| f64::from(table[[row, column, c]])).sum()).collect();
            let at = |basis: &Vec<f64>| basis.iter().zip(&sums).map(|(b, s)| b * s).sum::<f64>().max(0.0);
            let mean = bases.iter().map(at).sum::<f64>() / T_VALUES as f64;
            power[cell_of(row, rows) * CELLS + cell_of(column, columns)] += mean;
        }
    }
    let counts = apportioned(&power, LIST_SIDE * LIST_SIDE);
    let middle = |index: usize| -2.0 + 4.0 * (index as f64 + 0.5) / CELLS as f64;
    let mut texels = Vec::with_capacity(3 * LIST_SIDE * LIST_SIDE);
    for (cell, count) in counts.iter().enumerate() {
        let uv = [middle(cell % CELLS) as f32, -middle(cell / CELLS) as f32, 0.0];
        (0..*count).for_each(|_| texels.extend(uv));
    }
    let per_entry = 1.0 / (LIST_SIDE * LIST_SIDE) as f64 / (4.0 / CELLS as f64).powi(2);
    let density = Array3::from_shape_fn((CELLS, CELLS, 3), |(row, column, _)| {
        (counts[row * CELLS + column] as f64 * per_entry) as f32
    });
    let cells = Array3::from_shape_vec((LIST_SIDE, LIST_SIDE, 3), texels)
        .unwrap_or_else(|_| unreachable!("as many entries are dealt out as the list has"));
    let of_tables = power.iter().sum::<f64>() * 16.0 / ((rows - 1) * (columns - 1)) as f64;
    CellList { cells, density, lobe_share: lobe_share(set, of_tables) }
}

/// Entries dealt out in proportion, the left over ones to the largest remainders; to all alike where there is nothing.
fn apportioned(power: &[f64], entries: usize) -> Vec<usize> {
    let total: f64 = power.iter().sum();
    let share = |power: f64| if total > 0.0 { power / total } else { 1.0 / CELLS as f64 / CELLS as f64 };
    let exact: Vec<f64> = power.iter().map(|power| share(*power) * entries as f64).collect();
    let mut counts: Vec<usize> = exact.iter().map(|exact| *exact as usize).collect();
    let left = entries - counts.iter().sum::<usize>();
    let mut order: Vec<usize> = (0..power.len()).collect();
    order.sort_by(|a, b| exact[*b].fract().total_cmp(&exact[*a].fract()).then(a.cmp(b)));
    order.iter().cycle().take(left).for_each(|cell| counts[*cell] += 1);
    counts
}

/// The lobe's share of what is drawn by the tables and it: that of its power at `t = 1`.
fn lobe_share(set: &TableSet, of_tables: f64) -> f64 {
    let Some(lobe) = &set.lobe else { return 0.0 };
    let (rows, columns, _) = lobe.coherent.dim();
    let step = lobe.radius_max / (columns - 1) as f64;
    let ring = |column: usize| {
        let value: f64 = (0..3).map(|c| f64::from(lobe.coherent[[rows - 1, column, c]])).sum();
        value * std::f64::consts::TAU * column as f64 * step * step
    };
    let of_lobe: f64 = (0..columns).map(ring).sum();
    let share = if of_lobe + of_tables > 0.0 { of_lobe / (of_lobe + of_tables) } else { 0.5 };
    (1.0 - SHARE_EVEN) * share.clamp(SHARE_MIN, 1.0 - SHARE_MIN)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn entries_are_dealt_out_without_remainder() {
        let counts = apportioned(&[1.0, 2.0, 0.0, 4.0], 10);
        assert_eq!(counts, [1, 3, 0, 6]);
        assert_eq!(apportioned(&[0.0; CELLS * CELLS], 2 * CELLS * CELLS), vec![2; CELLS * CELLS]);
    }

    #[test]
    fn sums_name_each_image_and_step_the_polynomials() {
        let image = |n: usize| StoredArray {
            file: format!("t{n}.exr"),
            ..serde_json::from_value(json!({"file": "", "scale": 0.5, "peak": 1.0, "flushed": 0, "rounding": 0.0}))
                .unwrap()
        };
        let text = sum_of("tables_at", "spline", &[image(0), image(1), image(2), image(3)], "/x", ["A", "B"]);
        assert_eq!(text.matches("next = 2.0 * x * now - before;").count(), 2);
        assert!(text.contains("sum += now * 0.5 * spline(\"/x/t3.exr\", s, t, A, B);"), "{text}");
        assert!(sum_of("cross_at", "cubic", &[], "/x", ["A", "B"]).contains("return sum"));
    }
}
