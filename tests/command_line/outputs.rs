//! What commands write: never onto what they read, and over what is there only where that is asked for.

use std::fs;

use crate::evaluation::directions;
use crate::place::{HEAD, LASERS, Place, ROUGH, WAVE, contents};

/// Every way by which a command could write onto one of its inputs.
#[test]
fn no_command_writes_onto_its_inputs() {
    let place = Place::with_scans();
    place.publish(&[HEAD, LASERS, ROUGH].concat());
    place.write("d.csv", &directions(3));
    place.write("light.csv", "wavelength_nm,power\n400,1\n700,1\n");
    place
        .write("lit.toml", &[HEAD, &LASERS.replace("{ lines_nm = [633, 532, 450] }", "\"light.csv\""), ROUGH].concat());
    fs::create_dir(place.path("below")).unwrap();
    fs::hard_link(place.path("d.csv"), place.path("hard.csv")).unwrap();
    #[cfg(unix)]
    std::os::unix::fs::symlink("../rough.tif", place.path("below/soft.tif")).unwrap();
    let tables = "eval --directions d.csv --atlas out/small --specimen rough";
    let scan = "eval --directions d.csv --method reference --specimen rough --manifest";
    let mut lines = vec![
        "inspect rough.tif --save-heights rough.tif".to_owned(),
        "inspect rough.tif --save-heights below/../rough.tif".into(),
        format!("{tables} --out d.csv"),
        format!("{tables} --out ./hard.csv"),
        format!("{tables} --illuminant light.csv --out light.csv"),
        format!("{tables} --out out/small/v0001/rough/table.000.exr"),
        format!("{tables} --out out/small/v0001/new.csv"),
        format!("{scan} m.toml --out m.toml"),
        format!("{scan} m.toml --out rough.tif"),
        format!("{scan} lit.toml --out light.csv"),
        "export out/small --form viewer --single-file --out out/small/v0001/report.html".into(),
        "run m.toml --log m.toml".into(),
        "run m.toml --log ./below/../m.toml".into(),
        "run m.toml --log rough.tif".into(),
        "run lit.toml --log light.csv".into(),
        "run m.toml --log out/small/v0001/run.log".into(),
    ];
    if cfg!(unix) {
        lines.extend([
            "inspect rough.tif --save-heights below/soft.tif".into(),
            "inspect below/soft.tif --save-heights rough.tif".into(),
            "run m.toml --log below/soft.tif".into(),
        ]);
    }
    let before = contents_without_links(&place);
    for line in lines {
        let forces: &[&str] = if line.starts_with("run ") { &[""] } else { &["", " --force"] };
        for force in forces {
            let called = place.call(&format!("{line}{force}")).ended(2);
            let taken = force.is_empty() && called.stderr.contains("is there already");
            let said =
                taken || ["what this command reads", "never changes"].iter().any(|what| called.stderr.contains(what));
            assert!(said && called.stdout.is_empty(), "{line}: {}", called.stderr);
        }
    }
    assert_eq!(contents_without_links(&place), before);
}

/// All files; links cannot be listed with their bytes.
fn contents_without_links(place: &Place) -> Vec<(String, Vec<u8>)> {
    let link = place.path("below/soft.tif");
    let target = fs::read_link(&link).ok();
    let _ = fs::remove_file(&link);
    let found = contents(place.folder()).into_iter().collect();
    #[cfg(unix)]
    if let Some(target) = target {
        std::os::unix::fs::symlink(target, &link).unwrap();
    }
    found
}

#[test]
fn what_is_there_is_replaced_only_with_force() {
    let place = Place::with_scans();
    place.publish(&[HEAD, LASERS, ROUGH].concat());
    place.write("d.csv", &directions(2));
    let lines = [
        "eval --directions d.csv --atlas out/small --specimen rough --out new/out.csv",
        "inspect rough.tif --save-heights new/heights.tif",
        "synthesize flat --size 8 --out new/flat.tif",
        "export out/small --form viewer --single-file --out new/page.html",
    ];
    for line in lines {
        place.call(line).ended(0);
        let before = contents(place.folder());
        let refused = place.call(line).ended(2);
        assert!(
            refused.stderr.contains("is there already") && refused.stderr.contains("--force"),
            "{}",
            refused.stderr
        );
        assert_eq!(contents(place.folder()), before, "{line}");
        place.call(&format!("{line} --force")).ended(0);
    }
    // Half-written files would lie beside.
    assert_eq!(fs::read_dir(place.path("new")).unwrap().count(), lines.len());
}

