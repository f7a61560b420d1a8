//! Tilt and bow: what of the heights is the stage's and the scanner's.

use super::finding::{Fault, Finding, Remedy};
use super::prepared::Prepared;
use crate::height::HeightField;
use crate::height::prepare::level::{Order, subtract_surface};
use crate::height::prepare::repair::rms_nm;

/// Slope whose cosine is 0.99: beyond it, lengths along a scan are a hundredth shorter than on the surface.
const STEEP_DEG: f64 = 8.1;

/// Slope in degrees that is left after preparing from which on it is told: it turns the mirror direction by twice as much. Generated surfaces
/// have up to 0.1 degrees.
const LEFT_DEG: f64 = 0.5;

/// Ratio of the bowl's root mean square height to that of all else from which on the bowl is told: of eight real scans the
/// most curved, a butterfly's scale of 5 µm, has 0.88.
const BOW_MIN: f64 = 1.1;

/// Tells a tilt of more than 8.1 degrees as it was read, and of more than half a degree where it is left.
pub(super) fn tilt(read: &HeightField, prepared: &HeightField) -> Option<Finding> {
    let [of_read, left] = [read, prepared].map(tilt_deg);
    if left > LEFT_DEG {
        return Some(Finding {
            fault: Fault::Tilt,
            in_short: format!("tilted by {left:.1} degrees"),
            sentence: format!(
                "The heights are tilted by {left:.2} degrees, which turns the mirror direction by twice as much. `level = \"plane\"` takes the \
                 tilt away."
            ),
            remedy: Some(Remedy::Plane),
        });
    }
    (of_read > STEEP_DEG).then(|| Finding {
        fault: Fault::Tilt,
        in_short: format!("scanned at a tilt of {of_read:.0} degrees"),
        sentence: format!(
            "The scan was tilted by {of_read:.1} degrees. `level = \"plane\"`, the default, takes that away, but lengths along the tilt stay {:.1} % \
             too short: level the sample before scanning.",
            100.0 * (1.0 - of_read.to_radians().cos())
        ),
        remedy: Some(Remedy::Plane),
    })
}

/// Angle of the best plane in degrees.
fn tilt_deg(field: &HeightField) -> f64 {
    let [x, y] = subtract_surface(&mut field.clone(), Order::Plane).slope;
    x.hypot(y).atan().to_degrees()
}

/// Fewest samples along either side that tell a bowl from structure.
const SIZE_MIN: usize = 16;

/// Tells a bowl that is larger than all structure upon it.
pub(super) fn bow(prepared: &Prepared) -> Option<Finding> {
    let mut rest = prepared.levelled.clone();
    let removed = subtract_surface(&mut rest, Order::Quadratic);
    let rest_nm = rms_nm(&rest);
    let bow_nm = (prepared.rms_nm.powi(2) - rest_nm.powi(2)).max(0.0).sqrt();
    if bow_nm <= BOW_MIN * rest_nm || prepared.field.size().iter().any(|count| *count < SIZE_MIN) {
        return None;
    }
    let [x_nm, y_nm] = prepared.field.extent_nm();
    let [xx, _, yy] = removed.curvature_per_nm;
    let sags_nm = [xx * x_nm * x_nm / 8.0, yy * y_nm * y_nm / 8.0].map(f64::abs);
    Some(Finding {
        fault: Fault::Bow,
        in_short: format!("bowed by {:.0} nm", sags_nm[0].max(sags_nm[1])),
        sentence: format!(
            "The scan is bowed: by {:.1} nm along x and {:.1} nm along y from the middle to the edges, {bow_nm:.1} nm rms, more than its structure \
             ({rest_nm:.1} nm). Where that is the scanner's and not the surface's, `level = \"quadratic\"` takes it away.",
            sags_nm[0], sags_nm[1],
        ),
        remedy: Some(Remedy::Quadratic),
    })
}
