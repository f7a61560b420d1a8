//! Stability in storage and in the order of sums.

use super::case::StabilityCase;
use super::support::{case, config, on_texels, optics, pair_of, refused, relief, tables};
use crate::study::stored;
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_build::tables::model::{Basis, Storage, TableSet};

/// Threads of the second build, and parts of the sum that has no fixed order.
const THREADS: usize = 3;

pub fn cases() -> Vec<StabilityCase> {
    vec![threads(), halves()]
}

/// The same bits on one thread and on three. Guard: every sum has one order; split among three threads, the same
/// numbers add to another.
fn threads() -> StabilityCase {
    let field = relief([32, 32], [125.0; 2], 300.0);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().ok()?;
        pool.install(|| tables(&field, &optics(800.0), &config(Basis::Chebyshev)).ok())
    };
    let (Some(one), Some(three)) = (on(1), on(THREADS)) else {
        return refused("one thread and three");
    };
    let values = |set: &TableSet| -> Vec<f32> {
        let lobe = set.lobe.iter().flat_map(|lobe| lobe.coherent.iter());
        set.tables.iter().flat_map(|table| table.iter()).chain(lobe).copied().collect()
    };
    let (one, three) = (values(&one), values(&three));
    let different = one.iter().zip(&three).filter(|(a, b)| a.to_bits() != b.to_bits()).count();
    // Sums of 64 neighbouring numbers each, in sequence and as partial sums of every third.
    let reordered = one.chunks_exact(64).filter(|part| {
        let sequence: f32 = part.iter().sum();
        let split: f32 = (0..THREADS).map(|first| part.iter().skip(first).step_by(THREADS).sum::<f32>()).sum();
        sequence.to_bits() != split.to_bits()
    });
    case("one thread and three", "values whose bits differ", different as f64, 0.0)
        .guarded("sums in a fixed order", reordered.count() as f64)
}

/// Half floats: 11 bits round each table by 2^-11 at most; coefficients do not cancel, so three times that is
/// ample. Guard: each table is divided by its scale first, and the mirror's lobe stays in floats. Without it a deep
/// lobe overflows: 65504 is the end.
fn halves() -> StabilityCase {
    let field = relief([64, 64], [125.0; 2], 30.0);
    let Ok(set) = tables(&field, &optics(65_000.0), &config(Basis::Chebyshev)) else {
        return refused("half storage");
    };
    let halves = stored(&set, Storage::Half);
    let pairs: Vec<_> =
        on_texels(&set, [0.05, 1.0]).into_iter().chain([2.0, 1.0, 0.3].map(|w| pair_of(0.0, 0.0, w))).collect();
    let y = |set: &TableSet| -> Vec<f64> {
        pairs.iter().map(|&(wi, wo)| brdf_xyz(set, Interpolation::Cubic, wi, wo)[1]).collect()
    };
    let mut plain = set.clone();
    let lobe = plain.lobe.iter_mut().map(|lobe| &mut lobe.coherent);
    plain.tables.iter_mut().chain(lobe).for_each(|t| t.mapv_inplace(|v| half::f16::from_f32(v).to_f32()));
    let exact = y(&set);
    let mean = exact.iter().sum::<f64>() / exact.len() as f64;
    let worst = |found: Vec<f64>| {
        let floor = 1e-9 * mean;
        let off = exact.iter().zip(found).filter(|(e, _)| **e > floor).map(|(e, f)| (f / e - 1.0).abs());
        off.fold(0.0, |worst: f64, e| if e.is_nan() { f64::INFINITY } else { worst.max(e) })
    };
    let note = "worst rounding of Y, values down to 1e-9 of the mean";
    case("half storage", note, worst(y(&halves)), 3.0 * 2f64.powi(-11))
        .guarded("a scale for each table", worst(y(&plain)))
}
