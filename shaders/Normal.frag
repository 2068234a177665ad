#version 330

// Shows the direction a surface faces as a colour: -1..1 on each axis becomes 0..1 of red, green and blue.

in vec4 v_normal;

out vec4 out_color;

void main() {
    vec3 n = normalize(v_normal.xyz) * (gl_FrontFacing ? 1.0 : -1.0);
    out_color = vec4(0.5 + 0.5 * n, 1.0);
}
