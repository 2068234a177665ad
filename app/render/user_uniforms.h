// What a linked program has for its user to set.
#pragma once

#include "app/render/gl_functions.h"
#include "app/render/problem.h"
#include "app/render/shader_source.h"
#include "app/render/uniform_spec.h"

#include <QByteArray>

#include <span>
#include <vector>

namespace clothlab::render {

struct ShaderStage {
    GLenum type;
    ShaderSource source;
};

// As many textures of its own can a shader have.
inline constexpr int kMostUserSamplers = 10;

// A uniform that the program has but the renderer does not set by itself.
struct UserUniform {
    UniformSpec spec;
    GLint location = -1;
};

// In the order of the last stage's text. Uniforms that are `ours` are left out; those of a type without a
// control are told in `problems`, and samplers among them put out of the way of the others.
std::vector<UserUniform> findUserUniforms(Gl& gl, GLuint program, std::span<const ShaderStage> stages,
                                          bool (*ours)(const QByteArray& name), Problems& problems);

} // namespace clothlab::render
