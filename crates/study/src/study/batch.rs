//! Tables as a renderer on the CPU would hold them, evaluated for many directions at once.
//!
//! Both bases run through the same code: all tables of a texel side by side, 32-bit arithmetic, one pass over the
//! texels of a look-up and then the basis. Only the basis values differ.

use half::f16;
use half::slice::HalfFloatSliceExt;
use ndarray::Array3;
use rayon::prelude::*;

use diffraction_brdf::direction::{Vec3, Xyz, dot, v_cavity_shadowing, wave_vector_change};
use diffraction_brdf::evaluate::{Interpolation, lobe_window_power};
use diffraction_brdf::front_factor::FrontFactor;
use diffraction_brdf::material::reflectance;
use diffraction_brdf::storage::{half_scale, round_to_half};
use diffraction_build::optics::config::Material;
use diffraction_build::tables::model::{Basis, Storage, TableSet};

/// A pair of directions, to the light and to the viewer.
pub type Pair = (Vec3, Vec3);

/// A method that answers many pairs of directions at once on the calling thread: XYZ in 1/sr.
pub(crate) type Batch<'a> = &'a (dyn Fn(&[Pair], &mut [Xyz]) + Sync);

/// Most pairs that one thread takes at a time: methods that integrate over a spectrum prepare it once for each.
const CHUNK_MAX: usize = 2048;

/// Evaluates a method on all threads.
pub(crate) fn on_all_threads(batch: Batch, pairs: &[Pair]) -> Vec<Xyz> {
    let mut xyz = vec![[0.0; 3]; pairs.len()];
    let chunk = (pairs.len() / (4 * rayon::current_num_threads())).clamp(8, CHUNK_MAX);
    xyz.par_chunks_mut(chunk).zip(pairs.par_chunks(chunk)).for_each(|(out, pairs)| batch(pairs, out));
    xyz
}

/// Numbers of all tables, `[row][column][table][channel]`.
enum Texels {
    Float(Vec<f32>),
    Half(Vec<f16>),
}

/// A table set in one block of memory.
pub(crate) struct PackedTables {
    basis: Basis,
    size: usize,
    count: usize,
    texels: Texels,
    /// Factor of each table; a power of two for halves, 1 for floats.
    scales: Vec<f32>,
    front_factor: FrontFactor,
    /// The lobe alone, without tables: small, and looked up only near the mirror direction.
    lobe: TableSet,
    lobe_radius2: f64,
}

impl PackedTables {
    /// Packs the first `count` tables of a set in a format.
    pub fn new(set: &TableSet, count: usize, storage: Storage) -> Self {
        let tables = &set.tables[..count];
        let size = set.size();
        let scales: Vec<f32> = match storage {
            Storage::Float => vec![1.0; count],
            Storage::Half => tables.iter().map(|table| half_scale(peak(table))).collect(),
        };
        let number = |index: usize| {
            let (channel, table, texel) = (index % 3, index / 3 % count, index / (3 * count));
            tables[table][[texel / size, texel % size, channel]] / scales[table]
        };
        let numbers = 0..size * size * 3 * count;
        let texels = match storage {
            Storage::Float => Texels::Float(numbers.map(number).collect()),
            Storage::Half => Texels::Half(numbers.map(|index| f16::from_f32(number(index))).collect()),
        };
        let lobe = without_tables(set, storage);
        Self {
            basis: set.basis,
            size,
            count,
            texels,
            scales,
            front_factor: set.front_factor,
            // The cross term's square reaches to its corners.
            lobe_radius2: lobe.lobe.as_ref().map_or(0.0, |lobe| 2.0 * lobe.radius_max.powi(2)),
            lobe,
        }
    }

    /// Bytes a renderer holds: tables and cross term in their format, the coherent lobe in floats.
    pub fn bytes(&self) -> u64 {
        let (width, numbers) = match &self.texels {
            Texels::Float(texels) => (4, texels.len()),
            Texels::Half(texels) => (2, texels.len()),
        };
        let lobe = self.lobe.lobe.as_ref();
        let cross: usize = lobe.iter().flat_map(|lobe| &lobe.cross).map(Array3::len).sum();
        let coherent = lobe.map_or(0, |lobe| lobe.coherent.len());
        ((numbers + cross) * width + coherent * 4) as u64
    }

    /// XYZ of the BRDF in 1/sr for many pairs; zero for directions not above the surface.
    pub fn evaluate(&self, interpolation: Interpolation, pairs: &[Pair], out: &mut [Xyz]) {
        let mut scratch = Scratch::new(self.count, interpolation);
        for (&(wi, wo), xyz) in pairs.iter().zip(out) {
            *xyz = [0.0; 3];
            if !(wi[2] > 0.0 && wo[2] > 0.0) {
                continue;
            }
            let q = wave_vector_change(wi, wo);
            let front = self.front(wi, wo, q);
            let mut sum = self.tables_at(interpolation, q, &mut scratch);
            if q[0] * q[0] + q[1] * q[1] < self.lobe_radius2 {
                let lobe = lobe_window_power(&self.lobe, interpolation, q);
                sum.iter_mut().zip(lobe).for_each(|(sum, lobe)| *sum += lobe);
            }
            *xyz = sum.map(|value| front * value);
        }
    }

