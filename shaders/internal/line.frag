#version 330

// Thick lines with smooth edges, from what line.geom says about them.

in vec4 v_color;
noperspective in vec3 v_line;

out vec4 out_color;

void main() {
    float covered = clamp(v_line.y + 0.5 - abs(v_line.x), 0.0, 1.0);
    if (covered < 0.05)
        discard; // or its depth would cut a dark seam into lines behind
    out_color = vec4(v_color.rgb, v_color.a * covered * v_line.z);
}
