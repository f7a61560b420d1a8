//! Scans at the limits, from the file to the atlas: heights that are no numbers or no surface's, few samples, pitches far
//! apart.

use crate::place::{HEAD, LASERS, Place};
use crate::scan_files::{Order, PageParts, f32_bytes, tiff_file};

/// A scan as an uncompressed TIFF of floats in nm: a relief with a few samples replaced by other values.
fn write_floats(place: &Place, name: &str, [nx, ny]: [usize; 2], replaced: &[(usize, f32)]) {
    let wave = |index: usize| {
        let (x, y) = ((index % nx) as f32 / nx as f32, (index / nx) as f32 / ny as f32);
        30.0 * (std::f32::consts::TAU * (3.0 * x + 2.0 * y)).sin() + 10.0 * (std::f32::consts::TAU * 5.0 * x).cos()
    };
    let mut heights: Vec<f32> = (0..nx * ny).map(wave).collect();
    replaced.iter().for_each(|&(index, height)| heights[index] = height);
    let data = f32_bytes(Order::Little, &heights);
    let page = PageParts::grey(Order::Little, [nx as u32, ny as u32], 32, 3, data);
    std::fs::write(place.path(&format!("{name}.tif")), tiff_file(Order::Little, &[page])).unwrap();
}

fn specimen(name: &str, pitch_nm: &str) -> String {
    format!(
        "[[specimen]]\nname = \"{name}\"\nscans = [\"{name}.tif\"]\npitch_nm = {pitch_nm}\nheight = {{ unit = \"nm\" }}\n"
    )
}

/// Every `step`th of 48 x 48 samples.
fn every(step: usize, height: f32) -> Vec<(usize, f32)> {
    (0..48 * 48).step_by(step).map(|index| (index, height)).collect()
}

#[test]
fn scans_that_are_no_surface_are_refused_by_name_and_nothing_is_published() {
    let place = Place::empty();
    let missing = "samples are missing";
    let metre = "more than a metre";
    let bad = [
        ("all_nan", every(1, f32::NAN), missing),
        ("third_nan", every(3, f32::NAN), missing),
        ("third_infinite", every(3, f32::INFINITY), missing),
        ("one_1e30", vec![(77, 1e30)], metre),
        ("one_minus_1e30", vec![(77, -1e30)], metre),
        ("one_3e38", vec![(77, 3e38)], metre),
        ("all_1e30", every(1, 1e30), metre),
        // Below a metre a unit may be meant; as a relief that diffracts it is refused before tables are computed.
        ("one_1_cm", vec![(77, 1e7)], "from valley to peak"),
        ("pitch_1_mm", vec![], "samples lie 1000.0000 µm apart"),
    ];
    let mut manifest = [HEAD, LASERS].concat();
    for (name, replaced, _) in &bad {
        write_floats(&place, name, [48; 2], replaced);
        manifest += &specimen(name, if *name == "pitch_1_mm" { "1e6" } else { "100" });
    }
    place.write("m.toml", &manifest);
    let run = place.call("--quiet run m.toml").ended(1);
    assert!(!run.stdout.contains("published"), "{}", run.stdout);
    for (name, _, cause) in &bad {
        let line = run.stderr.split("failed: ").find(|line| line.starts_with(&format!("{name} ")));
        assert!(line.is_some_and(|line| line.contains(cause)), "{name}: {}", run.stderr);
    }
    assert!(run.stderr.ends_with("9 failed; the rest is done\n"), "{}", run.stderr);
    assert!(place.versions().is_empty(), "{:?}", place.versions());
}

#[test]
fn odd_scans_and_pitches_far_apart_give_tables_that_agree_with_the_scan() {
    let place = Place::empty();
    let few = |height: f32| vec![(77, height), (500, height), (501, height)];
    let odd = [
        ("few_nan", [48, 48], few(f32::NAN), "100"),
        ("few_infinite", [48, 48], few(f32::NEG_INFINITY), "100"),
        // The largest float marks what an instrument missed.
        ("few_largest", [48, 48], few(f32::MAX), "100"),
        ("minus_zero", [48, 48], few(-0.0), "100"),
        ("denormal", [48, 48], few(1e-40), "100"),
        ("flat", [48, 48], every(1, 7.0), "100"),
        ("one", [1, 1], vec![], "100"),
        ("four", [2, 2], vec![(0, 50.0)], "100"),
        ("row", [64, 1], vec![], "100"),
        ("column", [1, 64], vec![], "100"),
        ("pitch_1_nm", [48, 48], vec![], "1"),
        ("pitch_1_um", [48, 48], vec![], "1000"),
        ("oblong", [48, 48], vec![], "[10, 200]"),
    ];
    let mut manifest = [HEAD, LASERS].concat();
    for (name, size, replaced, pitch_nm) in &odd {
        write_floats(&place, name, *size, replaced);
        manifest += &specimen(name, pitch_nm);
    }
    let published = place.publish(&manifest);
    assert!(published.stdout.starts_with("published out/small/v0001 in "), "{}", published.stdout);
    let index = place.json("out/small/v0001/atlas.json");
    assert_eq!(index["specimens"].as_array().unwrap().len(), odd.len());
    place.call("verify out/small --manifest m.toml").ended(0);
    let directions = ["20,0,35,90", "30,40,30,220", "0,0,0,0", "89.9,10,89.9,190", "60,70,60,70", "89.99,0,89.99,0"];
    place.write("d.csv", &format!("theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg\n{}\n", directions.join("\n")));
    for (name, _, _, _) in &odd {
        let line = format!("eval --directions d.csv --atlas out/small --specimen {name}");
        let values = place.call(&line).ended(0).stdout;
        let rows: Vec<&str> = values.lines().skip(1).collect();
        assert_eq!(rows.len(), directions.len(), "{values}");
        for row in rows {
            let xyz: Vec<f64> = row.split(',').skip(4).map(|number| number.parse().unwrap()).collect();
            assert!(xyz.len() == 3 && xyz.iter().all(|value| value.is_finite()), "{name}: {row}");
        }
    }
}
