//! Missing samples: filled by the smoothest surface through their surroundings.
//!
//! The filled heights solve Laplace's equation with the known neighbours as boundary values (nothing
//! flows through the scan's edge). Conjugate gradients solve it, starting from averages over ever
//! coarser cells; all sums run in one fixed order, so the result is the same everywhere.

/// Iterations allowed. They grow with the width of the widest gap, in samples; with the coarse start
/// this serves gaps of well over a thousand.
const ITERATIONS_MAX: usize = 4000;
/// Iterations times missing samples allowed: about half a minute of one core.
const WORK_MAX: usize = 2_000_000_000;
/// The residual is reduced to this share of the known heights' rms.
const RELATIVE_RESIDUAL: f64 = 1e-9;

/// Replaces every NaN of a field of `size` by a smooth interpolation; `false` if it had to stop before
/// the solution was reached. The field must have a known sample, and `pitch` be positive.
pub(crate) fn fill(heights: &mut [f64], size: [usize; 2], pitch: [f64; 2]) -> bool {
    let missing: Vec<usize> = (0..heights.len()).filter(|&index| heights[index].is_nan()).collect();
    if missing.is_empty() || missing.len() == heights.len() {
        return missing.is_empty();
    }
    // Differences from the mean: the residual then scales with the relief, not with the altitude.
    let known = heights.len() - missing.len();
    let mean = heights.iter().filter(|height| !height.is_nan()).sum::<f64>() / known as f64;
    for height in heights.iter_mut() {
        *height -= mean;
    }
    let mean_square = {
        let known = heights.iter().filter(|height| !height.is_nan());
        known.map(|height| height * height).sum::<f64>() / (heights.len() - missing.len()) as f64
    };
    let goal = mean_square * missing.len() as f64 * RELATIVE_RESIDUAL.powi(2);
    let laplace = Laplace::new(&missing, heights, size, pitch);
    start(heights, size);
    let mut unknowns: Vec<f64> = missing.iter().map(|&index| heights[index]).collect();
    unknowns.push(0.0);
    let finished = laplace.solve(&mut unknowns, goal);
    for (&index, &height) in missing.iter().zip(&unknowns) {
        heights[index] = height;
    }
    for height in heights.iter_mut() {
        *height += mean;
    }
    finished
}

