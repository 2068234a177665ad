#version 330

// Shows the direction a surface faces as a colour: -1..1 on each axis becomes 0..1 of red, green and blue.
// Times the surface's own colour, which makes colliders darker than a white sheet.

uniform vec4 u_color;

in vec4 v_normal;

out vec4 out_color;

void main() {
    vec3 n = normalize(v_normal.xyz) * (gl_FrontFacing ? 1.0 : -1.0);
    out_color = vec4(u_color.rgb * (0.5 + 0.5 * n), u_color.a);
}
