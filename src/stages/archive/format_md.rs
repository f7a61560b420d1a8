//! The page `FORMAT.md`: how to evaluate an atlas in any renderer, with one number worked out.

use std::path::Path;

use super::format_look_ups::between_texels;
use super::format_spectral::spectral_section;
use super::specimen_file::{self, SpecimenFile};
use super::worked::{Lookup, WorkedNumber, work_number};
use diffraction_brdf::direction::Xyz;
use diffraction_brdf::error::Result;
use diffraction_brdf::files;
use diffraction_brdf::storage::{StoredLobe, StoredRestriction, StoredTables};
use diffraction_build::optics::config::{Factor, Material};
use diffraction_build::optics::dispersive::Dispersive;
use diffraction_build::tables::model::Basis;

/// Directions of the worked number in degrees, where tables answer for every direction.
const WORKED_DEG: [f64; 4] = [35.0, 20.0, 61.0, 250.0];

/// Writes the page into a version's folder, with the specimen in `specimen_folder` as its example.
///
/// # Errors
/// The disk's.
pub(crate) fn write_format(specimen_folder: &Path, version_folder: &Path) -> Result<()> {
    let (file, set) = specimen_file::load(specimen_folder)?;
    let angles = match (&set.restriction, file.check_values.first()) {
        (Some(_), Some(c)) => [c.theta_i_deg, c.phi_i_deg, c.theta_r_deg, c.phi_r_deg],
        _ => WORKED_DEG,
    };
    let worked = file.tables.derived_under.is_none().then(|| work_number(&set, angles));
    let text = format_md(&file, worked.as_ref());
    files::replace(&version_folder.join("FORMAT.md"), text.as_bytes())
}

/// The page, with `example`'s own sizes and `worked` as its number; none where spectral tables alone are stored.
pub fn format_md(example: &SpecimenFile, worked: Option<&WorkedNumber>) -> String {
    let tables = &example.tables;
    let of_xyz = |section: &dyn Fn() -> String| match tables.derived_under {
        None => section(),
        Some(_) => String::new(),
    };
    let sections = [
        introduction(&example.name),
        if tables.derived_under.is_some() { spectral_alone() } else { files_and_axes(tables) },
        of_xyz(&|| evaluation(tables)),
        factors(example),
        use_in_a_renderer(example),
        worked.map_or(String::new(), |worked| worked_number(example, worked)),
        spectral_section(example.spectral.as_ref(), tables.derived_under.is_some()),
    ];
    sections.iter().filter(|section| !section.is_empty()).map(String::as_str).collect::<Vec<_>>().join("\n")
}

