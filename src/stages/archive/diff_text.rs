//! What differs between two versions, in words: a summary, and every detail where it is asked for.

use super::diff::{Change, DiffReport, SpecimenChange, short};

/// Beginnings of the keys of `specimen.json` that are set rather than found.
const SETTINGS: [&str; 7] =
    ["optics.", "preparation.", "pigment", "species", "tables.basis", "tables.storage", "tables.served"];

/// Most lines of one kind in a summary.
const SHOWN: usize = 8;

impl DiffReport {
    /// Which specimens, inputs and settings differ, and how far colours and values moved; all that differs, with `details`.
    pub fn to_text(&self, details: bool) -> String {
        if self.is_same() {
            return format!("{} and {} hold the same\n", self.a, self.b);
        }
        let mut text = format!("{} -> {}\n", self.a, self.b);
        append_summary(&mut text, self);
        if details {
            append_details(&mut text, self);
        } else {
            text += "all that differs: `--details`, or `--json`\n";
        }
        text
    }
}

fn append_summary(text: &mut String, report: &DiffReport) {
    let names = |names: &[String]| if names.is_empty() { "none".to_owned() } else { names.join(", ") };
    let changed: Vec<String> = report.specimens.iter().map(|specimen| specimen.name.clone()).collect();
    *text += &format!("specimens changed  {}\n", names(&changed));
    for (title, list) in [("specimens added   ", &report.added), ("specimens removed ", &report.removed)] {
        if !list.is_empty() {
            *text += &format!("{title} {}\n", list.join(", "));
        }
    }
    let inputs: Vec<String> = report.inputs.iter().map(|change| change.what.clone()).collect();
    *text += &format!("inputs changed     {}\n", names(&inputs));
    for change in &report.index {
        *text += &format!("{:<18} {}\n", change.what.trim_end_matches("_sha256"), arrow(change));
    }
    append_settings(text, &report.specimens);
    for specimen in &report.specimens {
        let Some(colours) = &specimen.colours else { continue };
        let [[median, largest], [usual, most]] = [colours.delta_e, colours.relative];
        let [theta_i, phi_i, theta_r, phi_r] = colours.at_deg;
        *text += &format!(
            "colours            {}: CIEDE2000 up to {largest:.2} (median {median:.2}), largest for light from ({theta_i:.1}, {phi_i:.1}) \
             seen from ({theta_r:.1}, {phi_r:.1}) degrees; values by up to {:.3} % (median {:.3} %)\n",
            specimen.name,
            100.0 * most,
            100.0 * usual
        );
    }
}

/// Settings that changed, each once with the specimens that it is of.
fn append_settings(text: &mut String, specimens: &[SpecimenChange]) {
    let mut told: Vec<(String, Vec<&str>)> = Vec::new();
    for specimen in specimens {
        let is_set = |change: &&Change| SETTINGS.iter().any(|start| change.what.starts_with(start));
        for change in specimen.settings.iter().filter(is_set) {
            let line = format!("{}: {}", change.what, arrow(change));
            match told.iter_mut().find(|(known, _)| *known == line) {
                Some((_, names)) => names.push(&specimen.name),
                None => told.push((line, vec![&specimen.name])),
            }
        }
    }
    if told.is_empty() {
        *text += "settings changed   none\n";
    }
    for (line, names) in told.iter().take(SHOWN) {
        *text += &format!("settings changed   {line} ({})\n", names.join(", "));
    }
    if told.len() > SHOWN {
        *text += &format!("settings changed   and {} more\n", told.len() - SHOWN);
    }
}

fn append_details(text: &mut String, report: &DiffReport) {
    for (title, changes) in [("index", &report.index), ("inputs", &report.inputs), ("files", &report.files)] {
        append_changes(text, title, changes, "");
    }
    for specimen in &report.specimens {
        append_specimen(text, specimen);
    }
}

fn append_changes(text: &mut String, title: &str, changes: &[Change], indent: &str) {
    if changes.is_empty() {
        return;
    }
    *text += &format!("{indent}{title}:\n");
    for change in changes {
        *text += &format!("{indent}  {}: {}\n", change.what, arrow(change));
    }
}

fn arrow(change: &Change) -> String {
    let side = |value: &Option<serde_json::Value>| value.as_ref().map_or("(absent)".into(), short);
    format!("{} -> {}", side(&change.a), side(&change.b))
}

fn append_specimen(text: &mut String, specimen: &SpecimenChange) {
    *text += &format!("specimen {}:\n", specimen.name);
    append_changes(text, "settings", &specimen.settings, "  ");
    for table in &specimen.tables {
        *text += &match table.max_relative {
            Some(relative) => format!("  {}: differs by up to {relative:.3e} of its peak\n", table.table),
            None => format!("  {}: in one version only, or of another size\n", table.table),
        };
    }
    if let Some(check) = &specimen.check_values {
        *text += &format!(
            "  check values: {} compared, differ by up to {:.3e} of Y; {} without a partner\n",
            check.compared, check.max_relative, check.unmatched
        );
    }
}
