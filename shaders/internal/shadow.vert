#version 330

// What stands in the light's way: depths are all that is wanted.

uniform mat4 u_model;
uniform mat4 u_view_projection; // of the light

in vec4 in_position;

void main() {
    gl_Position = u_view_projection * (u_model * in_position);
}
