//! Stability in shape and sampling: steps, spikes, noise, odd scans and pitches, heights that are none.

use std::f64::consts::TAU;

use ndarray::Array2;

use super::case::StabilityCase;
use super::support::{
    BOUND, Comparison, HALF_AS_MANY, TakenOut, case, compared, config, laser, on_row, optics, pair_of, refused, relief,
    scaled, tables,
};
use diffraction_brdf::direction::{from_angles_deg, wave_vector_change};
use diffraction_brdf::evaluate::{Interpolation, window_power};
use diffraction_build::height::HeightField;
use diffraction_build::optics::kernel::Kernel;
use diffraction_build::optics::reference;
use diffraction_build::optics::spectra::half_height_range_nm;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Basis, TableSet, TablesConfig};
use diffraction_build::tables::plan::grid;
use diffraction_build::tables::resolution::lobe_width;

pub fn cases() -> Vec<StabilityCase> {
    let single =
        vec![between_samples(), zeros(), not_numbers(), flat(), line(), nyquist(), smallest_table(), smallest_scan()];
    [surfaces(), pitches(), unusable(), single].concat()
}

/// Any scan obeys the same sums: no bound but the tolerance. Guards: what tells the scan from its neighbours.
fn surfaces() -> Vec<StabilityCase> {
    let at = |depth: f64, h: &dyn Fn(usize, usize) -> f64| {
        scaled(Array2::from_shape_fn((32, 32), |(row, column)| h(column, row)), [125.0; 2], depth)
    };
    let hash = |x: usize, y: usize| ((x * 7_919 + y * 104_729 + x * y * 31) % 1_009) as f64;
    let (light, settings) = (optics(800.0), config(Basis::Chebyshev));
    let tried = |name: &str, field: &HeightField, taken_out: TakenOut| compared(name, field, &light, taken_out);

    let step = at(300.0, &|x, _| f64::from(u8::from(x > 20)));
    let fewer = TakenOut { what: HALF_AS_MANY, without: &|found| found.half_as_many() };
    let ramp = at(2_000.0, &|x, y| (x + 2 * y) as f64);
    // Light leaves towards where the slope leans.
    let sign = TakenOut { what: "the sign of (u, v)", without: &|found| found.misread(&|[u, v, w]| [-u, -v, w]) };
    let noise = at(300.0, &hash);
    let rows = TakenOut {
        what: "rows that go down where y goes up",
        without: &|found| found.misread(&|[u, v, w]| [u, -v, w]),
    };
    let board = at(200.0, &|x, y| 900.0 * ((x + y) % 2) as f64 + hash(x, y));
    let second = Array2::from_shape_fn((16, 16), |(row, column)| board.heights_nm[[2 * row, 2 * column]]);
    let second = HeightField { heights_nm: second, pitch_nm: [250.0; 2] };
    let every_sample = TakenOut {
        what: "every sample; every second one, where squares of one colour are left",
        without: &|found| found.other(&second, &light, &settings),
    };
    let oblong = relief([160, 12], [10.0, 200.0], 100.0);
    let square = HeightField { pitch_nm: [(10.0f64 * 200.0).sqrt(); 2], ..oblong.clone() };
    let each_axis = TakenOut {
        what: "a pitch for each axis; square pixels as large",
        without: &|found| found.other(&square, &light, &settings),
    };
    // The nodes follow from peak to valley; counted from the rms height of 310 nm they are too few.
    let spike = at(10_000.0, &|x, y| f64::from(u8::from(x == 20 && y == 9)));
    let whole_range =
        TakenOut { what: "tables for the whole range; for the rms height", without: &|found| found.with_tables(6) };
    vec![
        tried("step of 300 nm", &step, fewer),
        tried("ramp of 2 um with its seam", &ramp, sign),
        tried("white noise", &noise, rows),
        tried("checkerboard at Nyquist, with noise", &board, every_sample),
        tried("pixels of 1 : 20", &oblong, each_axis),
        compared("spike of 10 um in one sample", &spike, &laser(532.0, 800.0), whole_range),
    ]
}

