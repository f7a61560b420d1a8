//! Scenes of several specimens: each renders its share while its tables are at hand, and the shares add up.
//!
//! Light adds up, so a picture is the sum of those in which one specimen's surface alone is bright and the rest, dark,
//! hides and shades it. No more than one specimen's tables are in memory at a time.

use std::path::Path;

use ndarray::Array3;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::scenes::SceneWork;
use super::sharing::specimens_of;
use crate::stages::log::Log;
use crate::stages::results::{SceneResult, SharedSceneResult};
use crate::stages::stage::Stage;
use diffraction_brdf::atlas::{InputRecord, RESULT_FILE};
use diffraction_brdf::error::Result;
use diffraction_brdf::files;
use diffraction_brdf::json;
use diffraction_render::scene::model::{Scene, Shape};

/// Folder of these pictures, beside those of the specimens.
pub const FOLDER: &str = "scenes";

/// A specimen's share of a picture, from the tables and from the reference.
pub(crate) struct Share {
    work: SceneWork,
    expected: Option<Array3<f32>>,
}

/// A picture that is there, and what it was made from: its scene and all its specimens.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub(crate) struct SharedRecord {
    pub made_from: Value,
    pub result: SharedSceneResult,
}

impl SharedRecord {
    /// Those of a version; none where it has no such pictures.
    pub fn read_all(version_folder: &Path) -> Vec<Self> {
        let text = files::read_text(&version_folder.join(FOLDER).join(RESULT_FILE));
        text.ok().and_then(|text| serde_json::from_str(&text).ok()).unwrap_or_default()
    }

    /// Writes those of a version.
    ///
    /// # Errors
    /// The disk's.
    pub fn write_all(records: &[Self], version_folder: &Path) -> Result<()> {
        // Plain structs with string keys: there is nothing in them that JSON could refuse.
        let text = json::pretty(&records).expect("plain data can always be written as JSON");
        files::replace(&version_folder.join(FOLDER).join(RESULT_FILE), text.as_bytes())
    }
}

/// The shares of one scene so far.
struct Sum {
    scene: Scene,
    shares: usize,
    total: Option<Share>,
}

/// The shares of every scene so far.
pub(crate) struct SharedScenes(Vec<Sum>);

/// The files that scenes are made of, each once, with paths relative to `base` where they are below it.
pub fn inputs(scenes: &[Scene], base: &Path) -> Vec<InputRecord> {
    let mut inputs: Vec<InputRecord> = Vec::new();
    for scene in scenes {
        let Shape::Mesh(shape) = &scene.shape else {
            continue;
        };
        for (path, sha256) in &shape.model.files {
            let path = path.strip_prefix(base).unwrap_or(path).display().to_string();
            let record = InputRecord { path, sha256: sha256.clone() };
            if !inputs.contains(&record) {
                inputs.push(record);
            }
        }
    }
    inputs
}

/// A share with its reference, where that is known.
pub fn share(work: SceneWork, expected: Option<Array3<f32>>) -> Share {
    Share { work, expected }
}

impl SharedScenes {
    /// Every scene that is shared and not there already, without shares.
    pub fn new(scenes: &[Scene], is_there: impl Fn(&str) -> bool) -> Self {
        let shared = scenes.iter().filter(|scene| !specimens_of(scene).is_empty() && !is_there(&scene.name));
        Self(shared.map(|scene| Sum { scene: scene.clone(), shares: 0, total: None }).collect())
    }

    /// Adds a specimen's shares.
    pub fn add(&mut self, shares: Vec<Share>) {
        for share in shares {
            let Some(sum) = self.0.iter_mut().find(|sum| sum.scene.name == share.work.name()) else {
                continue;
            };
            sum.shares += 1;
            sum.total = Some(match sum.total.take() {
                None => share,
                Some(total) => Share {
                    work: total.work.plus(&share.work),
                    expected: total.expected.zip(share.expected).map(|(a, b)| a + b),
                },
            });
        }
    }

    /// Writes the pictures whose shares are all there into [`FOLDER`] of a version. What is missing is a failure.
    ///
    /// # Errors
    /// The disk's.
    pub fn finish(self, version_folder: &Path, log: &mut Log) -> Result<Vec<SharedSceneResult>> {
        let mut results = Vec::new();
        for Sum { scene, shares, total } in self.0 {
            let specimens = specimens_of(&scene).to_vec();
            let mut fail = |message: String| log.fail(Stage::RenderScenes, None, message);
            let Some(total) = total.filter(|_| shares == specimens.len()) else {
                let (name, all) = (&scene.name, specimens.join(", "));
                fail(format!("scene \"{name}\" is left out: it shows {all}, not all of which could be built"));
                continue;
            };
            match write(&scene, total, version_folder) {
                Ok(picture) => results.push(SharedSceneResult { specimens, picture }),
                Err(error) if error.is_of_disk_below(version_folder) => return Err(error),
                Err(error) => fail(error.to_string()),
            }
        }
        Ok(results)
    }
}

fn write(scene: &Scene, total: Share, version_folder: &Path) -> Result<SceneResult> {
    files::create_folder(&version_folder.join(FOLDER))?;
    total.work.whole(scene).write(total.expected.as_ref(), &version_folder.join(FOLDER), FOLDER)
}
