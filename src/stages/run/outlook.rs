//! What a run would make and why, without making it.

use serde::Serialize;

use super::choose::{Choice, Newest, choose};
use crate::error::Result;
use crate::stages::config::{RunConfig, SpecimenConfig};
use crate::stages::coverage::asked;

/// What a run would do with a specimen.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
pub struct Outlook {
    /// The specimen.
    pub name: String,
    /// Whether it would be made.
    pub make: bool,
    /// Why, in words.
    pub why: String,
}

/// Looks at every specimen that a run would take.
///
/// # Errors
/// The disk's.
pub fn outlook(config: &RunConfig) -> Result<Vec<Outlook>> {
    let newest = match config.atlas_root.is_dir() {
        true => Newest::of(&config.atlas_root)?,
        false => None,
    };
    let specimens: Vec<&SpecimenConfig> = asked::specimens(config).collect();
    let (choices, _) = choose(config, &specimens, newest.as_ref());
    let one = |(specimen, choice): (&&SpecimenConfig, Choice)| {
        let (make, why) = match choice {
            Choice::Make { why, .. } => (true, why),
            Choice::Found(found) if found.is_published => (false, "nothing that it is made from has changed".into()),
            Choice::Found(_) => (false, "it is finished, and no version holds it yet".into()),
        };
        Outlook { name: specimen.name.clone(), make, why }
    };
    Ok(specimens.iter().zip(choices).map(one).collect())
}
