#version 330

// A height map that is felt by the light only: the surface stays as it is, its normals are those of the relief.

#include "blinn_phong.glsl"
#include "relief.glsl"

uniform vec4 u_color;
uniform vec4 u_back_color;
uniform sampler2D u_texture_2;
uniform float u_normal_scaling;
uniform float u_height_scaling;

uniform float u_relief; // 0.05 [0, 1] "Relief" Height of white in metres is this times both scalings: threads are shallow.

in vec4 v_position;
in vec4 v_normal;
in vec2 v_uv;

out vec4 out_color;

void main() {
    vec4 color = gl_FrontFacing ? u_color : u_back_color;
    vec3 relief = relief_normal(normalize(v_normal.xyz), v_position.xyz, v_uv, u_texture_2,
                                u_relief * u_normal_scaling * u_height_scaling);
    vec3 n = facing_normal(relief);
    out_color = vec4(blinn_phong(color.rgb, v_position.xyz, n, vec3(1.0, 0.85, 0.22), 30.0), color.a);
}
