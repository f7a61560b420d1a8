//! Share of the incident power that tables send back, by angle of incidence.

use std::f64::consts::{FRAC_PI_2, PI, SQRT_2, TAU};
use std::ops::Range;

use rayon::prelude::*;
use serde::{Deserialize, Serialize};

use super::luminance::LuminanceTables;
use crate::ground::null_for_nan;
use crate::tables::model::TableSet;
use diffraction_brdf::direction::{Vec3, from_angles_deg, wave_vector_change};
use diffraction_brdf::energy::EnergyLimit;
use diffraction_brdf::evaluate::{Interpolation, coherent_lobe, cross_window_power};
use diffraction_brdf::front_factor::FrontFactor;
use diffraction_brdf::material::Material;

/// `∫ f cos_theta_o dω_o` for one incidence, relative to the incident power.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct PowerSum {
    /// Angle of incidence in degrees.
    pub theta_i_deg: f64,
    /// Wavelength in nm; `None` for the luminous sum.
    pub wavelength_nm: Option<f64>,
    /// The sum.
    #[serde(with = "null_for_nan")]
    pub sum: f64,
}

/// Angles of incidence in degrees of the directional albedo; power sums are those of the first, second and fourth.
const THETAS_I_DEG: [f64; 9] = [0.0, 30.0, 45.0, 60.0, 75.0, 80.0, 85.0, 88.0, 89.5];

/// Those at which power sums are taken.
const SUMMED_DEG: [f64; 3] = [0.0, 30.0, 60.0];

/// Share of the incident luminous power that a surface of the specimen's own material reflects from one direction.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize)]
pub struct DirectionalAlbedo {
    /// Polar angle of incidence in degrees; the azimuth is 0.
    pub theta_i_deg: f64,
    /// `∫ f cos_theta_o dω_o` of Y; above 1 it is more than arrives.
    #[serde(with = "null_for_nan")]
    pub albedo: f64,
}

/// What a table set reflects.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Reflected {
    /// Luminous sums `∫ f cos_theta_o dω_o` for unit reflectance.
    pub power_sums: Vec<PowerSum>,
    /// The same for the specimen's own material, up to grazing light.
    pub albedo: Vec<DirectionalAlbedo>,
    /// Share of the lobe in the power sum at normal incidence.
    pub lobe_share: Option<f64>,
}

/// What the tables reflect of light from the azimuth 0: the diffuse part over the viewer's hemisphere, the lobe over a fine
/// patch around the mirror direction. Nothing where the tables do not cover the whole hemisphere.
pub fn reflected(set: &TableSet) -> Reflected {
    let mut found = Reflected::default();
    if set.restriction.is_some() {
        return found;
    }
    let summand = Summand::new(set);
    for theta_i_deg in THETAS_I_DEG {
        let [diffuse, lobe] = summand.parts(from_angles_deg(theta_i_deg, 0.0), Fineness::Full);
        let [own, unit] = [0, 1].map(|which| diffuse[which] + lobe[which]);
        found.albedo.push(DirectionalAlbedo { theta_i_deg, albedo: own });
        if SUMMED_DEG.contains(&theta_i_deg) {
            found.power_sums.push(PowerSum { theta_i_deg, wavelength_nm: None, sum: unit });
        }
        if theta_i_deg == 0.0 && set.lobe.is_some() {
            found.lobe_share = Some(lobe[1] / unit);
        }
    }
    found
}

/// The last of them.
const GRAZING_DEG: f64 = 89.5;

/// Albedo above which a surface gives out more than it gets, and not by the quadrature's error alone.
pub(super) const ALBEDO_MAX: f64 = 1.01;

