//! Faults in a manifest: each is reported at its place, with what was expected.

use std::sync::LazyLock;

use crate::manifest_fixture::{GOOD, folder, good_with, parse_in};
use diffraction_atlas::manifest;
use diffraction_brdf::error::Error;
use proptest::prelude::*;

/// What is replaced in `GOOD`, by what; the expected `line:column`, the text that the carets mark, and
/// fragments of the message.
type Case = (&'static str, &'static str, &'static str, &'static str, &'static [&'static str]);

#[rustfmt::skip]
const CASES: &[Case] = &[
    // Not TOML.
    ("size = 501", "size = ", "15:8", "", &["not valid TOML"]),
    ("name = \"elaphe\"", "name = \"elaphe", "19:15", "", &["not valid TOML"]),
    ("[tables]", "[tables", "13:8", "", &["not valid TOML"]),
    ("out = \"out\"", "name = \"b\"", "5:1", "name", &["not valid TOML", "duplicate key"]),
    // The version of the format.
    ("schema = 1\n", "\n", "1:1", "", &["`schema` is missing", "schema = 1"]),
    ("schema = 1", "schema = 2", "1:10", "2", &["`schema` must be 1"]),
    ("schema = 1", "schema = \"1\"", "1:10", "\"1\"", &["`schema` must be 1"]),
    ("schema = 1", "schema = 1.0", "1:10", "1.0", &["`schema` must be 1"]),
    ("schema = 1", "schema = -1", "1:10", "-1", &["`schema` must be 1"]),
    // Unknown keys, at every depth.
    ("schema = 1", "shema = 1", "1:1", "shema", &["unknown key `shema`", "nearest known key is `schema`"]),
    ("[gpu]", "[gpus]", "42:2", "gpus", &["unknown key `gpus`", "`gpu`"]),
    ("[[scene]]\nname = \"sphere\"", "[[scenes]]\nname = \"sphere\"", "31:3", "scenes", &["`scene`"]),
    ("tolerance", "tolerence", "14:1", "tolerence", &["unknown key `tolerence` in [tables]", "`tolerance`"]),
    ("size = 501", "basys = \"taylor\"", "15:1", "basys", &["`basis`"]),
    ("edge = \"tile\"", "egde = \"tile\"", "10:33", "egde", &["unknown key `egde` in coherence", "`edge`"]),
    ("n = 1.56", "m = 1.56", "24:14", "m", &["unknown key `m` in material", "`n`, `k`"]),
    ("angular_diameter_deg", "angular_diameter", "34:41", "angular_diameter", &["`angular_diameter_deg`"]),
    ("threshold_rms", "threshold", "25:13", "threshold", &["`threshold_rms`"]),
    ("check = \"auto\"", "tolerance = 1", "43:1", "tolerance", &["belongs in [tables]"]),
    ("check = \"auto\"", "frame_time = \"never\"", "43:14", "\"never\"", &["`gpu.frame_time`", "\"auto\"", "\"on\"", "\"off\""]),
    ("check = \"auto\"", "check = \"off\"\nframe_time = \"on\"", "44:1", "frame_time", &["needs a GPU"]),
    ("windows = \"grid\"", "zzz.y = 1", "11:1", "zzz", &["unknown key `zzz`", "`illuminant`", "`shadowing`"]),
    ("check = \"auto\"", "check = \"auto\"\n[cache]\nlimit_mib = -1", "45:13", "-1", &["`cache.limit_mib`", "between 0 and"]),
    ("check = \"auto\"", "check = \"auto\"\n[cache]\nfolder = \"\"", "45:10", "\"\"", &["`cache.folder`"]),
    ("size_px = 512", "size_px = 512\ntolerance = 1e-2", "36:1", "tolerance", &["made for scenes", "tables.serve = \"scenes\""]),
    // The right quantity in the wrong unit.
    ("sigma_um = 16.25", "sigma_nm = 16250", "10:15", "sigma_nm", &["`sigma_um`", "sigma_um = 16.25)"]),
    ("sigma_um = 16.25", "sigma_mm = 0.01625", "10:15", "sigma_mm", &["sigma_um = 16.25)"]),
    ("pitch_nm = [48.8, 48.8]", "pitch_um = 0.0488", "21:1", "pitch_um", &["pitch_nm = 48.8)"]),
    ("full_scale_nm = 375", "full_scale_um = 0.375", "22:12", "full_scale_um", &["full_scale_nm = 375)"]),
    ("tilt_deg = 20", "tilt_rad = 0.5", "40:1", "tilt_rad", &["tilt_deg = 28.6478898)"]),
    ("memory_mib = 512", "memory_gib = 2", "16:1", "memory_gib", &["memory_mib = 2048)"]),
    // Missing parts.
    ("name = \"squamates\"\n", "\n", "3:1", "[atlas]", &["`name` is missing in `atlas`"]),
    ("name = \"elaphe\"\n", "\n", "18:1", "[[specimen]]", &["`name` is missing in `specimen[0]`"]),
    ("name = \"xenopeltis\"\nscans = [\"snake.tif\"]\n", "name = \"xenopeltis\"\n", "27:1", "[[specimen]]", &["`scans` is missing in `specimen[1]`"]),
    ("shape = \"sphere\"\n", "", "31:1", "[[scene]]", &["`shape` is missing"]),
    ("direction = [0.3, 0.2, 1.0], ", "", "34:10", "{ angular_diameter_deg = 0.53 }", &["`direction` is missing"]),
    ("n = 1.56", "k = 1.56", "24:12", "{ k = 1.56 }", &["`n` is missing"]),
    // Wrong types.
    ("[atlas]\nname = \"squamates\"\nout = \"out\"", "atlas = \"squamates\"", "3:9", "\"squamates\"", &["`atlas` must be a table"]),
    ("name = \"squamates\"", "name = 5", "4:8", "5", &["`atlas.name` must be a string", "the number 5"]),
    ("tolerance = 1e-3", "tolerance = \"fine\"", "14:13", "\"fine\"", &["`tables.tolerance` must be a number", "\"fine\""]),
    ("size = 501", "size = 501.0", "15:8", "501.0", &["must be a whole number"]),
    ("size = 501", "size = 1979-05-27", "15:8", "1979-05-27", &["must be a whole number", "date"]),
    ("windows = \"grid\"", "shadowing = \"yes\"", "11:13", "\"yes\"", &["must be true or false"]),
    ("wavelength_nm = [380, 780]", "wavelength_nm = 550", "9:17", "550", &["two wavelengths such as [380, 780]"]),
    ("wavelength_nm = [380, 780]", "wavelength_nm = [380, 550, 780]", "9:17", "[380, 550, 780]", &["found 3 elements"]),
    ("coherence = { sigma_um = 16.25, edge = \"tile\" }", "coherence = 16.25", "10:13", "16.25", &["must be a table such as"]),
    ("[[scene]]\nname = \"sphere\"", "[scene]\nname = \"sphere\"", "37:3", "scene", &["not valid TOML"]),
    ("scans = [\"snake.tif\"]\npitch", "scans = 5\npitch", "20:9", "5", &["must be a string"]),
    // Numbers out of range.
    ("[48.8, 48.8]", "-48.8", "21:12", "-48.8", &["`specimen[0].pitch_nm`", "above 0", "-48.8"]),
    ("[48.8, 48.8]", "0", "21:12", "0", &["above 0"]),
    ("[48.8, 48.8]", "nan", "21:12", "nan", &["finite number", "NaN"]),
    ("[48.8, 48.8]", "[48.8, inf]", "21:19", "inf", &["`specimen[0].pitch_nm[1]`", "finite number"]),
    ("[48.8, 48.8]", "[48.8, -1]", "21:19", "-1", &["above 0"]),
    ("[48.8, 48.8]", "[48.8]", "21:12", "[48.8]", &["two for x and y", "found 1 elements"]),
    ("[48.8, 48.8]", "2e6", "21:12", "2e6", &["at most 1000000 nm"]),
    ("size = 501", "size = 500", "15:8", "500", &["must be odd", "499 or 501"]),
    ("size = 501", "size = 1", "15:8", "1", &["between 3 and 16385"]),
    ("size = 501", "size = -501", "15:8", "-501", &["between 3 and 16385"]),
    ("size = 501", "size = 0x7fffffffffffffff", "15:8", "0x7fffffffffffffff", &["between 3 and"]),
    ("size = 501", "size = 99999999999999999999999999", "15:8", "99999999999999999999999999", &["between 3 and"]),
    ("size = 501", "count = 0", "15:9", "0", &["between 1 and 256"]),
    ("size = 501", "wavelength_step_nm = 0", "15:22", "0", &["between 0.01 and 100 nm"]),
    ("size = 501", "wavelength_step_nm = 1e-9", "15:22", "1e-9", &["`tables.wavelength_step_nm`", "between 0.01 and 100 nm", "found 1e-9"]),
    ("size = 501", "prefilter = { width = -0.1 }", "15:23", "-0.1", &["`tables.prefilter.width`", "above 0"]),
    ("tolerance = 1e-3", "tolerance = 1e-8", "14:13", "1e-8", &["above 1e-8 and at most 0.5"]),
    ("tolerance = 1e-3", "tolerance = 0.6", "14:13", "0.6", &["at most 0.5"]),
    ("memory_mib = 512", "memory_mib = 1", "16:14", "1", &["between 64 and"]),
    ("sigma_um = 16.25", "sigma_um = -1", "10:26", "-1", &["`optics.coherence.sigma_um`", "between 0.1 and 10000 µm"]),
    ("[380, 780]", "[780, 380]", "9:17", "[780, 380]", &["must increase", "write [380, 780]"]),
    ("[380, 780]", "[100, 780]", "9:18", "100", &["between 200 and 2500 nm"]),
    ("[380, 780]", "[380, 2501]", "9:23", "2501", &["between 200 and 2500 nm"]),
    ("[380, 780]", "[380, nan]", "9:23", "nan", &["finite"]),
    ("[380, 780]", "[800, 900]", "9:1", "wavelength_nm", &["no light falls between 380 and 780 nm"]),
    ("n = 1.56", "n = 0.9", "24:18", "0.9", &["between 1 and 100"]),
    ("n = 1.56", "n = 1.5, k = 0", "24:27", "0", &["above 0", "leave `k` out"]),
    ("threshold_rms = 8", "threshold_rms = 0", "25:29", "0", &["between 1 and 1000"]),
    ("level = \"plane\"", "max_missing_share = 0.9", "23:21", "0.9", &["between 0 and 0.5"]),
    ("level = \"plane\"", "blend_nm = -1", "23:12", "-1", &["above 0"]),
    ("level = \"plane\"", "page = -1", "23:8", "-1", &["between 0 and 65535"]),
    ("size_px = 512", "size_px = 9000", "35:11", "9000", &["between 16 and 8192"]),
    ("sigma_um = 16.25", "sigma_um = 1e300", "10:26", "1e300", &["found 1e300"]),
    ("size_px = 512", "size_px = 8192\nlight_samples = 1024", "36:1", "light_samples", &["8192 x 1024 x 1 = 8388608", "lower size_px"]),
    ("size_px = 512", "size_px = 2048\nanimate = { kind = \"light\", axis = \"viewing\", frames = 2, size_px = 5000 }\npixel_samples = 1024", "37:1", "pixel_samples", &["5000 x 1024 x 1"]),
    ("size_px = 512", "size_px = 0", "35:11", "0", &["between 16 and 8192"]),
    ("size_px = 512", "light_samples = 0", "35:17", "0", &["between 1 and 4096"]),
    ("size_px = 512", "exposure = { ev = inf }", "35:19", "inf", &["finite"]),
    ("tilt_deg = 20", "tilt_deg = 90", "40:12", "90", &["between -89 and 89 degrees"]),
    ("= 0.53", "= 100", "34:64", "100", &["between 0 and 90 degrees"]),
    // Unknown words.
    ("illuminant = \"D65\"", "illuminant = \"d65\"", "8:14", "\"d65\"", &["did you mean \"D65\"", "\"F12\""]),
    ("illuminant = \"D65\"", "illuminant = \"F13\"", "8:14", "\"F13\"", &["known illuminant"]),
    ("illuminant = \"D65\"", "illuminant = 65", "8:14", "65", &["must be a name"]),
    ("windows = \"grid\"", "windows = \"center\"", "11:11", "\"center\"", &["\"grid\", \"centre\"", "did you mean \"centre\""]),
    ("edge = \"tile\"", "edge = \"mirror\"", "10:40", "\"mirror\"", &["one of \"tile\", \"fade\""]),
    ("level = \"plane\"", "level = \"plan\"", "23:9", "\"plan\"", &["\"quadratic\"", "did you mean \"plane\""]),
    ("size = 501", "storage = \"f16\"", "15:11", "\"f16\"", &["one of \"auto\", \"half\", \"float\""]),
    ("size = 501", "basis = \"Chebyshev\"", "15:9", "\"Chebyshev\"", &["did you mean \"chebyshev\""]),
    ("size = 501", "prefilter = \"box\"", "15:13", "\"box\"", &["\"auto\", \"none\""]),
    ("material = { n = 1.56 }", "material = \"ideal\"\nalbedo = [0.4, 0.2, 0.1]", "25:10", "[0.4, 0.2, 0.1]", &["`specimen[0].albedo` needs a transparent material", "{ n = 1.56 }"]),
    ("material = { n = 1.56 }", "material = { n = 1.56 }\nalbedo = [0.4, 1.2, 0.1]", "25:16", "1.2", &["`specimen[0].albedo[1]`", "between 0 and 1"]),
    ("material = { n = 1.56 }", "material = { n = 1.56 }\nalbedo = 0.4", "25:10", "0.4", &["linear sRGB such as [0.45, 0.16, 0.05]"]),
    ("shape = \"sphere\"", "shape = \"spere\"", "33:9", "\"spere\"", &["found \"spere\"; did you mean \"sphere\"?"]),
    ("shape = \"sphere\"", "mesh = \"torus.obj\"", "33:1", "mesh", &["unknown key `mesh` in [[scene]]", "`shape = \"torus.obj\"`"]),
    ("shape = \"sphere\"", "shape = \"sphere\"\nModel = 3", "34:1", "Model", &["unknown key `Model` in [[scene]]", "`shape = \"body.obj\"`"]),
    ("shape = \"sphere\"", "shape = \"torus\"", "33:9", "\"torus\"", &["or the name of a mesh file such as \"body.obj\"; found \"torus\"", "\"hemisphere\", \"sphere\", \"snake\", \"patch\", \"screen\""]),
    ("check = \"auto\"", "check = \"on\"", "43:9", "\"on\"", &["\"required\""]),
    ("{ full_scale_nm = 375 }", "{ unit = \"micron\" }", "22:19", "\"micron\"", &["\"um\"", "\"angstrom\""]),
    ("{ n = 1.56 }", "\"keratin\"", "24:12", "\"keratin\"", &["\"ideal\", { n = 1.56 }"]),
    ("size_px = 512", "exposure = \"bright\"", "35:12", "\"bright\"", &["\"auto\" or { ev = 0.5 }"]),
    // Parts that do not fit together.
    ("{ full_scale_nm = 375 }", "{ full_scale_nm = 375, unit = \"nm\" }", "22:10", "{ full_scale_nm = 375, unit = \"nm\" }", &["exactly one", "found `full_scale_nm`, `unit`"]),
    ("{ full_scale_nm = 375 }", "{ offset_nm = 3 }", "22:10", "{ offset_nm = 3 }", &["exactly one", "found none"]),
    ("{ full_scale_nm = 375 }", "{ unit = \"nm\", offset_nm = 3 }", "22:25", "offset_nm", &["goes with `nm_per_count`"]),
    ("{ full_scale_nm = 375 }", "{ nm_per_count = 0 }", "22:27", "0", &["must not be 0"]),
    ("illuminant = \"D65\"", "illuminant = { lines_nm = [] }", "8:27", "[]", &["1 to 1000 wavelengths"]),
    ("illuminant = \"D65\"", "illuminant = { lines_nm = [633, 633] }", "8:33", "633", &["repeats the line"]),
    ("illuminant = \"D65\"", "illuminant = { lines_nm = [633], power = [1, 2] }", "8:42", "[1, 2]", &["each of the 1 lines", "found 2"]),
    ("illuminant = \"D65\"", "illuminant = { lines_nm = [633], power = [0] }", "8:43", "0", &["above 0"]),
    ("illuminant = \"D65\"", "illuminant = { lines_nm = [200000] }", "8:28", "200000", &["between 200 and 2500"]),
    ("illuminant = \"D65\"", "illuminant = { lines_nm = [1064] }", "9:17", "[380, 780]", &["leaves out the laser line at 1064 nm"]),
    ("illuminant = \"D65\"\nwavelength_nm = [380, 780]", "illuminant = { lines_nm = [1064] }\n", "8:1", "illuminant", &["no light falls between 380 and 780"]),
    ("tilt_deg = 20", "incidence_deg = 20", "40:1", "incidence_deg", &["does not apply to the shape \"patch\"", "`screen`"]),
    ("size_px = 512", "width_mm = 20", "35:1", "width_mm", &["does not apply to the shape \"sphere\"", "`patch`, `screen`"]),
    ("shape = \"patch\"\ntilt_deg = 20", "shape = \"screen\"\nlight = { direction = [0, 0, 1] }", "40:1", "light", &["does not apply to the shape \"screen\""]),
    ("tilt_deg = 20", "width_mm = 60", "40:1", "width_mm", &["must exceed `width_mm`"]),
    ("tilt_deg = 20", "distance_mm = 20", "40:1", "distance_mm", &["must exceed `width_mm`"]),
    ("tilt_deg = 20", "tilt_deg = -89", "40:1", "tilt_deg", &["turned away from the default light"]),
    ("shape = \"patch\"\ntilt_deg = 20", "shape = \"screen\"\nincidence_deg = 85\nbeam_diameter_mm = 50", "40:1", "incidence_deg", &["lights the specimen up to the screen"]),
    ("size_px = 512", "specimen = \"elaph\"", "35:12", "\"elaph\"", &["one of \"elaphe\", \"xenopeltis\"", "did you mean \"elaphe\""]),
    // Meshes.
    ("\"sphere\"\nlight", "\"none.obj\"\nlight", "33:9", "\"none.obj\"", &["names a file that does not exist"]),
    ("\"sphere\"\nlight", "\"snake.tif\"\nlight", "33:9", "\"snake.tif\"", &["cannot be shown", ".obj, .gltf or .glb"]),
    ("\"sphere\"\nlight", "\"bare.obj\"\nlight", "33:9", "\"bare.obj\"", &["cannot be shown", "line 4: the face has no texture coordinates"]),
    ("\"sphere\"\nlight", "\"body.obj\"\nmaterials = { back = \"elaphe\" }\nlight", "34:13", "{ back = \"elaphe\" }", &["every material of the mesh, \"back\", \"belly\"", "missing: \"belly\""]),
    ("\"sphere\"\nlight", "\"body.obj\"\nmaterials = { back = \"elaphe\", bely = \"elaphe\" }\nlight", "34:39", "\"elaphe\"", &["`scene[0].materials.bely` names no material", "\"back\", \"belly\""]),
    ("\"sphere\"\nlight", "\"body.obj\"\nmaterials = { back = \"elaph\", belly = \"elaphe\" }\nlight", "34:22", "\"elaph\"", &["`scene[0].materials.back` must be one of", "did you mean \"elaphe\""]),
    ("\"sphere\"\nlight", "\"body.obj\"\nmaterials = \"elaphe\"\nlight", "34:13", "\"elaphe\"", &["must be a table such as"]),
    ("\"sphere\"\nlight", "\"body.obj\"\nspecimen = \"elaphe\"\nmaterials = { back = \"elaphe\", belly = \"elaphe\" }\nlight", "34:1", "specimen", &["give one"]),
    ("\"sphere\"\nlight", "\"body.obj\"\ncamera = { position = [0, 0, 5] }\nlight", "34:10", "{ position = [0, 0, 5] }", &["`target` is missing"]),
    ("\"sphere\"\nlight", "\"body.obj\"\ncamera = { position = [0, 0, 5], target = [0, 0, 5] }\nlight", "34:10", "{ position = [0, 0, 5], target = [0, 0, 5] }", &["sees nothing"]),
    ("\"sphere\"\nlight", "\"body.obj\"\ncamera = { position = [0, 0, 5], target = [0, 0, 0], fov_deg = 20, width = 2 }\nlight", "34:68", "width", &["give one"]),
    ("\"sphere\"\nlight", "\"body.obj\"\ncamera = { position = [0, 0, 5], target = [0, 0, 0], fov_deg = 180 }\nlight", "34:64", "180", &["between 0.01 and 170 degrees"]),
    ("\"sphere\"\nlight", "\"body.obj\"\ntilt_deg = 3\nlight", "34:1", "tilt_deg", &["does not apply to a mesh but to `patch`", "a mesh takes `light`, `environment`, `camera`, `materials`"]),
    ("\"sphere\"\nlight", "\"sphere\"\ncamera = { position = [0, 0, 5], target = [0, 0, 0] }\nlight", "34:1", "camera", &["does not apply to the shape \"sphere\" but to `a mesh`"]),
    // Lights.
    ("[0.3, 0.2, 1.0]", "[0, 0, 0]", "34:24", "[0, 0, 0]", &["must not be zero"]),
    ("[0.3, 0.2, 1.0]", "[0.3, 0.2]", "34:24", "[0.3, 0.2]", &["three numbers"]),
    ("[0.3, 0.2, 1.0]", "[0.3, nan, 1.0]", "34:30", "nan", &["`scene[0].light[0].direction[1]`", "finite"]),
    ("shape = \"sphere\"\nlight = [{ direction = [0.3, 0.2, 1.0]", "shape = \"patch\"\nlight = [{ direction = [0.3, 0.2, -0.1]", "34:24", "[0.3, 0.2, -0.1]", &["below the horizon"]),
    ("shape = \"sphere\"\nlight = [{ direction = [0.3, 0.2, 1.0]", "shape = \"hemisphere\"\nlight = [{ direction = [1, 0, 0]", "34:24", "[1, 0, 0]", &["below the horizon"]),
    ("light = [{ direction = [0.3, 0.2, 1.0], angular_diameter_deg = 0.53 }]", "light = []", "34:9", "[]", &["1 to 64 lights"]),
    ("shape = \"sphere\"\nlight = [{", "shape = \"hemisphere\"\nlight = [{ direction = [0, 0, 1] }, {", "34:9", "[{ direction = [0, 0, 1] }, { direction = [0.3, 0.", &["exactly 1 light", "found 2"]),
    // Names.
    ("\"xenopeltis\"", "\"elaphe\"", "28:8", "\"elaphe\"", &["repeats the name"]),
    ("\"xenopeltis\"", "\"Elaphe\"", "28:8", "\"Elaphe\"", &["in case alone"]),
    ("name = \"patch\"", "name = \"sphere\"", "38:8", "\"sphere\"", &["repeats the name"]),
    ("\"xenopeltis\"", "\"../up\"", "28:8", "\"../up\"", &["becomes a folder's or file's name", "a-z"]),
    ("\"xenopeltis\"", "\"\"", "28:8", "\"\"", &["1 to 64"]),
    ("\"xenopeltis\"", "\"atlas.json\"", "28:8", "\"atlas.json\"", &["a-z"]),
    ("\"xenopeltis\"", "\"Lpt1\"", "28:8", "\"Lpt1\"", &["device's name"]),
    ("\"squamates\"", "\"-rf\"", "4:8", "\"-rf\"", &["`atlas.name`", "begin with a letter or digit"]),
    // Files.
    ("scans = [\"snake.tif\"]\npitch", "scans = [\"snake.tif\", \"nowhere.tif\"]\npitch", "20:23", "\"nowhere.tif\"", &["`specimen[0].scans[1]`", "does not exist", "nowhere.tif"]),
    ("scans = [\"snake.tif\"]\npitch", "scans = [\"snake_*.tif\"]\npitch", "20:10", "\"snake_*.tif\"", &["matches no file"]),
    ("scans = [\"snake.tif\"]\npitch", "scans = []\npitch", "20:9", "[]", &["at least one file"]),
    ("scans = [\"snake.tif\"]\npitch", "scans = [\"\"]\npitch", "20:10", "\"\"", &["must not be empty"]),
    ("level = \"plane\"", "measured = \"nowhere.csv\"", "23:12", "\"nowhere.csv\"", &["`specimen[0].measured`", "does not exist"]),
    ("level = \"plane\"", "measured = { acceptance_deg = 1 }", "23:12", "{ acceptance_deg = 1 }", &["`file`"]),
    ("level = \"plane\"", "measured = { file = \"measured.csv\", acceptance_deg = 61 }", "23:54", "61", &["`specimen[0].measured.acceptance_deg`", "between 0 and 60"]),
    ("level = \"plane\"", "measured = { file = \"measured.csv\", bandwidth_um = 0.002 }", "23:37", "bandwidth_um", &["bandwidth_nm = 2"]),
    ("illuminant = \"D65\"", "illuminant = \"nowhere.csv\"", "8:14", "\"nowhere.csv\"", &["`optics.illuminant`", "cannot read"]),
    ("illuminant = \"D65\"", "illuminant = \"snake.tif\"", "8:14", "\"snake.tif\"", &["the first line must be `wavelength_nm,power`"]),
    ("tilt_deg = 20", "environment = \"nowhere.exr\"", "40:15", "\"nowhere.exr\"", &["`scene[1].environment` cannot light", "cannot read"]),
    ("tilt_deg = 20", "environment = \"lamp.csv\"", "40:15", "\"lamp.csv\"", &["is no OpenEXR image"]),
    ("tilt_deg = 20", "environment = { file = \"flat.exr\" }", "40:24", "\"flat.exr\"", &["4 x 4 pixels", "twice as wide"]),
    ("tilt_deg = 20", "environment = { file = \"night.exr\" }", "40:24", "\"night.exr\"", &["is black"]),
    ("tilt_deg = 20", "environment = { rotate_deg = 9 }", "40:15", "{ rotate_deg = 9 }", &["`file`"]),
    ("tilt_deg = 20", "environment = { file = \"sky.exr\", scale = 0 }", "40:43", "0", &["must be above 0"]),
    ("shape = \"patch\"\ntilt_deg = 20", "shape = \"hemisphere\"\nenvironment = \"sky.exr\"", "40:1", "environment", &["does not apply", "`sphere`"]),
    ("tilt_deg = 20", "animate = { frames = 9 }", "40:11", "{ frames = 9 }", &["`kind`"]),
    ("tilt_deg = 20", "animate = { kind = \"spin\" }", "40:20", "\"spin\"", &["\"turntable\", \"light\""]),
    ("tilt_deg = 20", "animate = { kind = \"light\", degrees = 0 }", "40:29", "degrees", &["nothing moves"]),
    ("tilt_deg = 20", "animate = { kind = \"light\", frames = 1 }", "40:38", "1", &["between 2 and 1000"]),
    ("tilt_deg = 20", "animate = { kind = \"light\", frames = 1000 }", "40:11", "{ kind = \"light\", frames = 1000 }", &["pixels together", "`size_px`"]),
    ("shape = \"patch\"\ntilt_deg = 20", "shape = \"sphere\"\nanimate = { kind = \"turntable\" }", "40:13", "kind", &["looks the same", "viewing"]),
    ("shape = \"patch\"\ntilt_deg = 20", "shape = \"screen\"\nanimate = { kind = \"light\" }", "40:13", "kind", &["do not move"]),
    ("illuminant = \"D65\"", "illuminant = \"dark.csv\"", "9:1", "wavelength_nm", &["no light falls"]),
];

