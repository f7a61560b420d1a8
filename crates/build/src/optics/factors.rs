//! What stands in front of a window's power for one pair of directions.

use super::config::OpticsConfig;
use super::dispersive::Dispersive;
use diffraction_brdf::direction::{Vec3, wave_vector_change};
use diffraction_brdf::front_factor::{Factor, FrontFactor, image_radius2};

/// What a pair of directions asks of a window's power.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PairFactors<'a> {
    /// `-wi - wo`.
    pub q: Vec3,
    /// Factor of all but the coherent part, before the division by `w²`; at one wavelength where it depends on it.
    pub diffuse: f64,
    /// Factor of the coherent part; likewise.
    pub coherent: f64,
    /// Distance in (u, v) of the lobe's image in the horizon, where it counts.
    pub image_radius: Option<f64>,
    /// How the factors change with the wavelength.
    change: Option<Change<'a>>,
}

/// How the factors of a pair change with the wavelength.
#[derive(Debug, Clone, Copy, PartialEq)]
struct Change<'a> {
    dispersive: &'a Dispersive,
    kind: Kind,
}

#[derive(Debug, Clone, Copy, PartialEq)]
enum Kind {
    /// Each wavelength has its own index; of one polarisation where a number is given.
    Exact { front: FrontFactor, pair: (Vec3, Vec3), polarisation: Option<usize> },
    /// As tables have it: of all but the coherent part, the reflectance at normal incidence alone changes.
    AsTables { front: FrontFactor, pair: (Vec3, Vec3) },
}

impl<'a> PairFactors<'a> {
    /// `None` for directions not above the surface.
    pub fn of(optics: &'a OpticsConfig, wi: Vec3, wo: Vec3) -> Option<Self> {
        let front = optics.front_factor();
        (wi[2] > 0.0 && wo[2] > 0.0).then(|| Self {
            q: wave_vector_change(wi, wo),
            diffuse: front.diffuse(wi, wo),
            coherent: front.coherent(wi, wo),
            image_radius: (front.factor == Factor::Vector).then(|| image_radius2(wi, wo).sqrt()),
            change: optics.dispersion.as_ref().map(|dispersive| Change {
                dispersive,
                kind: Kind::Exact { front, pair: (wi, wo), polarisation: None },
            }),
        })
    }

    /// The same with the front factor at one wavelength, as tables have it.
    pub fn as_tables(optics: &'a OpticsConfig, wi: Vec3, wo: Vec3) -> Option<Self> {
        let (all, front) = (Self::of(optics, wi, wo)?, optics.front_factor());
        let kind = Kind::AsTables { front, pair: (wi, wo) };
        Some(Self { change: all.change.map(|change| Change { kind, ..change }), ..all })
    }

    /// The same by polarisation: ss, sp, ps, pp, the incident one first; `None` where the factor knows none, or for directions
    /// not above the surface.
    pub fn polarised(optics: &'a OpticsConfig, wi: Vec3, wo: Vec3) -> Option<[Self; 4]> {
        let (all, front) = (Self::of(optics, wi, wo)?, optics.front_factor());
        let factors = front.polarised(wi, wo)?;
        Some(std::array::from_fn(|index| Self {
            diffuse: factors.diffuse[index],
            coherent: factors.coherent[index],
            change: all.change.map(|change| Change {
                kind: Kind::Exact { front, pair: (wi, wo), polarisation: Some(index) },
                ..change
            }),
            ..all
        }))
    }

    /// The factors of all but the coherent part and of the coherent part at a wavelength in nm.
    fn at(&self, wavelength_nm: f64) -> [f64; 2] {
        let Some(Change { dispersive, kind }) = self.change else { return [self.diffuse, self.coherent] };
        match kind {
            Kind::AsTables { front, pair: (wi, wo) } => {
                let front = FrontFactor { material: dispersive.material_at(wavelength_nm), ..front };
                [dispersive.relative_reflectance(wavelength_nm) * self.diffuse, front.coherent(wi, wo)]
            }
            Kind::Exact { front, pair: (wi, wo), polarisation } => {
                let front = FrontFactor { material: dispersive.material_at(wavelength_nm), ..front };
                match polarisation.and_then(|index| Some((index, front.polarised(wi, wo)?))) {
                    None => [front.diffuse(wi, wo), front.coherent(wi, wo)],
                    Some((index, factors)) => [factors.diffuse[index], factors.coherent[index]],
                }
            }
        }
    }

    /// The BRDF in 1/sr at a wavelength from the power without the coherent part, the coherent part, and that of the image, in
    /// nm².
    pub fn brdf(&self, wavelength_nm: f64, rest_nm2: f64, coherent_nm2: f64) -> f64 {
        let [diffuse, coherent] = self.at(wavelength_nm);
        (diffuse * rest_nm2 / (self.q[2] * self.q[2]) + coherent * coherent_nm2) / wavelength_nm.powi(2)
    }
}
