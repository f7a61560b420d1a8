//! Aborted scans and lost lines.

use super::finding::{Fault, Finding, Remedy};
use crate::height::HeightField;
use crate::height::prepare::lost_lines::longest_block;
use crate::height::prepare::repair::LOST_BLOCK_MAX;

/// Tells from one lost line on: of samples that are equal by chance a line consists once in 2³⁹ (`prepare::lost_lines`).
pub(super) fn check(read: &HeightField, lost: &[bool]) -> Option<Finding> {
    let [first, count] = longest_block(lost, true)?;
    let total = lost.iter().filter(|lost| **lost).count();
    let [nx, ny] = read.size();
    let share = 100.0 * total as f64 / ny as f64;
    if count <= LOST_BLOCK_MAX {
        return Some(Finding {
            fault: Fault::LostLines,
            in_short: format!("{total} lost line{}", if total == 1 { "" } else { "s" }),
            sentence: format!(
                "{total} of {ny} scan lines ({share:.1} %, the first in row {first}) hold one value or repeat the line before: they were lost. \
                 `despike` fills them in from the lines around them."
            ),
            remedy: Some(Remedy::Despike),
        });
    }
    let of_height = read.heights_nm[[first, 0]];
    let constant = (0..nx).all(|column| read.heights_nm[[first + count - 1, column]] == of_height);
    let what = if constant { format!("one value ({of_height:.4} nm)") } else { "copies of one line".to_owned() };
    let kept = longest_block(lost, false);
    Some(Finding {
        fault: Fault::LostLines,
        in_short: format!("{share:.0} % of the scan holds no measurement"),
        sentence: format!(
            "{} is {what}: rows {first} to {} hold no measurement, as where a scan was stopped. {}",
            part_in_words(share),
            first + count - 1,
            kept.map_or("Scan again.".to_owned(), |[first, rows]| format!(
                "`crop = [0, {first}, {nx}, {rows}]` keeps what was measured."
            ))
        ),
        remedy: kept.map(|[first, rows]| Remedy::Crop([0, first, nx, rows])),
    })
}

fn part_in_words(percent: f64) -> String {
    match percent {
        48.0..=52.0 => "Half the scan".into(),
        _ => format!("{percent:.1} % of the scan"),
    }
}
