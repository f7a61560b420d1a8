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
struct TableParams {
    uint basis;
    uint table_count;
    uint cross_count;
    uint material;
    uint shadowing;
    float radius_max;
    float index_n;
    float index_k;
    uint restricted;
    float grid_last;
    float first_column;
    float first_row;
    uint factor;
    uint look_up;
    vec2 permittivity;
    vec4 pigment;
    vec4 table_scales[64];
    vec4 cross_scales[64];
};
struct Recurrence {
    float first;
    float second;
    float forward;
    float back;
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
const uint CHEBYSHEV = 0u;
const uint TAYLOR = 1u;
const float RANGE_SLACK = 0.02;
const uint SPLINES = 1u;
const uint LINEAR = 0u;
const uint CHORDS = 14u;
const float PI = 3.1415927;
const float BLUR_SHARE = 0.1835;
const float BLUR_SHARE_MAJOR = 0.05;
const float SPLINE_POINT_MAX = 0.003;
const uint RING = 6u;
const float GAUSSIAN_REACH = 4.55;
const uint LOBE_GAUSSIANS = 8u;
const float LOBE_WIDEST = 0.2197802;
const float LOBE_NARROWEST = 0.1098901;
const float LOBE_PLACES_MAX = 0.6;

layout(std140) uniform TableParams_block_0Fragment { TableParams _group_0_binding_0_fs; };

uniform highp sampler2DArray _group_0_binding_1_fs;

uniform highp sampler2DArray _group_0_binding_2_fs;

uniform highp sampler2D _group_0_binding_3_fs;

uniform highp sampler2D _group_0_binding_5_fs;

smooth in vec3 _vs2fs_location0;
smooth in vec3 _vs2fs_location1;
smooth in vec3 _vs2fs_location2;
layout(location = 0) out vec4 _fs2p_location0;

vec3 wave_vector_change(vec3 wi_1, vec3 wo_1) {
    return (-(wi_1) - wo_1);
}

float geometry_factor(vec3 wi_2, vec3 wo_2) {
    float one_plus = (1.0 + dot(wi_2, wo_2));
    return ((one_plus / wi_2.z) * (one_plus / wo_2.z));
}

float v_cavity_shadowing(vec3 wi_3, vec3 wo_3) {
    vec3 sum_12 = (wi_3 + wo_3);
    vec3 m = (sum_12 / vec3(sqrt(dot(sum_12, sum_12))));
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
    vec2 index = front.index;
    float cos_i = clamp(cos_theta_d, 0.0, 1.0);
    vec2 _e15 = complex_product(index, index);
    vec2 _e16 = complex_quotient(vec2((1.0 - (cos_i * cos_i)), 0.0), _e15);
    vec2 _e21 = complex_root((vec2(1.0, 0.0) - _e16));
    vec2 _e22 = complex_product(index, _e21);
    vec2 along = vec2(cos_i, 0.0);
    vec2 _e27 = complex_quotient((along - _e22), (along + _e22));
    vec2 _e32 = complex_quotient(((index * cos_i) - _e21), ((index * cos_i) + _e21));
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
    float w_3 = (wi_8.z + wo_8.z);
    float _e13 = geometry_factor(wi_8, wo_8);
    return (((mirror * _e13) / w_3) / w_3);
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

Front front_factor() {
    float _e2 = _group_0_binding_0_fs.index_n;
    float _e5 = _group_0_binding_0_fs.index_k;
    vec2 index_1 = vec2(_e2, _e5);
    uint _e9 = _group_0_binding_0_fs.material;
    uint _e12 = _group_0_binding_0_fs.factor;
    uint _e15 = _group_0_binding_0_fs.shadowing;
    vec2 _e18 = _group_0_binding_0_fs.permittivity;
    return Front(_e9, _e12, _e15, index_1, _e18);
}

vec3 pigment_xyz(vec3 wi_10, vec3 wo_10) {
    bool local_1 = false;
    if ((wi_10.z > 0.0)) {
        local_1 = (wo_10.z > 0.0);
    } else {
        local_1 = false;
    }
    bool _e11 = local_1;
    if (!(_e11)) {
        return vec3(0.0, 0.0, 0.0);
    }
    Front _e17 = front_factor();
    float _e19 = reflectance(_e17, wi_10.z);
    float _e23 = reflectance(_e17, wo_10.z);
    vec4 _e29 = _group_0_binding_0_fs.pigment;
    return (((1.0 - _e19) * (1.0 - _e23)) * _e29.xyz);
}

Recurrence shifted_values(float t) {
    float x_2 = ((2.0 * t) - 1.0);
    return Recurrence(1.0, x_2, (2.0 * x_2), 1.0);
}

Recurrence powers(float w) {
    float first = ((1.0 / w) / w);
    return Recurrence(first, (1.0 / w), w, 0.0);
}

vec2 table_place(vec2 at_1) {
    float _e14 = _group_0_binding_0_fs.grid_last;
    vec2 texel_1 = (vec2((0.5 + (0.5 * at_1.x)), (0.5 - (0.5 * at_1.y))) * _e14);
    float _e18 = _group_0_binding_0_fs.first_column;
    float _e21 = _group_0_binding_0_fs.first_row;
    return (((texel_1 - vec2(_e18, _e21)) + vec2(0.5)) / vec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy)));
}

