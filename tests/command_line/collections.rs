//! Runs over collections: only what changed is made, what fails keeps its last good result, and parts are made apart.

use std::collections::BTreeMap;
use std::fs;

use diffraction_brdf::atlas;
use serde_json::Value;

use crate::place::{HEAD, LASERS, Place, ROUGH, SCENES, WAVE, contents, usual};

/// Files of a version whose bytes depend on inputs and program alone.
fn timeless(place: &Place, version: &str) -> BTreeMap<String, Vec<u8>> {
    let mut files = contents(&place.path(&format!("out/small/{version}")));
    files.retain(|name, _| !atlas::may_differ(name) && name != "atlas.json");
    files
}

fn dry_run(place: &Place) -> String {
    place.call("run m.toml --dry-run").ended(0).stdout
}

#[test]
fn only_what_changed_is_made_and_the_rest_is_stored_once() {
    let place = Place::with_scans();
    place.write("m.toml", &usual());
    let before = contents(place.folder());
    assert_eq!(dry_run(&place), "make rough: it is new\nmake wave: it is new\n2 to make, 0 unchanged\n");
    assert_eq!(contents(place.folder()), before, "a dry run writes nothing");
    let first = place.publish(&usual());
    assert!(first.stdout.lines().next().unwrap().ends_with(": 2 made"), "{}", first.stdout);
    // A comment is no change.
    let second = place.publish(&("# last night's\n".to_owned() + &usual()));
    assert!(second.stdout.ends_with("nothing was published: 2 unchanged\n"), "{}", second.stdout);
    assert_eq!(dry_run(&place), "0 to make, 2 unchanged\n");

    place.write("m.toml", &usual().replace("n = 1.5", "n = 1.6"));
    let why = "make rough: optics.material.dielectric.n: 1.5 -> 1.6\n1 to make, 1 unchanged\n";
    assert_eq!(dry_run(&place), why);
    assert_eq!(place.call("list --missing m.toml").ended(0).stdout, "rough\n");
    let third = place.call("--quiet run m.toml").ended(0).stdout;
    assert!(third.lines().next().unwrap().ends_with(": 1 made, 1 unchanged"), "{third}");
    // The index stands in front of the tables.
    let used = &place.json("out/small/v0002/report.json")["cache"];
    assert_eq!((&used["tables_found"], &used["tables_built"]), (&1.into(), &0.into()));
    place.call("verify out/small --manifest m.toml").ended(0);
    #[cfg(unix)]
    for file in ["wave/table.000.exr", "wave/scenes/ball.png", "wave/result.json"] {
        use std::os::unix::fs::MetadataExt;
        let places = ["v0001", "v0002"].map(|version| fs::metadata(place.path(&format!("out/small/{version}/{file}"))));
        let [one, other] = places.map(|metadata| metadata.unwrap().ino());
        assert_eq!(one, other, "{file} is stored once");
    }
    // What was taken over is what would be made.
    let taken_over = timeless(&place, "v0002");
    fs::remove_dir_all(place.path("out/small")).unwrap();
    place.call("--quiet run m.toml --no-cache").ended(0);
    assert!(timeless(&place, "v0001") == taken_over);
}

#[test]
fn a_specimen_that_goes_and_one_that_comes_concern_no_other() {
    let place = Place::with_scans();
    place.publish(&usual());
    let bumps = "[[specimen]]\nname = \"bumps\"\nscans = [\"bumps.tif\"]\n";
    let run = place.publish(&[HEAD, LASERS, bumps, WAVE, SCENES].concat()).stdout;
    assert!(run.lines().next().unwrap().ends_with(": 1 made, 1 unchanged"), "{run}");
    let names = |version: &str| {
        let index = place.json(&format!("out/small/{version}/atlas.json"));
        index["specimens"]
            .as_array()
            .unwrap()
            .iter()
            .map(|s| s["name"].as_str().unwrap().to_owned())
            .collect::<Vec<_>>()
    };
    assert_eq!(names("v0002"), ["bumps", "wave"]);
    // One fewer, and nothing to make.
    let run = place.publish(&[HEAD, LASERS, WAVE, SCENES].concat()).stdout;
    assert!(run.lines().next().unwrap().ends_with(": 1 unchanged"), "{run}");
    assert_eq!(names("v0003"), ["wave"]);
}

