// Shaders as they are written in the course: with all of its uniforms and attributes, and nothing of ours.
#pragma once

#include <QByteArray>

namespace clothlab::course {

inline const QByteArray kAllUniforms = "#version 330\n"
                                       "uniform mat4 u_model;\n"
                                       "uniform mat4 u_view_projection;\n"
                                       "uniform vec4 u_color;\n"
                                       "uniform vec3 u_cam_pos;\n"
                                       "uniform vec3 u_light_pos;\n"
                                       "uniform vec3 u_light_intensity;\n"
                                       "uniform sampler2D u_texture_1;\n"
                                       "uniform sampler2D u_texture_2;\n"
                                       "uniform sampler2D u_texture_3;\n"
                                       "uniform sampler2D u_texture_4;\n"
                                       "uniform vec2 u_texture_1_size;\n"
                                       "uniform vec2 u_texture_2_size;\n"
                                       "uniform vec2 u_texture_3_size;\n"
                                       "uniform vec2 u_texture_4_size;\n"
                                       "uniform samplerCube u_texture_cubemap;\n"
                                       "uniform float u_normal_scaling;\n"
                                       "uniform float u_height_scaling;\n";

inline const QByteArray kInputs =
    "in vec4 v_position;\nin vec4 v_normal;\nin vec4 v_tangent;\nin vec2 v_uv;\n"
    "out vec4 out_color;\n";

inline const QByteArray kAttributes =
    "in vec4 in_position;\nin vec4 in_normal;\nin vec4 in_tangent;\nin vec2 in_uv;\n";

inline const QByteArray kPhong = kAllUniforms + kInputs + R"(
void main() {
  vec3 to_light = u_light_pos - v_position.xyz;
  float r2 = dot(to_light, to_light);
  vec3 l = normalize(to_light);
  vec3 n = normalize(v_normal.xyz);
  vec3 h = normalize(l + normalize(u_cam_pos - v_position.xyz));
  vec3 shade = vec3(0.1) + u_light_intensity / r2 * (max(0.0, dot(n, l)) + 0.5 * pow(max(0.0, dot(n, h)), 32.0));
  out_color = vec4(shade * u_color.rgb, 1.0);
}
)";

inline const QByteArray kTexture =
    kAllUniforms + kInputs + "void main() { out_color = texture(u_texture_1, v_uv); }\n";

// Tangent, bitangent and normal as the columns of a matrix; the height from the second texture.
inline const QByteArray kBump = kAllUniforms + kInputs + R"(
float h(vec2 uv) { return texture(u_texture_2, uv).r; }
void main() {
  vec3 n = normalize(v_normal.xyz);
  vec3 t = normalize(v_tangent.xyz);
  mat3 tbn = mat3(t, cross(n, t), n);
  float du = (h(v_uv + vec2(1.0 / u_texture_2_size.x, 0.0)) - h(v_uv)) * u_height_scaling * u_normal_scaling;
  float dv = (h(v_uv + vec2(0.0, 1.0 / u_texture_2_size.y)) - h(v_uv)) * u_height_scaling * u_normal_scaling;
  vec3 bumped = normalize(tbn * vec3(-du, -dv, 1.0));
  vec3 to_light = u_light_pos - v_position.xyz;
  vec3 light = u_light_intensity / dot(to_light, to_light) * max(0.0, dot(bumped, normalize(to_light)));
  out_color = vec4(0.05 + light, 1.0) * u_color;
}
)";

inline const QByteArray kDisplacementVertices = kAllUniforms + kAttributes + R"(
out vec4 v_position;
out vec2 v_uv;
out vec4 v_normal;
out vec4 v_tangent;
void main() {
  v_normal = normalize(u_model * in_normal);
  v_tangent = normalize(u_model * in_tangent);
  v_uv = in_uv;
  v_position = u_model * in_position + texture(u_texture_3, in_uv).r * u_height_scaling * v_normal;
  gl_Position = u_view_projection * v_position;
}
)";

inline const QByteArray kMirror = kAllUniforms + kInputs + R"(
void main() {
  vec3 seen = v_position.xyz - u_cam_pos;
  out_color = vec4(texture(u_texture_cubemap, reflect(seen, normalize(v_normal.xyz))).rgb, 1.0);
}
)";

inline const QByteArray kNormal =
    "#version 330\nin vec4 v_position;\nin vec4 v_normal;\nout vec4 out_color;\n"
    "void main() { out_color = (vec4(1, 1, 1, 0) + v_normal) / 2.0; }\n";

inline const QByteArray kWireframe = "#version 330\nuniform vec4 u_color;\nout vec4 out_color;\nvoid main() "
                                     "{ out_color = vec4(1.0, 0.2, 0.0, 1.0); }\n";

} // namespace clothlab::course
