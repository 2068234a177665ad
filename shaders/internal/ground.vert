#version 330

// A square in y = 0 around the point below the camera, made of the vertex numbers of a strip of four.

uniform mat4 u_view_projection;
uniform vec3 u_cam_pos;
uniform float u_radius; // metres

out vec2 v_ground;

void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1) * 2.0 - 1.0;
    v_ground = u_cam_pos.xz + u_radius * corner;
    gl_Position = u_view_projection * vec4(v_ground.x, 0.0, v_ground.y, 1.0);
}
