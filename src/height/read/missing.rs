//! Missing samples: filled by the smoothest surface through their surroundings.
//!
//! The filled heights solve Laplace's equation with the known neighbours as boundary values (nothing
//! flows through the scan's edge). Conjugate gradients solve it, starting from averages over ever
//! coarser cells; all sums run in one fixed order, so the result is the same everywhere.

/// Iterations allowed. They grow with the width of the widest gap, in samples; with the coarse start
/// this serves gaps of well over a thousand.
const ITERATIONS_MAX: usize = 4000;
/// The residual is reduced to this share of the known heights' size.
const RELATIVE_RESIDUAL: f64 = 1e-10;

/// Replaces every NaN of a field of `size` by a smooth interpolation; `false` if it had to stop before
/// the solution was reached. The field must have a known sample, and `pitch` be positive.
pub(super) fn fill(heights: &mut [f64], size: [usize; 2], pitch: [f64; 2]) -> bool {
    let missing: Vec<usize> = (0..heights.len())
        .filter(|&index| heights[index].is_nan())
        .collect();
    if missing.is_empty() || missing.len() == heights.len() {
        return missing.is_empty();
    }
    // Differences from the mean: the residual then scales with the relief, not with the altitude.
    let known = heights.len() - missing.len();
    let mean = heights
        .iter()
        .filter(|height| !height.is_nan())
        .sum::<f64>()
        / known as f64;
    for height in heights.iter_mut() {
        *height -= mean;
    }
    start(heights, size);
    let finished = Laplace::new(&missing, size, pitch).solve(heights);
    for height in heights.iter_mut() {
        *height += mean;
    }
    finished
}

/// First guess: the mean of the finest cell (2, 4, 8, ... samples wide) that knows anything.
fn start(heights: &mut [f64], size: [usize; 2]) {
    let at = |size: [usize; 2], x: usize, y: usize| y * size[0] + x;
    let known = |&height: &f64| {
        if height.is_nan() {
            [0.0, 0.0]
        } else {
            [height, 1.0]
        }
    };
    // Sums and counts of known heights, ever coarser.
    let mut levels = vec![(heights.iter().map(known).collect::<Vec<_>>(), size)];
    let mut coarsest = size;
    while coarsest != [1, 1] {
        let (fine, fine_size) = &levels[levels.len() - 1];
        coarsest = fine_size.map(|side| side.div_ceil(2));
        let mut coarse = vec![[0.0; 2]; coarsest[0] * coarsest[1]];
        for y in 0..fine_size[1] {
            for x in 0..fine_size[0] {
                let [sum, count] = fine[at(*fine_size, x, y)];
                let cell = &mut coarse[at(coarsest, x / 2, y / 2)];
                cell[0] += sum;
                cell[1] += count;
            }
        }
        levels.push((coarse, coarsest));
    }
    for y in 0..size[1] {
        for x in 0..size[0] {
            let height = &mut heights[at(size, x, y)];
            if !height.is_nan() {
                continue;
            }
            let mut cell = [x, y];
            for (sums, level_size) in &levels[1..] {
                cell = cell.map(|position| position / 2);
                let [sum, count] = sums[at(*level_size, cell[0], cell[1])];
                if count > 0.0 {
                    *height = sum / count;
                    break;
                }
            }
        }
    }
}

/// The five-point Laplacian over the missing samples.
struct Laplace<'m> {
    missing: &'m [usize],
    size: [usize; 2],
    /// Inverse squared pitches, the larger one being 1.
    weights: [f64; 2],
}

impl<'m> Laplace<'m> {
    fn new(missing: &'m [usize], size: [usize; 2], pitch: [f64; 2]) -> Self {
        let finest = pitch[0].min(pitch[1]);
        Self {
            missing,
            size,
            weights: pitch.map(|pitch| (finest / pitch).powi(2)),
        }
    }

    /// `Σ weight (field[i] - field[neighbour])` at a sample.
    fn at(&self, field: &[f64], index: usize) -> f64 {
        let [nx, ny] = self.size;
        let (x, y) = (index % nx, index / nx);
        let centre = field[index];
        let mut sum = 0.0;
        if x > 0 {
            sum += self.weights[0] * (centre - field[index - 1]);
        }
        if x + 1 < nx {
            sum += self.weights[0] * (centre - field[index + 1]);
        }
        if y > 0 {
            sum += self.weights[1] * (centre - field[index - nx]);
        }
        if y + 1 < ny {
            sum += self.weights[1] * (centre - field[index + nx]);
        }
        sum
    }

