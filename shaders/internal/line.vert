#version 330

in vec4 in_position;
in vec4 in_normal;
in vec4 in_tangent;
in vec2 in_uv;

out vec4 g_normal;
out vec4 g_tangent;
out vec2 g_uv;

void main() {
    gl_Position = in_position; // world space: line.geom projects
    g_normal = in_normal;
    g_tangent = in_tangent;
    g_uv = in_uv;
}