fn introduction(name: &str) -> String {
    format!(
        "# How to evaluate this atlas

The tables give the luminous BRDF of a surface, `f(wi, wo)` in 1/sr, as CIE XYZ (1931, 2 degrees). `wi` and `wo` are unit
vectors to the light and to the viewer in the local frame: x along the scan's columns, y up the scan, z the outward
normal.

The file `latest` beside this version's folder names the newest; `atlas.json` in it lists specimens and the digests of files.
One that has `stale` there could not be made again, for that reason: its files are those of an older version.
Every specimen has a folder, and a renderer needs no other. Numbers on this page are those of `{name}`; those of each
specimen stand in its `specimen.json`, and each EXR header repeats what concerns its own file:

- `tables.tables`: `file` and `scale` of each table, in the order of n; `tables.u`, `tables.v`: their axes; `tables.basis`.
- `tables.lobe`: `radius_max`, and `coherent` and `cross.patches` with `file` and `scale`; `null` where there is none.
- `tables.storage`: `\"half\"` or `\"float\"`, what the tables lose as 16-bit floats decides. With these, 95 % of colours
  shift by less than `tables.rounding.half`; a renderer that keeps tables in textures of 16-bit floats shows that.
- `optics.material`: `\"ideal\"` (`R = 1`), or `{{ \"dielectric\": {{ \"n\" }} }}`, or `{{ \"conductor\": {{ \"n\", \"k\" }} }}` of
  index `n + i k`; `optics.factor`: `\"vector\"` or `\"scalar\"`, which is meant where it is absent, see Factors; `optics.shadowing`.
- `optics.sigma_nm`, `lobe_sigma_nm`, `source_deg`: the coherence that the tables were made for. They hold its blur, the lobe's too:
  nothing of it is left to evaluate.
- `spectral`: tables of single wavelengths, see the end of this page; absent where there are none.
- `check_values`: directions to test an implementation with, no energy limit: `xyz_spline` by the look-up of this page, where that is by
  splines, `xyz` by linear ones, both in double precision.
- `errors`: measured errors of Y against the reference, by cause (`what`) and region, relative to the value itself: quantiles
  `p50`, `p95`, `p99` and `worst` of the `directions` that are brighter than `floor_per_sr`, and `relative_l2` over all
  directions. `lit_share` is the share of the region that the tables show lit; of `dark_directions` others that were
  evaluated, `missed_directions` are brighter than the floor. `null` where nothing is lit. The reference is too dark by `left_out_per_sr` at most.
- `albedo`: share of the arriving light of Y that is reflected, for light from the azimuth 0 at each `theta_i_deg`. Above 1, which
  ideal reflectors and the scalar factor can reach, a path tracer has to limit it; left out where tables serve certain scenes alone.
- `energy_limit`, where something reflects more than arrives: the same, the largest over azimuths, as `albedo` at each of `cos_theta`.
  A path tracer may divide `f` by `max(1, a(wi_z), a(wo_z))`, with `a(z) = p(z) / z` and `p` the values `albedo cos_theta`,
  linear between the nodes and constant beyond them: reciprocal, and nothing then reflects more than 1 % above what arrives. Check
  values and the worked number are without it.

`scenes/` in a specimen's folder holds the pictures the tables were checked by, and `scenes/` beside `atlas.json`, where there
is one, those of scenes that show several specimens; both are for looking at.
"
    )
}

fn files_and_axes(tables: &StoredTables) -> String {
    if let Some(restriction) = &tables.restriction {
        return restricted_files(tables, restriction);
    }
    let size = tables.u.samples;
    let lobe = tables.lobe.as_ref().map_or(String::new(), lobe_files);
    format!(
        "## Files

- `table.NNN.exr`, {count} files of {size} x {size} texels: one per basis function n, channels R, G, B holding X, Y, Z.
  Column `c` (from 0) lies at `u = -2 + 4 c / {last}`, row `r` (from 0, the top scan line) at `v = 2 - 4 r / {last}`.
  Texels beyond the disc of radius 2 are 0, but for a rim of three that interpolation at its edge reads.
{lobe}- Value = stored number x `scale`; every file has its own `scale`, a power of two. Treat the images as data: no colour
  management, no gamma.
- First and last texel *centres* lie on the ends of the axis: `c = {last} (u + 2) / 4`, likewise for rows. A sampler whose coordinates
  run from 0 to 1 over the *edges* of the image wants `s = (c + 0.5) / {size}`.
{between}",
        count = tables.tables.len(),
        last = size.saturating_sub(1),
        between = between_texels(tables.basis, size),
    )
}

/// What stands in their place where spectral tables alone are stored.
fn spectral_alone() -> String {
    "## Files

This atlas holds spectral tables alone, those of the last section. `tables.tables` is empty, `tables.lobe` is `null`, there are no
`table.NNN.exr` and no `lobe.exr`, and `check_values` is empty: `spectral.check_values` are to be met.
`tables.derived_under` is the light, `illuminant` from `wavelength_nm[0]` to `wavelength_nm[1]`, under which the pictures and
`errors` are; X, Y, Z are the sums over its wavelengths that the last section tells. Where the next one speaks of `coherent(r)`,
read `power exp(-(2 pi sigma r / lambda)^2)`.

Throughout, `(u, v, w) = -wi - wo`; both directions must lie above the surface, otherwise `f = 0`. `T_0 = 1`, `T_1 = x`,
`T_n = 2 x T_(n-1) - T_(n-2)`. Value = stored number x `scale`.
"
    .to_owned()
}

