//! Rows of the wave methods that the published one stands on: Wigner distributions and optical paths.
//!
//! They keep no tables, so that every direction is a sum over the surface: they are compared in directions alone, not in
//! pictures and power sums, which ask for ten thousand.

use super::batch::Pair;
use super::config::StudyConfig;
use super::methods::{Context, Cost, Label, measured};
use super::rows::MethodRow;
use crate::baselines::integrate_spectra;
use crate::baselines::paths::OpticalPaths;
use crate::baselines::wigner::{LightField, PhaseScreen, plane_of_incidence};
use diffraction_brdf::direction::{Xyz, wave_vector_change};
use diffraction_brdf::error::Result;
use diffraction_build::height::HeightField;
use diffraction_build::optics::spectra::half_height_range_nm;

/// Steps of progress.
pub fn count(config: &StudyConfig) -> usize {
    1 + config.light_fields.len() + config.paths.len()
}

impl Context<'_> {
    /// The Wigner distribution projected, light fields of ever more rays, ever more optical paths.
    pub(crate) fn wave_rows(&self) -> Result<Vec<MethodRow>> {
        let mut rows = vec![self.wigner_row()];
        self.progress.advance(1);
        for &[positions, angles] in &self.config.light_fields {
            rows.push(self.light_field_row(LightField { positions, angles }));
            self.progress.advance(1);
        }
        for &paths in &self.config.paths {
            rows.push(self.paths_row(paths)?);
            self.progress.advance(1);
        }
        Ok(rows)
    }

    fn wigner_row(&self) -> MethodRow {
        let batch = self.over_spectrum(|field, &(wi, wo), wavelengths_nm| {
            self.screen(field, &(wi, wo)).projected_nm2(wave_vector_change(wi, wo), wavelengths_nm)
        });
        // The distribution of one wavelength and one direction of light: as many frequencies as whole steps.
        let places =
            self.fields.first().map_or(0, |field| PhaseScreen::along(field, [1.0, 0.0], self.sigma()).places());
        let bytes = places * places.div_ceil(2) * size_of::<f32>();
        self.row(Label::without_tables("WBSDF", "plane of incidence".into(), bytes), Cost::default(), &batch)
    }

    fn light_field_row(&self, rays: LightField) -> MethodRow {
        let batch = self.over_spectrum(|field, &(wi, wo), wavelengths_nm| {
            rays.power_nm2(&self.screen(field, &(wi, wo)), [wi, wo], wavelengths_nm)
        });
        let setting = format!("{} x {} rays", rays.positions, rays.angles);
        self.row(Label::without_tables("light field", setting, rays.bytes()), Cost::default(), &batch)
    }

    fn paths_row(&self, count: usize) -> Result<MethodRow> {
        let sampled =
            || Ok(self.fields.iter().map(|field| OpticalPaths::sampled(field, self.sigma(), count)).collect());
        let (sampled, cost): (Vec<OpticalPaths>, Cost) = measured(sampled)?;
        let bytes = sampled.iter().map(OpticalPaths::bytes).sum();
        let batch = self.spectra_batch(|&(wi, wo), wavelengths_nm| {
            let q = wave_vector_change(wi, wo);
            mean(sampled.iter().map(|paths| paths.power_nm2(q, wavelengths_nm)), wavelengths_nm.len())
        });
        Ok(self.row(Label::without_tables("optical paths", format!("{count} paths"), bytes), cost, &batch))
    }

    fn sigma(&self) -> f64 {
        self.optics.sigma_nm
    }

    fn screen(&self, field: &HeightField, &(wi, wo): &Pair) -> PhaseScreen {
        PhaseScreen::along(field, plane_of_incidence(wi, wo), self.sigma())
    }

    /// A method for many pairs from its power on one scan: the mean over the scans, integrated over the spectrum.
    fn over_spectrum(
        &self,
        power_nm2: impl Fn(&HeightField, &Pair, &[f64]) -> Vec<f64> + Sync,
    ) -> impl Fn(&[Pair], &mut [Xyz]) + Sync {
        self.spectra_batch(move |pair, wavelengths_nm| {
            let of_scans = self.fields.iter().map(|field| power_nm2(field, pair, wavelengths_nm));
            mean(of_scans, wavelengths_nm.len())
        })
    }

    /// A method for many pairs from its power, integrated over the spectrum.
    fn spectra_batch(
        &self,
        power_nm2: impl Fn(&Pair, &[f64]) -> Vec<f64> + Sync,
    ) -> impl Fn(&[Pair], &mut [Xyz]) + Sync {
        let half_range_nm = self.fields.iter().map(half_height_range_nm).fold(0.0, f64::max);
        move |pairs, out| {
            out.fill([0.0; 3]);
            // A light that cannot be seen has failed before; a number that is none would show as the worst.
            if integrate_spectra(self.optics, half_range_nm, pairs, &power_nm2, out).is_err() {
                out.fill([f64::NAN; 3]);
            }
        }
    }
}

/// The mean of spectra of equal length.
fn mean(spectra: impl ExactSizeIterator<Item = Vec<f64>>, len: usize) -> Vec<f64> {
    let share = 1.0 / spectra.len().max(1) as f64;
    let mut sum = vec![0.0; len];
    spectra.for_each(|one| sum.iter_mut().zip(one).for_each(|(sum, value)| *sum += share * value));
    sum
}
