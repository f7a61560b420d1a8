//! Sampling on the GPU: densities against those of double precision, drawn directions against the densities, and what a coarse grid costs.

use std::f64::consts::{PI, TAU};

use diffraction_brdf::direction::from_angles_deg;
use diffraction_brdf::shader::promised_image;
use diffraction_brdf::shader_sampling::{CELLS_MAX, SamplingImage, ShaderSampler};
use diffraction_brdf::{Atlas, TableSet, Vec3};
use diffraction_render::render::gpu::Gpu;
use diffraction_render::render::gpu_sampled::{SampledQuery, draw_samples, eval_densities, upload_sampled};
use diffraction_render::render::gpu_tables::GpuTables;
use rayon::prelude::*;

use crate::filtered::snake;
use crate::sets::{full_set, gpu};
use crate::skip::skipped;

/// Polar angles of the viewer in degrees.
const ANGLES_DEG: [f64; 5] = [0.0, 35.0, 70.0, 85.0, 89.0];
/// Directions to the light for each viewer, a third of them even, the others drawn.
const DIRECTIONS: usize = 3_000;
/// Samples per viewer.
const SAMPLES: usize = 30_000;
/// Bins of the hemisphere in y and φ, where `wi = (h sin φ, y, h cos φ)`, `h = sqrt(1 - y²)`, in the viewer's frame: all of one solid angle.
const BINS: [usize; 2] = [16, 32];
/// Points per side of a bin at which densities are integrated: of most, and of those near the mirror direction.
const POINTS: [usize; 2] = [12, 80];
/// Distance in (u, v) from there within which a bin's middle lies that a lobe may reach.
const LOBE_REACH: f64 = 0.25;
/// A chi-square value of this probability or less fails; the random numbers are always the same.
const SIGNIFICANCE: f64 = 1e-4;
/// How far off a component of a direction rounding is: places in the grid are sums of three numbers up to 2 and a quotient, each rounded to
/// 2^-24 of 2, and a division that may err by 2.5 units of 4.
const SHIFT: f64 = 20.0 / (1u64 << 24) as f64;
/// Rounding of what is multiplied: three probabilities, each with a sum of up to 32 terms and twenty factors, make 160 units of 2^-24; angles
/// of the narrowest pieces, 0.044 apart, err by four units of 2.
const ROUNDING: f64 = 1e-5 + 1.1e-5;

/// Table sets with the scalar factor, shadowing and a cross term, and with the vector one on a snake, whose cells are blocks of texels.
fn sets() -> [(&'static str, &'static TableSet); 2] {
    [("full", full_set()), ("snake", snake().brdf.tables())]
}

fn viewers() -> impl Iterator<Item = (f64, Vec3)> {
    ANGLES_DEG.into_iter().enumerate().map(|(k, angle)| (angle, from_angles_deg(angle, 31.0 * k as f64 + 17.0)))
}

/// What 32-bit floats make of a direction.
fn rounded(direction: Vec3) -> Vec3 {
    direction.map(|c| f64::from(c as f32))
}

fn query(wo: Vec3, more: Vec3) -> SampledQuery {
    let [wo, more] = [wo, more].map(|v| v.map(|c| c as f32));
    SampledQuery { wo, more, unused: 0.0, unused_too: 0.0 }
}

fn random_triple(random: &mut fastrand::Rng) -> Vec3 {
    [0; 3].map(|_| f64::from(random.f32()))
}

/// Pairs of directions as 32-bit floats hold them.
fn pairs(sampler: &ShaderSampler) -> Vec<(Vec3, Vec3)> {
    let mut random = fastrand::Rng::with_seed(7);
    let mut pairs = Vec::new();
    for (_, wo) in viewers() {
        for n in 0..DIRECTIONS {
            let u = random_triple(&mut random);
            let even = direction([1.0, 0.0], 2.0 * u[0] - 1.0, PI * (u[1] - 0.5));
            let wi = if n % 3 == 0 { even } else { sampler.sample(wo, u).unwrap_or(even) };
            pairs.push((rounded(wi), rounded(wo)));
        }
    }
    pairs
}

