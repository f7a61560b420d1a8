//! Making opposite edges of a scan fit each other, for a surface that repeats it.
//!
//! At a seam the scan's last line should lead to its first as neighbouring lines do: by the mean of
//! the two steps next to the seam. What is missing is the seam's misfit, one number for each sample along
//! it. Half of it is added on one side and half subtracted on the other, fading out inwards. Unlike a
//! cross-fade of heights, this leaves fine structure its contrast and shows no second image of it.
//!
//! The misfit is faded by its frequency along the seam: `k` decays as `exp(-|k| d)` with the
//! distance `d`, as in a stretched membrane (the solution of Laplace's equation), so that noise does not
//! draw streaks; all of it ends at the blending distance, by a smooth factor.

use std::f64::consts::TAU;

use ndarray::{ArrayViewMut2, Axis};
use rustfft::FftPlanner;
use rustfft::num_complex::Complex;

use crate::height::HeightField;
use diffraction_brdf::error::{Error, Result};

/// Fewest samples that a misfit can be spread over; over fewer a step merely moves.
const SAMPLES_MIN: f64 = 4.0;

/// Whether the blending distance suits the scan.
pub fn check(field: &HeightField, blend_nm: f64) -> Result<()> {
    for (axis, name) in ["x", "y"].into_iter().enumerate() {
        let (count, pitch) = (field.size()[axis], field.pitch_nm[axis]);
        if count == 1 {
            continue;
        }
        let (least, most) = (SAMPLES_MIN * pitch, 0.5 * count as f64 * pitch);
        // Negated, so that NaN is refused too.
        if !(blend_nm >= least && blend_nm <= most) {
            let what = format!(
                "blend_nm is {blend_nm}; along {name} this scan of {count} samples every {pitch:.2} nm allows \
                 {:.1} (four samples) to {:.1} (half of the scan)",
                // Rounded so that either is allowed itself.
                (10.0 * least).ceil() / 10.0,
                (10.0 * most).floor() / 10.0
            );
            let fix = if least <= most { "set `blend_nm` within this range" } else { "leave `blend_nm` out" };
            return Err(Error::limit(
                what,
                format!("{fix}, or use coherence.edge = \"fade\", which needs no blending"),
            ));
        }
    }
    Ok(())
}

/// Makes opposite edges fit, changing heights nearer to them than `blend_nm`, which [`check`] has accepted.
pub fn blend(field: &mut HeightField, blend_nm: f64) {
    let [dx, dy] = field.pitch_nm;
    blend_first_axis(field.heights_nm.view_mut(), [dy, dx], blend_nm);
    blend_first_axis(field.heights_nm.view_mut().reversed_axes(), [dx, dy], blend_nm);
}

/// Blends the first line along axis 0 with the last; pitches are across and along the seam.
fn blend_first_axis(mut lines: ArrayViewMut2<f64>, [across_nm, along_nm]: [f64; 2], blend_nm: f64) {
    let (count, length) = lines.dim();
    if count < 2 {
        return;
    }
    let mut planner = FftPlanner::new();
    let (forward, inverse) = (planner.plan_fft_forward(length), planner.plan_fft_inverse(length));
    let mut misfit: Vec<Complex<f64>> = (0..length)
        .map(|i| {
            let (first, second) = (lines[[0, i]], lines[[1, i]]);
            let (last, before) = (lines[[count - 1, i]], lines[[count - 2, i]]);
            Complex::from(last + 0.5 * ((second - first) + (last - before)) - first)
        })
        .collect();
    forward.process(&mut misfit);
    let mut part = vec![Complex::default(); length];
    for index in 0..count / 2 {
        let distance_nm = index as f64 * across_nm;
        let share = distance_nm / blend_nm;
        if share >= 1.0 {
            break;
        }
        // Cubic from 1 to 0, level at both ends: the steps next to the seam stay as they are.
        let scale = 0.5 * (1.0 - share).powi(2) * (1.0 + 2.0 * share) / length as f64;
        for (i, (part, misfit)) in part.iter_mut().zip(&misfit).enumerate() {
            let wavenumber = TAU * i.min(length - i) as f64 / (length as f64 * along_nm);
            *part = misfit * (scale * (-wavenumber * distance_nm).exp());
        }
        inverse.process(&mut part);
        lines.index_axis_mut(Axis(0), index).iter_mut().zip(&part).for_each(|(height, part)| *height += part.re);
        let mirrored = count - 1 - index;
        lines.index_axis_mut(Axis(0), mirrored).iter_mut().zip(&part).for_each(|(height, part)| *height -= part.re);
    }
}
