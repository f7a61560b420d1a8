//! Which specimens a scene shows, and what one of them renders of it.

use diffraction_render::scene::model::{Scene, Shape, share_of};

/// Names of the specimens that share a scene; none where each has its own picture.
pub(crate) fn specimens_of(scene: &Scene) -> &[String] {
    match &scene.shape {
        Shape::Mesh(mesh) => &mesh.specimens,
        _ => &[],
    }
}

/// What a specimen renders: its scenes, and its shares of others.
pub(crate) fn scenes_for(scenes: &[Scene], specimen: &str) -> Vec<Scene> {
    let mut wanted = Vec::new();
    for scene in scenes {
        let sharing = specimens_of(scene);
        if sharing.is_empty() {
            if scene.specimen.as_ref().is_none_or(|name| name == specimen) {
                wanted.push(scene.clone());
            }
        } else if let Some(index) = sharing.iter().position(|name| name == specimen) {
            wanted.push(share_of(scene, index));
        }
    }
    wanted
}