/// What a pitch taken for one per cent more is named.
const PITCH: &str = "the pitch as it is; one per cent more";

fn stretched(field: &HeightField) -> HeightField {
    HeightField { pitch_nm: field.pitch_nm.map(|pitch| 1.01 * pitch), ..field.clone() }
}

/// From 1 nm to 1 µm between samples. Guard: frequencies follow the pitch, to better than a part in a hundred.
fn pitches() -> Vec<StabilityCase> {
    let pitched = |name: &str, field: &HeightField, optics| {
        let other = stretched(field);
        let without = |found: &Comparison| found.other(&other, &found.optics, &config(Basis::Chebyshev));
        compared(name, field, optics, TakenOut { what: PITCH, without: &without })
    };
    let row = relief([4_096, 1], [1.0, 4_096.0], 100.0);
    let light = optics(ROW_SIGMA_NM);
    vec![
        on_one_row("pitch 1 nm", &row, PITCH, &|found| {
            found.other(&stretched(&row), &light, &config(Basis::Chebyshev))
        }),
        pitched("pitch 10 nm", &relief([100, 100], [10.0, 10.0], 50.0), &optics(800.0)),
        // The sampling answers up to |(u, v)| = 0.35 at this wavelength: one ring of the table's texels.
        pitched("pitch 1 um", &relief([32, 32], [1_000.0, 1_000.0], 200.0), &laser(700.0, 8_000.0)),
    ]
}

/// A field with one sample replaced.
fn with(value: f64) -> HeightField {
    let mut field = relief([16, 16], [125.0; 2], 200.0);
    field.heights_nm[[3, 5]] = value;
    field
}

/// Heights that would need more nodes than any machine holds are refused, in no time. Guard: the refusal; without it
/// the phase range alone, half of which is the fewest nodes, asks for the memory given.
fn unusable() -> Vec<StabilityCase> {
    let mut cases = Vec::new();
    for (name, value) in [("1e30 nm", 1e30), ("-1e300 nm", -1e300), ("1 m", 1e9)] {
        for basis in [Basis::Chebyshev, Basis::Taylor] {
            let field = with(value);
            let config = config(basis);
            let accepted = tables(&field, &optics(600.0), &config).is_ok();
            // Lines of the tile of 2 µm within 2/λ, times the nodes, times a complex float.
            let nodes = 0.5 * half_height_range_nm(&field) * 2.0 * TAU / 380.0;
            let share = nodes * 16.0 * 16.0 * 8.0 / ((config.memory_mib as f64) * (1 << 20) as f64);
            let note = "memory taken over memory allowed: none where it is refused";
            cases.push(
                case(&format!("a height of {name}, {basis:?}"), note, if accepted { share } else { 0.0 }, 1.0)
                    .guarded("refusal", share),
            );
        }
    }
    cases
}

/// A window that falls between samples: its lobe, `λ/(2√2 πσ)` wide, covers a hundred times what the sampling answers for,
/// `λ/2` over the pitch. Guard: the refusal.
fn between_samples() -> StabilityCase {
    let (pitch_nm, sigma_nm) = (1e6, 2_000.0);
    let accepted = tables(&relief([32, 32], [pitch_nm; 2], 200.0), &laser(532.0, sigma_nm), &config(Basis::Chebyshev));
    let share = lobe_width(sigma_nm, 532.0) / (0.5 * 532.0 / pitch_nm);
    let note = "lobe's width over the radius that the sampling answers for: none where it is refused";
    let measured = if accepted.is_ok() { share } else { 0.0 };
    case("pitch 1 mm, window of 2 um", note, measured, 1.0).guarded("refusal", share)
}

