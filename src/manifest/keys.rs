//! Every key of the manifest, by table: the one list that checks, suggestions, and documentation share.

/// The keys of one table.
#[derive(Debug)]
pub struct Keys {
    /// The table as it is written in a manifest.
    pub table: &'static str,
    /// The keys it takes.
    pub names: &'static [&'static str],
}

/// The top level.
pub(crate) const TOP: Keys = Keys {
    table: "the top level",
    names: &["schema", "atlas", "optics", "tables", "specimen", "specimens", "scene", "gpu", "report", "cache"],
};

/// What the atlas is called and where it goes.
pub const ATLAS: Keys = Keys { table: "[atlas]", names: &["name", "out", "on_failure"] };

/// Illumination and averaging; defaults for every specimen.
pub(crate) const OPTICS: Keys = Keys {
    table: "[optics]",
    names: &["illuminant", "wavelength_nm", "coherence", "windows", "material", "factor", "shadowing"],
};

/// Laser lines in place of a named illuminant.
pub(crate) const LINES: Keys = Keys { table: "illuminant", names: &["lines_nm", "power"] };

/// The light's spatial coherence.
pub(crate) const COHERENCE: Keys = Keys { table: "coherence", names: &["sigma_um", "source_deg", "edge"] };

/// Refractive index.
pub(crate) const MATERIAL: Keys = Keys { table: "material", names: &["n", "k", "metal", "substance", "file"] };

/// What is asked of the tables.
pub(crate) const TABLES: Keys = Keys {
    table: "[tables]",
    names: &[
        "basis",
        "tolerance",
        "size",
        "count",
        "wavelength_step_nm",
        "storage",
        "prefilter",
        "hold",
        "serve",
        "memory_mib",
    ],
};

/// A prefilter of fixed width.
pub(crate) const PREFILTER: Keys = Keys { table: "prefilter", names: &["width"] };

/// One specimen.
pub const SPECIMEN: Keys = Keys {
    table: "[[specimen]]",
    names: &[
        "name",
        "species",
        "scans",
        "page",
        "channel",
        "pitch_nm",
        "height",
        "level",
        "despike",
        "blend_nm",
        "max_missing_share",
        "missing_value",
        "crop",
        "material",
        "albedo",
        "illuminant",
        "coherence",
        "windows",
        "measured",
    ],
};

/// Measured reflectance to compare with.
pub(crate) const MEASURED: Keys = Keys {
    table: "measured",
    names: &[
        "file",
        "acceptance_deg",
        "bandwidth_nm",
        "theta_i_deg",
        "phi_i_deg",
        "theta_r_deg",
        "phi_r_deg",
        "kind",
        "white_reflectance",
        "column",
    ],
};

/// What the stored numbers of a scan mean.
pub(crate) const HEIGHT: Keys =
    Keys { table: "height", names: &["full_scale_nm", "unit", "nm_per_count", "offset_nm"] };

/// Removal of single outliers.
pub(crate) const DESPIKE: Keys = Keys { table: "despike", names: &["threshold_rms"] };

/// One picture; which of the keys apply depends on the shape.
pub const SCENE: Keys = Keys {
    table: "[[scene]]",
    names: &[
        "name",
        "shape",
        "specimen",
        "light",
        "environment",
        "look_ups",
        "light_samples",
        "pixel_samples",
        "size_px",
        "exposure",
        "tolerance",
        "animate",
        "width_mm",
        "distance_mm",
        "tilt_deg",
        "turn_deg",
        "beam_diameter_mm",
        "beam_divergence_deg",
        "hole_diameter_mm",
        "incidence_deg",
        "camera",
        "materials",
    ],
};

/// The camera of a scene with a mesh.
pub(crate) const CAMERA: Keys = Keys { table: "camera", names: &["position", "target", "up", "fov_deg", "width"] };

/// One light of a scene.
pub const LIGHT: Keys = Keys { table: "light", names: &["direction", "angular_diameter_deg", "irradiance"] };

/// Light from all around.
pub(crate) const ENVIRONMENT: Keys = Keys { table: "environment", names: &["file", "rotate_deg", "scale"] };

/// Frames besides the still.
pub(crate) const ANIMATE: Keys =
    Keys { table: "animate", names: &["kind", "axis", "frames", "degrees", "fps", "size_px"] };

/// A fixed exposure.
pub(crate) const EXPOSURE: Keys = Keys { table: "exposure", names: &["ev"] };

/// What a GPU is used for.
pub const GPU: Keys = Keys { table: "[gpu]", names: &["check", "frame_time"] };

/// What is found out besides the tables.
pub(crate) const REPORT: Keys = Keys { table: "[report]", names: &["write", "reference", "savings"] };

/// Where intermediate results are kept.
pub(crate) const CACHE: Keys = Keys { table: "[cache]", names: &["folder", "limit_mib"] };

/// Every table.
pub const ALL: &[&Keys] = &[
    &TOP,
    &ATLAS,
    &OPTICS,
    &LINES,
    &COHERENCE,
    &MATERIAL,
    &TABLES,
    &PREFILTER,
    &SPECIMEN,
    &MEASURED,
    &HEIGHT,
    &DESPIKE,
    &SCENE,
    &CAMERA,
    &LIGHT,
    &ENVIRONMENT,
    &ANIMATE,
    &EXPOSURE,
    &GPU,
    &REPORT,
    &CACHE,
];

/// Units that key names end in.
const UNITS: &[(&str, &str, f64)] = &[
    ("pm", "length", 1e-12),
    ("nm", "length", 1e-9),
    ("um", "length", 1e-6),
    ("mm", "length", 1e-3),
    ("cm", "length", 1e-2),
    ("m", "length", 1.0),
    ("deg", "angle", std::f64::consts::PI / 180.0),
    ("mrad", "angle", 1e-3),
    ("rad", "angle", 1.0),
    ("kib", "memory", 1.0 / 1024.0),
    ("mib", "memory", 1.0),
    ("gib", "memory", 1024.0),
];

