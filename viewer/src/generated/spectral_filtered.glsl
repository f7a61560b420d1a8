#version 300 es

precision highp float;
precision highp int;

struct Front {
    uint material;
    uint factor;
    uint shadowing;
    vec2 index;
    vec2 permittivity;
};
struct SpectralParams {
    uint table_layers;
    uint cross_layers;
    uint lobe_count;
    uint material;
    uint factor;
    uint shadowing;
    float index_n;
    float index_k;
    vec2 permittivity;
    float shortest_nm;
    float lobe_sigma_nm;
    float cross_radius;
    uint of_source;
    uint look_up;
    vec4 table_scales[64];
    vec4 cross_scales[64];
};
struct SplinePlaces {
    vec2 first;
    vec2 second;
    vec2 share;
};
struct Ellipse {
    vec2 axis;
    vec2 variances;
};
struct Taps {
    float level;
    float centre;
    vec2 along;
    vec2 across;
};
struct LobePlace {
    vec2 centre;
    vec2 semi_axes;
};
const uint IDEAL = 0u;
const uint DIELECTRIC = 1u;
const uint CONDUCTOR = 2u;
const uint SCALAR = 0u;
const uint VECTOR = 1u;
const float NO_ANSWER = -1.0;
const float SHORTEST_SLACK = 1e-6;
const uint SPLINES = 1u;
const uint LINEAR = 0u;
const uint CHORDS = 14u;
const float PI = 3.1415927;
const float BLUR_SHARE = 0.1835;
const float BLUR_SHARE_MAJOR = 0.05;
const float SPLINE_POINT_MAX = 0.003;
const uint RING = 6u;
const float GAUSSIAN_REACH = 4.55;

layout(std140) uniform SpectralParams_block_0Fragment { SpectralParams _group_0_binding_0_fs; };

uniform highp sampler2DArray _group_0_binding_1_fs;

uniform highp sampler2DArray _group_0_binding_2_fs;

uniform highp sampler2D _group_0_binding_3_fs;

smooth in vec3 _vs2fs_location0;
smooth in vec3 _vs2fs_location1;
smooth in float _vs2fs_location2;
smooth in vec3 _vs2fs_location3;
layout(location = 0) out vec4 _fs2p_location0;

vec3 wave_vector_change(vec3 wi_1, vec3 wo_1) {
    return (-(wi_1) - wo_1);
}

float geometry_factor(vec3 wi_2, vec3 wo_2) {
    float one_plus = (1.0 + dot(wi_2, wo_2));
    return ((one_plus / wi_2.z) * (one_plus / wo_2.z));
}

float v_cavity_shadowing(vec3 wi_3, vec3 wo_3) {
    vec3 sum_9 = (wi_3 + wo_3);
    vec3 m = (sum_9 / vec3(sqrt(dot(sum_9, sum_9))));
    float wo_m = dot(wo_3, m);
    if (!((wo_m > 0.0))) {
        return 0.0;
    }
    float scale = ((2.0 * m.z) / wo_m);
    return clamp(min((scale * wo_3.z), (scale * wi_3.z)), 0.0, 1.0);
}

vec2 complex_product(vec2 a, vec2 b) {
    return vec2(((a.x * b.x) - (a.y * b.y)), ((a.x * b.y) + (a.y * b.x)));
}

vec2 complex_quotient(vec2 a_1, vec2 b_1) {
    vec2 _e6 = complex_product(a_1, vec2(b_1.x, -(b_1.y)));
    return (_e6 / vec2(dot(b_1, b_1)));
}

vec2 complex_root(vec2 a_2) {
    float larger = sqrt((0.5 * (sqrt(dot(a_2, a_2)) + abs(a_2.x))));
    if ((larger == 0.0)) {
        return vec2(0.0, 0.0);
    }
    float smaller = ((0.5 * abs(a_2.y)) / larger);
    float turn = ((a_2.y >= 0.0) ? 1.0 : -1.0);
    if ((a_2.x >= 0.0)) {
        return vec2(larger, (turn * smaller));
    }
    return vec2(smaller, (turn * larger));
}

float reflectance(Front front, float cos_theta_d) {
    if ((front.material == IDEAL)) {
        return 1.0;
    }
    vec2 index_2 = front.index;
    float cos_i = clamp(cos_theta_d, 0.0, 1.0);
    vec2 _e15 = complex_product(index_2, index_2);
    vec2 _e16 = complex_quotient(vec2((1.0 - (cos_i * cos_i)), 0.0), _e15);
    vec2 _e21 = complex_root((vec2(1.0, 0.0) - _e16));
    vec2 _e22 = complex_product(index_2, _e21);
    vec2 along = vec2(cos_i, 0.0);
    vec2 _e27 = complex_quotient((along - _e22), (along + _e22));
    vec2 _e32 = complex_quotient(((index_2 * cos_i) - _e21), ((index_2 * cos_i) + _e21));
    return (0.5 * (dot(_e27, _e27) + dot(_e32, _e32)));
}

float cos_half_angle(vec3 wi_4, vec3 wo_4) {
    return sqrt(max((0.5 + (0.5 * dot(wi_4, wo_4))), 0.0));
}

float shadowing(Front front_1, vec3 wi_5, vec3 wo_5) {
    if ((front_1.shadowing == 0u)) {
        return 1.0;
    }
    float _e7 = v_cavity_shadowing(wi_5, wo_5);
    return _e7;
}

