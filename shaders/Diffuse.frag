#version 330

// Lambert's law, and nothing else: light that arrives, falling off with the square of the distance, times the
// cosine to the normal. What no light reaches is black.

#include "light.glsl"

uniform vec4 u_color;
uniform vec4 u_back_color;
uniform vec3 u_light_pos;
uniform vec3 u_light_intensity;

in vec4 v_position;
in vec4 v_normal;

out vec4 out_color;

void main() {
    vec4 color = gl_FrontFacing ? u_color : u_back_color;
    vec3 n = facing_normal(v_normal.xyz);
    Lamp lamp = lamp_at(v_position.xyz, u_light_pos, u_light_intensity);
    vec3 arriving = lamp.arriving * reaching(v_position.xyz, n);
    out_color = vec4(color.rgb * arriving * max(dot(n, lamp.direction), 0.0), color.a);
}
