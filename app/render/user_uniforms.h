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
    GLenum type = 0;
    ShaderSource source;
};

// As many textures of its own can a shader have.
inline constexpr int kMostUserSamplers = 10;

// A uniform that the program has but the renderer does not set by itself.
struct UserUniform {
    UniformSpec spec;
    GLint location = -1;
};

struct ProgramUniforms {
    std::vector<UserUniform>
        ofTheUser; // in the order of the last stage's text, those of the stages before last
    std::vector<GLint> ofAnotherType; // locations of the renderer's own that it cannot set
};

// typeOfOurs gives the type of a uniform of the renderer's own, or 0. What cannot be set is told in
// `problems`: uniforms of the user's without a control, of which samplers are put out of the way of the
// others, and the renderer's own of another type.
ProgramUniforms findUniforms(Gl& gl, GLuint program, std::span<const ShaderStage> stages,
                             GLenum (*typeOfOurs)(const QByteArray& name), Problems& problems);

} // namespace clothlab::render
