//! Height fields as TIFF files that any microscopy program reads with their calibration.

use std::io::Cursor;
use std::path::Path;

use tiff::TiffError;
use tiff::encoder::compression::DeflateLevel;
use tiff::encoder::{Compression, Rational, TiffEncoder, colortype};
use tiff::tags::{ResolutionUnit, Tag};

use crate::height::HeightField;
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::files;

/// Writes a height field as a 32-bit floating-point TIFF in nm, calibrated the way ImageJ does it: `unit` and
/// `vunit` in the description, pixels per nm in the resolution tags. An existing file is replaced as a
/// whole. The same field gives the same bytes.
///
/// Heights keep 24 significant bits, the pitch at least nine digits.
///
/// # Errors
/// [`Error::Disk`] where the file cannot be written; [`Error::Limit`] for what a TIFF cannot hold: no
/// samples, heights that are no finite 32-bit number, a pitch outside 1e-6 nm to 1 mm, or 4 GiB and more.
pub fn write_scan_tiff(path: &Path, field: &HeightField) -> Result<()> {
    files::replace(path, &scan_tiff(path, field)?)
}

/// The bytes of [`write_scan_tiff`]; `path` is for messages.
///
/// # Errors
/// As [`write_scan_tiff`], without [`Error::Disk`].
pub(crate) fn scan_tiff(path: &Path, field: &HeightField) -> Result<Vec<u8>> {
    let refuse = |what: String, fix: &str| Err(Error::limit(format!("{}: {what}", path.display()), fix));
    let [nx, ny] = field.size();
    let (Ok(width), Ok(height)) = (u32::try_from(nx), u32::try_from(ny)) else {
        return refuse(format!("a TIFF cannot be {nx} x {ny} samples"), "lower the size");
    };
    if nx == 0 || ny == 0 {
        return refuse(format!("a field of {nx} x {ny} samples is empty"), "give it one sample at least");
    }
    let [Some(x_per_nm), Some(y_per_nm)] = field.pitch_nm.map(per_nm) else {
        return refuse(
            format!("a TIFF cannot hold the pitch {:?} nm", field.pitch_nm),
            "use a pitch between 1e-6 nm and 1 mm",
        );
    };
    let heights: Vec<f32> = field.heights_nm.iter().map(|height| *height as f32).collect();
    if let Some(index) = heights.iter().position(|height| !height.is_finite()) {
        return refuse(
            format!(
                "the height {} nm in row {}, column {} is no finite 32-bit number",
                field.heights_nm[[index / nx, index % nx]],
                index / nx,
                index % nx
            ),
            "fill missing samples before writing",
        );
    }
    encode([width, height], [x_per_nm, y_per_nm], &heights).map_err(|error| {
        Error::limit(
            format!("{}: cannot encode {nx} x {ny} samples as TIFF: {error}", path.display()),
            "lower the size: a TIFF holds 4 GiB",
        )
    })
}

fn encode(
    [width, height]: [u32; 2],
    [x, y]: [Rational; 2],
    heights: &[f32],
) -> std::result::Result<Vec<u8>, TiffError> {
    let mut bytes = Vec::new();
    // ImageJ decodes plain deflate of floating-point samples, but none of the predictors.
    let mut file =
        TiffEncoder::new(Cursor::new(&mut bytes))?.with_compression(Compression::Deflate(DeflateLevel::Best));
    let mut image = file.new_image::<colortype::Gray32Float>(width, height)?;
    image.encoder().write_tag(Tag::ImageDescription, description(heights).as_str())?;
    image.x_resolution(x);
    image.y_resolution(y);
    image.resolution_unit(ResolutionUnit::None);
    image.write_data(heights)?;
    Ok(bytes)
}

/// ImageJ's description; `min` and `max` are the limits of its display.
fn description(heights: &[f32]) -> String {
    let low = heights.iter().copied().fold(f32::INFINITY, f32::min);
    let high = heights.iter().copied().fold(f32::NEG_INFINITY, f32::max);
    format!("ImageJ=1.54f\nunit=nm\nvunit=nm\nmin={low:?}\nmax={high:?}\n")
}

