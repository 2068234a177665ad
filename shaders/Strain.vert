#version 330

// Default.vert, and the strain of each point.

uniform mat4 u_model;
uniform mat4 u_view_projection;

in vec4 in_position;
in vec4 in_normal;
in float in_strain; // signed, of the spring at the point that is strained most

out vec4 v_position;
out vec4 v_normal;
out float v_strain;

void main() {
    v_position = u_model * in_position;
    v_normal = vec4(normalize(mat3(u_model) * in_normal.xyz), 0.0);
    v_strain = in_strain;
    gl_Position = u_view_projection * v_position;
}
