//! Mesh files in scenes: the file itself, the camera, and which specimen covers which material.

use std::path::Path;
use std::sync::Arc;

use super::defaults;
use super::files;
use super::keys;
use super::reader::{Item, Section};
use crate::error::Result;
use crate::stages::pictures::shared_scenes::FOLDER as SHARED_FOLDER;
use diffraction_render::scene::camera::{self, Camera, Field};
use diffraction_render::scene::mesh::MeshShape;
use diffraction_render::scene::mesh_file::{self, COORDINATE_MAX, Model};

/// How a mesh is given in the shape's place.
pub(crate) const EXAMPLE: &str = "the name of a mesh file such as \"body.obj\"";

/// Whether a shape is a file rather than a word.
pub(crate) fn names_a_file(item: &Item) -> bool {
    item.as_text().is_some_and(|text| text.contains('.'))
}

/// The mesh of a scene; the file is read.
pub fn read(section: &Section, item: &Item, specimens: &[&str], base: &Path) -> Result<MeshShape> {
    let path = base.join(item.text_not_empty()?);
    if !path.is_file() {
        return Err(item.error(files::no_file(&path)));
    }
    let model =
        mesh_file::read(&path).map_err(|error| item.error(format!("names a mesh that cannot be shown: {error}")))?;
    let (covering, specimen_of_material) = match section.get("materials") {
        Some(materials) => materials_of(section, &materials, &model, specimens)?,
        None => (Vec::new(), Vec::new()),
    };
    Ok(MeshShape {
        camera: section.get("camera").map(|item| camera(&item)).transpose()?,
        path,
        specimens: covering,
        specimen_of_material,
        shown: None,
        model: Arc::new(model),
    })
}

/// Specimens in the manifest's order, and for each material of the mesh the index of its specimen among them.
fn materials_of(
    section: &Section,
    item: &Item,
    model: &Model,
    specimens: &[&str],
) -> Result<(Vec<String>, Vec<usize>)> {
    if section.has("specimen") {
        return Err(
            section.error_at_key("specimen", "`specimen` covers the whole mesh, `materials` its parts: give one")
        );
    }
    if let Some(name) = specimens.iter().find(|name| name.eq_ignore_ascii_case(SHARED_FOLDER)) {
        return Err(item.error(format!(
            "puts pictures into the folder \"{SHARED_FOLDER}\" beside the specimens; give the specimen \"{name}\" another name"
        )));
    }
    let known = &model.mesh.material_names;
    let listed = || known.iter().map(|name| format!("{name:?}")).collect::<Vec<_>>().join(", ");
    let options: Vec<(&str, usize)> = specimens.iter().enumerate().map(|(index, name)| (*name, index)).collect();
    let mut chosen = vec![None; known.len()];
    for (name, value) in item.named_values("{ back = \"corn_snake\" }")? {
        let Some(material) = known.iter().position(|other| *other == name) else {
            return Err(value.error(format!("names no material of the mesh; it has {}", listed())));
        };
        chosen[material] = Some(value.choice(&options)?);
    }
    let missing: Vec<String> =
        known.iter().zip(&chosen).filter(|(_, chosen)| chosen.is_none()).map(|(name, _)| format!("{name:?}")).collect();
    if !missing.is_empty() {
        let missing = missing.join(", ");
        return Err(item
            .error(format!("must name a specimen for every material of the mesh, {}; missing: {missing}", listed())));
    }
    let chosen: Vec<usize> = chosen.into_iter().flatten().collect();
    let mut covering = chosen.clone();
    covering.sort_unstable();
    covering.dedup();
    let index_of = |specimen: &usize| covering.binary_search(specimen).expect("it was collected from these");
    Ok((covering.iter().map(|&index| specimens[index].to_owned()).collect(), chosen.iter().map(index_of).collect()))
}

fn camera(item: &Item) -> Result<Camera> {
    let example = "{ position = [0, 0, 5], target = [0, 0, 0] }";
    let section = item.section(&keys::CAMERA, example)?;
    let vector = |item: Item| -> Result<[f64; 3]> {
        let [x, y, z] = item.list_of::<3>("three numbers")?;
        let component = |item: &Item| item.number_within(-COORDINATE_MAX, COORDINATE_MAX, "");
        Ok([component(&x)?, component(&y)?, component(&z)?])
    };
    if section.has("width") && section.has("fov_deg") {
        let message = "`width` makes parallel rays, `fov_deg` a pinhole camera: give one";
        return Err(section.error_at_key("width", message));
    }
    let camera = Camera {
        position: vector(section.require("position", example)?)?,
        target: vector(section.require("target", example)?)?,
        up: section.get("up").map(vector).transpose()?.unwrap_or(defaults::CAMERA_UP),
        field: match (section.get("width"), section.get("fov_deg")) {
            (Some(width), _) => Field::Width(width.number_above(0.0, COORDINATE_MAX, "in the mesh's unit")?),
            (None, Some(fov)) => Field::FovDeg(fov.number_within(0.01, 170.0, "degrees")?),
            (None, None) => Field::FovDeg(defaults::CAMERA_FOV_DEG),
        },
    };
    if camera::view(&camera).is_none() {
        return Err(item.error(
            "sees nothing: `position` and `target` must differ, and `up` must not lie along the line between them",
        ));
    }
    Ok(camera)
}
