//! What the report says about measured errors.

use crate::report::numbers;
use crate::stages::results::SpecimenResult;
use diffraction_build::accuracy::directions::Group;
use diffraction_build::accuracy::rows::{Cause, ErrorRow, promised};
use diffraction_build::ground::sampling::Region;
use diffraction_build::tables::look_ups::LookUp;

/// Error rows with those of one cause together, causes in the order in which they first come.
pub(crate) fn by_cause(rows: &[ErrorRow]) -> Vec<ErrorRow> {
    let first = |row: &ErrorRow| rows.iter().position(|other| other.cause == row.cause);
    let mut sorted = rows.to_vec();
    sorted.sort_by_key(first);
    sorted
}

/// Which directions the errors count, and how much of each group the tables show above the floor.
pub(crate) fn counted_directions(rows: &[ErrorRow]) -> String {
    let total = promised(rows);
    let totals: Vec<&ErrorRow> = rows.iter().filter(|row| row.cause == total).collect();
    let [low, high] = totals
        .iter()
        .fold([f64::INFINITY, 0.0f64], |[low, high], row| [low.min(row.floor_per_sr), high.max(row.floor_per_sr)]);
    let floor = match low < high {
        true => format!("{} to {}", numbers::number(low, 2), numbers::with_unit(high, 2, "/sr")),
        false => numbers::with_unit(low, 2, "/sr"),
    };
    let shares: Vec<String> =
        totals.iter().map(|row| format!("{}: {}", row.group, numbers::percent(row.share_above))).collect();
    let [below, missed] = totals
        .iter()
        .fold([0, 0], |[below, missed], row| [below + row.directions_below, missed + row.missed_directions]);
    let found = match (below, missed) {
        (0, _) => "Nothing is below it.".to_owned(),
        (_, 0) => {
            format!("Of {below} directions below that floor that were evaluated as well, none turned out above it.")
        }
        _ => format!(
            "Of {below} directions below that floor that were evaluated as well, {missed} turned out above it, and count."
        ),
    };
    let p95 = |cause: Cause| rows.iter().find(|row| row.cause == cause).map_or(f64::NAN, |row| row.p95);
    let grid = match p95(Cause::Grid) > 0.5 * p95(total) {
        true => " Most of the total is the grid’s: it arises between texels, and a larger tables.size lowers it.",
        false => "",
    };
    format!(
        "Medians, percentiles and worst ones count directions above the luminance floor, {floor}. Shares of each region that the tables \
         show above it: {}. {found}{}{grid}",
        shares.join("; "),
        left_out(rows)
    )
}

/// What the reference may miss in the dark, where the ends of its kernels are known.
fn left_out(rows: &[ErrorRow]) -> String {
    let most = rows.iter().filter_map(|row| row.left_out_per_sr).max_by(f64::total_cmp);
    most.map_or_else(String::new, |most| {
        format!(
            " In the dark the reference may be lower than the surface by up to {}, since its windows end.",
            numbers::with_unit(most, 2, "/sr")
        )
    })
}

/// A measured figure that stands for many, and what it means.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Figure {
    /// What was measured.
    pub name: &'static str,
    /// The figure.
    pub value: String,
    /// What it means, in a sentence.
    pub meaning: String,
}

/// Colour differences below which nobody notices anything, and below which one has to look twice (CIEDE2000).
const UNSEEN: f64 = 1.0;
const SLIGHT: f64 = 2.3;

/// Most texels a side that every graphics card takes.
const SIDE_MAX: usize = 8192;

/// The errors in three figures: of the colours in the pictures, of a look-up, of the tables themselves. What was not measured
/// is left out.
pub(crate) fn figures(specimen: &SpecimenResult) -> Vec<Figure> {
    [in_pictures(specimen), of_look_ups(specimen), of_method(specimen)].into_iter().flatten().collect()
}

fn in_pictures(specimen: &SpecimenResult) -> Option<Figure> {
    let worst = specimen.scenes.iter().filter_map(|scene| scene.error).map(|error| error.ciede2000_p95);
    let worst = worst.filter(|value| value.is_finite()).reduce(f64::max)?;
    let seen = match worst {
        value if value < UNSEEN => "nobody sees it",
        value if value < SLIGHT => "side by side it can just be seen",
        _ => "it can be seen",
    };
    let meaning = format!(
        "difference of colour between the tables’ pictures and those straight from the scan, in 95 of 100 pixels of the worst scene: {seen}"
    );
    Some(Figure { name: "In the pictures", value: format!("ΔE₀₀ {}", numbers::number(worst, 2)), meaning })
}

