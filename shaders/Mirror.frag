#version 330

// Shows what a mirror would: the surroundings of the cube map, seen along the reflected ray.

#include "light.glsl"

uniform vec3 u_cam_pos;
uniform samplerCube u_texture_cubemap;

in vec4 v_position;
in vec4 v_normal;

out vec4 out_color;

void main() {
    vec3 n = facing_normal(v_normal.xyz);
    out_color = vec4(texture(u_texture_cubemap, reflect(v_position.xyz - u_cam_pos, n)).rgb, 1.0);
}
