#version 330

// What surfaces look like when the chosen shader has nothing to say about them: plain, calm, readable.

uniform vec4 u_color;
uniform vec3 u_cam_pos;

in vec4 v_position;
in vec4 v_normal;

out vec4 out_color;

void main() {
    vec3 n = normalize(v_normal.xyz) * (gl_FrontFacing ? 1.0 : -1.0);
    vec3 to_camera = normalize(u_cam_pos - v_position.xyz);
    float facing = max(dot(n, to_camera), 0.0);
    float sky = 0.5 + 0.5 * n.y;
    out_color = vec4(u_color.rgb * (0.15 + 0.35 * sky + 0.35 * facing), u_color.a);
}
