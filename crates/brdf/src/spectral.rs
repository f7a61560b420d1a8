//! Spectral tables: the BRDF at any wavelength, and under any light, from one stack.
//!
//! The window's power depends on a direction and a wavelength through the spatial frequency `(u, v)/λ` and the phase scale
//! `2π|w|/λ` alone. So what holds at `q = (u, v, w)` and `λ` holds at `q λ0/λ` and `λ0` too: tables made for the shortest
//! wavelength `λ0` answer for every longer one, with a factor that is a power of `λ0/λ`.

use std::f64::consts::TAU;

use ndarray::Array3;

use crate::chebyshev;
use crate::direction::{Vec3, length, normalised_abs_w, wave_vector_change};
use crate::dispersion::Dispersion;
use crate::error::{Error, Result};
use crate::evaluate::{Interpolation, LookUp, sample};
use crate::front_factor::{Factor, FrontFactor, image_radius2};
use crate::splines::through_values;

/// Tables in one image: its channels.
pub const TABLES_PER_IMAGE: usize = 3;

/// The spectral tables of one specimen.
///
/// With `r = λ0/λ`, `(u', v', w') = r (u, v, w)`, `t' = |w'| / sqrt(4 - u'² - v'²)`, `ρ = sqrt(u² + v²)` and the image's radius
/// `ρ_h` of [`image_radius2`], which the scalar factor goes without:
///
/// `f = r⁴ D (Σ table_n(u', v') T_n(2t' - 1) + Σ cross_n(u', v') T_n(2t' - 1) / |w'|)
///    + r² C lobe(|w'|/2) (exp(-(2πσ ρ/λ)²) + exp(-(2πσ ρ_h/λ)²))`
///
/// Under a source of fixed size `σ` grows with the wavelength: `r²` and `σ/λ` of the lobe are then 1 and `σ/λ0`.
///
/// with `D` and `C` of [`FrontFactor::diffuse`] and [`FrontFactor::coherent`].
#[derive(Debug, Clone, PartialEq)]
pub struct SpectralTables {
    /// `λ0` in nm: the shortest wavelength that the tables answer for.
    pub shortest_nm: f64,
    /// Longest wavelength in nm of the light that they were made with; longer ones are answered for as well.
    pub longest_nm: f64,
    /// Number of tables.
    pub count: usize,
    /// Table `3 i + c` is channel `c` of image `i`; shape `[size, size, 3]`, texels as in a
    /// [`TableSet`](crate::TableSet) over `(u', v')`, values in 1/sr.
    pub images: Vec<Array3<f32>>,
    /// The coherent lobe; `None` where tables contain it.
    pub lobe: Option<SpectralLobe>,
    /// Side of the square in (u', v') over which each texel is averaged; 0 for point samples.
    pub prefilter_width: f64,
    /// What stands in front of the tables' values.
    pub front_factor: FrontFactor,
    /// How the material's index depends on the wavelength; `None` where it is that of `front_factor` at every one.
    pub dispersion: Option<Dispersion>,
    /// Radius of the (u', v') disc that the scans' sampling can answer for.
    pub usable_radius: f64,
    /// Standard deviation in nm of the coherence window of the diffuse part.
    pub sigma_nm: f64,
    /// Half the scans' range of heights in nm: with `sigma_nm` how fast values can change with the wavelength.
    pub half_height_range_nm: f64,
}

/// The coherent lobe of spectral tables: its form is known, what the surface decides is a function of `s` alone.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectralLobe {
    /// Power of the mean phasor over `|w'|/2`, evenly from 0 to 1: `|c|² ∬∬g² / (λ0² A)` in 1/sr.
    pub power: Vec<f32>,
    /// Standard deviation in nm of the light's coherence window, at the shortest wavelength.
    pub sigma_nm: f64,
    /// Whether it grows in proportion to the wavelength, as under a source of fixed size, or is the same at every one.
    pub is_of_source: bool,
    /// The cross term; `None` where it vanishes.
    pub cross: Option<SpectralCross>,
}

/// The cross term of the lobe with the rest.
#[derive(Debug, Clone, PartialEq)]
pub struct SpectralCross {
    /// Number of patches.
    pub count: usize,
    /// Packed as the tables are, over `[-radius_max, radius_max]²` in (u', v').
    pub images: Vec<Array3<f32>>,
    /// Half the side of the patches.
    pub radius_max: f64,
}

