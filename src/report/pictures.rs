//! Pictures of height data: the map of the heights and, beside it, their power spectrum.

use ndarray::{Array2, Array3, Axis};

use crate::report::colour_maps::{VIRIDIS, colour};
use crate::report::svg::round_step;
use diffraction_brdf::error::{Error, Result};
use diffraction_build::height::HeightField;

/// Margin of the scale bar from the lower left corner, as a share of the picture's longer side.
pub(crate) const SCALE_BAR_MARGIN: f64 = 0.03;

/// Longer side of a height map in pixels, whatever the scan: keeps the file small and the bar crisp.
const HEIGHT_MAP_PX: f64 = 600.0;

/// Colour of samples that were replaced: none of the map's.
const REPLACED_RGB: [u8; 3] = [230, 50, 50];

/// A height map and what its colours mean.
#[derive(Debug, Clone, PartialEq)]
pub struct HeightPicture {
    /// sRGB, shape `[rows, columns, 3]`, square pixels, row 0 at +y.
    pub rgb: Array3<u8>,
    /// Length in µm of the bar in the lower left corner; 0 where the picture is too low for one.
    pub scale_bar_um: f64,
    /// Height of the darkest colour in nm; a thousandth of the surface is lower.
    pub low_nm: f64,
    /// Height of the brightest colour in nm; a thousandth of the surface is higher.
    pub high_nm: f64,
}

/// Draws the heights. Colours span the middle 99.8 % of the heights, so that a grain of dust does
/// not flatten the rest. Samples that were `replaced`, of the field's shape, are marked in red.
///
/// Fails on a field without samples or without an area.
pub fn height_map(field: &HeightField, replaced: Option<&Array2<bool>>) -> Result<HeightPicture> {
    require_area(field)?;
    let [low_nm, high_nm] = quantiles(field, [0.001, 0.999]);
    let [width, height] = picture_size(field.extent_nm());
    let resampled = area_average(&field.heights_nm, height, width);
    let mut rgb = Array3::zeros((height, width, 3));
    let span = high_nm - low_nm;
    for ((row, column), &value) in resampled.indexed_iter() {
        // A flat field has no span: it is drawn in the middle colour. Missing heights stay NaN.
        let position = if span > 0.0 || value.is_nan() { (value - low_nm) / span } else { 0.5 };
        put(&mut rgb, row, column, colour(&VIRIDIS, position));
    }
    if let Some(replaced) = replaced {
        // Of a pixel over many samples one is enough, or single outliers would not be seen.
        let shares = area_average(&replaced.mapv(|is_replaced| f64::from(u8::from(is_replaced))), height, width);
        let marked = shares.indexed_iter().filter(|(_, share)| **share > 0.0);
        marked.for_each(|((row, column), _)| put(&mut rgb, row, column, REPLACED_RGB));
    }
    let scale_bar_um = draw_scale_bar(&mut rgb, field.extent_nm()[0] * 1e-3);
    Ok(HeightPicture { rgb, scale_bar_um, low_nm, high_nm })
}

/// Refuses fields that have no picture.
pub(super) fn require_area(field: &HeightField) -> Result<()> {
    let [x_nm, y_nm] = field.extent_nm();
    if x_nm > 0.0 && y_nm > 0.0 && x_nm.is_finite() && y_nm.is_finite() {
        return Ok(());
    }
    let [nx, ny] = field.size();
    Err(Error::limit(
        format!("a height field of {nx} x {ny} samples, {x_nm} x {y_nm} nm, cannot be drawn"),
        "give a scan with samples and a positive pitch",
    ))
}

/// Quantiles of the finite heights; zeros where there are none.
fn quantiles(field: &HeightField, shares: [f64; 2]) -> [f64; 2] {
    let mut sorted: Vec<f64> = field.heights_nm.iter().copied().filter(|height| height.is_finite()).collect();
    if sorted.is_empty() {
        return [0.0; 2];
    }
    let last = (sorted.len() - 1) as f64;
    shares.map(|share| {
        let rank = (share * last).round() as usize;
        *sorted.select_nth_unstable_by(rank, f64::total_cmp).1
    })
}

