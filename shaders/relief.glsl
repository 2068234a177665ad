// Normals of a surface with a height map on it. `#include "relief.glsl"` puts it into a shader of yours, too.

// The normal that the surface has when each of its points is moved along `n` by `metres` times the height there.
// `position` is where it was before, in world space. Whatever the texture coordinates do, the slope is that in metres:
// both are known to neighbouring pixels (Mikkelsen 2010, Bump Mapping Unparametrized Surfaces on the GPU).
vec3 relief_normal(vec3 n, vec3 position, vec2 uv, sampler2D heights, float metres) {
    vec2 texel = 1.0 / vec2(textureSize(heights, 0));
    vec2 slope = vec2(texture(heights, uv + vec2(texel.x, 0.0)).r - texture(heights, uv - vec2(texel.x, 0.0)).r,
                      texture(heights, uv + vec2(0.0, texel.y)).r - texture(heights, uv - vec2(0.0, texel.y)).r) /
                 (2.0 * texel);
    vec3 right = dFdx(position);
    vec3 up = dFdy(position);
    float rise_right = dot(slope, dFdx(uv));
    float rise_up = dot(slope, dFdy(uv));
    vec3 across_up = cross(up, n);
    vec3 across_right = cross(n, right);
    float area = dot(right, across_up);
    vec3 gradient = sign(area) * (rise_right * across_up + rise_up * across_right);
    return normalize(abs(area) * n - metres * gradient);
}
