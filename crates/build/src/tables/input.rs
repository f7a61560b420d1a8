//! What tables are made of: prepared scans, optics and settings, with what follows from them once.

use super::model::TablesConfig;
use super::resolution;
use crate::height::HeightField;
use crate::optics::config::OpticsConfig;
use crate::optics::spectra::half_height_range_nm;

/// One specimen's prepared scans, its optics and what is asked of its tables.
#[derive(Debug, Clone, Copy)]
pub struct BuildInput<'a> {
    /// Prepared heights, one field per scan.
    pub fields: &'a [HeightField],
    /// The optics.
    pub optics: &'a OpticsConfig,
    /// What is asked of the tables.
    pub tables: &'a TablesConfig,
    /// Largest root mean square of a scan's heights about their mean, in nm.
    pub rms_nm: f64,
    /// Largest half range of a scan's heights in nm.
    pub half_height_range_nm: f64,
    /// Shortest and longest wavelength of the light in nm.
    pub wavelength_range_nm: [f64; 2],
    /// Whether a wavelength stands for itself, in one channel of weight 1 instead of X, Y and Z.
    pub is_grey: bool,
}

impl<'a> BuildInput<'a> {
    /// Measures the heights. Whether they can be built from, planning tells.
    pub fn new(fields: &'a [HeightField], optics: &'a OpticsConfig, tables: &'a TablesConfig) -> Self {
        let largest = |of: fn(&HeightField) -> f64| fields.iter().map(of).fold(0.0, f64::max);
        Self {
            fields,
            optics,
            tables,
            rms_nm: largest(rms_nm),
            half_height_range_nm: largest(half_height_range_nm),
            wavelength_range_nm: optics.illuminant.reach_nm(optics.wavelength_nm),
            is_grey: false,
        }
    }

    /// The same scans under other optics and for other tables.
    pub fn with<'b>(&self, optics: &'b OpticsConfig, tables: &'b TablesConfig) -> BuildInput<'b>
    where
        'a: 'b,
    {
        BuildInput { optics, tables, wavelength_range_nm: optics.illuminant.reach_nm(optics.wavelength_nm), ..*self }
    }

    /// Channels of a texel.
    pub(super) fn channels(&self) -> usize {
        if self.is_grey { 1 } else { 3 }
    }

    /// Radius of the (u, v) disc for which the sampling of every scan holds every frequency at every wavelength.
    pub(super) fn usable_radius(&self) -> f64 {
        self.fields.iter().map(|field| resolution::usable_radius(self.optics, field.pitch_nm)).fold(2.0, f64::min)
    }
}

/// Root mean square of the heights about their mean, in nm.
fn rms_nm(field: &HeightField) -> f64 {
    let mean = field.heights_nm.mean().unwrap_or(0.0);
    let variance = field.heights_nm.iter().map(|h| (h - mean).powi(2)).sum::<f64>();
    (variance / field.heights_nm.len().max(1) as f64).sqrt()
}