/// Width and height in pixels with the extent's proportions.
fn picture_size(extent_nm: [f64; 2]) -> [usize; 2] {
    let longer = extent_nm[0].max(extent_nm[1]);
    extent_nm.map(|extent| ((extent / longer * HEIGHT_MAP_PX).round() as usize).max(1))
}

/// Mean of the samples under every pixel of a `rows` x `columns` picture of the same extent; where
/// pixels are smaller than samples this is the sample they lie in.
fn area_average(values: &Array2<f64>, rows: usize, columns: usize) -> Array2<f64> {
    let along_x = coverage(values.ncols(), columns);
    let along_y = coverage(values.nrows(), rows);
    let mut narrow: Array2<f64> = Array2::zeros((values.nrows(), columns));
    for (source, mut target) in values.axis_iter(Axis(0)).zip(narrow.axis_iter_mut(Axis(0))) {
        for (pixel, (first, weights)) in along_x.iter().enumerate() {
            target[pixel] = (0..weights.len()).map(|i| weights[i] * source[first + i]).sum::<f64>();
        }
    }
    Array2::from_shape_fn((rows, columns), |(row, column)| {
        let (first, weights) = &along_y[row];
        (0..weights.len()).map(|i| weights[i] * narrow[(first + i, column)]).sum::<f64>()
    })
}

/// For each of `pixels` equal parts of a line of `samples` cells: the first cell it touches and the
/// share of the part that lies in this cell and in the following ones.
fn coverage(samples: usize, pixels: usize) -> Vec<(usize, Vec<f64>)> {
    let width = samples as f64 / pixels as f64;
    (0..pixels)
        .map(|pixel| {
            let from = pixel as f64 * width;
            let to = (from + width).min(samples as f64);
            let first = (from as usize).min(samples - 1);
            let last = (to.ceil() as usize).clamp(first + 1, samples);
            let shares: Vec<f64> =
                (first..last).map(|cell| (to.min((cell + 1) as f64) - from.max(cell as f64)).max(0.0)).collect();
            let total: f64 = shares.iter().sum();
            (first, shares.iter().map(|share| share / total).collect())
        })
        .collect()
}

/// Draws a white bar with a black rim into the lower left corner and says how long it is in µm.
fn draw_scale_bar(rgb: &mut Array3<u8>, extent_x_um: f64) -> f64 {
    let (rows, columns, _) = rgb.dim();
    let margin = (SCALE_BAR_MARGIN * rows.max(columns) as f64).round() as usize;
    let thickness = (margin / 3).max(2);
    let bar_um = round_step(extent_x_um / 4.0);
    let length = (bar_um / extent_x_um * columns as f64).round() as usize;
    if rows < 3 * margin + thickness || columns < 2 * margin + length || length < 2 {
        return 0.0;
    }
    let top = rows - margin - thickness;
    for row in top - 1..=top + thickness {
        for column in margin - 1..=margin + length {
            let inside = (top..top + thickness).contains(&row) && (margin..margin + length).contains(&column);
            put(rgb, row, column, if inside { [255; 3] } else { [0; 3] });
        }
    }
    bar_um
}

