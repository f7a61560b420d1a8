//! What building tables costs: the transforms, one ring of sums over wavelengths, the whole.

use std::f64::consts::TAU;
use std::hint::black_box;

use criterion::{Criterion, criterion_group, criterion_main};
use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::height::HeightField;
use diffraction_build::height::synthesize::{Structure, synthesize};
use diffraction_build::optics::config::{Edge, Material, OpticsConfig, Windows};
use diffraction_build::optics::spectra;
use diffraction_build::tables::accumulate::{PowerSums, Quantity, RingSum, add_ring};
use diffraction_build::tables::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Basis, Prefilter, Storage, TablesConfig};
use diffraction_build::tables::plan;

/// Nodes in `w`, as snake scales need at the default tolerance.
const NODES: usize = 5;

fn surface() -> HeightField {
    synthesize(&Structure::CornSnake { seed: 1 }, [256, 256], [62.5, 62.5]).expect("the structure fits the tile")
}

fn optics(edge: Edge, windows: Windows) -> OpticsConfig {
    // The 16 µm tile holds 8 sigma.
    OpticsConfig {
        material: Material::Dielectric { n: 1.56 },
        ..OpticsConfig::ideal(Illuminant::D65, 2_000.0, edge, windows)
    }
}

fn config() -> TablesConfig {
    TablesConfig {
        basis: Basis::Chebyshev,
        tolerance: 1e-3,
        size: Some(251),
        count: Some(NODES),
        wavelength_step_nm: None,
        storage: Some(Storage::Half),
        prefilter: Prefilter::Auto,
        memory_mib: 2048,
    }
}

/// The two ways of summing: powers (the mean over all window positions), and amplitudes of one window.
fn cases() -> [(&'static str, OpticsConfig); 2] {
    [("tile mean", optics(Edge::Tile, Windows::Grid)), ("fade centre", optics(Edge::Fade, Windows::Centre))]
}

fn transforms(criterion: &mut Criterion) {
    let field = surface();
    let mut group = criterion.benchmark_group("transforms of 256²");
    for (name, optics) in cases() {
        let plan =
            plan::plan(&BuildInput::new(std::slice::from_ref(&field), &optics, &config())).expect("the build fits");
        let (_, placement) = plan.windows[0];
        group.bench_function(name, |bencher| {
            bencher.iter(|| spectra::transform(black_box(&field), placement, &optics, &plan.spectra));
        });
    }
    group.finish();
}

fn one_ring(criterion: &mut Criterion) {
    let field = surface();
    let mut group = criterion.benchmark_group("outermost ring of 251²");
    for (name, optics) in cases() {
        let plan =
            plan::plan(&BuildInput::new(std::slice::from_ref(&field), &optics, &config())).expect("the build fits");
        let (_, placement) = plan.windows[0];
        let spectra = spectra::transform(&field, placement, &optics, &plan.spectra).expect("the transforms fit");
        let ring = &plan.rings[0];
        let nodes = diffraction_brdf::chebyshev::gauss_nodes(NODES, ring.abs_w[0], ring.abs_w[1]);
        let mut sums = PowerSums::new(&plan.texels, 3, NODES);
        let what = RingSum { texels: &plan.texels, ring, filter: plan.filter, quantity: Quantity::Power, share: 1.0 };
        group.bench_function(name, |bencher| {
            bencher.iter(|| add_ring(black_box(&spectra), what, &nodes, &mut sums));
        });
    }
    group.finish();
}

fn whole_build(criterion: &mut Criterion) {
    let field = surface();
    let mut group = criterion.benchmark_group("whole build, 251²");
    for (name, optics) in cases() {
        group.bench_function(name, |bencher| {
            bencher.iter(|| {
                build::build(&BuildInput::new(std::slice::from_ref(black_box(&field)), &optics, &config()), &|_| ())
            });
        });
    }
    group.finish();
}

fn w_nodes(criterion: &mut Criterion) {
    use diffraction_brdf::chebyshev::nodes_for_exponential;
    criterion.bench_function("number of nodes in |w|, 1 µm", |bencher| {
        bencher.iter(|| nodes_for_exponential(black_box(500.0), 2.0 * TAU / 380.0, 1e-6));
    });
}

criterion_group! {
    name = benches;
    config = Criterion::default().sample_size(10);
    targets = transforms, one_ring, whole_build, w_nodes
}
criterion_main!(benches);
