//! A run's results as the report gets them: invented numbers, but pictures of real height fields.

use std::collections::BTreeMap;
use std::f64::consts::TAU;
use std::sync::LazyLock;

use diffraction_atlas::report::pictures::height_map;
use diffraction_atlas::report::spectrum_picture::{spectrum_half_range_per_um, spectrum_picture};
use diffraction_atlas::stages::goniometry::{BrightDirection, Goniometry, Plane, ReflectionMap, SetUp, Strip};
use diffraction_atlas::stages::gpu::check::{CpuPictures, compare, compare_with_reference};
use diffraction_atlas::stages::gpu::results::{FrameComparison, GpuSpectralRow, MethodFrame};
use diffraction_atlas::stages::results::*;
use diffraction_atlas::stages::stage::Stage;
use diffraction_brdf::spectrum::Illuminant;
use diffraction_build::accuracy::directions::Group;
use diffraction_build::accuracy::power_sums::{DirectionalAlbedo, PowerSum};
use diffraction_build::accuracy::rows::{Cause, ErrorRow};
use diffraction_build::ground::hue::Hue;
use diffraction_build::ground::sampling::Region;
use diffraction_build::height::HeightField;
use diffraction_build::optics::config::{Edge, Material, OpticsConfig, Windows};
use diffraction_build::tables::coverage::budget::Cost;
use diffraction_build::tables::model::{Basis, BuildRecord, Rounding, Storage};
use diffraction_render::render::gpu::GpuInfo;
use diffraction_render::render::gpu_frame::{Clock, FrameTime};
use diffraction_render::render::png_image::encode_png;
use ndarray::{Array2, Array3};

/// Results and the pictures they name.
#[derive(Clone)]
pub struct Sample {
    pub results: RunResults,
    pub pictures: BTreeMap<String, Vec<u8>>,
}

const MANIFEST: &str = "schema = 1\n\n[atlas]\nname = \"squamates\"\nout = \"out/atlas\"\n\n[tables]\nbasis = \"chebyshev\"\ntolerance = 1e-3   # of <95 %> of directions & no more\n\n[[specimen]]\nname = \"corn_snake_like\"\nscans = [\"specimens/corn_snake_like.tif\"]\n";

/// Three specimens that worked and one that did not. Made once, for the pictures take a moment.
pub fn sample() -> Sample {
    static SAMPLE: LazyLock<Sample> = LazyLock::new(make_sample);
    SAMPLE.clone()
}

fn make_sample() -> Sample {
    let mut pictures = BTreeMap::new();
    let specimens = vec![corn_snake(&mut pictures), crossed_grating(&mut pictures), blazed(&mut pictures), truncated()];
    let stages = stages(&specimens);
    let results = RunResults {
        schema: RESULTS_SCHEMA,
        atlas_name: "squamates".into(),
        version: Some("v0003".into()),
        program_version: "0.1.0".into(),
        started: "2025-03-14T09:26:53Z".into(),
        threads: 8,
        cpu_count: 16,
        manifest_text: MANIFEST.into(),
        specimens,
        shared_scenes: Vec::new(),
        stages,
        gpu: gpu_result(),
        left_out: Vec::new(),
        cache: None,
        failures: vec![Failure {
            specimen: Some("torn_scan".into()),
            stage: Stage::ReadAndPrepare,
            message: "scans/torn.tif: the file ends after 31 of 512 rows\n  copy the scan again from the instrument"
                .into(),
        }],
        peak_memory_mib: Some(1234.5),
        total_wall_s: 151.7,
    };
    Sample { results, pictures }
}

