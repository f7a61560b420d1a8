//! How an engine of its own draws with exported shaders: `cargo run --release --example engine EXPORTED SPECIMEN OUT.png`. Behind that may come a
//! side in pixels, a multiple of 16, and where light and viewer are, as `X,Y,Z`; with `OUT.f32` it writes linear sRGB as 32-bit floats.
//!
//! Of this library only the PNG encoder is used. `EXPORTED` is what `diffraction-atlas export ATLAS --form shaders --out
//! EXPORTED` wrote. A square of the specimen, seen from above under a point light.

use std::error::Error;
use std::path::Path;

use diffraction_render::render::png_image::write_png;
use ndarray::Array3;

/// Half the square's side; the light's and the viewer's place over its plane z = 0.
pub const HALF_SIDE: f32 = 1.0;
/// Where the light is.
pub const LIGHT: [f32; 3] = [-1.6, 0.3, 2.0];
/// Where the viewer is.
pub const EYE: [f32; 3] = [0.6, -0.2, 3.0];

/// The engine's half: directions for the exported fragment shader. Both are linear over the square, so that interpolating
/// them is exact; the fragment shader normalises them.
fn vertex_shader(light: [f32; 3], eye: [f32; 3]) -> String {
    format!(
        "struct Out {{
            @builtin(position) position: vec4<f32>,
            @location(0) to_light: vec3<f32>,
            @location(1) to_viewer: vec3<f32>,
        }}
        @vertex
        fn square(@builtin(vertex_index) index: u32) -> Out {{
            let corner = 2.0 * vec2<f32>(f32((index << 1u) & 2u), f32(index & 2u)) - 1.0;
            let place = vec3<f32>({HALF_SIDE:?} * corner, 0.0);
            let light = vec3<f32>({:?}, {:?}, {:?});
            let eye = vec3<f32>({:?}, {:?}, {:?});
            return Out(vec4<f32>(corner, 0.0, 1.0), light - place, eye - place);
        }}",
        light[0], light[1], light[2], eye[0], eye[1], eye[2]
    )
}

type Outcome<T> = Result<T, Box<dyn Error>>;

/// [`draw_from`] with the light and the viewer where they are here.
pub fn draw(exported: &Path, specimen: &str, side: u32) -> Outcome<Array3<f32>> {
    draw_from(exported, specimen, side, [LIGHT, EYE])
}

