//! The BRDF of one specimen: evaluation, and sampling of directions for path tracers.

use std::path::Path;
use std::sync::OnceLock;

use crate::direction::{Vec3, Xyz};
use crate::energy::EnergyLimit;
use crate::error::{Error, Result};
use crate::evaluate::{self, Interpolation, LookUp};
use crate::filtered::{Pyramids, brdf_xyz_filtered_by, spectral_filtered};
use crate::footprint::Footprint;
use crate::sampling::Sampler;
use crate::specimen::{self, CheckValue, SpecimenRecord};
use crate::spectral::SpectralTables;
use crate::spectral_light::UnderLight;
use crate::spectrum::Illuminant;
use crate::splines::Splines;
use crate::table_set::TableSet;

/// The BRDF that a table set holds. Frame, sign and units: see the [crate's page](crate).
///
/// It can be shared between threads; what sampling needs is prepared at the first call that samples.
#[derive(Debug, Clone)]
pub struct Brdf {
    tables: TableSet,
    spectral: Option<SpectralTables>,
    interpolation: Interpolation,
    check_values: Vec<CheckValue>,
    energy_limit: Option<EnergyLimit>,
    is_limited: bool,
    sampler: OnceLock<Sampler>,
    pyramids: OnceLock<Pyramids>,
    spectral_pyramids: OnceLock<Pyramids>,
    splines: OnceLock<Splines>,
    spectral_splines: OnceLock<Splines>,
}

/// A direction drawn by [`Brdf::sample`].
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Sample {
    /// Unit vector to the light.
    pub wi: Vec3,
    /// `f(wi, wo) cos_theta_i / pdf`, without unit: what light from `wi` adds to the radiance towards `wo` is this times its
    /// radiance. Its mean over samples is the directional albedo. Channels may be slightly negative where tables are.
    pub weight: Xyz,
    /// Density of `wi` in 1/sr: [`Brdf::pdf`].
    pub pdf: f64,
}

impl Brdf {
    /// The BRDF of tables in memory, with look-ups as graphics hardware makes them.
    ///
    /// # Errors
    /// [`Error::Call`] for tables of shapes that do not fit each other, and numbers that are not finite.
    ///
    /// ```
    /// use diffraction_brdf::{Basis, Brdf, Factor, FrontFactor, Material, TableSet};
    /// # use ndarray::Array3;
    /// // One table that is constant over the square of (u, v): the surface then only has its geometry factor.
    /// let brdf = Brdf::new(TableSet {
    ///     basis: Basis::Chebyshev,
    ///     tables: vec![Array3::from_elem((3, 3, 3), 0.1)],
    ///     lobe: None,
    ///     prefilter_width: 0.0,
    ///     front_factor: FrontFactor { material: Material::Ideal, shadowing: false, factor: Factor::Scalar },
    ///     restriction: None,
    ///     usable_radius: 2.0,
    /// })?;
    /// let up = [0.0, 0.0, 1.0];
    /// assert!((brdf.eval(up, up)[1] - 0.4).abs() < 1e-6);
    /// # Ok::<(), diffraction_brdf::Error>(())
    /// ```
    pub fn new(tables: TableSet) -> Result<Self> {
        tables.check().map_err(|what| Error::Call(format!("a table set cannot be evaluated: {what}")))?;
        Ok(Self {
            tables,
            spectral: None,
            interpolation: Interpolation::Bilinear,
            check_values: Vec::new(),
            energy_limit: None,
            is_limited: false,
            sampler: OnceLock::new(),
            pyramids: OnceLock::new(),
            spectral_pyramids: OnceLock::new(),
            splines: OnceLock::new(),
            spectral_splines: OnceLock::new(),
        })
    }

    /// Reads the tables beside `specimen.json`; those of X, Y, Z are derived where spectral ones alone are stored.
    pub(crate) fn read(folder: &Path, record: SpecimenRecord) -> Result<Self> {
        let (tables, spectral) =
            specimen::read_both(folder, &record.tables, record.spectral.as_ref(), record.front_factor)?;
        Ok(Self {
            tables,
            spectral,
            interpolation: Interpolation::Bilinear,
            check_values: record.check_values,
            energy_limit: record.energy_limit,
            is_limited: false,
            sampler: OnceLock::new(),
            pyramids: OnceLock::new(),
            spectral_pyramids: OnceLock::new(),
            splines: OnceLock::new(),
            spectral_splines: OnceLock::new(),
        })
    }

