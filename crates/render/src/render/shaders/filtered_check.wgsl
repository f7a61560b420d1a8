// Filtered values of uploaded queries, for comparison with the CPU. Follows tables.wgsl.

struct FilteredQuery {
    wi: vec3<f32>,
    // Wavelength in nm, for spectral tables.
    wavelength_nm: f32,
    wo: vec3<f32>,
    // Angular radius of the light in radians.
    angular_radius: f32,
    // Covariance of the normals' tilt over the pixel.
    normals: vec3<f32>,
    // What comes to the footprint besides.
    more: vec3<f32>,
}

@group(1) @binding(0) var<storage, read> queries: array<FilteredQuery>;
@group(1) @binding(1) var<storage, read_write> values: array<vec4<f32>>;

@compute @workgroup_size(64)
fn eval_filtered(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&queries) {
        return;
    }
    let query = queries[id.x];
    let footprint = footprint_of_light(query.wi, query.angular_radius)
        + footprint_of_normals(query.wi, query.wo, query.normals)
        + query.more;
    values[id.x] = value_of(query, footprint);
}
