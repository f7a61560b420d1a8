// The closure PREFIXbsdf for MaterialX's generators of GLSL and ESSL: lights alone, no surroundings and no transmission.
#include "libraries/pbrlib/genglsl/lib/mx_closure_type.glsl"
#include "../include/tables_filtered.es300.glsl"

void mx_PREFIXbsdf(ClosureData closureData, float weight, float turn, float light_diameter, vec3 N, vec3 X, vec3 Y, inout BSDF bsdf)
{
    bsdf.throughput = vec3(0.0);
    if (closureData.closureType != CLOSURE_TYPE_REFLECTION)
    {
        return;
    }
    // The columns of the scan: the tangent, square to the normal, turned about it.
    vec3 along = normalize(X - dot(X, N) * N);
    vec3 across = cross(N, along);
    across = dot(across, Y) < 0.0 ? -across : across;
    vec2 angle = vec2(cos(radians(turn)), sin(radians(turn)));
    vec3 columns = angle.x * along + angle.y * across;
    vec3 rows = angle.x * across - angle.y * along;
    vec3 L = normalize(closureData.L);
    vec3 V = normalize(closureData.V);
    vec3 wi = vec3(dot(L, columns), dot(L, rows), dot(L, N));
    vec3 wo = vec3(dot(V, columns), dot(V, rows), dot(V, N));
    vec3 footprint = PREFIXfootprint_of_light(wi, radians(0.5 * light_diameter));
    vec3 xyz = PREFIXsurface_xyz_filtered(wi, wo, footprint);
    // Magenta where the tables have no answer. Colours of gratings lie outside of sRGB: components may be negative.
    vec3 response = PREFIXhas_answer(xyz) ? PREFIXxyz_to_linear_srgb(xyz) * max(wi.z, 0.0) : vec3(1.0, 0.0, 1.0);
    bsdf.response = response * closureData.occlusion * weight;
}