float polarised_sum(Front front_2, vec3 wi_6, vec3 wo_6) {
    float cos_phi = 1.0;
    float sin2_i = dot(wi_6.xy, wi_6.xy);
    float sin2_o = dot(wo_6.xy, wo_6.xy);
    float sines = (sqrt(sin2_i) * sqrt(sin2_o));
    if ((sines > 1e-12)) {
        cos_phi = clamp((-(dot(wi_6.xy, wo_6.xy)) / sines), -1.0, 1.0);
    }
    float _e24 = cos_phi;
    float _e25 = cos_phi;
    float cos2_phi = (_e24 * _e25);
    vec2 eps = front_2.permittivity;
    if ((front_2.material == DIELECTRIC)) {
        float a_3 = sqrt(max((eps.x - sin2_i), 0.0));
        float b_2 = sqrt(max((eps.x - sin2_o), 0.0));
        float s_i = (wi_6.z + a_3);
        float s_o = (wo_6.z + b_2);
        float p_i = ((eps.x * wi_6.z) + a_3);
        float p_o = ((eps.x * wo_6.z) + b_2);
        float ss = (1.0 / (s_i * s_o));
        float sp = (b_2 / (s_i * p_o));
        float ps = (a_3 / (p_i * s_o));
        float _e61 = cos_phi;
        float pp = ((((a_3 * b_2) * _e61) - (eps.x * sines)) / (p_i * p_o));
        float contrast = ((eps.x - 1.0) * (eps.x - 1.0));
        return (contrast * ((((cos2_phi * ss) * ss) + ((1.0 - cos2_phi) * ((sp * sp) + (ps * ps)))) + (pp * pp)));
    }
    vec2 _e90 = complex_root((eps - vec2(sin2_i, 0.0)));
    vec2 _e94 = complex_root((eps - vec2(sin2_o, 0.0)));
    vec2 s_i_1 = (_e90 + vec2(wi_6.z, 0.0));
    vec2 s_o_1 = (_e94 + vec2(wo_6.z, 0.0));
    vec2 p_i_1 = ((eps * wi_6.z) + _e90);
    vec2 p_o_1 = ((eps * wo_6.z) + _e94);
    float ss_1 = (1.0 / (dot(s_i_1, s_i_1) * dot(s_o_1, s_o_1)));
    float sp_1 = (dot(_e94, _e94) / (dot(s_i_1, s_i_1) * dot(p_o_1, p_o_1)));
    float ps_1 = (dot(_e90, _e90) / (dot(p_i_1, p_i_1) * dot(s_o_1, s_o_1)));
    vec2 _e124 = complex_product(_e90, _e94);
    float _e125 = cos_phi;
    vec2 across = ((_e124 * _e125) - (eps * sines));
    float pp_1 = (dot(across, across) / (dot(p_i_1, p_i_1) * dot(p_o_1, p_o_1)));
    vec2 less = (eps - vec2(1.0, 0.0));
    return (dot(less, less) * (((cos2_phi * ss_1) + ((1.0 - cos2_phi) * (sp_1 + ps_1))) + pp_1));
}

float diffuse_factor(Front front_3, vec3 wi_7, vec3 wo_7) {
    bool local = false;
    if ((front_3.factor == VECTOR)) {
        local = (front_3.material != IDEAL);
    } else {
        local = false;
    }
    bool _e12 = local;
    if (_e12) {
        float _e18 = polarised_sum(front_3, wi_7, wo_7);
        float _e20 = shadowing(front_3, wi_7, wo_7);
        return ((((2.0 * wi_7.z) * wo_7.z) * _e18) * _e20);
    }
    float _e22 = cos_half_angle(wi_7, wo_7);
    float _e23 = reflectance(front_3, _e22);
    float _e24 = geometry_factor(wi_7, wo_7);
    float _e26 = shadowing(front_3, wi_7, wo_7);
    return ((_e23 * _e24) * _e26);
}

float coherent_factor(Front front_4, vec3 wi_8, vec3 wo_8) {
    float _e3 = cos_half_angle(wi_8, wo_8);
    float _e4 = reflectance(front_4, _e3);
    float _e5 = shadowing(front_4, wi_8, wo_8);
    float mirror = (_e4 * _e5);
    if ((front_4.factor == VECTOR)) {
        return mirror;
    }
    float w = (wi_8.z + wo_8.z);
    float _e13 = geometry_factor(wi_8, wo_8);
    return (((mirror * _e13) / w) / w);
}

float image_radius2_(vec3 wi_9, vec3 wo_9) {
    vec2 lateral = (wi_9.xy + wo_9.xy);
    float to_horizon_i = ((wi_9.z * wi_9.z) / (1.0 + length(wi_9.xy)));
    float to_horizon_o = ((wo_9.z * wo_9.z) / (1.0 + length(wo_9.xy)));
    return (dot(lateral, lateral) + ((4.0 * to_horizon_i) * to_horizon_o));
}

float max_abs_w(float rho) {
    return sqrt(max((4.0 - (rho * rho)), 0.0));
}

float normalised_abs_w(vec3 q) {
    float _e3 = max_abs_w(length(q.xy));
    if ((_e3 == 0.0)) {
        return 0.0;
    }
    return min((abs(q.z) / _e3), 1.0);
}

vec2 texel_centred(vec2 at, uvec2 size) {
    vec2 across_1 = vec2(size);
    vec2 texel = (vec2((0.5 + (0.5 * at.x)), (0.5 - (0.5 * at.y))) * (across_1 - vec2(1.0)));
    return ((texel + vec2(0.5)) / across_1);
}

Front front_of_index(vec2 index) {
    uint material = 0u;
    bool local_1 = false;
    uint _e3 = _group_0_binding_0_fs.material;
    material = _e3;
    uint _e5 = material;
    if ((_e5 != IDEAL)) {
        if ((index.y == 0.0)) {
            local_1 = (index.x >= 1.0);
        } else {
            local_1 = false;
        }
        bool _e19 = local_1;
        material = (_e19 ? DIELECTRIC : CONDUCTOR);
    }
    uint _e21 = material;
    uint _e24 = _group_0_binding_0_fs.factor;
    uint _e27 = _group_0_binding_0_fs.shadowing;
    vec2 _e28 = complex_product(index, index);
    return Front(_e21, _e24, _e27, index, _e28);
}

