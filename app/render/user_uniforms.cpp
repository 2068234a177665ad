#include "app/render/user_uniforms.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <optional>

namespace clothlab::render {
namespace {

// Texture units that nothing is bound to; OpenGL 3.3 has at least 48.
constexpr int kFirstSpareUnit = 16;
constexpr int kUnits = 48;

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

// Drivers list uniforms in any order; people read them in that of the file. Those of the vertex shader alone
// come last.
void sortAsWritten(std::vector<UserUniform>& uniforms, const QByteArray& source) {
    const QString text = QString::fromUtf8(source);
    const auto place = [&text](const UserUniform& uniform) {
        const QRegularExpression declaration(
            QStringLiteral("\\buniform\\s+\\w+\\s+%1\\b").arg(QRegularExpression::escape(uniform.spec.name)));
        const qsizetype index = text.indexOf(declaration);
        return index < 0 ? text.size() : index;
    };
    std::stable_sort(uniforms.begin(), uniforms.end(),
                     [&](const UserUniform& a, const UserUniform& b) { return place(a) < place(b); });
}

Problem withoutControl(const QString& file, const QByteArray& name) {
    return {file, 0,
            QStringLiteral("the uniform %1 has no control: only float, int, bool, vec2 to vec4 and "
                           "sampler2D have, and no arrays")
                .arg(QString::fromLatin1(name))};
}

Problem oneTooMany(const QString& file, const QByteArray& name) {
    return {file, 0,
            QStringLiteral("the texture %1 is one too many: a shader has up to %2 of its own")
                .arg(QString::fromLatin1(name))
                .arg(kMostUserSamplers)};
}

Problem ofAnotherType(const QString& file, const QByteArray& name) {
    return {file, 0,
            QStringLiteral("the uniform %1 has another type than what the program sets; it is not set")
                .arg(QString::fromLatin1(name))};
}

// Gathers the uniforms of one program.
class Finder {
public:
    Finder(Gl& gl, GLuint program, std::span<const ShaderStage> stages, Problems& problems)
        : m_gl(gl), m_program(program), m_file(stages.back().source.files.constFirst()),
          m_problems(problems) {
        for (const ShaderStage& stage : stages)
            m_sources.push_back(stage.source.text);
    }

    void addOurs(const ActiveUniform& active, GLenum type) {
        if (active.type == type)
            return;
        m_problems.append(ofAnotherType(m_file, active.name));
        m_found.ofAnotherType.push_back(active.location);
        putOutOfTheWay(active);
    }

    void addUsers(const ActiveUniform& active) {
        const std::optional<UniformSpec::Type> type = typeOf(active.type);
        if (!type || active.size != 1) {
            m_problems.append(withoutControl(m_file, active.name));
            putOutOfTheWay(active);
        } else if (*type == UniformSpec::Type::Sampler2D && ++m_samplers > kMostUserSamplers) {
            m_problems.append(oneTooMany(m_file, active.name));
        } else {
            m_found.ofTheUser.push_back(userUniform(m_gl, m_program, active, *type));
            annotate(m_found.ofTheUser.back().spec, m_sources);
        }
    }

    ProgramUniforms take() {
        sortAsWritten(m_found.ofTheUser, m_sources.back());
        return std::move(m_found);
    }

private:
    // Two kinds of sampler at one unit, and nothing would be drawn.
    void putOutOfTheWay(const ActiveUniform& active) {
        if (!isSampler(active.type) || active.type == GL_SAMPLER_2D || m_spareUnit >= kUnits)
            return;
        m_gl.glUseProgram(m_program);
        m_gl.glUniform1i(active.location, m_spareUnit++);
    }

    Gl& m_gl;
    GLuint m_program;
    QString m_file;
    Problems& m_problems;
    std::vector<QByteArray> m_sources;
    ProgramUniforms m_found;
    int m_samplers = 0;
    int m_spareUnit = kFirstSpareUnit;
};

} // namespace

ProgramUniforms findUniforms(Gl& gl, GLuint program, std::span<const ShaderStage> stages,
                             GLenum (*typeOfOurs)(const QByteArray& name), Problems& problems) {
    Finder finder(gl, program, stages, problems);
    GLint count = 0;
    gl.glGetProgramiv(program, GL_ACTIVE_UNIFORMS, &count);
    for (GLuint i = 0; i < static_cast<GLuint>(count); ++i) {
        const ActiveUniform active = activeUniform(gl, program, i);
        if (active.location < 0)
            continue;
        if (const GLenum type = typeOfOurs(active.name.split('[').constFirst());
            type != 0) // an array's name is its own
            finder.addOurs(active, type);
        else
            finder.addUsers(active);
    }
    return finder.take();
}

} // namespace clothlab::render
