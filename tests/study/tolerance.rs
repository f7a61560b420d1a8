//! The tolerance that is asked for is kept, on gratings too: automatic settings, measured afterwards.

use std::path::Path;

use diffraction_atlas::manifest::load;
use diffraction_atlas::stages::ingest::ingest;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Prefilter, Storage, TablesConfig};
use diffraction_build::tables::plan;
use diffraction_study::study::{Kept, StudyConfig, StudySpecimen, TOLERANCES, ToleranceRow, automatic, tolerance_row};

/// The specimens of a manifest, by its path in the repository.
fn specimens(manifest: &str) -> Vec<StudySpecimen> {
    let sections = load(&Path::new(env!("CARGO_MANIFEST_DIR")).join(manifest)).unwrap().0.specimens;
    let specimen = |section: &_| {
        let fields = ingest(section).unwrap().fields;
        StudySpecimen {
            name: section.name.clone(),
            fields,
            optics: section.optics.clone(),
            scenes: Vec::new(),
            lights: Vec::new(),
        }
    };
    sections.iter().map(specimen).collect()
}

fn print(name: &str, row: &ToleranceRow) {
    println!(
        "{name:24} {:.0e}: {:4} of {:4} texels, {:2} {:?} tables, {:3} wavelengths, {:.3e} samples, {:6.2} s; basis {:.1e}, \
         wavelengths {:.1e}, rounding {:.1e} (halves {:.1e}); on {} texels {:.1e}, worst {:.1e}; {:?}",
        row.tolerance,
        row.size[0],
        row.size[1],
        row.tables,
        row.storage,
        row.record.wavelengths_max,
        row.record.samples as f64,
        row.build_s,
        row.shares[0],
        row.shares[1],
        row.shares[2],
        row.rounding.half,
        row.on_texels.count,
        row.on_texels.p95,
        row.on_texels.worst,
        row.kept
    );
}

/// Small tables of point samples: as hard on basis and wavelengths as large ones, and no filter that would smooth over what
/// is wrong.
fn small(specimen: &StudySpecimen, tolerance: f64) -> TablesConfig {
    let config = StudyConfig { size_max: 151, ..StudyConfig::quick() };
    TablesConfig { prefilter: Prefilter::None, ..automatic(&specimen.optics, &config, tolerance) }
}

#[test]
fn every_bundled_specimen_keeps_every_tolerance() {
    let specimens = specimens("pipeline.toml");
    assert_eq!(specimens.len(), 6);
    for specimen in &specimens {
        for tolerance in TOLERANCES {
            let row = tolerance_row(specimen, &small(specimen, tolerance)).unwrap();
            print(&specimen.name, &row);
            assert!(row.on_texels.count >= 100, "{}: {} lit texels", specimen.name, row.on_texels.count);
            assert!(row.kept != Kept::Missed && row.on_texels.p95 <= tolerance, "{} {tolerance:e}", specimen.name);
            let stored = if row.storage == Storage::Half { row.rounding.half } else { row.rounding.float };
            assert!(stored <= row.rounding.allowed, "{} {tolerance:e}: {stored:e}", specimen.name);
        }
    }
}

/// The blazed grating's polynomials cancel at its vanishing orders, which halves do not survive.
#[test]
fn the_number_format_follows_from_what_halves_do() {
    for specimen in specimens("pipeline.toml") {
        let is_cancelling = specimen.name == "blazed_2500nm";
        if !is_cancelling && !specimen.name.ends_with("snake_like") {
            continue;
        }
        let tables = small(&specimen, 1e-3);
        let row = tolerance_row(&specimen, &tables).unwrap();
        print(&specimen.name, &row);
        let expected = if is_cancelling { Storage::Float } else { Storage::Half };
        assert!(row.storage == expected && row.kept != Kept::Missed, "{}", specimen.name);
        if is_cancelling {
            let halves = tolerance_row(&specimen, &TablesConfig { storage: Some(Storage::Half), ..tables }).unwrap();
            print(&specimen.name, &halves);
            assert!(halves.kept == Kept::Missed && halves.on_texels.p95 > 2e-3);
        }
    }
}

#[test]
fn fewer_wavelengths_keep_no_grating() {
    let gratings = ["blazed_2500nm", "sinusoid_1600nm", "grating_nanosurf_314nm"];
    for specimen in specimens("pipeline.toml").iter().filter(|s| gratings.contains(&s.name.as_str())) {
        for tolerance in [1e-3, 1e-4] {
            // At every radius a third of what the outermost ring takes.
            let [low, high] = specimen.optics.wavelength_nm;
            let tables = small(specimen, tolerance);
            let plan = plan::plan(&BuildInput::new(&specimen.fields, &specimen.optics, &tables)).unwrap();
            let third = plan.rings[0].quadrature.wavelengths_nm.len() / 3;
            let step_nm = (high - low) / third as f64;
            let row = tolerance_row(specimen, &TablesConfig { wavelength_step_nm: Some(step_nm), ..tables }).unwrap();
            print(&specimen.name, &row);
            assert!(row.kept == Kept::Missed && row.shares[0] < tolerance, "{} {tolerance:e}", specimen.name);
        }
    }
}

/// `cargo test --release measuring_real -- --ignored --nocapture`: the table of docs/accuracy.md.
#[test]
#[ignore = "minutes of measuring"]
fn measuring_real_scans_at_every_tolerance() {
    let manifest = "tests/real_scans.toml";
    if crate::skip::shared("specimens").is_none() {
        return;
    }
    let mut missed = Vec::new();
    for specimen in specimens("pipeline.toml").iter().chain(&specimens(manifest)) {
        for tolerance in TOLERANCES {
            let row = tolerance_row(specimen, &automatic(&specimen.optics, &StudyConfig::quick(), tolerance)).unwrap();
            print(&specimen.name, &row);
            if row.kept == Kept::Missed {
                missed.push(format!("{} {tolerance:e}", specimen.name));
            }
        }
    }
    assert!(missed.is_empty(), "{missed:?}");
}
