#version 330

// Makes a line of some pixels' width of each GL line, because core profiles draw none wider than one pixel.

#include "strain.glsl"

layout(lines) in;
layout(triangle_strip, max_vertices = 4) out;

uniform mat4 u_view_projection;
uniform vec2 u_viewport;    // pixels
uniform float u_pixel_size; // world length of a pixel where clip-space w is 1
uniform vec2 u_depth_slope; // how clip-space z and w grow along the view direction, a metre
uniform float u_depth_bias; // drawn nearer to the viewer by so many pixels' size
uniform float u_width;      // pixels
uniform vec4 u_color;
uniform bool u_by_strain;
uniform float u_max_fill;   // greatest width as a part of the line's own length; 0: no limit

in vec4 g_normal[];
in vec4 g_tangent[];
in vec2 g_uv[];
in vec3 g_rest[];

out vec4 v_position;
out vec4 v_normal;
out vec4 v_tangent;
out vec2 v_uv;
out vec4 v_color;
noperspective out vec3 v_line; // pixels from the middle, half the width in pixels, opacity

const float k_fringe = 1.0; // pixels beyond the edge, where it is smoothed

// (length - rest length) / rest length; 0 if the rest length is 0.
float strain() {
    float rest = distance(g_rest[0], g_rest[1]);
    return rest > 0.0 ? distance(gl_in[0].gl_Position.xyz, gl_in[1].gl_Position.xyz) / rest - 1.0 : 0.0;
}

// Moves nearer without moving on the screen.
vec4 nearer(vec4 clip) {
    float metres = u_depth_bias * u_pixel_size * clip.w;
    return vec4(clip.xy, (clip.z - metres * u_depth_slope.x) / (clip.w - metres * u_depth_slope.y) * clip.w, clip.w);
}

void emit(int from, int to, float part, vec4 clip, vec2 across, vec3 line) {
    v_position = mix(gl_in[from].gl_Position, gl_in[to].gl_Position, part);
    v_normal = mix(g_normal[from], g_normal[to], part);
    v_tangent = mix(g_tangent[from], g_tangent[to], part);
    v_uv = mix(g_uv[from], g_uv[to], part);
    v_line = line;
    v_color = u_by_strain ? vec4(strain_color(strain()), u_color.a) : u_color;
    vec2 shift = across * line.x * 2.0 / u_viewport * clip.w;
    gl_Position = nearer(clip + vec4(shift, 0.0, 0.0));
    EmitVertex();
}

void main() {
    vec4 a = u_view_projection * gl_in[0].gl_Position;
    vec4 b = u_view_projection * gl_in[1].gl_Position;

    // Cut off what is behind the near plane: it has no place on the screen to measure a width at.
    float inside_a = a.z + a.w;
    float inside_b = b.z + b.w;
    if (!(inside_a > 0.0 || inside_b > 0.0))
        return;
    float start = inside_a > 0.0 ? 0.0 : inside_a / (inside_a - inside_b);
    float end = inside_b > 0.0 ? 1.0 : inside_a / (inside_a - inside_b);
    vec4 from = mix(a, b, start);
    vec4 to = mix(a, b, end);
    if (!(from.w > 0.0 && to.w > 0.0))
        return;

    vec2 along = (to.xy / to.w - from.xy / from.w) * u_viewport;
    float along_squared = dot(along, along);
    if (!(along_squared > 1e-8))
        return;
    vec2 across = vec2(-along.y, along.x) * inversesqrt(along_squared);

    // Where springs are only a few pixels long, full width would fill the sheet.
    float width = u_width;
    if (u_max_fill > 0.0) {
        float pixels = distance(gl_in[0].gl_Position.xyz, gl_in[1].gl_Position.xyz) / (u_pixel_size * 0.5 * (from.w + to.w));
        width = min(width, max(pixels * u_max_fill, 0.35));
    }
    float half_width = 0.5 * max(width, 1.0);
    float opacity = min(width, 1.0);
    float reach = half_width + k_fringe;
    emit(0, 1, start, from, across, vec3(-reach, half_width, opacity));
    emit(0, 1, start, from, across, vec3(reach, half_width, opacity));
    emit(0, 1, end, to, across, vec3(-reach, half_width, opacity));
    emit(0, 1, end, to, across, vec3(reach, half_width, opacity));
    EndPrimitive();
}
