//! A least-squares fit of spherical harmonics to a BRDF: smooth bases cannot hold an order's lobe.

use diffraction_brdf::direction::{Vec3, Xyz, dot, wave_vector_change};
use diffraction_brdf::error::{Error, Result};
use diffraction_build::optics::config::OpticsConfig;

/// Powers of `|q| / 2` that multiply every harmonic: the spread of the incidence angles.
const RADIAL_POWERS: usize = 3;

/// Added to the diagonal of the normal equations, relative to its mean: on a hemisphere the harmonics are
/// nearly dependent.
const RIDGE: f64 = 1e-10;

/// `w² ⟨|P|²⟩/(λ² A w²)` as a sum of real spherical harmonics of the half vector times powers of `|q|`.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct HarmonicFit {
    /// Highest degree of the harmonics.
    pub degree: usize,
    /// Coefficients of X, Y and Z.
    pub coefficients: Vec<Xyz>,
}

/// Fits samples `(q, value)`, the values being what tables hold (see `evaluate::window_power`), in 1/sr.
///
/// # Errors
/// `Error::Call` if there are fewer samples than coefficients, or they leave a coefficient undetermined.
pub fn fit(degree: usize, samples: &[(Vec3, Xyz)]) -> Result<HarmonicFit> {
    let count = (degree + 1).pow(2) * RADIAL_POWERS;
    let undetermined = || {
        Error::Call(format!(
            "{} samples do not determine the {count} coefficients of spherical harmonics of degree {degree}",
            samples.len()
        ))
    };
    if samples.len() < count {
        return Err(undetermined());
    }
    let mut normal = vec![0.0; count * count];
    let mut right = vec![[0.0; 3]; count];
    for (q, value) in samples {
        let basis = basis(degree, *q);
        let w2 = q[2] * q[2];
        for (i, b) in basis.iter().enumerate() {
            right[i].iter_mut().zip(value).for_each(|(sum, value)| *sum += b * w2 * value);
            normal[i * count..i * count + i + 1].iter_mut().zip(&basis).for_each(|(sum, other)| *sum += b * other);
        }
    }
    let ridge = RIDGE * (0..count).map(|i| normal[i * count + i]).sum::<f64>() / count as f64;
    (0..count).for_each(|i| normal[i * count + i] += ridge);
    let coefficients = solve_cholesky(normal, right).ok_or_else(undetermined)?;
    Ok(HarmonicFit { degree, coefficients })
}

impl HarmonicFit {
    /// XYZ of the BRDF in 1/sr. Like every such fit it rings, and may be negative.
    pub fn brdf_xyz(&self, optics: &OpticsConfig, wi: Vec3, wo: Vec3) -> Xyz {
        let front = optics.front_factor().diffuse(wi, wo);
        if front == 0.0 {
            return [0.0; 3];
        }
        let q = wave_vector_change(wi, wo);
        let mut xyz = [0.0; 3];
        for (b, coefficient) in basis(self.degree, q).iter().zip(&self.coefficients) {
            xyz.iter_mut().zip(coefficient).for_each(|(sum, c)| *sum += front * b * c / (q[2] * q[2]));
        }
        xyz
    }
}

/// Values of all basis functions at `q`.
fn basis(degree: usize, q: Vec3) -> Vec<f64> {
    let length = dot(q, q).sqrt();
    let direction = if length > 0.0 { q.map(|x| -x / length) } else { [0.0, 0.0, 1.0] };
    let harmonics = real_harmonics(degree, direction);
    (0..RADIAL_POWERS).flat_map(|j| harmonics.iter().map(move |y| y * (0.5 * length).powi(j as i32))).collect()
}

/// Real orthonormal spherical harmonics up to a degree, ordered by `l² + l + m`.
pub(crate) fn real_harmonics(degree: usize, [x, y, z]: Vec3) -> Vec<f64> {
    let mut values = vec![0.0; (degree + 1).pow(2)];
    // Re and Im of (x + iy)^m stand for sin^m θ cos mφ and sin^m θ sin mφ: no pole trouble.
    let (mut re, mut im, mut sectoral) = (1.0, 0.0, (0.25 / std::f64::consts::PI).sqrt());
    for m in 0..=degree {
        let (mut before, mut here) = (0.0, sectoral);
        for l in m..=degree {
            let scale = if m == 0 { 1.0 } else { std::f64::consts::SQRT_2 };
            values[l * l + l + m] = scale * here * re;
            if m > 0 {
                values[l * l + l - m] = scale * here * im;
            }
            // Normalised recurrence in l: P_{l+1} = a (z P_l - b P_{l-1}).
            let (next, m2) = ((l + 1) as f64, (m * m) as f64);
            let a = ((4.0 * next * next - 1.0) / (next * next - m2)).sqrt();
            let b = (((l * l) as f64 - m2) / (4.0 * (l * l) as f64 - 1.0)).max(0.0).sqrt();
            (before, here) = (here, a * (z * here - b * before));
        }
        (re, im) = (re * x - im * y, re * y + im * x);
        sectoral *= ((2 * m + 3) as f64 / (2 * m + 2) as f64).sqrt();
    }
    values
}

