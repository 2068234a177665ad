#version 330

// Moves each vertex along its normal, by the height map in metres.

uniform mat4 u_model;
uniform mat4 u_view_projection;
uniform sampler2D u_texture_3;
uniform float u_height_scaling;
uniform float u_depth; // described in Displacement.frag

in vec4 in_position;
in vec4 in_normal;
in vec2 in_uv;

out vec4 v_position;
out vec4 v_base; // before it was moved
out vec4 v_normal;
out vec2 v_uv;

void main() {
    v_base = u_model * in_position;
    v_normal = vec4(normalize(mat3(u_model) * in_normal.xyz), 0.0);
    v_uv = in_uv;
    v_position = v_base + u_depth * u_height_scaling * textureLod(u_texture_3, in_uv, 0.0).r * v_normal;
    gl_Position = u_view_projection * v_position;
}