fn corn_snake(pictures: &mut BTreeMap<String, Vec<u8>>) -> SpecimenResult {
    // Rows of rounded steps with a finger-like ripple along them, on a gently domed surface.
    let heights_nm = Array2::from_shape_fn((512, 512), |(row, column)| {
        let [x, y] = [column as f64 / 512.0, (511 - row) as f64 / 512.0];
        let wave = 0.10 * (TAU * 3.0 * x).sin() + 0.06 * (TAU * (7.0 * x + 2.0 * y)).sin();
        let rows = (TAU * (28.0 * y + wave)).cos();
        let fingers = (TAU * (56.0 * x + 0.35 * (TAU * 5.0 * y).sin())).cos();
        26.0 * rows + 10.0 * fingers * (1.0 + rows) + 8.0 * (TAU * x).cos() * (TAU * y).sin()
    });
    let field = HeightField { heights_nm, pitch_nm: [62.5, 62.5] };
    let periods = [(1143.0, 90.2, 1.0), (571.0, 90.1, 0.31), (571.4, 0.2, 0.12)];
    let mut specimen = specimen("corn_snake_like", &field, &periods, pictures);
    specimen.species = Some("Pantherophis guttatus".into());
    specimen.generated = true;
    specimen.warnings = vec![
        "4.1 % of the slopes are above 0.5, where the scalar model is doubtful: treat values beyond 60° with care"
            .into(),
        "the cross term of the lobe is averaged over one window only".into(),
    ];
    specimen
}

fn crossed_grating(pictures: &mut BTreeMap<String, Vec<u8>>) -> SpecimenResult {
    let heights_nm = Array2::from_shape_fn((256, 256), |(row, column)| {
        let [x, y] = [column as f64 * 11.71875, (255 - row) as f64 * 11.71875];
        27.5 * (TAU * (x + y) / (314.3 * 2f64.sqrt())).cos() + 0.02 * x
    });
    let field = HeightField { heights_nm, pitch_nm: [11.71875, 11.71875] };
    let mut specimen = specimen("grating_nanosurf_314nm", &field, &[(314.3, 45.0, 1.0)], pictures);
    let basis = &mut specimen.errors[3];
    (basis.p95, basis.p99, basis.worst) = (2.4e-3, 4.1e-3, 0.012);
    specimen.scans[0]["warnings"] = serde_json::json!(["the unit was spelt \"nM\", read as nm"]);
    specimen.optics.as_mut().unwrap().material = Material::Conductor { n: 0.18, k: 3.4 };
    specimen
}

fn blazed(pictures: &mut BTreeMap<String, Vec<u8>>) -> SpecimenResult {
    let heights_nm = Array2::from_shape_fn((64, 512), |(_, column)| 250.0 * (column as f64 * 50.0 / 2500.0).fract());
    let field = HeightField { heights_nm, pitch_nm: [50.0, 50.0] };
    let periods = [(2500.0, 0.0, 1.0), (1250.0, 0.0, 0.25), (833.3, 0.0, 0.11)];
    let mut specimen = specimen("blazed_2500nm", &field, &periods, pictures);
    specimen.generated = true;
    specimen
}

fn truncated() -> SpecimenResult {
    SpecimenResult {
        name: "torn_scan".into(),
        species: None,
        generated: false,
        scans: vec![],
        size: [512, 512],
        pitch_nm: [48.8, 50.0],
        extent_um: [24.9856, 25.6],
        statistics: None,
        optics: None,
        pigment: None,
        build: None,
        lobe: None,
        errors: vec![],
        power_sums: vec![],
        albedo: vec![],
        measured: None,
        goniometry: None,
        scenes: vec![],
        height_map: None,
        spectrum: None,
        preview_png: None,
        reached_png: None,
        spectral: None,
        budget: None,
        verdict: Some(Verdict { grade: Grade::Red, sentence: "no tables: scans/torn.tif ends early".into() }),
        warnings: vec![],
        failed: Some(
            "scans/torn.tif: the file ends after 31 of 512 rows\n  copy the scan again from the instrument".into(),
        ),
        stale: None,
    }
}