/// The key that means the same as `unknown` in another unit, and the factor that converts a value.
fn in_another_unit(unknown: &str, names: &[&'static str]) -> Option<(&'static str, f64)> {
    let split = |name: &str| -> Option<(String, &'static str, f64)> {
        let (stem, unit) = name.rsplit_once('_')?;
        let (_, kind, factor) = UNITS.iter().find(|(u, _, _)| u.eq_ignore_ascii_case(unit))?;
        Some((stem.to_ascii_lowercase(), *kind, *factor))
    };
    let (stem, kind, factor) = split(unknown)?;
    names.iter().find_map(|name| {
        let (other_stem, other_kind, other_factor) = split(name)?;
        let same = other_stem == stem && other_kind == kind && other_factor != factor;
        same.then_some((*name, factor / other_factor))
    })
}

/// Keys of [`SCENE`] that people expect to name a mesh's file.
const MESH_FILE_WORDS: &[&str] = &["mesh", "model", "obj", "gltf", "glb", "geometry", "file", "path"];

/// What to say of a key that a table does not take; `number` and `text` are its value, where it is one.
pub(crate) fn unknown_key(unknown: &str, keys: &Keys, number: Option<f64>, text: Option<&str>) -> String {
    let table = keys.table;
    if keys.table == SCENE.table && MESH_FILE_WORDS.contains(&unknown.to_lowercase().as_str()) {
        let file = text.filter(|text| text.contains('.')).unwrap_or("body.obj");
        return format!(
            "unknown key `{unknown}` in {table}: a mesh file stands in the shape's place, `shape = {file:?}`"
        );
    }
    if let Some((name, factor)) = in_another_unit(unknown, keys.names) {
        let converted = number
            .map_or(String::new(), |value| format!(" (here {name} = {})", short(round_to_9_digits(value * factor))));
        return format!(
            "unknown key `{unknown}` in {table}: this quantity is given as `{name}`{converted}; \
             the unit is the last word of the key"
        );
    }
    if let Some(name) = nearest(unknown, keys.names) {
        return format!("unknown key `{unknown}` in {table}; the nearest known key is `{name}`");
    }
    if let Some(home) = ALL.iter().find(|other| other.names.contains(&unknown)) {
        return format!("unknown key `{unknown}` in {table}; it belongs in {}", home.table);
    }
    format!("unknown key `{unknown}` in {table}; expected one of {}", quoted(keys.names))
}

/// The known word most like `word`, if any is alike at all.
pub fn nearest<'a>(word: &str, known: &[&'a str]) -> Option<&'a str> {
    // 0.75 keeps one slip in a short word and a lost unit in a long one, and drops mere shared letters.
    const ALIKE: f64 = 0.75;
    let lower = word.to_lowercase();
    let score = |name: &str| strsim::jaro_winkler(&lower, &name.to_lowercase());
    known
        .iter()
        .map(|name| (score(name), *name))
        .filter(|(score, _)| *score >= ALIKE)
        // The first of equals wins, so the answer does not depend on anything but the list.
        .fold(None, |best: Option<(f64, &str)>, next| match best {
            Some(best) if best.0 >= next.0 => Some(best),
            _ => Some(next),
        })
        .map(|(_, name)| name)
}

/// Words in backquotes, separated by commas.
pub(crate) fn quoted(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
    quoted.join(", ")
}

/// A number without rows of zeros: as a power of ten beyond a million and below a millionth.
pub fn short(number: f64) -> String {
    let plain = number == 0.0 || !number.is_finite() || (1e-6..=1e6).contains(&number.abs());
    if plain { number.to_string() } else { format!("{number:e}") }
}

/// Nine significant digits: hides the last bits that a change of unit leaves behind.
fn round_to_9_digits(value: f64) -> f64 {
    format!("{value:.8e}").parse().unwrap_or(value)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn another_unit_is_named_and_converted() {
        let message = unknown_key("sigma_nm", &COHERENCE, Some(16250.0), None);
        assert!(message.contains("`sigma_um`") && message.contains("sigma_um = 16.25)"), "{message}");
        let message = unknown_key("tilt_rad", &SCENE, Some(0.5), None);
        assert!(message.contains("tilt_deg = 28.6478898)"), "{message}");
        assert!(unknown_key("sigma_nm", &COHERENCE, Some(1e300), None).contains("sigma_um = 1e297)"));
        assert!(unknown_key("memory_gib", &TABLES, Some(2.0), None).contains("memory_mib = 2048)"));
    }

    #[test]
    fn slips_lost_units_and_misplaced_keys_are_named() {
        for (unknown, keys, expected) in [
            ("tolerence", &TABLES, "nearest known key is `tolerance`"),
            ("pitch", &SPECIMEN, "nearest known key is `pitch_nm`"),
            ("Storage", &TABLES, "nearest known key is `storage`"),
            ("specimns", &TOP, "nearest known key is `specimens`"),
            ("tolerance", &GPU, "belongs in [tables]"),
            ("zzz", &GPU, "expected one of `check`, `frame_time`"),
        ] {
            let message = unknown_key(unknown, keys, None, None);
            assert!(message.contains(expected), "{message}");
        }
    }

    #[test]
    fn each_key_stands_once_in_its_table() {
        for keys in ALL {
            for (index, name) in keys.names.iter().enumerate() {
                assert!(!keys.names[..index].contains(name), "{name} twice in {}", keys.table);
            }
        }
    }
}