    /// Conjugate gradients on the missing samples of `field`; `false` if the residual stayed too large.
    fn solve(&self, field: &mut [f64]) -> bool {
        let squares = |values: &[f64]| values.iter().map(|value| value * value).sum::<f64>();
        let scale = squares(field) / field.len() as f64 * self.missing.len() as f64;
        let goal = scale * RELATIVE_RESIDUAL * RELATIVE_RESIDUAL;
        let mut residual: Vec<f64> = self.missing.iter().map(|&i| -self.at(field, i)).collect();
        let mut size = squares(&residual);
        // Zero at known samples throughout, so that the Laplacian of it is that of the unknowns.
        let mut direction = vec![0.0; field.len()];
        for (&index, &value) in self.missing.iter().zip(&residual) {
            direction[index] = value;
        }
        for _ in 0..ITERATIONS_MAX {
            if size <= goal {
                return true;
            }
            let image: Vec<f64> = self
                .missing
                .iter()
                .map(|&i| self.at(&direction, i))
                .collect();
            let curvature: f64 = self
                .missing
                .iter()
                .zip(&image)
                .map(|(&index, value)| direction[index] * value)
                .sum();
            let step = size / curvature;
            for (k, &index) in self.missing.iter().enumerate() {
                field[index] += step * direction[index];
                residual[k] -= step * image[k];
            }
            let next = squares(&residual);
            let share = next / size;
            for (k, &index) in self.missing.iter().enumerate() {
                direction[index] = residual[k] + share * direction[index];
            }
            size = next;
        }
        size <= goal
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Fills a gap cut out of `height(x, y)` and returns the largest error.
    fn error_of(
        height: impl Fn(f64, f64) -> f64,
        gap: impl Fn(usize, usize) -> bool,
        pitch: [f64; 2],
    ) -> f64 {
        let [nx, ny] = [61, 47];
        let truth: Vec<f64> = (0..nx * ny)
            .map(|i| height((i % nx) as f64 * pitch[0], (i / nx) as f64 * pitch[1]))
            .collect();
        let mut holed = truth.clone();
        for (index, value) in holed.iter_mut().enumerate() {
            if gap(index % nx, index / nx) {
                *value = f64::NAN;
            }
        }
        assert!(holed.iter().any(|value| value.is_nan()));
        assert!(fill(&mut holed, [nx, ny], pitch));
        holed
            .iter()
            .zip(&truth)
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f64::max)
    }

    /// Planes and `x² - y²` solve the discrete equation exactly, so they must come back. The residual
    /// is 1e-10 of heights around 1000; a gap of 30 samples can amplify it by about 30² / 8.
    #[test]
    fn harmonic_surfaces_are_restored() {
        let disc = |x: usize, y: usize| {
            let (dx, dy) = (x as f64 - 30.0, y as f64 - 22.0);
            dx * dx + dy * dy < 225.0
        };
        let plane = |x: f64, y: f64| 700.0 + 3.0 * x - 2.0 * y;
        let saddle = |x: f64, y: f64| x * x - y * y;
        let specks = |x: usize, y: usize| (x * 7 + y * 13) % 11 == 0 && x % 60 > 0 && y % 46 > 0;
        for pitch in [[1.0, 1.0], [1.0, 2.5]] {
            assert!(error_of(plane, disc, pitch) < 1e-4);
            assert!(error_of(saddle, disc, pitch) < 1e-4);
            assert!(error_of(plane, specks, pitch) < 1e-4);
        }
        // The comparison can fail: a bump is not harmonic.
        let bump = |x: f64, y: f64| x * x + y * y;
        assert!(error_of(bump, disc, [1.0, 1.0]) > 50.0);
    }

    #[test]
    fn filled_values_stay_between_their_surroundings() {
        let mut field: Vec<f64> = (0..400).map(|i| f64::from((i * 37) % 100)).collect();
        for value in &mut field[150..330] {
            *value = f64::NAN;
        }
        assert!(fill(&mut field, [20, 20], [1.0, 3.0]));
        assert!(
            field
                .iter()
                .all(|value| (-1e-6..=99.0 + 1e-6).contains(value))
        );
    }

    #[test]
    fn constant_surroundings_fill_with_the_constant() {
        let mut field = vec![f64::NAN; 64];
        field[5] = 42.0;
        assert!(fill(&mut field, [8, 8], [1.0, 1.0]));
        assert!(field.iter().all(|value| (value - 42.0).abs() < 1e-9));
        let mut nothing = vec![f64::NAN; 4];
        assert!(!fill(&mut nothing, [2, 2], [1.0, 1.0]));
    }
}