/// The 95th percentile of a cause over the whole hemisphere, or over what there is.
pub(crate) fn p95(errors: &[ErrorRow], cause: Cause) -> Option<f64> {
    let mut rows = errors.iter().filter(|row| row.cause == cause && row.p95.is_finite());
    let first = rows.clone().next();
    rows.find(|row| row.group == Group::Region(Region::Hemisphere)).or(first).map(|row| row.p95)
}

fn of_look_ups(specimen: &SpecimenResult) -> Option<Figure> {
    let rows = &specimen.errors;
    let error = p95(rows, promised(rows))?;
    let (how, other) = match promised(rows) {
        Cause::TotalSpline => ("by splines through the texels", ("linear", Cause::Total)),
        _ => ("linear between texels", ("cubic", Cause::TotalCubic)),
    };
    let other = p95(rows, other.1)
        .map_or_else(String::new, |error| format!("; with {} look-ups {}", other.0, numbers::percent(error)));
    let meaning = format!(
        "relative error of a look-up as FORMAT.md describes it, {how}, in 95 of 100 directions with light{other}"
    );
    Some(Figure { name: "Of a look-up", value: numbers::percent(error), meaning })
}

fn of_method(specimen: &SpecimenResult) -> Option<Figure> {
    let causes = [Cause::Basis, Cause::WavelengthStep, Cause::Storage, Cause::OneWavelength];
    let (cause, error) = causes
        .into_iter()
        .filter_map(|cause| Some((cause, p95(&specimen.errors, cause)?)))
        .max_by(|a, b| a.1.total_cmp(&b.1))?;
    let most = match cause {
        Cause::Basis => "the number of tables",
        Cause::WavelengthStep => "the steps between wavelengths",
        Cause::Storage => "rounding of stored numbers",
        _ => "one front factor for all wavelengths",
    };
    let asked = specimen
        .build
        .as_ref()
        .map_or_else(String::new, |built| format!(", where {} was asked for", numbers::round_percent(built.tolerance)));
    let meaning = format!(
        "what the tables themselves add, on their texels, in 95 of 100 directions with light{asked}: most by {most}"
    );
    Some(Figure { name: "Of the tables", value: numbers::percent(error), meaning })
}

