// Blinn-Phong with its parts. `#include "blinn_phong.glsl"` puts it into a shader of yours, too.

#include "light.glsl"

uniform vec3 u_cam_pos;
uniform vec3 u_light_pos;
uniform vec3 u_light_intensity;

// ambient * color + diffuse * color + specular, each part with its weight; what is bright is softened.
vec3 blinn_phong(vec3 color, vec3 position, vec3 n, vec3 weights, float shininess) {
    vec3 to_camera = normalize(u_cam_pos - position);
    Lamp lamp = lamp_at(position, u_light_pos, u_light_intensity);
    float cosine = max(dot(n, lamp.direction), 0.0);
    vec3 arriving = cosine > 0.0 ? lamp.arriving * reaching(position, n) : vec3(0.0);
    vec3 half_way = lamp.direction + to_camera;
    float shine = max(dot(n, half_way), 0.0) * inversesqrt(max(dot(half_way, half_way), 1e-8));
    vec3 ambient = weights.x * ambient_light(n, to_camera);
    vec3 diffuse = weights.y * arriving * cosine;
    vec3 specular = weights.z * arriving * pow(shine, shininess);
    return soft_shoulder(color * (ambient + diffuse) + specular);
}
