#version 330

// Signed strain as a colour, shaded just enough to show the folds.

#include "light.glsl"
#include "strain.glsl"

uniform vec3 u_cam_pos;

uniform float u_shading; // 0.25 [0, 1] "Shading" 0 shows the colours of the legend exactly.

in vec4 v_position;
in vec4 v_normal;
in float v_strain;

out vec4 out_color;

void main() {
    float facing = abs(dot(normalize(v_normal.xyz), normalize(u_cam_pos - v_position.xyz)));
    out_color = vec4(strain_color(v_strain) * (1.0 - u_shading * (1.0 - facing)), 1.0);
}
