//! Spectral tables on the GPU against the CPU, value by value, within the derived bound.

use std::sync::OnceLock;

use diffraction_brdf::evaluate::Interpolation;
use diffraction_brdf::front_factor::{Factor, FrontFactor};
use diffraction_brdf::shader_spectral::{SpectralImage, spectral_image};
use diffraction_brdf::{Dispersion, SpectralTables};
use diffraction_build::ground::sampling::{Region, direction_pairs};
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, Material, OpticsConfig, Windows};
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::spectral::{SpectralInput, build_spectral};
use diffraction_render::render::gpu::Gpu;
use diffraction_render::render::gpu_bound_spectral::SpectralBound;
use diffraction_render::render::gpu_spectral::{SpectralQuery, eval_spectral, upload_spectral};

use crate::sets::gpu;
use crate::surfaces::{quantile, random, sampled, tables_config};

const PAIRS: usize = 2_000;

fn rough() -> HeightField {
    random([101, 120], [170.0, 150.0], 380.0, 70.0, 7)
}

/// Eight periods of 2.1 µm, 150 nm deep, with a weak second harmonic.
fn grating() -> HeightField {
    sampled([112, 96], [150.0, 150.0], |x, _| {
        let phase = std::f64::consts::TAU * x / 2_100.0;
        75.0 * phase.sin() + 12.0 * (2.0 * phase).cos()
    })
}

fn build_tables(field: HeightField, edge: Edge, windows: Windows, front: FrontFactor, size: usize) -> SpectralTables {
    let optics = OpticsConfig {
        material: front.material,
        shadowing: front.shadowing,
        factor: front.factor,
        ..OpticsConfig::ideal(diffraction_brdf::spectrum::Illuminant::D65, 1_500.0, edge, windows)
    };
    let config = tables_config(1e-2, Some(size));
    let spectral = SpectralInput::new(&optics, &config);
    let fields = [field];
    let input = BuildInput::new(&fields, &optics, &config);
    let built = build_spectral(&input, &spectral, &|_| ()).expect("the tables build");
    built.tables
}

const DIELECTRIC: FrontFactor =
    FrontFactor { material: Material::Dielectric { n: 1.56 }, shadowing: false, factor: Factor::Vector };
const METAL: FrontFactor =
    FrontFactor { material: Material::Conductor { n: 0.9, k: 6.2 }, shadowing: true, factor: Factor::Scalar };

/// Rough tables with everything: lobe, cross term, a metal with a dispersion.
fn full() -> &'static SpectralTables {
    static TABLES: OnceLock<SpectralTables> = OnceLock::new();
    TABLES.get_or_init(|| {
        let front = FrontFactor { factor: Factor::Vector, ..METAL };
        let tables = build_tables(rough(), Edge::Fade, Windows::Centre, front, 101);
        assert!(tables.lobe.as_ref().is_some_and(|lobe| lobe.cross.is_some()));
        SpectralTables { dispersion: Dispersion::metal("gold"), ..tables }
    })
}

/// Pairs over the hemisphere, near the mirror direction and at grazing angles, each at a wavelength of its own.
fn queries(tables: &SpectralTables) -> Vec<SpectralQuery> {
    let each = PAIRS.div_ceil(Region::ALL.len());
    let pairs = Region::ALL.into_iter().flat_map(|region| direction_pairs(region, each));
    let query = |(index, (wi, wo)): (usize, ([f64; 3], [f64; 3]))| {
        let nm = (380.0 + 400.0 * (index as f64 * 0.618_034).fract()) as f32;
        let own = tables.dispersion.as_ref().map(|dispersion| dispersion.index_at(f64::from(nm)).unwrap());
        SpectralQuery {
            wi: wi.map(|c| c as f32),
            wavelength_nm: nm,
            wo: wo.map(|c| c as f32),
            own_index: u32::from(own.is_some()),
            index: own.unwrap_or_default().map(|c| c as f32),
            unused: [0; 2],
        }
    };
    pairs.enumerate().map(query).collect()
}

