//! The shape of the workspace: no two files use each other in a circle, none uses a floor above its own, and what documents name is
//! there.
//!
//! The sources are read as text: `use` lines, and paths that begin with `crate`, `super`, `self`, another member of the
//! workspace, or a name that a `use` line brought in; modules called `tests` are passed over. A path belongs to the file of the longest part of it that is a module.

#[path = "architecture/documents.rs"]
mod documents;
#[path = "architecture/graph.rs"]
mod graph;
#[path = "architecture/source.rs"]
mod source;

use std::fs;
use std::path::Path;

use documents::{dead_names, dead_paths};
use graph::{Arrow, circles, upward};
use source::{Source, arrows};

/// Floors of a crate, from the lowest up; a file or folder on one floor uses those below, and no neighbour.
struct Floors {
    /// The crate's folder, empty for the root.
    folder: &'static str,
    /// Names of files without ending, or of folders, floor by floor.
    floors: &'static [&'static [&'static str]],
}

/// Crates that are not named here are one floor each.
const FLOORS: [Floors; 4] = [
    Floors { folder: "crates/build", floors: &[&["ground"], &["height"], &["optics"], &["tables"], &["accuracy"]] },
    Floors { folder: "crates/study", floors: &[&["error"], &["baselines"], &["study"], &["stability"]] },
    Floors { folder: "crates/render", floors: &[&["error"], &["scene"], &["render"]] },
    Floors { folder: "", floors: &[&["error"], &["stages"], &["manifest", "report"], &["cli"], &["main"]] },
];

/// Crates from the lowest up. Cargo forbids circles among them, but lets a crate's tests use one that stands above it.
const CRATES: [&[&str]; 4] = [&["brdf"], &["build"], &["render", "study"], &["atlas"]];

/// Every source of the workspace, tests and examples aside, with its path from the root.
fn sources() -> Vec<Source> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut sources = Vec::new();
    let mut add = |folder: &str| {
        let name = if folder.is_empty() {
            "diffraction_atlas".into()
        } else {
            format!("diffraction_{}", folder.rsplit('/').next().unwrap())
        };
        collect(&root.join(folder).join("src"), &mut |path, text| {
            let path = path.strip_prefix(root).unwrap().to_str().unwrap().replace('\\', "/");
            sources.push(Source { crate_name: name.clone(), path, text });
        });
    };
    add("");
    let mut crates: Vec<_> = fs::read_dir(root.join("crates")).unwrap().map(|entry| entry.unwrap().path()).collect();
    crates.sort();
    for path in crates {
        add(&format!("crates/{}", path.file_name().unwrap().to_str().unwrap()));
    }
    sources
}

fn collect(folder: &Path, found: &mut impl FnMut(&Path, String)) {
    collect_ending(folder, "rs", found);
}

fn collect_ending(folder: &Path, wanted: &str, found: &mut impl FnMut(&Path, String)) {
    let mut paths: Vec<_> = fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    for path in paths {
        if path.is_dir() {
            collect_ending(&path, wanted, found);
        } else if path.extension().is_some_and(|ending| ending == wanted) {
            let text = fs::read_to_string(&path).unwrap();
            found(&path, text);
        }
    }
}

/// All that is wrong, a line each.
fn complaints(sources: &[Source]) -> Vec<String> {
    let arrows: Vec<Arrow> = arrows(sources);
    let mut wrong: Vec<String> = circles(&arrows)
        .iter()
        .map(|(files, way)| format!("a circle among {files} files: {}", way.join(" -> ")))
        .collect();
    for Floors { folder, floors } in FLOORS {
        wrong.extend(upward(&arrows, folder, floors));
    }
    wrong
}

#[test]
fn no_file_is_in_a_circle_and_none_uses_a_floor_above() {
    let sources = sources();
    assert!(sources.len() > 200, "only {} sources were found", sources.len());
    let wrong = complaints(&sources);
    assert!(wrong.is_empty(), "{} faults:\n{}", wrong.len(), wrong.join("\n"));
}

/// Crates of the workspace that a manifest names without standing above them, by the rank of its own.
fn crates_not_below(manifest: &str, rank: usize) -> Vec<&'static str> {
    let named = |name: &&str| manifest.lines().any(|line| line.starts_with(&format!("diffraction-{name}")));
    CRATES[rank..].concat().into_iter().filter(named).collect()
}

