//! One number worked out step by step from the tables: the example in `FORMAT.md`.
//!
//! Written for reading, in double precision, straight from the formula: it stands beside the fast evaluation as a
//! second opinion.

use ndarray::Array3;
use rustfft::num_complex::Complex;
use serde::Serialize;

use diffraction_brdf::direction::{self, Vec3, Xyz};
use diffraction_brdf::front_factor::Factor;
use diffraction_brdf::material::{self, Material};
use diffraction_build::tables::model::{Basis, Lobe, Restriction, TableSet};

/// A look-up between four texels.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Lookup {
    /// Position in texels along the columns and the rows; whole numbers are texel centres.
    pub position: [f64; 2],
    /// Column and row of the texel before that position; the other three follow it.
    pub texel: [usize; 2],
    /// The rest of the position: weights of the following column and row.
    pub fraction: [f64; 2],
}

/// One basis function's share.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Term {
    /// `T_n(2t - 1)` or `|w|^n`.
    pub basis_value: f64,
    /// Y at the four texels, scale applied: this row then the next, this column then the next.
    pub corners_y: [f64; 4],
    /// Interpolated X, Y, Z in 1/sr.
    pub value: Xyz,
}

/// The lobe's share.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct LobeShare {
    /// `sqrt(u² + v²)`.
    pub radius: f64,
    /// Where in the coherent image; `None` beyond the lobe's radius, where it is zero.
    pub lookup: Option<Lookup>,
    /// Interpolated coherent part in 1/sr.
    pub coherent: Xyz,
    /// Radius of the lobe's image in the horizon, and the coherent part there, with the vector factor.
    pub image: Option<(f64, Xyz)>,
    /// Sum of the cross term in 1/sr, before the division by `|w|`; zero beyond its square.
    pub cross: Xyz,
}

/// Every intermediate result on the way from two directions to the BRDF.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct WorkedNumber {
    /// theta_i, phi_i, theta_r, phi_r in degrees.
    pub angles_deg: [f64; 4],
    /// Unit vector to the light.
    pub wi: Vec3,
    /// Unit vector to the viewer.
    pub wo: Vec3,
    /// `-wi - wo`.
    pub q: Vec3,
    /// `|w| / sqrt(4 - u² - v²)`.
    pub t: f64,
    /// Where in the tables.
    pub lookup: Lookup,
    /// Lowest and highest `t` between the texels there, where tables are restricted to scenes; [0, 1] elsewhere.
    pub range: [f64; 2],
    /// Where `t` lies in that range: what the tables' polynomials are evaluated at.
    pub s: f64,
    /// One per table.
    pub terms: Vec<Term>,
    /// Sum of the tables' terms, before any division.
    pub sum: Xyz,
    /// The lobe; `None` where there is none.
    pub lobe: Option<LobeShare>,
    /// `(1 + wi·wo)² / (cos_i cos_o)`.
    pub geometry_factor: f64,
    /// Cosine between the light and the half vector.
    pub cos_half: f64,
    /// Fresnel reflectance at that angle.
    pub reflectance: f64,
    /// Shadowing factor; 1 where it is not applied.
    pub shadowing: f64,
    /// `D` of `FORMAT.md`: the factor of tables and cross term, without shadowing.
    pub diffuse_factor: f64,
    /// `C`: the factor of the lobe, likewise.
    pub coherent_factor: f64,
    /// The BRDF in 1/sr.
    pub xyz: Xyz,
}

