//! What look-ups between texels come to, in words.

use crate::report::numbers;
use crate::stages::results::BuildResult;
use diffraction_build::accuracy::rows::{Cause, ErrorRow};
use diffraction_build::tables::look_ups::LookUp;

/// Which look-ups keep the tolerance in total, and how many texels would; nothing where nothing was measured.
pub(crate) fn look_ups(built: &BuildResult, errors: &[ErrorRow]) -> Option<String> {
    let worst = |cause: Cause| {
        let of_groups = errors.iter().filter(|row| row.cause == cause).map(|row| row.p95).filter(|p95| p95.is_finite());
        of_groups.reduce(f64::max)
    };
    let in_words = |(name, look_up, cause): (&str, LookUp, Cause)| {
        let error = worst(cause)?;
        let said = numbers::number(error, 2);
        Some(if error <= built.tolerance {
            format!("{name} ones keep the tolerance in 95 % of lit directions ({said})")
        } else {
            let size = look_up.size_for(built.tolerance, built.size.max(3), error);
            format!(
                "{name} ones err by {said} or more in 5 % of lit directions, about {size} × {size} texels would keep the tolerance"
            )
        })
    };
    let kinds = [
        ("spline", LookUp::Spline, Cause::TotalSpline),
        ("linear", LookUp::Linear, Cause::Total),
        ("cubic", LookUp::Cubic, Cause::TotalCubic),
    ];
    let parts: Vec<String> = kinds.into_iter().filter_map(in_words).collect();
    (!parts.is_empty()).then(|| parts.join("; "))
}
