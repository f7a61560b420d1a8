//! Comparing two atlas versions: inputs, settings, files, tables and check values.

use std::collections::BTreeMap;
use std::path::Path;

use ndarray::Array3;
use serde::Serialize;
use serde_json::Value;

use super::diff_colours::colour_change;
use crate::stages::archive::specimen_file::{self, SpecimenFile};
use diffraction_brdf::atlas::{self, AtlasIndex};
use diffraction_brdf::direction::Xyz;
use diffraction_brdf::error::{Error, Result};
use diffraction_brdf::specimen::CheckValue;
use diffraction_build::tables::model::TableSet;

pub use super::diff_colours::ColourChange;

/// A value that is not the same in both; `None` where it is absent.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Change {
    /// Where: the keys down to the value, joined by dots.
    pub what: String,
    /// Before.
    pub a: Option<Value>,
    /// After.
    pub b: Option<Value>,
}

/// How far a table moved.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct TableChange {
    /// `table.NNN`, `lobe` or `lobe.NNN`.
    pub table: String,
    /// Largest difference over the largest absolute value of either; `None` where the shapes differ or one is absent.
    pub max_relative: Option<f64>,
}

/// How far the check values of equal directions moved.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct CheckChange {
    /// Directions in both.
    pub compared: usize,
    /// Directions in one only.
    pub unmatched: usize,
    /// Largest difference of X, Y or Z over the larger Y of the two; 0 where nothing is compared.
    pub max_relative: f64,
}

/// What changed in a specimen that both versions hold.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct SpecimenChange {
    /// The specimen.
    pub name: String,
    /// Differences of `specimen.json`, check values apart.
    pub settings: Vec<Change>,
    /// Tables that differ.
    pub tables: Vec<TableChange>,
    /// How far colours and values moved; `None` where no table differs and the front factor is the same.
    pub colours: Option<ColourChange>,
    /// The check values, where they differ.
    pub check_values: Option<CheckChange>,
}

/// Everything that differs between versions `a` and `b`.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct DiffReport {
    /// The first version's folder.
    pub a: String,
    /// The second version's folder.
    pub b: String,
    /// Name, program version and manifest of the index.
    pub index: Vec<Change>,
    /// Inputs by path, with their digests.
    pub inputs: Vec<Change>,
    /// Files by path, with their digests; those that hold times are left out.
    pub files: Vec<Change>,
    /// Specimens only in `a`.
    pub removed: Vec<String>,
    /// Specimens only in `b`.
    pub added: Vec<String>,
    /// Specimens in both that differ.
    pub specimens: Vec<SpecimenChange>,
}

impl DiffReport {
    /// Whether nothing differs but times.
    pub fn is_same(&self) -> bool {
        [&self.index, &self.inputs, &self.files].iter().all(|changes| changes.is_empty())
            && self.removed.is_empty()
            && self.added.is_empty()
            && self.specimens.is_empty()
    }
}

/// Compares two versions; each path is a version's folder, or an atlas, of which the newest version is taken.
pub fn diff(a: &Path, b: &Path) -> Result<DiffReport> {
    let (a, b) = (atlas::resolve(a)?.folder, atlas::resolve(b)?.folder);
    let (index_a, index_b) = (atlas::read_index(&a)?, atlas::read_index(&b)?);
    let names = |index: &AtlasIndex| index.specimens.iter().map(|entry| entry.name.clone()).collect::<Vec<_>>();
    let (names_a, names_b) = (names(&index_a), names(&index_b));
    let mut specimens = Vec::new();
    for name in names_a.iter().filter(|name| names_b.contains(name)) {
        let loaded_a = specimen_file::load(&atlas::specimen_folder(&a, &index_a, name)?)?;
        let loaded_b = specimen_file::load(&atlas::specimen_folder(&b, &index_b, name)?)?;
        specimens.extend(specimen_change(name, &loaded_a, &loaded_b)?);
    }
    Ok(DiffReport {
        a: a.display().to_string(),
        b: b.display().to_string(),
        index: index_changes(&index_a, &index_b),
        inputs: digest_changes(
            index_a.inputs.iter().map(|input| (&input.path, &input.sha256)),
            index_b.inputs.iter().map(|input| (&input.path, &input.sha256)),
        ),
        files: digest_changes(
            index_a.content().files.iter().map(|file| (&file.path, &file.sha256)),
            index_b.content().files.iter().map(|file| (&file.path, &file.sha256)),
        ),
        removed: names_a.iter().filter(|name| !names_b.contains(name)).cloned().collect(),
        added: names_b.iter().filter(|name| !names_a.contains(name)).cloned().collect(),
        specimens,
    })
}

