// The colours of signed strain, as in the legend. `#include "strain.glsl"` puts it into a shader of yours, too.

uniform float u_strain_range;   // at the ends of the colours
uniform vec3 u_strain_colors[5]; // compressed, …, unstrained, …, stretched

vec3 strain_color(float strain) {
    float place = 2.0 * (clamp(strain / u_strain_range, -1.0, 1.0) + 1.0);
    int below = min(int(place), 3);
    return mix(u_strain_colors[below], u_strain_colors[below + 1], place - float(below));
}
