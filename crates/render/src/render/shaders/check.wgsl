// Shading of uploaded samples, for comparison with the CPU. Follows tables.wgsl.

struct ShadingSample {
    wi: vec3<f32>,
    weight: f32,
    wo: vec3<f32>,
}

// Neighbouring samples of one pixel.
struct Run {
    first: u32,
    count: u32,
}

@group(1) @binding(0) var<storage, read> samples: array<ShadingSample>;
@group(1) @binding(1) var<storage, read> runs: array<Run>;
@group(1) @binding(2) var<storage, read_write> sums: array<vec4<f32>>;

@compute @workgroup_size(64)
fn shade_runs(@builtin(global_invocation_id) id: vec3<u32>) {
    if id.x >= arrayLength(&runs) {
        return;
    }
    let run = runs[id.x];
    var sum = vec3<f32>(0.0, 0.0, 0.0);
    var unanswered = 0.0;
    for (var index = run.first; index < run.first + run.count; index = index + 1u) {
        let xyz = surface_xyz(samples[index].wi, samples[index].wo);
        if has_answer(xyz) {
            sum = sum + samples[index].weight * xyz;
        } else {
            unanswered = unanswered + 1.0;
        }
    }
    sums[id.x] = vec4<f32>(sum, unanswered);
}