/// Evaluates the tables at theta_i, phi_i, theta_r, phi_r in degrees, linear between texels. Both directions must lie
/// above the surface.
pub fn work_number(tables: &TableSet, angles_deg: [f64; 4]) -> WorkedNumber {
    let wi = direction::from_angles_deg(angles_deg[0], angles_deg[1]);
    let wo = direction::from_angles_deg(angles_deg[2], angles_deg[3]);
    assert!(wi[2] > 0.0 && wo[2] > 0.0, "both directions lie above the surface");
    let q = direction::wave_vector_change(wi, wo);
    let [u, v, w] = q;
    let t = relative_w(q);

    let (lookup, range) = match &tables.restriction {
        None => (look_up([(u + 2.0) / 4.0, (2.0 - v) / 4.0], [tables.size(), tables.size()]), [0.0, 1.0]),
        Some(window) => place_in_window(window, u, v),
    };
    let s = (t - range[0]) / (range[1] - range[0]);
    let terms: Vec<Term> =
        tables.tables.iter().enumerate().map(|(n, table)| term(tables.basis, n, w, s, table, &lookup)).collect();
    let sum = weighted_sum(&terms);
    let vector = tables.front_factor.factor == Factor::Vector;
    let lobe = tables.lobe.as_ref().map(|lobe| {
        let image = vector.then(|| {
            let radius = image_radius(wi, wo);
            let t = relative_w([radius, 0.0, w]);
            (radius, lobe_share(lobe, [radius, 0.0, w], t).coherent)
        });
        LobeShare { image, ..lobe_share(lobe, q, t) }
    });

    let geometry_factor = direction::geometry_factor(wi, wo);
    let cos_half = material::cos_half_angle(wi, wo);
    let reflectance = material::reflectance(tables.front_factor.material, cos_half);
    let shadowing = if tables.front_factor.shadowing { direction::v_cavity_shadowing(wi, wo) } else { 1.0 };
    let scalar = reflectance * geometry_factor;
    let (diffuse_factor, coherent_factor) = match tables.front_factor.factor {
        Factor::Scalar => (scalar, scalar / (w * w)),
        Factor::Vector => (vector_factor(tables.front_factor.material, wi, wo).unwrap_or(scalar), reflectance),
    };
    let xyz = std::array::from_fn(|channel| {
        let diffuse = match tables.basis {
            Basis::Chebyshev => sum[channel],
            Basis::Taylor => sum[channel] / (w * w),
        };
        let cross = lobe.as_ref().map_or(0.0, |lobe| lobe.cross[channel] / w.abs());
        let coherent =
            lobe.as_ref().map_or(0.0, |lobe| lobe.coherent[channel] + lobe.image.map_or(0.0, |i| i.1[channel]));
        shadowing * (diffuse_factor * (diffuse + cross) + coherent_factor * coherent)
    });
    WorkedNumber {
        angles_deg,
        wi,
        wo,
        q,
        t,
        lookup,
        range,
        s,
        terms,
        sum,
        lobe,
        geometry_factor,
        cos_half,
        reflectance,
        shadowing,
        diffuse_factor,
        coherent_factor,
        xyz,
    }
}

/// `sqrt(u² + v² + 4 h_i h_o)`, by angles: `h = 1 - sin θ`.
fn image_radius(wi: Vec3, wo: Vec3) -> f64 {
    let [u, v, _] = direction::wave_vector_change(wi, wo);
    let h = |d: Vec3| 1.0 - (1.0 - d[2] * d[2]).sqrt();
    (u * u + v * v + 4.0 * h(wi) * h(wo)).sqrt()
}

/// The vector factor by angles, polarisation by polarisation; `None` for the ideal reflector, which has no index.
fn vector_factor(material: Material, wi: Vec3, wo: Vec3) -> Option<f64> {
    let index = match material {
        Material::Ideal => return None,
        Material::Dielectric { n } => Complex::new(n, 0.0),
        Material::Conductor { n, k } => Complex::new(n, k),
    };
    let (eps, one) = (index * index, Complex::new(1.0, 0.0));
    let [theta_i, theta_o] = [wi, wo].map(|d| d[2].min(1.0).acos());
    // From the direction of travel to that of the scattered light: a half turn from the light's own azimuth.
    let phi = wo[1].atan2(wo[0]) - wi[1].atan2(wi[0]) - std::f64::consts::PI;
    let [a, b] = [theta_i, theta_o].map(|theta| (eps - one * theta.sin().powi(2)).sqrt());
    let [s_i, s_o] = [(theta_i, a), (theta_o, b)].map(|(theta, root)| root + theta.cos());
    let [p_i, p_o] = [(theta_i, a), (theta_o, b)].map(|(theta, root)| eps * theta.cos() + root);
    let amplitudes = [
        one * phi.cos() / (s_i * s_o),
        b * phi.sin() / (s_i * p_o),
        a * phi.sin() / (p_i * s_o),
        (a * b * phi.cos() - eps * theta_i.sin() * theta_o.sin()) / (p_i * p_o),
    ];
    let q: f64 = amplitudes.iter().map(|amplitude| ((eps - one) * amplitude).norm_sqr()).sum();
    Some(2.0 * theta_i.cos() * theta_o.cos() * q)
}