/// The text above the carets.
fn marked(excerpt: &str) -> String {
    let lines: Vec<&str> = excerpt.lines().collect();
    assert_eq!(lines.len(), 2, "{excerpt}");
    let carets = || lines[1].chars().enumerate().filter(|(_, c)| *c == '^').map(|(at, _)| at);
    let (first, last) = (carets().next().unwrap(), carets().last().unwrap());
    lines[0].chars().skip(first).take(last + 1 - first).collect()
}

#[test]
fn every_fault_is_reported_at_its_place() {
    let folder = folder();
    parse_in(folder.path(), GOOD).unwrap();
    let mut wrong = Vec::new();
    for (find, replace, place, under, fragments) in CASES {
        match parse_in(folder.path(), &good_with(find, replace)) {
            Err(Error::Manifest { line, column, message, excerpt, file }) => {
                assert!(file.ends_with("m.toml"));
                let place_found = format!("{line}:{column}");
                if place_found != *place || marked(&excerpt).trim_end() != *under {
                    wrong.push(format!(
                        "{replace:?}: expected {place} {under:?}, found {place_found}: {message}\n{excerpt}"
                    ));
                }
                for fragment in fragments.iter().filter(|fragment| !message.contains(**fragment)) {
                    wrong.push(format!("{replace:?}: no {fragment:?} in: {message}"));
                }
            }
            other => wrong.push(format!("{replace:?}: expected a fault of the manifest, found {other:?}")),
        }
    }
    assert!(wrong.is_empty(), "{} of {}:\n{}", wrong.len(), CASES.len(), wrong.join("\n"));
}

