//! Values of an atlas at many directions, as JSON: what readers in other languages are held against.
//!
//!     cargo run --release -p diffraction-brdf --example values -- out/atlas/bundled > values.json
//!
//! One object for each specimen: `wi`, `wo`, `u` (three numbers in [0, 1) to sample with), and for each of these directions
//! what [`Brdf`] gives, `null` where there is no answer.

use std::collections::BTreeMap;
use std::error::Error;

use diffraction_brdf::direction::from_angles_deg;
use diffraction_brdf::spectrum::Illuminant;
use diffraction_brdf::{Atlas, Brdf, Footprint, Interpolation, Vec3};
use serde_json::{Value, json};

/// Pairs of directions for each specimen.
const PAIRS: usize = 96;
/// Diameters in degrees of the lights of filtered look-ups.
const DIAMETERS_DEG: [f64; 4] = [0.05, 0.53, 3.0, 12.0];
const WAVELENGTHS_NM: [f64; 3] = [412.0, 550.0, 701.5];

/// Directions spread over the hemisphere, every third pair around the mirror direction, and some grazing.
fn pair(k: usize) -> ([Vec3; 2], [f64; 3]) {
    let turn = |factor: f64| (factor * (k as f64 + 1.0)).fract();
    let theta = |x: f64| if k % 4 == 3 { 80.0 + 9.99 * x } else { 80.0 * x };
    let (theta_i, phi_i) = (theta(turn(0.754_877_666)), 360.0 * turn(0.569_840_291));
    let (theta_o, phi_o) = if k.is_multiple_of(3) {
        (theta_i + 3.0 * turn(0.381_966_01) - 3.0, phi_i + 180.0 + 4.0 * turn(0.618_033_99) - 2.0)
    } else {
        (theta(turn(0.819_172_513)), 360.0 * turn(0.671_043_607))
    };
    let directions = [from_angles_deg(theta_i, phi_i), from_angles_deg(theta_o.abs(), phi_o)];
    (directions, [turn(0.414_213_562), turn(0.732_050_808), turn(0.236_067_977)])
}

fn values(brdf: &Brdf) -> Result<Value, Box<dyn Error>> {
    let cubic = brdf.clone().with_interpolation(Interpolation::Cubic);
    let spline = brdf.clone().with_interpolation(Interpolation::Spline);
    let limited = brdf.clone().with_energy_limit();
    let mut columns: BTreeMap<String, Vec<Value>> = BTreeMap::new();
    for k in 0..PAIRS {
        let ([wi, wo], u) = pair(k);
        let mut add = |name: &str, value: Value| columns.entry(name.to_owned()).or_default().push(value);
        add("wi", json!(wi));
        add("wo", json!(wo));
        add("u", json!(u));
        add("linear", json!(brdf.eval(wi, wo)));
        add("cubic", json!(cubic.eval(wi, wo)));
        add("spline", json!(spline.eval(wi, wo)));
        add("limited", json!(limited.eval(wi, wo)));
        add("pdf", json!(brdf.pdf(wi, wo)));
        add("sample", json!(brdf.sample(wo, u).map(|sample| (sample.wi, sample.weight, sample.pdf))));
        for diameter_deg in DIAMETERS_DEG {
            let light = Footprint::of_light(wi, diameter_deg)?;
            add(&format!("filtered_{diameter_deg}"), json!(brdf.eval_filtered(wi, wo, light)));
            add(&format!("filtered_cubic_{diameter_deg}"), json!(cubic.eval_filtered(wi, wo, light)));
            if brdf.spectral().is_some() {
                let spectrum = brdf.eval_wavelengths_filtered(wi, wo, light, &WAVELENGTHS_NM)?;
                add(&format!("wavelengths_filtered_{diameter_deg}"), json!(spectrum));
            }
        }
        if brdf.spectral().is_some() {
            add("wavelengths", json!(brdf.eval_wavelengths(wi, wo, &WAVELENGTHS_NM)?));
            add("wavelengths_cubic", json!(cubic.eval_wavelengths(wi, wo, &WAVELENGTHS_NM)?));
            add("wavelengths_spline", json!(spline.eval_wavelengths(wi, wo, &WAVELENGTHS_NM)?));
        }
    }
    if brdf.spectral().is_some() {
        let lights = [("D65", Illuminant::D65), ("A", Illuminant::A), ("E", Illuminant::E), ("F11", Illuminant::F(11))];
        for (name, light) in lights {
            let under = brdf.xyz_under(&light)?;
            let xyz = (0..PAIRS).map(pair).map(|([wi, wo], _)| json!(under.eval(wi, wo)));
            columns.insert(format!("under_{name}"), xyz.collect());
        }
    }
    Ok(json!({ "wavelengths_nm": WAVELENGTHS_NM, "diameters_deg": DIAMETERS_DEG, "columns": columns }))
}

fn main() -> Result<(), Box<dyn Error>> {
    let path = std::env::args().nth(1).ok_or("usage: values ATLAS")?;
    let atlas = Atlas::open(path)?;
    let specimens: Result<BTreeMap<&str, Value>, Box<dyn Error>> =
        atlas.specimens().iter().map(|entry| Ok((entry.name.as_str(), values(&atlas.brdf(&entry.name)?)?))).collect();
    println!("{}", serde_json::to_string(&specimens?)?);
    Ok(())
}
