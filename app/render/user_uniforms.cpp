#include "app/render/user_uniforms.h"

#include <algorithm>
#include <array>
#include <optional>

namespace clothlab::render {
namespace {

constexpr GLint kLastUnit = 15; // OpenGL 3.3 has at least 16 texture units

std::optional<UniformSpec::Type> typeOf(GLenum type) {
    switch (type) {
    case GL_BOOL:
        return UniformSpec::Type::Bool;
    case GL_INT:
        return UniformSpec::Type::Int;
    case GL_FLOAT:
        return UniformSpec::Type::Float;
    case GL_FLOAT_VEC2:
        return UniformSpec::Type::Vec2;
    case GL_FLOAT_VEC3:
        return UniformSpec::Type::Vec3;
    case GL_FLOAT_VEC4:
        return UniformSpec::Type::Vec4;
    case GL_SAMPLER_2D:
        return UniformSpec::Type::Sampler2D;
    default:
        return std::nullopt;
    }
}

bool isSampler(GLenum type) {
    // Those of OpenGL 3.3: from sampler1D to the shadow and buffer kinds, then the signed and unsigned ones.
    return (type >= GL_SAMPLER_1D && type <= GL_SAMPLER_2D_RECT_SHADOW) ||
           (type >= GL_SAMPLER_1D_ARRAY && type <= GL_SAMPLER_CUBE_SHADOW) ||
           (type >= GL_INT_SAMPLER_1D && type <= GL_UNSIGNED_INT_SAMPLER_BUFFER) ||
           (type >= GL_SAMPLER_2D_MULTISAMPLE && type <= GL_UNSIGNED_INT_SAMPLER_2D_MULTISAMPLE_ARRAY);
}

struct ActiveUniform {
    QByteArray name;
    GLenum type = 0;
    GLint size = 0; // elements of an array
    GLint location = -1;
};

ActiveUniform activeUniform(Gl& gl, GLuint program, GLuint index) {
    std::array<char, 256> buffer{};
    ActiveUniform uniform;
    gl.glGetActiveUniform(program, index, static_cast<GLsizei>(buffer.size()), nullptr, &uniform.size,
                          &uniform.type, buffer.data());
    uniform.name = buffer.data();
    uniform.location = gl.glGetUniformLocation(program, uniform.name.constData());
    return uniform;
}

UserUniform userUniform(Gl& gl, GLuint program, const ActiveUniform& active, UniformSpec::Type type) {
    UserUniform uniform;
    uniform.location = active.location;
    uniform.spec.name = QString::fromLatin1(active.name);
    uniform.spec.type = type;
    if (type == UniformSpec::Type::Bool || type == UniformSpec::Type::Int) {
        GLint value = 0;
        gl.glGetUniformiv(program, active.location, &value);
        uniform.spec.initial.numbers[0] = static_cast<float>(value);
    } else if (type != UniformSpec::Type::Sampler2D) {
        gl.glGetUniformfv(program, active.location, uniform.spec.initial.numbers.data());
    }
    return uniform;
}

// Drivers list uniforms in any order; people read them in that of the file.
void sortAsWritten(std::vector<UserUniform>& uniforms, const QByteArray& text) {
    const auto place = [&text](const UserUniform& uniform) {
        const QByteArray declared = ' ' + uniform.spec.name.toLatin1();
        return std::pair(text.indexOf(declared + ';'), text.indexOf(declared));
    };
    std::stable_sort(uniforms.begin(), uniforms.end(),
                     [&](const UserUniform& a, const UserUniform& b) { return place(a) < place(b); });
}

} // namespace

std::vector<UserUniform> findUserUniforms(Gl& gl, GLuint program, std::span<const ShaderStage> stages,
                                          bool (*ours)(const QByteArray& name), Problems& problems) {
    std::vector<QByteArray> sources;
    for (const ShaderStage& stage : stages)
        sources.push_back(stage.source.text);
    std::vector<UserUniform> uniforms;
    GLint count = 0;
    gl.glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    GLint strayUnit = kLastUnit;
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
        const ActiveUniform active = activeUniform(gl, program, i);
        if (active.location < 0 || ours(active.name.split('[').constFirst())) // of an array the name of all
            continue;
        const std::optional<UniformSpec::Type> type = typeOf(active.type);
        if (type && active.size == 1) {
            uniforms.push_back(userUniform(gl, program, active, *type));
            annotate(uniforms.back().spec, sources);
            continue;
        }
        problems.append(
            {stages.back().source.files.constFirst(), 0,
             QStringLiteral("the uniform %1 has no control: only float, int, bool, vec2 to vec4 and "
                            "sampler2D have, and no arrays")
                 .arg(QString::fromLatin1(active.name))});
        // Two samplers of different types on one unit, and nothing would be drawn.
        if (isSampler(active.type)) {
            gl.glUseProgram(program);
            gl.glUniform1i(active.location, strayUnit--);
        }
    }
    sortAsWritten(uniforms, sources.back());
    return uniforms;
}

} // namespace clothlab::render
