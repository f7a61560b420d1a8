//! Textures in KTX 2.0 files, as a reader that shares no code with the writer finds them.

use std::collections::BTreeMap;
use std::path::Path;

use ktx2::dfd::{Basic, Block};
use ktx2::{Format, Reader};
use serde_json::Value;

use crate::exported::exported;

/// Textures of a specimen: index, name there, name of the files, and format.
const TEXTURES: [(&str, &str, &str, Format); 8] = [
    ("textures.json", "tables", "tables", Format::R16G16B16A16_SFLOAT),
    ("textures.json", "cross_terms", "cross_terms", Format::R16G16B16A16_SFLOAT),
    ("textures.json", "lobe", "lobe", Format::R32G32B32A32_SFLOAT),
    ("textures.json", "lobe_gaussians", "lobe_gaussians", Format::R32G32B32A32_SFLOAT),
    ("textures.json", "sampling", "sampling", Format::R32_SFLOAT),
    ("spectral_textures.json", "tables", "spectral_tables", Format::R16G16B16A16_SFLOAT),
    ("spectral_textures.json", "cross_terms", "spectral_cross_terms", Format::R16G16B16A16_SFLOAT),
    ("spectral_textures.json", "lobe", "spectral_lobe", Format::R32_SFLOAT),
];

fn index(folder: &Path, name: &str) -> Value {
    serde_json::from_slice(&std::fs::read(folder.join(name)).unwrap()).unwrap()
}

/// Levels of the bytes to upload: the finest, and the coarser ones one after another.
fn raw_levels(folder: &Path, about: &Value) -> Vec<Vec<u8>> {
    let read = |about: &Value| std::fs::read(folder.join(about["file"].as_str().unwrap())).unwrap();
    let finest = read(about);
    let [width, height, layers]: [usize; 3] = serde_json::from_value(about["width_height_layers"].clone()).unwrap();
    let texel = finest.len() / (width * height * layers);
    let mut levels = vec![finest];
    if !about["coarser"].is_null() {
        let (bytes, mut at) = (read(&about["coarser"]), 0);
        let sizes: Vec<[usize; 2]> = serde_json::from_value(about["coarser"]["width_height"].clone()).unwrap();
        for [width, height] in sizes {
            let end = at + texel * layers * width * height;
            levels.push(bytes[at..end].to_vec());
            at = end;
        }
        assert_eq!(at, bytes.len());
    }
    levels
}

/// The descriptor is the one of its format, but for primaries: numbers of tables are no colours.
fn check_descriptor(reader: &Reader<Vec<u8>>, format: Format) {
    let [Block::Basic(found)] = reader.dfd_blocks() else { panic!("{:?}", reader.dfd_blocks()) };
    let (mut expected, type_size) = Basic::from_format(format).unwrap();
    assert_ne!(found.to_vec(), expected.to_vec(), "primaries make no difference");
    expected.color_primaries = None;
    assert_eq!(found.to_vec(), expected.to_vec());
    assert_eq!(reader.header().type_size, type_size);
}

#[test]
fn containers_hold_what_is_uploaded() {
    let (_raw_place, raw) = exported(&["--form", "shaders"]);
    let (_place, contained) = exported(&["--form", "shaders", "--ktx2"]);
    let [raw, contained] = [raw, contained].map(|folder| folder.join("wave"));
    for (index_name, name, file, format) in TEXTURES {
        let [plain, about] = [&raw, &contained].map(|folder| index(folder, index_name)[name].clone());
        assert_eq!(about["file"], format!("{file}.ktx2"));
        let bytes = std::fs::read(contained.join(format!("{file}.ktx2"))).unwrap();
        let reader = Reader::new(bytes.clone()).unwrap();
        let header = reader.header();
        let [width, height, layers]: [u32; 3] = serde_json::from_value(plain["width_height_layers"].clone()).unwrap();
        let is_array = plain["kind"] == "2D array texture";
        assert_eq!((header.format, header.supercompression_scheme), (Some(format), None), "{file}");
        assert_eq!(
            [header.pixel_width, header.pixel_height, header.pixel_depth, header.face_count],
            [width, height, 0, 1]
        );
        assert_eq!(header.layer_count, if is_array { layers } else { 0 }, "{file}");
        check_descriptor(&reader, format);
        let levels: Vec<Vec<u8>> = reader.levels().map(|level| level.data.to_vec()).collect();
        assert!(levels == raw_levels(&raw, &plain), "{file}: other bytes");
        assert!(
            is_array == (levels.len() > 1) || format == Format::R16G16B16A16_SFLOAT,
            "{file}: {} levels",
            levels.len()
        );
        let keys: BTreeMap<&str, &[u8]> = reader.key_value_data().collect();
        assert_eq!(keys["KTXorientation"], b"rd\0");
        assert!(keys["KTXwriter"].starts_with(b"diffraction-atlas "));
        assert!(Reader::new(bytes[..bytes.len() - 1].to_vec()).is_err(), "{file}: a byte less goes unseen");
        let mut other = bytes;
        let last = other.len() - 1;
        other[last] ^= 1;
        let other = Reader::new(other).unwrap().levels().map(|level| level.data.to_vec()).collect::<Vec<_>>();
        assert!(other != raw_levels(&raw, &plain), "{file}: one bit goes unseen");
    }
    let is_raw = |name: &str| name.ends_with("16f") || name.ends_with("32f");
    let names = std::fs::read_dir(&contained).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    assert!(!names.into_iter().any(|name| is_raw(&name)), "textures are written twice");
}
