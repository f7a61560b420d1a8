//! Formats that are known but not read: told apart by their content, refused by name, with the ways out.

use super::archive::Archive;
use super::refusal::Refusal;

/// What there is to do about a file of a microscope that is not read.
pub(super) const WAYS_OUT: &str = "open it in Gwyddion and save the height channel by \"File, Save as\" as Gwyddion simple field (.gsf), or \
                                   convert it, or a folder of such files, by `python3 tools/convert.py`";

/// First bytes and the format's name.
const FORMATS: &[(&[u8], &str)] = &[
    (b"\x89HDF\r\n\x1a\n", "HDF5 (TopoStats .topostats, Nanosurf .nhf, Asylum, DATX and others)"),
    (b"\xd0\xcf\x11\xe0\xa1\xb1\x1a\xe1", "a compound document (MountainsMap .mnt, Keyence, Omicron and others)"),
    (b"AliconaImaging\0", "Alicona .al3d"),
    (b"fileformat = bcr", "BCR-STM (.bcr, .bcrf)"),
    (b"\xff\xfef\0i\0l\0e\0f\0o\0r\0m\0a\0t\0", "BCR-STM (.bcr, .bcrf)"),
    (b"\xfe\xff\0f\0i\0l\0e\0f\0o\0r\0m\0a\0t", "BCR-STM (.bcr, .bcrf)"),
    (b"fileType", "Agilent or Molecular Imaging .mi"),
    (b"\x01\xb0\x93\xff", "NT-MDT .mdt"),
    (b"\x01\0Directory", "Wyko or Veeco .opd"),
    (b"VCA DATA\x01", "Bruker or Dektak .OPDx"),
    (b"VK3_", "Keyence .vk3"),
    (b"VK4_", "Keyence .vk4"),
    (b"VK6", "Keyence .vk6"),
    (b"VK7", "Keyence .vk7"),
    (b"KPK0", "Keyence .zon"),
    (b"KPK1", "Keyence .zon"),
    (b":NANONIS_VERSION:", "Nanonis .sxm"),
    (b"\x88\x1b\x03\x6f", "Zygo MetroPro .dat"),
    (b"\x88\x1b\x03\x70", "Zygo MetroPro .dat"),
    (b"\x88\x1b\x03\x71", "Zygo MetroPro .dat"),
    (b"aISO-1.0", "ISO 25178-71 .sdf"),
    (b"bISO-1.0", "ISO 25178-71 .sdf"),
    (b"aBCR-1.0", "ISO 25178-71 .sdf"),
    (b"bBCR-1.0", "ISO 25178-71 .sdf"),
    (b"FRTM_GLIDERV", "FRT MicroProf"),
    (b"Binary TrueMap Data File", "TrueMap .tmd"),
    (b"OmniSurf3D", "OmniSurf3D"),
    (b"Zeta-Instruments", "Zeta .zmg"),
    (b"CDF\x01", "NetCDF"),
    (b"CDF\x02", "NetCDF"),
    (b"MATLAB 5.0 MAT-file", "MATLAB .mat"),
    (b"MATLAB 7.3 MAT-file", "MATLAB .mat"),
    (b"\x93NUMPY", "a NumPy array"),
    (b"GWYO", "a Gwyddion file of its first versions"),
    (b"SPECM", "Bruker .spm of another kind"),
];

/// Begins of pictures and documents, which have no heights.
const PICTURES: &[(&[u8], &str)] = &[
    (b"\x89PNG", "a picture (PNG)"),
    (b"\xff\xd8\xff", "a picture (JPEG)"),
    (b"GIF8", "a picture (GIF)"),
    (b"BM", "a picture (BMP)"),
    (b"%PDF", "a document (PDF)"),
];

/// What to do about a picture.
const EXPORT: &str = "export the height channel itself: as a TIFF with 16-bit or floating-point samples, as Gwyddion simple field (.gsf), \
                      or in the microscope's own format";