float share_of_range(vec2 at_2, float t_1) {
    bool local_2 = false;
    bool local_3 = false;
    bool local_4 = false;
    bool local_5 = false;
    vec2 _e2 = table_place(at_2);
    vec2 half_texel = (vec2(0.5) / vec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy)));
    uint _e13 = _group_0_binding_0_fs.table_count;
    vec4 _e15 = textureLod(_group_0_binding_1_fs, vec3(_e2, _e13), 0.0);
    vec3 range = _e15.xyz;
    if (all(greaterThan(_e2, (0.99 * half_texel)))) {
        local_2 = all(greaterThan((vec2(1.0) - _e2), (0.99 * half_texel)));
    } else {
        local_2 = false;
    }
    bool inside = local_2;
    float s_1 = ((t_1 - range.x) / (range.y - range.x));
    if (inside) {
        local_3 = (range.z > 0.998);
    } else {
        local_3 = false;
    }
    bool _e44 = local_3;
    if (_e44) {
        local_4 = (s_1 >= -0.02);
    } else {
        local_4 = false;
    }
    bool _e50 = local_4;
    if (_e50) {
        local_5 = (s_1 <= 1.02);
    } else {
        local_5 = false;
    }
    bool _e56 = local_5;
    if (!(_e56)) {
        return -1.0;
    }
    return clamp(s_1, 0.0, 1.0);
}

vec4 spline_texel(SplinePlaces places, uint layer) {
    vec4 a_4 = textureLod(_group_0_binding_1_fs, vec3(places.first, layer), 0.0);
    vec4 b_3 = textureLod(_group_0_binding_1_fs, vec3(vec2(places.second.x, places.first.y), layer), 0.0);
    vec4 c = textureLod(_group_0_binding_1_fs, vec3(vec2(places.first.x, places.second.y), layer), 0.0);
    vec4 d = textureLod(_group_0_binding_1_fs, vec3(places.second, layer), 0.0);
    return mix(mix(d, c, places.share.x), mix(b_3, a_4, places.share.x), places.share.y);
}

vec3 expansion_by_splines(Recurrence basis, SplinePlaces places_1) {
    vec3 sum = vec3(0.0, 0.0, 0.0);
    float now = 0.0;
    float next = 0.0;
    uint n = 0u;
    now = basis.first;
    next = basis.second;
    bool loop_init = true;
    while(true) {
        if (!loop_init) {
            uint _e45 = n;
            n = (_e45 + 1u);
        }
        loop_init = false;
        uint _e13 = n;
        uint _e16 = _group_0_binding_0_fs.table_count;
        if ((_e13 < _e16)) {
        } else {
            break;
        }
        {
            vec3 _e18 = sum;
            float _e19 = now;
            uint _e22 = n;
            uint _e26 = n;
            float _e30 = _group_0_binding_0_fs.table_scales[(_e22 / 4u)][(_e26 % 4u)];
            uint _e32 = n;
            vec4 _e33 = spline_texel(places_1, _e32);
            sum = (_e18 + ((_e19 * _e30) * _e33.xyz));
            float _e38 = next;
            float _e41 = now;
            float after = ((basis.forward * _e38) - (basis.back * _e41));
            float _e44 = next;
            now = _e44;
            next = after;
        }
    }
    vec3 _e48 = sum;
    return _e48;
}

SplinePlaces spline_places(vec2 uv) {
    vec2 size_2 = vec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy));
    vec2 texel_2 = ((uv * size_2) - vec2(0.5));
    vec2 whole = floor(texel_2);
    vec2 f = (texel_2 - whole);
    vec2 g = (vec2(1.0) - f);
    vec2 before = (((g * g) * g) / vec2(6.0));
    vec2 last_1 = (((f * f) * f) / vec2(6.0));
    vec2 nearest = ((vec2(0.6666667) - (f * f)) + (3.0 * last_1));
    vec2 share = (before + nearest);
    vec2 first_1 = ((whole - vec2(1.0)) + (nearest / share));
    vec2 second = ((whole + vec2(1.0)) + (last_1 / (vec2(1.0) - share)));
    return SplinePlaces(((first_1 + vec2(0.5)) / size_2), ((second + vec2(0.5)) / size_2), share);
}

vec3 expansion(Recurrence basis_1, vec2 at_3) {
    vec3 sum_1 = vec3(0.0, 0.0, 0.0);
    float now_1 = 0.0;
    float next_1 = 0.0;
    uint n_1 = 0u;
    vec2 _e2 = table_place(at_3);
    uint _e5 = _group_0_binding_0_fs.look_up;
    if ((_e5 == SPLINES)) {
        SplinePlaces _e8 = spline_places(_e2);
        vec3 _e9 = expansion_by_splines(basis_1, _e8);
        return _e9;
    }
    now_1 = basis_1.first;
    next_1 = basis_1.second;
    bool loop_init_1 = true;
    while(true) {
        if (!loop_init_1) {
            uint _e56 = n_1;
            n_1 = (_e56 + 1u);
        }
        loop_init_1 = false;
        uint _e21 = n_1;
        uint _e24 = _group_0_binding_0_fs.table_count;
        if ((_e21 < _e24)) {
        } else {
            break;
        }
        {
            uint _e28 = n_1;
            vec4 _e30 = textureLod(_group_0_binding_1_fs, vec3(_e2, _e28), 0.0);
            vec3 texel_3 = _e30.xyz;
            vec3 _e32 = sum_1;
            float _e33 = now_1;
            uint _e36 = n_1;
            uint _e40 = n_1;
            float _e44 = _group_0_binding_0_fs.table_scales[(_e36 / 4u)][(_e40 % 4u)];
            sum_1 = (_e32 + ((_e33 * _e44) * texel_3));
            float _e49 = next_1;
            float _e52 = now_1;
            float after_1 = ((basis_1.forward * _e49) - (basis_1.back * _e52));
            float _e55 = next_1;
            now_1 = _e55;
            next_1 = after_1;
        }
    }
    vec3 _e59 = sum_1;
    return _e59;
}

vec4 lagrange_weights(float x) {
    float a_5 = (x - 1.0);
    float b_4 = (x - 2.0);
    float c_1 = (x - 3.0);
    return vec4((((-(a_5) * b_4) * c_1) / 6.0), (((0.5 * x) * b_4) * c_1), (((-0.5 * x) * a_5) * c_1), (((x * a_5) * b_4) / 6.0));
}