Front front_factor() {
    float _e2 = _group_0_binding_0_fs.index_n;
    float _e5 = _group_0_binding_0_fs.index_k;
    vec2 index_3 = vec2(_e2, _e5);
    uint _e9 = _group_0_binding_0_fs.material;
    uint _e12 = _group_0_binding_0_fs.factor;
    uint _e15 = _group_0_binding_0_fs.shadowing;
    vec2 _e18 = _group_0_binding_0_fs.permittivity;
    return Front(_e9, _e12, _e15, index_3, _e18);
}

vec4 first_four(float x) {
    float second = (((2.0 * x) * x) - 1.0);
    return vec4(1.0, x, second, (((2.0 * x) * second) - x));
}

vec4 spline_texel(SplinePlaces places, uint layer) {
    vec4 a_4 = textureLod(_group_0_binding_1_fs, vec3(places.first, layer), 0.0);
    vec4 b_3 = textureLod(_group_0_binding_1_fs, vec3(vec2(places.second.x, places.first.y), layer), 0.0);
    vec4 c = textureLod(_group_0_binding_1_fs, vec3(vec2(places.first.x, places.second.y), layer), 0.0);
    vec4 d = textureLod(_group_0_binding_1_fs, vec3(places.second, layer), 0.0);
    return mix(mix(d, c, places.share.x), mix(b_3, a_4, places.share.x), places.share.y);
}

vec4 next_four(vec4 basis, float x_1) {
    float a_5 = (((2.0 * x_1) * basis.w) - basis.z);
    float b_4 = (((2.0 * x_1) * a_5) - basis.w);
    float c_1 = (((2.0 * x_1) * b_4) - a_5);
    return vec4(a_5, b_4, c_1, (((2.0 * x_1) * c_1) - b_4));
}

float expansion_by_splines(SplinePlaces places_1, float t) {
    vec4 basis_1 = vec4(0.0);
    float sum = 0.0;
    uint layer_1 = 0u;
    vec4 _e6 = first_four(((2.0 * t) - 1.0));
    basis_1 = _e6;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e35 = layer_1;
            layer_1 = (_e35 + 1u);
        }
        loop_init = false;
        uint _e12 = layer_1;
        uint _e15 = _group_0_binding_0_fs.table_layers;
        if ((_e12 < _e15)) {
        } else {
            break;
        }
        {
            float _e17 = sum;
            vec4 _e18 = basis_1;
            uint _e21 = layer_1;
            vec4 _e23 = _group_0_binding_0_fs.table_scales[_e21];
            uint _e25 = layer_1;
            vec4 _e26 = spline_texel(places_1, _e25);
            sum = (_e17 + dot((_e18 * _e23), _e26));
            vec4 _e29 = basis_1;
            vec4 _e34 = next_four(_e29, ((2.0 * t) - 1.0));
            basis_1 = _e34;
        }
    }
    float _e38 = sum;
    return _e38;
}

SplinePlaces spline_places(vec2 uv) {
    vec2 size_2 = vec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy));
    vec2 texel_1 = ((uv * size_2) - vec2(0.5));
    vec2 whole = floor(texel_1);
    vec2 f = (texel_1 - whole);
    vec2 g = (vec2(1.0) - f);
    vec2 before = (((g * g) * g) / vec2(6.0));
    vec2 last = (((f * f) * f) / vec2(6.0));
    vec2 nearest = ((vec2(0.6666667) - (f * f)) + (3.0 * last));
    vec2 share = (before + nearest);
    vec2 first = ((whole - vec2(1.0)) + (nearest / share));
    vec2 second_1 = ((whole + vec2(1.0)) + (last / (vec2(1.0) - share)));
    return SplinePlaces(((first + vec2(0.5)) / size_2), ((second_1 + vec2(0.5)) / size_2), share);
}

float expansion(vec2 at_1, float t_1) {
    vec4 basis_2 = vec4(0.0);
    float sum_1 = 0.0;
    uint layer_2 = 0u;
    vec2 _e4 = texel_centred(at_1, uvec2(textureSize(_group_0_binding_1_fs, 0).xy));
    uint _e7 = _group_0_binding_0_fs.look_up;
    if ((_e7 == SPLINES)) {
        SplinePlaces _e10 = spline_places(_e4);
        float _e11 = expansion_by_splines(_e10, t_1);
        return _e11;
    }
    vec4 _e16 = first_four(((2.0 * t_1) - 1.0));
    basis_2 = _e16;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e48 = layer_2;
            layer_2 = (_e48 + 1u);
        }
        loop_init_1 = false;
        uint _e22 = layer_2;
        uint _e25 = _group_0_binding_0_fs.table_layers;
        if ((_e22 < _e25)) {
        } else {
            break;
        }
        {
            uint _e29 = layer_2;
            vec4 texel_2 = textureLod(_group_0_binding_1_fs, vec3(_e4, _e29), 0.0);
            float _e32 = sum_1;
            vec4 _e33 = basis_2;
            uint _e36 = layer_2;
            vec4 _e38 = _group_0_binding_0_fs.table_scales[_e36];
            sum_1 = (_e32 + dot((_e33 * _e38), texel_2));
            vec4 _e42 = basis_2;
            vec4 _e47 = next_four(_e42, ((2.0 * t_1) - 1.0));
            basis_2 = _e47;
        }
    }
    float _e51 = sum_1;
    return _e51;
}

vec4 lagrange_weights(float x_2) {
    float a_6 = (x_2 - 1.0);
    float b_5 = (x_2 - 2.0);
    float c_2 = (x_2 - 3.0);
    return vec4((((-(a_6) * b_5) * c_2) / 6.0), (((0.5 * x_2) * b_5) * c_2), (((-0.5 * x_2) * a_6) * c_2), (((x_2 * a_6) * b_5) / 6.0));
}