/// Where in the window of restricted tables, and the range of `t` there.
fn place_in_window(window: &Restriction, u: f64, v: f64) -> (Lookup, [f64; 2]) {
    let (rows, columns, _) = window.range.dim();
    let texel = 4.0 / (window.size - 1) as f64;
    let at = [(u + 2.0) / texel - window.first[1] as f64, (2.0 - v) / texel - window.first[0] as f64];
    let last = [(columns - 1) as f64, (rows - 1) as f64];
    let lookup = look_up([at[0] / last[0], at[1] / last[1]], [columns, rows]);
    let range = term(Basis::Chebyshev, 0, 0.0, 0.0, &window.range, &lookup).value;
    (lookup, [range[0], range[1]])
}

/// `t` in [0, 1]; 0 at the rim of the disc, where `|w|` can only be 0.
fn relative_w([u, v, w]: Vec3) -> f64 {
    let w_max_squared = 4.0 - u * u - v * v;
    if w_max_squared <= 0.0 { 0.0 } else { (w.abs() / w_max_squared.sqrt()).min(1.0) }
}

/// From positions in [0, 1] between the first and the last texel centre.
fn look_up(relative: [f64; 2], samples: [usize; 2]) -> Lookup {
    let position: [f64; 2] = std::array::from_fn(|axis| relative[axis].clamp(0.0, 1.0) * (samples[axis] - 1) as f64);
    let texel = std::array::from_fn(|axis| (position[axis] as usize).min(samples[axis].saturating_sub(2)));
    let fraction = std::array::from_fn(|axis| position[axis] - texel[axis] as f64);
    Lookup { position, texel, fraction }
}

/// The four texels of a look-up and their weights; the last texel stands in for one beyond it.
fn corners(image: &Array3<f32>, lookup: &Lookup) -> [(Xyz, f64); 4] {
    let (rows, columns, _) = image.dim();
    let [x, y] = lookup.fraction;
    std::array::from_fn(|corner| {
        let (dx, dy) = (corner % 2, corner / 2);
        let row = (lookup.texel[1] + dy).min(rows - 1);
        let column = (lookup.texel[0] + dx).min(columns - 1);
        let weight = (if dx == 1 { x } else { 1.0 - x }) * (if dy == 1 { y } else { 1.0 - y });
        (std::array::from_fn(|channel| f64::from(image[[row, column, channel]])), weight)
    })
}

fn term(basis: Basis, n: usize, w: f64, t: f64, image: &Array3<f32>, lookup: &Lookup) -> Term {
    let basis_value = match basis {
        Basis::Chebyshev => chebyshev(n, 2.0 * t - 1.0),
        Basis::Taylor => w.abs().powi(n as i32),
    };
    let corners = corners(image, lookup);
    Term { basis_value, corners_y: corners.map(|(xyz, _)| xyz[1]), value: interpolated(&corners) }
}

/// `T_n(x)` by its cosine.
fn chebyshev(n: usize, x: f64) -> f64 {
    (n as f64 * x.clamp(-1.0, 1.0).acos()).cos()
}

fn interpolated(corners: &[(Xyz, f64); 4]) -> Xyz {
    std::array::from_fn(|channel| corners.iter().map(|(xyz, weight)| xyz[channel] * weight).sum())
}

fn weighted_sum(terms: &[Term]) -> Xyz {
    std::array::from_fn(|channel| terms.iter().map(|term| term.basis_value * term.value[channel]).sum())
}

fn lobe_share(lobe: &Lobe, q: Vec3, t: f64) -> LobeShare {
    let [u, v, w] = q;
    let (radius, width) = (u.hypot(v), 2.0 * lobe.radius_max);
    let mut share = LobeShare { radius, lookup: None, coherent: [0.0; 3], image: None, cross: [0.0; 3] };
    if radius < lobe.radius_max {
        let (t_samples, radius_samples, _) = lobe.coherent.dim();
        let lookup = look_up([radius / lobe.radius_max, t], [radius_samples, t_samples]);
        share.coherent = interpolated(&corners(&lobe.coherent, &lookup));
        share.lookup = Some(lookup);
    }
    if u.abs().max(v.abs()) < lobe.radius_max {
        let relative = [(u + lobe.radius_max) / width, (lobe.radius_max - v) / width];
        let patch_term = |(n, patch): (usize, &Array3<f32>)| {
            let (rows, columns, _) = patch.dim();
            term(Basis::Chebyshev, n, w, t, patch, &look_up(relative, [columns, rows]))
        };
        let terms: Vec<Term> = lobe.cross.iter().enumerate().map(patch_term).collect();
        share.cross = weighted_sum(&terms);
    }
    share
}