    /// The same BRDF with other look-ups: linear ones are what graphics hardware gives and `check_values` have as `xyz`; cubic
    /// ones read four times as many texels and err less between them; splines read as many coefficients, which are made of the
    /// tables at the first look-up, err least, and keep the tolerance that the tables were made with.
    ///
    /// ```
    /// # mod tiny { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/tiny_atlas/mod.rs")); }
    /// use diffraction_brdf::{Brdf, Interpolation};
    /// # let tables = tiny::tiny_tables();
    /// let linear = Brdf::new(tables)?;
    /// let [wi, wo] = [[0.6, 0.0, 0.8], [-0.28, 0.0, 0.96]];
    /// for other in [Interpolation::Cubic, Interpolation::Spline] {
    ///     let closer = linear.clone().with_interpolation(other);
    ///     let [a, b] = [linear.eval(wi, wo)[1], closer.eval(wi, wo)[1]];
    ///     assert!(a != b && (a / b - 1.0).abs() < 0.1);
    /// }
    /// # Ok::<(), diffraction_brdf::Error>(())
    /// ```
    pub fn with_interpolation(self, interpolation: Interpolation) -> Self {
        Self { interpolation, ..self }
    }

    /// The same BRDF divided by `max(1, albedo(wi), albedo(wo))`, for path tracers: no direction reflects more than arrives, and
    /// it stays reciprocal ([`EnergyLimit`]). `sample` draws as before, with weights that are that much smaller.
    ///
    /// The scalar factor and ideal reflectors have no bound at grazing angles. Tables that show it come with a limit; others,
    /// and those made in memory, with none, and are what they were, bit for bit. The limit is of luminance, to about 1 %; it
    /// darkens every azimuth by what the brightest needs. Off by default: values then are those of the model.
    ///
    /// ```
    /// # mod tiny { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/tiny_atlas/mod.rs")); }
    /// use diffraction_brdf::{Brdf, EnergyLimit};
    /// # let tables = tiny::tiny_tables();
    /// let limit = EnergyLimit::new(vec![0.1, 1.0], vec![4.0, 0.4]).unwrap();
    /// let free = Brdf::new(tables)?.with_limit(limit);
    /// let limited = free.clone().with_energy_limit();
    /// let [low, up] = [[0.99498743710662, 0.0, 0.1], [0.0, 0.0, 1.0]];
    /// assert!((limited.eval(low, up)[1] / free.eval(low, up)[1] - 0.25).abs() < 1e-9);
    /// assert_eq!(limited.eval(up, up), free.eval(up, up));
    /// # Ok::<(), diffraction_brdf::Error>(())
    /// ```
    pub fn with_energy_limit(self) -> Self {
        Self { is_limited: true, ..self }
    }

    /// The same BRDF with another limit for [`Self::with_energy_limit`], such as for tables made in memory.
    pub fn with_limit(self, limit: EnergyLimit) -> Self {
        Self { energy_limit: Some(limit), ..self }
    }

    /// The limit that came with the tables, whether it is switched on or not; `None` where nothing needs one.
    pub fn energy_limit(&self) -> Option<&EnergyLimit> {
        self.energy_limit.as_ref()
    }

    /// XYZ of the BRDF in 1/sr for unit vectors to the light and to the viewer; the cosine is not in it.
    ///
    /// Zero for directions that are not above the surface, not a number where the tables have no answer ([`Self::answers`]).
    /// Values may be slightly negative where the tables are.
    pub fn eval(&self, wi: Vec3, wo: Vec3) -> Xyz {
        self.limited(evaluate::brdf_xyz_by(&self.tables, self.look_up(), wi, wo), wi, wo)
    }

