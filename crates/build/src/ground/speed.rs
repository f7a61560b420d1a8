//! How fast this machine is beside the one that forecasts' constants are from.

use std::time::{Duration, Instant};

use ndarray::Array2;
use rayon::prelude::*;
use rustfft::num_complex::Complex;

use super::fft::fft2;

/// Side of the transforms that are timed: some hundred kilobytes, as the lines of a window.
const SIDE: usize = 128;

/// Nanoseconds of a point of them, both ways, on the machine of `tables::forecast`: a third of what large ones take, which do not fit into a
/// cache. Taken from another machine, where tables took 1.5 times the forecast and these 6 ns.
const NS_PER_POINT: f64 = 4.0;

/// How long is measured: past some slices of a scheduler, so that what others take of the machine counts.
const TIMED: Duration = Duration::from_millis(100);

/// How many times as long the same work takes here and now, with all threads at it. What else the machine does counts too, so it is
/// another figure each time: it predicts, and decides nothing.
pub fn slowdown() -> f64 {
    let threads = rayon::current_num_threads();
    let start = Instant::now();
    // Each thread by itself, as specimens are made.
    let rounds: usize = (0..threads).into_par_iter().with_max_len(1).map(|_| rounds(start)).sum();
    let elapsed_ns = start.elapsed().as_nanos() as f64;
    let nominal_ns = rounds as f64 * (SIDE * SIDE) as f64 * NS_PER_POINT / threads as f64;
    elapsed_ns / nominal_ns
}

/// Transforms done until the time is up; one at least.
fn rounds(start: Instant) -> usize {
    let mut field = Array2::from_shape_fn((SIDE, SIDE), |(j, i)| Complex::new(j as f64, i as f64));
    let scale = 1.0 / SIDE as f64;
    let mut count = 0;
    loop {
        fft2(&mut field);
        field.mapv_inplace(|value| value * scale);
        count += 1;
        if start.elapsed() >= TIMED {
            return std::hint::black_box(count);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::slowdown;

    #[test]
    fn a_machine_has_a_speed_within_reason() {
        let found = slowdown();
        assert!((0.05..200.0).contains(&found), "{found}");
    }
}