/// How many images so many tables take.
pub(crate) fn images_for(count: usize) -> usize {
    count.div_ceil(TABLES_PER_IMAGE)
}

impl SpectralTables {
    /// Texels along u' and v'.
    pub fn size(&self) -> usize {
        self.images.first().map_or(0, |image| image.dim().0)
    }

    /// The BRDF in 1/sr at each wavelength in nm, for unit vectors to the light and to the viewer; zero for directions not
    /// above the surface, not a number for wavelengths shorter than the tables'.
    pub fn eval(&self, interpolation: Interpolation, wi: Vec3, wo: Vec3, wavelengths_nm: &[f64]) -> Vec<f64> {
        self.eval_by(LookUp::Values(interpolation), wi, wo, wavelengths_nm)
    }

    pub(crate) fn eval_by(&self, look_up: LookUp, wi: Vec3, wo: Vec3, wavelengths_nm: &[f64]) -> Vec<f64> {
        if !(wi[2] > 0.0 && wo[2] > 0.0) {
            return vec![0.0; wavelengths_nm.len()];
        }
        let pair = Pair::of(self.front_factor, wi, wo);
        wavelengths_nm.iter().map(|&nm| self.eval_pair(look_up, &pair, nm)).collect()
    }

    /// [`Self::eval`] at one wavelength for directions above the surface.
    pub(crate) fn eval_pair(&self, look_up: LookUp, pair: &Pair, wavelength_nm: f64) -> f64 {
        let r = self.shortest_nm / wavelength_nm;
        // The wavelength itself may differ by rounding.
        if !(r > 0.0 && r <= 1.0 + 1e-9) {
            return f64::NAN;
        }
        let Some([front_diffuse, front_coherent]) = self.front_at(pair, wavelength_nm) else { return f64::NAN };
        let q = pair.q.map(|part| part * r.min(1.0));
        let mut diffuse = self.diffuse_at(look_up, q);
        let Some(lobe) = &self.lobe else { return r.powi(4) * front_diffuse * diffuse };
        diffuse += lobe.cross.as_ref().map_or(0.0, |cross| cross.value(look_up.interpolation(), q));
        let (share, width) = lobe.share_and_width(self.shortest_nm, wavelength_nm);
        let shape = |radius: f64| (-(radius / width).powi(2)).exp();
        let shape = shape(pair.radius) + pair.image_radius.map_or(0.0, shape);
        r.powi(4) * front_diffuse * diffuse + share * front_coherent * lobe.power_at(q[2].abs()) * shape
    }

    /// `D` and `C` at a wavelength in nm; `None` where the material is not known.
    pub(crate) fn front_at(&self, pair: &Pair, wavelength_nm: f64) -> Option<[f64; 2]> {
        let Some(dispersion) = &self.dispersion else { return Some([pair.diffuse, pair.coherent]) };
        let front = FrontFactor { material: dispersion.material_at(wavelength_nm)?, ..self.front_factor };
        Some([front.diffuse(pair.wi, pair.wo), front.coherent(pair.wi, pair.wo)])
    }

    /// The tables' part alone at a wavelength in nm, in 1/sr: without the cross term, the lobe, `D` and `r⁴`.
    pub fn diffuse(&self, interpolation: Interpolation, wi: Vec3, wo: Vec3, wavelength_nm: f64) -> f64 {
        let r = (self.shortest_nm / wavelength_nm).min(1.0);
        self.diffuse_at(LookUp::Values(interpolation), wave_vector_change(wi, wo).map(|part| part * r))
    }

    pub(crate) fn diffuse_at(&self, look_up: LookUp, q: Vec3) -> f64 {
        let basis = chebyshev::shifted_values(self.count, normalised_abs_w(q));
        let size = self.size() as f64 - 1.0;
        let at = [(2.0 - q[1]) / 4.0 * size, (q[0] + 2.0) / 4.0 * size];
        match look_up {
            LookUp::Splines(splines) => packed_sum(splines.values(at), &basis),
            LookUp::Values(Interpolation::Spline) => {
                packed_sum(self.images.iter().map(|image| through_values(image.view(), at)), &basis)
            }
            LookUp::Values(interpolation) => packed_expansion(&self.images, &basis, interpolation, at),
        }
    }