    /// As `optics::reference::prefactor` for directions above the surface, without complex numbers where the material
    /// has none.
    fn front(&self, wi: Vec3, wo: Vec3, q: Vec3) -> f64 {
        let q2 = dot(q, q);
        let shadowing = if self.front_factor.shadowing { v_cavity_shadowing(wi, wo) } else { 1.0 };
        let cos = (0.5 * q2.sqrt()).min(1.0);
        let reflectance = match self.front_factor.material {
            Material::Ideal => 1.0,
            Material::Dielectric { n } => {
                let cos_t = (1.0 - (1.0 - cos * cos) / (n * n)).sqrt();
                let [s, p] = [(cos - n * cos_t) / (cos + n * cos_t), (n * cos - cos_t) / (n * cos + cos_t)];
                0.5 * (s * s + p * p)
            }
            material => reflectance(material, cos),
        };
        reflectance * q2 * q2 / (4.0 * wi[2] * wo[2]) * shadowing
    }

    fn tables_at(&self, interpolation: Interpolation, q: Vec3, scratch: &mut Scratch) -> Xyz {
        let last = (self.size - 1) as f32;
        let at = [(2.0 - q[1] as f32) * 0.25 * last, (q[0] as f32 + 2.0) * 0.25 * last];
        let (row, wy) = stencil(interpolation, at[0], self.size);
        let (column, wx) = stencil(interpolation, at[1], self.size);
        let taps = scratch.taps;
        let per_texel = 3 * self.count;
        scratch.sums.fill(0.0);
        for (dy, &wy) in wy.iter().enumerate().take(taps) {
            let start = ((row + dy) * self.size + column) * per_texel;
            let run = start..start + taps * per_texel;
            let values = match &self.texels {
                Texels::Float(texels) => &texels[run],
                Texels::Half(texels) => {
                    texels[run].convert_to_f32_slice(&mut scratch.wide);
                    &scratch.wide[..]
                }
            };
            for (texel, &wx) in values.chunks_exact(per_texel).zip(&wx) {
                let weight = wy * wx;
                scratch.sums.iter_mut().zip(texel).for_each(|(sum, value)| *sum += weight * value);
            }
        }
        self.basis_values(q, &mut scratch.basis);
        let mut xyz = [0.0f32; 3];
        for (sums, basis) in scratch.sums.chunks_exact(3).zip(&scratch.basis) {
            xyz.iter_mut().zip(sums).for_each(|(xyz, sum)| *xyz += basis * sum);
        }
        xyz.map(f64::from)
    }

    /// Values of the basis times each table's scale.
    fn basis_values(&self, q: Vec3, basis: &mut [f32]) {
        let w = q[2].abs();
        match self.basis {
            Basis::Chebyshev => {
                let reach = (4.0 - q[0] * q[0] - q[1] * q[1]).max(0.0).sqrt();
                let x = if reach == 0.0 { -1.0 } else { (2.0 * (w / reach).min(1.0) - 1.0) as f32 };
                let (mut before, mut here) = (x, 1.0);
                for (value, scale) in basis.iter_mut().zip(&self.scales) {
                    *value = here * scale;
                    (before, here) = (here, 2.0 * x * here - before);
                }
            }
            Basis::Taylor => {
                let mut power = (1.0 / (w * w)) as f32;
                for (value, scale) in basis.iter_mut().zip(&self.scales) {
                    *value = power * scale;
                    power *= w as f32;
                }
            }
        }
    }
}

/// Working memory of one thread.
struct Scratch {
    /// Texels of a look-up along one axis.
    taps: usize,
    /// One row of texels as floats.
    wide: Vec<f32>,
    sums: Vec<f32>,
    basis: Vec<f32>,
}

impl Scratch {
    fn new(count: usize, interpolation: Interpolation) -> Self {
        let taps = if interpolation == Interpolation::Bilinear { 2 } else { 4 };
        Self { taps, wide: vec![0.0; taps * 3 * count], sums: vec![0.0; 3 * count], basis: vec![0.0; count] }
    }
}

/// First texel and weights along one axis of at least four texels; Lagrange's cubic where four are wanted.
fn stencil(interpolation: Interpolation, at: f32, size: usize) -> (usize, [f32; 4]) {
    let at = at.clamp(0.0, (size - 1) as f32);
    if interpolation == Interpolation::Bilinear {
        let first = (at as usize).min(size - 2);
        let share = at - first as f32;
        return (first, [1.0 - share, share, 0.0, 0.0]);
    }
    let first = (at as usize).saturating_sub(1).min(size - 4);
    let x = at - first as f32;
    let (a, b, c, d) = (x, x - 1.0, x - 2.0, x - 3.0);
    (first, [-b * c * d / 6.0, a * c * d / 2.0, -a * b * d / 2.0, a * b * c / 6.0])
}