/// Sets a pixel.
pub(super) fn put(rgb: &mut Array3<u8>, row: usize, column: usize, value: [u8; 3]) {
    for channel in 0..3 {
        rgb[(row, column, channel)] = value[channel];
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn map_of(field: &HeightField) -> Result<HeightPicture> {
        height_map(field, None)
    }

    fn field(rows: usize, columns: usize, pitch_nm: [f64; 2], height: impl Fn(usize, usize) -> f64) -> HeightField {
        HeightField {
            heights_nm: Array2::from_shape_fn((rows, columns), |(row, column)| height(row, column)),
            pitch_nm,
        }
    }

    fn pixel(picture: &HeightPicture, row: usize, column: usize) -> [u8; 3] {
        std::array::from_fn(|channel| picture.rgb[(row, column, channel)])
    }

    #[test]
    fn proportions_follow_the_extent_and_row_0_is_on_top() {
        // 20 µm wide, 5 µm high, in pixels that are twice as wide as high.
        let map = map_of(&field(100, 200, [100.0, 50.0], |row, _| 99.0 - row as f64)).unwrap();
        assert_eq!(map.rgb.dim(), (150, 600, 3));
        assert_eq!(pixel(&map, 0, 300), VIRIDIS[15]);
        assert_eq!(pixel(&map, 149, 590), VIRIDIS[0]);
        assert_eq!(map.scale_bar_um, 5.0);
    }

    #[test]
    fn the_bar_is_as_long_as_it_says() {
        let map = map_of(&field(256, 256, [125.0, 125.0], |row, column| (row + column) as f64)).unwrap();
        assert_eq!(map.scale_bar_um, 5.0);
        let row = 600 - 18 - 3;
        let white = (0..300).filter(|&column| pixel(&map, row, column) == [255; 3]).count();
        // 5 µm of 32 µm on 600 pixels, to the nearest pixel.
        assert_eq!(white, 94);
    }

    #[test]
    fn dust_does_not_set_the_range() {
        let dusty = field(
            100,
            100,
            [50.0, 50.0],
            |row, column| {
                if (row, column) == (40, 40) { 1e4 } else { (column % 10) as f64 }
            },
        );
        let map = map_of(&dusty).unwrap();
        assert_eq!([map.low_nm, map.high_nm], [0.0, 9.0]);
    }

    #[test]
    fn replaced_samples_are_marked() {
        let slope = field(1200, 1200, [10.0; 2], |row, column| (row + column) as f64);
        let mut replaced = Array2::from_elem((1200, 1200), false);
        replaced[[101, 401]] = true;
        let marked = height_map(&slope, Some(&replaced)).unwrap();
        assert_eq!(pixel(&marked, 50, 200), REPLACED_RGB);
        let (plain, mut expected) = (map_of(&slope).unwrap(), marked.clone());
        put(&mut expected.rgb, 50, 200, pixel(&plain, 50, 200));
        assert_eq!(plain, expected, "nothing else is marked");
    }

    #[test]
    fn averages_keep_the_mean_and_enlarging_keeps_the_samples() {
        let values = Array2::from_shape_fn((7, 5), |(row, column)| (row * row + 3 * column) as f64);
        let smaller = area_average(&values, 3, 2);
        assert!((smaller.mean().unwrap() - values.mean().unwrap()).abs() < 1e-12);
        let larger = area_average(&values, 14, 10);
        assert_eq!(larger[(13, 9)], values[(6, 4)]);
        assert_eq!(larger[(4, 3)], values[(2, 1)]);
    }

    #[test]
    fn flat_missing_and_thin_fields() {
        let flat = map_of(&field(8, 8, [50.0, 50.0], |_, _| 3.0)).unwrap();
        assert_eq!(pixel(&flat, 0, 0), colour(&VIRIDIS, 0.5));
        let missing = map_of(&field(8, 8, [50.0, 50.0], |_, _| f64::NAN)).unwrap();
        assert_eq!(pixel(&missing, 0, 0), [128; 3]);
        assert_eq!(missing.low_nm, 0.0);
        let thin = map_of(&field(1, 2000, [50.0, 50.0], |_, column| column as f64)).unwrap();
        assert_eq!((thin.rgb.dim(), thin.scale_bar_um), ((1, 600, 3), 0.0));
        assert!(map_of(&field(0, 8, [50.0, 50.0], |_, _| 0.0)).is_err());
        assert!(map_of(&field(8, 8, [f64::NAN, 50.0], |_, _| 0.0)).is_err());
    }
}
