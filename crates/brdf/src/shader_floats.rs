//! Layers of 32-bit floats for the shaders: for tables that 16 bits would round by more than their tolerance.

use ndarray::{Array3, ArrayView3, Axis};

use crate::evaluate::Interpolation;
use crate::mips;
use crate::shader_spectral::TABLES_PER_LAYER;
use crate::spectral::{SpectralTables, TABLES_PER_IMAGE};
use crate::splines::Splines;
use crate::table_set::TableSet;

/// The levels of a texture, from the finest to the coarsest; value = texel, so that scales in the uniform are 1.
#[derive(Debug, Clone, PartialEq)]
pub struct FloatLayers {
    /// Layers of every level.
    pub count: usize,
    /// The finest level, and those of the mip chain below, which tables restricted to scenes lack.
    pub levels: Vec<FloatLevel>,
}

/// A level, `[layer][row][column]`.
#[derive(Debug, Clone, PartialEq)]
pub struct FloatLevel {
    /// Number of rows and columns.
    pub size: [usize; 2],
    /// All layers' texels; in those of X, Y, Z the fourth channel is unused.
    pub texels: Vec<[f32; 4]>,
}

/// Tables for the look-ups that they are promised for, and, where they are restricted, the range behind them; a layer to a table. `set` is one that
/// [`promised_image`](crate::shader::promised_image) takes.
pub fn promised_floats(set: &TableSet) -> FloatLayers {
    let mut layers = float_layers(&set.tables);
    if set.look_up() == Interpolation::Spline {
        layers.put_on_the_finest(float_layers(Splines::new(&set.tables).coefficients()));
    }
    if let Some(restriction) = &set.restriction {
        layers.levels.truncate(1);
        layers.levels[0].texels.extend(restriction.range.rows().into_iter().map(|x| [x[0], x[1], x[2], 0.0]));
        layers.count += 1;
    }
    layers
}

/// Spectral tables likewise, four to a layer.
pub fn promised_spectral_floats(tables: &SpectralTables) -> FloatLayers {
    let mut layers = float_layers_of_spectral(&tables.images, tables.count);
    let splines = Splines::new(&tables.images);
    layers.put_on_the_finest(float_layers_of_spectral(splines.coefficients(), tables.count));
    layers
}

impl FloatLayers {
    /// Coefficients stand for values where nothing is averaged.
    fn put_on_the_finest(&mut self, coefficients: Self) {
        self.levels[0] =
            coefficients.levels.into_iter().next().unwrap_or_else(|| unreachable!("a texture has a level"));
    }
}

/// Images of X, Y, Z, a layer to an image; one black texel where there are none.
pub fn float_layers(images: &[Array3<f32>]) -> FloatLayers {
    let planes = images.iter().flat_map(|image| (0..3).map(|channel| plane(image, channel)));
    in_layers(planes, images.len(), 3)
}

/// `count` spectral tables of images with three each, four to a layer; one black texel where there are none.
pub fn float_layers_of_spectral(images: &[Array3<f32>], count: usize) -> FloatLayers {
    let planes = (0..count).map(|n| plane(&images[n / TABLES_PER_IMAGE], n % TABLES_PER_IMAGE));
    in_layers(planes, count.div_ceil(TABLES_PER_LAYER), TABLES_PER_LAYER)
}

fn plane(image: &Array3<f32>, channel: usize) -> ArrayView3<'_, f32> {
    image.index_axis(Axis(2), channel).insert_axis(Axis(2))
}

fn in_layers<'a>(planes: impl Iterator<Item = ArrayView3<'a, f32>>, count: usize, per_layer: usize) -> FloatLayers {
    let mut out = FloatLayers { count, levels: Vec::new() };
    for (n, plane) in planes.enumerate() {
        let coarser = mips::coarser(plane);
        for (index, level) in std::iter::once(plane).chain(coarser.iter().map(|level| level.view())).enumerate() {
            let (rows, columns, _) = level.dim();
            if n == 0 {
                out.levels.push(FloatLevel { size: [rows, columns], texels: vec![[0.0; 4]; count * rows * columns] });
            }
            let layer = &mut out.levels[index].texels[n / per_layer * rows * columns..][..rows * columns];
            layer.iter_mut().zip(level).for_each(|(texel, value)| texel[n % per_layer] = *value);
        }
    }
    if out.levels.is_empty() {
        return FloatLayers { count: 1, levels: vec![FloatLevel { size: [1, 1], texels: vec![[0.0; 4]] }] };
    }
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texels_lie_where_the_halves_do_and_keep_their_bits() {
        let image =
            |shift: f32| Array3::from_shape_fn((9, 8, 3), |(r, c, k)| shift + (r * 80 + c * 10 + k) as f32 / 3.0);
        let images = [image(0.1), image(-7.7)];
        let xyz = float_layers(&images);
        assert_eq!((xyz.count, xyz.levels.len(), xyz.levels[1].size), (2, 2, [4, 4]));
        assert_eq!(xyz.levels[0].texels[72 + 8 * 2 + 5][..3], [0, 1, 2].map(|k| images[1][[2, 5, k]]));
        let spectral = float_layers_of_spectral(&images, 5);
        assert_eq!(spectral.count, 2);
        // The fifth table is the second image's second channel: the first of the second layer.
        assert_eq!(spectral.levels[0].texels[72 + 8 * 2 + 5], [images[1][[2, 5, 1]], 0.0, 0.0, 0.0]);
        assert_eq!(spectral.levels[1].texels[0][3], mips::coarser(plane(&images[1], 0))[0][[0, 0, 0]]);
        assert_eq!(float_layers(&[]).levels[0].texels, [[0.0; 4]]);
    }
}