/// Samples per nm as a ratio of 32-bit numbers, by continued fractions: the last convergent that fits.
/// `None` for a pitch that no such ratio approximates well.
fn per_nm(pitch_nm: f64) -> Option<Rational> {
    if !(1e-6..=1e6).contains(&pitch_nm) {
        return None;
    }
    // Convergents of the pitch; numerator and denominator trade places at the end.
    let (mut before, mut last) = ([0u64, 1u64], [1u64, 0u64]);
    let mut rest = pitch_nm;
    loop {
        let whole = rest.floor();
        let next = [0, 1].map(|part| (whole as u64).saturating_mul(last[part]).saturating_add(before[part]));
        if next.iter().any(|part| *part > u64::from(u32::MAX)) {
            break;
        }
        (before, last) = (last, next);
        if (last[0] as f64 / last[1] as f64 - pitch_nm).abs() <= 1e-16 * pitch_nm {
            break;
        }
        rest = 1.0 / (rest - whole);
    }
    let [numerator, denominator] = last.map(|part| u32::try_from(part).ok());
    Some(Rational { n: denominator?, d: numerator.filter(|part| *part > 0)? })
}

#[cfg(test)]
mod tests {
    use ndarray::array;
    use proptest::prelude::*;

    use super::*;
    use crate::height::read::{ReadConfig, scan_from_bytes};

    fn field(pitch_nm: [f64; 2]) -> HeightField {
        HeightField { heights_nm: array![[0.0, -1.5, 1e-3], [250.125, 1e6, -7.0]], pitch_nm }
    }

    proptest! {
        #[test]
        fn the_pitch_comes_back(x in -2.99..5.99f64, y in -2.99..5.99f64) {
            let pitch = [10f64.powf(x), 10f64.powf(y)];
            let bytes = scan_tiff(Path::new("f.tif"), &field(pitch)).unwrap();
            let scan = scan_from_bytes(Path::new("f.tif"), &bytes, &ReadConfig::default()).unwrap();
            for (read, written) in scan.field.pitch_nm.into_iter().zip(pitch) {
                // The last convergent p/q that fits is off by less than 1/(q q'), the next one p'/q' having p' or q'
                // above 2^32: a share below 1/(q 2^32) or 1/(p 2^32), so below 2.4e-10.
                prop_assert!((read / written - 1.0).abs() < 1e-9, "{read} {written}");
            }
        }
    }

    #[test]
    fn usual_pitches_come_back_exactly() {
        for pitch in [48.8, 62.5, 62.34375, 60.546875, 11.71875, 50.0, 1.0, 0.1, 1e-6, 1e6, 84.0442164] {
            let ratio = per_nm(pitch).unwrap();
            assert_eq!(f64::from(ratio.d) / f64::from(ratio.n), pitch);
        }
        for pitch in [0.0, -1.0, f64::NAN, f64::INFINITY, 1e7, 1e-7] {
            assert!(per_nm(pitch).is_none());
        }
    }

    #[test]
    fn heights_and_units_come_back_without_help() {
        let field = field([48.8, 50.0]);
        let bytes = scan_tiff(Path::new("f.tif"), &field).unwrap();
        assert_eq!(bytes, scan_tiff(Path::new("f.tif"), &field).unwrap());
        let scan = scan_from_bytes(Path::new("f.tif"), &bytes, &ReadConfig::default()).unwrap();
        assert_eq!(scan.field.heights_nm, field.heights_nm.mapv(|height| f64::from(height as f32)));
        let about = scan.provenance;
        assert_eq!((about.format.as_str(), about.sample_format.as_str()), ("ImageJ TIFF", "f32"));
        assert!(about.pitch_from.contains("ImageJ") && about.height_from.contains("ImageJ"), "{about:?}");
        assert!(about.warnings.is_empty(), "{about:?}");
    }

    #[test]
    fn what_a_tiff_cannot_hold_is_refused() {
        let refused = |field: &HeightField| scan_tiff(Path::new("f.tif"), field).unwrap_err().to_string();
        assert!(refused(&field([0.0, 1.0])).contains("pitch"));
        for bad in [f64::NAN, f64::INFINITY, 1e39] {
            let mut field = field([1.0; 2]);
            field.heights_nm[[1, 2]] = bad;
            assert!(refused(&field).contains("row 1, column 2"), "{}", refused(&field));
        }
        let empty = HeightField { heights_nm: ndarray::Array2::zeros([0, 3]), pitch_nm: [1.0; 2] };
        assert!(refused(&empty).contains("3 x 0 samples is empty"));
    }

    #[test]
    fn files_are_replaced_whole() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("f.tif");
        std::fs::write(&path, "old").unwrap();
        write_scan_tiff(&path, &field([1.0; 2])).unwrap();
        assert_eq!(std::fs::read(&path).unwrap(), scan_tiff(&path, &field([1.0; 2])).unwrap());
        assert!(write_scan_tiff(&folder.path().join("none/f.tif"), &field([1.0; 2])).is_err());
    }
}
