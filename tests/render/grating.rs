//! A stand-in material with a closed form: a sinusoidal grating's orders, blurred by disorder.

use std::f64::consts::{PI, TAU};

use diffraction_brdf::direction::{Vec3, Xyz, geometry_factor, wave_vector_change};

/// A sinusoid of amplitude `amplitude_nm` along x whose orders are Gaussian spots in (u, v).
pub struct Grating {
    pub pitch_nm: f64,
    pub amplitude_nm: f64,
    /// Spot width in u that does not depend on the order, from finite coherence.
    pub width_u: f64,
    /// Spot width in v, from waviness of the lines.
    pub width_v: f64,
    /// Relative spread of the pitch, which blurs high orders more.
    pub pitch_spread: f64,
    /// Wavelength step of the colour integral.
    pub step_nm: f64,
}

/// CIE 1931 matching functions in the fit of Wyman, Sloan and Shirley (2013), times factors that
/// bring equal energy roughly to D65's white.
pub fn colour_matching(wavelength_nm: f64) -> Xyz {
    let lobe = |centre: f64, below: f64, above: f64| {
        let width = if wavelength_nm < centre { below } else { above };
        (-0.5 * ((wavelength_nm - centre) / width).powi(2)).exp()
    };
    let x = 1.056 * lobe(599.8, 37.9, 31.0) + 0.362 * lobe(442.0, 16.0, 26.7) - 0.065 * lobe(501.1, 20.4, 26.2);
    let y = 0.821 * lobe(568.8, 46.9, 40.5) + 0.286 * lobe(530.9, 16.3, 31.1);
    let z = 1.217 * lobe(437.0, 11.8, 36.0) + 0.681 * lobe(459.0, 26.0, 13.8);
    [0.9505 * x, y, 1.089 * z]
}

/// XYZ of the grating's BRDF: orders at `u = mλ/d` of power `J_m²(k w a) G / w²`.
pub fn brdf(grating: &Grating, wi: Vec3, wo: Vec3) -> Xyz {
    let [u, v, w] = wave_vector_change(wi, wo);
    let across = (-0.5 * (v / grating.width_v).powi(2)).exp() / (TAU.sqrt() * grating.width_v);
    let mut xyz = [0.0; 3];
    if across < 1e-9 {
        return xyz;
    }
    let (mut white, mut wavelength_nm) = (0.0, 380.0);
    while wavelength_nm <= 780.0 {
        let matching = colour_matching(wavelength_nm);
        white += matching[1];
        let spectral = across * orders(grating, wavelength_nm, u, w);
        for (sum, c) in xyz.iter_mut().zip(matching) {
            *sum += c * spectral;
        }
        wavelength_nm += grating.step_nm;
    }
    xyz.map(|sum| sum * geometry_factor(wi, wo) / (w * w) / white)
}

/// Density along u of all orders at one wavelength.
fn orders(grating: &Grating, wavelength_nm: f64, u: f64, w: f64) -> f64 {
    let spacing = wavelength_nm / grating.pitch_nm;
    let phase = TAU / wavelength_nm * w * grating.amplitude_nm;
    let reach = (6.0 * (grating.width_u / spacing + grating.pitch_spread * (u / spacing).abs())).ceil();
    let nearest = (u / spacing).round();
    let (first, last) = ((nearest - reach) as i32, (nearest + reach) as i32);
    (first..=last)
        .map(|m| {
            let centre = f64::from(m) * spacing;
            let width = grating.width_u.hypot(grating.pitch_spread * centre);
            let off = (u - centre) / width;
            if off.abs() > 6.0 {
                return 0.0;
            }
            let amplitude = libm::jn(m.abs(), phase);
            amplitude * amplitude * (-0.5 * off * off).exp() / ((2.0 * PI).sqrt() * width)
        })
        .sum()
}
