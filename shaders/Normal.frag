#version 330

// Shows the direction a surface faces as a colour: -1..1 on each axis becomes 0..1 of red, green and blue.
// Times the surface's own colour, which makes colliders darker than a white sheet.

#include "light.glsl"

uniform vec4 u_color;
uniform vec4 u_back_color;

in vec4 v_normal;

out vec4 out_color;

void main() {
    vec4 color = gl_FrontFacing ? u_color : u_back_color;
    out_color = vec4(color.rgb * (0.5 + 0.5 * facing_normal(v_normal.xyz)), color.a);
}
