#version 330

// Blinn-Phong: ambient, diffuse and specular light.

#include "blinn_phong.glsl"

uniform vec4 u_color;
uniform vec4 u_back_color;

uniform bool u_show_ambient;  // true "Show ambient"
uniform float u_ambient;      // 1 [0, 3] "Ambient" Weight of the light that comes from everywhere.
uniform bool u_show_diffuse;  // true "Show diffuse"
uniform float u_diffuse;      // 0.8 [0, 3] "Diffuse" Weight of the light that a matt surface scatters.
uniform bool u_show_specular; // true "Show specular"
uniform float u_specular;     // 0.22 [0, 3] "Specular" Weight of the highlight.
uniform float u_shininess;    // 40 [1, 500] "Shininess" Exponent of the highlight: higher is smaller and sharper.

in vec4 v_position;
in vec4 v_normal;

out vec4 out_color;

void main() {
    vec4 color = gl_FrontFacing ? u_color : u_back_color;
    vec3 weights = vec3(u_show_ambient ? u_ambient : 0.0, u_show_diffuse ? u_diffuse : 0.0,
                        u_show_specular ? u_specular : 0.0);
    vec3 n = facing_normal(v_normal.xyz);
    out_color = vec4(blinn_phong(color.rgb, v_position.xyz, n, weights, u_shininess), color.a);
}