/// So many specimens that each has a page of its own.
#[test]
fn of_many_specimens_each_has_a_page_that_is_stored_once() {
    let place = Place::with_scans();
    fs::create_dir(place.path("scans")).unwrap();
    let scan = fs::read(place.path("rough.tif")).unwrap();
    let add = |n: usize| fs::write(place.path(&format!("scans/scale_{n:02}.tif")), &scan).unwrap();
    (0..21).for_each(add);
    // As little of each as there can be.
    let few = LASERS.replace("size = 65", "size = 17\nserve = \"scenes\"") + "[report]\nreference = false\n";
    let each = "[[specimen]]\nname = \"{file}\"\nscans = \"scans/*.tif\"\n";
    let map = "[[scene]]\nname = \"map\"\nshape = \"hemisphere\"\nlight = { direction = [0, 0, 1] }\nsize_px = 16\n";
    let manifest = [HEAD, &few, each, map].concat();
    place.publish(&manifest);
    let page = |version: &str, name: &str| {
        fs::read_to_string(place.path(&format!("out/small/{version}/report.pages/{name}.html"))).unwrap()
    };
    let overview = fs::read_to_string(place.path("out/small/v0001/report.html")).unwrap();
    assert!(overview.contains("\"./report.pages/scale_07.html\"") && !overview.contains("<h3>The surface</h3>"));
    let one = page("v0001", "scale_07");
    assert!(one.contains("<h3>The surface</h3>") && one.contains("\"../scale_07/heights.png\""));
    let told = &place.json("out/small/v0001/report.json")["specimens"][7];
    assert_eq!((&told["name"], &told["budget"]), (&"scale_07".into(), &Value::Null));
    assert!(place.json("out/small/v0001/scale_07/result.json")["result"]["budget"].is_object());

    // One comes, one breaks.
    add(21);
    let whole = cut(&place, "scans/scale_03.tif");
    let run = place.call("--quiet run m.toml").ended(1);
    assert!(run.stdout.contains(": 1 made, 20 unchanged, 1 kept"), "{}", run.stdout);
    place.call("verify out/small").ended(0);
    let stale = "result of an older version";
    assert!(page("v0002", "scale_03").contains(stale) && !page("v0002", "scale_07").contains(stale));
    assert!(page("v0002", "scale_21").contains("<h3>The surface</h3>"));
    #[cfg(unix)]
    {
        use std::os::unix::fs::MetadataExt;
        let file = |version: &str, name: &str| format!("out/small/{version}/report.pages/{name}.html");
        let node = |version: &str, name: &str| fs::metadata(place.path(&file(version, name))).unwrap().ino();
        assert_eq!(node("v0001", "scale_07"), node("v0002", "scale_07"));
    }
    // And is mended: its page says so no more.
    fs::write(place.path("scans/scale_03.tif"), whole).unwrap();
    place.call("--quiet run m.toml").ended(0);
    assert!(!page("v0003", "scale_03").contains(stale));
    // A page that was changed by hand is not taken over.
    fs::write(place.path("out/small/v0003/report.pages/scale_05.html"), "mine").unwrap();
    add(22);
    place.call("--quiet run m.toml").ended(0);
    assert!(page("v0004", "scale_05").contains("<h3>The surface</h3>"));
    place.call("verify out/small/v0004").ended(0);
}

/// Cuts a scan short, as a copy that broke off.
fn cut(place: &Place, name: &str) -> Vec<u8> {
    let whole = fs::read(place.path(name)).unwrap();
    fs::write(place.path(name), &whole[..whole.len() / 2]).unwrap();
    whole
}