fn specimen(
    name: &str,
    field: &HeightField,
    periods: &[(f64, f64, f64)],
    pictures: &mut BTreeMap<String, Vec<u8>>,
) -> SpecimenResult {
    let periods: Vec<Period> = periods
        .iter()
        .map(|&(period_nm, direction_deg, relative_power)| Period { period_nm, direction_deg, relative_power })
        .collect();
    let preview = format!("{name}/preview.png");
    pictures.insert(preview.clone(), encode_png(&sphere(256, &periods[0], 0.0)).unwrap());
    SpecimenResult {
        name: name.into(),
        species: None,
        generated: false,
        scans: vec![serde_json::json!({
            "file_name": format!("{name}.tif"),
            "sha256": "9f86d081884c7d659a2feaa0c55ad015a3bf4f1b2b0b822cd15d6c15b0f00a08",
            "format": "ImageJ TIFF",
            "sample_format": "f32",
            "size": field.size(),
            "pitch_nm": field.pitch_nm,
            "pitch_from": "file: ImageJ description",
            "height_from": "file: ImageJ vunit",
            "missing_samples": 0,
            "channel": null,
            "warnings": []
        })],
        size: field.size(),
        pitch_nm: field.pitch_nm,
        extent_um: field.extent_nm().map(|extent| extent * 1e-3),
        statistics: Some(statistics(field, periods.clone())),
        optics: Some(optics()),
        pigment: None,
        build: Some(build()),
        lobe: Some(LobeResult { radius_max: 0.142, cross_tables: 4, power_share: Some(0.37) }),
        errors: errors(),
        power_sums: power_sums(),
        albedo: albedo(),
        measured: None,
        goniometry: Some(goniometry(name, pictures)),
        scenes: vec![scene(name, &periods[0], pictures)],
        height_map: Some(height_file(name, field, pictures)),
        spectrum: Some(spectrum_file(name, field, &periods, pictures)),
        preview_png: Some(preview),
        reached_png: None,
        spectral: Some(SpectralResult {
            tables: 6,
            size: 601,
            storage: Storage::Half,
            range_nm: [380.0, 780.0],
            stored_bytes: 2_100_000,
            build_s: 0.3,
            build_cpu_s: Some(0.3),
            errors: errors().into_iter().filter(|row| row.cause != Cause::WavelengthStep).collect(),
        }),
        budget: None,
        verdict: Some(Verdict { grade: Grade::Amber, sentence: "good within limits: its edges do not fit.".into() }),
        warnings: vec![],
        failed: None,
        stale: None,
    }
}

fn goniometry(name: &str, pictures: &mut BTreeMap<String, Vec<u8>>) -> Goniometry {
    let png = format!("{name}/reflection_00deg.png");
    pictures.insert(png.clone(), encode_png(&Array3::from_elem((65, 65, 3), 20)).unwrap());
    let colour =
        |angle: i32| [0.2, 0.4, 0.1].map(|c: f32| c * (-0.01 * (f64::from(angle).abs() - 20.0).powi(2)).exp() as f32);
    let strip = |set_up| Strip { set_up, plane: Plane::Xz, first_deg: -85, xyz: (-85..=85).map(colour).collect() };
    Goniometry {
        acceptance_deg: 1.0,
        sentence: "In light from straight above it looks white from there.".into(),
        maps: vec![ReflectionMap { png, light_theta_deg: 0.0, white_level: 2.5 }],
        strips: vec![strip(SetUp::NormalIncidence), strip(SetUp::Mirror)],
        brightest: vec![BrightDirection {
            theta_deg: 20.3,
            phi_deg: 180.0,
            xyz: [0.2, 0.4, 0.1],
            hue: Hue::of([0.2, 0.4, 0.1], [0.95, 1.0, 1.09]),
            wavelength_nm: (0..=80).map(|n| 380.0 + 5.0 * f64::from(n)).collect(),
            radiance_factor: (0..=80).map(|n| (-0.01 * f64::from(n - 34).powi(2)).exp()).collect(),
        }],
    }
}

fn statistics(field: &HeightField, dominant_periods: Vec<Period>) -> Statistics {
    let mean = field.heights_nm.mean().unwrap();
    let rms_height_nm = field.heights_nm.mapv(|h| (h - mean).powi(2)).mean().unwrap().sqrt();
    Statistics {
        rms_height_nm,
        rms_slope: 0.214,
        peak_to_valley_nm: 112.0,
        autocorrelation_length_nm: 262.0,
        dominant_periods,
        usable_uv_radius: 2.0,
        steep_share: 0.041,
        wave_slope: 0.187,
        wall_share: 0.002,
        ambiguous_share: 0.0,
        surface: None,
        warnings: vec![],
    }
}

