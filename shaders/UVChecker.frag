#version 330

// Texture coordinates: fields of u across and v down, red growing with u and green with v, and lines between them.

#include "blinn_phong.glsl"

uniform float u_fields; // 8 [1, 64] "Fields" Along each side.

in vec4 v_position;
in vec4 v_normal;
in vec2 v_uv;

out vec4 out_color;

void main() {
    vec2 place = v_uv * u_fields;
    vec2 field = floor(place);
    vec2 pixel = max(fwidth(place), 1e-6);
    vec2 to_line = min(fract(place), 1.0 - fract(place));
    float line = 1.0 - min(smoothstep(0.5, 1.5, to_line.x / pixel.x), smoothstep(0.5, 1.5, to_line.y / pixel.y));
    vec2 part = clamp((field + 0.5) / u_fields, 0.0, 1.0);
    vec3 color = vec3(0.2 + 0.75 * part.x, 0.2 + 0.75 * part.y, 0.42);
    color = mod(field.x + field.y, 2.0) < 0.5 ? color : 0.62 * color;
    color = mix(color, vec3(0.96), 0.8 * line);
    vec3 n = facing_normal(v_normal.xyz);
    out_color = vec4(blinn_phong(color, v_position.xyz, n, vec3(1.6, 0.6, 0.05), 20.0), 1.0);
}
