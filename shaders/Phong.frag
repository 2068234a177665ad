#version 330

// Blinn-Phong: ambient, diffuse and specular light. Ambient light comes from a bright sky and a dim ground, and a
// little from the camera, so that the side away from the light keeps its shape.

uniform vec4 u_color;
uniform vec3 u_cam_pos;
uniform vec3 u_light_pos;
uniform vec3 u_light_intensity;

in vec4 v_position;
in vec4 v_normal;

out vec4 out_color;

const vec3 k_sky = vec3(0.25, 0.26, 0.28);
const vec3 k_ground = vec3(0.17, 0.165, 0.16);
const float k_camera = 0.16;
const float k_diffuse = 0.80;
const float k_specular = 0.22;
const float k_shininess = 40.0;

// Straight up to `start`, from there bending so that nothing reaches 1: bright places keep their shading.
vec3 soft_shoulder(vec3 c) {
    const float start = 0.7;
    const float room = 1.0 - start;
    vec3 over = max(c - start, 0.0);
    return min(c, start) + room * over / (over + room);
}

void main() {
    vec3 n = normalize(v_normal.xyz) * (gl_FrontFacing ? 1.0 : -1.0);
    vec3 to_camera = normalize(u_cam_pos - v_position.xyz);
    vec3 to_light = u_light_pos - v_position.xyz;
    float distance_squared = max(dot(to_light, to_light), 1e-6);
    vec3 l = to_light * inversesqrt(distance_squared);
    vec3 arriving = u_light_intensity / distance_squared;

    float cosine = max(dot(n, l), 0.0);
    vec3 ambient = mix(k_ground, k_sky, 0.5 + 0.5 * n.y) + k_camera * max(dot(n, to_camera), 0.0);
    vec3 diffuse = k_diffuse * arriving * cosine;
    // Added to a zero vector when the camera looks along the light: half_way is only used where it has a length.
    vec3 half_way = l + to_camera;
    float shine = max(dot(n, half_way), 0.0) * inversesqrt(max(dot(half_way, half_way), 1e-8));
    vec3 specular = k_specular * arriving * pow(shine, k_shininess) * step(1e-4, cosine);

    out_color = vec4(soft_shoulder(u_color.rgb * (ambient + diffuse) + specular), u_color.a);
}
