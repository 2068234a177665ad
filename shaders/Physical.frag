#version 330

// Physically based: a rough metal or a dielectric, lit by the lamp and by the surroundings. Computed in linear light.
// Microfacets after Trowbridge and Reitz (GGX) with Smith's shadowing and Schlick's Fresnel, as in Burley 2012; the
// surroundings come from the cube map's mipmap, scaled after Karis 2014, and matt light from nine harmonics
// (Ramamoorthi and Hanrahan 2001).

#include "light.glsl"

uniform vec4 u_color;
uniform vec4 u_back_color;
uniform vec3 u_cam_pos;
uniform vec3 u_light_pos;
uniform vec3 u_light_intensity;
uniform samplerCube u_texture_cubemap;
uniform float u_cubemap_levels;
uniform vec3 u_irradiance[9];

uniform float u_roughness;     // 0.5 [0.04, 1] "Roughness" 0 would be a mirror, 1 is matt.
uniform float u_metallic;      // 0 [0, 1] "Metallic" 1: highlights take the base colour, and nothing is scattered.
uniform bool u_use_map;        // true "Use the base map"
uniform sampler2D u_base_map;  // srgb texture_5.png "Base map" Times the colour of the sheet.
uniform float u_lamp;          // 1.6 [0, 5] "Lamp" Weight of the main light.
uniform float u_surroundings;  // 1.8 [0, 5] "Surroundings" Weight of the cube map.

in vec4 v_position;
in vec4 v_normal;
in vec2 v_uv;

out vec4 out_color;

const float k_pi = 3.14159265;

vec3 to_linear(vec3 c) {
    return mix(c / 12.92, pow((c + 0.055) / 1.055, vec3(2.4)), step(0.04045, c));
}

vec3 to_srgb(vec3 c) {
    return mix(12.92 * c, 1.055 * pow(max(c, 0.0), vec3(1.0 / 2.4)) - 0.055, step(0.0031308, c));
}

// Matt light from all around, over pi.
vec3 irradiance(vec3 n) {
    vec3 sum = u_irradiance[0] + u_irradiance[1] * n.y + u_irradiance[2] * n.z + u_irradiance[3] * n.x +
               u_irradiance[4] * n.x * n.y + u_irradiance[5] * n.y * n.z + u_irradiance[6] * (3.0 * n.z * n.z - 1.0) +
               u_irradiance[7] * n.x * n.z + u_irradiance[8] * (n.x * n.x - n.y * n.y);
    return max(sum, 0.0);
}

vec3 fresnel(vec3 straight_on, float cosine) {
    return straight_on + (1.0 - straight_on) * pow(clamp(1.0 - cosine, 0.0, 1.0), 5.0);
}

// The lamp's highlight, without the cosine to the lamp.
vec3 highlight(vec3 n, vec3 l, vec3 v, vec3 straight_on, float alpha) {
    vec3 h = normalize(l + v);
    float nl = max(dot(n, l), 1e-4);
    float nv = max(dot(n, v), 1e-4);
    float nh = max(dot(n, h), 0.0);
    float a2 = alpha * alpha;
    float bend = nh * nh * (a2 - 1.0) + 1.0;
    float facets = a2 / (k_pi * bend * bend);
    float shadowing = 0.5 / (nl * sqrt(nv * nv * (1.0 - a2) + a2) + nv * sqrt(nl * nl * (1.0 - a2) + a2));
    return facets * shadowing * fresnel(straight_on, max(dot(h, v), 0.0));
}

// How much of the surroundings a rough surface reflects in all.
vec3 reflected_part(vec3 straight_on, float roughness, float nv) {
    vec4 r = roughness * vec4(-1.0, -0.0275, -0.572, 0.022) + vec4(1.0, 0.0425, 1.04, -0.04);
    float lobe = min(r.x * r.x, exp2(-9.28 * nv)) * r.x + r.y;
    vec2 scale_bias = vec2(-1.04, 1.04) * lobe + r.zw;
    return straight_on * scale_bias.x + scale_bias.y;
}

void main() {
    vec4 color = gl_FrontFacing ? u_color : u_back_color;
    vec3 base = to_linear(color.rgb) * (u_use_map ? texture(u_base_map, v_uv).rgb : vec3(1.0));
    vec3 n = facing_normal(v_normal.xyz);
    vec3 v = normalize(u_cam_pos - v_position.xyz);
    float nv = max(dot(n, v), 1e-4);
    float roughness = max(u_roughness, 0.04);
    vec3 straight_on = mix(vec3(0.04), base, u_metallic);
    vec3 mirrored = reflected_part(straight_on, roughness, nv);
    vec3 matt = base * (1.0 - u_metallic) * (1.0 - mirrored); // what is mirrored goes in nowhere

    Lamp lamp = lamp_at(v_position.xyz, u_light_pos, u_light_intensity);
    float nl = max(dot(n, lamp.direction), 0.0);
    vec3 arriving = nl > 0.0 ? u_lamp * lamp.arriving * nl * reaching(v_position.xyz, n) : vec3(0.0);
    vec3 light = arriving * (matt + k_pi * highlight(n, lamp.direction, v, straight_on, roughness * roughness));

    float level = roughness * max(u_cubemap_levels - 3.0, 0.0);
    vec3 around = to_linear(textureLod(u_texture_cubemap, reflect(-v, n), level).rgb);
    light += u_surroundings * (matt * irradiance(n) + around * mirrored);
    out_color = vec4(soft_shoulder(to_srgb(light)), color.a);
}
