#version 330

// Takes the vertices to world space for every surface shader that has no vertex shader of its own.

uniform mat4 u_model;
uniform mat4 u_view_projection;

in vec4 in_position;
in vec4 in_normal;
in vec4 in_tangent;
in vec2 in_uv;

out vec4 v_position;
out vec4 v_normal;
out vec4 v_tangent;
out vec2 v_uv;

void main() {
    v_position = u_model * in_position;
    v_normal = vec4(normalize(mat3(u_model) * in_normal.xyz), 0.0);
    v_tangent = vec4(normalize(mat3(u_model) * in_tangent.xyz), 0.0);
    v_uv = in_uv;
    gl_Position = u_view_projection * v_position;
}
