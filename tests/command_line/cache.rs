//! What a run finds again of an earlier one, and that nothing published depends on it.

use std::collections::BTreeMap;

use diffraction_brdf::atlas;
use serde_json::Value;

use crate::place::{HEAD, LASERS, Place, ROUGH, SCENES, WAVE, contents, usual};

/// Files of a version whose bytes depend on inputs and program alone.
fn timeless(place: &Place, version: &str) -> BTreeMap<String, Vec<u8>> {
    let mut files = contents(&place.path(&format!("out/small/{version}")));
    files.retain(|name, _| !atlas::may_differ(name) && name != "atlas.json");
    files
}

/// What the report of a version says of the cache.
fn used(place: &Place, version: &str) -> [u64; 4] {
    let cache = &place.json(&format!("out/small/{version}/report.json"))["cache"];
    ["tables_found", "tables_built", "pairs_found", "pairs_computed"].map(|key| cache[key].as_u64().unwrap())
}

fn entries(place: &Place) -> usize {
    std::fs::read_dir(place.path("out/.cache")).map_or(0, |entries| entries.count())
}

/// The usual run, then again with the published version out of the way.
fn twice(between: impl FnOnce(&Place)) -> (Place, BTreeMap<String, Vec<u8>>) {
    let place = Place::with_scans();
    place.publish(&usual());
    let cold = timeless(&place, "v0001");
    std::fs::rename(place.path("out/small"), place.path("out/first")).unwrap();
    between(&place);
    (place, cold)
}

#[test]
fn the_bytes_are_the_same_cold_warm_damaged_and_without() {
    let (place, cold) = twice(|_| ());
    let again = || {
        let _ = std::fs::remove_dir_all(place.path("out/small"));
        place.publish(&usual());
        assert!(timeless(&place, "v0001") == cold);
    };
    again();
    let [tables_found, tables_built, found, computed] = used(&place, "v0001");
    assert_eq!((tables_found, tables_built, computed), (2, 0, 0));
    assert!(found > 700, "{found} pairs");

    for entry in std::fs::read_dir(place.path("out/.cache")).unwrap() {
        let path = entry.unwrap().path();
        let mut bytes = std::fs::read(&path).unwrap();
        let middle = bytes.len() / 2;
        bytes[middle] ^= 1;
        std::fs::write(&path, bytes).unwrap();
    }
    again();
    let [tables_found, tables_built, found_in_damaged, computed] = used(&place, "v0001");
    assert_eq!((tables_found, tables_built), (0, 2));
    // A direction that several samples share is computed once.
    assert!(computed > 700 && found_in_damaged < found, "{computed} pairs");

    std::fs::remove_dir_all(place.path("out/small")).unwrap();
    place.call("--quiet run m.toml --no-cache").ended(0);
    assert!(timeless(&place, "v0001") == cold);
    assert_eq!(place.json("out/small/v0001/report.json")["cache"], Value::Null);
}

#[test]
fn a_changed_scene_computes_its_new_pairs_alone() {
    let (place, _) = twice(|_| ());
    let lit = usual().replace("light = { direction = [0, 0, 1] }", "light = { direction = [0, 0.6, 0.8] }");
    assert_ne!(lit, usual());
    place.publish(&lit);
    let [tables_found, tables_built, found, computed] = used(&place, "v0001");
    assert_eq!((tables_found, tables_built), (2, 0));
    // Two specimens, the map's pixels within its disc, two directions of its light; the ball and the error rows are known.
    let across = |n: u64| (n as f64 + 0.5) / 8.0 - 1.0;
    let in_disc = |n: &u64| across(n / 16).hypot(across(n % 16)) < 1.0;
    assert_eq!(computed, 2 * (0..256).filter(in_disc).count() as u64 * 2);
    assert!(found > 2 * 384, "{found} pairs");
    let warm = timeless(&place, "v0001");
    std::fs::remove_dir_all(place.path("out/small")).unwrap();
    place.call("--quiet run m.toml --no-cache").ended(0);
    assert!(timeless(&place, "v0001") == warm);
}

/// Tables restricted to scenes are built again for a changed one; the values of the reference stay those of the pixels that
/// have not changed.
#[test]
fn a_changed_scene_builds_restricted_tables_again() {
    let restricted = |light: &str| {
        let scenes = SCENES.replace("light = { direction = [0, 0, 1] }", light);
        let tables = LASERS.replace("size = 65\n", "size = 65\nserve = \"scenes\"\n");
        [HEAD, &tables, ROUGH, WAVE, &scenes].concat()
    };
    let place = Place::with_scans();
    place.publish(&restricted("light = { direction = [0, 0, 1] }"));
    let first = timeless(&place, "v0001");
    place.write("m.toml", &restricted("light = { direction = [0, 0.05, 1] }"));
    place.call("--quiet run m.toml").ended(0);
    let [tables_found, tables_built, found, computed] = used(&place, "v0002");
    // The ball's pixels; its directions are drawn anew for the error rows.
    assert!((tables_found, tables_built) == (0, 2) && found > 0, "{found} of {} pairs", found + computed);
    let warm = timeless(&place, "v0002");
    assert!(warm != first);
    std::fs::remove_dir_all(place.path("out/small")).unwrap();
    place.call("--quiet run m.toml --no-cache").ended(0);
    assert!(timeless(&place, "v0001") == warm);
}

#[test]
fn a_changed_scan_concerns_its_specimen_alone() {
    let (place, _) = twice(|place| std::fs::copy(place.path("bumps.tif"), place.path("rough.tif")).map(drop).unwrap());
    place.publish(&usual());
    let [tables_found, tables_built, found, computed] = used(&place, "v0001");
    assert_eq!((tables_found, tables_built), (1, 1));
    assert!(found > 384 && computed > 384, "{found} found, {computed} computed");
}

#[test]
fn the_cache_is_shown_cleared_moved_and_switched_off() {
    let place = Place::with_scans();
    place.publish(&usual());
    let shown = place.call("cache m.toml").ended(0).stdout;
    assert_eq!(entries(&place), 8, "tables, pictures, errors and direct sum of two specimens");
    assert!(shown.starts_with("out/.cache: 8 entries, ") && shown.ends_with("of 1024 MiB\n"), "{shown}");
    let cleared = place.call("cache m.toml --clear").ended(0).stdout;
    assert!(cleared.starts_with("out/.cache: removed 8 entries"), "{cleared}");
    assert_eq!(entries(&place), 0);
    // What is published already is not made again.
    let forget = || std::fs::remove_dir_all(place.path("out/small")).unwrap();
    forget();
    place.publish(&(usual() + "[cache]\nlimit_mib = 0\n"));
    assert_eq!(entries(&place), 0);
    forget();
    place.publish(&(usual() + "[cache]\nfolder = \"kept\"\n"));
    assert_eq!(entries(&place), 0);
    assert!(place.call("cache m.toml").ended(0).stdout.starts_with("kept: 8 entries"));
}