vec4 cross_texel(vec2 uv_1, uint layer_3) {
    bool local_2 = false;
    vec4 sum_2 = vec4(0.0, 0.0, 0.0, 0.0);
    int k = 0;
    ivec2 size_3 = ivec2(uvec2(textureSize(_group_0_binding_2_fs, 0).xy));
    uint _e7 = _group_0_binding_0_fs.look_up;
    if (!((_e7 == LINEAR))) {
        local_2 = (min(size_3.x, size_3.y) < 4);
    } else {
        local_2 = true;
    }
    bool _e19 = local_2;
    if (_e19) {
        vec4 _e23 = textureLod(_group_0_binding_2_fs, vec3(uv_1, layer_3), 0.0);
        return _e23;
    }
    vec2 at_7 = clamp(((uv_1 * vec2(size_3)) - vec2(0.5)), vec2(0.0, 0.0), vec2((size_3 - ivec2(1))));
    ivec2 first_1 = min(max((ivec2(at_7) - ivec2(1)), ivec2(0, 0)), (size_3 - ivec2(4)));
    vec4 _e52 = lagrange_weights((at_7.x - float(first_1.x)));
    vec4 _e57 = lagrange_weights((at_7.y - float(first_1.y)));
    bool loop_init_2 = true;
    while(true) {
        if (!loop_init_2) {
            int _e93 = k;
            k = (_e93 + 1);
        }
        loop_init_2 = false;
        int _e66 = k;
        if ((_e66 < 16)) {
        } else {
            break;
        }
        {
            int _e70 = k;
            int _e73 = k;
            vec4 texel_3 = texelFetch(_group_0_binding_2_fs, ivec3((first_1 + ivec2((_e70 % 4), (_e73 / 4))), int(layer_3)), 0);
            vec4 _e81 = sum_2;
            int _e82 = k;
            int _e86 = k;
            sum_2 = (_e81 + ((_e52[(_e82 % 4)] * _e57[(_e86 / 4)]) * texel_3));
        }
    }
    vec4 _e96 = sum_2;
    return _e96;
}

float cross_value(vec3 q_1, float t_2) {
    bool local_3 = false;
    vec4 basis_3 = vec4(0.0);
    float sum_3 = 0.0;
    uint layer_4 = 0u;
    uint _e4 = _group_0_binding_0_fs.cross_layers;
    if (!((_e4 == 0u))) {
        float _e17 = _group_0_binding_0_fs.cross_radius;
        local_3 = (max(abs(q_1.x), abs(q_1.y)) >= _e17);
    } else {
        local_3 = true;
    }
    bool _e20 = local_3;
    if (_e20) {
        return 0.0;
    }
    float _e25 = _group_0_binding_0_fs.cross_radius;
    vec2 _e30 = texel_centred((q_1.xy / vec2(_e25)), uvec2(textureSize(_group_0_binding_2_fs, 0).xy));
    vec4 _e35 = first_four(((2.0 * t_2) - 1.0));
    basis_3 = _e35;
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            uint _e64 = layer_4;
            layer_4 = (_e64 + 1u);
        }
        loop_init_3 = false;
        uint _e41 = layer_4;
        uint _e44 = _group_0_binding_0_fs.cross_layers;
        if ((_e41 < _e44)) {
        } else {
            break;
        }
        {
            uint _e46 = layer_4;
            vec4 _e47 = cross_texel(_e30, _e46);
            float _e48 = sum_3;
            vec4 _e49 = basis_3;
            uint _e52 = layer_4;
            vec4 _e54 = _group_0_binding_0_fs.cross_scales[_e52];
            sum_3 = (_e48 + dot((_e49 * _e54), _e47));
            vec4 _e58 = basis_3;
            vec4 _e63 = next_four(_e58, ((2.0 * t_2) - 1.0));
            basis_3 = _e63;
        }
    }
    float _e67 = sum_3;
    return (_e67 / abs(q_1.z));
}

float lobe_shape(float radius2_, float wavelength_nm_1) {
    float _e4 = _group_0_binding_0_fs.lobe_sigma_nm;
    float scale_1 = ((6.2831855 * _e4) / wavelength_nm_1);
    return exp(((-(scale_1) * scale_1) * radius2_));
}

float power_texel(uint index_1) {
    uint columns = uvec2(textureSize(_group_0_binding_3_fs, 0).xy).x;
    vec4 _e11 = texelFetch(_group_0_binding_3_fs, ivec2(int((index_1 % columns)), int((index_1 / columns))), 0);
    return _e11.x;
}

float power_at(float abs_w) {
    uint _e3 = _group_0_binding_0_fs.lobe_count;
    uint last_1 = (_e3 - 1u);
    float at_8 = (clamp((0.5 * abs_w), 0.0, 1.0) * float(last_1));
    uint first_2 = min(uint(at_8), (last_1 - 1u));
    float _e17 = power_texel(first_2);
    float _e20 = power_texel((first_2 + 1u));
    return mix(_e17, _e20, (at_8 - float(first_2)));
}

