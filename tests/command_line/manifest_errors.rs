//! Faults in a manifest: each is reported at its place, with what was expected.

use std::sync::LazyLock;

use crate::manifest_fixture::{GOOD, folder, good_with, parse_in};
use diffraction_atlas::error::Error;
use diffraction_atlas::manifest;
use proptest::prelude::*;

/// What is replaced in `GOOD`, by what; the expected `line:column`, the text that the carets mark, and
/// what the message must name, however it is worded: keys, values, limits, choices.
type Case = (&'static str, &'static str, &'static str, &'static str, &'static [&'static str]);

#[rustfmt::skip]
const CASES: &[Case] = &[
    // Not TOML.
    ("size = 501", "size = ", "15:8", "", &["TOML"]),
    ("name = \"elaphe\"", "name = \"elaphe", "19:15", "", &["TOML"]),
    ("[tables]", "[tables", "13:8", "", &["TOML"]),
    ("out = \"out\"", "name = \"b\"", "5:1", "name", &["TOML", "duplicate"]),
    // The version of the format.
    ("schema = 1\n", "\n", "1:1", "", &["`schema`", "schema = 1"]),
    ("schema = 1", "schema = 2", "1:10", "2", &["`schema`"]),
    ("schema = 1", "schema = \"1\"", "1:10", "\"1\"", &["`schema`"]),
    ("schema = 1", "schema = 1.0", "1:10", "1.0", &["`schema`"]),
    ("schema = 1", "schema = -1", "1:10", "-1", &["`schema`"]),
    // Unknown keys, at every depth.
    ("schema = 1", "shema = 1", "1:1", "shema", &["`shema`", "`schema`"]),
    ("[gpu]", "[gpus]", "42:2", "gpus", &["`gpus`", "`gpu`"]),
    ("[[scene]]\nname = \"sphere\"", "[[scenes]]\nname = \"sphere\"", "31:3", "scenes", &["`scene`"]),
    ("tolerance", "tolerence", "14:1", "tolerence", &["`tolerence`", "[tables]", "`tolerance`"]),
    ("size = 501", "basys = \"taylor\"", "15:1", "basys", &["`basis`"]),
    ("edge = \"tile\"", "egde = \"tile\"", "10:33", "egde", &["`egde`", "`edge`"]),
    ("n = 1.56", "q = 1.56", "24:14", "q", &["`q`", "`n`", "`k`"]),
    ("angular_diameter_deg", "angular_diameter", "34:41", "angular_diameter", &["`angular_diameter_deg`"]),
    ("threshold_rms", "threshold", "25:13", "threshold", &["`threshold_rms`"]),
    ("check = \"auto\"", "tolerance = 1", "43:1", "tolerance", &["[tables]"]),
    ("check = \"auto\"", "frame_time = \"never\"", "43:14", "\"never\"", &["`gpu.frame_time`", "\"auto\"", "\"on\"", "\"off\""]),
    ("check = \"auto\"", "check = \"off\"\nframe_time = \"on\"", "44:1", "frame_time", &["GPU"]),
    ("windows = \"grid\"", "zzz.y = 1", "11:1", "zzz", &["`zzz`", "`illuminant`", "`shadowing`"]),
    ("check = \"auto\"", "check = \"auto\"\n[cache]\nlimit_mib = -1", "45:13", "-1", &["`cache.limit_mib`", "0"]),
    ("check = \"auto\"", "check = \"auto\"\n[cache]\nfolder = \"\"", "45:10", "\"\"", &["`cache.folder`"]),
    ("size_px = 512", "size_px = 512\ntolerance = 1e-2", "36:1", "tolerance", &["scenes", "serve = \"scenes\""]),
    // The right quantity in the wrong unit.
    ("sigma_um = 16.25", "sigma_nm = 16250", "10:15", "sigma_nm", &["`sigma_um`", "sigma_um = 16.25"]),
    ("sigma_um = 16.25", "sigma_mm = 0.01625", "10:15", "sigma_mm", &["sigma_um = 16.25"]),
    ("pitch_nm = [48.8, 48.8]", "pitch_um = 0.0488", "21:1", "pitch_um", &["pitch_nm = 48.8"]),
    ("full_scale_nm = 375", "full_scale_um = 0.375", "22:12", "full_scale_um", &["full_scale_nm = 375"]),
    ("tilt_deg = 20", "tilt_rad = 0.5", "40:1", "tilt_rad", &["tilt_deg = 28.6478898"]),
    ("memory_mib = 512", "memory_gib = 2", "16:1", "memory_gib", &["memory_mib = 2048"]),
    // Missing parts.
    ("name = \"squamates\"\n", "\n", "3:1", "[atlas]", &["`name`", "`atlas`"]),
    ("name = \"elaphe\"\n", "\n", "18:1", "[[specimen]]", &["`name`", "`specimen[0]`"]),
    ("name = \"xenopeltis\"\nscans = [\"snake.tif\"]\n", "name = \"xenopeltis\"\n", "27:1", "[[specimen]]", &["`scans`", "`specimen \"xenopeltis\"`"]),
    ("shape = \"sphere\"\n", "", "31:1", "[[scene]]", &["`shape`"]),
    ("direction = [0.3, 0.2, 1.0], ", "", "34:10", "{ angular_diameter_deg = 0.53 }", &["`direction`"]),
    ("n = 1.56", "k = 1.56", "24:12", "{ k = 1.56 }", &["`n`"]),
    // Wrong types.
    ("[atlas]\nname = \"squamates\"\nout = \"out\"", "atlas = \"squamates\"", "3:9", "\"squamates\"", &["`atlas`"]),
    ("name = \"squamates\"", "name = 5", "4:8", "5", &["`atlas.name`", "5"]),
    ("tolerance = 1e-3", "tolerance = \"fine\"", "14:13", "\"fine\"", &["`tables.tolerance`", "\"fine\""]),
    ("size = 501", "size = 501.0", "15:8", "501.0", &["whole"]),
    ("size = 501", "size = 1979-05-27", "15:8", "1979-05-27", &["whole", "date"]),
    ("windows = \"grid\"", "shadowing = \"yes\"", "11:13", "\"yes\"", &["true"]),
    ("wavelength_nm = [380, 780]", "wavelength_nm = 550", "9:17", "550", &["[380, 780]"]),
    ("wavelength_nm = [380, 780]", "wavelength_nm = [380, 550, 780]", "9:17", "[380, 550, 780]", &["3"]),
    ("coherence = { sigma_um = 16.25, edge = \"tile\" }", "coherence = 16.25", "10:13", "16.25", &["table"]),
    ("[[scene]]\nname = \"sphere\"", "[scene]\nname = \"sphere\"", "37:3", "scene", &["TOML"]),
    ("scans = [\"snake.tif\"]\npitch", "scans = 5\npitch", "20:9", "5", &["string"]),
    // A source of fixed size.
    ("sigma_um = 16.25, edge = \"tile\"", "source_deg = 0.53, sigma_um = 16.25", "10:28", "0.53", &["`optics.coherence.source_deg`", "`sigma_um`"]),
    ("sigma_um = 16.25, edge = \"tile\"", "source_deg = 0.53, edge = \"fade\"", "10:1", "coherence", &["\"auto\"", "\"tile\"", "`sigma_um`"]),
    ("sigma_um = 16.25, edge = \"tile\" }\nwindows = \"grid\"", "source_deg = 0.53 }\nwindows = \"centre\"", "11:1", "windows", &["windows = \"grid\"", "`sigma_um`"]),
    ("sigma_um = 16.25", "source_deg = 0", "10:28", "0", &["`optics.coherence.source_deg`", "20 degrees"]),
    ("level = \"plane\"", "coherence = { source_deg = 2, edge = \"fade\" }", "23:1", "coherence", &["edge = \"auto\""]),
    // A specimen's own light.
    ("level = \"plane\"", "illuminant = \"D66\"", "23:14", "\"D66\"", &["`specimen \"elaphe\": illuminant`", "\"D65\""]),
    ("level = \"plane\"", "illuminant = { lines_nm = [800, 600] }", "23:14", "{ lines_nm = [800, 600] }", &["800 nm", "`optics.wavelength_nm`"]),
    // Numbers out of range.
    ("[48.8, 48.8]", "-48.8", "21:12", "-48.8", &["`specimen \"elaphe\": pitch_nm`", "between 0.001", "-48.8"]),
    ("[48.8, 48.8]", "0", "21:12", "0", &["between 0.001"]),
    ("[48.8, 48.8]", "nan", "21:12", "nan", &["finite", "NaN"]),
    ("[48.8, 48.8]", "[48.8, inf]", "21:19", "inf", &["`specimen \"elaphe\": pitch_nm[1]`", "finite"]),
    ("[48.8, 48.8]", "[48.8, -1]", "21:19", "-1", &["between 0.001"]),
    ("[48.8, 48.8]", "[48.8]", "21:12", "[48.8]", &["two", "1"]),
    ("[48.8, 48.8]", "2e6", "21:12", "2e6", &["1000000 nm"]),
    ("size = 501", "size = 500", "15:8", "500", &["odd", "499", "501"]),
    ("size = 501", "size = 1", "15:8", "1", &["16385"]),
    ("size = 501", "size = -501", "15:8", "-501", &["16385"]),
    ("size = 501", "size = 0x7fffffffffffffff", "15:8", "0x7fffffffffffffff", &["3"]),
    ("size = 501", "size = 99999999999999999999999999", "15:8", "99999999999999999999999999", &["3"]),
    ("size = 501", "count = 0", "15:9", "0", &["256"]),
    ("size = 501", "wavelength_step_nm = 0", "15:22", "0", &["0.01", "100 nm"]),
    ("size = 501", "wavelength_step_nm = 1e-9", "15:22", "1e-9", &["`tables.wavelength_step_nm`", "0.01", "100 nm", "1e-9"]),
    ("size = 501", "prefilter = { width = -0.1 }", "15:23", "-0.1", &["`tables.prefilter.width`", "above 0"]),
    ("tolerance = 1e-3", "tolerance = 1e-8", "14:13", "1e-8", &["1e-8", "0.5"]),
    ("tolerance = 1e-3", "tolerance = 0.6", "14:13", "0.6", &["0.5"]),
    ("memory_mib = 512", "memory_mib = 1", "16:14", "1", &["64"]),
    ("sigma_um = 16.25", "sigma_um = -1", "10:26", "-1", &["`optics.coherence.sigma_um`", "0.1", "10000 µm"]),
    ("[380, 780]", "[780, 380]", "9:17", "[780, 380]", &["increas", "[380, 780]"]),
    ("[380, 780]", "[100, 780]", "9:18", "100", &["200", "2500 nm"]),
    ("[380, 780]", "[380, 2501]", "9:23", "2501", &["200", "2500 nm"]),
    ("[380, 780]", "[380, nan]", "9:23", "nan", &["finite"]),
    ("[380, 780]", "[800, 900]", "9:1", "wavelength_nm", &["380", "780 nm"]),
    ("n = 1.56", "n = 0.9", "24:18", "0.9", &["100"]),
    ("n = 1.56", "n = 1.5, k = 0", "24:27", "0", &["above 0", "`k`"]),
    ("threshold_rms = 8", "threshold_rms = 0", "25:29", "0", &["1000"]),
    ("level = \"plane\"", "max_missing_share = 0.9", "23:21", "0.9", &["0.5"]),
    ("level = \"plane\"", "crop = [0, 0, 0, 9]", "23:15", "0", &["1048576 samples"]),
    ("level = \"plane\"", "crop = [0, 9]", "23:8", "[0, 9]", &["width"]),
    ("level = \"plane\"", "blend_nm = -1", "23:12", "-1", &["above 0"]),
    ("level = \"plane\"", "page = -1", "23:8", "-1", &["65535"]),
    ("size_px = 512", "size_px = 9000", "35:11", "9000", &["16", "8192"]),
    ("sigma_um = 16.25", "sigma_um = 1e300", "10:26", "1e300", &["1e300"]),
    ("size_px = 512", "size_px = 8192\nlight_samples = 1024", "36:1", "light_samples", &["8192 x 1024 x 1 = 8388608", "size_px"]),
    ("size_px = 512", "size_px = 2048\nanimate = { kind = \"light\", axis = \"viewing\", frames = 2, size_px = 5000 }\npixel_samples = 1024", "37:1", "pixel_samples", &["5000 x 1024 x 1"]),
    ("size_px = 512", "size_px = 0", "35:11", "0", &["16", "8192"]),
    ("size_px = 512", "light_samples = 0", "35:17", "0", &["4096"]),
    ("size_px = 512", "exposure = { ev = inf }", "35:19", "inf", &["finite"]),
    ("tilt_deg = 20", "tilt_deg = 90", "40:12", "90", &["-89", "89 degrees"]),
    ("= 0.53", "= 100", "34:64", "100", &["90 degrees"]),
    // Unknown words.
    ("illuminant = \"D65\"", "illuminant = \"d65\"", "8:14", "\"d65\"", &["\"D65\"", "\"F12\""]),
    ("illuminant = \"D65\"", "illuminant = \"F13\"", "8:14", "\"F13\"", &["illuminant"]),
    ("illuminant = \"D65\"", "illuminant = 65", "8:14", "65", &["name"]),
    ("windows = \"grid\"", "windows = \"center\"", "11:11", "\"center\"", &["\"grid\"", "\"centre\""]),
    ("edge = \"tile\"", "edge = \"mirror\"", "10:40", "\"mirror\"", &["\"tile\"", "\"fade\""]),
    ("level = \"plane\"", "level = \"plan\"", "23:9", "\"plan\"", &["\"quadratic\"", "\"plane\""]),
    ("size = 501", "storage = \"f16\"", "15:11", "\"f16\"", &["\"auto\"", "\"half\"", "\"float\""]),
    ("size = 501", "basis = \"Chebyshev\"", "15:9", "\"Chebyshev\"", &["\"chebyshev\""]),
    ("size = 501", "prefilter = \"box\"", "15:13", "\"box\"", &["\"auto\"", "\"none\""]),
    ("material = { n = 1.56 }", "material = \"ideal\"\nalbedo = [0.4, 0.2, 0.1]", "25:10", "[0.4, 0.2, 0.1]", &["`specimen \"elaphe\": albedo`", "{ n = 1.56 }"]),
    ("material = { n = 1.56 }", "material = { n = 1.56 }\nalbedo = [0.4, 1.2, 0.1]", "25:16", "1.2", &["`specimen \"elaphe\": albedo[1]`", "0", "1"]),
    ("material = { n = 1.56 }", "material = { n = 1.56 }\nalbedo = 0.4", "25:10", "0.4", &["[0.45, 0.16, 0.05]"]),
    ("shape = \"sphere\"", "shape = \"spere\"", "33:9", "\"spere\"", &["\"spere\"", "\"sphere\""]),
    ("shape = \"sphere\"", "mesh = \"torus.obj\"", "33:1", "mesh", &["`mesh`", "[[scene]]", "`shape = \"torus.obj\"`"]),
    ("shape = \"sphere\"", "shape = \"sphere\"\nModel = 3", "34:1", "Model", &["`Model`", "[[scene]]", "`shape = \"body.obj\"`"]),
    ("shape = \"sphere\"", "shape = \"torus\"", "33:9", "\"torus\"", &["\"body.obj\"", "\"torus\"", "\"hemisphere\"", "\"sphere\"", "\"snake\"", "\"patch\"", "\"screen\""]),
    ("check = \"auto\"", "check = \"on\"", "43:9", "\"on\"", &["\"required\""]),
    ("{ full_scale_nm = 375 }", "{ unit = \"micron\" }", "22:19", "\"micron\"", &["\"um\"", "\"angstrom\""]),
    ("{ n = 1.56 }", "\"keratin\"", "24:12", "\"keratin\"", &["\"ideal\"", "{ n = 1.56 }"]),
    ("{ n = 1.56 }", "{ metal = \"alumnium\" }", "24:22", "\"alumnium\"", &["`specimen \"elaphe\": material.metal`", "did you mean \"aluminium\"", "\"silver\""]),
    ("{ n = 1.56 }", "{ metal = \"silicon\" }", "24:22", "\"silicon\"", &["{ substance = \"silicon\" }"]),
    ("{ n = 1.56 }", "{ substance = \"chitine\" }", "24:26", "\"chitine\"", &["did you mean \"chitin\"", "\"gold\""]),
    ("{ n = 1.56 }", "{ substance = \"alpha_keratin\" }", "24:26", "\"alpha_keratin\"", &["\"beta_keratin\"", "{ n = 1.55 }"]),
    ("{ n = 1.56 }", "{ metal = 5 }", "24:22", "5", &["string"]),
    ("{ n = 1.56 }", "{ metal = \"gold\", k = 2 }", "24:30", "k", &["`specimen \"elaphe\": material.k`", "`metal`"]),
    ("{ n = 1.56 }", "{ file = \"nk.csv\", substance = \"chitin\" }", "24:14", "file", &["`substance`"]),
    ("{ n = 1.56 }", "{ file = \"nowhere.csv\" }", "24:21", "\"nowhere.csv\"", &["`specimen \"elaphe\": material.file`", "read"]),
    ("{ n = 1.56 }", "{ file = \"lamp.csv\" }", "24:21", "\"lamp.csv\"", &["`wavelength_nm,n,k`"]),
    ("{ n = 1.56 }", "{ file = \"nk_worn.csv\" }", "24:21", "\"nk_worn.csv\"", &["line 3", "n = 0"]),
    ("{ n = 1.56 }", "{ file = \"nk_red.csv\" }", "24:21", "\"nk_red.csv\"", &["nk_red.csv is known from 500 to 800 nm", "380 to 780 nm", "`wavelength_nm`"]),
    ("[380, 780]", "[250, 780]\nmaterial = { metal = \"gold\" }", "10:22", "\"gold\"", &["300.9 to 892 nm", "250 to 780 nm"]),
    ("size_px = 512", "exposure = \"bright\"", "35:12", "\"bright\"", &["\"auto\"", "{ ev = 0.5 }"]),
    // Parts that do not fit together.
    ("{ full_scale_nm = 375 }", "{ full_scale_nm = 375, unit = \"nm\" }", "22:10", "{ full_scale_nm = 375, unit = \"nm\" }", &["one", "`full_scale_nm`", "`unit`"]),
    ("{ full_scale_nm = 375 }", "{ offset_nm = 3 }", "22:10", "{ offset_nm = 3 }", &["one", "none"]),
    ("{ full_scale_nm = 375 }", "{ unit = \"nm\", offset_nm = 3 }", "22:25", "offset_nm", &["`nm_per_count`"]),
    ("{ full_scale_nm = 375 }", "{ nm_per_count = 0 }", "22:27", "0", &[" 0"]),
    ("illuminant = \"D65\"", "illuminant = { lines_nm = [] }", "8:27", "[]", &["1000"]),
    ("illuminant = \"D65\"", "illuminant = { lines_nm = [633, 633] }", "8:33", "633", &["repeat"]),
    ("illuminant = \"D65\"", "illuminant = { lines_nm = [633], power = [1, 2] }", "8:42", "[1, 2]", &["1", "2"]),
    ("illuminant = \"D65\"", "illuminant = { lines_nm = [633], power = [0] }", "8:43", "0", &["above 0"]),
    ("illuminant = \"D65\"", "illuminant = { lines_nm = [200000] }", "8:28", "200000", &["200", "2500"]),
    ("illuminant = \"D65\"", "illuminant = { lines_nm = [1064] }", "9:17", "[380, 780]", &["1064 nm"]),
    ("illuminant = \"D65\"\nwavelength_nm = [380, 780]", "illuminant = { lines_nm = [1064] }\n", "8:1", "illuminant", &["380", "780"]),
    ("tilt_deg = 20", "incidence_deg = 20", "40:1", "incidence_deg", &["\"patch\"", "`screen`"]),
    ("size_px = 512", "width_mm = 20", "35:1", "width_mm", &["\"sphere\"", "`patch`", "`screen`"]),
    ("shape = \"patch\"\ntilt_deg = 20", "shape = \"screen\"\nlight = { direction = [0, 0, 1] }", "40:1", "light", &["\"screen\""]),
    ("tilt_deg = 20", "width_mm = 60", "40:1", "width_mm", &["`width_mm`"]),
    ("tilt_deg = 20", "distance_mm = 20", "40:1", "distance_mm", &["`width_mm`"]),
    ("tilt_deg = 20", "tilt_deg = -89", "40:1", "tilt_deg", &["light"]),
    ("shape = \"patch\"\ntilt_deg = 20", "shape = \"screen\"\nincidence_deg = 85\nbeam_diameter_mm = 50", "40:1", "incidence_deg", &["screen"]),
    ("size_px = 512", "specimen = \"elaph\"", "35:12", "\"elaph\"", &["\"elaphe\"", "\"xenopeltis\""]),
    // Meshes.
    ("\"sphere\"\nlight", "\"none.obj\"\nlight", "33:9", "\"none.obj\"", &["exist"]),
    ("\"sphere\"\nlight", "\"snake.tif\"\nlight", "33:9", "\"snake.tif\"", &["shown", ".obj, .gltf or .glb"]),
    ("\"sphere\"\nlight", "\"bare.obj\"\nlight", "33:9", "\"bare.obj\"", &["shown", "4"]),
    ("\"sphere\"\nlight", "\"body.obj\"\nmaterials = { back = \"elaphe\" }\nlight", "34:13", "{ back = \"elaphe\" }", &["\"back\"", "\"belly\""]),
    ("\"sphere\"\nlight", "\"body.obj\"\nmaterials = { back = \"elaphe\", bely = \"elaphe\" }\nlight", "34:39", "\"elaphe\"", &["`scene[0].materials.bely`", "\"back\"", "\"belly\""]),
    ("\"sphere\"\nlight", "\"body.obj\"\nmaterials = { back = \"elaph\", belly = \"elaphe\" }\nlight", "34:22", "\"elaph\"", &["`scene[0].materials.back`", "\"elaphe\""]),
    ("\"sphere\"\nlight", "\"body.obj\"\nmaterials = \"elaphe\"\nlight", "34:13", "\"elaphe\"", &["table"]),
    ("\"sphere\"\nlight", "\"body.obj\"\nspecimen = \"elaphe\"\nmaterials = { back = \"elaphe\", belly = \"elaphe\" }\nlight", "34:1", "specimen", &["one"]),
    ("\"sphere\"\nlight", "\"body.obj\"\ncamera = { position = [0, 0, 5] }\nlight", "34:10", "{ position = [0, 0, 5] }", &["`target`"]),
    ("\"sphere\"\nlight", "\"body.obj\"\ncamera = { position = [0, 0, 5], target = [0, 0, 5] }\nlight", "34:10", "{ position = [0, 0, 5], target = [0, 0, 5] }", &["sees"]),
    ("\"sphere\"\nlight", "\"body.obj\"\ncamera = { position = [0, 0, 5], target = [0, 0, 0], fov_deg = 20, width = 2 }\nlight", "34:68", "width", &["one"]),
    ("\"sphere\"\nlight", "\"body.obj\"\ncamera = { position = [0, 0, 5], target = [0, 0, 0], fov_deg = 180 }\nlight", "34:64", "180", &["0.01", "170 degrees"]),
    ("\"sphere\"\nlight", "\"body.obj\"\ntilt_deg = 3\nlight", "34:1", "tilt_deg", &["`patch`", "`light`", "`environment`", "`camera`", "`materials`"]),
    ("\"sphere\"\nlight", "\"sphere\"\ncamera = { position = [0, 0, 5], target = [0, 0, 0] }\nlight", "34:1", "camera", &["\"sphere\"", "`a mesh`"]),
    // Lights.
    ("[0.3, 0.2, 1.0]", "[0, 0, 0]", "34:24", "[0, 0, 0]", &["zero"]),
    ("[0.3, 0.2, 1.0]", "[0.3, 0.2]", "34:24", "[0.3, 0.2]", &["three"]),
    ("[0.3, 0.2, 1.0]", "[0.3, nan, 1.0]", "34:30", "nan", &["`scene[0].light[0].direction[1]`", "finite"]),
    ("shape = \"sphere\"\nlight = [{ direction = [0.3, 0.2, 1.0]", "shape = \"patch\"\nlight = [{ direction = [0.3, 0.2, -0.1]", "34:24", "[0.3, 0.2, -0.1]", &["horizon"]),
    ("shape = \"sphere\"\nlight = [{ direction = [0.3, 0.2, 1.0]", "shape = \"hemisphere\"\nlight = [{ direction = [1, 0, 0]", "34:24", "[1, 0, 0]", &["horizon"]),
    ("light = [{ direction = [0.3, 0.2, 1.0], angular_diameter_deg = 0.53 }]", "light = []", "34:9", "[]", &["64"]),
    ("shape = \"sphere\"\nlight = [{", "shape = \"hemisphere\"\nlight = [{ direction = [0, 0, 1] }, {", "34:9", "[{ direction = [0, 0, 1] }, { direction = [0.3, 0.", &["1", "2"]),
    // Names.
    ("\"xenopeltis\"", "\"elaphe\"", "28:8", "\"elaphe\"", &["repeat"]),
    ("\"xenopeltis\"", "\"Elaphe\"", "28:8", "\"Elaphe\"", &["case"]),
    ("name = \"patch\"", "name = \"sphere\"", "38:8", "\"sphere\"", &["repeat"]),
    ("\"xenopeltis\"", "\"../up\"", "28:8", "\"../up\"", &["folder", "a-z"]),
    ("\"xenopeltis\"", "\"\"", "28:8", "\"\"", &["64"]),
    ("\"xenopeltis\"", "\"atlas.json\"", "28:8", "\"atlas.json\"", &["a-z"]),
    ("\"xenopeltis\"", "\"Lpt1\"", "28:8", "\"Lpt1\"", &["device"]),
    ("\"squamates\"", "\"-rf\"", "4:8", "\"-rf\"", &["`atlas.name`", "letter"]),
    // Files.
    ("scans = [\"snake.tif\"]\npitch", "scans = [\"snake.tif\", \"nowhere.tif\"]\npitch", "20:23", "\"nowhere.tif\"", &["`specimen \"elaphe\": scans[1]`", "exist", "nowhere.tif"]),
    ("scans = [\"snake.tif\"]\npitch", "scans = [\".\"]\npitch", "20:10", "\".\"", &["`specimen \"elaphe\": scans[0]`", "a folder where a file is expected"]),
    ("scans = [\"snake.tif\"]\npitch", "scans = [\"snake_*.tif\"]\npitch", "20:10", "\"snake_*.tif\"", &["file"]),
    ("scans = [\"snake.tif\"]\npitch", "scans = []\npitch", "20:9", "[]", &["file"]),
    ("scans = [\"snake.tif\"]\npitch", "scans = [\"\"]\npitch", "20:10", "\"\"", &["empty"]),
    ("level = \"plane\"", "measured = \"nowhere.csv\"", "23:12", "\"nowhere.csv\"", &["`specimen \"elaphe\": measured`", "exist"]),
    ("level = \"plane\"", "measured = { acceptance_deg = 1 }", "23:12", "{ acceptance_deg = 1 }", &["`file`"]),
    ("level = \"plane\"", "measured = { file = \"measured.csv\", acceptance_deg = 61 }", "23:54", "61", &["`specimen \"elaphe\": measured.acceptance_deg`", "60"]),
    ("level = \"plane\"", "measured = { file = \"measured.csv\", bandwidth_um = 0.002 }", "23:37", "bandwidth_um", &["bandwidth_nm = 2"]),
    ("illuminant = \"D65\"", "illuminant = \"nowhere.csv\"", "8:14", "\"nowhere.csv\"", &["`optics.illuminant`", "read"]),
    ("illuminant = \"D65\"", "illuminant = \"snake.tif\"", "8:14", "\"snake.tif\"", &["`wavelength_nm,power`"]),
    ("tilt_deg = 20", "environment = \"nowhere.exr\"", "40:15", "\"nowhere.exr\"", &["`scene[1].environment`", "read"]),
    ("tilt_deg = 20", "environment = \"lamp.csv\"", "40:15", "\"lamp.csv\"", &["OpenEXR"]),
    ("tilt_deg = 20", "environment = { file = \"flat.exr\" }", "40:24", "\"flat.exr\"", &["4 x 4", "wide"]),
    ("tilt_deg = 20", "environment = { file = \"night.exr\" }", "40:24", "\"night.exr\"", &["black"]),
    ("tilt_deg = 20", "environment = { rotate_deg = 9 }", "40:15", "{ rotate_deg = 9 }", &["`file`"]),
    ("tilt_deg = 20", "environment = { file = \"sky.exr\", scale = 0 }", "40:43", "0", &["above 0"]),
    ("shape = \"patch\"\ntilt_deg = 20", "shape = \"hemisphere\"\nenvironment = \"sky.exr\"", "40:1", "environment", &["apply", "`sphere`"]),
    ("tilt_deg = 20", "animate = { frames = 9 }", "40:11", "{ frames = 9 }", &["`kind`"]),
    ("tilt_deg = 20", "animate = { kind = \"spin\" }", "40:20", "\"spin\"", &["\"turntable\"", "\"light\""]),
    ("tilt_deg = 20", "animate = { kind = \"light\", degrees = 0 }", "40:29", "degrees", &["moves"]),
    ("tilt_deg = 20", "animate = { kind = \"light\", frames = 1 }", "40:38", "1", &["1000"]),
    ("tilt_deg = 20", "animate = { kind = \"light\", frames = 1000 }", "40:11", "{ kind = \"light\", frames = 1000 }", &["pixels", "`size_px`"]),
    ("shape = \"patch\"\ntilt_deg = 20", "shape = \"sphere\"\nanimate = { kind = \"turntable\" }", "40:13", "kind", &["same", "viewing"]),
    ("shape = \"patch\"\ntilt_deg = 20", "shape = \"screen\"\nanimate = { kind = \"light\" }", "40:13", "kind", &["move"]),
    ("illuminant = \"D65\"", "illuminant = \"dark.csv\"", "9:1", "wavelength_nm", &["light"]),
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
    // As compilers have it, so that editors jump there; then what was found and what may stand instead, and the line itself.
    let place = format!("{}:15:8: `tables.size` ", folder.path().join("m.toml").display());
    assert!(message.starts_with(&place), "{message}");
    for needed in ["500", "499", "501"] {
        assert!(message.lines().next().unwrap().contains(needed), "{message}");
    }
    assert!(message.ends_with("\n 15 | size = 500\n    |        ^^^"), "{message}");
}

