//! What an interactive program draws, on the GPU: one frame's pixels, and how long a frame takes.

use ndarray::Array3;
use serde::{Deserialize, Serialize};
use std::time::Instant;

use super::gpu::Gpu;
use super::gpu_layout::{FrameLight, FrameParams, SIDE_MAX};
use super::gpu_tables::{GpuTables, entry};
use super::wgsl;
use crate::ground::error::{Error, Result};
use crate::scene::light::light_samples;
use crate::scene::model::{Scene, Shape, check};
use crate::scene::sphere;

/// Frames drawn before any is timed: caches fill and clocks rise.
const WARM_UP: usize = 8;
/// Most frames timed: two entries each of a query set, which holds 4096.
const FRAMES_MAX: usize = 2048;
/// Frames submitted before waiting: the GPU stays busy, the queue short.
const BATCH: usize = 8;
/// Bytes of a pixel: four half floats.
const PIXEL_BYTES: usize = 8;
/// Bytes of the texels that one bilinear look-up of a table touches.
const LOOK_UP_BYTES: f64 = 4.0 * 8.0;

/// Where frame times come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize)]
#[serde(rename_all = "lowercase")]
pub enum Clock {
    /// The GPU's timestamps around each pass.
    Timestamps,
    /// Time between submitting a batch of frames and its end, over the frames: the GPU has no timestamps.
    Wall,
}

/// Time of one frame.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FrameTime {
    /// Median over the frames, or over the batches with `Clock::Wall`.
    pub median_ms: f64,
    /// Shortest.
    pub shortest_ms: f64,
    /// Frames timed.
    pub frames: usize,
    /// Pixels along each side.
    pub size_px: usize,
    /// Tables fetched per evaluation.
    pub tables: usize,
    /// Light samples per pixel.
    pub light_samples: usize,
    /// Texel reads in GB/s at the median, every look-up of a lit pixel counted as four texels: an upper bound of what
    /// leaves the cache.
    pub texel_gb_per_s: f64,
    /// How it was measured.
    pub clock: Clock,
}

/// A scene ready to be drawn.
#[derive(Debug)]
pub struct Frame<'a> {
    gpu: &'a Gpu,
    tables: &'a GpuTables,
    pipeline: wgpu::RenderPipeline,
    group: wgpu::BindGroup,
    target: wgpu::Texture,
    size_px: usize,
    light_samples: usize,
}

impl<'a> Frame<'a> {
    /// Prepares a sphere; `exposure` brings XYZ to display values.
    ///
    /// # Errors
    /// `Error::Call` for another shape or a picture larger than a texture, `Error::Gpu`.
    pub fn new(gpu: &'a Gpu, tables: &'a GpuTables, scene: &Scene, exposure: f32) -> Result<Self> {
        check(scene)?;
        if scene.shape != Shape::Sphere || scene.size_px > SIDE_MAX {
            return Err(Error::Call(format!(
                "scene \"{}\": frames are drawn of shape = \"sphere\" with size_px up to {SIDE_MAX}, not {:?} with {}",
                scene.name, scene.shape, scene.size_px
            )));
        }
        if scene.turn.angle_deg != 0.0 {
            return Err(Error::Call(format!(
                "scene \"{}\": frames are drawn of an object that is not turned",
                scene.name
            )));
        }
        let lights: Vec<FrameLight> = light_samples(scene)
            .iter()
            .map(|light| FrameLight {
                direction: light.direction.map(|c| c as f32),
                irradiance: light.irradiance as f32,
                pixel_offset: light.pixel_offset.map(|c| c as f32),
                unused: [0.0; 2],
            })
            .collect();
        let params = FrameParams {
            size_px: scene.size_px as f32,
            radius: sphere::RADIUS as f32,
            light_count: lights.len() as u32,
            exposure,
        };
        gpu.guarded("prepare a frame", || {
            let layout = frame_layout(gpu);
            Self {
                gpu,
                tables,
                pipeline: pipeline(gpu, tables, &layout),
                group: frame_group(gpu, &layout, &params, &lights),
                target: target(gpu, scene.size_px as u32),
                size_px: scene.size_px,
                light_samples: lights.len(),
            }
        })
    }

