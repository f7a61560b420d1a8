//! What one pair of directions costs: from tables, straight from the transforms, and by the direct sum.

use std::hint::black_box;

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use diffraction_brdf::direction::{Vec3, normalise};
use diffraction_brdf::evaluate::{Interpolation, brdf_xyz};
use diffraction_brdf::spectrum::Illuminant;
use diffraction_brdf::{Brdf, Factor, Footprint};
use diffraction_build::ground::sampling::{Region, direction_pairs};
use diffraction_build::height::HeightField;
use diffraction_build::height::synthesize::{Structure, synthesize};
use diffraction_build::optics::config::{Edge, Material, OpticsConfig, Windows};
use diffraction_build::optics::reference;
use diffraction_build::optics::spectra;
use diffraction_build::optics::spectral;
use diffraction_build::tables::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Basis, Prefilter, Storage, TablesConfig};
use diffraction_build::tables::plan;

/// Pairs per measurement of the fast methods: enough that look-ups do not stay in one cache line.
const PAIRS: usize = 1024;

/// Pairs per measurement of the slow ones.
const FEW_PAIRS: usize = 8;

fn surface() -> HeightField {
    synthesize(&Structure::CornSnake { seed: 1 }, [256, 256], [62.5, 62.5]).expect("the structure fits the tile")
}

fn optics() -> OpticsConfig {
    OpticsConfig {
        material: Material::Dielectric { n: 1.56 },
        ..OpticsConfig::ideal(Illuminant::D65, 2_000.0, Edge::Fade, Windows::Centre)
    }
}

fn config() -> TablesConfig {
    TablesConfig {
        basis: Basis::Chebyshev,
        tolerance: 1e-3,
        size: Some(251),
        count: None,
        wavelength_step_nm: None,
        storage: Some(Storage::Float),
        prefilter: Prefilter::None,
        memory_mib: 2048,
    }
}

fn from_tables(criterion: &mut Criterion) {
    let field = surface();
    let (set, _) = build::build(&BuildInput::new(&[field], &optics(), &config()), &|_| ()).expect("the build fits");
    let mut group = criterion.benchmark_group("from tables");
    for region in [Region::Hemisphere, Region::NearSpecular] {
        let pairs: Vec<(Vec3, Vec3)> = direction_pairs(region, PAIRS);
        group.throughput(Throughput::Elements(pairs.len() as u64));
        for (name, interpolation) in [("bilinear", Interpolation::Bilinear), ("cubic", Interpolation::Cubic)] {
            group.bench_function(format!("{name}, {}", region.name()), |bencher| {
                bencher.iter(|| {
                    let values = pairs.iter().map(|&(wi, wo)| brdf_xyz(black_box(&set), interpolation, wi, wo)[1]);
                    values.sum::<f64>()
                });
            });
        }
    }
    group.finish();
}

/// The sun, 0.53 degrees across: a point in its middle, one filtered look-up, and means over samples of its disc.
fn light_with_a_size(criterion: &mut Criterion) {
    let set = build::build(&BuildInput::new(&[surface()], &optics(), &config()), &|_| ()).expect("the build fits").0;
    let brdf = Brdf::new(set).expect("built tables can be evaluated");
    let mut group = criterion.benchmark_group("the sun");
    for region in [Region::Hemisphere, Region::NearSpecular] {
        let pairs: Vec<(Vec3, Vec3)> = direction_pairs(region, PAIRS);
        group.throughput(Throughput::Elements(pairs.len() as u64));
        group.bench_function(format!("point, {}", region.name()), |bencher| {
            bencher.iter(|| pairs.iter().map(|&(wi, wo)| black_box(&brdf).eval(wi, wo)[1]).sum::<f64>());
        });
        group.bench_function(format!("filtered, {}", region.name()), |bencher| {
            bencher.iter(|| {
                let value = |&(wi, wo): &(Vec3, Vec3)| {
                    let sun = Footprint::of_light(wi, 0.53).expect("a diameter");
                    black_box(&brdf).eval_filtered(wi, wo, sun)[1]
                };
                pairs.iter().map(value).sum::<f64>()
            });
        });
        for count in [16, 64, 256] {
            group.bench_function(format!("{count} samples, {}", region.name()), |bencher| {
                bencher.iter(|| {
                    let value = |&(wi, wo): &(Vec3, Vec3)| {
                        (0..count).map(|n| black_box(&brdf).eval(nearby(wi, n, count), wo)[1]).sum::<f64>()
                    };
                    pairs.iter().map(value).sum::<f64>()
                });
            });
        }
    }
    group.finish();
}