fn optics() -> OpticsConfig {
    OpticsConfig {
        material: Material::Dielectric { n: 1.56 },
        ..OpticsConfig::ideal(Illuminant::D65, 16_250.0, Edge::Tile, Windows::Grid)
    }
}

fn build() -> BuildResult {
    BuildResult {
        basis: Basis::Chebyshev,
        tables: 6,
        size: 501,
        storage: Storage::Half,
        rounding: Some(Rounding { half: 2.3e-4, float: 9.1e-5, allowed: 5e-4 }),
        stored_bytes: 9_646_899,
        prefilter_width: 0.008,
        tolerance: 1e-3,
        record: BuildRecord {
            transforms: 14,
            windows: 1,
            node_samples: 4_000_000,
            wavelengths_max: 412,
            samples: 61_204_511,
            wavelength_step_nm: [0.61, 5.0],
        },
        build_s: 21.4,
        build_cpu_s: Some(40.2),
        memory_bytes: Some(83_000_000),
        predicted: Some(Cost { node_samples: 3.6e6, seconds: 17.2, memory_bytes: 71e6, stored_bytes: 9.2e6 }),
    }
}

fn errors() -> Vec<ErrorRow> {
    let regions = [(Region::Hemisphere, 1.0), (Region::NearSpecular, 0.4), (Region::Grazing, 3.2)];
    let causes = [
        (Cause::Total, 1.1e-3),
        (Cause::Basis, 6.1e-5),
        (Cause::WavelengthStep, 4.0e-4),
        (Cause::Grid, 9.2e-4),
        (Cause::Storage, 2.4e-4),
    ];
    causes
        .iter()
        .flat_map(|&(cause, median)| {
            regions.map(|(region, factor)| ErrorRow {
                cause,
                group: Group::Region(region),
                directions: 2000,
                floor_per_sr: 1.5e-4,
                share_above: 1.0,
                directions_below: 32,
                missed_directions: 0,
                left_out_per_sr: Some(2.1e-6),
                relative_l2: median * factor * 1.4,
                p50: median * factor * 0.2,
                p95: median * factor,
                p99: median * factor * 2.6,
                worst: median * factor * 11.0,
            })
        })
        .collect()
}

fn albedo() -> Vec<DirectionalAlbedo> {
    [(0.0, 0.048), (45.0, 0.052), (60.0, 0.093), (85.0, 0.49)]
        .map(|(theta_i_deg, albedo)| DirectionalAlbedo { theta_i_deg, albedo })
        .to_vec()
}

fn power_sums() -> Vec<PowerSum> {
    let mut sums = Vec::new();
    for wavelength_nm in [None, Some(450.0), Some(550.0), Some(650.0)] {
        for theta_i_deg in [0.0f64, 15.0, 30.0, 45.0, 60.0, 75.0] {
            let tilt = (theta_i_deg / 75.0).powi(3);
            let colour = wavelength_nm.map_or(0.0, |wavelength| (550.0 - wavelength) * 5e-4);
            sums.push(PowerSum { theta_i_deg, wavelength_nm, sum: 1.012 + colour - 0.21 * tilt * (1.0 + colour) });
        }
    }
    sums
}

