#version 330

// A height map that moves the surface itself (Displacement.vert), with the normals of what comes out of it.

#include "blinn_phong.glsl"
#include "relief.glsl"

uniform vec4 u_color;
uniform vec4 u_back_color;
uniform sampler2D u_texture_3;
uniform float u_normal_scaling;
uniform float u_height_scaling;

uniform float u_depth;  // 0.15 [0, 2] "Depth" Times the height scaling: how far white is moved, in metres.
uniform float u_relief; // 0.5 [0, 2] "Relief" Times the normal scaling: where that makes 1, normals are those of the surface.

in vec4 v_position;
in vec4 v_base;
in vec4 v_normal;
in vec2 v_uv;

out vec4 out_color;

void main() {
    vec4 color = gl_FrontFacing ? u_color : u_back_color;
    vec3 relief = relief_normal(normalize(v_normal.xyz), v_base.xyz, v_uv, u_texture_3,
                                u_depth * u_height_scaling * u_relief * u_normal_scaling);
    vec3 n = facing_normal(relief);
    out_color = vec4(blinn_phong(color.rgb, v_position.xyz, n, vec3(1.0, 0.85, 0.22), 30.0), color.a);
}
