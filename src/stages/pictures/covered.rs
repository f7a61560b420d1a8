//! Picture of the part of the (u, v) disc that restricted tables cover: their mean light there, grey elsewhere.

use ndarray::Array3;

use diffraction_build::ground::colour::{auto_exposure, to_srgb8};
use diffraction_build::tables::model::{Restriction, TableSet};

/// Side of the picture in pixels.
const SIDE_PX: usize = 360;

/// The disc where nothing is covered, and the square around it.
const UNCOVERED_RGB: [u8; 3] = [70, 70, 74];
const OUTSIDE_RGB: [u8; 3] = [255, 255, 255];

/// The square [-2, 2]² of (u, v), +v up; `None` where every direction is.
pub(crate) fn covered_picture(set: &TableSet) -> Option<Array3<u8>> {
    let window = set.restriction.as_ref()?;
    let table = set.tables.first()?;
    // The first polynomial is 1: its table is the mean over the |w| covered.
    let numbers = Array3::from_shape_fn((SIDE_PX, SIDE_PX, 3), |(row, column, channel)| {
        texel_at(window, row, column).map_or(0.0, |[r, c]| table[[r, c, channel]].max(0.0))
    });
    let mut picture = to_srgb8(&numbers, auto_exposure(&numbers));
    for row in 0..SIDE_PX {
        for column in 0..SIDE_PX {
            let colour = match texel_at(window, row, column) {
                Some(_) => continue,
                None if place(row).hypot(place(column)) < 2.0 => UNCOVERED_RGB,
                None => OUTSIDE_RGB,
            };
            colour.into_iter().enumerate().for_each(|(c, value)| picture[[row, column, c]] = value);
        }
    }
    Some(picture)
}

/// Coordinate of a pixel's centre, from -2 to 2.
fn place(pixel: usize) -> f64 {
    4.0 * (pixel as f64 + 0.5) / SIDE_PX as f64 - 2.0
}

/// The covered texel of the window nearest to a pixel.
fn texel_at(window: &Restriction, row: usize, column: usize) -> Option<[usize; 2]> {
    let nearest = |pixel: usize| ((place(pixel) + 2.0) / 4.0 * (window.size - 1) as f64).round() as usize;
    let (r, c) = (nearest(row).checked_sub(window.first[0])?, nearest(column).checked_sub(window.first[1])?);
    let (rows, columns, _) = window.range.dim();
    (r < rows && c < columns && window.range[[r, c, 2]] > 0.0).then_some([r, c])
}

#[cfg(test)]
mod tests {
    use super::*;
    use diffraction_brdf::front_factor::{Factor, FrontFactor};
    use diffraction_brdf::material::Material;
    use diffraction_build::tables::model::Basis;

    #[test]
    fn covered_texels_shine_and_the_rest_of_the_disc_is_grey() {
        // 5 x 5 texels over [-2, 2]; the window is the column u = 1, rows v = 1 and v = 0, of which v = 0 is covered.
        let mut range = Array3::zeros((2, 1, 3));
        range[[1, 0, 2]] = 1.0;
        let set = TableSet {
            basis: Basis::Chebyshev,
            tables: vec![Array3::from_elem((2, 1, 3), 1.0)],
            lobe: None,
            prefilter_width: 0.0,
            front_factor: FrontFactor { material: Material::Ideal, shadowing: false, factor: Factor::Scalar },
            restriction: Some(Restriction { size: 5, first: [1, 3], range }),
            usable_radius: 2.0,
        };
        let picture = covered_picture(&set).unwrap();
        let at = |u: f64, v: f64| {
            let pixel = |x: f64| ((x + 2.0) / 4.0 * SIDE_PX as f64) as usize;
            [0, 1, 2].map(|c| picture[[pixel(-v), pixel(u), c]])
        };
        assert!(at(1.0, 0.0)[1] > 200, "{:?}", at(1.0, 0.0));
        for (u, v) in [(1.0, 1.0), (0.0, 0.0), (-1.0, 0.0)] {
            assert_eq!(at(u, v), UNCOVERED_RGB);
        }
        assert_eq!(at(1.9, 1.9), OUTSIDE_RGB);
        assert!(covered_picture(&TableSet { restriction: None, ..set }).is_none());
    }
}
