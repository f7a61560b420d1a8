//! The fuzz targets' readers on their corpus and on a few mutations of it, the same each time: what longer fuzzing found stays mended.

use std::path::{Path, PathBuf};

use crate::readers::READERS;
use crate::skip::test_data;

/// Mutations of each file; fuzzing itself does millions (CONTRIBUTING.md).
const MUTATIONS: usize = 60;

/// Files that a reader's fuzzing starts from.
fn corpus(name: &str) -> Vec<(PathBuf, Vec<u8>)> {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("fuzz/corpus").join(name);
    // Scans are those that other tests read.
    let folders = if name == "scan" { vec![own, test_data("formats"), test_data("foreign")] } else { vec![own] };
    let mut files: Vec<PathBuf> = folders
        .iter()
        .flat_map(|folder| std::fs::read_dir(folder).unwrap())
        .map(|entry| entry.unwrap().path())
        .collect();
    files.sort();
    files.into_iter().map(|path| (path.clone(), std::fs::read(path).unwrap())).collect()
}

/// Bytes changed, cut, doubled and put together with those of another file.
fn mutated(bytes: &[u8], other: &[u8], random: &mut fastrand::Rng) -> Vec<u8> {
    const TELLING: [&[u8]; 8] =
        [b"\xff\xff\xff\xff", b"\0\0\0\0", b"\x7f\xff\xff\xff", b"-1", b"1e308", b"NaN", b"\"", b"\n"];
    let mut bytes = bytes.to_vec();
    for _ in 0..random.usize(1..5) {
        let at = random.usize(0..=bytes.len());
        match random.u8(0..6) {
            0 => bytes.truncate(at),
            1 => bytes.extend_from_slice(&other[other.len() - at.min(other.len())..]),
            2 => drop(bytes.splice(at..at, TELLING[random.usize(0..TELLING.len())].iter().copied())),
            3 => drop(bytes.drain(at..(at + random.usize(0..40)).min(bytes.len()))),
            _ => bytes.get_mut(at).into_iter().for_each(|byte| *byte = random.u8(..)),
        }
    }
    bytes
}

#[test]
fn no_reader_panics_on_its_corpus_or_near_it() {
    replay(19, MUTATIONS);
}

#[test]
#[ignore = "slow: as the one above, a hundred times as many"]
fn no_reader_panics_far_from_its_corpus() {
    replay(20, 100 * MUTATIONS);
}

/// Every reader on its corpus and so many mutations of each file.
fn replay(seed: u64, mutations: usize) {
    let mut random = fastrand::Rng::with_seed(seed);
    for (name, reader) in READERS {
        let corpus = corpus(name);
        assert!(corpus.len() >= 3, "{name} has a corpus");
        for (_, bytes) in &corpus {
            reader(bytes);
            for _ in 0..mutations {
                let other = &corpus[random.usize(0..corpus.len())].1;
                reader(&mutated(bytes, other, &mut random));
            }
        }
    }
}

#[test]
fn the_corpus_is_worth_mutating() {
    // Of every reader some file is read as a good one, or fuzzing would not come past the first check.
    let accepted = |name: &str, is_good: &dyn Fn(&Path, &[u8]) -> bool| {
        let good = corpus(name).iter().filter(|(path, bytes)| is_good(path, bytes)).count();
        assert!(good > 0, "{name}: no file of the corpus is good");
    };
    let folder = tempfile::tempdir().unwrap();
    let put = |name: &str, bytes: &[u8]| {
        let path = folder.path().join(name);
        std::fs::write(&path, bytes).unwrap();
        path
    };
    put("scan.tif", b"");
    accepted("manifest", &|_, bytes| {
        let text = String::from_utf8_lossy(bytes);
        diffraction_atlas::manifest::parse(&text, &folder.path().join("m.toml").display().to_string()).is_ok()
    });
    accepted("picture", &|_, bytes| diffraction_brdf::exr_image::read_rgb(&put("p.exr", bytes)).is_ok());
    for (kind, name) in ["m.obj", "m.gltf", "m.glb"].iter().enumerate() {
        accepted("mesh", &|_, bytes| {
            usize::from(bytes[0]) % 3 == kind
                && diffraction_render::scene::mesh_file::read(&put(name, &bytes[1..])).is_ok()
        });
    }
    accepted("picture", &|_, bytes| {
        diffraction_render::scene::environment::load(&put("p.exr", bytes), 0.0, 1.0).is_ok()
    });
    accepted("atlas", &|_, bytes| {
        put("atlas.json", &bytes[1..]);
        bytes[0] % 4 == 0 && diffraction_brdf::atlas::read_index(folder.path()).is_ok()
    });
}
