//! The stages of a run, by name.

use std::fmt;

use serde::{Deserialize, Serialize};

/// One stage: what is timed together, and what a failure names.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Serialize, Deserialize)]
pub enum Stage {
    /// Scans to prepared heights.
    #[serde(rename = "read and prepare")]
    ReadAndPrepare,
    /// The file of measured reflectance.
    #[serde(rename = "read measured reflectance")]
    ReadMeasured,
    /// The part of the tables that the scenes look up.
    #[serde(rename = "find what the scenes reach")]
    FindCoverage,
    /// Grid, wavelengths and number of tables.
    #[serde(rename = "plan")]
    Plan,
    /// Transforms and sums.
    #[serde(rename = "build tables")]
    BuildTables,
    /// Whether tables on few texels suffice for the tolerance.
    #[serde(rename = "count texels")]
    CountTexels,
    /// Number format and bits.
    #[serde(rename = "round to the tolerance")]
    Round,
    /// Tables to files.
    #[serde(rename = "store tables")]
    StoreTables,
    /// Files to tables.
    #[serde(rename = "read back")]
    ReadBack,
    /// Pictures from the tables.
    #[serde(rename = "render scenes")]
    RenderScenes,
    /// Frames from the tables.
    #[serde(rename = "render animations")]
    RenderAnimations,
    /// The BRDF straight from the scans.
    #[serde(rename = "evaluate the reference")]
    EvaluateReference,
    /// Rows of errors, and power sums.
    #[serde(rename = "measure errors")]
    MeasureErrors,
    /// The model as the instrument sees it, and what was measured.
    #[serde(rename = "compare with measured reflectance")]
    CompareMeasured,
    /// Maps, strips and spectra over the angles of light and detector.
    #[serde(rename = "look from all sides")]
    LookAround,
    /// Pictures and `specimen.json` to files.
    #[serde(rename = "write pictures")]
    WritePictures,
    /// Transforms and sums of the spectral tables.
    #[serde(rename = "build spectral tables")]
    BuildSpectral,
    /// Spectral tables to files, and back.
    #[serde(rename = "store spectral tables")]
    StoreSpectral,
    /// Tables of X, Y, Z from the spectral ones, where these alone are stored.
    #[serde(rename = "derive tables of X, Y, Z")]
    DeriveTables,
    /// Errors of the spectral tables at single wavelengths.
    #[serde(rename = "measure spectral errors")]
    MeasureSpectral,
    /// What tables restricted to scenes leave out, and what that saves.
    #[serde(rename = "account for what is left out")]
    AccountSavings,
    /// A specimen that another machine was to make.
    #[serde(rename = "take from the store")]
    TakeFinished,
    /// Published files on the GPU.
    #[serde(rename = "check on the GPU")]
    CheckOnGpu,
    /// Frames on the GPU.
    #[serde(rename = "time frames")]
    TimeFrames,
}

impl Stage {
    /// A verb phrase, the same as in `report.json`.
    pub fn as_str(self) -> &'static str {
        match self {
            Self::ReadAndPrepare => "read and prepare",
            Self::ReadMeasured => "read measured reflectance",
            Self::FindCoverage => "find what the scenes reach",
            Self::Plan => "plan",
            Self::BuildTables => "build tables",
            Self::CountTexels => "count texels",
            Self::Round => "round to the tolerance",
            Self::StoreTables => "store tables",
            Self::ReadBack => "read back",
            Self::RenderScenes => "render scenes",
            Self::RenderAnimations => "render animations",
            Self::EvaluateReference => "evaluate the reference",
            Self::MeasureErrors => "measure errors",
            Self::CompareMeasured => "compare with measured reflectance",
            Self::LookAround => "look from all sides",
            Self::WritePictures => "write pictures",
            Self::BuildSpectral => "build spectral tables",
            Self::StoreSpectral => "store spectral tables",
            Self::DeriveTables => "derive tables of X, Y, Z",
            Self::MeasureSpectral => "measure spectral errors",
            Self::AccountSavings => "account for what is left out",
            Self::TakeFinished => "take from the store",
            Self::CheckOnGpu => "check on the GPU",
            Self::TimeFrames => "time frames",
        }
    }
}

impl fmt::Display for Stage {
    fn fmt(&self, formatter: &mut fmt::Formatter) -> fmt::Result {
        formatter.write_str(self.as_str())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn json_has_the_words_that_people_read() {
        use Stage::*;
        let all = [
            ReadAndPrepare,
            ReadMeasured,
            FindCoverage,
            Plan,
            BuildTables,
            CountTexels,
            Round,
            StoreTables,
            ReadBack,
            RenderScenes,
            RenderAnimations,
            EvaluateReference,
            MeasureErrors,
            CompareMeasured,
            LookAround,
            WritePictures,
            BuildSpectral,
            StoreSpectral,
            MeasureSpectral,
            AccountSavings,
            TakeFinished,
            CheckOnGpu,
            TimeFrames,
        ];
        for stage in all {
            assert_eq!(serde_json::to_value(stage).unwrap(), stage.as_str());
        }
    }
}