#[test]
fn no_specimen_is_a_fault() {
    let folder = folder();
    let text = &GOOD[..GOOD.find("[[specimen]]").unwrap()];
    let message = parse_in(folder.path(), text).unwrap_err().to_string();
    assert!(message.contains("`specimen`"), "{message}");
    let message = parse_in(folder.path(), &format!("specimen = []\n{text}")).unwrap_err().to_string();
    assert!(message.contains("specimen"), "{message}");
    let message = parse_in(folder.path(), "").unwrap_err().to_string();
    assert!(message.contains(":1:1: `schema`"), "{message}");
}

#[test]
fn scenes_to_cover_must_be_there() {
    let folder = folder();
    let good = good_with("size = 501", "serve = [\"q\"]");
    let message = parse_in(folder.path(), &good).unwrap_err().to_string();
    assert!(["\"sphere\"", "\"patch\"", "\"q\""].iter().all(|name| message.contains(name)), "{message}");
    let message = parse_in(folder.path(), &good[..good.find("[[scene]]").unwrap()]).unwrap_err().to_string();
    assert!(message.contains(":15:9: `tables.serve`"), "{message}");
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
    assert!(
        matches!(manifest::load(&path), Err(Error::Library(diffraction_brdf::Error::Call(message))) if message.contains("bad.toml"))
    );
    assert!(matches!(manifest::load(folder.path()), Err(Error::Library(diffraction_brdf::Error::Call(_)))));
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
