//! One line that says whether a specimen's tables are good, and why not.

use super::warnings::{are_unlike, repetition_warning, seam_warnings};
use crate::stages::ingest::Scans;
use diffraction_build::height::quality::{Finding, Grade, Remedy, Verdict};
use diffraction_build::optics::validity::doubts;

/// What else than scans a verdict goes by.
#[derive(Debug, Clone, Copy)]
pub(super) struct Outcome {
    /// `|(u, v)|` that the tables answer for.
    pub usable_radius: f64,
    /// Whether some row of errors exceeds what was asked for.
    pub breaks_tolerance: bool,
    /// Whether the manifest says what the surface is made of.
    pub is_material_given: bool,
}

/// What to think of a specimen, the most serious reason first.
pub(super) fn verdict(scans: &Scans, outcome: &Outcome) -> Verdict {
    let findings: Vec<&Finding> = scans.findings.iter().flatten().collect();
    let (limits, faults): (Vec<&Finding>, Vec<&Finding>) = findings.into_iter().partition(|finding| finding.is_limit());
    if !faults.is_empty() {
        let reasons: Vec<String> = faults.iter().map(|finding| reason(finding)).collect();
        return Verdict { grade: Grade::Red, sentence: format!("not good because: {}.", distinct(reasons).join("; ")) };
    }
    let optics = &scans.optics;
    let range_nm = optics.illuminant.reach_nm(optics.wavelength_nm);
    let is_steep = scans.fields.iter().any(|field| !doubts(field, range_nm, optics.material, optics.factor).is_empty());
    let others = [
        (!outcome.is_material_given, "no material is given, so brightness means nothing".to_owned()),
        (is_steep, "some orders are doubtful, for the slopes or the pitch".to_owned()),
        (outcome.usable_radius < 2.0, format!("the samples end at |(u, v)| = {:.2}", outcome.usable_radius)),
        (!seam_warnings(scans, optics).is_empty(), "its edges do not fit (`blend_nm`)".to_owned()),
        (
            repetition_warning(&scans.fields, optics).is_some(),
            "the scan is small beside the light's coherence".to_owned(),
        ),
        (are_unlike(scans), "its scans differ".to_owned()),
        (outcome.breaks_tolerance, "errors exceed the tolerance".to_owned()),
    ];
    let others = others.into_iter().filter(|(holds, _)| *holds).map(|(_, words)| words);
    let reasons = distinct(limits.iter().map(|finding| finding.in_short.clone()).chain(others).collect());
    if reasons.is_empty() {
        let sentence = "good for all directions, within the tolerance.".to_owned();
        return Verdict { grade: Grade::Green, sentence };
    }
    Verdict { grade: Grade::Amber, sentence: format!("good within limits: {}.", reasons.join("; ")) }
}

/// Of a specimen without tables.
pub(super) fn failed_verdict(why: &str) -> Verdict {
    Verdict { grade: Grade::Red, sentence: format!("no tables: {why}") }
}

fn reason(finding: &Finding) -> String {
    let setting = finding.remedy.as_ref().map(Remedy::toml);
    setting.map_or_else(|| finding.in_short.clone(), |setting| format!("{} (`{setting}`)", finding.in_short))
}

/// Each reason once, in order.
fn distinct(reasons: Vec<String>) -> Vec<String> {
    let mut told: Vec<String> = Vec::new();
    for reason in reasons {
        if !told.contains(&reason) {
            told.push(reason);
        }
    }
    told
}