    /// Splines' coefficients are made at the first look-up.
    fn look_up(&self) -> LookUp<'_> {
        match self.interpolation {
            Interpolation::Spline if self.tables.restriction.is_none() => {
                LookUp::Splines(self.splines.get_or_init(|| Splines::new(&self.tables.tables)))
            }
            interpolation => LookUp::Values(interpolation),
        }
    }

    fn spectral_look_up(&self, tables: &SpectralTables) -> LookUp<'_> {
        match self.interpolation {
            Interpolation::Spline => {
                LookUp::Splines(self.spectral_splines.get_or_init(|| Splines::new(&tables.images)))
            }
            interpolation => LookUp::Values(interpolation),
        }
    }

    fn limited(&self, xyz: Xyz, wi: Vec3, wo: Vec3) -> Xyz {
        match self.energy_limit.as_ref().filter(|_| self.is_limited) {
            None => xyz,
            Some(limit) => xyz.map(|value| value * limit.factor(wi, wo)),
        }
    }

    /// Mean of the BRDF over a footprint around two directions, XYZ in 1/sr: a light with a size, or a pixel of a curved
    /// surface, in one look-up.
    ///
    /// It stands where [`Self::eval`] stands for a point of light: with the light's irradiance `E` on a plane that faces it,
    /// evenly over its disc, the radiance is `eval_filtered cos_theta_i E`. For light alone it is the mean of `f cos_theta_i` over
    /// the disc, divided by `cos_theta_i` at its centre, which is the mean of `f` over the disc seen along the normal. A footprint
    /// with a pixel's curvature in it has the mean over that as well; footprints add.
    ///
    /// Tables and lobe are averaged over the ellipse, at the centre's front factor and `|w|`: within 0.1 % for the sun, 1 %
    /// for a lamp two degrees wide, at 95 of 100 directions. For much larger ones, and where the light's disc meets the horizon,
    /// sample the light instead. Small footprints give [`Self::eval`], without a step. Zero and not a number as there; not a
    /// number, too, where the tables have no answer for a part of the footprint. Coarser copies of the tables, a third of their
    /// memory, are made at the first call.
    ///
    /// ```
    /// # mod tiny { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/tiny_atlas/mod.rs")); }
    /// # let brdf = diffraction_brdf::Brdf::new(tiny::tiny_tables())?;
    /// use diffraction_brdf::Footprint;
    /// let [wi, wo] = [[0.6, 0.0, 0.8], [-0.56, 0.0, 0.8284926]];
    /// let sun = Footprint::of_light(wi, 0.53)?;
    /// let pixel = Footprint::of_normals(wi, wo, [1e-4, 0.0, 1e-4])?;
    /// let blurred = brdf.eval_filtered(wi, wo, sun + pixel);
    /// assert!(blurred[1] < brdf.eval(wi, wo)[1]);
    /// # Ok::<(), diffraction_brdf::Error>(())
    /// ```
    pub fn eval_filtered(&self, wi: Vec3, wo: Vec3, footprint: Footprint) -> Xyz {
        let pyramids = self.pyramids.get_or_init(|| Pyramids::new(&self.tables));
        let xyz = brdf_xyz_filtered_by(&self.tables, pyramids, self.look_up(), [wi, wo], footprint);
        self.limited(xyz, wi, wo)
    }

    /// [`Self::eval_wavelengths`] over a footprint, as [`Self::eval_filtered`] is [`Self::eval`] over one.
    ///
    /// # Errors
    /// As [`Self::eval_wavelengths`].
    pub fn eval_wavelengths_filtered(
        &self,
        wi: Vec3,
        wo: Vec3,
        footprint: Footprint,
        wavelengths_nm: &[f64],
    ) -> Result<Vec<f64>> {
        let tables = self.spectral_tables()?;
        tables.check_wavelengths(wavelengths_nm)?;
        let pyramids = self.spectral_pyramids.get_or_init(|| Pyramids::of_spectral(tables));
        let look_up = self.spectral_look_up(tables);
        Ok(spectral_filtered(tables, pyramids, look_up, [wi, wo], footprint, wavelengths_nm))
    }

    /// [`Self::eval`] for slices of directions, on all threads with the feature `rayon`.
    ///
    /// # Panics
    /// If the slices differ in length.
    ///
    /// ```
    /// # mod tiny { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/tiny_atlas/mod.rs")); }
    /// # let brdf = diffraction_brdf::Brdf::new(tiny::tiny_tables())?;
    /// let wi = [[0.0, 0.0, 1.0], [0.6, 0.0, 0.8]];
    /// let wo = [[0.0, 0.0, 1.0], [-0.6, 0.0, 0.8]];
    /// let mut xyz = [[0.0; 3]; 2];
    /// brdf.eval_many(&wi, &wo, &mut xyz);
    /// assert_eq!(xyz[1], brdf.eval(wi[1], wo[1]));
    /// # Ok::<(), diffraction_brdf::Error>(())
    /// ```
    pub fn eval_many(&self, wi: &[Vec3], wo: &[Vec3], xyz: &mut [Xyz]) {
        assert!(wi.len() == wo.len() && wo.len() == xyz.len(), "as many wi as wo and values");
        #[cfg(feature = "rayon")]
        {
            use rayon::prelude::*;
            let pairs = wi.par_iter().zip(wo).with_min_len(256);
            pairs.zip(xyz).for_each(|((wi, wo), xyz)| *xyz = self.eval(*wi, *wo));
        }
        #[cfg(not(feature = "rayon"))]
        wi.iter().zip(wo).zip(xyz).for_each(|((wi, wo), xyz)| *xyz = self.eval(*wi, *wo));
    }

    /// The BRDF in 1/sr at each wavelength in nm, from the spectral tables: zero for directions not above the surface.
    ///
    /// # Errors
    /// [`Error::Call`] for a specimen without spectral tables, and for a wavelength shorter than they answer for.
    pub fn eval_wavelengths(&self, wi: Vec3, wo: Vec3, wavelengths_nm: &[f64]) -> Result<Vec<f64>> {
        let tables = self.spectral_tables()?;
        tables.check_wavelengths(wavelengths_nm)?;
        Ok(tables.eval_by(self.spectral_look_up(tables), wi, wo, wavelengths_nm))
    }

    /// The BRDF under any light, from the spectral tables: its `eval` gives XYZ in 1/sr relative to that light.
    ///
    /// # Errors
    /// [`Error::Call`] for a specimen without spectral tables, a light that the eye does not see, and laser lines shorter
    /// than the tables answer for.
    pub fn xyz_under(&self, illuminant: &Illuminant) -> Result<UnderLight<'_>> {
        let tables = self.spectral_tables()?;
        tables.under_by(self.spectral_look_up(tables), illuminant)
    }

    /// The spectral tables; `None` where the atlas holds none.
    pub fn spectral(&self) -> Option<&SpectralTables> {
        self.spectral.as_ref()
    }

    fn spectral_tables(&self) -> Result<&SpectralTables> {
        self.spectral.as_ref().ok_or_else(|| {
            Error::Call(
                "this specimen has no spectral tables: run the pipeline with \"spectral\" in tables.hold, or ask for X, Y, Z \
                 under the light of its tables"
                    .into(),
            )
        })
    }

    /// Whether the tables can answer for a pair of directions: always, unless they were made for certain scenes only.
    pub fn answers(&self, wi: Vec3, wo: Vec3) -> bool {
        evaluate::answers(&self.tables, self.interpolation, wi, wo)
    }

    /// Draws a direction to the light, given the one to the viewer and three numbers that are uniform in [0, 1).
    ///
    /// `None` where `wo` is not above the surface, and where the tables have no answer for what was drawn: the sample then
    /// counts with the weight 0. The model is reciprocal, so that light paths may swap the roles of `wi` and `wo`.
    ///
    /// ```
    /// # mod tiny { include!(concat!(env!("CARGO_MANIFEST_DIR"), "/tests/tiny_atlas/mod.rs")); }
    /// # let brdf = diffraction_brdf::Brdf::new(tiny::tiny_tables())?;
    /// // The share of light under an even sky that is reflected towards the viewer: the mean of the weights.
    /// let wo = [0.6, 0.0, 0.8];
    /// let mut random = fastrand::Rng::with_seed(1);
    /// let mut sum = 0.0;
    /// for _ in 0..10_000 {
    ///     if let Some(sample) = brdf.sample(wo, [random.f64(), random.f64(), random.f64()]) {
    ///         assert_eq!(sample.pdf, brdf.pdf(sample.wi, wo));
    ///         sum += sample.weight[1];
    ///     }
    /// }
    /// assert!(sum / 10_000.0 > 0.01 && sum / 10_000.0 < 1.0);
    /// # Ok::<(), diffraction_brdf::Error>(())
    /// ```
    pub fn sample(&self, wo: Vec3, u: [f64; 3]) -> Option<Sample> {
        let wi = self.sampler().sample(wo, u)?;
        let pdf = self.sampler().pdf(wi, wo);
        let xyz = self.eval(wi, wo);
        if !(pdf > 0.0 && xyz.iter().all(|value| value.is_finite())) {
            return None;
        }
        Some(Sample { wi, weight: xyz.map(|value| value * wi[2] / pdf), pdf })
    }

    /// Density in 1/sr with which [`Self::sample`] draws `wi` for this `wo`; 0 where it never does.
    ///
    /// Its integral over directions is the probability that a sample is drawn: 1 but for tables made for certain scenes,
    /// and for rims of the hemisphere within rounding.
    pub fn pdf(&self, wi: Vec3, wo: Vec3) -> f64 {
        if self.tables.restriction.is_some() && !self.answers(wi, wo) {
            return 0.0;
        }
        self.sampler().pdf(wi, wo)
    }

    /// An upper bound of the channels of [`Sample::weight`] for linear look-ups; derived in the source of the sampler.
    pub fn weight_bound(&self, wo: Vec3) -> f64 {
        self.sampler().weight_bound(wo)
    }

    /// Directions and values that came with the tables, from linear look-ups: a test of whatever evaluates them. Empty for
    /// tables that were made in memory.
    pub fn check_values(&self) -> &[CheckValue] {
        &self.check_values
    }

    /// The tables.
    pub fn tables(&self) -> &TableSet {
        &self.tables
    }

    fn sampler(&self) -> &Sampler {
        self.sampler.get_or_init(|| Sampler::new(&self.tables))
    }
}
