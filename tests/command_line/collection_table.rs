//! Specimens from a CSV file: what its cells mean, and what is said of those that mean nothing.

use std::path::Path;

use diffraction_atlas::error::Error;
use diffraction_atlas::manifest::Manifest;
use diffraction_build::height::prepare::Level;
use diffraction_build::height::read::{HeightScale, LengthUnit};
use diffraction_build::optics::config::Material;

use crate::manifest_fixture::{folder, parse_in};
use crate::place::{HEAD, LASERS, Place};

const MANIFEST: &str =
    "schema = 1\nspecimens = \"table.csv\"\n[atlas]\nname = \"a\"\n[optics]\nmaterial = { n = 1.3 }\n";

fn read(folder: &Path, table: &str) -> Result<Manifest, Error> {
    std::fs::write(folder.join("table.csv"), table).unwrap();
    parse_in(folder, MANIFEST)
}

#[test]
fn a_row_means_what_a_section_means() {
    let folder = folder();
    let table = "# scanned in May\n\
                 name;scans;species;pitch_nm;material.n;height.unit;level;crop;measured;coherence.sigma_um;despike.threshold_rms\n\
                 0412;snake.tif;Elaphe guttata;48,8;1,56;nm;rows;0 0 512 400;measured.csv;4;8\n\
                 both;snake*.tif;\"a; b\";48,8 50;;;;;;;\n\
                 {file}_again;snake2.tif;;;;;;;;;\n";
    let sections = r#"[[specimen]]
name = "0412"
scans = "snake.tif"
species = "Elaphe guttata"
pitch_nm = 48.8
material = { n = 1.56 }
height = { unit = "nm" }
level = "rows"
crop = [0, 0, 512, 400]
measured = "measured.csv"
coherence = { sigma_um = 4 }
despike = { threshold_rms = 8 }
[[specimen]]
name = "both"
scans = "snake*.tif"
species = "a; b"
pitch_nm = [48.8, 50]
[[specimen]]
name = "snake2_again"
scans = "snake2.tif"
"#;
    let rows = read(folder.path(), table).unwrap();
    let written = MANIFEST.replace("specimens = \"table.csv\"\n", "") + sections;
    let written = parse_in(folder.path(), &written).unwrap();
    assert_eq!(rows.specimens, written.specimens);
    // And is not what it would be without the cells.
    let [first, _, last] = &rows.specimens[..] else { panic!("three rows") };
    assert_eq!((first.read.height, first.prepare.level), (Some(HeightScale::Unit(LengthUnit::Nm)), Level::Rows));
    assert_eq!(
        (&first.optics.material, &last.optics.material),
        (&Material::Dielectric { n: 1.56 }, &Material::Dielectric { n: 1.3 })
    );
    let collection = rows.collection.unwrap();
    assert_eq!(collection.named, [folder.path().join("measured.csv")]);

    // Beside sections, behind them, and in other clothes.
    let other = table.replace(',', ".").replace(';', "\t").replace('\n', "\r\n").replace("a\t b", "a; b");
    std::fs::write(folder.path().join("table.csv"), "\u{feff}".to_owned() + &other).unwrap();
    let section = "[[specimen]]\nname = \"first\"\nscans = \"snake.tif\"\n";
    let beside = parse_in(folder.path(), &(MANIFEST.to_owned() + section)).unwrap().specimens;
    assert_eq!((beside[0].name.as_str(), &beside[1..]), ("first", &rows.specimens[..]));
    let twice = parse_in(folder.path(), &(MANIFEST.to_owned() + &section.replace("first", "BOTH"))).unwrap_err();
    assert!(twice.to_string().contains("\"both\" differs from \"BOTH\" in case alone"), "{twice}");
}