float brdf_spectral_with(Front front_5, vec3 wi_10, vec3 wo_10, float wavelength_nm_2) {
    bool local_4 = false;
    bool local_5 = false;
    float shape = 0.0;
    if ((wi_10.z > 0.0)) {
        local_4 = (wo_10.z > 0.0);
    } else {
        local_4 = false;
    }
    bool _e13 = local_4;
    if (!(_e13)) {
        return 0.0;
    }
    float _e18 = _group_0_binding_0_fs.shortest_nm;
    float ratio = (_e18 / wavelength_nm_2);
    if ((ratio > 0.0)) {
        local_5 = (ratio <= 1.000001);
    } else {
        local_5 = false;
    }
    bool _e27 = local_5;
    if (!(_e27)) {
        return NO_ANSWER;
    }
    float r = min(ratio, 1.0);
    vec3 _e32 = wave_vector_change(wi_10, wo_10);
    vec3 q_4 = (r * _e32);
    float _e34 = normalised_abs_w(q_4);
    float _e35 = diffuse_factor(front_5, wi_10, wo_10);
    float _e39 = expansion((0.5 * q_4.xy), _e34);
    float _e40 = cross_value(q_4, _e34);
    float diffuse = (_e35 * (_e39 + _e40));
    float r2_ = (r * r);
    uint _e46 = _group_0_binding_0_fs.lobe_count;
    if ((_e46 == 0u)) {
        return ((r2_ * r2_) * diffuse);
    }
    uint _e53 = _group_0_binding_0_fs.of_source;
    bool grows = (_e53 == 1u);
    float _e58 = _group_0_binding_0_fs.shortest_nm;
    float lobe_nm = (grows ? _e58 : wavelength_nm_2);
    float _e63 = lobe_shape(dot(_e32.xy, _e32.xy), lobe_nm);
    shape = _e63;
    if ((front_5.factor == VECTOR)) {
        float _e68 = shape;
        float _e69 = image_radius2_(wi_10, wo_10);
        float _e70 = lobe_shape(_e69, lobe_nm);
        shape = (_e68 + _e70);
    }
    float _e76 = coherent_factor(front_5, wi_10, wo_10);
    float _e80 = power_at(abs(q_4.z));
    float _e82 = shape;
    return (((r2_ * r2_) * diffuse) + ((((grows ? 1.0 : r2_) * _e76) * _e80) * _e82));
}

float brdf_spectral(vec3 wi_11, vec3 wo_11, float wavelength_nm_3) {
    Front _e3 = front_factor();
    float _e4 = brdf_spectral_with(_e3, wi_11, wo_11, wavelength_nm_3);
    return _e4;
}

bool has_answer(float value) {
    return (value != NO_ANSWER);
}

vec3 footprint_of_light(vec3 wi_12, float angular_radius) {
    float sine = sin(angular_radius);
    return (((0.25 * sine) * sine) * vec3((1.0 - (wi_12.x * wi_12.x)), (-(wi_12.x) * wi_12.y), (1.0 - (wi_12.y * wi_12.y))));
}

vec3 footprint_of_normals(vec3 wi_13, vec3 wo_12, vec3 normals) {
    float w_1 = (wi_13.z + wo_12.z);
    return ((w_1 * w_1) * normals);
}

Ellipse ellipse_of(vec3 footprint_1) {
    vec2 axis = vec2(1.0, 0.0);
    float middle = (0.5 * (footprint_1.x + footprint_1.z));
    float difference = (0.5 * (footprint_1.x - footprint_1.z));
    float spread = length(vec2(difference, footprint_1.y));
    if ((spread > 0.0)) {
        float larger_1 = sqrt((0.5 + ((0.5 * abs(difference)) / spread)));
        float smaller_1 = ((0.5 * abs(footprint_1.y)) / (spread * larger_1));
        float turn_1 = ((footprint_1.y >= 0.0) ? 1.0 : -1.0);
        axis = ((difference >= 0.0) ? vec2(larger_1, (turn_1 * smaller_1)) : vec2(smaller_1, (turn_1 * larger_1)));
    }
    vec2 _e46 = axis;
    return Ellipse(_e46, vec2((middle + spread), max((middle - spread), 0.0)));
}

Taps taps_of(Ellipse ellipse, float texels_per_unit, float level_max) {
    vec2 variances = ((ellipse.variances * texels_per_unit) * texels_per_unit);
    float wanted = max((BLUR_SHARE * variances.y), (BLUR_SHARE_MAJOR * variances.x));
    float level_2 = clamp(floor((0.5 * log2((1.0 + (4.0 * wanted))))), 0.0, level_max);
    float blur = (0.25 * (exp2((2.0 * level_2)) - 1.0));
    float share_1 = min((blur / max(sqrt((variances.x * variances.y)), 1e-20)), BLUR_SHARE);
    float rest = (1.0 - share_1);
    float ring = min((((4.0 * rest) * rest) / ((5.3333335 - ((16.0 * share_1) * rest)) - ((8.0 * share_1) * share_1))), 1.0);
    vec2 axes = (sqrt(((2.0 * max((variances - vec2(blur)), vec2(0.0, 0.0))) / vec2(ring))) / vec2(texels_per_unit));
    return Taps(level_2, (1.0 - ring), (axes.x * ellipse.axis), (axes.y * vec2(-(ellipse.axis.y), ellipse.axis.x)));
}

Ellipse for_coefficients(Ellipse ellipse_1, float texels_per_unit_1) {
    return Ellipse(ellipse_1.axis, (ellipse_1.variances + vec2((1.0 / ((6.0 * texels_per_unit_1) * texels_per_unit_1)))));
}

vec2 next_of_ring(vec2 at_2) {
    return vec2(((0.5 * at_2.x) - (0.8660254 * at_2.y)), ((0.8660254 * at_2.x) + (0.5 * at_2.y)));
}

float coarsest_level(uvec2 size_1) {
    return max(floor(log2((0.25 * float(min(size_1.x, size_1.y))))), 0.0);
}

LobePlace direct_lobe(vec2 at_3, Ellipse ellipse_2) {
    vec2 axis_1 = ellipse_2.axis;
    return LobePlace(vec2(dot(at_3, axis_1), ((at_3.y * axis_1.x) - (at_3.x * axis_1.y))), (2.0 * sqrt(ellipse_2.variances)));
}