/// Comparison of all queries.
struct Comparison {
    /// Differences as shares of what is allowed.
    shares: Vec<f64>,
    /// Relative differences, and relative bounds, of what is no darker than a tenth of the median, nor than 1e-4 of the brightest
    /// twentieth: the dark between a grating's orders is below what halves hold.
    relative: Vec<f64>,
    bounds: Vec<f64>,
}

impl Comparison {
    /// Share of the queries that are farther off than is allowed.
    fn beyond(&self) -> f64 {
        self.shares.iter().filter(|share| **share > 1.0).count() as f64 / self.shares.len() as f64
    }

    fn worst(&self) -> f64 {
        self.shares.iter().fold(0.0, |worst: f64, share| worst.max(*share))
    }
}

fn compare(gpu: &Gpu, tables: &SpectralTables, image: &SpectralImage) -> Comparison {
    let queries = queries(tables);
    assert!(queries.len() >= PAIRS);
    let found = eval_spectral(gpu, &upload_spectral(gpu, image).unwrap(), &queries).unwrap();
    let bound = SpectralBound::new(tables);
    let rows = queries.iter().zip(found).map(|(query, found)| {
        let [wi, wo] = [query.wi, query.wo].map(|v| v.map(f64::from));
        let nm = f64::from(query.wavelength_nm);
        (tables.eval(Interpolation::Bilinear, wi, wo, &[nm])[0], f64::from(found), bound.at(wi, wo, nm))
    });
    let rows: Vec<(f64, f64, f64)> = rows.collect();
    // What is no number exceeds whatever is allowed.
    let share = |&(exact, found, allowed): &(f64, f64, f64)| {
        let share = (found - exact).abs() / allowed;
        if share.is_nan() { f64::MAX } else { share }
    };
    let exact: Vec<f64> = rows.iter().map(|row| row.0).collect();
    let floor = (0.1 * quantile(&exact, 0.5)).max(1e-4 * quantile(&exact, 0.95));
    let lit: Vec<&(f64, f64, f64)> = rows.iter().filter(|row| row.0 > floor).collect();
    Comparison {
        shares: rows.iter().map(share).collect(),
        relative: lit.iter().map(|row| (row.1 / row.0 - 1.0).abs()).collect(),
        bounds: lit.iter().map(|row| row.2 / row.0).collect(),
    }
}

fn agrees(name: &str, tables: &SpectralTables) {
    let Some(gpu) = gpu(name) else { return };
    let check = compare(gpu, tables, &spectral_image(tables).unwrap());
    let [median, p95, allowed] = [(&check.relative, 0.5), (&check.relative, 0.95), (&check.bounds, 0.5)]
        .map(|(values, share)| quantile(values, share));
    println!(
        "{name}: {} tables, {} lit; relative difference {median:.1e} median, {p95:.1e} p95; allowed {allowed:.1e} median; \
         worst share {:.3}",
        tables.count,
        check.relative.len(),
        check.worst()
    );
    assert!(check.relative.len() > PAIRS / 10 && median > 0.0, "{name}: nothing is compared");
    // A bound that allows a percent would say nothing.
    assert!(allowed < 1e-2, "{name}: {allowed:e}");
    assert!(check.worst() <= 1.0, "{name}: {}", check.worst());
}

#[test]
fn a_rough_surface_agrees() {
    agrees("rough, windows on a grid", &build_tables(rough(), Edge::Tile, Windows::Grid, DIELECTRIC, 101));
    agrees("rough, one window, dispersive", full());
}

#[test]
fn a_grating_agrees() {
    agrees("grating, windows on a grid", &build_tables(grating(), Edge::Tile, Windows::Grid, METAL, 161));
    let tables = build_tables(grating(), Edge::Fade, Windows::Centre, DIELECTRIC, 161);
    assert!(tables.lobe.as_ref().is_some_and(|lobe| lobe.cross.is_some()));
    agrees("grating, one window", &tables);
}

