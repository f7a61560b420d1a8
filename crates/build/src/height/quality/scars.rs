//! Streaks along the fast axis.

use super::finding::{Fault, Finding, Remedy};
use super::prepared::Prepared;
use crate::height::prepare::scars::scars;

/// Tells streaks one line wide, of at least 12 samples, that rise over both lines beside them by 0.4 times the rms height
/// (`prepare::scars`).
pub(super) fn check(prepared: &Prepared) -> Option<Finding> {
    let found = scars(&prepared.levelled.heights_nm, prepared.rms_nm);
    let highest = found.iter().max_by(|a, b| a.height_nm.abs().total_cmp(&b.height_nm.abs()))?;
    let longest = found.iter().map(|scar| scar.columns.len()).max().unwrap_or(0);
    let count = format!("{} scar{}", found.len(), if found.len() == 1 { "" } else { "s" });
    Some(Finding {
        fault: Fault::Scars,
        in_short: count.clone(),
        sentence: format!(
            "{count} along the fast axis, streaks one line wide of up to {longest} samples, stand out by up to {:.1} nm (row {}): there the tip lost \
             the surface. `despike = {{ threshold_rms = 8 }}` masks them and fills them in.",
            highest.height_nm.abs(),
            highest.row
        ),
        remedy: Some(Remedy::Despike),
    })
}