/// What is to be said of an albedo above 1, at the azimuth 0 or, by the limit, at others.
pub fn too_bright(albedo: &[DirectionalAlbedo], limit: Option<&EnergyLimit>) -> Option<String> {
    let above: Vec<&DirectionalAlbedo> = albedo.iter().filter(|at| at.albedo > ALBEDO_MAX).collect();
    let reasons = "the factor in front of its tables has no bound at grazing angles, so that path tracers want it limited \
                   (`energy_limit` in specimen.json)";
    let Some(most) = above.iter().max_by(|a, b| a.albedo.total_cmp(&b.albedo)) else {
        let limit = limit?;
        let halves = (0..=(2.0 * GRAZING_DEG) as u32).map(|half| 0.5 * f64::from(half));
        let albedos = halves.map(|theta_deg| (theta_deg, limit.albedo_at(theta_deg.to_radians().cos())));
        let (theta_deg, most) = albedos.max_by(|a, b| a.1.total_cmp(&b.1))?;
        return Some(format!(
            "the surface reflects more light than arrives from some azimuths, {most:.3} times as much at {theta_deg} degrees of \
             incidence: {reasons}"
        ));
    };
    let angles: Vec<String> = above.iter().map(|at| at.theta_i_deg.to_string()).collect();
    Some(format!(
        "the surface reflects more light than arrives at {} degrees of incidence, {:.3} times as much at {}: {reasons}",
        angles.join(", "),
        most.albedo,
        most.theta_i_deg
    ))
}

/// How finely power is summed.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Fineness {
    /// A step per texel.
    Full,
    /// A step per two texels: of a line as narrow as one texel's deviation, `2 exp(-π²/2)` = 1.4 % is missed at most.
    Coarse,
}

/// What is summed over the viewer's hemisphere: tables for every direction, made ready.
pub(super) struct Summand<'a> {
    set: &'a TableSet,
    luminance: LuminanceTables,
}

impl<'a> Summand<'a> {
    pub(super) fn new(set: &'a TableSet) -> Self {
        Self { set, luminance: LuminanceTables::new(set) }
    }

    /// Luminous power of the diffuse part and of the lobe with its cross term, each for the set's own material and for unit
    /// reflectance, relative to what arrives from `wi`.
    pub(super) fn parts(&self, wi: Vec3, fineness: Fineness) -> [[f64; 2]; 2] {
        self.weighed_parts(wi, fineness, &|_| 1.0)
    }

    /// The same with a weight for each direction to the viewer.
    pub(super) fn weighed_parts(
        &self,
        wi: Vec3,
        fineness: Fineness,
        weight: &(dyn Fn(Vec3) -> f64 + Sync),
    ) -> [[f64; 2]; 2] {
        let set = self.set;
        let own = set.front_factor;
        let unit = FrontFactor { material: Material::Ideal, ..own };
        let fronts = |wo: Vec3| [own.diffuse(wi, wo), unit.diffuse(wi, wo)];
        // A step per texel at most, or narrow orders fall between them.
        let (texels, rings, lobe_steps) = match fineness {
            Fineness::Full => (1.0, 128.0, LOBE_STEPS),
            Fineness::Coarse => (2.0, 64.0, LOBE_STEPS / 4),
        };
        let step = (texels * 4.0 / set.size() as f64).min(FRAC_PI_2 / rings);
        let diffuse = integrate(0.0..FRAC_PI_2, 0.0..TAU, Steps::Size(step), |wo| {
            let power = self.luminance.power(wave_vector_change(wi, wo));
            fronts(wo).map(|front| front * power * weight(wo))
        });
        let Some(lobe) = &set.lobe else { return [diffuse, [0.0; 2]] };
        let (theta, phi) = patch(wi, SQRT_2 * lobe.radius_max);
        let coherent = integrate(theta, phi, Steps::Count(lobe_steps), |wo| {
            let power = coherent_lobe(set, lobe, Interpolation::Bilinear, wi, wo)[1];
            let cross = cross_window_power(lobe, Interpolation::Bilinear, wave_vector_change(wi, wo))[1];
            let (fronts, mirrors) = (fronts(wo), [own, unit].map(|front| front.coherent(wi, wo)));
            [0, 1].map(|which| (mirrors[which] * power + fronts[which] * cross) * weight(wo))
        });
        [diffuse, coherent]
    }
}