#[test]
fn a_message_is_ready_to_read() {
    let folder = folder();
    let text = good_with("size = 501", "size = 500");
    let message = parse_in(folder.path(), &text).unwrap_err().to_string();
    let file = folder.path().join("m.toml");
    assert_eq!(
        message,
        format!(
            "{}:15:8: `tables.size` must be odd, so that one texel lies at u = v = 0; found 500, try 499 or 501\n \
             15 | size = 500\n    |        ^^^",
            file.display()
        )
    );
}

#[test]
fn no_specimen_is_a_fault() {
    let folder = folder();
    let text = &GOOD[..GOOD.find("[[specimen]]").unwrap()];
    let message = parse_in(folder.path(), text).unwrap_err().to_string();
    assert!(message.contains("`specimen` is missing"), "{message}");
    let message = parse_in(folder.path(), &format!("specimen = []\n{text}")).unwrap_err().to_string();
    assert!(message.contains("at least one specimen"), "{message}");
    let message = parse_in(folder.path(), "").unwrap_err().to_string();
    assert!(message.contains(":1:1: `schema` is missing"), "{message}");
}

#[test]
fn scenes_to_serve_must_be_there() {
    let folder = folder();
    let good = good_with("size = 501", "serve = [\"q\"]");
    let message = parse_in(folder.path(), &good).unwrap_err().to_string();
    assert!(message.contains("must be one of \"sphere\", \"patch\"; found \"q\""), "{message}");
    let message = parse_in(folder.path(), &good[..good.find("[[scene]]").unwrap()]).unwrap_err().to_string();
    assert!(message.contains(":15:9: `tables.serve` names scenes, but there is no [[scene]]"), "{message}");
}

