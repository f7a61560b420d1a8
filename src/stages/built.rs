//! Tables, built and measured.

use super::stage::Stage;
use super::usage::{self, Stopwatch};
use diffraction_brdf::error::Result;
use diffraction_build::tables::build;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::model::{Advance, BuildRecord, TableSet};
use diffraction_build::tables::plan::BuildPlan;

/// Tables, and what building them took.
#[derive(Debug)]
pub struct Built {
    /// The tables.
    pub set: TableSet,
    /// What was chosen while building.
    pub record: BuildRecord,
    /// Seconds.
    pub seconds: f64,
    /// Seconds that all threads together ran; `None` where the system does not tell.
    pub processor_s: Option<f64>,
    /// Most bytes on the heap beyond those before; `None` where nobody counts them.
    pub memory_bytes: Option<u64>,
}

impl Built {
    /// Builds from nothing and measures.
    ///
    /// # Errors
    /// Those of building.
    pub fn measured(input: &BuildInput, plan: &BuildPlan, advance: Advance) -> Result<Self> {
        let stopwatch = Stopwatch::start();
        let build = || build::build_planned(input, plan, advance);
        let (built, memory_bytes) = usage::with_heap_bytes(build);
        let (set, record) = built?;
        let time = stopwatch.read(Stage::BuildTables, None);
        Ok(Self { set, record, seconds: time.wall_s, processor_s: time.cpu_s, memory_bytes })
    }
}