/// Steps along each side of the lobe's patch: nine to a standard deviation of the narrowest lobe.
const LOBE_STEPS: usize = 256;

/// Polar angles and azimuths that hold all directions within a radius, in the projected disc, of the mirror direction.
fn patch(wi: Vec3, radius: f64) -> (Range<f64>, Range<f64>) {
    let sin_i = wi[0].hypot(wi[1]);
    let half = if radius < sin_i { (radius / sin_i).asin() } else { PI };
    let mirror = (-wi[1]).atan2(-wi[0]);
    let theta = (sin_i - radius).max(0.0).asin()..(sin_i + radius).min(1.0).asin();
    (theta, mirror - half..mirror + half)
}

/// How finely a part of the hemisphere is divided.
#[derive(Clone, Copy)]
enum Steps {
    /// No longer than this in the projected disc.
    Size(f64),
    /// As many along either angle.
    Count(usize),
}

/// Midpoint rule of `f cos_theta_o` over polar angles and azimuths. In the polar angle the area `sin θ cos θ dθ dφ` of the
/// projected disc takes away what `1/cos θ` has at the horizon, and its steps are finest there.
fn integrate(theta: Range<f64>, phi: Range<f64>, steps: Steps, f: impl Fn(Vec3) -> [f64; 2] + Sync) -> [f64; 2] {
    let count = |length: f64| match steps {
        Steps::Size(size) => (length / size).ceil().max(8.0) as usize,
        Steps::Count(count) => count,
    };
    let rings = count(theta.end - theta.start);
    let height = (theta.end - theta.start) / rings as f64;
    let ring = |index: usize| {
        let (sin, cos) = (theta.start + (index as f64 + 0.5) * height).sin_cos();
        let cells = count((phi.end - phi.start) * sin);
        let width = (phi.end - phi.start) / cells as f64;
        let mut sums = [0.0; 2];
        for cell in 0..cells {
            let (y, x) = (phi.start + (cell as f64 + 0.5) * width).sin_cos();
            let values = f([sin * x, sin * y, cos]);
            sums.iter_mut().zip(values).for_each(|(sum, value)| *sum += value);
        }
        sums.map(|sum| sum * sin * cos * height * width)
    };
    let rings: Vec<[f64; 2]> = (0..rings).into_par_iter().map(ring).collect();
    rings.iter().fold([0.0; 2], |sums, ring| [sums[0] + ring[0], sums[1] + ring[1]])
}

#[cfg(test)]
pub(super) mod tests {
    use std::path::{Path, PathBuf};

    use ndarray::Array2;

    use super::*;
    use crate::height::HeightField;
    use crate::height::prepare::{Level, PrepareConfig, prepare};
    use crate::height::read::{HeightScale, LengthUnit, ReadConfig, read_scan};
    use crate::optics::config::{Edge, Factor, OpticsConfig, Windows};
    use crate::tables::build::build;
    use crate::tables::input::BuildInput;
    use crate::tables::model::{Basis, Prefilter, Storage, TablesConfig};
    use diffraction_brdf::spectrum::Illuminant;

    /// Small tables of a scan as the manifest's defaults have them, but for the size.
    pub(in crate::accuracy) fn tables(field: &HeightField, material: Material) -> TableSet {
        let optics = OpticsConfig {
            material,
            factor: Factor::Vector,
            ..OpticsConfig::ideal(Illuminant::D65, 4_000.0, Edge::Auto, Windows::Grid)
        };
        let fields = std::slice::from_ref(field);
        let optics = optics.for_scans(fields);
        let config = TablesConfig {
            basis: Basis::Chebyshev,
            tolerance: 1e-2,
            size: Some(201),
            count: None,
            wavelength_step_nm: None,
            storage: Some(Storage::Float),
            prefilter: Prefilter::Auto,
            memory_mib: 2048,
        };
        build(&BuildInput::new(fields, &optics, &config), &|_| ()).unwrap().0
    }

