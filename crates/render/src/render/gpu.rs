//! A GPU without a window: opening it, waiting with a time limit, reading back, and turning every failure into an error.

use std::future::Future;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::pin::pin;
use std::sync::{Arc, Mutex, mpsc};
use std::task::{Context, Poll, Waker};
use std::time::{Duration, Instant};

use serde::{Deserialize, Serialize};

use crate::error::{Error, Result};

/// Longest wait for one submission, and for opening the device.
pub const TIME_LIMIT: Duration = Duration::from_secs(120);

/// What is reported about a GPU.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct GpuInfo {
    /// The adapter's name.
    pub adapter: String,
    /// vulkan, metal or dx12.
    pub backend: String,
    /// The driver's name and version.
    pub driver: String,
    /// Discrete, integrated, virtual, or cpu for software.
    pub kind: String,
    /// PCI identifiers of vendor and device.
    pub vendor_device: [u32; 2],
    /// Whether frame times come from the GPU's own clock.
    pub timestamps: bool,
    /// The adapter's largest texture side; the program keeps to WebGPU's 8192.
    pub texture_side_max: u32,
    /// The adapter's most texture layers; the program keeps to WebGPU's 256.
    pub texture_layers_max: u32,
    /// The adapter's largest storage binding in bytes; the program keeps to 8 MiB.
    pub storage_binding_max_bytes: u64,
    /// The features the adapter offers, in wgpu's words.
    pub features: Vec<String>,
}

impl GpuInfo {
    /// Whether the processor does the work: its times say little, and large pictures take long.
    pub fn is_software(&self) -> bool {
        self.kind == "cpu"
    }
}

/// An opened GPU.
#[derive(Debug)]
pub struct Gpu {
    pub(super) device: wgpu::Device,
    pub(super) queue: wgpu::Queue,
    info: GpuInfo,
    /// The first failure that no call was there to receive: device loss above all.
    failure: Arc<Mutex<Option<String>>>,
}

impl Gpu {
    /// Opens the fastest adapter; `None` where there is none. A software adapter counts.
    ///
    /// # Errors
    /// `Error::Gpu` if an adapter is there and fails, or does not answer within [`TIME_LIMIT`].
    pub fn open() -> Result<Option<Self>> {
        // On its own thread: loading a driver is the one wait without a time limit of its own.
        let (sender, receiver) = mpsc::channel();
        std::thread::spawn(move || {
            let opened = catch_unwind(open).unwrap_or_else(|panic| Err(Error::Gpu(panic_text(&*panic))));
            // Nobody listens any more after the time limit.
            sender.send(opened).ok();
        });
        receiver.recv_timeout(TIME_LIMIT).unwrap_or_else(|_| Err(out_of_time("open the adapter")))
    }

    /// Opens the fastest adapter.
    ///
    /// # Errors
    /// As [`Gpu::open`]; also where there is none.
    pub fn require() -> Result<Self> {
        Self::open()?.ok_or_else(|| {
            Error::Gpu(
                "no adapter: install a Vulkan driver (Mesa's software driver will do: package mesa-vulkan-drivers) or \
                 set gpu.check = \"off\""
                    .into(),
            )
        })
    }

    /// What it is.
    pub fn info(&self) -> &GpuInfo {
        &self.info
    }

    /// Runs calls that create or submit something, and waits for nothing.
    ///
    /// # Errors
    /// `Error::Gpu` for whatever the calls reported: out of memory, rejected calls, loss of the device.
    pub(super) fn guarded<T>(&self, doing: &str, calls: impl FnOnce() -> T) -> Result<T> {
        self.check_alive(doing)?;
        let filters = [wgpu::ErrorFilter::Validation, wgpu::ErrorFilter::Internal, wgpu::ErrorFilter::OutOfMemory];
        let scopes = filters.map(|filter| self.device.push_error_scope(filter));
        let result = catch_unwind(AssertUnwindSafe(calls));
        let mut errors = Vec::new();
        // Scopes must be popped in reverse.
        for scope in scopes.into_iter().rev() {
            errors.extend(block_on(scope.pop(), doing)?);
        }
        if result.is_err() || !errors.is_empty() {
            // A lost device reports itself only when polled, and is the better explanation.
            catch_unwind(AssertUnwindSafe(|| self.device.poll(wgpu::PollType::Poll))).ok();
            self.check_alive(doing)?;
        }
        let result = result.map_err(|panic| Error::Gpu(format!("cannot {doing}: {}", panic_text(&*panic))))?;
        if let Some(error) = errors.first() {
            return Err(Error::Gpu(match error {
                wgpu::Error::OutOfMemory { .. } => {
                    format!("out of memory: cannot {doing}; lower tables.size, or set gpu.check = \"off\"")
                }
                other => format!("cannot {doing}: {other}"),
            }));
        }
        self.check_alive(doing)?;
        Ok(result)
    }