#[test]
fn a_specimen_that_fails_keeps_its_last_good_result() {
    let place = Place::with_scans();
    place.publish(&usual());
    let good = timeless(&place, "v0001");
    let whole = cut(&place, "rough.tif");
    place.write("m.toml", &usual().replace("name = \"wave\"\n", "name = \"wave\"\nspecies = \"unda\"\n"));
    let run = place.call("run m.toml").ended(1);
    assert!(run.stdout.lines().next().unwrap().ends_with(": 1 made, 1 kept"), "{}", run.stdout);
    assert!(run.stderr.contains("what there was of it is kept, marked as stale"), "{}", run.stderr);
    assert!(run.stderr.contains("failed: rough (read and prepare): "), "{}", run.stderr);
    let index = place.json("out/small/v0002/atlas.json");
    let stale = |index: &Value| index["specimens"][0]["stale"].as_str().map(str::to_owned);
    assert!(stale(&index).unwrap().contains("rough.tif: "), "{index}");
    assert_eq!(index["specimens"][1].get("stale"), None);
    let kept = timeless(&place, "v0002");
    assert!(good.iter().filter(|(name, _)| name.starts_with("rough/")).all(|(name, bytes)| kept[name] == *bytes));
    place.call("verify out/small").ended(0);
    let page = fs::read_to_string(place.path("out/small/v0002/report.json")).unwrap();
    assert!(page.contains("\"stale\": \""));

    // Again: the same, and nothing new.
    let run = place.call("--quiet run m.toml").ended(1);
    assert!(run.stdout.contains("v0002 holds the same already"), "{}", run.stdout);
    // Mended: it is what it was, without a mark.
    fs::write(place.path("rough.tif"), whole).unwrap();
    let run = place.call("--quiet run m.toml").ended(0);
    assert!(run.stdout.lines().next().unwrap().ends_with(": 2 unchanged"), "{}", run.stdout);
    assert_eq!(stale(&place.json("out/small/v0003/atlas.json")), None);
}

#[test]
fn the_manifest_chooses_what_becomes_of_a_specimen_that_fails() {
    let place = Place::with_scans();
    place.publish(&usual());
    cut(&place, "rough.tif");
    let manifest =
        |choice: &str| usual().replace("out = \"out\"\n", &format!("out = \"out\"\non_failure = \"{choice}\"\n"));
    place.write("m.toml", &manifest("stop"));
    let run = place.call("--quiet run m.toml").ended(1);
    assert!(run.stdout.is_empty() && run.stderr.starts_with("error: rough.tif: "), "{}{}", run.stdout, run.stderr);
    assert_eq!(place.versions(), ["latest", "v0001"]);
    place.write("m.toml", &manifest("drop"));
    place.call("--quiet run m.toml").ended(1);
    let index = place.json("out/small/v0002/atlas.json");
    assert_eq!(index["specimens"].as_array().unwrap().len(), 1);
    assert!(!place.path("out/small/v0002/rough").exists());
}

#[test]
fn parts_made_apart_and_merged_are_the_atlas_of_one_machine() {
    let place = Place::with_scans();
    place.publish(&usual());
    let whole = timeless(&place, "v0001");
    fs::rename(place.path("out/small"), place.path("out/alone")).unwrap();
    let merge = place.call("--quiet merge m.toml").ended(1);
    assert!(merge.stderr.contains("rough (take from the store): it has not been made yet"), "{}", merge.stderr);
    assert!(place.versions().is_empty());
    let only = place.call("run m.toml --only wave").ended(0);
    assert_eq!(only.stdout, "1 made\n");
    assert_eq!(place.call("list --missing m.toml").ended(0).stdout, "rough\n");
    // The lock is nobody's concern; and what is there is not made again.
    let held = diffraction_atlas::stages::archive::publish::begin(&place.path("out/small")).unwrap();
    let mut made = 0;
    for part in 1..=3 {
        let run = place.call(&format!("--quiet run m.toml --shard {part}/3")).ended(0).stdout;
        made += usize::from(run.contains("1 made"));
        assert!(!run.contains("2 "), "{run}");
    }
    assert_eq!(made, 1, "rough, for wave was there");
    drop(held);
    assert_eq!(place.versions(), [".units"]);
    let merge = place.call("--quiet merge m.toml").ended(0).stdout;
    assert!(merge.starts_with("published out/small/v0001 in ") && merge.contains(": 2 unchanged"), "{merge}");
    assert!(timeless(&place, "v0001") == whole);
    assert_eq!(place.versions(), ["latest", "v0001"], "the store is empty");
    place.call("verify out/small --manifest m.toml").ended(0);
    place.call("run m.toml --only waves").ended(2);
}