#[test]
fn windows_line_ends_tabs_and_marks_do_not_shift_places() {
    let folder = folder();
    let text = good_with("size = 501", "size\t=\t500");
    for text in [text.replace('\n', "\r\n"), format!("\u{feff}{text}")] {
        let message = parse_in(folder.path(), &text).unwrap_err().to_string();
        assert!(message.contains(":15:8: "), "{message}");
        assert!(message.ends_with(" 15 | size\t=\t500\n    |     \t \t^^^"), "{message:?}");
    }
    // On the first line the mark itself must not count.
    let message = parse_in(folder.path(), "\u{feff}schema = 2").unwrap_err().to_string();
    assert!(message.contains(":1:10: "), "{message}");
}

#[test]
fn files_that_are_no_manifest_are_refused() {
    let folder = folder();
    let path = folder.path().join("bad.toml");
    assert!(matches!(manifest::load(&path), Err(Error::Call(message)) if message.contains("bad.toml")));
    assert!(matches!(manifest::load(folder.path()), Err(Error::Call(_))));
    std::fs::write(&path, b"schema = 1\nname = \"\xff\"").unwrap();
    let message = manifest::load(&path).unwrap_err().to_string();
    assert!(message.contains("bad.toml:2:9: not UTF-8"), "{message}");
    // Nesting must not exhaust the stack.
    for open in ["[", "{ a = ", "[[", "a."] {
        let text = format!("schema = {}", open.repeat(100_000));
        assert!(matches!(parse_in(folder.path(), &text), Err(Error::Manifest { .. })), "{open}");
    }
}

