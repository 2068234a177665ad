#version 330

uniform vec4 u_color;
uniform float u_radius;

out vec4 out_color;

void main() {
    float from_center = length(gl_PointCoord - 0.5) * (2.0 * u_radius + 2.0);
    float covered = clamp(u_radius + 0.5 - from_center, 0.0, 1.0);
    if (covered <= 0.0)
        discard;
    // A dark rim keeps dots apart from a bright sheet, and from each other.
    float rim = clamp(from_center - 0.72 * u_radius + 0.5, 0.0, 1.0);
    out_color = vec4(u_color.rgb * mix(1.0, 0.25, rim), u_color.a * covered);
}