/// The same for tables restricted to scenes.
fn restricted_files(tables: &StoredTables, restriction: &StoredRestriction) -> String {
    let (columns, rows, [first_row, first_column]) = (tables.u.samples, tables.v.samples, restriction.first);
    format!(
        "## Files

These tables serve the scenes of their manifest and no other direction. They are a window of a grid of {size} x {size} texels
over [-2, 2] in u and v, from column {first_column} and row {first_row} on; every specimen has a window of its own, and
`specimen.json` tells it under `tables.u`, `tables.v` and `tables.served`.

- `table.NNN.exr`, {count} files of {columns} x {rows} texels: one per basis function n, channels R, G, B holding X, Y, Z.
  Column `c` (from 0) of a window lies at `u = {u_first} + c {step}`, row `r` (from 0, the top scan line) at
  `v = {v_first} - r {step}`, with `{step}` = 4 / {last}. The header's data window says the same in columns and rows of the whole
  grid, which is the display window: a reader that fills up the display window counts `c` and `r` from the data window's corner.
- `range.exr`, as large: R and G hold `low` and `high`, the least and the greatest `t` a texel is made for, B is 1 where a texel
  is served and 0 where not. A look-up that reads a texel with B = 0, or whose `t` does not lie between the
  interpolated `low` and `high` but for rounding (a fiftieth of `high - low`), has **no answer**: report it, do not use what
  the tables hold there. The program's readers then give NaN, its pictures magenta. Rows of `lobe.exr` that no answer reads hold 0.
{lobe}- Value = stored number x `scale`; every file has its own `scale`, a power of two. Treat the images as data: no colour
  management, no gamma.
- Between texel centres interpolate linearly in both axes, tables and range alike.
",
        size = restriction.size,
        count = tables.tables.len(),
        u_first = tables.u.first,
        v_first = tables.v.first,
        step = 4.0 / (restriction.size - 1) as f64,
        last = restriction.size - 1,
        lobe = tables.lobe.as_ref().map_or(String::new(), lobe_files),
    )
}

fn lobe_files(lobe: &StoredLobe) -> String {
    let (columns, rows, radius_max) = (lobe.radius.samples, lobe.t.samples, lobe.radius_max);
    let mut text = format!(
        "- `lobe.exr`, {columns} x {rows} texels: the coherent lobe. Columns are the radius `sqrt(u^2 + v^2)` from 0 to
  `radius_max` = {radius_max}, rows are `t` from 0 to 1: row 0 is `t = 0`. R, G, B hold X, Y, Z as 32-bit floats, which a
  texture has to keep: the lobe is thousands of times its surroundings.
",
    );
    if lobe.cross.is_none() {
        text += "- The lobe has no cross term here: the sum over cross patches below is 0. Of a specimen with `lobe.cross.patches` these
  are square images, one per Chebyshev polynomial: columns `u` from `-radius_max` to `radius_max`, rows `v` from `radius_max` down.\n";
    }
    if let Some(cross) = &lobe.cross {
        let (patches, side) = (cross.patches.len(), cross.u.samples);
        text += &format!(
            "- `lobe.NNN.exr`, {patches} files of {side} x {side} texels: the lobe's cross term, one per Chebyshev polynomial.
  Columns are `u` from `-radius_max` to `radius_max`, rows `v` from `radius_max` down to `-radius_max`.
",
        );
    }
    text
}