/// Linear sRGB of the square, `[rows, columns, 3]`, for a light of unit irradiance and a viewer at these places. The side is a multiple of 16.
pub fn draw_from(exported: &Path, specimen: &str, side: u32, [light, eye]: [[f32; 3]; 2]) -> Outcome<Array3<f32>> {
    let instance = wgpu::Instance::new(wgpu::InstanceDescriptor::new_without_display_handle());
    let adapter = block_on(instance.request_adapter(&Default::default()))?;
    let (device, queue) = block_on(adapter.request_device(&Default::default()))?;
    let folder = exported.join(specimen);
    let index: serde_json::Value = serde_json::from_slice(&std::fs::read(folder.join("textures.json"))?)?;

    let params = std::fs::read(folder.join("params.bin"))?;
    let uniform = buffer(&device, params.len() as u64, wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_DST);
    queue.write_buffer(&uniform, 0, &params);
    let views = ["tables", "cross_terms", "lobe"].map(|name| texture(&device, &queue, &folder, &index[name]));
    let [tables, cross_terms, lobe] = views;
    let sampler = device.create_sampler(&wgpu::SamplerDescriptor {
        mag_filter: wgpu::FilterMode::Linear,
        min_filter: wgpu::FilterMode::Linear,
        ..Default::default()
    });

    let target = device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width: side, height: side, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: wgpu::TextureFormat::Rgba32Float,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT | wgpu::TextureUsages::COPY_SRC,
        view_formats: &[],
    });
    let material = std::fs::read_to_string(exported.join("tables.wgsl"))?;
    let pipeline = pipeline(&device, &vertex_shader(light, eye), &material, target.format());
    let group = device.create_bind_group(&wgpu::BindGroupDescriptor {
        label: None,
        layout: &pipeline.get_bind_group_layout(0),
        entries: &[
            wgpu::BindGroupEntry { binding: 0, resource: uniform.as_entire_binding() },
            wgpu::BindGroupEntry { binding: 1, resource: wgpu::BindingResource::TextureView(&tables?) },
            wgpu::BindGroupEntry { binding: 2, resource: wgpu::BindingResource::TextureView(&cross_terms?) },
            wgpu::BindGroupEntry { binding: 3, resource: wgpu::BindingResource::TextureView(&lobe?) },
            wgpu::BindGroupEntry { binding: 4, resource: wgpu::BindingResource::Sampler(&sampler) },
        ],
    });

    let bytes = u64::from(side * side * 16);
    let read = buffer(&device, bytes, wgpu::BufferUsages::MAP_READ | wgpu::BufferUsages::COPY_DST);
    let mut encoder = device.create_command_encoder(&Default::default());
    let mut pass = encoder.begin_render_pass(&wgpu::RenderPassDescriptor {
        color_attachments: &[Some(wgpu::RenderPassColorAttachment {
            view: &target.create_view(&Default::default()),
            depth_slice: None,
            resolve_target: None,
            ops: wgpu::Operations::default(),
        })],
        ..Default::default()
    });
    pass.set_pipeline(&pipeline);
    pass.set_bind_group(0, &group, &[]);
    pass.draw(0..3, 0..1);
    drop(pass);
    let layout = wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(side * 16), rows_per_image: Some(side) };
    encoder.copy_texture_to_buffer(
        target.as_image_copy(),
        wgpu::TexelCopyBufferInfo { buffer: &read, layout },
        target.size(),
    );
    queue.submit([encoder.finish()]);
    read.slice(..).map_async(wgpu::MapMode::Read, |_| ());
    device.poll(wgpu::PollType::wait_indefinitely())?;
    let mapped = read.slice(..).get_mapped_range()?;
    let texels: &[[f32; 4]] = bytemuck::cast_slice(&mapped);
    let side = side as usize;
    Ok(Array3::from_shape_fn((side, side, 3), |(row, column, c)| texels[row * side + column][c]))
}

fn buffer(device: &wgpu::Device, size: u64, usage: wgpu::BufferUsages) -> wgpu::Buffer {
    device.create_buffer(&wgpu::BufferDescriptor { label: None, size, usage, mapped_at_creation: false })
}

/// A texture as textures.json describes it.
fn texture(
    device: &wgpu::Device,
    queue: &wgpu::Queue,
    folder: &Path,
    about: &serde_json::Value,
) -> Outcome<wgpu::TextureView> {
    let texels = std::fs::read(folder.join(about["file"].as_str().ok_or("no file")?))?;
    let [width, height, layers]: [u32; 3] = serde_json::from_value(about["width_height_layers"].clone())?;
    let (format, bytes) = match about["format"].as_str() {
        Some("RGBA16F") => (wgpu::TextureFormat::Rgba16Float, 8),
        Some("RGBA32F") => (wgpu::TextureFormat::Rgba32Float, 16),
        other => return Err(format!("no format {other:?}").into()),
    };
    let texture = device.create_texture(&wgpu::TextureDescriptor {
        label: None,
        size: wgpu::Extent3d { width, height, depth_or_array_layers: layers },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format,
        usage: wgpu::TextureUsages::TEXTURE_BINDING | wgpu::TextureUsages::COPY_DST,
        view_formats: &[],
    });
    let rows =
        wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(width * bytes), rows_per_image: Some(height) };
    queue.write_texture(texture.as_image_copy(), &texels, rows, texture.size());
    let array = about["kind"].as_str().is_some_and(|kind| kind.contains("array"));
    let dimension = if array { wgpu::TextureViewDimension::D2Array } else { wgpu::TextureViewDimension::D2 };
    Ok(texture.create_view(&wgpu::TextureViewDescriptor { dimension: Some(dimension), ..Default::default() }))
}