fn scene(name: &str, period: &Period, pictures: &mut BTreeMap<String, Vec<u8>>) -> SceneResult {
    let path = |what: &str| format!("{name}/scenes/sphere{what}.png");
    let (tables, reference) = (sphere(192, period, 0.0), sphere(192, period, 0.004));
    let pair = Array3::from_shape_fn((192, 388, 3), |(row, column, channel)| match column {
        0..192 => tables[(row, column, channel)],
        192..196 => 255,
        _ => reference[(row, column - 196, channel)],
    });
    let difference = Array3::from_shape_fn((192, 192, 3), |at| tables[at].abs_diff(reference[at]));
    pictures.insert(path(""), encode_png(&sphere(512, period, 0.0)).unwrap());
    pictures.insert(path(".side_by_side"), encode_png(&pair).unwrap());
    pictures.insert(path(".difference"), encode_png(&difference).unwrap());
    SceneResult {
        light: "light from 45° at azimuth 0°, 0.53° wide".into(),
        name: "sphere".into(),
        shape: "sphere".into(),
        size_px: [512, 512],
        exposure: 0.412,
        seconds: 0.183,
        error: Some(SceneError {
            pixels: 36_864,
            relative_l2: 1.9e-3,
            ciede2000_mean: 0.041,
            ciede2000_p95: 0.13,
            ciede2000_max: 0.92,
        }),
        uncovered_pixels: 0,
        table_png: path(""),
        side_by_side_png: Some(path(".side_by_side")),
        difference_png: Some(path(".difference")),
        difference_scale: Some("5 % of the reference white".into()),
        animation_png: None,
        animation: None,
    }
}

fn height_file(name: &str, field: &HeightField, pictures: &mut BTreeMap<String, Vec<u8>>) -> HeightMapFile {
    let picture = height_map(field, None).unwrap();
    let png = format!("{name}/heights.png");
    pictures.insert(png.clone(), encode_png(&picture.rgb).unwrap());
    HeightMapFile {
        png,
        scale_bar_um: picture.scale_bar_um,
        low_nm: picture.low_nm,
        high_nm: picture.high_nm,
        replaced_samples: 0,
    }
}

fn spectrum_file(
    name: &str,
    field: &HeightField,
    periods: &[Period],
    pictures: &mut BTreeMap<String, Vec<u8>>,
) -> SpectrumFile {
    let periods_nm: Vec<f64> = periods.iter().map(|period| period.period_nm).collect();
    let range = spectrum_half_range_per_um(field, &periods_nm);
    let picture = spectrum_picture(field, range).unwrap();
    let png = format!("{name}/spectrum.png");
    pictures.insert(png.clone(), encode_png(&picture.rgb).unwrap());
    SpectrumFile { png, half_range_per_um: picture.half_range_per_um, low_db: picture.low_db }
}

/// A stand-in for a rendered scene: orders of a grating on a sphere, shifted by `shift` in u.
fn sphere(side: usize, period: &Period, shift: f64) -> Array3<u8> {
    let (sin, cos) = period.direction_deg.to_radians().sin_cos();
    let mut rgb = Array3::zeros((side, side, 3));
    for row in 0..side {
        for column in 0..side {
            let place = |index: usize| (index as f64 + 0.5) / side as f64 * 2.1 - 1.05;
            let (x, y) = (place(column), -place(row));
            if x * x + y * y >= 1.0 {
                continue;
            }
            let z = (1.0 - x * x - y * y).sqrt();
            // Half vector against the surface frame, for a light to the upper left.
            let (hx, hy, hz) = (-0.35, 0.45, 1.82);
            let (nx, ny) = (2.0 * (hx * z - hz * x) / 1.9, 2.0 * (hy * z - hz * y) / 1.9);
            let along = nx * cos + ny * sin + shift;
            let across = -nx * sin + ny * cos;
            let mut colour = [0.012; 3];
            for order in 1..=4 {
                let wavelength_nm = along.abs() * period.period_nm / f64::from(order);
                let strength = (-across * across * 6.0).exp() / f64::from(order);
                for (channel, centre) in [610.0, 545.0, 450.0].into_iter().enumerate() {
                    let offset: f64 = (wavelength_nm - centre) / 38.0;
                    colour[channel] += 0.7 * strength * (-offset * offset).exp();
                }
            }
            let lobe = 1.5 * (-(along * along + across * across) / 0.006).exp();
            for channel in 0..3 {
                let value: f64 = (colour[channel] + lobe).min(1.0);
                rgb[(row, column, channel)] = (255.0 * value.powf(1.0 / 2.2)).round() as u8;
            }
        }
    }
    rgb
}