/// Why a file in none of the formats that are read is refused.
pub(super) fn refusal(bytes: &[u8]) -> Refusal {
    if let Some((_, name)) = FORMATS.iter().find(|(magic, _)| bytes.starts_with(magic)) {
        return Refusal::new(format!("this is {name}, which is not read"), WAYS_OUT);
    }
    // A block of the user may precede an HDF5 file.
    if [512, 1024, 2048].iter().any(|&at| bytes.get(at..).is_some_and(|rest| rest.starts_with(FORMATS[0].0))) {
        return Refusal::new(format!("this is {}, which is not read", FORMATS[0].1), WAYS_OUT);
    }
    if is_rhk(bytes) {
        return Refusal::new("this is RHK .sm4, which is not read", WAYS_OUT);
    }
    if is_sensofar(bytes) {
        return Refusal::new("this is Sensofar .plu, which is not read", WAYS_OUT);
    }
    if let Some((_, name)) = PICTURES.iter().find(|(magic, _)| bytes.starts_with(magic)) {
        return Refusal::new(format!("this is {name}, not a height scan"), EXPORT);
    }
    Refusal::new("its first bytes are those of no format that is known here", WAYS_OUT)
}

/// Why a zip archive that is no X3P file is refused.
pub(super) fn archive_refusal(archive: &Archive) -> Refusal {
    let name = if archive.has("data-image.jpk-qi-image") || archive.has("data-image/") {
        "a JPK map of force curves (.jpk-qi-data, .jpk-force-map)"
    } else if archive.has("header.properties") {
        "JPK force curves or their map (.jpk-force, .jpk-qi-data)"
    } else if archive.has("index.xml") {
        "Sensofar .plux"
    } else if archive.has_ending(".npy") {
        "NumPy arrays (.npz)"
    } else if archive.has("[Content_Types].xml") {
        "an office document"
    } else {
        "a zip archive without a surface"
    };
    Refusal::new(format!("this is {name}, which is not read"), WAYS_OUT)
}

/// RHK's mark stands in UTF-16 behind a length.
fn is_rhk(bytes: &[u8]) -> bool {
    let mark: Vec<u8> = "STiMage".encode_utf16().flat_map(u16::to_le_bytes).collect();
    bytes.get(2..2 + mark.len()) == Some(&mark[..])
}

/// Sensofar's plain files begin with a date in 128 bytes, a comment in 256 follows.
fn is_sensofar(bytes: &[u8]) -> bool {
    let Some(date) = bytes.get(..128).filter(|_| bytes.len() >= 500) else { return false };
    let text: Vec<u8> = date.iter().copied().take_while(|&byte| byte != 0).collect();
    let days = ["Mon ", "Tue ", "Wed ", "Thu ", "Fri ", "Sat ", "Sun "];
    text.is_ascii() && text.contains(&b':') && days.iter().any(|day| text.starts_with(day.as_bytes()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn formats_are_told_by_content_and_ways_out_given() {
        for (magic, name) in FORMATS {
            let refusal = refusal(&[magic, &b"rest of the file"[..]].concat());
            assert!(refusal.what.contains(name) && refusal.fix == WAYS_OUT, "{refusal:?}");
        }
        let mut plu = b"Thu Mar 19 10:21:05 2015".to_vec();
        plu.resize(600, 0);
        assert!(refusal(&plu).what.contains(".plu"));
        let rhk: Vec<u8> = "\u{28}STiMage 005.004".encode_utf16().flat_map(u16::to_le_bytes).collect();
        assert!(refusal(&rhk).what.contains(".sm4"));
        let behind_a_block = [&[0; 512][..], FORMATS[0].0].concat();
        assert!(refusal(&behind_a_block).what.contains("HDF5"));
        assert!(refusal(b"\x89PNG\r\n").fix.contains("export"));
        for bytes in [&b""[..], b"x", &[0; 700]] {
            assert!(refusal(bytes).what.contains("no format"));
        }
    }
}