/// Largest magnitude of a table.
fn peak(table: &Array3<f32>) -> f32 {
    table.iter().fold(0.0, |peak, value| peak.max(value.abs()))
}

/// The tables as an atlas gives them back: halves over their scale, the coherent lobe always in floats.
pub fn stored(set: &TableSet, storage: Storage) -> TableSet {
    let mut tables = set.tables.clone();
    if storage == Storage::Half {
        tables.iter_mut().for_each(round_to_half);
    }
    TableSet { tables, ..without_tables(set, storage) }
}

/// A set's lobe alone, its cross term rounded to a format.
fn without_tables(set: &TableSet, storage: Storage) -> TableSet {
    let mut lobe = set.lobe.clone();
    if storage == Storage::Half {
        lobe.iter_mut().flat_map(|lobe| &mut lobe.cross).for_each(round_to_half);
    }
    TableSet {
        basis: set.basis,
        tables: Vec::new(),
        lobe,
        prefilter_width: set.prefilter_width,
        front_factor: set.front_factor,
        restriction: None,
        usable_radius: set.usable_radius,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use diffraction_brdf::evaluate::brdf_xyz;
    use diffraction_brdf::front_factor::Factor;
    use diffraction_build::ground::sampling::{Region, direction_pairs};
    use diffraction_build::tables::model::Lobe;

    fn set(basis: Basis) -> TableSet {
        let number =
            |n: usize| move |(r, c, k): (usize, usize, usize)| ((r * 7 + c * 3 + k + n) % 11) as f32 * 0.1 + 0.2;
        let table = |n: usize| Array3::from_shape_fn((9, 9, 3), number(n));
        TableSet {
            basis,
            tables: (0..4).map(table).collect(),
            lobe: (basis == Basis::Chebyshev).then(|| Lobe {
                coherent: Array3::from_shape_fn((5, 6, 3), number(1)),
                radius_max: 0.4,
                cross: vec![Array3::from_shape_fn((7, 7, 3), number(2))],
            }),
            prefilter_width: 0.0,
            front_factor: FrontFactor {
                material: Material::Dielectric { n: 1.5 },
                shadowing: false,
                factor: Factor::Scalar,
            },
            restriction: None,
            usable_radius: 2.0,
        }
    }

    #[test]
    fn batches_equal_single_evaluations_to_rounding() {
        for basis in [Basis::Chebyshev, Basis::Taylor] {
            for storage in [Storage::Float, Storage::Half] {
                for interpolation in [Interpolation::Bilinear, Interpolation::Cubic] {
                    let (set, pairs) = (set(basis), direction_pairs(Region::Hemisphere, 600));
                    let packed = PackedTables::new(&set, 4, storage);
                    let read = stored(&set, storage);
                    let batch = |pairs: &[Pair], out: &mut [Xyz]| packed.evaluate(interpolation, pairs, out);
                    let found = on_all_threads(&batch, &pairs);
                    for (&(wi, wo), found) in pairs.iter().zip(&found) {
                        let one = brdf_xyz(&read, interpolation, wi, wo)[1];
                        // Positions, weights, and fewer than a hundred products in 24 bits, relative to the sum of
                        // magnitudes: four tables of at most 1.3, over w² in powers of w. A position carries 2^-24 of
                        // 8 texels, over which values change by up to their own size.
                        let w2 = (wi[2] + wo[2]).powi(2).min(1.0);
                        let magnitude = set.front_factor.diffuse(wi, wo) * 4.0 * 1.3 * 4.0 / w2;
                        assert!((found[1] - one).abs() <= 2e-6 * magnitude, "{basis:?} {} {one}", found[1]);
                    }
                    // A single wrong texel shows.
                    let mut wrong = set.clone();
                    wrong.tables[1].mapv_inplace(|value| value * 1.01);
                    let wrong = PackedTables::new(&wrong, 4, storage);
                    let other =
                        on_all_threads(&|p: &[Pair], o: &mut [Xyz]| wrong.evaluate(interpolation, p, o), &pairs);
                    assert!(other.iter().zip(&found).any(|(a, b)| (a[1] / b[1] - 1.0).abs() > 1e-4));
                }
            }
        }
    }

    #[test]
    fn bytes_are_those_of_the_numbers_held() {
        let set = set(Basis::Chebyshev);
        let [float, half] = [Storage::Float, Storage::Half].map(|s| PackedTables::new(&set, 4, s).bytes());
        let (tables, cross, coherent) = (9 * 9 * 3 * 4, 7 * 7 * 3, 5 * 6 * 3);
        assert_eq!(float, ((tables + cross + coherent) * 4) as u64);
        assert_eq!(half, ((tables + cross) * 2 + coherent * 4) as u64);
    }
}
