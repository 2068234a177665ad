// What the surface shaders share about light. `#include "light.glsl"` puts it into a shader of yours, too.

uniform bool u_two_sided;
uniform sampler2DShadow u_shadow_map;
uniform mat4 u_shadow_matrix;    // from world space to the shadow map, before the division by w
uniform float u_shadow_strength; // 0: no shadows

// The normal of the side that is seen.
vec3 facing_normal(vec3 normal) {
    vec3 n = normalize(normal);
    return gl_FrontFacing || !u_two_sided ? n : -n;
}

// How much of the main light reaches a point, 0 … 1, smoothed over a few texels.
float reaching(vec3 position, vec3 n) {
    if (u_shadow_strength <= 0.0)
        return 1.0;
    float away = (u_shadow_matrix * vec4(position, 1.0)).w;
    // A little off the surface, or it would shade itself.
    vec4 place = u_shadow_matrix * vec4(position + 0.0015 * away * n, 1.0);
    if (place.w <= 0.0)
        return 1.0;
    vec3 p = place.xyz / place.w;
    vec2 texel = 1.2 / vec2(textureSize(u_shadow_map, 0));
    float sum = texture(u_shadow_map, p) * 2.0;
    sum += texture(u_shadow_map, p + vec3(texel.x, 0.4 * texel.y, 0.0));
    sum += texture(u_shadow_map, p + vec3(-texel.x, -0.4 * texel.y, 0.0));
    sum += texture(u_shadow_map, p + vec3(-0.4 * texel.x, texel.y, 0.0));
    sum += texture(u_shadow_map, p + vec3(0.4 * texel.x, -texel.y, 0.0));
    return mix(1.0, sum / 6.0, u_shadow_strength);
}

// Light that comes from everywhere: a bright sky, a dim ground, and a little from the camera, so that the side away
// from the lamp keeps its shape.
vec3 ambient_light(vec3 n, vec3 to_camera) {
    const vec3 sky = vec3(0.25, 0.26, 0.28);
    const vec3 ground = vec3(0.17, 0.165, 0.16);
    return mix(ground, sky, 0.5 + 0.5 * n.y) + 0.16 * max(dot(n, to_camera), 0.0);
}

// Straight up to `start`, from there bending so that nothing reaches 1: bright places keep their shading.
vec3 soft_shoulder(vec3 c) {
    const float start = 0.7;
    const float room = 1.0 - start;
    vec3 over = max(c - start, 0.0);
    return min(c, start) + room * over / (over + room);
}

// The main light at a point: direction to it, and what arrives there if nothing is in the way.
struct Lamp {
    vec3 direction;
    vec3 arriving;
};

Lamp lamp_at(vec3 position, vec3 lamp_position, vec3 intensity) {
    vec3 to_lamp = lamp_position - position;
    float distance_squared = max(dot(to_lamp, to_lamp), 1e-6);
    return Lamp(to_lamp * inversesqrt(distance_squared), intensity / distance_squared);
}