fn evaluation(tables: &StoredTables) -> String {
    let steps = match tables.basis {
        Basis::Chebyshev if tables.restriction.is_some() => {
            "2. `t = |w| / sqrt(4 - u^2 - v^2)`, at most 1 (0 where the root is 0).
3. `low` and `high` from `range.exr` at (u, v); `s = (t - low) / (high - low)`.
4. `T_0 = 1`, `T_1 = x`, `T_n = 2 x T_(n-1) - T_(n-2)`; `diffuse` = sum over n of `T_n`, for `x = 2 s - 1`, times table n at
   (u, v).
5. Where there is a lobe: `cross` = (sum over n of `T_n`, for `x = 2 t - 1`, times cross patch n at (u, v)) / `|w|` where `|u|`
   and `|v|` both are below `radius_max`, otherwise 0; `lobe`: see Factors.
6. `f = D (diffuse + cross) + C lobe`, times the shadowing factor where it is switched on."
        }
        Basis::Chebyshev => {
            "2. `t = |w| / sqrt(4 - u^2 - v^2)`, at most 1 (0 where the root is 0); `x = 2 t - 1`.
3. `T_0 = 1`, `T_1 = x`, `T_n = 2 x T_(n-1) - T_(n-2)`.
4. `diffuse` = sum over n of `T_n` times table n at (u, v).
5. `cross` = (sum over n of `T_n` times cross patch n at (u, v)) / `|w|` where `|u|` and `|v|` both are below `radius_max`,
   otherwise 0; `lobe`: see Factors.
6. `f = D (diffuse + cross) + C lobe`, times the shadowing factor where it is switched on."
        }
        Basis::Taylor => {
            "2. `diffuse` = sum over n of `|w|^n` times table n at (u, v).
3. `f = D diffuse / w^2`, times the shadowing factor where it is switched on."
        }
    };
    format!(
        "## Evaluation

1. `(u, v, w) = -wi - wo`. Both directions must lie above the surface, `wi_z > 0` and `wo_z > 0`, otherwise `f = 0`.
{steps}

In one line: `{formula}`.

Values may lie slightly below 0, where tables and rounding leave it so: clamp before sampling in proportion to them, not before summing.
Texels count from the top row on; loaders that turn images over give row 0 last. Where look-ups are called cubic, and for lobe and cross
patches beside splines, four by four texels stand for two by two: along each axis Lagrange's cubic through four, from the texel
`clamp(floor(c) - 1, 0, n - 4)` of `n` on.
",
        formula = tables.formula
    )
}

fn factors(example: &SpecimenFile) -> String {
    let material = match example.optics.material {
        Material::Ideal => "here the material is ideal, `R = 1`".to_owned(),
        Material::Dielectric { n } => format!("here `n = {n}`, `k = 0`"),
        Material::Conductor { n, k } => format!("here `n = {n}`, `k = {k}`"),
    };
    let material = match &example.optics.dispersion {
        None => material,
        Some(Dispersive { reference_nm, table }) => format!(
            "{material}: {}, whose index depends on the wavelength, at {reference_nm:.1} nm; the tables hold how `R` at \
             normal incidence changes with the wavelength, `lobe.exr` how `R` at its own angle does",
            table.name()
        ),
    };
    let shadowing = if example.optics.shadowing { "switched on" } else { "switched off" };
    let factor = match example.optics.factor {
        Factor::Vector => "vector",
        Factor::Scalar => "scalar",
    };
    format!(
        "## Factors

`optics.factor` in `specimen.json`, here `{factor}`, says which `D`, `C` and `lobe` are meant. Write `coherent(r)` for `lobe.exr`
at the radius `r` and at `t = |w| / sqrt(4 - r^2)`, at most 1; 0 from `r = radius_max` on, and where there is no lobe.

- `scalar`: `D = R G`, `C = R G / w^2`, `lobe = coherent(sqrt(u^2 + v^2))`.
- `vector`: `C = R`, `lobe = coherent(sqrt(u^2 + v^2)) + coherent(sqrt(u^2 + v^2 + 4 h_i h_o))`, `h = z^2 / (1 + sqrt(x^2 + y^2))`
  of `wi` and of `wo`: the second is the lobe's mirror image in the horizon, the light that would leave below. `D = R G` for the
  material `ideal`; otherwise `D = 2 wi_z wo_z |eps - 1|^2 (cos^2 |1 / (A B)|^2 + sin^2 (|b / (A B')|^2 + |a / (A' B)|^2)
  + |(a b cos - eps s_i s_o) / (A' B')|^2)`, first-order vector perturbation, with `eps = (n + i k)^2`;
  `s_i = sqrt(wi_x^2 + wi_y^2)`, `a = sqrt(eps - s_i^2)`, `A = wi_z + a`, `A' = eps wi_z + a`; `s_o`, `b`, `B`, `B'` likewise of `wo`;
  `cos = -(wi_x wo_x + wi_y wo_y) / (s_i s_o)` (1 where `s_i s_o` is 0), `sin^2 = 1 - cos^2`. Roots are complex with a real
  part that is not negative.
- `G = (1 + wi.wo)^2 / (wi_z wo_z)`.
- `R`, the Fresnel reflectance of unpolarised light at the half vector ({material}): with `c = |wi + wo| / 2` and
  `g = sqrt((n + i k)^2 - 1 + c^2)` (complex, real part positive), `R = (|a|^2 + |b|^2) / 2`, `a = (c - g) / (c + g)`,
  `b = ((n + i k)^2 c - g) / ((n + i k)^2 c + g)`.
- Shadowing, {shadowing} for this specimen: with `m = (wi + wo) / |wi + wo|`,
  `min(1, 2 m_z wo_z / (wo.m), 2 m_z wi_z / (wo.m))`.
"
    )
}

