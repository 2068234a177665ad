#version 330

// Moves each vertex along its normal, by the height map in metres.

uniform mat4 u_model;
uniform mat4 u_view_projection;
uniform sampler2D u_texture_3;
uniform float u_height_scaling;
uniform float u_depth; // described in Displacement.frag

in vec4 in_position;
in vec4 in_normal;
in vec2 in_uv;

out vec4 v_position;
out vec4 v_base; // before it was moved
out vec4 v_normal;
out vec2 v_uv;

// Linear between the four texels around, with a map that repeats. Not by texture(): software drivers blur that in a
// vertex shader as they would on a surface seen edge on.
float height(vec2 uv) {
    ivec2 size = textureSize(u_texture_3, 0);
    vec2 place = uv * vec2(size) - 0.5;
    vec2 part = fract(place);
    ivec2 low = (ivec2(floor(place)) % size + size) % size;
    ivec2 high = (low + 1) % size;
    vec2 left = vec2(texelFetch(u_texture_3, low, 0).r, texelFetch(u_texture_3, ivec2(low.x, high.y), 0).r);
    vec2 right = vec2(texelFetch(u_texture_3, ivec2(high.x, low.y), 0).r, texelFetch(u_texture_3, high, 0).r);
    vec2 column = mix(left, right, part.x);
    return mix(column.x, column.y, part.y);
}

void main() {
    v_base = u_model * in_position;
    v_normal = vec4(normalize(mat3(u_model) * in_normal.xyz), 0.0);
    v_uv = in_uv;
    v_position = v_base + u_depth * u_height_scaling * height(in_uv) * v_normal;
    gl_Position = u_view_projection * v_position;
}
