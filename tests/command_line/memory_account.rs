//! What `plan` says of a run's memory, held against the most that the process held, and what does not fit refused.

use crate::place::{Place, rough};

/// A run to measure: a rough surface of so many samples, and what the manifest says of it.
struct Case {
    name: &'static str,
    samples: usize,
    specimens: usize,
    manifest: &'static str,
}

/// Most that a prediction may be off, as a share of what was measured.
const OFF_MAX: f64 = 0.15;

const BALL: &str = "[[scene]]\nname = \"ball\"\nshape = \"sphere\"\nsize_px = 128\n";

const fn case(name: &'static str, samples: usize, specimens: usize, manifest: &'static str) -> Case {
    Case { name, samples, specimens, manifest }
}

/// The first three are those of every day. A line `BALL` stands for a scene, and without one there is none.
const CASES: [Case; 13] = [
    case("small", 128, 1, "[tables]\nsize = 301\n"),
    case("one kind of tables", 512, 1, "[tables]\nsize = 401\nhold = [\"xyz\"]\n"),
    case("several specimens", 256, 4, "[tables]\nsize = 401\nBALL"),
    case("spectral alone", 512, 1, "[tables]\nsize = 401\nhold = [\"spectral\"]\n"),
    case("larger", 1024, 1, "[tables]\nsize = 601\n"),
    case("without the reference", 1024, 1, "[tables]\nsize = 601\n[report]\nreference = false\n"),
    case("large scan", 4096, 1, "[tables]\nsize = 301\n[report]\nreference = false\n"),
    case("large tables", 256, 1, "[tables]\nsize = 2001\n[report]\nreference = false\n"),
    case("floats", 256, 1, "[tables]\nsize = 1001\nstorage = \"float\"\n"),
    case("restricted", 512, 1, "[tables]\nsize = 601\nserve = \"scenes\"\nBALL"),
    case("pictures", 256, 1, "[tables]\nsize = 601\nBALL"),
    case("one window", 1024, 1, "[tables]\nsize = 301\n[optics]\nwindows = \"centre\"\n"),
    case("on a GPU", 256, 1, "[tables]\nsize = 401\n[gpu]\ncheck = \"auto\"\nBALL"),
];

impl Case {
    /// The manifest, of tables of another size where one is given.
    fn manifest(&self, size: Option<usize>) -> String {
        let (section, scene) = match self.manifest.split_once("BALL") {
            Some((section, _)) => (section.to_owned(), BALL),
            None => (self.manifest.to_owned(), ""),
        };
        let section = match size {
            Some(size) => section.lines().map(|line| format!("{}\n", resized(line, size))).collect(),
            None => section,
        };
        let none = if scene.is_empty() { "scene = []\n" } else { "" };
        let is_inside = section.contains("centre");
        let edge = if is_inside { ", edge = \"fade\"" } else { "" };
        let optics = format!("material = {{ n = 1.56 }}\ncoherence = {{ sigma_um = 2{edge} }}\n");
        let section = match is_inside {
            true => section.replace("[optics]\n", &format!("[optics]\n{optics}")),
            false => format!("[optics]\n{optics}{section}"),
        };
        let gpu = if section.contains("[gpu]") { "" } else { "[gpu]\ncheck = \"off\"\n" };
        format!(
            "schema = 1\n{none}[atlas]\nname = \"a\"\nout = \"out\"\n{section}{gpu}[[specimen]]\nname = \"{{file}}\"\nscans = \"s*.tif\"\n{scene}"
        )
    }

    fn place(&self) -> Place {
        let place = Place::empty();
        for seed in 1..=self.specimens {
            place.scan(&format!("s{seed}.tif"), rough(seed as u64), [self.samples; 2], [60.0; 2]);
        }
        place.write("m.toml", &self.manifest(None));
        place
    }
}

fn resized(line: &str, size: usize) -> String {
    if line.starts_with("size = ") { format!("size = {size}") } else { line.to_owned() }
}

fn predicted_mib(place: &Place) -> f64 {
    place.call("plan m.toml --json").ended(0).json()["memory_mib"].as_f64().unwrap()
}

/// Most that the process of a run held, and what was predicted.
fn measured_mib(case: &Case, place: &Place) -> [f64; 2] {
    let predicted = predicted_mib(place);
    place.call("--quiet run m.toml").ended(0);
    let measured = place.json("out/a/v0001/report.json")["peak_memory_mib"].as_f64().unwrap();
    println!("{:24} {predicted:6.0} MiB predicted, {measured:6.0} held: {:.2}", case.name, predicted / measured);
    [predicted, measured]
}

fn is_off([predicted, measured]: [f64; 2]) -> bool {
    (predicted / measured - 1.0).abs() > OFF_MAX
}

#[test]
#[cfg(target_os = "linux")]
fn memory_of_a_run_is_predicted() {
    for case in &CASES[..3] {
        let place = case.place();
        let [predicted, measured] = measured_mib(case, &place);
        assert!(!is_off([predicted, measured]), "{}: {predicted} {measured}", case.name);
        // Of tables half as wide again the prediction is another.
        place.write("m.toml", &case.manifest(Some(701)));
        let other = predicted_mib(&place);
        assert!(is_off([other, measured]), "{}: {other} {measured}", case.name);
    }
}

#[test]
#[ignore = "slow: thirteen runs, up to 4096 samples and 2001 texels a side"]
#[cfg(target_os = "linux")]
fn memory_of_every_kind_of_run_is_predicted() {
    let all: Vec<_> = CASES.iter().map(|case| (case.name, measured_mib(case, &case.place()))).collect();
    let off: Vec<_> = all.into_iter().filter(|(_, mib)| is_off(*mib)).collect();
    assert!(off.is_empty(), "{off:?}");
}

#[test]
fn what_does_not_fit_is_refused_before_it_is_computed() {
    let case = &CASES[0];
    let place = case.place();
    let needed = predicted_mib(&place);
    for (allowed, status) in [(needed - 1.0, 1), (needed, 0)] {
        let planned = place.call(&format!("plan m.toml --memory {allowed}")).ended(status);
        let run = place.call(&format!("--quiet run m.toml --memory {allowed}")).ended(status);
        let messages = [planned.stdout + &planned.stderr, run.stderr];
        if status == 1 {
            for message in messages {
                for part in ["s1", "--memory", &needed.to_string(), &allowed.to_string(), "tables.size"] {
                    assert!(message.contains(part), "{part}: {message}");
                }
            }
            assert!(!place.path("out/a/v0001").exists());
        }
    }
    // Building has an allowance of its own.
    let manifest = case.manifest(Some(1401)).replace("[tables]\n", "[tables]\nmemory_mib = 64\n");
    place.write("m.toml", &manifest);
    let said = [place.call("plan m.toml").ended(1).stderr, place.call("--quiet run m.toml").ended(1).stderr];
    assert!(said.iter().all(|said| said.contains("memory_mib") && said.contains("64 MiB")), "{said:?}");
}