    /// `|P|² / (λ0² A w²)` at `q = (u, v, w)` and the shortest wavelength in 1/sr: what tables, cross term and lobe hold,
    /// without what stands in front of them.
    pub fn window_power(&self, interpolation: Interpolation, q: Vec3) -> f64 {
        let diffuse = self.diffuse_at(LookUp::Values(interpolation), q);
        let Some(lobe) = &self.lobe else { return diffuse };
        let shape = (-(TAU * lobe.sigma_nm * length([q[0], q[1]]) / self.shortest_nm).powi(2)).exp();
        let cross = lobe.cross.as_ref().map_or(0.0, |cross| cross.value(interpolation, q));
        diffuse + cross + lobe.power_at(q[2].abs()) * shape / q[2].powi(2)
    }

    /// What keeps the tables from being evaluated, in words.
    pub(crate) fn check(&self) -> std::result::Result<(), String> {
        let positive = |name: &str, value: f64| match value > 0.0 && value.is_finite() {
            true => Ok(()),
            false => Err(format!("its {name} is {value}")),
        };
        self.front_factor.check()?;
        positive("shortest wavelength", self.shortest_nm)?;
        positive("coherence of the diffuse part", self.sigma_nm)?;
        if !(self.longest_nm >= self.shortest_nm && self.longest_nm.is_finite()) {
            return Err(format!("its wavelengths run from {} to {} nm", self.shortest_nm, self.longest_nm));
        }
        if !(self.half_height_range_nm >= 0.0 && self.half_height_range_nm.is_finite()) {
            return Err(format!("its range of heights is {}", self.half_height_range_nm));
        }
        if let Some(dispersion) = &self.dispersion {
            let [low, high] = dispersion.range_nm();
            if !(low <= self.shortest_nm && self.longest_nm <= high) {
                return Err(format!("the index of {} is known from {low} to {high} nm only", dispersion.name()));
            }
        }
        check_packed("spectral tables", self.count, &self.images)?;
        let Some(lobe) = &self.lobe else { return Ok(()) };
        positive("coherence of the light", lobe.sigma_nm)?;
        if lobe.power.len() < 2 || lobe.power.iter().any(|value| !value.is_finite()) {
            return Err("its lobe has fewer than two values, or some that are not finite".into());
        }
        let Some(cross) = &lobe.cross else { return Ok(()) };
        positive("cross term's radius", cross.radius_max)?;
        check_packed("patches of the spectral cross term", cross.count, &cross.images)
    }

    /// An error for wavelengths that are not answered for.
    ///
    /// # Errors
    /// [`Error::Call`] that names the first of them.
    pub fn check_wavelengths(&self, wavelengths_nm: &[f64]) -> Result<()> {
        if let Some(dispersion) = &self.dispersion
            && let Some(nm) = wavelengths_nm.iter().find(|nm| dispersion.index_at(**nm).is_none())
        {
            let [low, high] = dispersion.range_nm();
            return Err(Error::Call(format!(
                "the refractive index of {} is known from {low} to {high} nm, not at {nm} nm",
                dispersion.name()
            )));
        }
        match wavelengths_nm.iter().find(|nm| !(**nm >= self.shortest_nm * (1.0 - 1e-9) && nm.is_finite())) {
            None => Ok(()),
            Some(nm) => Err(Error::Call(format!(
                "the spectral tables begin at {} nm and cannot tell of {nm} nm; optics.wavelength_nm of the manifest sets \
                 where they begin",
                self.shortest_nm
            ))),
        }
    }
}

fn check_packed(what: &str, count: usize, images: &[Array3<f32>]) -> std::result::Result<(), String> {
    let size = images.first().map_or(0, |image| image.dim().0);
    if count == 0 || images.len() != images_for(count) {
        return Err(format!("{count} {what} do not lie in {} images", images.len()));
    }
    if size < 2 || images.iter().any(|image| image.dim() != (size, size, TABLES_PER_IMAGE)) {
        return Err(format!("{what} are not all of one square size with three channels"));
    }
    if images.iter().any(|image| image.iter().any(|value| !value.is_finite())) {
        return Err(format!("{what} hold values that are not finite"));
    }
    Ok(())
}

