//! What each plot of a study shows and what to choose by it, a sentence or two below it.

use crate::report::numbers;
use diffraction_study::study::{EqualError, Measure, SpecimenStudy};

/// Below a specimen's plot of this key.
pub(crate) fn of_specimen(key: &str, study: &SpecimenStudy) -> String {
    let said = match key {
        "cost" => {
            "Error against what it costs: further left and lower is better, and each line joins the settings of one method by cost. \
                   Choose the lowest line left of what you can spend."
        }
        "cost-on-texels" => {
            "The same without the error between texels, which all tables share: what is left is the method’s own. A flat \
                             line is a method that more cost does not mend."
        }
        "tables" => {
            return format!(
                "{} {}",
                "Left: each table costs a fetch, so the leftmost line at your error is the cheapest. \
                                    Right: below 1 nobody sees a difference of colour.",
                fewest(&study.equal)
            );
        }
        "tolerance" => {
            "What was asked for against what was measured: on or below the line “asked for” it is kept. Linear look-ups \
                        keep least; where they matter choose more texels, not a smaller tolerance."
        }
        "lights" => {
            "What a light with a size costs: choose filtered look-ups, of which one is as good as dozens of points; of a snake, whose scales have edges \
             within pixels, it is worth fewer."
        }
        "wide-lights" => {
            "The same under lamps that are wide for one look-up: where its error is too much, sixty-four points and more do better than parts of the light."
        }
        "basis" => {
            "What the number of tables adds by itself: choose the first that lies below your tolerance; more only cost."
        }
        "wavelength-step" => {
            "What steps over the wavelength add by themselves: halving them costs twice the sums. The automatic choice stays below \
                              the tolerance."
        }
        "grid" => {
            "What look-ups between texels add by themselves: linear ones fall with the square of the texels’ distance, cubic ones with its \
                   fourth power. Choose cubic where a shader can afford them."
        }
        "storage" => {
            "What rounding adds by itself: 11 bits are half floats. Below the line of your tolerance fewer bits cost nothing but bytes."
        }
        "windows" => {
            "How far a mean over few positions of the window is from that over all: one window shows the speckle of one place."
        }
        _ => "",
    };
    said.into()
}

/// Which method reaches an error with fewer tables, and where it is the published one, why.
fn fewest(equal: &[EqualError]) -> String {
    let both = equal.iter().filter(|row| row.measure == Measure::P95);
    let pairs: Vec<(f64, usize, usize)> = both
        .filter_map(|row| Some((row.target, row.chebyshev.as_ref()?.tables, row.taylor.as_ref()?.tables)))
        .collect();
    let Some((target, chebyshev, taylor)) = pairs.iter().copied().min_by(|a, b| a.0.total_cmp(&b.0)) else {
        return String::new();
    };
    let counts = format!(
        "An error of {} takes {chebyshev} Chebyshev tables or {taylor} Taylor tables here",
        numbers::number(target, 2)
    );
    match taylor > chebyshev {
        true => format!("{counts}: choose Chebyshev."),
        false => format!(
            "{counts}: on relief as shallow as this the power series has few terms and nothing to cancel, and Taylor floats are as good or \
             better; Chebyshev halves are smaller."
        ),
    }
}

/// Below a plot of the stability suite.
pub(crate) fn of_stability(key: &str) -> &'static str {
    match key {
        "depth" => {
            "The number of tables grows in proportion to the relief, and with it the error stays: a fixed number of four does for \
                    shallow relief alone. Leave the number to the tolerance."
        }
        "series" => {
            "The power series cancels more digits the deeper the relief: each number format fails where its line leaves the bottom, and \
                     there more terms do not help. For relief beyond choose Chebyshev."
        }
        "grazing" => {
            "Divided by w², as tables are stored, the error stays level towards grazing directions; undivided it grows without bound."
        }
        _ => "",
    }
}