/// One of so many directions spread over the sun's disc, to within what its time depends on.
fn nearby(wi: Vec3, n: usize, count: usize) -> Vec3 {
    let shift = 0.0046 * ((n as f64 + 0.5) / count as f64).sqrt();
    let (sin, cos) = (2.399_963 * n as f64).sin_cos();
    normalise([wi[0] + shift * cos, wi[1] + shift * sin, wi[2]])
}

/// What the vector factor adds to a look-up: the same tables read with either factor, and both factors alone.
fn front_factors(criterion: &mut Criterion) {
    let set = build::build(&BuildInput::new(&[surface()], &optics(), &config()), &|_| ()).expect("the build fits").0;
    for (material_name, material) in
        [("keratin", Material::Dielectric { n: 1.56 }), ("aluminium", Material::Conductor { n: 0.96, k: 6.7 })]
    {
        let mut group = criterion.benchmark_group(format!("front factor, {material_name}"));
        for region in [Region::Hemisphere, Region::NearSpecular] {
            let pairs: Vec<(Vec3, Vec3)> = direction_pairs(region, PAIRS);
            group.throughput(Throughput::Elements(pairs.len() as u64));
            for (name, factor) in [("scalar", Factor::Scalar), ("vector", Factor::Vector)] {
                let mut set = set.clone();
                (set.front_factor.material, set.front_factor.factor) = (material, factor);
                for (look_up, interpolation) in [("bilinear", Interpolation::Bilinear), ("cubic", Interpolation::Cubic)]
                {
                    group.bench_function(format!("{name}, {look_up}, {}", region.name()), |bencher| {
                        bencher.iter(|| {
                            let value = |&(wi, wo): &(Vec3, Vec3)| brdf_xyz(black_box(&set), interpolation, wi, wo)[1];
                            pairs.iter().map(value).sum::<f64>()
                        });
                    });
                }
                let front = set.front_factor;
                group.bench_function(format!("{name} alone, {}", region.name()), |bencher| {
                    bencher.iter(|| {
                        let value = |&(wi, wo): &(Vec3, Vec3)| {
                            black_box(front).diffuse(wi, wo) + black_box(front).coherent(wi, wo)
                        };
                        pairs.iter().map(value).sum::<f64>()
                    });
                });
            }
        }
        group.finish();
    }
}

fn from_the_scan(criterion: &mut Criterion) {
    let field = surface();
    let (optics, config) = (optics(), config());
    let plan = plan::plan(&BuildInput::new(std::slice::from_ref(&field), &optics, &config)).expect("the build fits");
    let (_, placement) = plan.windows[0];
    let transformed = spectra::transform(&field, placement, &optics, &plan.spectra).expect("the transforms fit");
    let pairs = direction_pairs(Region::Hemisphere, FEW_PAIRS);
    let mut group = criterion.benchmark_group("from the scan");
    group.sample_size(10).throughput(Throughput::Elements(pairs.len() as u64));
    group.bench_function("transforms", |bencher| {
        bencher.iter(|| {
            let mut sums = vec![[0.0; 3]; pairs.len()];
            spectral::add_window(black_box(&transformed), &optics, &pairs, reference::FULL_STEP, &mut sums)
                .expect("D65 is visible");
            sums
        });
    });
    group.bench_function("direct sum", |bencher| {
        bencher.iter(|| reference::brdf_xyz_batch(std::slice::from_ref(black_box(&field)), &optics, &pairs));
    });
    group.finish();
}

criterion_group!(benches, from_tables, front_factors, light_with_a_size, from_the_scan);
criterion_main!(benches);
