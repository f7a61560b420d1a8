//! What the pages of a run and of a study have in common: their looks, and what sorts the overview.

/// The style sheet.
pub(crate) const STYLE: &str = include_str!("templates/style.css");

/// Sorts, filters and searches the overview of specimens.
pub(crate) const OVERVIEW_SCRIPT: &str = include_str!("templates/overview.js");
