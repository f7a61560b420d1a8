//! Values at directions, and the columns that they stand in.

use std::f64::consts::PI;

use crate::cli::terminal;
use crate::error::Result;
use diffraction_brdf::direction::{Vec3, Xyz};
use diffraction_brdf::error::Error;
use diffraction_brdf::front_factor::{Factor, FrontFactor};
use diffraction_build::ground::colour::{srgb_encode, xyz_to_linear_srgb};
use diffraction_build::ground::hue::Hue;

/// Columns beside the angles, and a row of values per pair.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Table {
    pub(super) columns: Vec<String>,
    pub(super) values: Vec<Vec<f64>>,
}

/// Values, and XYZ of the light that they are under; `None` for those of single wavelengths.
pub(super) struct Evaluated {
    pub(super) table: Table,
    pub(super) white: Option<Xyz>,
}

/// Values of X, Y, Z.
pub(super) fn xyz_table(values: impl IntoIterator<Item = Xyz>) -> Table {
    Table {
        columns: ["X", "Y", "Z"].map(String::from).to_vec(),
        values: values.into_iter().map(|xyz| xyz.to_vec()).collect(),
    }
}

/// Names of columns of single wavelengths.
pub(super) fn wavelength_columns(wavelengths_nm: &[f64]) -> Vec<String> {
    wavelengths_nm.iter().map(|nm| format!("f_{nm}_nm")).collect()
}

/// Suffixes of the columns of polarised values.
const POLARISATIONS: [&str; 4] = ["ss", "sp", "ps", "pp"];

/// Four columns for each of these.
pub(super) fn polarised_columns(names: &[String]) -> Vec<String> {
    names.iter().flat_map(|name| POLARISATIONS.map(|kind| format!("{name}_{kind}"))).collect()
}

/// Polarised values of X, Y, Z.
pub(super) fn polarised_table(values: &[[Xyz; 4]]) -> Table {
    let row = |by_kind: &[Xyz; 4]| (0..3).flat_map(|c| by_kind.map(|xyz| xyz[c])).collect();
    Table { columns: polarised_columns(&["X", "Y", "Z"].map(String::from)), values: values.iter().map(row).collect() }
}

/// Refuses to keep polarisations apart where the front factor does not.
///
/// # Errors
/// [`Error::Limit`].
pub(super) fn check_polarised(front: FrontFactor, specimen: &str) -> Result<()> {
    let up = [0.0, 0.0, 1.0];
    if front.polarised(up, up).is_some() {
        return Ok(());
    }
    let what = match front.factor {
        Factor::Scalar => "has the scalar factor",
        Factor::Vector => "is an ideal reflector, which has no refractive index",
    };
    Err(Error::limit(
        format!("`{specimen}` {what}, and so knows no polarisation"),
        "leave `--polarised` out, or set optics.factor = \"vector\" and a material such as { n = 1.56 } for it",
    )
    .into())
}

/// Values past the scan's sampling are too dark: said, not hidden.
pub(super) fn warn_beyond(usable_radius: f64, pairs: &[(Vec3, Vec3)]) {
    let beyond = pairs.iter().filter(|(wi, wo)| (wi[0] + wo[0]).hypot(wi[1] + wo[1]) > usable_radius).count();
    if beyond > 0 {
        terminal::say(&format!(
            "warning: {beyond} of {} directions lie beyond |(u, v)| = {usable_radius:.3}, where the scan's sampling no \
             longer answers for every wavelength: their values are too dark\n",
            pairs.len()
        ));
    }
}

/// Columns of the colour behind those of X, Y, Z: what a surface of this BRDF looks like beside a matt white in the same light, whose
/// BRDF is 1/π. Lights of other chromaticity are not adapted to: a white lamp's white comes out as the lamp.
pub(super) fn with_colour(table: Table, white: Xyz) -> Table {
    let Table { mut columns, mut values } = table;
    columns.extend(["sRGB_R", "sRGB_G", "sRGB_B", "x", "y", "dominant_nm"].map(String::from));
    for row in &mut values {
        let xyz: Xyz = [row[0], row[1], row[2]];
        let rgb = xyz_to_linear_srgb(xyz.map(|value| PI * value)).map(|linear| srgb_encode(linear.clamp(0.0, 1.0)));
        let hue = Hue::of(xyz, white);
        let [x, y] = hue.map_or([f64::NAN; 2], |hue| hue.xy);
        row.extend(rgb);
        row.extend([x, y, hue.and_then(|hue| hue.dominant_nm).unwrap_or(f64::NAN)]);
    }
    Table { columns, values }
}