    /// Waits for everything submitted so far.
    ///
    /// # Errors
    /// `Error::Gpu` when it takes longer than [`TIME_LIMIT`] or the device is lost.
    pub(super) fn wait(&self, doing: &str) -> Result<()> {
        self.check_alive(doing)?;
        let wait = wgpu::PollType::Wait { submission_index: None, timeout: Some(TIME_LIMIT) };
        // A lost device makes `poll` panic (wgpu 30).
        let polled = catch_unwind(AssertUnwindSafe(|| self.device.poll(wait)));
        self.check_alive(doing)?;
        match polled {
            Ok(Ok(_)) => Ok(()),
            Ok(Err(wgpu::PollError::Timeout)) => Err(out_of_time(doing)),
            Ok(Err(error)) => Err(Error::Gpu(format!("cannot {doing}: {error}"))),
            Err(panic) => Err(Error::Gpu(format!("cannot {doing}: {}", panic_text(&*panic)))),
        }
    }

    /// The first bytes of a buffer with usage `MAP_READ`, once everything submitted is done.
    ///
    /// # Errors
    /// As [`Gpu::wait`].
    pub(super) fn read(&self, buffer: &wgpu::Buffer, bytes: u64, doing: &str) -> Result<Vec<u8>> {
        let slice = buffer.slice(..bytes);
        let (sender, receiver) = mpsc::channel();
        self.guarded(doing, || {
            slice.map_async(wgpu::MapMode::Read, move |mapped| {
                sender.send(mapped).ok();
            });
        })?;
        self.wait(doing)?;
        match receiver.recv_timeout(TIME_LIMIT) {
            Ok(Ok(())) => {}
            _ => return Err(Error::Gpu(format!("cannot {doing}: the result could not be mapped"))),
        }
        let view = slice.get_mapped_range().map_err(|error| Error::Gpu(format!("cannot {doing}: {error}")))?;
        let copy = view.to_vec();
        drop(view);
        buffer.unmap();
        Ok(copy)
    }

    fn check_alive(&self, doing: &str) -> Result<()> {
        match self.failure.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).as_ref() {
            Some(failure) => Err(Error::Gpu(format!("cannot {doing}: {failure}"))),
            None => Ok(()),
        }
    }

    /// Throws the device away as a driver's reset would; every later call must fail. For tests of just that.
    #[doc(hidden)]
    pub fn lose(&self) {
        self.device.destroy();
    }
}

fn open() -> Result<Option<Gpu>> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let options =
        wgpu::RequestAdapterOptions { power_preference: wgpu::PowerPreference::HighPerformance, ..Default::default() };
    let Ok(adapter) = block_on(instance.request_adapter(&options), "look for an adapter")? else {
        return Ok(None);
    };
    let features = adapter.features() & wgpu::Features::TIMESTAMP_QUERY;
    let descriptor = wgpu::DeviceDescriptor {
        label: Some("diffraction-atlas"),
        required_features: features,
        // No more than what every WebGPU device grants.
        required_limits: wgpu::Limits::defaults(),
        ..Default::default()
    };
    let info = describe(&adapter);
    let (device, queue) = block_on(adapter.request_device(&descriptor), "open the device")?
        .map_err(|error| Error::Gpu(format!("{} cannot be opened: {error}", info.adapter)))?;
    let failure = Arc::new(Mutex::new(None));
    let note = |failure: &Arc<Mutex<Option<String>>>, text: String| {
        failure.lock().unwrap_or_else(|poisoned| poisoned.into_inner()).get_or_insert(text);
    };
    let lost = failure.clone();
    device.set_device_lost_callback(move |reason, message| {
        note(&lost, format!("the device was lost ({reason:?}: {message})"));
    });
    let uncaught = failure.clone();
    device.on_uncaptured_error(Arc::new(move |error: wgpu::Error| note(&uncaught, error.to_string())));
    Ok(Some(Gpu { device, queue, info, failure }))
}

fn describe(adapter: &wgpu::Adapter) -> GpuInfo {
    let (info, limits, features) = (adapter.get_info(), adapter.limits(), adapter.features());
    GpuInfo {
        adapter: info.name,
        backend: info.backend.to_string(),
        driver: format!("{} {}", info.driver, info.driver_info).trim().to_owned(),
        kind: format!("{:?}", info.device_type).to_lowercase(),
        vendor_device: [info.vendor, info.device],
        timestamps: features.contains(wgpu::Features::TIMESTAMP_QUERY),
        texture_side_max: limits.max_texture_dimension_2d,
        texture_layers_max: limits.max_texture_array_layers,
        storage_binding_max_bytes: limits.max_storage_buffer_binding_size,
        features: features.iter_names().map(|(name, _)| name.to_owned()).collect(),
    }
}

/// Polls a future to its end; those of a native backend are ready at once.
fn block_on<T>(future: impl Future<Output = T>, doing: &str) -> Result<T> {
    let mut future = pin!(future);
    let started = Instant::now();
    loop {
        if let Poll::Ready(value) = future.as_mut().poll(&mut Context::from_waker(Waker::noop())) {
            return Ok(value);
        }
        if started.elapsed() > TIME_LIMIT {
            return Err(out_of_time(doing));
        }
        std::thread::sleep(Duration::from_millis(1));
    }
}

fn out_of_time(doing: &str) -> Error {
    Error::Gpu(format!(
        "cannot {doing}: no answer within {} s; the driver hangs or is too slow, set gpu.check = \"off\" to go on",
        TIME_LIMIT.as_secs()
    ))
}

fn panic_text(panic: &(dyn std::any::Any + Send)) -> String {
    let text = panic.downcast_ref::<String>().map(String::as_str).or_else(|| panic.downcast_ref::<&str>().copied());
    text.unwrap_or("the driver's interface broke down").to_owned()
}