#[cfg(test)]
mod tests {
    use super::*;
    use diffraction_brdf::spectrum::Illuminant;
    use diffraction_build::optics::config::{Edge, OpticsConfig, Windows};

    fn optics() -> OpticsConfig {
        OpticsConfig::ideal(Illuminant::E, 16_250.0, Edge::Tile, Windows::Grid)
    }

    /// Tables that are linear in u and v, which bilinear interpolation gives back exactly.
    fn linear_tables(basis: Basis, lobe: Option<Lobe>) -> TableSet {
        let table = |a: f64, b: f64, c: f64| {
            Array3::from_shape_fn((9, 9, 3), |(row, column, channel)| {
                let (u, v) = (-2.0 + column as f64 / 2.0, 2.0 - row as f64 / 2.0);
                ((a + b * u + c * v) * (1 + channel) as f64) as f32
            })
        };
        let tables = vec![table(4.0, 0.5, -0.25), table(1.0, -0.125, 2.0), table(-0.5, 0.75, 0.0)];
        TableSet {
            basis,
            tables,
            lobe,
            prefilter_width: 0.0,
            front_factor: optics().front_factor(),
            restriction: None,
            usable_radius: 2.0,
        }
    }

    const ANGLES: [f64; 4] = [35.0, 20.0, 61.0, 250.0];

    #[test]
    fn linear_tables_give_the_formula_in_closed_form() {
        let worked = work_number(&linear_tables(Basis::Chebyshev, None), ANGLES);
        let [u, v, w] = worked.q;
        let t = w.abs() / (4.0 - u * u - v * v).sqrt();
        let x = 2.0 * t - 1.0;
        let tables = [4.0 + 0.5 * u - 0.25 * v, 1.0 - 0.125 * u + 2.0 * v, -0.5 + 0.75 * u];
        let sum = tables[0] + tables[1] * x + tables[2] * (2.0 * x * x - 1.0);
        let g = (1.0 + direction::dot(worked.wi, worked.wo)).powi(2) / (worked.wi[2] * worked.wo[2]);
        for channel in 0..3 {
            let expected = g * sum * (1 + channel) as f64;
            assert!((worked.xyz[channel] / expected - 1.0).abs() < 1e-12, "{channel}");
        }
        let taylor = work_number(&linear_tables(Basis::Taylor, None), ANGLES);
        let expected = g * (tables[0] + tables[1] * w.abs() + tables[2] * w * w) / (w * w);
        assert!((taylor.xyz[0] / expected - 1.0).abs() < 1e-12);
    }

    #[test]
    fn the_lobe_counts_inside_its_radius_only() {
        let coherent = Array3::from_shape_fn((3, 5, 3), |(t, radius, _)| (1.0 + t as f32) * (4.0 - radius as f32));
        let cross = vec![Array3::from_elem((3, 3, 3), 0.25f32), Array3::from_elem((3, 3, 3), 2.0f32)];
        let set = linear_tables(Basis::Chebyshev, Some(Lobe { coherent, radius_max: 0.2, cross }));
        let without = linear_tables(Basis::Chebyshev, None);
        assert_eq!(work_number(&set, ANGLES).xyz, work_number(&without, ANGLES).xyz);

        let near_mirror = [40.0, 0.0, 43.0, 180.0];
        let worked = work_number(&set, near_mirror);
        let [u, v, w] = worked.q;
        let (radius, x) = (u.hypot(v), 2.0 * worked.t - 1.0);
        let lobe = (1.0 + 2.0 * worked.t) * (4.0 - 4.0 * radius / 0.2) / (w * w) + (0.25 + 2.0 * x) / w.abs();
        let difference = worked.xyz[1] - work_number(&without, near_mirror).xyz[1];
        assert!((difference / (worked.geometry_factor * lobe) - 1.0).abs() < 1e-12);
    }
}
