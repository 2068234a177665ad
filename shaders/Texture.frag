#version 330

// A picture on the surface.

#include "blinn_phong.glsl"

uniform vec4 u_color;
uniform vec4 u_back_color;
uniform sampler2D u_texture_1;

uniform vec2 u_tiles;   // (1, 1) [0.1, 20] "Tiles" How often the picture repeats across and down.
uniform bool u_lit;     // true "Lit" Off: the picture's own colours, whatever the light.

in vec4 v_position;
in vec4 v_normal;
in vec2 v_uv;

out vec4 out_color;

void main() {
    vec4 color = gl_FrontFacing ? u_color : u_back_color;
    vec3 picture = texture(u_texture_1, v_uv * u_tiles).rgb;
    vec3 n = facing_normal(v_normal.xyz);
    vec3 lit = blinn_phong(color.rgb * picture, v_position.xyz, n, vec3(1.0, 0.85, 0.08), 30.0);
    out_color = vec4(u_lit ? lit : picture, color.a);
}