/// The least and the most that the density may be: over directions that are off by rounding, and with its own.
fn allowed(sampler: &ShaderSampler, (wi, wo): (Vec3, Vec3)) -> [f64; 2] {
    let moved = |v: Vec3, [x, y]: [f64; 2]| {
        let [x, y] = [v[0] + SHIFT * x, v[1] + SHIFT * y];
        [x, y, (1.0 - x * x - y * y).max(0.0).sqrt()]
    };
    const STEPS: [[f64; 2]; 9] =
        [[0., 0.], [1., 0.], [-1., 0.], [0., 1.], [0., -1.], [1., 1.], [1., -1.], [-1., 1.], [-1., -1.]];
    let mut range = [sampler.pdf(wi, wo); 2];
    for light in STEPS {
        for viewer in STEPS {
            let density = sampler.pdf(moved(wi, light), moved(wo, viewer));
            range = [range[0].min(density), range[1].max(density)];
        }
    }
    [range[0] * (1.0 - ROUNDING), range[1] * (1.0 + ROUNDING)]
}

/// How many densities of a GPU are not within what is allowed, and the largest distance of one as a share of the allowed value.
fn outside(
    gpu: &Gpu,
    set: &TableSet,
    image: &SamplingImage,
    pairs: &[(Vec3, Vec3)],
    ranges: &[[f64; 2]],
) -> (usize, f64) {
    let tables = upload_sampled(gpu, &promised_image(set, None).unwrap(), image).unwrap();
    let queries: Vec<SampledQuery> = pairs.iter().map(|&(wi, wo)| query(wo, wi)).collect();
    let densities = eval_densities(gpu, &tables, &queries).unwrap();
    let (mut count, mut worst) = (0, 0f64);
    for (&density, [least, most]) in densities.iter().zip(ranges) {
        let density = f64::from(density);
        let off = ((least - density) / least).max((density - most) / most);
        if off.is_nan() || off > 0.0 {
            count += 1;
            worst = worst.max(off);
        }
    }
    (count, worst)
}

#[test]
fn densities_are_those_of_double_precision() {
    let Some(gpu) = gpu("densities of samples") else { return };
    for (name, set) in sets() {
        let sampler = ShaderSampler::new(set);
        let mut image = sampler.image();
        let pairs = pairs(&sampler);
        let ranges: Vec<[f64; 2]> = pairs.par_iter().map(|&pair| allowed(&sampler, pair)).collect();
        let mut widths: Vec<f64> = ranges.iter().map(|[least, most]| most / least - 1.0).collect();
        widths.sort_by(f64::total_cmp);
        let (count, worst) = outside(gpu, set, &image, &pairs, &ranges);
        println!(
            "{name}: {count} of {} outside, by {worst:.1e}; allowed {:.1e} at the median",
            pairs.len(),
            widths[widths.len() / 2]
        );
        assert_eq!(count, 0, "{name}: by {worst:e}");
        assert!(widths[widths.len() / 2] < 1e-3, "the bound says nothing: {widths:?}");
        // A thousandth more of the strip in the middle of the lobe, at every node.
        let columns = image.size[1];
        (2..10).for_each(|row| image.texels[row * columns + 3 + 16] *= 1.001);
        let (count, _) = outside(gpu, set, &image, &pairs, &ranges);
        assert!(count > pairs.len() / 10, "{name}: a strip that is off goes unseen: {count}");
    }
}

/// The direction at `y` and `φ` in a viewer's frame, whose azimuth has this cosine and sine.
fn direction([cos, sin]: [f64; 2], y: f64, phi: f64) -> Vec3 {
    let h = (1.0 - y * y).sqrt();
    let x = h * phi.sin();
    [x * cos - y * sin, x * sin + y * cos, h * phi.cos()]
}

fn azimuth(wo: Vec3) -> [f64; 2] {
    let length = wo[0].hypot(wo[1]);
    if length > 0.0 { [wo[0] / length, wo[1] / length] } else { [1.0, 0.0] }
}

fn bin_of([cos, sin]: [f64; 2], wi: Vec3) -> usize {
    let [x, y] = [wi[0] * cos + wi[1] * sin, wi[1] * cos - wi[0] * sin];
    let place = |share: f64, bins: usize| ((share * bins as f64) as usize).min(bins - 1);
    place(0.5 * (y + 1.0), BINS[0]) * BINS[1] + place(x.atan2(wi[2]) / PI + 0.5, BINS[1])
}

