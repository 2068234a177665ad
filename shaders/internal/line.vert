#version 330

in vec4 in_position;
in vec4 in_normal;
in vec4 in_tangent;
in vec2 in_uv;
in vec3 in_rest;

out vec4 g_normal;
out vec4 g_tangent;
out vec2 g_uv;
out vec3 g_rest;

void main() {
    gl_Position = in_position; // world space: line.geom projects
    g_normal = in_normal;
    g_tangent = in_tangent;
    g_uv = in_uv;
    g_rest = in_rest;
}
