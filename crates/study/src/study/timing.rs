//! How long one direction takes in a batch: the best of several passes, because other work only adds time.

use std::time::Instant;

use super::batch::{Batch, Pair, on_all_threads};
use diffraction_brdf::error::{Error, Result};

/// Fewest seconds of a pass whose time is taken, where there are directions enough.
const PASS_S: f64 = 0.02;

/// Passes of that length.
const PASSES: usize = 5;

/// First number of directions tried.
const FIRST: usize = 16;

/// Threads on which evaluation is timed.
#[derive(Debug)]
pub struct Clock {
    one: rayon::ThreadPool,
}

impl Clock {
    /// Makes a pool of one thread, so that methods that work in parallel inside are held to it too.
    ///
    /// # Errors
    /// `Error::Call` if the system gives no thread.
    pub fn new() -> Result<Self> {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build();
        Ok(Self { one: pool.map_err(|error| Error::Call(format!("no thread to time on: {error}")))? })
    }

    /// Seconds per direction on one thread.
    pub(crate) fn on_one_thread(&self, batch: Batch, pairs: &[Pair]) -> f64 {
        self.one.install(|| best_per_direction(batch, pairs))
    }

    /// Wall seconds per direction with all threads at work.
    pub(crate) fn on_all_threads(&self, batch: Batch, pairs: &[Pair]) -> f64 {
        best_per_direction(batch, pairs)
    }
}

fn best_per_direction(batch: Batch, pairs: &[Pair]) -> f64 {
    let pass = |count: usize| {
        let started = Instant::now();
        std::hint::black_box(on_all_threads(batch, &pairs[..count]));
        started.elapsed().as_secs_f64()
    };
    let mut count = FIRST.min(pairs.len());
    let mut best = pass(count);
    while best < PASS_S && count < pairs.len() {
        count = (count * 4).min(pairs.len());
        best = pass(count);
    }
    for _ in 1..PASSES {
        best = best.min(pass(count));
    }
    best / count.max(1) as f64
}

#[cfg(test)]
mod tests {
    use super::*;
    use diffraction_brdf::direction::Xyz;
    use diffraction_build::ground::sampling::{Region, direction_pairs};

    #[test]
    fn a_known_wait_is_measured() {
        let pairs = direction_pairs(Region::Hemisphere, 40);
        let wait = std::time::Duration::from_micros(200);
        let batch = |pairs: &[Pair], _: &mut [Xyz]| pairs.iter().for_each(|_| std::thread::sleep(wait));
        let found = Clock::new().unwrap().on_one_thread(&batch, &pairs);
        // A sleep is never shorter than asked for; a busy machine makes it longer.
        assert!((2e-4..5e-3).contains(&found), "{found}");
    }
}