impl SpectralLobe {
    /// What the lobe's power counts at a wavelength, and the distance in (u, v) at which its form has fallen to `1/e`, from the
    /// shortest wavelength and this one in nm.
    pub fn share_and_width(&self, shortest_nm: f64, wavelength_nm: f64) -> (f64, f64) {
        // The peak is as the square of the window's width, over the square of the wavelength.
        match self.is_of_source {
            true => (1.0, shortest_nm / (TAU * self.sigma_nm)),
            false => ((shortest_nm / wavelength_nm).powi(2), wavelength_nm / (TAU * self.sigma_nm)),
        }
    }

    /// Power at `|w'|`, linear between entries.
    pub(crate) fn power_at(&self, abs_w: f64) -> f64 {
        let last = self.power.len() - 1;
        let at = (0.5 * abs_w).clamp(0.0, 1.0) * last as f64;
        let first = (at as usize).min(last - 1);
        let [low, high] = [first, first + 1].map(|index| f64::from(self.power[index]));
        low + (at - first as f64) * (high - low)
    }
}

impl SpectralCross {
    /// `Σ cross_n T_n / |w'|` at `q'`.
    pub(crate) fn value(&self, interpolation: Interpolation, q: Vec3) -> f64 {
        if q[0].abs().max(q[1].abs()) >= self.radius_max {
            return 0.0;
        }
        let size = self.images[0].dim().0 as f64 - 1.0;
        let at = [q[1], -q[0]].map(|x| (self.radius_max - x) / (2.0 * self.radius_max) * size);
        let basis = chebyshev::shifted_values(self.count, normalised_abs_w(q));
        packed_expansion(&self.images, &basis, interpolation, at) / q[2].abs()
    }
}

/// `Σ basis_n table_n` of packed tables at a position in texels (row, column).
fn packed_expansion(images: &[Array3<f32>], basis: &[f64], interpolation: Interpolation, at: [f64; 2]) -> f64 {
    packed_sum(images.iter().map(|image| sample(image.view(), interpolation, at)), basis)
}

/// `Σ basis_n value_n` of packed values.
fn packed_sum(images: impl Iterator<Item = [f64; TABLES_PER_IMAGE]>, basis: &[f64]) -> f64 {
    images
        .zip(basis.chunks(TABLES_PER_IMAGE))
        .fold(0.0, |sum, (values, basis)| sum + basis.iter().zip(values).map(|(b, value)| b * value).sum::<f64>())
}

/// What a pair of directions above the surface has at every wavelength.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Pair {
    wi: Vec3,
    wo: Vec3,
    q: Vec3,
    radius: f64,
    /// That of the lobe's image in the horizon; none with the scalar factor.
    image_radius: Option<f64>,
    /// `D` of the constant material.
    diffuse: f64,
    /// `C` of it.
    coherent: f64,
}

impl Pair {
    pub(crate) fn of(front: FrontFactor, wi: Vec3, wo: Vec3) -> Self {
        let q = wave_vector_change(wi, wo);
        Self {
            wi,
            wo,
            q,
            radius: length([q[0], q[1]]),
            image_radius: (front.factor == Factor::Vector).then(|| image_radius2(wi, wo).sqrt()),
            diffuse: front.diffuse(wi, wo),
            coherent: front.coherent(wi, wo),
        }
    }

    /// Distance from the mirror direction in (u, v).
    pub(crate) fn radius(&self) -> f64 {
        self.radius
    }
}

/// Packs tables, an image of one channel each, three to an image; channels without a table are zero.
pub fn packed(tables: &[Array3<f32>]) -> Vec<Array3<f32>> {
    let pack = |group: &[Array3<f32>]| {
        let (rows, columns, _) = group[0].dim();
        Array3::from_shape_fn((rows, columns, TABLES_PER_IMAGE), |(row, column, c)| {
            group.get(c).map_or(0.0, |table| table[[row, column, 0]])
        })
    };
    tables.chunks(TABLES_PER_IMAGE).map(pack).collect()
}