/// Integrals per bin of a density on the GPU, at one random point of every part of a bin.
fn shares(gpu: &Gpu, tables: &GpuTables, wo: Vec3) -> Vec<f64> {
    let mut random = fastrand::Rng::with_seed(11);
    let (mut queries, mut weights) = (Vec::new(), Vec::new());
    for bin in 0..BINS[0] * BINS[1] {
        let at = |[row, column]: [f64; 2]| {
            let y = -1.0 + 2.0 * ((bin / BINS[1]) as f64 + row) / BINS[0] as f64;
            let phi = PI * (((bin % BINS[1]) as f64 + column) / BINS[1] as f64 - 0.5);
            direction(azimuth(wo), y, phi)
        };
        let middle = at([0.5, 0.5]);
        let points = if (middle[0] + wo[0]).hypot(middle[1] + wo[1]) < LOBE_REACH { POINTS[1] } else { POINTS[0] };
        for n in 0..points * points {
            let part = [n / points, n % points].map(|part| (part as f64 + random.f64()) / points as f64);
            queries.push(query(wo, at(part)));
            weights.push((bin, TAU / (BINS[0] * BINS[1] * points * points) as f64));
        }
    }
    let mut shares = vec![0.0; BINS[0] * BINS[1]];
    for (density, (bin, area)) in eval_densities(gpu, tables, &queries).unwrap().into_iter().zip(weights) {
        shares[bin] += f64::from(density) * area;
    }
    shares
}

/// Probability of a chi-square value as large as that of counts against expected shares (Wilson and Hilferty 1931); bins
/// that expect fewer than five are put together.
fn chi_square_probability(counts: &[f64], shares: &[f64], samples: usize) -> f64 {
    let (mut value, mut bins, mut pooled) = (0.0, 0usize, [0.0; 2]);
    for (count, share) in counts.iter().zip(shares) {
        let expected = share * samples as f64;
        if expected >= 5.0 {
            value += (count - expected).powi(2) / expected;
            bins += 1;
        } else {
            pooled = [pooled[0] + count, pooled[1] + expected];
        }
    }
    if pooled[1] > 0.0 {
        value += (pooled[0] - pooled[1]).powi(2) / pooled[1];
        bins += 1;
    }
    let freedom = (bins - 1) as f64;
    let spread = 2.0 / (9.0 * freedom);
    let z = ((value / freedom).cbrt() - (1.0 - spread)) / spread.sqrt();
    0.5 * libm::erfc(z / 2f64.sqrt())
}

#[test]
fn directions_are_drawn_from_the_density() {
    let Some(gpu) = gpu("drawn directions") else { return };
    for (name, set) in sets() {
        let image = ShaderSampler::new(set).image();
        let tables = upload_sampled(gpu, &promised_image(set, None).unwrap(), &image).unwrap();
        for (angle, wo) in viewers() {
            let shares = shares(gpu, &tables, wo);
            let mut random = fastrand::Rng::with_seed(5);
            let queries: Vec<SampledQuery> = (0..SAMPLES).map(|_| query(wo, random_triple(&mut random))).collect();
            let (mut counts, mut lost) = (vec![0.0; shares.len()], 0);
            for drawn in draw_samples(gpu, &tables, &queries).unwrap() {
                let wi = [drawn[0], drawn[1], drawn[2]].map(f64::from);
                if drawn[3] > 0.0 {
                    assert!((wi[0].hypot(wi[1]).hypot(wi[2]) - 1.0).abs() < 1e-6 && wi[2] > 0.0, "{wi:?}");
                    counts[bin_of(azimuth(wo), wi)] += 1.0;
                } else {
                    lost += 1;
                }
            }
            let total: f64 = shares.iter().sum();
            let probability = chi_square_probability(&counts, &shares, SAMPLES);
            println!("{name}, {angle} degrees: density {total:.4}, probability {probability:.3}, lost {lost}");
            assert!((total - 1.0).abs() < 0.01, "{name}, {angle} degrees: the density integrates to {total}");
            assert!(probability > SIGNIFICANCE, "{name}, {angle} degrees: chi-square of probability {probability:e}");
            assert!(lost <= SAMPLES / 500, "{name}, {angle} degrees: {lost} samples were lost");
            // Of two bins side by side one a sixth more, the other a sixth less.
            let wrong = |n: usize| shares[n] * if (n + n / BINS[1]).is_multiple_of(2) { 1.17 } else { 0.83 };
            let tilted: Vec<f64> = (0..shares.len()).map(wrong).collect();
            let scale: f64 = tilted.iter().sum();
            let tilted: Vec<f64> = tilted.iter().map(|share| share / scale).collect();
            let probability = chi_square_probability(&counts, &tilted, SAMPLES);
            assert!(probability < 0.1 * SIGNIFICANCE, "{name}, {angle} degrees: a tilt goes unseen: {probability:e}");
        }
    }
}