/// Solves `L L^T x = right` for a matrix given by its lower triangle, row-major.
fn solve_cholesky(mut matrix: Vec<f64>, mut right: Vec<Xyz>) -> Option<Vec<Xyz>> {
    let n = right.len();
    for i in 0..n {
        for j in 0..=i {
            let sum: f64 = (0..j).map(|k| matrix[i * n + k] * matrix[j * n + k]).sum();
            let rest = matrix[i * n + j] - sum;
            if i == j {
                if rest.is_nan() || rest <= 0.0 {
                    return None;
                }
                matrix[i * n + i] = rest.sqrt();
            } else {
                matrix[i * n + j] = rest / matrix[j * n + j];
            }
        }
    }
    for i in 0..n {
        let (done, rest) = right.split_at_mut(i);
        eliminate(&mut rest[0], done, |k| matrix[i * n + k], matrix[i * n + i]);
    }
    for i in (0..n).rev() {
        let (rest, done) = right.split_at_mut(i + 1);
        eliminate(&mut rest[i], done, |k| matrix[(i + 1 + k) * n + i], matrix[i * n + i]);
    }
    Some(right)
}

/// `value = (value - Σ factor(k) done[k]) / pivot`.
fn eliminate(value: &mut Xyz, done: &[Xyz], factor: impl Fn(usize) -> f64, pivot: f64) {
    for (k, other) in done.iter().enumerate() {
        value.iter_mut().zip(other).for_each(|(value, other)| *value -= factor(k) * other);
    }
    *value = value.map(|v| v / pivot);
}

#[cfg(test)]
mod tests {
    use super::*;
    use diffraction_build::ground::sampling;

    fn directions(count: usize) -> Vec<Vec3> {
        (0..count)
            .map(|index| {
                let [a, b] = sampling::plane(index);
                let (z, phi) = (2.0 * a - 1.0, std::f64::consts::TAU * b);
                let r = (1.0 - z * z).sqrt();
                [r * phi.cos(), r * phi.sin(), z]
            })
            .collect()
    }

    #[test]
    fn harmonics_are_orthonormal() {
        let degree = 5;
        let all: Vec<_> = directions(40_000).iter().map(|d| real_harmonics(degree, *d)).collect();
        for i in 0..36 {
            for j in 0..=i {
                let mean: f64 = all.iter().map(|y| y[i] * y[j]).sum::<f64>() / all.len() as f64;
                let inner = 4.0 * std::f64::consts::PI * mean;
                // Quasi-random points err by about log(n)²/n times the variation: a few 1e-3.
                assert!((inner - f64::from(u8::from(i == j))).abs() < 5e-3, "{i} {j} {inner}");
            }
        }
    }

    #[test]
    fn a_function_of_the_space_is_fitted_exactly_and_others_are_not() {
        let samples = |f: &dyn Fn(Vec3) -> f64| -> Vec<(Vec3, Xyz)> {
            let upper = directions(2_000).into_iter().filter(|d| d[2] > 0.05);
            upper
                .enumerate()
                .map(|(i, d)| {
                    let q = d.map(|x| -x * (0.4 + 1.5 * sampling::plane(i)[1]));
                    (q, [f(q) / (q[2] * q[2]); 3])
                })
                .collect()
        };
        let inside = |q: Vec3| 0.3 + (0.2 * q[0] * q[1] - 0.1 * q[2] * q[2]) * 0.25;
        let outside = |q: Vec3| (-40.0 * (q[0] * q[0] + q[1] * q[1])).exp();
        let residual = |f: &dyn Fn(Vec3) -> f64| {
            let samples = samples(f);
            let fitted = fit(4, &samples).unwrap();
            let worst = samples.iter().map(|(q, value)| {
                let sum: f64 = basis(4, *q).iter().zip(&fitted.coefficients).map(|(b, c)| b * c[1]).sum();
                (sum - q[2] * q[2] * value[1]).abs()
            });
            worst.fold(0.0, f64::max)
        };
        // The ridge moves coefficients along weak directions by about its square root.
        assert!(residual(&inside) < 1e-4, "{}", residual(&inside));
        assert!(residual(&outside) > 1e-2);
        assert!(fit(8, &samples(&inside)[..100]).is_err());
    }
}