#[test]
fn no_crate_uses_one_that_is_not_below_it_in_its_tests_either() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("crates");
    let mut found: Vec<_> = fs::read_dir(&root).unwrap().map(|entry| entry.unwrap().file_name()).collect();
    found.sort();
    assert_eq!(found, ["brdf", "build", "render", "study"], "CRATES names them all");
    for (rank, names) in CRATES.iter().enumerate().take(3) {
        for name in *names {
            let manifest = fs::read_to_string(root.join(name).join("Cargo.toml")).unwrap();
            assert_eq!(crates_not_below(&manifest, rank), [""; 0], "{name}");
        }
    }
    let tested_from_above =
        "[dependencies]\ndiffraction-brdf.workspace = true\n[dev-dependencies]\ndiffraction-build = \"1\"\n";
    assert_eq!(crates_not_below(tested_from_above, 0), ["brdf", "build"]);
    assert_eq!(crates_not_below(tested_from_above, 1), ["build"]);
    assert_eq!(crates_not_below(tested_from_above, 2), [""; 0]);
}

/// What must be seen on the real sources for the test above to mean anything.
#[test]
fn arrows_that_are_known_to_be_there_are_found() {
    let arrows = arrows(&sources());
    let is_there = |from: &str, to: &str| arrows.iter().any(|arrow| arrow.from == from && arrow.to == to);
    assert!(is_there("src/main.rs", "src/cli/mod.rs"));
    assert!(is_there("src/cli/mod.rs", "src/cli/commands/run.rs"));
    assert!(is_there("src/cli/commands/run.rs", "crates/render/src/render/png_image.rs"));
    assert!(is_there("crates/build/src/tables/build.rs", "crates/build/src/optics/spectra.rs"));
}

fn made_up(files: &[(&str, &str)]) -> Vec<Source> {
    let source = |(path, text): &(&str, &str)| {
        let folder = path.split_once("src/").unwrap().0.trim_end_matches('/');
        let crate_name = match folder.rsplit_once('/') {
            None => "diffraction_atlas".into(),
            Some((_, last)) => format!("diffraction_{last}"),
        };
        Source { crate_name, path: (*path).into(), text: (*text).into() }
    };
    files.iter().map(source).collect()
}

#[test]
fn a_circle_is_named_however_it_is_written() {
    let uses = [
        "use super::b::{self, X};",
        "use crate::stages::b;",
        "use crate::stages::{e::{V, W}, b::{X as Z}};",
        "use super::*; fn f() { crate::stages::b::go() }",
        "fn f(x: super::b::X) {}",
        "mod within { use super::super::b::X; }",
        "use crate::stages; fn f() { stages::b::go() }",
    ];
    for text in uses {
        let wrong = complaints(&made_up(&[
            ("src/lib.rs", "pub mod stages;"),
            ("src/stages/mod.rs", "pub mod a; pub mod b; pub mod c;"),
            ("src/stages/a.rs", text),
            ("src/stages/b.rs", "use super::c::Y;"),
            ("src/stages/c.rs", "use super::d::W; pub struct Y;"),
            ("src/stages/d.rs", "use super::a::W;"),
        ]));
        let files = ["a", "b", "c", "d", "a"].map(|name| format!("src/stages/{name}.rs"));
        assert_eq!(wrong, [format!("a circle among 4 files: {}", files.join(" -> "))], "{text}");
    }
}

#[test]
fn a_folder_that_hands_on_what_uses_it_is_a_circle() {
    let files = |within: &str| {
        made_up(&[
            ("src/stages/mod.rs", "pub mod gpu;"),
            ("src/stages/gpu/mod.rs", "mod check; pub use check::check; pub struct Config;"),
            ("src/stages/gpu/check.rs", within),
        ])
    };
    let wrong = complaints(&files("use super::Config; pub fn check(_: Config) {}"));
    assert_eq!(
        wrong,
        ["a circle among 2 files: src/stages/gpu/check.rs -> src/stages/gpu/mod.rs -> src/stages/gpu/check.rs"]
    );
    assert!(complaints(&files("pub fn check() {}")).is_empty());
}

