//! Samples, surfaces and lights in the byte layouts that the shaders read.

use bytemuck::{Pod, Zeroable};

use crate::scene::samples::ShadingSamples;

/// Most samples that one invocation sums in 32-bit floats; the sums of these are added in 64 bits.
pub(crate) const RUN_SAMPLES_MAX: usize = 64;
/// Most samples uploaded at once: 8 MiB, and a dispatch short enough for any driver's watchdog.
pub(crate) const CHUNK_SAMPLES_MAX: usize = 1 << 18;

/// `ShadingSample` of check.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct ShadingSample {
    /// To the light.
    pub wi: [f32; 3],
    /// Factor on the BRDF.
    pub weight: f32,
    /// To the viewer.
    pub wo: [f32; 3],
    /// Fills the stride of 32 bytes.
    pub unused: f32,
}

/// `Run` of check.wgsl: neighbouring samples of one pixel.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Eq, Pod, Zeroable)]
pub struct Run {
    /// First sample, counted from the chunk's start.
    pub first: u32,
    /// Number of samples.
    pub count: u32,
}

/// `FrameParams` of frame.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct FrameParams {
    /// Pixels along each side.
    pub size_px: u32,
    /// Entries of the list of lights.
    pub light_count: u32,
    /// Words that hold a pixel's shadows.
    pub lit_words: u32,
    /// Factor that brings XYZ to display values.
    pub exposure: f32,
}

/// `FrameLight` of frame.wgsl.
#[repr(C)]
#[derive(Debug, Clone, Copy, PartialEq, Pod, Zeroable)]
pub struct FrameLight {
    /// Unit vector in the world.
    pub direction: [f32; 3],
    /// Irradiance on a surface that faces it.
    pub irradiance: f32,
    /// Layer of the surfaces that it is shaded on.
    pub layer: u32,
    /// Angular radius in radians of what it stands for; 0 for a point.
    pub angular_radius: f32,
    /// Fills the stride of 32 bytes.
    pub unused: [u32; 2],
}

/// Part of the samples that is shaded by one dispatch.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Chunk {
    /// First sample and one past the last.
    pub samples: std::ops::Range<usize>,
    /// The runs, in order.
    pub runs: Vec<Run>,
    /// The pixel of each run: `row * columns + column`.
    pub pixels: Vec<u32>,
}

/// Cuts samples into runs of at most `run_max` within a pixel and chunks of at most `chunk_max >= run_max`.
pub(crate) fn chunks(samples: &ShadingSamples, run_max: usize, chunk_max: usize) -> Vec<Chunk> {
    let mut out: Vec<Chunk> = Vec::new();
    let pixels = samples.first.windows(2).enumerate();
    for (pixel, range) in pixels {
        let (mut first, end) = (range[0] as usize, range[1] as usize);
        while first < end {
            let count = (end - first).min(run_max);
            if out.last().is_none_or(|chunk| first + count - chunk.samples.start > chunk_max) {
                out.push(Chunk { samples: first..first, runs: Vec::new(), pixels: Vec::new() });
            }
            let last = out.len() - 1;
            let chunk = &mut out[last];
            chunk.runs.push(Run { first: (first - chunk.samples.start) as u32, count: count as u32 });
            chunk.pixels.push(pixel as u32);
            first += count;
            chunk.samples.end = first;
        }
    }
    out
}

/// Samples of a chunk as the shader reads them.
pub(crate) fn packed_samples(samples: &ShadingSamples, chunk: &Chunk) -> Vec<ShadingSample> {
    let range = chunk.samples.clone();
    range
        .map(|i| ShadingSample { wi: samples.wi[i], weight: samples.weight[i], wo: samples.wo[i], unused: 0.0 })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn samples(counts: &[u32]) -> ShadingSamples {
        let mut first = vec![0];
        for count in counts {
            first.push(first[first.len() - 1] + count);
        }
        let total = first[counts.len()] as usize;
        ShadingSamples {
            rows: 1,
            columns: counts.len(),
            first,
            wi: (0..total).map(|i| [i as f32, 0.0, 1.0]).collect(),
            wo: vec![[0.0, 0.0, 1.0]; total],
            weight: vec![1.0; total],
        }
    }

    #[test]
    fn every_sample_lies_in_one_run_of_its_pixel() {
        let samples = samples(&[0, 3, 9, 1, 0, 4, 5]);
        for (run_max, chunk_max) in [(1, 1), (2, 5), (4, 4), (100, 100)] {
            let mut next = 0;
            for chunk in chunks(&samples, run_max, chunk_max) {
                assert_eq!(chunk.samples.start, next);
                assert!(chunk.samples.len() <= chunk_max);
                let packed = packed_samples(&samples, &chunk);
                for (run, pixel) in chunk.runs.iter().zip(&chunk.pixels) {
                    assert!(run.count as usize <= run_max);
                    assert_eq!(packed[run.first as usize].wi[0], next as f32);
                    let pixel = *pixel as usize;
                    assert!((samples.first[pixel] as usize) <= next);
                    next += run.count as usize;
                    assert!(next <= samples.first[pixel + 1] as usize);
                }
                assert_eq!(chunk.samples.end, next);
            }
            assert_eq!(next, 22);
        }
    }
}
