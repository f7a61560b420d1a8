//! One atlas under six lights, beside the reference: `cargo run --release --example lights MANIFEST SPECIMEN ATLAS OUT.png`.
//!
//! Light along the normal, every direction to the viewer seen from above. The upper row is evaluated from the specimen's
//! spectral tables, which know no light; the lower row straight from its scans under that light. The left four lights are D65,
//! A, F11, and laser lines of 450, 532 and 632.8 nm together; then the lines of 532 and of 632.8 nm alone. What is printed is how far the rows
//! differ: the root of the summed squared differences of X, Y, Z over the root of the summed squares.

use std::error::Error;
use std::path::Path;

use diffraction_atlas::manifest;
use diffraction_atlas::stages::ingest::{Scans, ingest};
use diffraction_brdf::spectrum::{Illuminant, Line};
use diffraction_brdf::{Atlas, Interpolation, Vec3, Xyz};
use diffraction_build::ground::colour::{auto_exposure, to_srgb8};
use diffraction_build::ground::metrics::relative_l2;
use diffraction_build::optics::config::OpticsConfig;
use diffraction_build::optics::spectral::brdf_xyz_batch;
use diffraction_build::tables::input::BuildInput;
use diffraction_build::tables::plan::plan;
use diffraction_render::render::png_image::{side_by_side, write_png};
use ndarray::{Array3, Axis, concatenate};

/// Pixels across each picture.
const SIDE: usize = 160;

/// Light along the normal.
const WI: Vec3 = [0.0, 0.0, 1.0];

fn lines(wavelengths_nm: &[f64]) -> Illuminant {
    Illuminant::Lines(wavelengths_nm.iter().map(|&wavelength_nm| Line { wavelength_nm, power: 1.0 }).collect())
}

/// The lights, with their names.
fn lights() -> [(&'static str, Illuminant); 6] {
    [
        ("D65", Illuminant::D65),
        ("A", Illuminant::A),
        ("F11", Illuminant::F(11)),
        ("450, 532, 632.8 nm", lines(&[450.0, 532.0, 632.8])),
        ("532 nm", lines(&[532.0])),
        ("632.8 nm", lines(&[632.8])),
    ]
}

/// The viewer's direction of a pixel; `None` outside of the hemisphere's disc.
fn viewer(row: usize, column: usize) -> Option<Vec3> {
    let at = |index: usize| 2.0 * (index as f64 + 0.5) / SIDE as f64 - 1.0;
    let (x, y) = (at(column), -at(row));
    let z2 = 1.0 - x * x - y * y;
    (z2 > 1e-4).then(|| [x, y, z2.sqrt()])
}

fn picture(values: &[Xyz], pixels: &[usize]) -> Array3<f32> {
    let mut image = Array3::zeros((SIDE, SIDE, 3));
    for (xyz, pixel) in values.iter().zip(pixels) {
        (0..3).for_each(|c| image[[pixel / SIDE, pixel % SIDE, c]] = xyz[c] as f32);
    }
    image
}

fn main() -> Result<(), Box<dyn Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [manifest_path, specimen, atlas, out] = &arguments[..] else {
        return Err("usage: lights MANIFEST SPECIMEN ATLAS OUT.png".into());
    };
    let brdf = Atlas::open(atlas)?.brdf(specimen)?.with_interpolation(Interpolation::Cubic);
    let (manifest, _) = manifest::load(Path::new(manifest_path))?;
    let config =
        manifest.specimens.iter().find(|found| found.name == *specimen).ok_or("the manifest has no such specimen")?;
    let Scans { fields, optics, .. } = ingest(config)?;
    let pixels: Vec<usize> = (0..SIDE * SIDE).filter(|&pixel| viewer(pixel / SIDE, pixel % SIDE).is_some()).collect();
    let pairs: Vec<(Vec3, Vec3)> =
        pixels.iter().filter_map(|pixel| Some((WI, viewer(pixel / SIDE, pixel % SIDE)?))).collect();
    let mut rows: [Vec<Array3<u8>>; 2] = Default::default();
    for (name, illuminant) in lights() {
        let light = brdf.xyz_under(&illuminant)?;
        let tables: Vec<Xyz> = pairs.iter().map(|&(wi, wo)| light.eval(wi, wo)).collect();
        let wavelength_nm =
            if let Illuminant::Lines(_) = illuminant { illuminant.reach_nm([380.0, 780.0]) } else { [380.0, 780.0] };
        let optics = OpticsConfig { illuminant, wavelength_nm, ..optics.clone() };
        let spectra = plan(&BuildInput::new(&fields, &optics, &manifest.tables))?.spectra;
        let reference = brdf_xyz_batch(&fields, &optics, &spectra, &pairs)?;
        println!("{name}: {:.1e}", relative_l2(&reference.concat(), &tables.concat()));
        let reference = picture(&reference, &pixels);
        let exposure = auto_exposure(&reference);
        rows[0].push(to_srgb8(&picture(&tables, &pixels), exposure));
        rows[1].push(to_srgb8(&reference, exposure));
    }
    let rows = rows.map(|row| side_by_side(&row.iter().collect::<Vec<_>>(), 4, [255; 3]));
    write_png(Path::new(out), &concatenate(Axis(0), &rows.each_ref().map(|row| row.view()))?)?;
    Ok(())
}