    /// Linear sRGB `[rows, columns, 3]` of a frame; components may be negative.
    ///
    /// # Errors
    /// `Error::Gpu`.
    pub fn draw(&self) -> Result<Array3<f32>> {
        let side = self.size_px;
        let row_bytes = (side * PIXEL_BYTES).next_multiple_of(wgpu::COPY_BYTES_PER_ROW_ALIGNMENT as usize);
        let readback = self.gpu.guarded("draw a frame", || {
            let readback = self.gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("frame read"),
                size: (row_bytes * side) as u64,
                usage: wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ,
                mapped_at_creation: false,
            });
            let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
            self.encode(&mut encoder, None);
            let rows = wgpu::TexelCopyBufferLayout {
                offset: 0,
                bytes_per_row: Some(row_bytes as u32),
                rows_per_image: Some(side as u32),
            };
            encoder.copy_texture_to_buffer(
                self.target.as_image_copy(),
                wgpu::TexelCopyBufferInfo { buffer: &readback, layout: rows },
                self.target.size(),
            );
            self.gpu.queue.submit([encoder.finish()]);
            readback
        })?;
        let bytes = self.gpu.read(&readback, (row_bytes * side) as u64, "read a frame")?;
        Ok(Array3::from_shape_fn((side, side, 3), |(row, column, c)| {
            let at = row * row_bytes + column * PIXEL_BYTES + 2 * c;
            half::f16::from_le_bytes([bytes[at], bytes[at + 1]]).to_f32()
        }))
    }

    /// Times 1 to 2048 frames after a warm-up.
    ///
    /// # Errors
    /// `Error::Gpu`.
    pub fn time(&self, frames: usize) -> Result<FrameTime> {
        let frames = frames.clamp(1, FRAMES_MAX);
        for _ in 0..WARM_UP {
            self.submit_batch(1, None)?;
        }
        let clock = if self.gpu.info().timestamps { Clock::Timestamps } else { Clock::Wall };
        let mut times_ms = match clock {
            Clock::Timestamps => self.timestamps_ms(frames)?,
            Clock::Wall => self.wall_times_ms(frames)?,
        };
        times_ms.sort_unstable_by(f64::total_cmp);
        let median_ms = times_ms[times_ms.len() / 2];
        let disc = std::f64::consts::PI * (0.5 * sphere::RADIUS * self.size_px as f64).powi(2);
        let look_ups = disc * (self.light_samples * self.tables.table_count) as f64;
        Ok(FrameTime {
            median_ms,
            shortest_ms: times_ms[0],
            frames,
            size_px: self.size_px,
            tables: self.tables.table_count,
            light_samples: self.light_samples,
            texel_gb_per_s: look_ups * LOOK_UP_BYTES / (median_ms * 1e6),
            clock,
        })
    }

    fn timestamps_ms(&self, frames: usize) -> Result<Vec<f64>> {
        let count = 2 * frames as u32;
        let bytes = u64::from(count) * 8;
        let (set, resolved, readback) = self.gpu.guarded("prepare timestamps", || {
            let buffer = |usage| {
                self.gpu.device.create_buffer(&wgpu::BufferDescriptor {
                    label: Some("timestamps"),
                    size: bytes,
                    usage,
                    mapped_at_creation: false,
                })
            };
            let set = self.gpu.device.create_query_set(&wgpu::QuerySetDescriptor {
                label: Some("timestamps"),
                ty: wgpu::QueryType::Timestamp,
                count,
            });
            let resolved = buffer(wgpu::BufferUsages::QUERY_RESOLVE | wgpu::BufferUsages::COPY_SRC);
            (set, resolved, buffer(wgpu::BufferUsages::COPY_DST | wgpu::BufferUsages::MAP_READ))
        })?;
        for first in (0..frames).step_by(BATCH) {
            self.submit_batch(BATCH.min(frames - first), Some((&set, 2 * first as u32)))?;
        }
        self.gpu.guarded("read timestamps", || {
            let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
            encoder.resolve_query_set(&set, 0..count, &resolved, 0);
            encoder.copy_buffer_to_buffer(&resolved, 0, &readback, 0, bytes);
            self.gpu.queue.submit([encoder.finish()]);
        })?;
        let bytes = self.gpu.read(&readback, bytes, "read timestamps")?;
        let ticks: Vec<u64> =
            bytes.chunks_exact(8).map(|b| u64::from_le_bytes(std::array::from_fn(|i| b[i]))).collect();
        let tick_ms = f64::from(self.gpu.queue.get_timestamp_period()) * 1e-6;
        // A clock that was reset in between gives no negative time but a wrapped one: left at zero.
        Ok(ticks.chunks_exact(2).map(|pair| pair[1].saturating_sub(pair[0]) as f64 * tick_ms).collect())
    }

    fn wall_times_ms(&self, frames: usize) -> Result<Vec<f64>> {
        (0..frames)
            .step_by(BATCH)
            .map(|first| {
                let count = BATCH.min(frames - first);
                let started = Instant::now();
                self.submit_batch(count, None)?;
                Ok(started.elapsed().as_secs_f64() * 1e3 / count as f64)
            })
            .collect()
    }

    /// Draws frames and waits for them; with timestamps from the given entry on.
    fn submit_batch(&self, count: usize, timestamps: Option<(&wgpu::QuerySet, u32)>) -> Result<()> {
        self.gpu.guarded("draw frames", || {
            for frame in 0..count as u32 {
                let mut encoder = self.gpu.device.create_command_encoder(&Default::default());
                self.encode(&mut encoder, timestamps.map(|(set, first)| (set, first + 2 * frame)));
                self.gpu.queue.submit([encoder.finish()]);
            }
        })?;
        self.gpu.wait("draw frames")
    }

    fn encode(&self, encoder: &mut wgpu::CommandEncoder, timestamps: Option<(&wgpu::QuerySet, u32)>) {
        let view = self.target.create_view(&Default::default());
        let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
            label: Some("frame"),
            color_attachments: &[Some(wgpu::RenderPassColorAttachment {
                view: &view,
                depth_slice: None,
                resolve_target: None,
                ops: wgpu::Operations { load: wgpu::LoadOp::Clear(wgpu::Color::BLACK), store: wgpu::StoreOp::Store },
            })],
            timestamp_writes: timestamps.map(|(query_set, first)| wgpu::RenderPassTimestampWrites {
                query_set,
                beginning_of_pass_write_index: Some(first),
                end_of_pass_write_index: Some(first + 1),
            }),
            ..Default::default()
        });
        pass.set_pipeline(&self.pipeline);
        pass.set_bind_group(0, &self.tables.group, &[]);
        pass.set_bind_group(1, &self.group, &[]);
        pass.draw(0..3, 0..1);
    }
}

const FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba16Float;

fn target(gpu: &Gpu, side: u32) -> wgpu::Texture {
    gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("frame"),
        size: wgpu::Extent3d { width: side, height: side, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: FORMAT,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
        view_formats: &[],
    })
}

fn frame_layout(gpu: &Gpu) -> wgpu::BindGroupLayout {
    let types = [wgpu::BufferBindingType::Uniform, wgpu::BufferBindingType::Storage { read_only: true }];
    let entries: Vec<wgpu::BindGroupLayoutEntry> = (0u32..)
        .zip(types)
        .map(|(binding, ty)| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::FRAGMENT,
            ty: wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None },
            count: None,
        })
        .collect();
    gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some("frame"), entries: &entries })
}

fn frame_group(
    gpu: &Gpu,
    layout: &wgpu::BindGroupLayout,
    params: &FrameParams,
    lights: &[FrameLight],
) -> wgpu::BindGroup {
    let buffer = |bytes: &[u8], usage| {
        let buffer = gpu.device.create_buffer(&wgpu::BufferDescriptor {
            label: Some("frame"),
            size: bytes.len() as u64,
            usage: usage | wgpu::BufferUsages::COPY_DST,
            mapped_at_creation: false,
        });
        gpu.queue.write_buffer(&buffer, 0, bytes);
        buffer
    };
    let params = buffer(bytemuck::bytes_of(params), wgpu::BufferUsages::UNIFORM);
    let lights = buffer(bytemuck::cast_slice(lights), wgpu::BufferUsages::STORAGE);
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("frame"),
        layout,
        entries: &[entry(0, params.as_entire_binding()), entry(1, lights.as_entire_binding())],
    })
}

fn pipeline(gpu: &Gpu, tables: &GpuTables, group: &wgpu::BindGroupLayout) -> wgpu::RenderPipeline {
    let module = gpu.device.create_shader_module(wgpu::ShaderModuleDescriptor {
        label: Some("frame"),
        source: wgpu::ShaderSource::Wgsl(wgsl::frame().into()),
    });
    let layout = gpu.device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: Some("frame"),
        bind_group_layouts: &[Some(&tables.layout), Some(group)],
        immediate_size: 0,
    });
    gpu.device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: Some("frame"),
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &module,
            entry_point: Some(wgsl::FULL_SCREEN),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: Default::default(),
        depth_stencil: None,
        multisample: Default::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module,
            entry_point: Some(wgsl::SHADE_SPHERE),
            compilation_options: Default::default(),
            targets: &[Some(FORMAT.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}