#[test]
fn arrows_up_the_floors_are_named() {
    let cases = [
        ("src/stages/a.rs", "use crate::cli::Global;", "src/cli/mod.rs"),
        ("src/manifest/b.rs", "use crate::report::svg::Svg;", "src/report/svg.rs"),
        ("crates/build/src/height/c.rs", "use crate::tables::plan::Plan;", "crates/build/src/tables/plan.rs"),
        ("crates/render/src/scene/d.rs", "fn f() { crate::render::cpu::shade() }", "crates/render/src/render/cpu.rs"),
    ];
    for (path, text, above) in cases {
        let wrong = complaints(&made_up(&[(path, text), (above, "")]));
        assert_eq!(wrong, [format!("{path} uses {above}, which is no lower floor")]);
    }
    let unknown = complaints(&made_up(&[("src/attic/a.rs", "use crate::cli::X;"), ("src/cli/mod.rs", "")]));
    assert_eq!(unknown, ["src/attic/a.rs is on no floor"]);
}

#[test]
fn what_is_no_arrow_is_none() {
    let quiet = [
        "// use crate::stages::b;\n/* crate::stages::b::X */",
        "fn f() -> &'static str { \"crate::stages::b::X\" }",
        "fn f() -> &'static str { r#\"use \"crate::stages::b\";\"# }",
        "fn f<'a>(x: &'a str) -> char { '\"' } fn g() { std::b::X }",
        "mod b { pub struct X; } use self::b::X;",
        // What only a file's own tests use may lie above it.
        "mod tests { use super::super::b::X; fn f() { { crate::stages::b::go() } } }",
    ];
    for text in quiet {
        let files = [("src/stages/a.rs", text), ("src/stages/b.rs", "use super::a::Y;"), ("src/stages/mod.rs", "")];
        let wrong = complaints(&made_up(&files));
        assert!(wrong.is_empty(), "{text}: {wrong:?}");
    }
}

/// The documents that people read, from the root.
fn documents(root: &Path) -> Vec<String> {
    let mut found = vec!["README.md".to_owned(), "CONTRIBUTING.md".into(), "CHANGELOG.md".into()];
    for folder in ["docs", "examples", "specimens", "tests"] {
        collect_ending(&root.join(folder), "md", &mut |path, _| {
            found.push(path.strip_prefix(root).unwrap().to_str().unwrap().replace('\\', "/"));
        });
    }
    found
}

#[test]
fn what_documents_name_is_there() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let read = |document: &str| fs::read_to_string(root.join(document)).unwrap();
    let documents = documents(root);
    assert!(documents.iter().any(|name| name == "docs/optics.md"), "{documents:?}");
    let dead: Vec<String> = documents.iter().flat_map(|name| dead_paths(root, name, &read(name))).collect();
    assert!(dead.is_empty(), "{}", dead.join("\n"));
    let glossary = read("docs/glossary.md");
    assert_eq!(dead_names(root, &glossary), [""; 0]);

    let wrong =
        "`src/main.rs` and `src/attic.rs`, [here](optics.md#limits), [there](attic.md#limits), `vNNNN/src`, `src/*.rs`";
    let told = ["src/attic.rs", "attic.md"].map(|name| format!("docs/a.md names {name}, which is not there"));
    assert_eq!(dead_paths(root, "docs/a.md", wrong), told);
    let renamed = glossary.replace("`Restriction`", "`Restrictions`");
    assert_eq!(dead_names(root, &renamed), ["Restrictions is in none of `crates/brdf/src/table_set.rs`"]);
}

/// The one file that writes to the terminal cleans what it writes; whatever writes past it would not.
#[test]
fn all_output_passes_through_one_file() {
    let writes = |text: &str| {
        let code = text
            .split("mod tests {")
            .next()
            .unwrap_or(text)
            .lines()
            .filter(|line| !line.trim_start().starts_with("//"));
        let code: String = code.collect();
        ["println!", "print!(", "eprint!", "eprintln!", "io::stdout()", "io::stderr().lock()"]
            .iter()
            .any(|way| code.contains(way))
    };
    let sources = sources();
    let of_program = sources.iter().filter(|source| source.path.starts_with("src/"));
    let found: Vec<&str> =
        of_program.filter(|source| writes(&source.text)).map(|source| source.path.as_str()).collect();
    assert_eq!(found, ["src/cli/terminal.rs"]);
    assert!(writes("fn f() { println!(\"{name}\") }") && !writes("/// `println!` is not called."));
}