/// First guess: the mean of the finest cell (2, 4, 8, ... samples wide) that knows anything.
fn start(heights: &mut [f64], size: [usize; 2]) {
    let at = |size: [usize; 2], x: usize, y: usize| y * size[0] + x;
    let known = |&height: &f64| {
        if height.is_nan() { [0.0, 0.0] } else { [height, 1.0] }
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

/// The five-point Laplacian over the missing samples, numbered in the order of `missing`.
struct Laplace {
    /// Numbers of the left, right, upper and lower neighbour; one beyond the last number for a
    /// neighbour that is known or outside.
    neighbours: Vec<[usize; 4]>,
    /// Sum of the weights of all neighbours inside the field.
    degree: Vec<f64>,
    /// Sum of the known neighbours' heights by their weights.
    source: Vec<f64>,
    /// Inverse squared pitches along x and y, the larger one being 1.
    weights: [f64; 2],
}

impl Laplace {
    fn new(missing: &[usize], heights: &[f64], size: [usize; 2], pitch: [f64; 2]) -> Self {
        let finest = pitch[0].min(pitch[1]);
        let weights = pitch.map(|pitch| (finest / pitch).powi(2));
        let [nx, ny] = size;
        let none = missing.len();
        let mut laplace =
            Self { neighbours: vec![[none; 4]; none], degree: vec![0.0; none], source: vec![0.0; none], weights };
        for (number, &index) in missing.iter().enumerate() {
            let (x, y) = (index % nx, index / nx);
            let around = [
                (x > 0).then(|| index - 1),
                (x + 1 < nx).then(|| index + 1),
                (y > 0).then(|| index - nx),
                (y + 1 < ny).then(|| index + nx),
            ];
            for (side, neighbour) in around.into_iter().enumerate() {
                let Some(neighbour) = neighbour else { continue };
                let weight = weights[side / 2];
                laplace.degree[number] += weight;
                match missing.binary_search(&neighbour) {
                    Ok(other) => laplace.neighbours[number][side] = other,
                    Err(_) => laplace.source[number] += weight * heights[neighbour],
                }
            }
        }
        laplace
    }

    /// The Laplacian of `field`, whose extra last value stands for every known sample and is 0.
    fn apply(&self, field: &[f64], image: &mut [f64]) {
        for (number, value) in image.iter_mut().enumerate() {
            let [left, right, up, down] = self.neighbours[number];
            *value = self.degree[number] * field[number]
                - self.weights[0] * (field[left] + field[right])
                - self.weights[1] * (field[up] + field[down]);
        }
    }

    /// Conjugate gradients from the guess in `field`, which has one value more than there are
    /// unknowns, 0; `false` if the residual stayed above `goal`, both as sums of squares.
    fn solve(&self, field: &mut [f64], goal: f64) -> bool {
        let count = self.degree.len();
        let squares = |values: &[f64]| values.iter().map(|value| value * value).sum::<f64>();
        let mut image = vec![0.0; count];
        self.apply(field, &mut image);
        let mut residual: Vec<f64> = self.source.iter().zip(&image).map(|(b, a)| b - a).collect();
        let mut direction = residual.clone();
        direction.push(0.0);
        let mut size = squares(&residual);
        for _ in 0..ITERATIONS_MAX.min(WORK_MAX / count) {
            if size <= goal {
                return true;
            }
            self.apply(&direction, &mut image);
            let curvature: f64 = direction.iter().zip(&image).map(|(d, a)| d * a).sum();
            let step = size / curvature;
            for number in 0..count {
                field[number] += step * direction[number];
                residual[number] -= step * image[number];
            }
            let next = squares(&residual);
            let share = next / size;
            for number in 0..count {
                direction[number] = residual[number] + share * direction[number];
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
    fn error_of(height: impl Fn(f64, f64) -> f64, gap: impl Fn(usize, usize) -> bool, pitch: [f64; 2]) -> f64 {
        let [nx, ny] = [61, 47];
        let truth: Vec<f64> =
            (0..nx * ny).map(|i| height((i % nx) as f64 * pitch[0], (i / nx) as f64 * pitch[1])).collect();
        let mut holed = truth.clone();
        for (index, value) in holed.iter_mut().enumerate() {
            if gap(index % nx, index / nx) {
                *value = f64::NAN;
            }
        }
        assert!(holed.iter().any(|value| value.is_nan()));
        assert!(fill(&mut holed, [nx, ny], pitch));
        holed.iter().zip(&truth).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    }

    /// Planes and `x² - y²` solve the discrete equation exactly, so they must come back. The residual
    /// is 1e-9 of an rms around 1000; a gap of 30 samples can amplify it by about 30² / 8.
    #[test]
    fn harmonic_surfaces_are_restored() {
        let disc = |x: usize, y: usize| {
            let (dx, dy) = (x as f64 - 30.0, y as f64 - 22.0);
            dx * dx + dy * dy < 225.0
        };
        let plane = |x: f64, y: f64| 700.0 + 3.0 * x - 2.0 * y;
        let saddle = |x: f64, y: f64| x * x - y * y;
        let specks =
            |x: usize, y: usize| (x * 7 + y * 13).is_multiple_of(11) && (1..60).contains(&x) && (1..46).contains(&y);
        for pitch in [[1.0, 1.0], [1.0, 2.5]] {
            assert!(error_of(plane, disc, pitch) < 2e-4);
            assert!(error_of(saddle, disc, pitch) < 2e-4);
            assert!(error_of(plane, specks, pitch) < 2e-4);
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
        assert!(field.iter().all(|value| (-1e-6..=99.0 + 1e-6).contains(value)));
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