#[test]
fn what_is_uploaded_wrong_is_found() {
    let Some(gpu) = gpu("spectral tables that are wrong") else { return };
    let tables = full();
    let image = spectral_image(tables).unwrap();
    assert!(compare(gpu, tables, &image).worst() <= 1.0);
    type Tamper<'a> = &'a dyn Fn(&mut SpectralImage);
    let tampers: [(&str, bool, Tamper); 8] = [
        ("shortest wavelength 1 nm up", true, &|image| image.params.shortest_nm += 1.0),
        ("shortest wavelength 1 nm down", true, &|image| image.params.shortest_nm -= 1.0),
        ("one scale 2 % up", true, &|image| image.params.table_scales[0][0] *= 1.02),
        ("tables 1 and 2 exchanged", true, &|image| {
            image.tables.texels.iter_mut().for_each(|texel| texel.swap(1, 2));
            image.params.table_scales[0].swap(1, 2);
        }),
        ("no cross term", false, &|image| image.params.cross_layers = 0),
        ("coherence 2 % up", false, &|image| image.params.lobe_sigma_nm *= 1.02),
        ("power of the lobe 2 % up", false, &|image| image.power.iter_mut().for_each(|value| *value *= 1.02)),
        ("scalar factor", true, &|image| image.params.factor = 0),
    ];
    for (what, everywhere, tamper) in tampers {
        let mut wrong = image.clone();
        tamper(&mut wrong);
        let beyond = compare(gpu, tables, &wrong).beyond();
        println!("{what}: {:.1} % of queries beyond what is allowed", 100.0 * beyond);
        // Lobe and cross term are narrow; all else concerns every direction.
        assert!(beyond > if everywhere { 0.5 } else { 0.01 }, "{what} went unnoticed: {beyond}");
    }
    // Indices come with the queries: the tables of another metal need no other upload.
    let moved = SpectralTables { dispersion: Dispersion::metal("silver"), ..tables.clone() };
    let found = compare(gpu, &moved, &image);
    assert!(found.worst() <= 1.0, "each query brings its index: {}", found.worst());
}

/// The uniform's own index is used where a query brings none.
#[test]
fn the_uniform_holds_the_index_of_one_wavelength() {
    let Some(gpu) = gpu("index of the uniform") else { return };
    let tables = full();
    let mut image = spectral_image(tables).unwrap();
    let nm = 550.0;
    image.params = image.params.at(tables.dispersion.as_ref().unwrap().material_at(nm).unwrap());
    let at = |query: SpectralQuery| SpectralQuery { wavelength_nm: nm as f32, own_index: 0, ..query };
    let queries: Vec<SpectralQuery> = queries(tables).into_iter().map(at).collect();
    let bound = SpectralBound::new(tables);
    let worst = |image: &SpectralImage| {
        let found = eval_spectral(gpu, &upload_spectral(gpu, image).unwrap(), &queries).unwrap();
        let shares = queries.iter().zip(found).map(|(query, found)| {
            let [wi, wo] = [query.wi, query.wo].map(|v| v.map(f64::from));
            let exact = tables.eval(Interpolation::Bilinear, wi, wo, &[nm])[0];
            (f64::from(found) - exact).abs() / bound.at(wi, wo, nm)
        });
        shares.fold(0.0, f64::max)
    };
    assert!(worst(&image) <= 1.0, "{}", worst(&image));
    // The index of the shortest wavelength in its place.
    assert!(worst(&spectral_image(tables).unwrap()) > 1.0);
}

#[test]
fn what_has_no_answer_has_none_on_the_gpu() {
    let Some(gpu) = gpu("spectral values without an answer") else { return };
    let tables = full();
    let uploaded = upload_spectral(gpu, &spectral_image(tables).unwrap()).unwrap();
    let up = SpectralQuery {
        wi: [0.0, 0.0, 1.0],
        wavelength_nm: 500.0,
        wo: [0.0, 0.0, 1.0],
        own_index: 0,
        index: [0.0; 2],
        unused: [0; 2],
    };
    let queries = [
        up,
        SpectralQuery { wavelength_nm: 379.0, ..up },
        SpectralQuery { wo: [0.6, 0.0, -0.8], ..up },
        SpectralQuery { wavelength_nm: 380.0, ..up },
    ];
    let found = eval_spectral(gpu, &uploaded, &queries).unwrap();
    assert!(found[0] > 0.0 && found[1].is_nan() && found[2] == 0.0 && found[3] > 0.0, "{found:?}");
    assert!(eval_spectral(gpu, &uploaded, &[]).unwrap().is_empty());
}