fn stages(specimens: &[SpecimenResult]) -> Vec<StageTime> {
    let per_specimen = [
        (Stage::ReadAndPrepare, 0.251),
        (Stage::BuildTables, 21.4),
        (Stage::StoreTables, 0.42),
        (Stage::RenderScenes, 1.6),
        (Stage::EvaluateReference, 9.1),
        (Stage::MeasureErrors, 14.8),
        (Stage::WritePictures, 0.42),
    ];
    let mut stages = Vec::new();
    for (index, specimen) in specimens.iter().enumerate() {
        let count = if specimen.failed.is_some() { 1 } else { 7 };
        for (name, wall_s) in per_specimen.into_iter().take(count) {
            stages.push(StageTime {
                name,
                specimen: Some(specimen.name.clone()),
                wall_s: wall_s * (1.0 - 0.2 * index as f64),
                cpu_s: Some(wall_s * 6.5),
            });
        }
    }
    stages.push(StageTime { name: Stage::TimeFrames, specimen: None, wall_s: 0.61, cpu_s: Some(0.2) });
    stages
}

fn gpu_result() -> GpuResult {
    let gpu = GpuInfo {
        adapter: "llvmpipe (LLVM 15.0.6, 256 bits)".into(),
        backend: "vulkan".into(),
        driver: "llvmpipe Mesa 22.3.6".into(),
        kind: "cpu".into(),
        vendor_device: [0x10005, 0],
        timestamps: true,
        texture_side_max: 16_384,
        texture_layers_max: 2048,
        storage_binding_max_bytes: 128 << 20,
        features: ["TIMESTAMP_QUERY", "FLOAT32_FILTERABLE", "SHADER_F16"].map(String::from).into(),
    };
    let time = |tables, median_ms| FrameTime {
        median_ms,
        shortest_ms: 0.9 * median_ms,
        frames: 5,
        size_px: 1024,
        tables,
        light_samples: 1,
        evaluations: 420_000,
        texel_gb_per_s: 3.1,
        clock: Clock::Timestamps,
    };
    let frames = FrameComparison {
        specimen: "corn_snake_like".into(),
        atlas: MethodFrame { error_p95: [5.5e-4, 9.8e-4, 5.0e-4], time: time(5, 96.2) },
        taylor: Some(MethodFrame { error_p95: [5.0e-4, 1.3e-2, 4.9e-4], time: time(12, 171.4) }),
        refused: None,
        copy_gb_per_s: 11.3,
    };
    let rows = [("corn_snake_like", 3.1e-6, None), ("blazed_2500nm", 3e-1, Some("corn_snake_like/preview.png"))];
    GpuResult::Checked {
        gpu: Box::new(gpu),
        rows: rows.map(gpu_row).into(),
        spectral: vec![GpuSpectralRow {
            specimen: "grating".into(),
            values: 768,
            not_finite: 0,
            beyond: 0,
            worst_of_tolerance: 0.31,
        }],
        frames: Some(Box::new(frames)),
    }
}

/// A scene on which the GPU adds `added` where 1e-3 of white are allowed.
fn gpu_row((specimen, added, difference): (&str, f32, Option<&str>)) -> GpuRow {
    let image = |value: f32| Array3::from_elem((4, 4, 3), value);
    let (exact, by_cpu, by_gpu, bound) = (image(0.5), image(0.501), image(0.501 + added), image(1e-3));
    let mut cpu = compare(&by_cpu, &by_gpu, &bound, 1.0);
    cpu.scene = "sphere".into();
    let pictures = CpuPictures { linear: &by_cpu, cubic: &by_cpu };
    let mut reference = compare_with_reference(&exact, pictures, &by_gpu, &bound, 1.0, 2.5e-3);
    (cpu.difference, reference.difference) = (None, None);
    GpuRow {
        specimen: specimen.into(),
        cpu,
        picture: None,
        reference: Some(reference),
        promised: true,
        difference_png: difference.map(String::from),
    }
}
