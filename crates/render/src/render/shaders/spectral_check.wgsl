// Spectral values of uploaded queries, for comparison with the CPU. Follows spectral.wgsl.

struct SpectralQuery {
    wi: vec3<f32>,
    wavelength_nm: f32,
    wo: vec3<f32>,
    // 1 where `index` stands in for the uniform's.
    own_index: u32,
    // n and k.
    index: vec2<f32>,
}

@group(1) @binding(0) var<storage, read> queries: array<SpectralQuery>;
@group(1) @binding(1) var<storage, read_write> values: array<f32>;

@compute @workgroup_size(64)
fn eval_spectral(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&queries) {
        return;
    }
    let query = queries[id.x];
    if query.own_index == 0u {
        values[id.x] = brdf_spectral(query.wi, query.wo, query.wavelength_nm);
    } else {
        values[id.x] = brdf_spectral_with(front_of_index(query.index), query.wi, query.wo, query.wavelength_nm);
    }
}