#[test]
fn a_part_that_failed_tells_whoever_merges_why() {
    let place = Place::with_scans();
    cut(&place, "rough.tif");
    place.write("m.toml", &usual());
    let part = place.call("--quiet run m.toml --shard 1/1").ended(1);
    assert!(part.stderr.contains("failed: rough (read and prepare): rough.tif: "), "{}", part.stderr);
    let merge = place.call("--quiet merge m.toml").ended(1);
    assert!(merge.stderr.contains("failed: rough (read and prepare): rough.tif: "), "{}", merge.stderr);
    assert!(merge.stdout.contains(": 1 unchanged, 1 failed"), "{}", merge.stdout);
}

#[test]
fn a_run_that_was_interrupted_goes_on_where_it_was() {
    let place = Place::with_scans();
    place.write("m.toml", &usual());
    place.call("--quiet run m.toml --only rough").ended(0);
    let unit = fs::read_dir(place.path("out/small/.units")).unwrap().next().unwrap().unwrap().path();
    let run = place.publish(&usual()).stdout;
    assert!(run.lines().next().unwrap().ends_with(": 1 made, 1 unchanged"), "{run}");
    assert!(!unit.exists());
    // A damaged one is made again.
    fs::remove_dir_all(place.path("out/small")).unwrap();
    place.call("--quiet run m.toml --only rough").ended(0);
    let table = unit.join("table.000.exr");
    let mut bytes = fs::read(&table).unwrap();
    bytes[1000] ^= 1;
    fs::write(&table, bytes).unwrap();
    let run = place.publish(&usual()).stdout;
    assert!(run.lines().next().unwrap().ends_with(": 2 made"), "{run}");
    place.call("verify out/small --manifest m.toml").ended(0);
}

#[test]
fn lines_of_json_and_a_log_tell_what_was_done() {
    let place = Place::with_scans();
    cut(&place, "wave.tif");
    place.write("m.toml", &[HEAD, LASERS, ROUGH, WAVE].concat());
    let run = place.call("--quiet run m.toml --json-lines --log run.log").ended(1);
    let lines: Vec<Value> = run.stdout.lines().map(|line| serde_json::from_str(line).unwrap()).collect();
    let outcome = |name: &str| lines.iter().find(|line| line["name"] == name).unwrap()["outcome"].clone();
    assert_eq!((outcome("rough"), outcome("wave")), ("made".into(), "failed".into()));
    let last = lines.last().unwrap();
    assert_eq!((&last["event"], &last["published"]["version"]), (&"run".into(), &"v0001".into()));
    assert_eq!((&last["specimens"]["made"], &last["failures"][0]["specimen"]), (&1.into(), &"wave".into()));
    let log = fs::read_to_string(place.path("run.log")).unwrap();
    assert!(log.contains("Z {\"event\":\"run\"") && log.contains("Z wave (read and prepare): wave.tif: "), "{log}");
}

#[test]
fn old_versions_go_and_what_the_newest_shares_with_them_stays() {
    let place = Place::with_scans();
    for n in ["1.5", "1.6", "1.7"] {
        place.publish(&[HEAD, LASERS, &ROUGH.replace("1.5", n), WAVE].concat());
    }
    let newest = contents(&place.path("out/small/v0003"));
    let listed = place.call("list out/small").ended(0).stdout;
    assert!(listed.lines().nth(1).unwrap().contains(" held by no other): "), "{listed}");
    let said = place.call("prune out/small --keep 1 --dry-run").ended(0).stdout;
    assert_eq!((said.as_str(), place.versions().len()), ("would remove v0001, v0002\n", 4));
    // Somebody still looks at an old one.
    fs::write(place.path("out/small/latest"), "v0001\n").unwrap();
    assert_eq!(place.call("prune out/small --keep 1").ended(0).stdout, "removed v0002\n");
    assert_eq!(place.versions(), ["latest", "v0001", "v0003"]);
    assert!(contents(&place.path("out/small/v0003")) == newest);
    let held = diffraction_atlas::stages::archive::publish::begin(&place.path("out/small")).unwrap();
    place.call("prune out/small --keep 1").ended(75);
    drop(held);
    assert_eq!(place.call("prune out/small --keep 1").ended(0).stdout, "removed v0001\n");
    place.call("verify out/small").ended(0);
    place.call("prune out --keep 1").ended(2);
    place.call("prune out/small --keep 0").ended(2);
}