fn pipeline(
    device: &wgpu::Device,
    vertices: &str,
    material: &str,
    format: wgpu::TextureFormat,
) -> wgpu::RenderPipeline {
    let module = |source: String| {
        let source = wgpu::ShaderSource::Wgsl(source.into());
        device.create_shader_module(wgpu::ShaderModuleDescriptor { label: None, source })
    };
    let image = |binding, filterable, view_dimension| {
        let sample_type = wgpu::TextureSampleType::Float { filterable };
        let ty = wgpu::BindingType::Texture { sample_type, view_dimension, multisampled: false };
        wgpu::BindGroupLayoutEntry { binding, visibility: wgpu::ShaderStages::FRAGMENT, ty, count: None }
    };
    let other =
        |binding, ty| wgpu::BindGroupLayoutEntry { binding, visibility: wgpu::ShaderStages::FRAGMENT, ty, count: None };
    let uniform = wgpu::BindingType::Buffer {
        ty: wgpu::BufferBindingType::Uniform,
        has_dynamic_offset: false,
        min_binding_size: None,
    };
    let group = device.create_bind_group_layout(&wgpu::BindGroupLayoutDescriptor {
        label: None,
        entries: &[
            other(0, uniform),
            image(1, true, wgpu::TextureViewDimension::D2Array),
            image(2, true, wgpu::TextureViewDimension::D2Array),
            // Not filterable: what the shader does itself for 32-bit floats.
            image(3, false, wgpu::TextureViewDimension::D2),
            other(4, wgpu::BindingType::Sampler(wgpu::SamplerBindingType::Filtering)),
        ],
    });
    let layout = device.create_pipeline_layout(&wgpu::PipelineLayoutDescriptor {
        label: None,
        bind_group_layouts: &[Some(&group)],
        immediate_size: 0,
    });
    device.create_render_pipeline(&wgpu::RenderPipelineDescriptor {
        label: None,
        layout: Some(&layout),
        vertex: wgpu::VertexState {
            module: &module(vertices.to_owned()),
            entry_point: Some("square"),
            compilation_options: Default::default(),
            buffers: &[],
        },
        primitive: Default::default(),
        depth_stencil: None,
        multisample: Default::default(),
        fragment: Some(wgpu::FragmentState {
            module: &module(material.to_owned()),
            entry_point: Some("shade_material"),
            compilation_options: Default::default(),
            targets: &[Some(format.into())],
        }),
        multiview_mask: None,
        cache: None,
    })
}

/// Polls a future of wgpu's, which is ready at once outside of browsers.
fn block_on<T>(future: impl Future<Output = T>) -> T {
    let mut future = std::pin::pin!(future);
    let mut context = std::task::Context::from_waker(std::task::Waker::noop());
    loop {
        if let std::task::Poll::Ready(value) = future.as_mut().poll(&mut context) {
            return value;
        }
        std::thread::yield_now();
    }
}

/// Three numbers with commas between them.
fn vector(text: &str) -> Outcome<[f32; 3]> {
    let numbers: Vec<f32> = text.split(',').map(str::parse).collect::<Result<_, _>>()?;
    numbers.try_into().map_err(|_| format!("{text:?}: three numbers are expected, such as 0,0,2").into())
}

fn main() -> Outcome<()> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [exported, specimen, out, more @ ..] = &arguments[..] else {
        return Err("name the exported folder, a specimen, and the PNG to write".into());
    };
    let side = more.first().map_or(Ok(512), |side| side.parse())?;
    let place = |index: usize, default| more.get(index).map_or(Ok(default), |text| vector(text));
    let linear = draw_from(Path::new(exported), specimen, side, [place(1, LIGHT)?, place(2, EYE)?])?;
    if out.ends_with(".f32") {
        let bytes: Vec<u8> = linear.iter().flat_map(|value| value.to_le_bytes()).collect();
        return Ok(std::fs::write(out, bytes)?);
    }
    // Exposed for the brightest hundredth, then the curve of sRGB.
    let mut greens: Vec<f32> = linear.iter().skip(1).step_by(3).copied().collect();
    greens.sort_by(f32::total_cmp);
    let white = greens[greens.len() * 99 / 100].max(f32::MIN_POSITIVE);
    let encode = |value: f32| {
        let value = (value / white).clamp(0.0, 1.0);
        let curve = if value <= 0.003_130_8 { 12.92 * value } else { 1.055 * value.powf(1.0 / 2.4) - 0.055 };
        (255.0 * curve).round() as u8
    };
    write_png(Path::new(out), &linear.mapv(encode))?;
    Ok(())
}