vec4 cross_texel(vec2 uv_1, uint layer_1) {
    bool local_6 = false;
    vec4 sum_2 = vec4(0.0, 0.0, 0.0, 0.0);
    int k = 0;
    ivec2 size_3 = ivec2(uvec2(textureSize(_group_0_binding_2_fs, 0).xy));
    uint _e7 = _group_0_binding_0_fs.look_up;
    if (!((_e7 == LINEAR))) {
        local_6 = (min(size_3.x, size_3.y) < 4);
    } else {
        local_6 = true;
    }
    bool _e19 = local_6;
    if (_e19) {
        vec4 _e23 = textureLod(_group_0_binding_2_fs, vec3(uv_1, layer_1), 0.0);
        return _e23;
    }
    vec2 at_12 = clamp(((uv_1 * vec2(size_3)) - vec2(0.5)), vec2(0.0, 0.0), vec2((size_3 - ivec2(1))));
    ivec2 first_2 = min(max((ivec2(at_12) - ivec2(1)), ivec2(0, 0)), (size_3 - ivec2(4)));
    vec4 _e52 = lagrange_weights((at_12.x - float(first_2.x)));
    vec4 _e57 = lagrange_weights((at_12.y - float(first_2.y)));
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
            vec4 texel_4 = texelFetch(_group_0_binding_2_fs, ivec3((first_2 + ivec2((_e70 % 4), (_e73 / 4))), int(layer_1)), 0);
            vec4 _e81 = sum_2;
            int _e82 = k;
            int _e86 = k;
            sum_2 = (_e81 + ((_e52[(_e82 % 4)] * _e57[(_e86 / 4)]) * texel_4));
        }
    }
    vec4 _e96 = sum_2;
    return _e96;
}

vec3 cross_expansion(Recurrence basis_2, vec2 at_4) {
    vec3 sum_3 = vec3(0.0, 0.0, 0.0);
    float now_2 = 0.0;
    float next_2 = 0.0;
    uint n_2 = 0u;
    vec2 _e4 = texel_centred(at_4, uvec2(textureSize(_group_0_binding_2_fs, 0).xy));
    now_2 = basis_2.first;
    next_2 = basis_2.second;
    bool loop_init_3 = true;
    while(true) {
        if (!loop_init_3) {
            uint _e48 = n_2;
            n_2 = (_e48 + 1u);
        }
        loop_init_3 = false;
        uint _e16 = n_2;
        uint _e19 = _group_0_binding_0_fs.cross_count;
        if ((_e16 < _e19)) {
        } else {
            break;
        }
        {
            uint _e21 = n_2;
            vec4 _e22 = cross_texel(_e4, _e21);
            vec3 texel_5 = _e22.xyz;
            vec3 _e24 = sum_3;
            float _e25 = now_2;
            uint _e28 = n_2;
            uint _e32 = n_2;
            float _e36 = _group_0_binding_0_fs.cross_scales[(_e28 / 4u)][(_e32 % 4u)];
            sum_3 = (_e24 + ((_e25 * _e36) * texel_5));
            float _e41 = next_2;
            float _e44 = now_2;
            float after_2 = ((basis_2.forward * _e41) - (basis_2.back * _e44));
            float _e47 = next_2;
            now_2 = _e47;
            next_2 = after_2;
        }
    }
    vec3 _e51 = sum_3;
    return _e51;
}

vec3 cross_value(vec3 q_1, float t_2) {
    bool local_7 = false;
    uint _e4 = _group_0_binding_0_fs.cross_count;
    if (!((_e4 == 0u))) {
        float _e17 = _group_0_binding_0_fs.radius_max;
        local_7 = (max(abs(q_1.x), abs(q_1.y)) >= _e17);
    } else {
        local_7 = true;
    }
    bool _e20 = local_7;
    if (_e20) {
        return vec3(0.0, 0.0, 0.0);
    }
    Recurrence _e25 = shifted_values(t_2);
    float _e29 = _group_0_binding_0_fs.radius_max;
    vec3 _e32 = cross_expansion(_e25, (q_1.xy / vec2(_e29)));
    return (_e32 / vec3(abs(q_1.z)));
}

vec3 sample_cubic(vec2 at_5, ivec2 last) {
    vec3 sum_4 = vec3(0.0, 0.0, 0.0);
    int k_1 = 0;
    ivec2 first_3 = min(max((ivec2(at_5) - ivec2(1)), ivec2(0, 0)), (last - ivec2(3)));
    vec4 _e17 = lagrange_weights((at_5.x - float(first_3.x)));
    vec4 _e22 = lagrange_weights((at_5.y - float(first_3.y)));
    bool loop_init_4 = true;
    while(true) {
        if (!loop_init_4) {
            int _e60 = k_1;
            k_1 = (_e60 + 1);
        }
        loop_init_4 = false;
        int _e30 = k_1;
        if ((_e30 < 16)) {
        } else {
            break;
        }
        {
            int _e35 = k_1;
            int _e40 = k_1;
            vec4 _e46 = texelFetch(_group_0_binding_3_fs, ivec2((first_3.y + (_e35 % 4)), (first_3.x + (_e40 / 4))), 0);
            vec3 texel_6 = _e46.xyz;
            vec3 _e48 = sum_4;
            int _e49 = k_1;
            int _e53 = k_1;
            sum_4 = (_e48 + ((_e22[(_e49 % 4)] * _e17[(_e53 / 4)]) * texel_6));
        }
    }
    vec3 _e63 = sum_4;
    return _e63;
}