#[test]
fn nothing_is_drawn_from_below_the_surface() {
    let Some(gpu) = gpu("viewers below the surface") else { return };
    let set = full_set();
    let tables = upload_sampled(gpu, &promised_image(set, None).unwrap(), &ShaderSampler::new(set).image()).unwrap();
    let below = [query([0.6, 0.0, -0.8], [0.3, 0.4, 0.5]), query([1.0, 0.0, 0.0], [0.9, 0.4, 0.5])];
    assert!(draw_samples(gpu, &tables, &below).unwrap().iter().all(|drawn| *drawn == [0.0; 4]));
    let pairs = [query([0.6, 0.0, -0.8], [0.0, 0.0, 1.0]), query([0.0, 0.0, 1.0], [0.6, 0.0, -0.8])];
    assert_eq!(eval_densities(gpu, &tables, &pairs).unwrap(), [0.0, 0.0]);
}

/// The table in docs/engines.md: deviation of Y's weight in albedos, by cells as fine as the texels and by those of shaders; bytes; time of a
/// sample.
#[test]
#[ignore = "measures: wants ATLAS, an atlas's folder"]
fn measuring_weights_of_coarse_cells() {
    let Some(folder) = std::env::var_os("ATLAS") else { return skipped(format_args!("weights: ATLAS is not set")) };
    let atlas = Atlas::open(folder).unwrap();
    for specimen in atlas.specimens() {
        let brdf = atlas.brdf(&specimen.name).unwrap();
        let sampler = ShaderSampler::new(brdf.tables());
        let image = sampler.image();
        print!("{}: {CELLS_MAX} cells, {} kB;", specimen.name, 4 * image.texels.len() / 1000);
        for (angle, wo) in viewers().take(4) {
            let mut random = fastrand::Rng::with_seed(3);
            let mut sums = [[0.0; 2]; 2];
            for _ in 0..20_000 {
                let u = random_triple(&mut random);
                let fine = brdf.sample(wo, u).map_or(0.0, |sample| sample.weight[1]);
                let coarse = sampler.sample(wo, u).map_or(0.0, |wi| brdf.eval(wi, wo)[1] * wi[2] / sampler.pdf(wi, wo));
                for (sum, weight) in sums.iter_mut().zip([fine, coarse]) {
                    *sum = [sum[0] + weight / 20_000.0, sum[1] + weight * weight / 20_000.0];
                }
            }
            let [fine, coarse] = sums.map(|[mean, square]| (square / (mean * mean) - 1.0).sqrt());
            print!(" {angle}: {fine:.2} {coarse:.2};");
        }
        println!();
    }
    let Some(gpu) = gpu("time of a sample") else { return };
    let set = snake().brdf.tables();
    let tables = upload_sampled(gpu, &promised_image(set, None).unwrap(), &ShaderSampler::new(set).image()).unwrap();
    for (angle, wo) in viewers() {
        let mut random = fastrand::Rng::with_seed(5);
        let queries: Vec<SampledQuery> = (0..100_000).map(|_| query(wo, random_triple(&mut random))).collect();
        let clock = std::time::Instant::now();
        draw_samples(gpu, &tables, &queries).unwrap();
        println!("{angle} degrees: {:.2} us a sample", clock.elapsed().as_secs_f64() * 10.0);
    }
}
