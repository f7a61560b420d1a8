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

layout(std140) uniform TableParams_block_0Fragment { TableParams _group_0_binding_0_fs; };

uniform highp sampler2DArray _group_0_binding_1_fs;

uniform highp sampler2DArray _group_0_binding_2_fs;

uniform highp sampler2D _group_0_binding_3_fs;

smooth in vec3 _vs2fs_location0;
smooth in vec3 _vs2fs_location1;
layout(location = 0) out vec4 _fs2p_location0;

vec3 wave_vector_change(vec3 wi_1, vec3 wo_1) {
    return (-(wi_1) - wo_1);
}

float geometry_factor(vec3 wi_2, vec3 wo_2) {
    float one_plus = (1.0 + dot(wi_2, wo_2));
    return ((one_plus / wi_2.z) * (one_plus / wo_2.z));
}

float v_cavity_shadowing(vec3 wi_3, vec3 wo_3) {
    vec3 sum_5 = (wi_3 + wo_3);
    vec3 m = (sum_5 / vec3(sqrt(dot(sum_5, sum_5))));
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
    float w_2 = (wi_8.z + wo_8.z);
    float _e13 = geometry_factor(wi_8, wo_8);
    return (((mirror * _e13) / w_2) / w_2);
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
    float x_1 = ((2.0 * t) - 1.0);
    return Recurrence(1.0, x_1, (2.0 * x_1), 1.0);
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
    vec2 size_1 = vec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy));
    vec2 texel_2 = ((uv * size_1) - vec2(0.5));
    vec2 whole = floor(texel_2);
    vec2 f = (texel_2 - whole);
    vec2 g = (vec2(1.0) - f);
    vec2 before = (((g * g) * g) / vec2(6.0));
    vec2 last_1 = (((f * f) * f) / vec2(6.0));
    vec2 nearest = ((vec2(0.6666667) - (f * f)) + (3.0 * last_1));
    vec2 share = (before + nearest);
    vec2 first_1 = ((whole - vec2(1.0)) + (nearest / share));
    vec2 second = ((whole + vec2(1.0)) + (last_1 / (vec2(1.0) - share)));
    return SplinePlaces(((first_1 + vec2(0.5)) / size_1), ((second + vec2(0.5)) / size_1), share);
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
    ivec2 size_2 = ivec2(uvec2(textureSize(_group_0_binding_2_fs, 0).xy));
    uint _e7 = _group_0_binding_0_fs.look_up;
    if (!((_e7 == LINEAR))) {
        local_6 = (min(size_2.x, size_2.y) < 4);
    } else {
        local_6 = true;
    }
    bool _e19 = local_6;
    if (_e19) {
        vec4 _e23 = textureLod(_group_0_binding_2_fs, vec3(uv_1, layer_1), 0.0);
        return _e23;
    }
    vec2 at_7 = clamp(((uv_1 * vec2(size_2)) - vec2(0.5)), vec2(0.0, 0.0), vec2((size_2 - ivec2(1))));
    ivec2 first_2 = min(max((ivec2(at_7) - ivec2(1)), ivec2(0, 0)), (size_2 - ivec2(4)));
    vec4 _e52 = lagrange_weights((at_7.x - float(first_2.x)));
    vec4 _e57 = lagrange_weights((at_7.y - float(first_2.y)));
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
    vec3 low = mix(_e53.xyz, _e60.xyz, share_1.y);
    vec4 _e69 = texelFetch(_group_0_binding_3_fs, ivec2(first_4.y, second_1.x), 0);
    vec4 _e76 = texelFetch(_group_0_binding_3_fs, ivec2(second_1.y, second_1.x), 0);
    vec3 high = mix(_e69.xyz, _e76.xyz, share_1.y);
    return mix(low, high, share_1.x);
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
    float radius_1 = length(q_2.xy);
    float _e7 = _group_0_binding_0_fs.radius_max;
    if ((radius_1 >= _e7)) {
        return vec3(0.0, 0.0, 0.0);
    }
    vec3 _e14 = lobe_at(radius_1, q_2.z);
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
    vec2 at_8 = (0.5 * _e17.xy);
    s = _e18;
    uint _e25 = _group_0_binding_0_fs.restricted;
    if ((_e25 != 0u)) {
        float _e28 = share_of_range(at_8, _e18);
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
    vec3 _e50 = expansion(_e49, at_8);
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

void main() {
    vec3 wi = _vs2fs_location0;
    vec3 wo = _vs2fs_location1;
    vec3 to_light = normalize(wi);
    vec3 to_viewer = normalize(wo);
    vec3 _e4 = surface_xyz(to_light, to_viewer);
    bool _e5 = has_answer(_e4);
    if (!(_e5)) {
        _fs2p_location0 = vec4(1.0, 0.0, 1.0, 1.0);
        return;
    }
    vec3 xyz_2 = (_e4 * max(to_light.z, 0.0));
    vec3 _e16 = xyz_to_linear_srgb(xyz_2);
    _fs2p_location0 = vec4(_e16, 1.0);
    return;
}

