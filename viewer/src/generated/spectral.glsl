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
const uint IDEAL = 0u;
const uint DIELECTRIC = 1u;
const uint CONDUCTOR = 2u;
const uint SCALAR = 0u;
const uint VECTOR = 1u;
const float NO_ANSWER = -1.0;
const float SHORTEST_SLACK = 1e-6;
const uint SPLINES = 1u;
const uint LINEAR = 0u;

layout(std140) uniform SpectralParams_block_0Fragment { SpectralParams _group_0_binding_0_fs; };

uniform highp sampler2DArray _group_0_binding_1_fs;

uniform highp sampler2DArray _group_0_binding_2_fs;

uniform highp sampler2D _group_0_binding_3_fs;

smooth in vec3 _vs2fs_location0;
smooth in vec3 _vs2fs_location1;
smooth in float _vs2fs_location2;
layout(location = 0) out vec4 _fs2p_location0;

vec3 wave_vector_change(vec3 wi_1, vec3 wo_1) {
    return (-(wi_1) - wo_1);
}

float geometry_factor(vec3 wi_2, vec3 wo_2) {
    float one_plus = (1.0 + dot(wi_2, wo_2));
    return ((one_plus / wi_2.z) * (one_plus / wo_2.z));
}

float v_cavity_shadowing(vec3 wi_3, vec3 wo_3) {
    vec3 sum_4 = (wi_3 + wo_3);
    vec3 m = (sum_4 / vec3(sqrt(dot(sum_4, sum_4))));
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
    vec2 size_1 = vec2(uvec2(textureSize(_group_0_binding_1_fs, 0).xy));
    vec2 texel_1 = ((uv * size_1) - vec2(0.5));
    vec2 whole = floor(texel_1);
    vec2 f = (texel_1 - whole);
    vec2 g = (vec2(1.0) - f);
    vec2 before = (((g * g) * g) / vec2(6.0));
    vec2 last = (((f * f) * f) / vec2(6.0));
    vec2 nearest = ((vec2(0.6666667) - (f * f)) + (3.0 * last));
    vec2 share = (before + nearest);
    vec2 first = ((whole - vec2(1.0)) + (nearest / share));
    vec2 second_1 = ((whole + vec2(1.0)) + (last / (vec2(1.0) - share)));
    return SplinePlaces(((first + vec2(0.5)) / size_1), ((second_1 + vec2(0.5)) / size_1), share);
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
    ivec2 size_2 = ivec2(uvec2(textureSize(_group_0_binding_2_fs, 0).xy));
    uint _e7 = _group_0_binding_0_fs.look_up;
    if (!((_e7 == LINEAR))) {
        local_2 = (min(size_2.x, size_2.y) < 4);
    } else {
        local_2 = true;
    }
    bool _e19 = local_2;
    if (_e19) {
        vec4 _e23 = textureLod(_group_0_binding_2_fs, vec3(uv_1, layer_3), 0.0);
        return _e23;
    }
    vec2 at_2 = clamp(((uv_1 * vec2(size_2)) - vec2(0.5)), vec2(0.0, 0.0), vec2((size_2 - ivec2(1))));
    ivec2 first_1 = min(max((ivec2(at_2) - ivec2(1)), ivec2(0, 0)), (size_2 - ivec2(4)));
    vec4 _e52 = lagrange_weights((at_2.x - float(first_1.x)));
    vec4 _e57 = lagrange_weights((at_2.y - float(first_1.y)));
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
    float at_3 = (clamp((0.5 * abs_w), 0.0, 1.0) * float(last_1));
    uint first_2 = min(uint(at_3), (last_1 - 1u));
    float _e17 = power_texel(first_2);
    float _e20 = power_texel((first_2 + 1u));
    return mix(_e17, _e20, (at_3 - float(first_2)));
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
    vec3 q_2 = (r * _e32);
    float _e34 = normalised_abs_w(q_2);
    float _e35 = diffuse_factor(front_5, wi_10, wo_10);
    float _e39 = expansion((0.5 * q_2.xy), _e34);
    float _e40 = cross_value(q_2, _e34);
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
    float _e80 = power_at(abs(q_2.z));
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

void main() {
    vec3 wi = _vs2fs_location0;
    vec3 wo = _vs2fs_location1;
    float wavelength_nm = _vs2fs_location2;
    vec3 to_light = normalize(wi);
    float _e5 = brdf_spectral(to_light, normalize(wo), wavelength_nm);
    bool _e6 = has_answer(_e5);
    if (!(_e6)) {
        _fs2p_location0 = vec4(0.0, 0.0, 0.0, 1.0);
        return;
    }
    _fs2p_location0 = vec4((_e5 * max(to_light.z, 0.0)), 1.0, 0.0, 1.0);
    return;
}