#[test]
fn an_export_that_failed_does_not_block_the_next() {
    let place = Place::with_scans();
    place.publish(&[HEAD, LASERS, ROUGH].concat());
    let table = place.path("out/small/v0001/rough/table.000.exr");
    let bytes = fs::read(&table).unwrap();
    let mut damaged = bytes.clone();
    let middle = damaged.len() / 2;
    damaged[..middle].fill(0);
    let lines =
        ["float-tables", "shaders", "viewer"].map(|form| format!("export out/small/v0001 --form {form} --out {form}"));
    fs::write(&table, &damaged).unwrap();
    for line in &lines {
        place.call(line).ended(1);
    }
    let left: Vec<String> = contents(place.folder())
        .into_keys()
        .filter(|path| path.contains("float-tables") || path.contains("shaders"))
        .collect();
    assert_eq!(left, [""; 0]);
    fs::write(&table, &bytes).unwrap();
    for line in &lines {
        place.call(line).ended(0);
        let refused = place.call(line).ended(2);
        assert!(refused.stderr.contains("is there already"), "{}", refused.stderr);
    }
}

/// Tables of 32-bit floats are an atlas again, of the specimens that were named: every reader opens it, and finds the same values.
#[test]
fn float_tables_are_an_atlas() {
    let place = Place::with_scans();
    place.publish(&[HEAD, LASERS, ROUGH, WAVE].concat());
    place.call("export out/small --form float-tables --specimen rough --out floats").ended(0);
    let index: serde_json::Value = serde_json::from_slice(&fs::read(place.path("floats/atlas.json")).unwrap()).unwrap();
    assert_eq!(index["specimens"].as_array().unwrap().len(), 1);
    assert!(
        fs::read_to_string(place.path("floats/FORMAT.md"))
            .unwrap()
            .contains("Numbers on this page are those of `rough`")
    );
    place.call("verify floats --samples 0").ended(0);
    fs::write(place.path("some.csv"), "theta_i_deg,phi_i_deg,theta_r_deg,phi_r_deg\n10,20,30,40\n0,0,0,0\n").unwrap();
    let said = |atlas: &str| {
        place.call(&format!("eval --directions some.csv --atlas {atlas} --specimen rough")).ended(0).stdout
    };
    assert_eq!(said("floats"), said("out/small"));
    let file = place.path("floats/rough/table.000.exr");
    let mut bytes = fs::read(&file).unwrap();
    let last = bytes.len() - 1;
    bytes[last] ^= 1;
    fs::write(&file, bytes).unwrap();
    place.call("verify floats --samples 0").ended(1);
}

/// Names of files, and texts in them, reach the terminal without what steers it.
#[cfg(unix)]
#[test]
fn names_do_not_steer_the_terminal() {
    let place = Place::with_scans();
    let hostile = "a\u{1b}]0;owned\u{7}\u{202e}fit.tif";
    fs::copy(place.path("rough.tif"), place.path(hostile)).unwrap();
    fs::write(place.path("bad\u{1b}[31m.tif"), "II*\0nothing").unwrap();
    for name in [hostile, "bad\u{1b}[31m.tif", "none\u{7}.tif", "--no\u{1b}[2Jsuch"] {
        for json in [&[][..], &["--json"][..]] {
            let output = crate::place::program(place.folder()).arg("inspect").arg(name).args(json).output().unwrap();
            let shown = [output.stdout, output.stderr].concat();
            let shown = String::from_utf8(shown).unwrap();
            assert!(!shown.contains(['\u{1b}', '\u{7}', '\u{202e}']), "{name:?}: {shown:?}");
            assert!(!shown.is_empty());
        }
    }
}
