#version 330

// Lambert's law, and nothing else: light that arrives, falling off with the square of the distance, times the
// cosine to the normal. What no light reaches is black.

uniform vec4 u_color;
uniform vec3 u_light_pos;
uniform vec3 u_light_intensity;

in vec4 v_position;
in vec4 v_normal;

out vec4 out_color;

void main() {
    vec3 n = normalize(v_normal.xyz) * (gl_FrontFacing ? 1.0 : -1.0);
    vec3 to_light = u_light_pos - v_position.xyz;
    float distance_squared = max(dot(to_light, to_light), 1e-6);
    vec3 arriving = u_light_intensity / distance_squared;
    float cosine = max(dot(n, to_light * inversesqrt(distance_squared)), 0.0);
    out_color = vec4(u_color.rgb * arriving * cosine, u_color.a);
}