    pub(in crate::accuracy) fn bundled(name: &str, level: Level) -> HeightField {
        let path: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../specimens").join(name);
        let unit =
            (name == "grating_nanosurf_314nm.tif").then_some(HeightScale::Unit(LengthUnit::parse("nm").unwrap()));
        let scan = read_scan(&path, &ReadConfig { height: unit, ..ReadConfig::default() }).unwrap();
        prepare(&scan.field, &PrepareConfig { level, despike: None, blend_nm: None }).unwrap().0
    }

    #[test]
    fn no_bundled_specimen_with_a_material_reflects_more_than_arrives() {
        let keratin = Material::Dielectric { n: 1.56 };
        for (name, level, material) in [
            ("corn_snake_like.tif", Level::None, keratin),
            ("sunbeam_snake_like.tif", Level::None, keratin),
            ("cd_track_like.tif", Level::None, Material::Conductor { n: 0.96, k: 6.7 }),
            ("grating_nanosurf_314nm.tif", Level::Plane, Material::Dielectric { n: 1.5 }),
        ] {
            let found = reflected(&tables(&bundled(name, level), material));
            println!("{name}: {:.4?}", found.albedo.iter().map(|at| at.albedo).collect::<Vec<_>>());
            assert!(found.albedo.iter().all(|at| at.albedo > 0.0 && at.albedo <= 1.0), "{name}: {:?}", found.albedo);
            assert_eq!(too_bright(&found.albedo, None), None);
            let limit = EnergyLimit::new(vec![0.01, 0.2, 1.0], vec![0.9, 1.3, 0.5]).unwrap();
            let text = too_bright(&found.albedo, Some(&limit)).unwrap();
            assert!(text.contains(" some azimuths, 1.3") && text.contains(" times as much at 78.5 degrees"), "{text}");
        }
    }

    #[test]
    fn an_ideal_blazed_grating_does_and_is_named() {
        let found = reflected(&tables(&bundled("blazed_2500nm.tif", Level::None), Material::Ideal));
        println!("blazed: {:.4?}", found.albedo.iter().map(|at| at.albedo).collect::<Vec<_>>());
        let at = |deg: f64| found.albedo.iter().find(|at| at.theta_i_deg == deg).unwrap().albedo;
        assert!(at(85.0) > 1.0 && at(60.0) < 1.0, "{:?}", found.albedo);
        let text = too_bright(&found.albedo, None).unwrap();
        assert!(text.contains("85, 88, 89.5 degrees") && text.contains("times as much at 89.5"), "{text}");
        // An ideal reflector's albedo is its power sum.
        assert!(found.power_sums.iter().all(|sum| sum.sum == at(sum.theta_i_deg)));
    }

    #[test]
    fn a_flat_ideal_surface_reflects_all_up_to_grazing() {
        let flat = HeightField { heights_nm: Array2::zeros((64, 64)), pitch_nm: [500.0; 2] };
        let found = reflected(&tables(&flat, Material::Ideal));
        println!("flat: {:.5?}", found.albedo.iter().map(|at| at.albedo).collect::<Vec<_>>());
        assert!(found.albedo.iter().all(|at| (at.albedo - 1.0).abs() < 0.01), "{:?}", found.albedo);
        assert_eq!(found.lobe_share.map(|share| (share * 1e6).round()), Some(1e6));
        // A flat dielectric has the Fresnel reflectance, as long as it is even over the lobe's width.
        let material = Material::Dielectric { n: 1.56 };
        for at in reflected(&tables(&flat, material)).albedo.iter().filter(|at| at.theta_i_deg <= 60.0) {
            let expected = diffraction_brdf::material::reflectance(material, at.theta_i_deg.to_radians().cos());
            assert!((at.albedo / expected - 1.0).abs() < 0.01, "{at:?} {expected}");
        }
    }
}