vec3 sample_(vec2 at_6) {
    bool local_8 = false;
    ivec2 last_2 = (ivec2(uvec2(textureSize(_group_0_binding_3_fs, 0).xy)).yx - ivec2(1));
    uint _e10 = _group_0_binding_0_fs.look_up;
    if ((_e10 == SPLINES)) {
        local_8 = (min(last_2.x, last_2.y) >= 3);
    } else {
        local_8 = false;
    }
    bool _e21 = local_8;
    if (_e21) {
        vec3 _e27 = sample_cubic(clamp(at_6, vec2(0.0, 0.0), vec2(last_2)), last_2);
        return _e27;
    }
    vec2 inside_1 = clamp(at_6, vec2(0.0, 0.0), vec2(last_2));
    ivec2 first_4 = max(min(ivec2(inside_1), (last_2 - ivec2(1))), ivec2(0, 0));
    ivec2 second_1 = min((first_4 + ivec2(1)), last_2);
    vec2 share_1 = (inside_1 - vec2(first_4));
    vec4 _e53 = texelFetch(_group_0_binding_3_fs, ivec2(first_4.y, first_4.x), 0);
    vec4 _e60 = texelFetch(_group_0_binding_3_fs, ivec2(second_1.y, first_4.x), 0);
    vec3 low_1 = mix(_e53.xyz, _e60.xyz, share_1.y);
    vec4 _e69 = texelFetch(_group_0_binding_3_fs, ivec2(first_4.y, second_1.x), 0);
    vec4 _e76 = texelFetch(_group_0_binding_3_fs, ivec2(second_1.y, second_1.x), 0);
    vec3 high_1 = mix(_e69.xyz, _e76.xyz, share_1.y);
    return mix(low_1, high_1, share_1.x);
}

vec3 lobe_at(float radius, float w_1) {
    float _e4 = _group_0_binding_0_fs.radius_max;
    if ((radius >= _e4)) {
        return vec3(0.0, 0.0, 0.0);
    }
    vec2 last_3 = (vec2(uvec2(textureSize(_group_0_binding_3_fs, 0).xy)) - vec2(1.0));
    float _e18 = normalised_abs_w(vec3(radius, 0.0, w_1));
    float _e23 = _group_0_binding_0_fs.radius_max;
    vec3 _e28 = sample_(vec2((_e18 * last_3.y), ((radius / _e23) * last_3.x)));
    return _e28;
}

vec3 coherent_value(vec3 wi_11, vec3 wo_11, vec3 q_2) {
    vec3 value = vec3(0.0);
    float radius_3 = length(q_2.xy);
    float _e7 = _group_0_binding_0_fs.radius_max;
    if ((radius_3 >= _e7)) {
        return vec3(0.0, 0.0, 0.0);
    }
    vec3 _e14 = lobe_at(radius_3, q_2.z);
    value = _e14;
    uint _e18 = _group_0_binding_0_fs.factor;
    if ((_e18 == VECTOR)) {
        vec3 _e21 = value;
        float _e22 = image_radius2_(wi_11, wo_11);
        vec3 _e25 = lobe_at(sqrt(_e22), q_2.z);
        value = (_e21 + _e25);
    }
    Front _e27 = front_factor();
    float _e28 = coherent_factor(_e27, wi_11, wo_11);
    vec3 _e29 = value;
    return (_e28 * _e29);
}

vec3 brdf_xyz(vec3 wi_12, vec3 wo_12) {
    bool local_9 = false;
    float s = 0.0;
    Recurrence basis_3 = Recurrence(0.0, 0.0, 0.0, 0.0);
    if ((wi_12.z > 0.0)) {
        local_9 = (wo_12.z > 0.0);
    } else {
        local_9 = false;
    }
    bool _e11 = local_9;
    if (!(_e11)) {
        return vec3(0.0, 0.0, 0.0);
    }
    vec3 _e17 = wave_vector_change(wi_12, wo_12);
    float _e18 = normalised_abs_w(_e17);
    vec2 at_13 = (0.5 * _e17.xy);
    s = _e18;
    uint _e25 = _group_0_binding_0_fs.restricted;
    if ((_e25 != 0u)) {
        float _e28 = share_of_range(at_13, _e18);
        s = _e28;
        float _e29 = s;
        if ((_e29 < 0.0)) {
            return vec3(-1.0, -1.0, -1.0);
        }
    }
    float _e36 = s;
    Recurrence _e37 = shifted_values(_e36);
    basis_3 = _e37;
    uint _e41 = _group_0_binding_0_fs.basis;
    if ((_e41 == TAYLOR)) {
        Recurrence _e46 = powers(abs(_e17.z));
        basis_3 = _e46;
    }
    Front _e47 = front_factor();
    float _e48 = diffuse_factor(_e47, wi_12, wo_12);
    Recurrence _e49 = basis_3;
    vec3 _e50 = expansion(_e49, at_13);
    vec3 _e51 = cross_value(_e17, _e18);
    vec3 diffuse = (_e48 * (_e50 + _e51));
    vec3 _e54 = coherent_value(wi_12, wo_12, _e17);
    return (diffuse + _e54);
}

bool has_answer(vec3 xyz) {
    bool local_10 = false;
    bool local_11 = false;
    if ((xyz.x == NO_ANSWER)) {
        local_10 = (xyz.y == NO_ANSWER);
    } else {
        local_10 = false;
    }
    bool _e10 = local_10;
    if (_e10) {
        local_11 = (xyz.z == NO_ANSWER);
    } else {
        local_11 = false;
    }
    bool _e17 = local_11;
    return !(_e17);
}

vec3 surface_xyz(vec3 wi_13, vec3 wo_13) {
    bool local_12 = false;
    vec3 _e2 = brdf_xyz(wi_13, wo_13);
    float _e6 = _group_0_binding_0_fs.pigment.w;
    if (!((_e6 == 0.0))) {
        bool _e12 = has_answer(_e2);
        local_12 = !(_e12);
    } else {
        local_12 = true;
    }
    bool _e15 = local_12;
    if (_e15) {
        return _e2;
    }
    vec3 _e16 = pigment_xyz(wi_13, wo_13);
    return (_e2 + _e16);
}

vec3 xyz_to_linear_srgb(vec3 xyz_1) {
    return vec3(dot(vec3(3.2404542, -1.5371385, -0.4985314), xyz_1), dot(vec3(-0.969266, 1.8760108, 0.041556), xyz_1), dot(vec3(0.0556434, -0.2040259, 1.0572252), xyz_1));
}

