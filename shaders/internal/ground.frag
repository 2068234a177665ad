#version 330

// Grid lines every power of ten metres, the finest that still have room, with the x and z axes in their colours.

uniform vec4 u_color;
uniform vec3 u_cam_pos;
uniform float u_radius; // metres, where the grid has faded out
uniform float u_width;  // pixels

in vec2 v_ground;

out vec4 out_color;

const vec3 k_x_axis = vec3(0.80, 0.33, 0.36);
const vec3 k_z_axis = vec3(0.35, 0.55, 0.90);

// How much of a pixel is covered by a line at distance `metres`, for pixels of the given size.
vec2 line(vec2 metres, vec2 pixel) {
    return clamp(0.5 * u_width + 0.5 - metres / pixel, 0.0, 1.0);
}

float grid(float cell, vec2 pixel) {
    vec2 to_line = abs(fract(v_ground / cell - 0.5) - 0.5) * cell;
    // Lines that come closer than a few pixels would fill the plane: fade them out before.
    vec2 room = 1.0 - smoothstep(0.08, 0.35, pixel / cell);
    vec2 covered = line(to_line, pixel) * room;
    return max(covered.x, covered.y);
}

void main() {
    vec2 pixel = max(fwidth(v_ground), 1e-7);
    float level = log(max(pixel.x, pixel.y) * 10.0) / log(10.0);
    float cell = pow(10.0, ceil(level));
    float coarser = ceil(level) - level; // 1: the finest lines have all the room they need
    float covered = max(grid(cell, pixel) * 0.45 * smoothstep(0.0, 0.7, coarser), grid(cell * 10.0, pixel));

    vec2 axes = line(abs(v_ground.yx), pixel); // the x axis is where z is zero
    vec3 color = mix(mix(u_color.rgb, k_x_axis, axes.x), k_z_axis, axes.y);
    covered = max(covered, 2.0 * max(axes.x, axes.y));

    float fade = 1.0 - smoothstep(0.15, 1.0, distance(v_ground, u_cam_pos.xz) / u_radius);
    float alpha = min(u_color.a * covered, 1.0) * fade;
    if (alpha < 0.004)
        discard;
    out_color = vec4(color, alpha);
}
