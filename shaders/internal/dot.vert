#version 330

// Round dots of a size in pixels. The depth is shifted as in line.geom.

uniform mat4 u_view_projection;
uniform float u_pixel_size;
uniform vec2 u_depth_slope;
uniform float u_depth_bias;
uniform float u_radius; // pixels

in vec4 in_position;

void main() {
    vec4 clip = u_view_projection * in_position;
    float metres = u_depth_bias * u_pixel_size * clip.w;
    clip.z = (clip.z - metres * u_depth_slope.x) / (clip.w - metres * u_depth_slope.y) * clip.w;
    gl_Position = clip;
    gl_PointSize = 2.0 * u_radius + 2.0; // a pixel around for the smooth edge
}
