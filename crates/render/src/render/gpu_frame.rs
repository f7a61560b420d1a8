//! What an interactive program draws, on the GPU: one frame's pixels, and how long a frame takes.
//!
//! The lighting pass of a deferred renderer. Surfaces and shadows are gathered on the CPU and uploaded once, 48 bytes a
//! point and a bit a light; what is drawn and timed is all that the tables take part in: reading the surface, bringing
//! the directions into its frame, the BRDF of every light that is not shaded, colour.

use ndarray::Array3;
use serde::{Deserialize, Serialize};
use std::time::Instant;

use super::gpu::Gpu;
use super::gpu_layout::{FrameLight, FrameParams};
use super::gpu_tables::{GpuTables, entry, texture, write_layer};
use super::wgsl;
use crate::error::Result;
use crate::scene::gbuffer::GBuffer;
use crate::scene::light::LightSample;
use diffraction_brdf::error::Error;
use diffraction_brdf::shader::{LAYERS_MAX, SIDE_MAX};

/// Most frames in a batch: two entries each of a query set, which holds 4096.
const BATCH_MAX: usize = 2048;
/// Bytes of a pixel: four half floats.
const PIXEL_BYTES: usize = 8;
/// Bytes of a storage binding that every WebGPU device grants.
const BINDING_BYTES_MAX: usize = 128 << 20;
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

/// How many frames are drawn to time them.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct FramePlan {
    /// Frames drawn before any is timed: caches fill and clocks rise.
    pub warm_up: usize,
    /// Batches timed.
    pub batches: usize,
    /// Frames in a batch, submitted before waiting: the GPU stays busy, the queue short. 1 to 2048.
    pub batch: usize,
}

impl FramePlan {
    /// A plan of a second or less: many frames on hardware, few on a software driver.
    pub fn suited_to(gpu: &Gpu) -> Self {
        if gpu.info().is_software() {
            Self { warm_up: 1, batches: 5, batch: 1 }
        } else {
            Self { warm_up: 200, batches: 125, batch: 8 }
        }
    }
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
    /// Pairs of directions shaded in a frame: light samples of all pixels that show the surface lit.
    pub evaluations: u64,
    /// Texel reads in GB/s at the median, every look-up of a table counted as four texels: an upper bound of what
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
    evaluations: u64,
}