/// The setting that would keep the tolerance, as a sentence; `None` where what a reader gets keeps it, or nothing was measured.
pub(crate) fn what_would_keep(specimen: &SpecimenResult) -> Option<String> {
    let built = specimen.build.as_ref()?;
    let rows = &specimen.errors;
    let kinds = [
        ("spline", LookUp::Spline, Cause::TotalSpline),
        ("cubic", LookUp::Cubic, Cause::TotalCubic),
        ("linear", LookUp::Linear, Cause::Total),
    ];
    p95(rows, promised(rows)).filter(|error| *error > built.tolerance)?;
    let of = |(name, look_up, cause): (&str, LookUp, Cause)| {
        let error = p95(rows, cause)?;
        let size = look_up.size_for(built.tolerance, built.size.max(3), error);
        Some(match (error <= built.tolerance, size <= SIDE_MAX) {
            (true, _) => format!("{name} look-ups keep it in these tables"),
            (false, true) => format!("{name} look-ups want about `tables.size = {size}`"),
            (false, false) => format!("{name} ones would want {size} texels a side, more than graphics cards take"),
        })
    };
    let parts: Vec<String> = kinds.into_iter().filter_map(of).collect();
    Some(format!("For {}: {}.", numbers::round_percent(built.tolerance), parts.join("; ")))
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// A row of one direction with this 95th percentile.
    pub(crate) fn error_row(cause: Cause, region: Region, p95: f64) -> ErrorRow {
        ErrorRow {
            cause,
            group: Group::Region(region),
            directions: 1,
            floor_per_sr: 1.5e-4,
            share_above: 1.0,
            directions_below: 32,
            missed_directions: 0,
            left_out_per_sr: None,
            relative_l2: 0.0,
            p50: 0.0,
            p95,
            p99: 0.0,
            worst: 0.0,
        }
    }

    #[test]
    fn what_is_counted_is_said_with_what_was_missed() {
        let row = |region, missed_directions| ErrorRow { missed_directions, ..error_row(Cause::Total, region, 0.0) };
        let rows = [row(Region::NearSpecular, 0), row(Region::Grazing, 0)];
        let text = counted_directions(&rows).replace('\u{a0}', " ");
        assert!(
            text.contains("above the luminance floor, 0.00015 /sr. ")
                && text.contains("near specular: 100 %; grazing: 100 %."),
            "{text}"
        );
        assert!(
            text.ends_with("Of 64 directions below that floor that were evaluated as well, none turned out above it."),
            "{text}"
        );
        assert!(
            counted_directions(&[row(Region::NearSpecular, 0), row(Region::Grazing, 3)])
                .contains(", 3 turned out above it")
        );
        let bounded = ErrorRow { left_out_per_sr: Some(3e-6), ..row(Region::Grazing, 0) };
        let text = counted_directions(&[row(Region::NearSpecular, 0), bounded]).replace('\u{a0}', " ");
        assert!(text.ends_with(" lower than the surface by up to 3.0 × 10⁻⁶ /sr, since its windows end."), "{text}");
    }

    #[test]
    fn rows_of_a_cause_stand_together_in_their_order() {
        let (near, far) = (Region::NearSpecular, Region::Grazing);
        let of = |rows: &[ErrorRow]| rows.iter().map(|row| (row.cause, row.group.clone())).collect::<Vec<_>>();
        let rows = |kinds: [(Cause, Region); 4]| kinds.map(|(cause, region)| error_row(cause, region, 0.0));
        let (total, basis) = (Cause::Total, Cause::Basis);
        let sorted = by_cause(&rows([(total, near), (basis, near), (total, far), (basis, far)]));
        assert_eq!(of(&sorted), of(&rows([(total, near), (total, far), (basis, near), (basis, far)])));
    }

    fn measured(rows: &[(Cause, f64)]) -> SpecimenResult {
        let errors: Vec<ErrorRow> =
            rows.iter().map(|&(cause, p95)| error_row(cause, Region::Hemisphere, p95)).collect();
        serde_json::from_value(serde_json::json!({
            "name": "a", "species": null, "generated": false, "scans": [], "size": [4, 4], "pitch_nm": [50.0, 50.0],
            "extent_um": [0.2, 0.2], "statistics": null, "optics": null, "lobe": null, "power_sums": [], "scenes": [],
            "height_map": null, "spectrum": null, "preview_png": null, "warnings": [], "failed": null, "errors": errors,
            "build": {
                "basis": "chebyshev", "tables": 5, "size": 601, "storage": "half", "stored_bytes": 1, "prefilter_width": 0.0,
                "tolerance": 1e-3, "build_s": 1.0,
                "record": serde_json::to_value(diffraction_build::tables::model::BuildRecord::default()).unwrap()
            }
        }))
        .unwrap()
    }

    #[test]
    fn three_figures_stand_for_the_rows() {
        let rows = [(Cause::Total, 0.02), (Cause::TotalCubic, 4e-4), (Cause::Basis, 1e-4), (Cause::Storage, 3e-4)];
        let found = figures(&measured(&rows));
        let values: Vec<String> = found.iter().map(|figure| figure.value.replace('\u{a0}', " ")).collect();
        assert_eq!(values, ["2.0 %", "0.030 %"]);
        assert!(found[1].meaning.ends_with("most by rounding of stored numbers"), "{}", found[1].meaning);
        assert!(figures(&measured(&[])).is_empty());
        let by_spline = figures(&measured(&[(Cause::TotalSpline, 9e-4), (Cause::Total, 0.02)]));
        assert!(
            by_spline[0].meaning.contains("by splines") && by_spline[0].meaning.contains("with linear look-ups 2.0")
        );
    }

    #[test]
    fn the_setting_that_would_keep_the_tolerance_is_named() {
        let said = |rows: &[(Cause, f64)]| what_would_keep(&measured(rows)).map(|text| text.replace('\u{a0}', " "));
        assert_eq!(said(&[(Cause::Total, 9e-4)]), None);
        assert_eq!(
            said(&[(Cause::Total, 0.02), (Cause::TotalSpline, 9e-4)]),
            None,
            "what FORMAT.md describes keeps it"
        );
        let kept = said(&[(Cause::Total, 4e-3), (Cause::TotalCubic, 1e-4)]).unwrap();
        assert_eq!(
            kept,
            "For 0.1 %: cubic look-ups keep it in these tables; linear look-ups want about `tables.size = 1201`."
        );
        let coarse = said(&[(Cause::Total, 1.0), (Cause::TotalCubic, 0.016)]).unwrap();
        assert!(
            coarse.contains("cubic look-ups want about `tables.size = 1201`")
                && coarse.contains("more than graphics cards"),
            "{coarse}"
        );
    }
}
