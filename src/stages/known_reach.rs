//! What scenes reach of a grid, kept in the cache: it depends on no surface, so that specimens share it.

use serde_json::{Value, json};

use super::cache::Cache;
use diffraction_brdf::error::Result;
use diffraction_build::tables::domain::Domain;
use diffraction_build::tables::plan::Grid;
use diffraction_render::scene::model::{Scene, Shape};
use diffraction_render::scene::reach::reach;

/// [`reach`], found where it is not known.
///
/// # Errors
/// As [`reach`].
pub fn known_reach(cache: &Cache, scene: &Scene, grid: Grid, parts: usize) -> Result<Domain> {
    if !cache.is_on() {
        return reach(scene, grid, parts);
    }
    let key = cache.key("reach", &json!({ "scene": scene_parts(scene), "grid": grid.size }));
    if let Some(domain) = cache.load(&key).and_then(|bytes| decode(&bytes, grid)) {
        return Ok(domain);
    }
    let domain = reach(scene, grid, parts)?;
    cache.store(&key, &encode(&domain));
    Ok(domain)
}

/// Everything of a scene that decides where its samples lie: not what it is called, nor how it is shown.
fn scene_parts(scene: &Scene) -> Value {
    let mut parts = json!(scene);
    for key in ["name", "exposure", "specimen", "tolerance"] {
        parts[key] = Value::Null;
    }
    let mesh: Vec<&String> = match &scene.shape {
        Shape::Mesh(shape) => shape.model.files.iter().map(|(_, digest)| digest).collect(),
        _ => Vec::new(),
    };
    // Only what was read says how the image is turned.
    let sky_deg = scene.environment.as_ref().map(|environment| environment.sky.rotate_deg());
    json!([parts, mesh, sky_deg])
}

/// Each texel reached: its index, lowest and highest `t`.
fn encode(domain: &Domain) -> Vec<u8> {
    let ends = domain.low.iter().zip(&domain.high).enumerate().filter(|(_, (low, high))| low <= high);
    let texel = |(index, (low, high)): (usize, (&f32, &f32))| {
        [(index as u32).to_le_bytes(), low.to_le_bytes(), high.to_le_bytes()]
    };
    ends.flat_map(texel).flatten().collect()
}

fn decode(bytes: &[u8], grid: Grid) -> Option<Domain> {
    let (words, rest) = bytes.as_chunks::<4>();
    let (texels, other) = words.as_chunks::<3>();
    let mut domain = Domain::new(grid);
    for [index, low, high] in texels {
        let index = u32::from_le_bytes(*index) as usize;
        *domain.low.get_mut(index)? = f32::from_le_bytes(*low);
        *domain.high.get_mut(index)? = f32::from_le_bytes(*high);
    }
    (rest.is_empty() && other.is_empty()).then_some(domain)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stages::cache::CacheConfig;
    use diffraction_render::scene::model::{Exposure, Light};

    fn ball() -> Scene {
        let sun = Light { direction: [0.3, 0.2, 1.0], angular_diameter_deg: 0.5, irradiance: 1.0 };
        Scene::still("ball", Shape::Sphere, vec![sun], 24)
    }

    #[test]
    fn what_is_known_is_what_is_found() {
        let folder = tempfile::tempdir().unwrap();
        let cache = Cache::open(&CacheConfig { folder: folder.path().to_owned(), limit_mib: 1 });
        let grid = Grid { size: 61, half_width: 2.0 };
        let found = known_reach(&cache, &ball(), grid, 1).unwrap();
        assert!(found == reach(&ball(), grid, 1).unwrap() && found.texels() > 500);
        // How many copies of the grid are filled at once is no part of the key.
        assert!(found == reach(&ball(), grid, 4).unwrap());
        let [before, _] = cache.traffic();
        // The same under another name, brighter, and asked for less.
        let other = Scene { name: "other".into(), exposure: Exposure::Ev(2.0), tolerance: Some(0.1), ..ball() };
        assert!(known_reach(&cache, &other, grid, 1).unwrap() == found);
        let [after, _] = cache.traffic();
        assert!(after > before, "it was read");
        // Everything else makes another scene.
        let finer = Grid { size: 63, ..grid };
        let larger = Scene { size_px: 25, ..ball() };
        for (scene, grid) in [(ball(), finer), (larger, grid)] {
            assert!(known_reach(&cache, &scene, grid, 1).unwrap() == reach(&scene, grid, 1).unwrap());
            assert_eq!(cache.traffic()[0], after);
        }
    }

    #[test]
    fn bytes_that_are_no_domain_are_refused() {
        let grid = Grid { size: 61, half_width: 2.0 };
        let good = encode(&reach(&ball(), grid, 1).unwrap());
        assert!(decode(&good, grid).is_some());
        assert!(decode(&good[..good.len() - 1], grid).is_none() && decode(&good[..good.len() - 4], grid).is_none());
        assert!(decode(&good, Grid { size: 31, ..grid }).is_none(), "texels beyond the grid");
    }
}
