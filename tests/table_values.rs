//! Tables against an independent evaluator's figures.

mod common;

use diffraction_atlas::tables::build::build;
use diffraction_atlas::tables::evaluate::{Interpolation, brdf_xyz};
use diffraction_atlas::tables::model::{Basis, Prefilter, Storage, TablesConfig};
use diffraction_atlas::ground::direction::wave_vector_change;

#[test]
fn probe() {
    let Some(shared) = common::shared("probe") else { return };
    let size: usize = std::env::var("SIZE").map(|s| s.parse().unwrap()).unwrap_or(1001);
    let only = std::env::var("ONLY").unwrap_or_default();
    for mut case in common::cases(&shared) {
        if !case.name.contains(&only) { continue; }
        let (lo, hi) = case.field.heights_nm.iter().fold((f64::MAX, f64::MIN), |(l, h), &x| (l.min(x), h.max(x)));
        case.field.heights_nm -= 0.5 * (lo + hi);
        let config = TablesConfig { basis: Basis::Chebyshev, tolerance: 1e-3, size: Some(size), count: None, wavelength_step_nm: None, storage: Storage::Float, prefilter: Prefilter::None, memory_mib: 8192 };
        let started = std::time::Instant::now();
        let (set, record) = build(std::slice::from_ref(&case.field), &case.optics, &config, &|_| ()).unwrap();
        println!("{} {} tables, {record:?} {:?}", case.name, set.tables.len(), started.elapsed());
        for interpolation in [Interpolation::Bilinear, Interpolation::Cubic] {
            let mut errors: Vec<f64> = case.rows.iter().filter(|r| r.xyz[1] > 1e-6).filter(|r| { let q = wave_vector_change(r.wi, r.wo); q[0].hypot(q[1]) > set.lobe.as_ref().unwrap().radius_max })
                .map(|r| (brdf_xyz(&set, interpolation, r.wi, r.wo)[1] / r.xyz[1] - 1.0).abs()).collect();
            let mut lobe: Vec<f64> = case.rows.iter().filter(|r| r.xyz[1] > 1e-6).filter(|r| { let q = wave_vector_change(r.wi, r.wo); q[0].hypot(q[1]) <= set.lobe.as_ref().unwrap().radius_max })
                .map(|r| (brdf_xyz(&set, interpolation, r.wi, r.wo)[1] / r.xyz[1] - 1.0).abs()).collect();
            for e in [&mut errors, &mut lobe] {
            e.sort_by(f64::total_cmp);
            let q = |p: f64| e.get(((e.len().max(1) - 1) as f64 * p).ceil() as usize).copied().unwrap_or(f64::NAN);
            println!("  {interpolation:?} n={} p50 {:.2e} p95 {:.2e} p99 {:.2e} worst {:.2e}", e.len(), q(0.5), q(0.95), q(0.99), q(1.0)); }
        }
    }
}