LobePlace image_lobe(vec3 wi_14, vec3 wo_13, vec3 footprint_2) {
    vec2 e = vec2(1.0, 0.0);
    vec2 difference_1 = (wo_13.xy - wi_14.xy);
    float apart = length(difference_1);
    if ((apart > 0.0)) {
        e = (difference_1 / vec2(apart));
    }
    vec2 sum_10 = (wi_14.xy + wo_13.xy);
    float _e20 = e.x;
    float _e24 = e.y;
    float along_1 = ((sum_10.y * _e20) - (sum_10.x * _e24));
    float _e27 = image_radius2_(wi_14, wo_13);
    float across_2 = sqrt(max((_e27 - (along_1 * along_1)), 0.0));
    float _e34 = e.x;
    float _e36 = e.x;
    float _e41 = e.x;
    float _e45 = e.y;
    float _e51 = e.y;
    float _e53 = e.y;
    float _e59 = e.y;
    float _e61 = e.y;
    float _e66 = e.x;
    float _e70 = e.y;
    float _e76 = e.x;
    float _e78 = e.x;
    vec2 variances_1 = vec2(((((_e34 * _e36) * footprint_2.x) + (((2.0 * _e41) * _e45) * footprint_2.y)) + ((_e51 * _e53) * footprint_2.z)), ((((_e59 * _e61) * footprint_2.x) - (((2.0 * _e66) * _e70) * footprint_2.y)) + ((_e76 * _e78) * footprint_2.z)));
    return LobePlace(vec2(across_2, along_1), (2.0 * sqrt(max(variances_1, vec2(0.0, 0.0)))));
}

bool reaches(LobePlace place, float reach) {
    return (length(max((abs(place.centre) - place.semi_axes), vec2(0.0, 0.0))) < reach);
}

vec2 within(float centre, float semi_axis, float reach_1, float limit) {
    if ((semi_axis > 0.0)) {
        vec2 ends = vec2(max(((-(reach_1) - centre) / semi_axis), -(limit)), min(((reach_1 - centre) / semi_axis), limit));
        return vec2(ends.x, max(ends.x, ends.y));
    }
    return ((abs(centre) < reach_1) ? vec2(-(limit), limit) : vec2(0.0, 0.0));
}

float erfc(float x_3) {
    float p = 0.17087276;
    float t_7 = (1.0 / (1.0 + (0.5 * x_3)));
    float _e9 = p;
    p = (-0.82215226 + (t_7 * _e9));
    float _e13 = p;
    p = (1.4885159 + (t_7 * _e13));
    float _e17 = p;
    p = (-1.135204 + (t_7 * _e17));
    float _e21 = p;
    p = (0.27886808 + (t_7 * _e21));
    float _e25 = p;
    p = (-0.18628806 + (t_7 * _e25));
    float _e29 = p;
    p = (0.09678418 + (t_7 * _e29));
    float _e33 = p;
    p = (0.37409195 + (t_7 * _e33));
    float _e37 = p;
    p = (1.0000237 + (t_7 * _e37));
    float _e45 = p;
    return (t_7 * exp((((-(x_3) * x_3) - 1.2655122) + (t_7 * _e45))));
}

float gaussian_between(float low, float high) {
    float area = 0.0;
    float apart_1 = (high - low);
    if ((apart_1 < 0.05)) {
        float middle_1 = (0.5 * (low + high));
        float square = (middle_1 * middle_1);
        return (exp(-(square)) * (1.0 + (((apart_1 * apart_1) * ((2.0 * square) - 1.0)) / 12.0)));
    }
    if ((low >= 0.0)) {
        float _e26 = erfc(low);
        float _e27 = erfc(high);
        area = (_e26 - _e27);
    } else {
        if ((high <= 0.0)) {
            float _e32 = erfc(-(high));
            float _e34 = erfc(-(low));
            area = (_e32 - _e34);
        } else {
            float _e37 = erfc(-(low));
            float _e40 = erfc(high);
            area = ((2.0 - _e37) - _e40);
        }
    }
    float _e42 = area;
    return ((0.8862269 * _e42) / apart_1);
}

float gaussian_mean(LobePlace place_1, float width) {
    float sum_4 = 0.0;
    uint k_1 = 0u;
    float reach_2 = (GAUSSIAN_REACH * width);
    vec2 _e9 = within(place_1.centre.y, place_1.semi_axes.y, reach_2, 1.0);
    float middle_2 = (0.5 * (_e9.x + _e9.y));
    float half_length = (0.5 * (_e9.y - _e9.x));
    if ((half_length <= 0.0)) {
        return 0.0;
    }
    bool loop_init_4 = true;
    while(true) {
        if (!loop_init_4) {
            uint _e87 = k_1;
            k_1 = (_e87 + 1u);
        }
        loop_init_4 = false;
        uint _e28 = k_1;
        if ((_e28 < CHORDS)) {
        } else {
            break;
        }
        {
            uint _e31 = k_1;
            float angle = (float((_e31 + 1u)) * 0.20943952);
            float eta = (middle_2 - (half_length * cos(angle)));
            float y = (place_1.centre.y + (place_1.semi_axes.y * eta));
            float chord = sqrt(max((1.0 - (eta * eta)), 0.0));
            vec2 _e61 = within(place_1.centre.x, place_1.semi_axes.x, sqrt(max(((reach_2 * reach_2) - (y * y)), 0.0)), chord);
            vec2 lateral_1 = ((vec2(place_1.centre.x) + (place_1.semi_axes.x * _e61)) / vec2(width));
            float off = (y / width);
            float _e72 = sum_4;
            float _e84 = gaussian_between(lateral_1.x, lateral_1.y);
            sum_4 = (_e72 + (((sin(angle) * (_e61.y - _e61.x)) * exp((-(off) * off))) * _e84));
        }
    }
    float _e90 = sum_4;
    return (((_e90 * half_length) * 0.20943952) / PI);
}