vec3 footprint_of_light(vec3 wi_14, float angular_radius) {
    float sine = sin(angular_radius);
    return (((0.25 * sine) * sine) * vec3((1.0 - (wi_14.x * wi_14.x)), (-(wi_14.x) * wi_14.y), (1.0 - (wi_14.y * wi_14.y))));
}

vec3 footprint_of_normals(vec3 wi_15, vec3 wo_14, vec3 normals) {
    float w_4 = (wi_15.z + wo_14.z);
    return ((w_4 * w_4) * normals);
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
    float share_2 = min((blur / max(sqrt((variances.x * variances.y)), 1e-20)), BLUR_SHARE);
    float rest = (1.0 - share_2);
    float ring = min((((4.0 * rest) * rest) / ((5.3333335 - ((16.0 * share_2) * rest)) - ((8.0 * share_2) * share_2))), 1.0);
    vec2 axes = (sqrt(((2.0 * max((variances - vec2(blur)), vec2(0.0, 0.0))) / vec2(ring))) / vec2(texels_per_unit));
    return Taps(level_2, (1.0 - ring), (axes.x * ellipse.axis), (axes.y * vec2(-(ellipse.axis.y), ellipse.axis.x)));
}

Ellipse for_coefficients(Ellipse ellipse_1, float texels_per_unit_1) {
    return Ellipse(ellipse_1.axis, (ellipse_1.variances + vec2((1.0 / ((6.0 * texels_per_unit_1) * texels_per_unit_1)))));
}

vec2 next_of_ring(vec2 at_7) {
    return vec2(((0.5 * at_7.x) - (0.8660254 * at_7.y)), ((0.8660254 * at_7.x) + (0.5 * at_7.y)));
}

float coarsest_level(uvec2 size_1) {
    return max(floor(log2((0.25 * float(min(size_1.x, size_1.y))))), 0.0);
}

LobePlace direct_lobe(vec2 at_8, Ellipse ellipse_2) {
    vec2 axis_1 = ellipse_2.axis;
    return LobePlace(vec2(dot(at_8, axis_1), ((at_8.y * axis_1.x) - (at_8.x * axis_1.y))), (2.0 * sqrt(ellipse_2.variances)));
}