fn use_in_a_renderer(example: &SpecimenFile) -> String {
    let StoredTables { usable_radius, prefilter_width, .. } = example.tables;
    format!(
        "## In a renderer

- Radiance `= f cos(theta_i) E`, with `E` the light's irradiance on a plane facing it; integrate over extended lights. `f` does
  not contain the cosine.
- X, Y, Z are relative to the illuminant the tables were made for, each specimen's `optics.illuminant` (here {illuminant}): a white Lambertian surface would read
  `Y = 1 / pi` and its X, Z those of that illuminant's white over pi. So `E` is a plain number, the light's
  luminous irradiance; its colour is in the tables already.
- Linear sRGB (D65): `R = 3.2404542 X - 1.5371385 Y - 0.4985314 Z`, `G = -0.9692660 X + 1.8760108 Y + 0.0415560 Z`,
  `B = 0.0556434 X - 0.2040259 Y + 1.0572252 Z`. Pure diffraction colours lie outside sRGB: convert after summing over lights,
  and expect negative components.
- On a mesh the program lays x along the texture coordinate u and y at a right angle to it, on the side to which v grows:
  where the coordinates are mirrored, so is the structure.
- To sample directions: `cos(theta_o) d(omega_o) = du dv`, so a density over (u, v) times `cos(theta_o)` is one over
  directions. Sample the lobe apart from the diffuse part: it is narrow and round in (u, v) about the mirror direction, where
  `t = cos(theta_i)` and `G = w^2`: it reflects `R` times the integral of `coherent` over (u, v), to a good approximation.
  With shares `a + b + c = 1` of lobe, tables and remainder the density is `p = a p_lobe + b p_tables + c / (2 pi)` in 1/sr and
  a sample's weight `f cos(theta_o) / p`. As `f` grows towards the horizon, draw the remainder evenly over solid angle, as `c / (2 pi)`
  says, and lobe and tables from what of them lies in the disc `(u + wi_x)^2 + (v + wi_y)^2 < 1`, normalised over it: then no sample
  is lost below the surface, and weights stay bounded.
- Where `specimen.json` has a `pigment`, the pictures show one below the structure besides `f`; the tables do not hold it. It
  adds `(1 - R(wi_z)) (1 - R(wo_z)) pigment.xyz_per_sr`, with the `R` of the factors above at `c = wi_z` and `c = wo_z`.
- `usable_radius` = {usable_radius}: beyond this `sqrt(u^2 + v^2)` the scan's sampling cannot answer; what the tables hold there is
  zero or doubtful.
- `prefilter_width` = {prefilter_width}: each texel is the mean over a square of this side in u and v (0: a point sample). Blur that the
  scene adds (angular size of the light, footprint of the pixel) comes on top.
",
        illuminant = serde_json::to_string(&example.optics.illuminant).unwrap_or_default().replace('"', ""),
    )
}