/// Negative zero and denormals are heights like any other, to the last bit zero. Guard: missing samples are marked apart;
/// a height that stands for "missing" would have them filled from their neighbours.
fn zeros() -> StabilityCase {
    let name = "-0 and denormal heights";
    let (minus, tiny) = ([3, 5], [4, 5]);
    let mut plain = relief([32, 32], [125.0; 2], 200.0);
    let with = |heights: [f64; 2], plain: &HeightField| {
        let mut field = plain.clone();
        [minus, tiny].into_iter().zip(heights).for_each(|(at, height)| field.heights_nm[at] = height);
        field
    };
    let mean =
        |[row, column]: [usize; 2]| 0.5 * (plain.heights_nm[[row, column - 1]] + plain.heights_nm[[row, column + 1]]);
    let filled = with([mean(minus), mean(tiny)], &plain);
    plain = with([0.0; 2], &plain);
    let odd = with([-0.0, f64::MIN_POSITIVE * 0.5], &plain);
    let built = |field: &HeightField| tables(field, &optics(800.0), &config(Basis::Chebyshev));
    let (Ok(plain), Ok(odd), Ok(filled)) = (built(&plain), built(&odd), built(&filled)) else { return refused(name) };
    let different = |other: &TableSet| {
        let pairs = plain.tables.iter().flatten().zip(other.tables.iter().flatten());
        pairs.filter(|(a, b)| a.to_bits() != b.to_bits()).count() as f64
    };
    case(name, "values of the tables whose bits differ from those of zeros", different(&odd), 0.0)
        .guarded("zero is a height; taken for a missing sample", different(&filled))
}