impl<'a> Frame<'a> {
    /// Uploads the geometry; `exposure` brings XYZ to display values.
    ///
    /// # Errors
    /// `Error::Limit` for a picture larger than every GPU takes, `Error::Gpu`.
    pub fn new(gpu: &'a Gpu, tables: &'a GpuTables, buffer: &GBuffer, exposure: f32) -> Result<Self> {
        let lit_bytes = size_of_val(buffer.lit.as_slice());
        if buffer.size_px > SIDE_MAX || buffer.layers > LAYERS_MAX || lit_bytes > BINDING_BYTES_MAX {
            let (name, side, layers) = (&buffer.scene, buffer.size_px, buffer.layers);
            return Err(Error::limit(
                format!(
                    "a frame of scene \"{name}\" needs {layers} textures of {side} x {side} pixels and {lit_bytes} bytes of \
                     shadows; every GPU takes {LAYERS_MAX} of {SIDE_MAX} x {SIDE_MAX} and {BINDING_BYTES_MAX} bytes"
                ),
                "lower its size_px, light_samples or pixel_samples",
            )
            .into());
        }
        gpu.guarded("prepare a frame", || {
            let layout = frame_layout(gpu);
            Self {
                gpu,
                tables,
                pipeline: pipeline(gpu, tables, &layout, buffer.is_filtered()),
                group: frame_group(gpu, &layout, buffer, exposure),
                target: target(gpu, buffer.size_px as u32),
                size_px: buffer.size_px,
                light_samples: buffer.lights.len(),
                evaluations: buffer.evaluations(),
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

    /// Times of a batch of frames, or their mean without timestamps.
    fn batch_ms(&self, frames: usize) -> Result<Vec<f64>> {
        match clock(self.gpu) {
            Clock::Timestamps => self.timestamps_ms(frames),
            Clock::Wall => Ok(vec![self.wall_ms(frames)?]),
        }
    }

    fn summary(&self, mut times_ms: Vec<f64>, frames: usize) -> FrameTime {
        times_ms.sort_unstable_by(f64::total_cmp);
        let median_ms = times_ms[times_ms.len() / 2];
        let look_ups = self.evaluations as f64 * self.tables.table_count as f64;
        FrameTime {
            median_ms,
            shortest_ms: times_ms[0],
            frames,
            size_px: self.size_px,
            tables: self.tables.table_count,
            light_samples: self.light_samples,
            evaluations: self.evaluations,
            texel_gb_per_s: look_ups * LOOK_UP_BYTES / (median_ms * 1e6),
            clock: clock(self.gpu),
        }
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
        self.submit_batch(frames, Some((&set, 0)))?;
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

    fn wall_ms(&self, frames: usize) -> Result<f64> {
        let started = Instant::now();
        self.submit_batch(frames, None)?;
        Ok(started.elapsed().as_secs_f64() * 1e3 / frames as f64)
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

/// Times frames after a warm-up. Batches take turns, so that whatever else slows the machine down slows all of them.
///
/// # Errors
/// `Error::Gpu`.
pub fn time_frames<const N: usize>(frames: [&Frame; N], plan: FramePlan) -> Result<[FrameTime; N]> {
    let (batches, batch) = (plan.batches.max(1), plan.batch.clamp(1, BATCH_MAX));
    for frame in frames {
        for _ in 0..plan.warm_up.div_ceil(batch) {
            frame.submit_batch(batch.min(plan.warm_up), None)?;
        }
    }
    let mut times_ms: [Vec<f64>; N] = std::array::from_fn(|_| Vec::with_capacity(batches * batch));
    for _ in 0..batches {
        for (frame, times) in frames.iter().zip(&mut times_ms) {
            times.extend(frame.batch_ms(batch)?);
        }
    }
    let mut times_ms = times_ms.into_iter();
    Ok(frames.map(|frame| frame.summary(times_ms.next().unwrap_or_default(), batches * batch)))
}

fn clock(gpu: &Gpu) -> Clock {
    if gpu.info().timestamps { Clock::Timestamps } else { Clock::Wall }
}

/// Bytes of the buffers that [`copy_gb_per_s`] copies: beyond most caches, within WebGPU's default limits.
const COPY_BYTES: u64 = 64 << 20;
/// Copies that are timed together.
const COPIES: u64 = 8;

/// What copying within the GPU's memory reaches in GB/s, bytes read and written counted: a measure of its bandwidth.
///
/// # Errors
/// `Error::Gpu`.
pub fn copy_gb_per_s(gpu: &Gpu) -> Result<f64> {
    let buffers = gpu.guarded("prepare copies", || {
        [(); 2].map(|()| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some("copies"),
                size: COPY_BYTES,
                usage: wgpu::BufferUsages::COPY_SRC | wgpu::BufferUsages::COPY_DST,
                mapped_at_creation: false,
            })
        })
    })?;
    let copy = |count| -> Result<f64> {
        let started = Instant::now();
        gpu.guarded("copy", || {
            let mut encoder = gpu.device.create_command_encoder(&Default::default());
            for _ in 0..count {
                encoder.copy_buffer_to_buffer(&buffers[0], 0, &buffers[1], 0, COPY_BYTES);
            }
            gpu.queue.submit([encoder.finish()]);
        })?;
        gpu.wait("copy")?;
        Ok(started.elapsed().as_secs_f64())
    };
    // The first copy also clears the buffers.
    copy(1)?;
    Ok((2 * COPIES * COPY_BYTES) as f64 / copy(COPIES)? * 1e-9)
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
    let buffer = |ty| wgpu::BindingType::Buffer { ty, has_dynamic_offset: false, min_binding_size: None };
    let list = buffer(wgpu::BufferBindingType::Storage { read_only: true });
    let vectors = wgpu::BindingType::Texture {
        sample_type: wgpu::TextureSampleType::Float { filterable: false },
        view_dimension: wgpu::TextureViewDimension::D2Array,
        multisampled: false,
    };
    let types = [buffer(wgpu::BufferBindingType::Uniform), list, list, vectors, vectors, vectors];
    let entries: Vec<wgpu::BindGroupLayoutEntry> = (0u32..)
        .zip(types)
        .map(|(binding, ty)| wgpu::BindGroupLayoutEntry {
            binding,
            visibility: wgpu::ShaderStages::FRAGMENT,
            ty,
            count: None,
        })
        .collect();
    gpu.device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor { label: Some("frame"), entries: &entries })
}

fn frame_group(gpu: &Gpu, layout: &wgpu::BindGroupLayout, surfaces: &GBuffer, exposure: f32) -> wgpu::BindGroup {
    let light = |((light, &layer), &angular_radius): ((&LightSample, &u32), &f32)| FrameLight {
        direction: light.direction.map(|c| c as f32),
        irradiance: light.irradiance as f32,
        layer,
        angular_radius,
        unused: [0; 2],
    };
    let pieces = surfaces.lights.iter().zip(&surfaces.layer_of_light).zip(&surfaces.radius_of_light);
    let lights: Vec<FrameLight> = pieces.map(light).collect();
    let params = FrameParams {
        size_px: surfaces.size_px as u32,
        light_count: lights.len() as u32,
        lit_words: surfaces.lit_words as u32,
        exposure,
    };
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
    let params = buffer(bytemuck::bytes_of(&params), wgpu::BufferUsages::UNIFORM);
    let lights = buffer(bytemuck::cast_slice(&lights), wgpu::BufferUsages::STORAGE);
    let lit = buffer(bytemuck::cast_slice(&surfaces.lit), wgpu::BufferUsages::STORAGE);
    let padded = |[x, y, z]: [f32; 3]| [x, y, z, 0.0];
    let normals: Vec<[f32; 4]> = surfaces.normal.iter().copied().map(padded).collect();
    let viewers: Vec<[f32; 4]> = surfaces.to_viewer.iter().copied().map(padded).collect();
    let [tangents, normals, viewers] =
        [&surfaces.tangent, &normals, &viewers].map(|vectors| vector_view(gpu, surfaces, vectors));
    gpu.device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: Some("frame"),
        layout,
        entries: &[
            entry(0, params.as_entire_binding()),
            entry(1, lights.as_entire_binding()),
            entry(2, lit.as_entire_binding()),
            entry(3, wgpu::BindingResource::TextureView(&tangents)),
            entry(4, wgpu::BindingResource::TextureView(&normals)),
            entry(5, wgpu::BindingResource::TextureView(&viewers)),
        ],
    })
}

/// One vector of every surface point, as a texture.
fn vector_view(gpu: &Gpu, surfaces: &GBuffer, vectors: &[[f32; 4]]) -> wgpu::TextureView {
    let side = surfaces.size_px;
    let texture = texture(gpu, wgpu::TextureFormat::Rgba32Float, [side, side, surfaces.layers]);
    for (layer, texels) in vectors.chunks_exact(side * side).enumerate() {
        write_layer(gpu, &texture, [side, side], layer, bytemuck::cast_slice(texels));
    }
    texture.create_view(&wgpu::TextureViewDescriptor {
        dimension: Some(wgpu::TextureViewDimension::D2Array),
        ..Default::default()
    })
}

fn pipeline(gpu: &Gpu, tables: &GpuTables, group: &wgpu::BindGroupLayout, filtered: bool) -> wgpu::RenderPipeline {
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
            entry_point: Some(if filtered { wgsl::SHADE_SURFACES_FILTERED } else { wgsl::SHADE_SURFACES }),
            compilation_options: Default::default(),
            targets: &[Some(FORMAT.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}