#[test]
fn faults_stand_in_their_cell() {
    let folder = folder();
    for (table, [line, column], fault) in [
        ("", [1, 1], "names the columns"),
        ("name,scans\n", [2, 1], "holds no specimen"),
        ("name,scans,pitch\na,snake.tif,5\n", [1, 12], "nearest known key is `pitch_nm`"),
        ("name,scans,material.m\n", [1, 12], "unknown key `m` in material"),
        ("name,scans,optics.n\n", [1, 12], "`optics` is no table"),
        ("name,scans,name\n", [1, 12], "two columns `name`"),
        ("name,scans,pitch_nm\n\na,snake.tif,50\nb,snake.tif,-5\n", [4, 13], "`pitch_nm` must lie between"),
        ("name,scans,pitch_nm\na,snake.tif,wide\n", [2, 13], "found the string \"wide\""),
        ("name,scans,pitch_nm\na,snake.tif,50 51 52\n", [2, 13], "found 3 elements"),
        ("name,scans,page\na,snake.tif,0.5\n", [2, 13], "`page` must be a whole number"),
        ("name,scans,crop\na,snake.tif,0 0 -1 4\n", [2, 17], "`crop[2]` must lie between"),
        ("name,scans,material.n\na,snake.tif, 0.5\n", [2, 14], "`material.n` must lie between"),
        ("name,scans,material,material.n\na,snake.tif,ideal,1.5\n", [2, 19], "`material` is given as a whole"),
        ("name,scans,height.offset_nm\na,snake.tif,1\n", [2, 13], "`height` must hold exactly one"),
        ("name,scans\na,snake.tif,5\n", [2, 1], "expected 2 cells"),
        ("name,scans\na,none.tif\n", [2, 3], "a file that does not exist"),
        ("name,scans\n,snake.tif\n", [2, 1], "`name` is missing"),
        ("name,scans\na,snake.tif\nA,snake.tif\n", [3, 1], "in case alone"),
        ("name,scans\nµ,snake.tif\n", [2, 1], "begin with a letter"),
    ] {
        let error = read(folder.path(), table).unwrap_err();
        let Error::Manifest { file, line: at, column: across, message, .. } = &error else { panic!("{error:?}") };
        assert!(file.ends_with("table.csv") && message.contains(fault), "{table:?}: {error}");
        assert_eq!([*at, *across], [line, column], "{table:?}: {error}");
    }
    for (name, fault) in
        [("none.csv", "a file that does not exist"), ("flat.exr", "this is no text"), (".", "a folder")]
    {
        let error = parse_in(folder.path(), &MANIFEST.replace("table.csv", name)).unwrap_err();
        let Error::Manifest { line: 2, message, .. } = &error else { panic!("{error:?}") };
        assert!(message.contains(fault), "{message}");
    }
}

#[test]
fn a_changed_row_makes_its_specimen_alone() {
    let place = Place::with_scans();
    let manifest = HEAD.replacen('\n', "\nspecimens = \"table.csv\"\n", 1) + LASERS;
    place.write("table.csv", "name,scans,material.n\nrough,rough.tif,1.5\nbumps,bumps.tif,1.5\n");
    let run = place.publish(&manifest).stdout;
    assert!(run.lines().next().unwrap().ends_with(": 2 made"), "{run}");
    place.write("table.csv", "name,scans,material.n\nrough,rough.tif,1.5\nbumps,bumps.tif,1.6\n");
    let run = place.publish(&manifest).stdout;
    assert!(run.lines().next().unwrap().ends_with(": 1 made, 1 unchanged"), "{run}");
    let inputs = |version: &str| place.json(&format!("out/small/{version}/atlas.json"))["inputs"].clone();
    let digest = |version: &str| {
        let inputs = inputs(version);
        let table = inputs.as_array().unwrap().iter().find(|input| input["path"] == "table.csv").unwrap().clone();
        table["sha256"].as_str().unwrap().to_owned()
    };
    assert_ne!(digest("v0001"), digest("v0002"));
    // No command writes onto it.
    place.write("d.csv", &crate::evaluation::directions(2));
    let line = "eval --directions d.csv --method reference --manifest m.toml --specimen rough --out table.csv";
    let refused = place.call(&format!("{line} --force"));
    assert_eq!(refused.status, 2, "{}", refused.stderr);
}