/// A good manifest with one line deleted, doubled, moved, or garbled.
fn mutated(line: usize, other: usize, kind: u8, junk: &str) -> String {
    let mut lines: Vec<String> = GOOD.lines().map(str::to_owned).collect();
    let (line, other) = (line % lines.len(), other % lines.len());
    match kind {
        0 => drop(lines.remove(line)),
        1 => lines.insert(other, lines[line].clone()),
        2 => lines.swap(line, other),
        3 => lines[line] = junk.to_owned(),
        4 => {
            let at = lines[line].char_indices().nth(other).map_or(lines[line].len(), |(at, _)| at);
            lines[line].insert_str(at, junk);
        }
        _ => {
            // The value of another key in place of its own.
            let value = lines[other].split_once('=').map_or(junk, |(_, value)| value).to_owned();
            let key = lines[line].split('=').next().unwrap_or_default().to_owned();
            lines[line] = format!("{key}={value}");
        }
    }
    lines.join("\n")
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(2000) })]

    #[test]
    fn mutated_manifests_are_read_or_refused_with_a_place(
        line in 0usize..100, other in 0usize..100, kind in 0u8..6, junk in "\\PC{0,12}|[\\x00-\\x7f]{0,8}",
    ) {
        static FOLDER: LazyLock<tempfile::TempDir> = LazyLock::new(folder);
        let text = mutated(line, other, kind, &junk);
        match parse_in(FOLDER.path(), &text) {
            Ok(_) => {}
            Err(Error::Manifest { line, column, message, excerpt, .. }) => {
                let lines = text.split('\n').count();
                prop_assert!((1..=lines).contains(&line), "line {line} of {lines}");
                let width = text.split('\n').nth(line - 1).unwrap().chars().count();
                prop_assert!((1..=width + 1).contains(&column), "column {column} of {width}");
                prop_assert!(!message.is_empty() && excerpt.contains('^'));
            }
            Err(other) => prop_assert!(false, "{other}"),
        }
    }
}