/// Heights that are no numbers are refused. Guard: the refusal; a single one makes every sum no number.
fn not_numbers() -> StabilityCase {
    let values = [f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    let accepted = values
        .into_iter()
        .flat_map(|value| [Basis::Chebyshev, Basis::Taylor].map(|basis| (value, basis)))
        .filter(|&(value, basis)| tables(&with(value), &optics(600.0), &config(basis)).is_ok())
        .count();
    let pair = (from_angles_deg(20.0, 0.0), from_angles_deg(40.0, 90.0));
    let summed = values.into_iter().filter(|&value| {
        let sum = reference::brdf_xyz(&[with(value)], &optics(600.0), pair.0, pair.1);
        sum.is_ok_and(|xyz| xyz[1].is_nan())
    });
    case("heights of NaN and infinity", "scans accepted, of both bases", accepted as f64, 0.0)
        .guarded("refusal; sums that are no number", summed.count() as f64)
}

/// A flat surface: nothing outside the lobe, to the last bit, and the mirror's peak `4πσ²/λ²` in it. Guard: the mean
/// phasor is taken out before transforming; in the tables its lobe is a pole.
fn flat() -> StabilityCase {
    let name = "a constant line of 1 x N samples";
    let field = HeightField { heights_nm: Array2::zeros((16, 1)), pitch_nm: [125.0, 400.0] };
    let Ok(set) = tables(&field, &optics(800.0), &config(Basis::Chebyshev)) else { return refused(name) };
    let diffuse: f32 = set.tables.iter().flat_map(|t| t.iter()).map(|v| v.abs()).sum();
    let mirror = Comparison::new(&set, &field, &optics(800.0), [2.0, 1.5, 1.0].map(|w| pair_of(0.0, 0.0, w)).to_vec());
    let note = "diffuse part (exactly 0) and error of the lobe's peak";
    case(name, note, f64::from(diffuse) + mirror.error(), BOUND)
        .guarded("the mean phasor apart; polynomials through its lobe", mirror.whole(0))
}

/// Standard deviation in nm of the window of the cases with one row of samples.
const ROW_SIGMA_NM: f64 = 1_500.0;

/// One row of samples: light on one row of texels alone. Guard: a single sample has no structure along its axis but the
/// line at zero; transformed like others it repeats that line at every multiple of `1/pitch`.
fn line() -> StabilityCase {
    let field = relief([64, 1], [60.0, 8_000.0], 150.0);
    let kernel = Kernel::GaussianPower { sigma_nm: ROW_SIGMA_NM };
    let at = |line: i32| kernel.value(f64::from(line) / field.pitch_nm[1], 1.0, 0.0);
    let repeated = (-8..=8).map(at).sum::<f64>() / at(0);
    on_one_row("a relief of N x 1 samples", &field, "one line along an axis of one sample; its aliases", &|found| {
        found.error_of(&|wi, wo| {
            let power = window_power(found.set, Interpolation::Cubic, wave_vector_change(wi, wo))[1];
            found.set.front_factor.diffuse(wi, wo) * power * repeated
        })
    })
}

fn on_one_row(name: &str, field: &HeightField, guard: &str, without: &dyn Fn(&Comparison) -> f64) -> StabilityCase {
    let Ok(set) = tables(field, &optics(ROW_SIGMA_NM), &config(Basis::Chebyshev)) else { return refused(name) };
    let found = Comparison::new(&set, field, &optics(ROW_SIGMA_NM), on_row(&set, [0.1, 1.0]));
    let note = "95 % error of Y on the row of texels that has light";
    case(name, note, found.error(), BOUND).guarded(guard, without(&found))
}

/// Beyond the frequencies that the sampling holds there is no light, exactly. Guard: lines past that limit are left
/// out; a sum over the samples repeats there what lies below it.
fn nyquist() -> StabilityCase {
    let field = relief([32, 32], [600.0; 2], 200.0);
    let optics = laser(532.0, 4_000.0);
    let Ok(set) = tables(&field, &optics, &config(Basis::Chebyshev)) else {
        return refused("beyond the sampling's limit");
    };
    // The limit lies at |u| = 0.5 · 532 / 600 = 0.44; the lobes are 0.02 wide.
    let directions = [0.6, 0.7, 0.8].map(|u| pair_of(u, 0.2, 1.5));
    let light = |&(wi, wo): &(_, _)| window_power(&set, Interpolation::Bilinear, wave_vector_change(wi, wo))[1];
    let beyond: f64 = directions.iter().map(light).sum();
    let alias = [0.6, 0.7, 0.8].map(|u: f64| u - 532.0 / 600.0).map(|u| pair_of(u, 0.2, 1.5));
    case("beyond the sampling's limit", "sum of the tables' values, exactly 0", beyond, 0.0)
        .guarded("no lines past the limit; their aliases", alias.iter().map(light).sum())
}

/// The smallest table: its corners lie beyond the rim. Guard: the reach of `|w|` ends at 0 there; the root of what is
/// negative is no number.
fn smallest_table() -> StabilityCase {
    let name = "a table of 3 x 3 texels";
    let config = TablesConfig { size: Some(3), ..config(Basis::Chebyshev) };
    let Ok(set) = tables(&relief([32, 32], [125.0; 2], 200.0), &optics(800.0), &config) else { return refused(name) };
    let texels = set.tables.iter().flat_map(|table| table.lanes(ndarray::Axis(2)).into_iter().collect::<Vec<_>>());
    let not_finite = texels.filter(|xyz| xyz.iter().any(|value| !value.is_finite())).count();
    let grid = grid(&BuildInput::new(&[], &optics(800.0), &config));
    let reaches = (0..9).map(|index| (4.0 - grid.u(index % 3).powi(2) - grid.v(index / 3).powi(2)).sqrt());
    case(name, "texels that are no number", not_finite as f64, 0.0)
        .guarded("the reach of w ends at 0", reaches.filter(|reach| reach.is_nan()).count() as f64)
}

/// The smallest scan. Two samples have all their structure in the line at the sampling's very limit, which cannot tell
/// left from right: the tables leave it out. Guard: that; summed all the same it shows in its direction.
fn smallest_scan() -> StabilityCase {
    let name = "a scan of 2 x 2 samples";
    let field = relief([2, 2], [300.0; 2], 200.0);
    let light = laser(532.0, 800.0);
    let Ok(set) = tables(&field, &light, &config(Basis::Chebyshev)) else { return refused(name) };
    let sum = set.tables.iter().flatten().map(|value| f64::from(value.abs())).sum::<f64>();
    let (wi, wo) = pair_of(0.5 * 532.0 / 300.0, 0.0, 1.5);
    let ambiguous = reference::brdf_xyz(&[field], &light, wi, wo).map_or(0.0, |xyz| xyz[1]);
    // What is left is the rounding of phasors: (2^-52)² of the lobe's peak, 30, over w² from 1e-4 on, 1323 values each.
    case(name, "sum of the tables' values: rounding", sum, 1e-20)
        .guarded("no line at the very limit; Y of the direct sum there", ambiguous)
}
