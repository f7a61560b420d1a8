// Drawn directions and densities of uploaded queries, for comparison with the CPU. Follows sampling_tables.wgsl.

struct SampledQuery {
    wo: vec3<f32>,
    // Random numbers, or the direction to the light.
    more: vec3<f32>,
}

@group(1) @binding(0) var<storage, read> queries: array<SampledQuery>;
@group(1) @binding(1) var<storage, read_write> values: array<vec4<f32>>;

@compute @workgroup_size(64)
fn draw_samples(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x < arrayLength(&queries) {
        values[id.x] = brdf_sample(queries[id.x].wo, queries[id.x].more);
    }
}

@compute @workgroup_size(64)
fn eval_densities(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x < arrayLength(&queries) {
        values[id.x] = vec4<f32>(brdf_pdf(queries[id.x].more, queries[id.x].wo));
    }
}