fn worked_number(example: &SpecimenFile, worked: &WorkedNumber) -> String {
    let [theta_i, phi_i, theta_r, phi_r] = worked.angles_deg;
    let [u, v, w] = worked.q;
    let mut text = format!(
        "## A worked number

Specimen `{name}`, light at theta {theta_i}, phi {phi_i}, viewer at theta {theta_r}, phi {phi_r} degrees.

- `wi` = {wi}, `wo` = {wo}
- `u` = {u}, `v` = {v}, `|w|` = {w}, `t` = {t}, `x` = {x}
- In the tables: {place}{range}

| n | {basis} | Y at the four texels (scale applied) | X, Y, Z interpolated |
|---|---|---|---|
",
        name = example.name,
        wi = triple(worked.wi),
        wo = triple(worked.wo),
        u = digits(u),
        v = digits(v),
        w = digits(w.abs()),
        t = digits(worked.t),
        x = digits(2.0 * worked.s - 1.0),
        place = place(&worked.lookup),
        range = match example.tables.restriction {
            None => String::new(),
            Some(_) => {
                let [low, high] = worked.range.map(digits);
                format!("; `low` = {low}, `high` = {high}, `s` = {}", digits(worked.s))
            }
        },
        basis = match example.tables.basis {
            Basis::Chebyshev => "`T_n`",
            Basis::Taylor => "`\\|w\\|^n`",
        },
    );
    for (n, term) in worked.terms.iter().enumerate() {
        let corners = term.corners_y.map(digits).join(", ");
        text += &format!("| {n} | {} | {corners} | {} |\n", digits(term.basis_value), triple(term.value));
    }
    text += &format!("\n- `diffuse` = {}\n", triple(worked.sum));
    if let Some(lobe) = &worked.lobe {
        let inside = lobe
            .lookup
            .as_ref()
            .map_or("beyond the lobe".to_owned(), |lookup| format!("in `lobe.exr`: {}", place(lookup)));
        text += &format!(
            "- `radius` = {}, {inside}; coherent = {}, cross sum = {}\n",
            digits(lobe.radius),
            triple(lobe.coherent),
            triple(lobe.cross)
        );
        if let Some((radius, coherent)) = lobe.image {
            text += &format!("- its image: radius {}, coherent = {}\n", digits(radius), triple(coherent));
        }
    }
    text += &format!(
        "- `G` = {}, `c` = {}, `R` = {}, `D` = {}, `C` = {}, shadowing {}\n- **`f` = {}** (X, Y, Z in 1/sr)\n",
        digits(worked.geometry_factor),
        digits(worked.cos_half),
        digits(worked.reflectance),
        digits(worked.diffuse_factor),
        digits(worked.coherent_factor),
        digits(worked.shadowing),
        triple(worked.xyz),
    );
    text
}

fn place(lookup: &Lookup) -> String {
    let [column, row] = lookup.texel;
    let [x, y] = lookup.fraction.map(digits);
    format!("columns {column} and {}, rows {row} and {}, weights of the second {x} and {y}", column + 1, row + 1)
}

fn triple(xyz: Xyz) -> String {
    format!("({})", xyz.map(digits).join(", "))
}

/// Seven significant digits.
fn digits(number: f64) -> String {
    if number != 0.0 && !(1e-4..1e7).contains(&number.abs()) {
        return format!("{number:.6e}");
    }
    let magnitude = if number == 0.0 { 0 } else { number.abs().log10().floor() as i32 };
    format!("{number:.*}", (6 - magnitude).max(0) as usize)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_seven_digits() {
        let cases = [(1.0, "1.000000"), (-12.3456789, "-12.34568"), (0.0, "0.000000"), (1.2345678e-5, "1.234568e-5")];
        for (number, expected) in cases.into_iter().chain([(0.00123456789, "0.001234568"), (1234567.8, "1234568")]) {
            assert_eq!(digits(number), expected);
        }
    }
}