fn index_changes(a: &AtlasIndex, b: &AtlasIndex) -> Vec<Change> {
    let fields = |index: &AtlasIndex| {
        serde_json::json!({"name": index.name, "program_version": index.program_version,
                           "manifest_sha256": index.manifest_sha256})
    };
    changes(&fields(a), &fields(b))
}

/// By path: changed, only in the first, only in the second.
fn digest_changes<'a>(
    a: impl Iterator<Item = (&'a String, &'a String)>,
    b: impl Iterator<Item = (&'a String, &'a String)>,
) -> Vec<Change> {
    let value = |entries: BTreeMap<&String, &String>| -> BTreeMap<String, Value> {
        entries.into_iter().map(|(path, digest)| (path.clone(), Value::String(digest.clone()))).collect()
    };
    leaf_changes(value(a.collect()), value(b.collect()))
}

fn specimen_change(
    name: &str,
    (file_a, tables_a): &(SpecimenFile, TableSet),
    (file_b, tables_b): &(SpecimenFile, TableSet),
) -> Result<Option<SpecimenChange>> {
    let settings = changes(&settings(file_a)?, &settings(file_b)?);
    let tables = table_changes(tables_a, tables_b);
    let check_values =
        (file_a.check_values != file_b.check_values).then(|| check_change(&file_a.check_values, &file_b.check_values));
    let same = settings.is_empty() && tables.is_empty() && check_values.is_none();
    let looks_the_same = tables.is_empty() && tables_a.front_factor == tables_b.front_factor;
    let colours = (!looks_the_same).then(|| colour_change(tables_a, tables_b));
    Ok((!same).then(|| SpecimenChange { name: name.to_owned(), settings, tables, colours, check_values }))
}

fn settings(file: &SpecimenFile) -> Result<Value> {
    let without = SpecimenFile { check_values: Vec::new(), ..file.clone() };
    serde_json::to_value(without).map_err(|e| Error::Call(format!("{}: cannot be compared: {e}", file.name)))
}

/// All leaves that differ.
pub(crate) fn changes(a: &Value, b: &Value) -> Vec<Change> {
    let leaves = |value: &Value| {
        let mut found = BTreeMap::new();
        collect_leaves(String::new(), value, &mut found);
        found
    };
    leaf_changes(leaves(a), leaves(b))
}

/// Keys down to each value that holds no others; an empty list or object is a value.
fn collect_leaves(key: String, value: &Value, found: &mut BTreeMap<String, Value>) {
    let below = |part: &str| if key.is_empty() { part.to_owned() } else { format!("{key}.{part}") };
    match value {
        Value::Object(map) if !map.is_empty() => {
            map.iter().for_each(|(part, item)| collect_leaves(below(part), item, found));
        }
        Value::Array(items) if !items.is_empty() => {
            // Padded, so that sorting by text keeps the order of the list.
            items.iter().enumerate().for_each(|(n, item)| collect_leaves(below(&format!("{n:03}")), item, found));
        }
        leaf => {
            found.insert(key, leaf.clone());
        }
    }
}

/// Values of either that differ, by their keys.
pub(super) fn leaf_changes(mut a: BTreeMap<String, Value>, mut b: BTreeMap<String, Value>) -> Vec<Change> {
    let mut keys: Vec<String> = a.keys().chain(b.keys()).cloned().collect();
    keys.sort_unstable();
    keys.dedup();
    let change = |what: String| Change { a: a.remove(&what), b: b.remove(&what), what };
    keys.into_iter().map(change).filter(|change| change.a != change.b).collect()
}

