//! A GPU on a thread of its own: a driver that hangs ends a stage with an error, not the run.

use std::time::Duration;

use diffraction_render::render::gpu::{Gpu, GpuInfo};
use diffraction_render::render::gpu_thread::OwningThread;

/// Longest wait for the GPU, over one specimen.
const TIME_LIMIT: Duration = Duration::from_secs(300);

/// An open GPU.
#[derive(Debug)]
pub struct GpuDevice {
    thread: OwningThread<Gpu>,
    info: GpuInfo,
}

impl GpuDevice {
    /// Takes over an open GPU.
    pub fn new(gpu: Gpu) -> Self {
        let info = gpu.info().clone();
        Self { thread: OwningThread::new(gpu), info }
    }

    /// Adapter, driver, limits and features.
    pub fn info(&self) -> &GpuInfo {
        &self.info
    }

    /// The thread, for one more stage's worth of waiting.
    pub fn thread(&self) -> &OwningThread<Gpu> {
        self.thread.allow(TIME_LIMIT);
        &self.thread
    }
}
