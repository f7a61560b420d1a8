//! The stability suite: stiff and extreme cases, each with a derived bound and a measured figure.
//!
//! A case measures one number that must not exceed its bound. Something keeps it there: a refusal, a limit taken, an
//! order of sums, a count that follows the input. The same number is measured with that taken out, by the naive way
//! written here beside it, and must exceed the bound: a case that nothing breaks would show nothing.

mod case;
mod depth;
mod directions;
mod large;
mod lights;
mod series;
mod shapes;
mod storage;
mod support;

use serde::{Deserialize, Serialize};

pub use case::{Guard, StabilityCase, Verdict};
pub use depth::DepthRow;
use diffraction_build::ground::progress::Progress;
pub use directions::GrazingRow;
pub use series::SeriesRow;

/// The whole suite.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Stability {
    /// All cases.
    pub cases: Vec<StabilityCase>,
    /// Number of tables and error against depth.
    pub depths: Vec<DepthRow>,
    /// Where the published series fails in each number format.
    pub series: Vec<SeriesRow>,
    /// Error towards grazing with and without the division by `w²`.
    pub grazing: Vec<GrazingRow>,
}

/// Runs every case; `thorough` adds those of many megabytes.
pub fn run_stability(thorough: bool, progress: &dyn Progress) -> Stability {
    let groups: [&dyn Fn() -> Vec<StabilityCase>; 5] =
        [&depth::cases, &shapes::cases, &lights::cases, &storage::cases, &|| {
            if thorough { large_cases() } else { Vec::new() }
        }];
    progress.stage("stability suite", 3 + groups.len() as u64);
    let (depths, mut cases) = depth::rows_and_cases();
    progress.advance(1);
    let (grazing, of_directions) = directions::rows_and_cases();
    cases.extend(of_directions);
    progress.advance(1);
    let series = series::rows();
    progress.advance(1);
    for group in groups {
        cases.extend(group());
        progress.advance(1);
    }
    progress.finish();
    Stability { cases, depths, series, grazing }
}

/// A scan of 8192² samples, and a table of 4001² texels.
pub fn large_cases() -> Vec<StabilityCase> {
    vec![large::scan_of_8192(), large::table_of_4001()]
}