fn table_changes(a: &TableSet, b: &TableSet) -> Vec<TableChange> {
    let (a, b) = (named_tables(a), named_tables(b));
    let mut names: Vec<&String> = a.keys().chain(b.keys()).collect();
    names.sort_unstable();
    names.dedup();
    let change = |name: &String| {
        let max_relative = match (a.get(name), b.get(name)) {
            (Some(a), Some(b)) if a == b => return None,
            (Some(a), Some(b)) if a.dim() == b.dim() => Some(max_relative(a, b)),
            _ => None,
        };
        Some(TableChange { table: name.clone(), max_relative })
    };
    names.into_iter().filter_map(change).collect()
}

fn named_tables(set: &TableSet) -> BTreeMap<String, &Array3<f32>> {
    let mut named: BTreeMap<String, &Array3<f32>> =
        set.tables.iter().enumerate().map(|(n, table)| (format!("table.{n:03}"), table)).collect();
    if let Some(lobe) = &set.lobe {
        named.insert("lobe".to_owned(), &lobe.coherent);
        named.extend(lobe.cross.iter().enumerate().map(|(n, patch)| (format!("lobe.{n:03}"), patch)));
    }
    named
}

/// Over the peak: pointwise ratios would be ruled by texels next to zero, which nobody sees.
fn max_relative(a: &Array3<f32>, b: &Array3<f32>) -> f64 {
    let pairs = a.iter().zip(b).map(|(&a, &b)| (f64::from(a), f64::from(b)));
    let (difference, peak) = pairs.fold((0f64, 0f64), |(difference, peak), (a, b)| {
        (difference.max((a - b).abs()), peak.max(a.abs()).max(b.abs()))
    });
    if peak > 0.0 { difference / peak } else { 0.0 }
}

fn check_change(a: &[CheckValue], b: &[CheckValue]) -> CheckChange {
    let same_directions = |a: &CheckValue, b: &CheckValue| a.wi == b.wi && a.wo == b.wo;
    let matched: Vec<(Xyz, Xyz)> =
        a.iter().filter_map(|a| b.iter().find(|b| same_directions(a, b)).map(|b| (a.xyz, b.xyz))).collect();
    let relative = |(a, b): &(Xyz, Xyz)| {
        let difference = (0..3).map(|channel| (a[channel] - b[channel]).abs()).fold(0.0, f64::max);
        let luminance = a[1].abs().max(b[1].abs());
        if luminance > 0.0 { difference / luminance } else { difference }
    };
    CheckChange {
        compared: matched.len(),
        unmatched: a.len() + b.len() - 2 * matched.len(),
        max_relative: matched.iter().map(relative).fold(0.0, f64::max),
    }
}

/// A value in a line of text; digests by their first digits.
pub(crate) fn short(value: &Value) -> String {
    match value {
        Value::String(text) if text.len() == 64 && text.bytes().all(|byte| byte.is_ascii_hexdigit()) => {
            format!("sha256 {}", &text[..12])
        }
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn leaves_are_compared_by_their_keys() {
        let a = json!({"x": {"y": [1, 2], "gone": true}, "same": "s", "empty": []});
        let b = json!({"same": "s", "x": {"y": [1, 3, 4]}, "empty": []});
        let found: Vec<_> = changes(&a, &b).into_iter().map(|c| (c.what, c.a, c.b)).collect();
        let expected = vec![
            ("x.gone".to_owned(), Some(json!(true)), None),
            ("x.y.001".to_owned(), Some(json!(2)), Some(json!(3))),
            ("x.y.002".to_owned(), None, Some(json!(4))),
        ];
        assert_eq!(found, expected);
        assert!(changes(&a, &a).is_empty());
    }

    #[test]
    fn tables_are_compared_over_their_peak() {
        let a = Array3::from_elem((2, 2, 3), 2.0f32);
        let mut b = a.clone();
        b[[1, 0, 2]] = 1.5;
        assert_eq!(max_relative(&a, &b), 0.25);
        assert_eq!(max_relative(&a, &a), 0.0);
    }
}