LobePlace image_lobe(vec3 wi_16, vec3 wo_15, vec3 footprint_2) {
    vec2 e = vec2(1.0, 0.0);
    vec2 difference_1 = (wo_15.xy - wi_16.xy);
    float apart = length(difference_1);
    if ((apart > 0.0)) {
        e = (difference_1 / vec2(apart));
    }
    vec2 sum_13 = (wi_16.xy + wo_15.xy);
    float _e20 = e.x;
    float _e24 = e.y;
    float along_1 = ((sum_13.y * _e20) - (sum_13.x * _e24));
    float _e27 = image_radius2_(wi_16, wo_15);
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

float erfc(float x_1) {
    float p = 0.17087276;
    float t_5 = (1.0 / (1.0 + (0.5 * x_1)));
    float _e9 = p;
    p = (-0.82215226 + (t_5 * _e9));
    float _e13 = p;
    p = (1.4885159 + (t_5 * _e13));
    float _e17 = p;
    p = (-1.135204 + (t_5 * _e17));
    float _e21 = p;
    p = (0.27886808 + (t_5 * _e21));
    float _e25 = p;
    p = (-0.18628806 + (t_5 * _e25));
    float _e29 = p;
    p = (0.09678418 + (t_5 * _e29));
    float _e33 = p;
    p = (0.37409195 + (t_5 * _e33));
    float _e37 = p;
    p = (1.0000237 + (t_5 * _e37));
    float _e45 = p;
    return (t_5 * exp((((-(x_1) * x_1) - 1.2655122) + (t_5 * _e45))));
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
    float sum_5 = 0.0;
    uint k_2 = 0u;
    float reach_2 = (GAUSSIAN_REACH * width);
    vec2 _e9 = within(place_1.centre.y, place_1.semi_axes.y, reach_2, 1.0);
    float middle_2 = (0.5 * (_e9.x + _e9.y));
    float half_length = (0.5 * (_e9.y - _e9.x));
    if ((half_length <= 0.0)) {
        return 0.0;
    }
    bool loop_init_5 = true;
    while(true) {
        if (!loop_init_5) {
            uint _e87 = k_2;
            k_2 = (_e87 + 1u);
        }
        loop_init_5 = false;
        uint _e28 = k_2;
        if ((_e28 < CHORDS)) {
        } else {
            break;
        }
        {
            uint _e31 = k_2;
            float angle = (float((_e31 + 1u)) * 0.20943952);
            float eta = (middle_2 - (half_length * cos(angle)));
            float y = (place_1.centre.y + (place_1.semi_axes.y * eta));
            float chord = sqrt(max((1.0 - (eta * eta)), 0.0));
            vec2 _e61 = within(place_1.centre.x, place_1.semi_axes.x, sqrt(max(((reach_2 * reach_2) - (y * y)), 0.0)), chord);
            vec2 lateral_1 = ((vec2(place_1.centre.x) + (place_1.semi_axes.x * _e61)) / vec2(width));
            float off = (y / width);
            float _e72 = sum_5;
            float _e84 = gaussian_between(lateral_1.x, lateral_1.y);
            sum_5 = (_e72 + (((sin(angle) * (_e61.y - _e61.x)) * exp((-(off) * off))) * _e84));
        }
    }
    float _e90 = sum_5;
    return (((_e90 * half_length) * 0.20943952) / PI);
}

vec3 expansion_on(Recurrence basis_4, vec2 at_9, float level) {
    vec3 sum_6 = vec3(0.0, 0.0, 0.0);
    float now_3 = 0.0;
    float next_3 = 0.0;
    uint n_3 = 0u;
    vec2 _e3 = table_place(at_9);
    now_3 = basis_4.first;
    next_3 = basis_4.second;
    bool loop_init_6 = true;
    while(true) {
        if (!loop_init_6) {
            uint _e49 = n_3;
            n_3 = (_e49 + 1u);
        }
        loop_init_6 = false;
        uint _e15 = n_3;
        uint _e18 = _group_0_binding_0_fs.table_count;
        if ((_e15 < _e18)) {
        } else {
            break;
        }
        {
            uint _e22 = n_3;
            vec4 _e23 = textureLod(_group_0_binding_1_fs, vec3(_e3, _e22), level);
            vec3 texel_7 = _e23.xyz;
            vec3 _e25 = sum_6;
            float _e26 = now_3;
            uint _e29 = n_3;
            uint _e33 = n_3;
            float _e37 = _group_0_binding_0_fs.table_scales[(_e29 / 4u)][(_e33 % 4u)];
            sum_6 = (_e25 + ((_e26 * _e37) * texel_7));
            float _e42 = next_3;
            float _e45 = now_3;
            float after_3 = ((basis_4.forward * _e42) - (basis_4.back * _e45));
            float _e48 = next_3;
            now_3 = _e48;
            next_3 = after_3;
        }
    }
    vec3 _e52 = sum_6;
    return _e52;
}

vec3 tables_mean(vec3 q_3, float t_3, Ellipse ellipse_3) {
    float level_max_1 = 0.0;
    Taps taps = Taps(0.0, 0.0, vec2(0.0), vec2(0.0));
    Recurrence basis_5 = Recurrence(0.0, 0.0, 0.0, 0.0);
    bool local_13 = false;
    vec3 sum_7 = vec3(0.0, 0.0, 0.0);
    vec2 place_2 = vec2(0.0, 0.0);
    float weight = 0.0;
    uint k_3 = 0u;
    vec2 at_10 = vec2(0.0);
    uint _e7 = _group_0_binding_0_fs.restricted;
    if ((_e7 == 0u)) {
        float _e12 = coarsest_level(uvec2(textureSize(_group_0_binding_1_fs, 0).xy));
        level_max_1 = _e12;
    }
    float _e15 = _group_0_binding_0_fs.grid_last;
    float texels_per_unit_2 = (0.25 * _e15);
    float _e18 = level_max_1;
    Taps _e19 = taps_of(ellipse_3, texels_per_unit_2, _e18);
    taps = _e19;
    Recurrence _e21 = shifted_values(t_3);
    basis_5 = _e21;
    uint _e25 = _group_0_binding_0_fs.basis;
    if ((_e25 == TAYLOR)) {
        Recurrence _e30 = powers(abs(q_3.z));
        basis_5 = _e30;
    }
    uint _e33 = _group_0_binding_0_fs.look_up;
    if ((_e33 == SPLINES)) {
        float _e39 = taps.level;
        local_13 = (_e39 == 0.0);
    } else {
        local_13 = false;
    }
    bool _e43 = local_13;
    if (_e43) {
        if ((((ellipse_3.variances.x * texels_per_unit_2) * texels_per_unit_2) < SPLINE_POINT_MAX)) {
            Recurrence _e50 = basis_5;
            vec3 _e54 = expansion(_e50, (0.5 * q_3.xy));
            return _e54;
        }
        Ellipse _e55 = for_coefficients(ellipse_3, texels_per_unit_2);
        Taps _e57 = taps_of(_e55, texels_per_unit_2, 0.0);
        taps = _e57;
    }
    float _e68 = taps.centre;
    weight = _e68;
    bool loop_init_7 = true;
    while(true) {
        if (!loop_init_7) {
            uint _e140 = k_3;
            k_3 = (_e140 + 1u);
        }
        loop_init_7 = false;
        uint _e72 = k_3;
        if ((_e72 <= RING)) {
        } else {
            break;
        }
        {
            float _e77 = place_2.x;
            vec2 _e79 = taps.along;
            float _e83 = place_2.y;
            vec2 _e85 = taps.across;
            at_10 = ((q_3.xy + (_e77 * _e79)) + (_e83 * _e85));
            vec2 _e89 = at_10;
            vec2 _e90 = at_10;
            at_10 = (_e89 * min(1.0, (2.0 / max(length(_e90), 1e-20))));
            uint _e101 = _group_0_binding_0_fs.restricted;
            if ((_e101 != 0u)) {
                vec2 _e104 = at_10;
                float _e107 = share_of_range((0.5 * _e104), t_3);
                if ((_e107 < 0.0)) {
                    return vec3(-1.0, -1.0, -1.0);
                }
                Recurrence _e114 = shifted_values(_e107);
                basis_5 = _e114;
            }
            vec3 _e115 = sum_7;
            float _e116 = weight;
            Recurrence _e117 = basis_5;
            vec2 _e118 = at_10;
            float _e122 = taps.level;
            vec3 _e123 = expansion_on(_e117, (0.5 * _e118), _e122);
            sum_7 = (_e115 + (_e116 * _e123));
            float _e127 = taps.centre;
            weight = ((1.0 - _e127) / 6.0);
            uint _e132 = k_3;
            if ((_e132 == 0u)) {
                place_2 = vec2(1.0, 0.0);
            } else {
                vec2 _e138 = place_2;
                vec2 _e139 = next_of_ring(_e138);
                place_2 = _e139;
            }
        }
    }
    vec3 _e143 = sum_7;
    return _e143;
}

vec3 cross_expansion_on(Recurrence basis_6, vec2 at_11, float level_1) {
    vec3 sum_8 = vec3(0.0, 0.0, 0.0);
    float now_4 = 0.0;
    float next_4 = 0.0;
    uint n_4 = 0u;
    vec2 _e5 = texel_centred(at_11, uvec2(textureSize(_group_0_binding_2_fs, 0).xy));
    now_4 = basis_6.first;
    next_4 = basis_6.second;
    bool loop_init_8 = true;
    while(true) {
        if (!loop_init_8) {
            uint _e51 = n_4;
            n_4 = (_e51 + 1u);
        }
        loop_init_8 = false;
        uint _e17 = n_4;
        uint _e20 = _group_0_binding_0_fs.cross_count;
        if ((_e17 < _e20)) {
        } else {
            break;
        }
        {
            uint _e24 = n_4;
            vec4 _e25 = textureLod(_group_0_binding_2_fs, vec3(_e5, _e24), level_1);
            vec3 texel_8 = _e25.xyz;
            vec3 _e27 = sum_8;
            float _e28 = now_4;
            uint _e31 = n_4;
            uint _e35 = n_4;
            float _e39 = _group_0_binding_0_fs.cross_scales[(_e31 / 4u)][(_e35 % 4u)];
            sum_8 = (_e27 + ((_e28 * _e39) * texel_8));
            float _e44 = next_4;
            float _e47 = now_4;
            float after_4 = ((basis_6.forward * _e44) - (basis_6.back * _e47));
            float _e50 = next_4;
            now_4 = _e50;
            next_4 = after_4;
        }
    }
    vec3 _e54 = sum_8;
    return _e54;
}

vec3 cross_mean(vec3 q_4, float t_4, Ellipse ellipse_4) {
    vec3 sum_9 = vec3(0.0, 0.0, 0.0);
    bool local_14 = false;
    vec2 place_3 = vec2(0.0, 0.0);
    float weight_1 = 0.0;
    uint k_4 = 0u;
    float _e15 = _group_0_binding_0_fs.radius_max;
    float reach_3 = ((2.0 * sqrt(ellipse_4.variances.x)) + _e15);
    uint _e19 = _group_0_binding_0_fs.cross_count;
    if (!((_e19 == 0u))) {
        local_14 = (max(abs(q_4.x), abs(q_4.y)) >= reach_3);
    } else {
        local_14 = true;
    }
    bool _e32 = local_14;
    if (_e32) {
        vec3 _e33 = sum_9;
        return _e33;
    }
    uvec2 size_4 = uvec2(textureSize(_group_0_binding_2_fs, 0).xy);
    float _e44 = _group_0_binding_0_fs.radius_max;
    float _e46 = coarsest_level(size_4);
    Taps _e47 = taps_of(ellipse_4, ((0.5 * (float(size_4.x) - 1.0)) / _e44), _e46);
    Recurrence _e48 = shifted_values(t_4);
    weight_1 = _e47.centre;
    bool loop_init_9 = true;
    while(true) {
        if (!loop_init_9) {
            uint _e102 = k_4;
            k_4 = (_e102 + 1u);
        }
        loop_init_9 = false;
        uint _e57 = k_4;
        if ((_e57 <= RING)) {
        } else {
            break;
        }
        {
            float _e62 = place_3.x;
            float _e67 = place_3.y;
            float _e73 = _group_0_binding_0_fs.radius_max;
            vec2 at_14 = (((q_4.xy + (_e62 * _e47.along)) + (_e67 * _e47.across)) / vec2(_e73));
            if ((max(abs(at_14.x), abs(at_14.y)) < 1.0)) {
                vec3 _e83 = sum_9;
                float _e84 = weight_1;
                vec3 _e86 = cross_expansion_on(_e48, at_14, _e47.level);
                sum_9 = (_e83 + (_e84 * _e86));
            }
            weight_1 = ((1.0 - _e47.centre) / 6.0);
            uint _e94 = k_4;
            if ((_e94 == 0u)) {
                place_3 = vec2(1.0, 0.0);
            } else {
                vec2 _e100 = place_3;
                vec2 _e101 = next_of_ring(_e100);
                place_3 = _e101;
            }
        }
    }
    vec3 _e105 = sum_9;
    return (_e105 / vec3(abs(q_4.z)));
}

vec3 lobe_by_gaussians(LobePlace place_4, float row) {
    vec3 sum_10 = vec3(0.0, 0.0, 0.0);
    uint k_5 = 0u;
    int last_4 = (int(uvec2(textureSize(_group_0_binding_3_fs, 0).xy).y) - 1);
    int first_5 = max(min(int(row), (last_4 - 1)), 0);
    float share_3 = clamp((row - float(first_5)), 0.0, 1.0);
    bool loop_init_10 = true;
    while(true) {
        if (!loop_init_10) {
            uint _e63 = k_5;
            k_5 = (_e63 + 1u);
        }
        loop_init_10 = false;
        uint _e26 = k_5;
        if ((_e26 < LOBE_GAUSSIANS)) {
        } else {
            break;
        }
        {
            uint _e30 = k_5;
            vec4 _e34 = texelFetch(_group_0_binding_5_fs, ivec2(int(_e30), first_5), 0);
            vec3 low_2 = _e34.xyz;
            uint _e37 = k_5;
            vec4 _e44 = texelFetch(_group_0_binding_5_fs, ivec2(int(_e37), min((first_5 + 1), last_4)), 0);
            vec3 high_2 = _e44.xyz;
            float _e48 = _group_0_binding_0_fs.radius_max;
            uint _e51 = k_5;
            float width_1 = ((_e48 * LOBE_WIDEST) * exp2((-(float(_e51)) / 7.0)));
            vec3 _e58 = sum_10;
            float _e59 = gaussian_mean(place_4, width_1);
            sum_10 = (_e58 + (_e59 * mix(low_2, high_2, share_3)));
        }
    }
    vec3 _e66 = sum_10;
    return max(_e66, vec3(0.0, 0.0, 0.0));
}

vec3 profile_at(float row_1, float radius_1) {
    float _e4 = _group_0_binding_0_fs.radius_max;
    if ((radius_1 >= _e4)) {
        return vec3(0.0, 0.0, 0.0);
    }
    float _e12 = _group_0_binding_0_fs.radius_max;
    vec3 _e22 = sample_(vec2(row_1, ((radius_1 / _e12) * float((uvec2(textureSize(_group_0_binding_3_fs, 0).xy).x - 1u)))));
    return _e22;
}

vec3 lobe_by_places(LobePlace place_5, float row_2) {
    vec3 sum_11 = vec3(0.0, 0.0, 0.0);
    uint k_6 = 0u;
    float radius_2 = 0.0;
    float weight_2 = 0.0;
    bool loop_init_11 = true;
    while(true) {
        if (!loop_init_11) {
            uint _e56 = k_6;
            k_6 = (_e56 + 1u);
        }
        loop_init_11 = false;
        uint _e9 = k_6;
        if ((_e9 < 24u)) {
        } else {
            break;
        }
        {
            uint _e12 = k_6;
            uint ring_1 = (_e12 / 8u);
            radius_2 = 0.70710677;
            weight_2 = 0.055555556;
            if ((ring_1 != 1u)) {
                radius_2 = ((ring_1 == 0u) ? 0.3357107 : 0.94196516);
                weight_2 = 0.034722224;
            }
            uint _e27 = k_6;
            float angle_1 = (((float((_e27 % 8u)) + (0.5 * float((ring_1 % 2u)))) * 0.25) * PI);
            float _e42 = radius_2;
            vec2 at_15 = (place_5.centre + ((_e42 * vec2(cos(angle_1), sin(angle_1))) * place_5.semi_axes));
            vec3 _e50 = sum_11;
            float _e51 = weight_2;
            vec3 _e53 = profile_at(row_2, length(at_15));
            sum_11 = (_e50 + (_e51 * _e53));
        }
    }
    vec3 _e59 = sum_11;
    return _e59;
}

vec3 lobe_mean(LobePlace place_6, float w_2) {
    vec3 zero = vec3(0.0, 0.0, 0.0);
    float _e8 = _group_0_binding_0_fs.radius_max;
    bool _e9 = reaches(place_6, _e8);
    if (!(_e9)) {
        return zero;
    }
    uint rows = uvec2(textureSize(_group_0_binding_3_fs, 0).xy).y;
    float _e18 = normalised_abs_w(vec3(length(place_6.centre), 0.0, w_2));
    float row_3 = (_e18 * float((rows - 1u)));
    float longest = max(place_6.semi_axes.x, place_6.semi_axes.y);
    float _e31 = _group_0_binding_0_fs.radius_max;
    if ((longest > (0.06593406 * _e31))) {
        vec3 _e34 = lobe_by_gaussians(place_6, row_3);
        return _e34;
    }
    if ((longest == 0.0)) {
        vec3 _e39 = profile_at(row_3, length(place_6.centre));
        return _e39;
    }
    vec3 _e40 = lobe_by_places(place_6, row_3);
    return _e40;
}

vec3 brdf_xyz_filtered(vec3 wi_17, vec3 wo_16, vec3 footprint_3) {
    bool local_15 = false;
    vec3 shape = vec3(0.0);
    if ((wi_17.z > 0.0)) {
        local_15 = (wo_16.z > 0.0);
    } else {
        local_15 = false;
    }
    bool _e12 = local_15;
    if (!(_e12)) {
        return vec3(0.0, 0.0, 0.0);
    }
    vec3 _e18 = wave_vector_change(wi_17, wo_16);
    float _e19 = normalised_abs_w(_e18);
    Ellipse _e20 = ellipse_of(footprint_3);
    vec3 _e21 = tables_mean(_e18, _e19, _e20);
    bool _e22 = has_answer(_e21);
    if (!(_e22)) {
        return _e21;
    }
    Front _e24 = front_factor();
    float _e25 = diffuse_factor(_e24, wi_17, wo_16);
    vec3 _e26 = cross_mean(_e18, _e19, _e20);
    vec3 diffuse_1 = (_e25 * (_e21 + _e26));
    LobePlace _e30 = direct_lobe(_e18.xy, _e20);
    vec3 _e32 = lobe_mean(_e30, _e18.z);
    shape = _e32;
    uint _e36 = _group_0_binding_0_fs.factor;
    if ((_e36 == VECTOR)) {
        vec3 _e39 = shape;
        LobePlace _e40 = image_lobe(wi_17, wo_16, footprint_3);
        vec3 _e42 = lobe_mean(_e40, _e18.z);
        shape = (_e39 + _e42);
    }
    Front _e44 = front_factor();
    float _e45 = coherent_factor(_e44, wi_17, wo_16);
    vec3 _e46 = shape;
    return (diffuse_1 + (_e45 * _e46));
}

vec3 surface_xyz_filtered(vec3 wi_18, vec3 wo_17, vec3 footprint_4) {
    bool local_16 = false;
    vec3 _e3 = brdf_xyz_filtered(wi_18, wo_17, footprint_4);
    float _e7 = _group_0_binding_0_fs.pigment.w;
    if (!((_e7 == 0.0))) {
        bool _e13 = has_answer(_e3);
        local_16 = !(_e13);
    } else {
        local_16 = true;
    }
    bool _e16 = local_16;
    if (_e16) {
        return _e3;
    }
    vec3 _e17 = pigment_xyz(wi_18, wo_17);
    return (_e3 + _e17);
}

void main() {
    vec3 wi = _vs2fs_location0;
    vec3 wo = _vs2fs_location1;
    vec3 footprint = _vs2fs_location2;
    vec3 to_light = normalize(wi);
    vec3 _e5 = surface_xyz_filtered(to_light, normalize(wo), footprint);
    bool _e6 = has_answer(_e5);
    if (!(_e6)) {
        _fs2p_location0 = vec4(1.0, 0.0, 1.0, 1.0);
        return;
    }
    vec3 _e17 = xyz_to_linear_srgb((_e5 * max(to_light.z, 0.0)));
    _fs2p_location0 = vec4(_e17, 1.0);
    return;
}

