#version 330

// Changeant silk: warp and weft of different colours, so that the sheet changes its colour with the view, with the long
// highlights of threads (Kajiya and Kay 1989) and a woven-in pattern where the threads change places.

#include "light.glsl"

uniform vec3 u_cam_pos;
uniform vec3 u_light_pos;
uniform vec3 u_light_intensity;

uniform vec3 u_warp_color; // #B3123F "Warp" Threads along u.
uniform vec3 u_weft_color; // #1B2FA8 "Weft" Threads along v.
uniform float u_gloss;     // 0.9 [0, 2] "Gloss"
uniform float u_pattern;   // 6 [0, 20] "Pattern" Figures along a side; 0: plain.
uniform float u_threads;   // 90 [0, 400] "Threads" Along a side, where they are large enough to be seen.

in vec4 v_position;
in vec4 v_normal;
in vec4 v_tangent;
in vec2 v_uv;

out vec4 out_color;

// A long highlight across a thread of direction t.
float strand(vec3 t, vec3 l, vec3 v, float power) {
    float tl = dot(t, l);
    float tv = dot(t, v);
    float along = sqrt(max(1.0 - tl * tl, 0.0)) * sqrt(max(1.0 - tv * tv, 0.0)) - tl * tv;
    return pow(max(along, 0.0), power);
}

// 1 within a figure of eight petals, 0 outside, smooth at the edge.
float figure(vec2 uv) {
    vec2 place = uv * u_pattern;
    vec2 cell = fract(place + 0.5 * vec2(mod(floor(place.y), 2.0), 0.0)) - 0.5;
    float angle = atan(cell.y, cell.x);
    float edge = 0.24 + 0.13 * cos(8.0 * angle) * smoothstep(0.05, 0.3, length(cell));
    float width = max(fwidth(place.y), 0.01);
    float ring = abs(length(cell) - 0.43) - 0.015;
    float inside = smoothstep(width, -width, length(cell) - edge) * smoothstep(-width, width, length(cell) - 0.07);
    return max(inside, smoothstep(width, -width, ring));
}

void main() {
    vec3 n = facing_normal(v_normal.xyz);
    vec3 t = normalize(v_tangent.xyz - dot(v_tangent.xyz, n) * n);
    vec3 b = cross(n, t);
    vec3 v = normalize(u_cam_pos - v_position.xyz);
    Lamp lamp = lamp_at(v_position.xyz, u_light_pos, u_light_intensity);
    float cosine = max(dot(n, lamp.direction), 0.0);
    vec3 arriving = cosine > 0.0 ? lamp.arriving * reaching(v_position.xyz, n) : vec3(0.0);

    float woven = u_pattern > 0.0 ? figure(v_uv) : 0.0;
    // Which thread lies on top changes with the view: one shows its flank where the other is seen end on.
    float lean = abs(dot(v, b)) - abs(dot(v, t));
    float weft_on_top = clamp(0.5 + 1.1 * lean, 0.0, 1.0);
    weft_on_top = mix(weft_on_top, 1.0 - weft_on_top, woven);
    vec3 color = mix(u_warp_color, u_weft_color, weft_on_top);

    vec2 place = v_uv * u_threads;
    float seen = 1.0 - smoothstep(0.15, 0.5, max(fwidth(place).x, fwidth(place).y));
    vec2 round_thread = 0.5 + 0.5 * cos(6.2831853 * place);
    color *= 1.0 - 0.35 * seen * (1.0 - mix(round_thread.y, round_thread.x, weft_on_top));

    vec3 thread = normalize(mix(t, b, weft_on_top));
    float shine = u_gloss * mix(strand(t, lamp.direction, v, 60.0), strand(b, lamp.direction, v, 60.0), weft_on_top);
    float wide = 0.35 * u_gloss * strand(thread, lamp.direction, v, 8.0);
    float rim = pow(1.0 - max(dot(n, v), 0.0), 3.0);
    vec3 light = color * (1.5 * ambient_light(n, v) + arriving * cosine);
    light += arriving * sqrt(cosine) * (shine * mix(color, vec3(1.0), 0.55) + wide * color);
    light += 0.35 * rim * mix(u_weft_color, u_warp_color, weft_on_top);
    out_color = vec4(soft_shoulder(light), 1.0);
}