float expansion_on(vec2 at_4, float t_3, float level) {
    vec4 basis_4 = vec4(0.0);
    float sum_5 = 0.0;
    uint layer_5 = 0u;
    vec2 _e5 = texel_centred(at_4, uvec2(textureSize(_group_0_binding_1_fs, 0).xy));
    vec4 _e10 = first_four(((2.0 * t_3) - 1.0));
    basis_4 = _e10;
    bool loop_init_5 = true;
    while(true) {
        if (!loop_init_5) {
            uint _e41 = layer_5;
            layer_5 = (_e41 + 1u);
        }
        loop_init_5 = false;
        uint _e16 = layer_5;
        uint _e19 = _group_0_binding_0_fs.table_layers;
        if ((_e16 < _e19)) {
        } else {
            break;
        }
        {
            uint _e23 = layer_5;
            vec4 texel_4 = textureLod(_group_0_binding_1_fs, vec3(_e5, _e23), level);
            float _e25 = sum_5;
            vec4 _e26 = basis_4;
            uint _e29 = layer_5;
            vec4 _e31 = _group_0_binding_0_fs.table_scales[_e29];
            sum_5 = (_e25 + dot((_e26 * _e31), texel_4));
            vec4 _e35 = basis_4;
            vec4 _e40 = next_four(_e35, ((2.0 * t_3) - 1.0));
            basis_4 = _e40;
        }
    }
    float _e44 = sum_5;
    return _e44;
}

float expansion_mean(vec3 q_2, float t_4, Ellipse ellipse_3) {
    Taps taps = Taps(0.0, 0.0, vec2(0.0), vec2(0.0));
    bool local_6 = false;
    float sum_6 = 0.0;
    vec2 place_2 = vec2(0.0, 0.0);
    float weight = 0.0;
    uint k_2 = 0u;
    vec2 at_5 = vec2(0.0);
    uvec2 size_4 = uvec2(textureSize(_group_0_binding_1_fs, 0).xy);
    float texels_per_unit_2 = (0.25 * (float(size_4.x) - 1.0));
    float _e11 = coarsest_level(size_4);
    Taps _e12 = taps_of(ellipse_3, texels_per_unit_2, _e11);
    taps = _e12;
    uint _e16 = _group_0_binding_0_fs.look_up;
    if ((_e16 == SPLINES)) {
        float _e22 = taps.level;
        local_6 = (_e22 == 0.0);
    } else {
        local_6 = false;
    }
    bool _e26 = local_6;
    if (_e26) {
        if ((((ellipse_3.variances.x * texels_per_unit_2) * texels_per_unit_2) < SPLINE_POINT_MAX)) {
            float _e36 = expansion((0.5 * q_2.xy), t_4);
            return _e36;
        }
        Ellipse _e37 = for_coefficients(ellipse_3, texels_per_unit_2);
        Taps _e39 = taps_of(_e37, texels_per_unit_2, 0.0);
        taps = _e39;
    }
    float _e47 = taps.centre;
    weight = _e47;
    bool loop_init_6 = true;
    while(true) {
        if (!loop_init_6) {
            uint _e102 = k_2;
            k_2 = (_e102 + 1u);
        }
        loop_init_6 = false;
        uint _e51 = k_2;
        if ((_e51 <= RING)) {
        } else {
            break;
        }
        {
            float _e56 = place_2.x;
            vec2 _e58 = taps.along;
            float _e62 = place_2.y;
            vec2 _e64 = taps.across;
            at_5 = ((q_2.xy + (_e56 * _e58)) + (_e62 * _e64));
            vec2 _e68 = at_5;
            vec2 _e69 = at_5;
            at_5 = (_e68 * min(1.0, (2.0 / max(length(_e69), 1e-20))));
            float _e78 = sum_6;
            float _e79 = weight;
            vec2 _e80 = at_5;
            float _e84 = taps.level;
            float _e85 = expansion_on((0.5 * _e80), t_4, _e84);
            sum_6 = (_e78 + (_e79 * _e85));
            float _e89 = taps.centre;
            weight = ((1.0 - _e89) / 6.0);
            uint _e94 = k_2;
            if ((_e94 == 0u)) {
                place_2 = vec2(1.0, 0.0);
            } else {
                vec2 _e100 = place_2;
                vec2 _e101 = next_of_ring(_e100);
                place_2 = _e101;
            }
        }
    }
    float _e105 = sum_6;
    return _e105;
}

float cross_on(vec2 at_6, float t_5, float level_1) {
    vec4 basis_5 = vec4(0.0);
    float sum_7 = 0.0;
    uint layer_6 = 0u;
    vec2 _e5 = texel_centred(at_6, uvec2(textureSize(_group_0_binding_2_fs, 0).xy));
    vec4 _e10 = first_four(((2.0 * t_5) - 1.0));
    basis_5 = _e10;
    bool loop_init_7 = true;
    while(true) {
        if (!loop_init_7) {
            uint _e41 = layer_6;
            layer_6 = (_e41 + 1u);
        }
        loop_init_7 = false;
        uint _e16 = layer_6;
        uint _e19 = _group_0_binding_0_fs.cross_layers;
        if ((_e16 < _e19)) {
        } else {
            break;
        }
        {
            uint _e23 = layer_6;
            vec4 texel_5 = textureLod(_group_0_binding_2_fs, vec3(_e5, _e23), level_1);
            float _e25 = sum_7;
            vec4 _e26 = basis_5;
            uint _e29 = layer_6;
            vec4 _e31 = _group_0_binding_0_fs.cross_scales[_e29];
            sum_7 = (_e25 + dot((_e26 * _e31), texel_5));
            vec4 _e35 = basis_5;
            vec4 _e40 = next_four(_e35, ((2.0 * t_5) - 1.0));
            basis_5 = _e40;
        }
    }
    float _e44 = sum_7;
    return _e44;
}

float cross_mean(vec3 q_3, float t_6, Ellipse ellipse_4) {
    float sum_8 = 0.0;
    bool local_7 = false;
    vec2 place_3 = vec2(0.0, 0.0);
    float weight_1 = 0.0;
    uint k_3 = 0u;
    float _e12 = _group_0_binding_0_fs.cross_radius;
    float reach_3 = ((2.0 * sqrt(ellipse_4.variances.x)) + _e12);
    uint _e16 = _group_0_binding_0_fs.cross_layers;
    if (!((_e16 == 0u))) {
        local_7 = (max(abs(q_3.x), abs(q_3.y)) >= reach_3);
    } else {
        local_7 = true;
    }
    bool _e29 = local_7;
    if (_e29) {
        float _e30 = sum_8;
        return _e30;
    }
    uvec2 size_5 = uvec2(textureSize(_group_0_binding_2_fs, 0).xy);
    float _e41 = _group_0_binding_0_fs.cross_radius;
    float _e43 = coarsest_level(size_5);
    Taps _e44 = taps_of(ellipse_4, ((0.5 * (float(size_5.x) - 1.0)) / _e41), _e43);
    weight_1 = _e44.centre;
    bool loop_init_8 = true;
    while(true) {
        if (!loop_init_8) {
            uint _e98 = k_3;
            k_3 = (_e98 + 1u);
        }
        loop_init_8 = false;
        uint _e53 = k_3;
        if ((_e53 <= RING)) {
        } else {
            break;
        }
        {
            float _e58 = place_3.x;
            float _e63 = place_3.y;
            float _e69 = _group_0_binding_0_fs.cross_radius;
            vec2 at_9 = (((q_3.xy + (_e58 * _e44.along)) + (_e63 * _e44.across)) / vec2(_e69));
            if ((max(abs(at_9.x), abs(at_9.y)) < 1.0)) {
                float _e79 = sum_8;
                float _e80 = weight_1;
                float _e82 = cross_on(at_9, t_6, _e44.level);
                sum_8 = (_e79 + (_e80 * _e82));
            }
            weight_1 = ((1.0 - _e44.centre) / 6.0);
            uint _e90 = k_3;
            if ((_e90 == 0u)) {
                place_3 = vec2(1.0, 0.0);
            } else {
                vec2 _e96 = place_3;
                vec2 _e97 = next_of_ring(_e96);
                place_3 = _e97;
            }
        }
    }
    float _e101 = sum_8;
    return (_e101 / abs(q_3.z));
}

float lobe_mean(LobePlace place_4, float width_1) {
    bool _e4 = reaches(place_4, (GAUSSIAN_REACH * width_1));
    if (!(_e4)) {
        return 0.0;
    }
    float _e7 = gaussian_mean(place_4, width_1);
    return _e7;
}

float brdf_spectral_filtered_with(Front front_6, vec3 wi_15, vec3 wo_14, float wavelength_nm_4, vec3 footprint_3) {
    bool local_8 = false;
    bool local_9 = false;
    float shape_1 = 0.0;
    if ((wi_15.z > 0.0)) {
        local_8 = (wo_14.z > 0.0);
    } else {
        local_8 = false;
    }
    bool _e14 = local_8;
    if (!(_e14)) {
        return 0.0;
    }
    float _e19 = _group_0_binding_0_fs.shortest_nm;
    float ratio_1 = (_e19 / wavelength_nm_4);
    if ((ratio_1 > 0.0)) {
        local_9 = (ratio_1 <= 1.000001);
    } else {
        local_9 = false;
    }
    bool _e28 = local_9;
    if (!(_e28)) {
        return NO_ANSWER;
    }
    float r_1 = min(ratio_1, 1.0);
    float r2_1 = (r_1 * r_1);
    vec3 _e34 = wave_vector_change(wi_15, wo_14);
    vec3 q_5 = (r_1 * _e34);
    float _e36 = normalised_abs_w(q_5);
    Ellipse _e38 = ellipse_of((r2_1 * footprint_3));
    float _e39 = diffuse_factor(front_6, wi_15, wo_14);
    float _e40 = expansion_mean(q_5, _e36, _e38);
    float _e41 = cross_mean(q_5, _e36, _e38);
    float diffuse_1 = (_e39 * (_e40 + _e41));
    uint _e46 = _group_0_binding_0_fs.lobe_count;
    if ((_e46 == 0u)) {
        return ((r2_1 * r2_1) * diffuse_1);
    }
    uint _e53 = _group_0_binding_0_fs.of_source;
    bool grows_1 = (_e53 == 1u);
    float _e58 = _group_0_binding_0_fs.shortest_nm;
    float _e63 = _group_0_binding_0_fs.lobe_sigma_nm;
    float width_2 = ((grows_1 ? _e58 : wavelength_nm_4) / (6.2831855 * _e63));
    Ellipse _e67 = ellipse_of(footprint_3);
    LobePlace _e68 = direct_lobe(_e34.xy, _e67);
    float _e69 = lobe_mean(_e68, width_2);
    shape_1 = _e69;
    if ((front_6.factor == VECTOR)) {
        float _e74 = shape_1;
        LobePlace _e75 = image_lobe(wi_15, wo_14, footprint_3);
        float _e76 = lobe_mean(_e75, width_2);
        shape_1 = (_e74 + _e76);
    }
    float _e82 = coherent_factor(front_6, wi_15, wo_14);
    float _e86 = power_at(abs(q_5.z));
    float _e88 = shape_1;
    return (((r2_1 * r2_1) * diffuse_1) + ((((grows_1 ? 1.0 : r2_1) * _e82) * _e86) * _e88));
}

float brdf_spectral_filtered(vec3 wi_16, vec3 wo_15, float wavelength_nm_5, vec3 footprint_4) {
    Front _e4 = front_factor();
    float _e5 = brdf_spectral_filtered_with(_e4, wi_16, wo_15, wavelength_nm_5, footprint_4);
    return _e5;
}

void main() {
    vec3 wi = _vs2fs_location0;
    vec3 wo = _vs2fs_location1;
    float wavelength_nm = _vs2fs_location2;
    vec3 footprint = _vs2fs_location3;
    vec3 to_light = normalize(wi);
    float _e6 = brdf_spectral_filtered(to_light, normalize(wo), wavelength_nm, footprint);
    bool _e7 = has_answer(_e6);
    if (!(_e7)) {
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, 1.0);
        return;
    }
    _fs2p_location0 = vec4((_e6 * max(to_light.z, 0.0)), 1.0, 0.0, 1.0);
    return;
}

