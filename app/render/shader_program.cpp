#include "app/render/shader_program.h"

#include "app/render/shader_log.h"

#include <QRegularExpression>

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

namespace clothlab::render {
namespace {

constexpr std::array<const char*, static_cast<std::size_t>(Uniform::Count)> kUniformNames{
    "u_model",           "u_view_projection",
    "u_color",           "u_cam_pos",
    "u_light_pos",       "u_light_intensity",
    "u_normal_scaling",  "u_height_scaling",
    "u_texture_1",       "u_texture_2",
    "u_texture_3",       "u_texture_4",
    "u_texture_1_size",  "u_texture_2_size",
    "u_texture_3_size",  "u_texture_4_size",
    "u_texture_cubemap", "u_cubemap_levels",
    "u_irradiance",      "u_back_color",
    "u_two_sided",       "u_time",
    "u_shadow_map",      "u_shadow_matrix",
    "u_shadow_strength", "u_strain_range",
    "u_strain_colors",   "u_by_strain",
    "u_viewport",        "u_pixel_size",
    "u_depth_slope",     "u_depth_bias",
    "u_width",           "u_max_fill",
    "u_radius",
};

constexpr std::array<const char*, kRest + 1> kAttributeNames{"in_position", "in_normal", "in_tangent",
                                                             "in_uv",       "in_strain", "in_rest"};

bool isOurs(const QByteArray& name) {
    return std::find(kUniformNames.begin(), kUniformNames.end(), name) != kUniformNames.end();
}

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
    return (type >= GL_SAMPLER_1D && type <= GL_SAMPLER_2D_RECT_SHADOW) ||
           (type >= GL_SAMPLER_1D_ARRAY && type <= GL_SAMPLER_CUBE_SHADOW) ||
           (type >= GL_INT_SAMPLER_1D && type <= GL_UNSIGNED_INT_SAMPLER_BUFFER);
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

GLuint compileStage(Gl& gl, const ShaderStage& stage, Problems& problems) {
    const GLuint shader = gl.glCreateShader(stage.type);
    const char* text = stage.source.text.constData();
    const auto length = static_cast<GLint>(stage.source.text.size());
    gl.glShaderSource(shader, 1, &text, &length);
    gl.glCompileShader(shader);
    GLint compiled = GL_FALSE;
    gl.glGetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (compiled == GL_TRUE)
        return shader;
    GLint logLength = 0;
    gl.glGetShaderiv(shader, GL_INFO_LOG_LENGTH, &logLength);
    QByteArray log(std::max(logLength, 1), '\0');
    gl.glGetShaderInfoLog(shader, static_cast<GLsizei>(log.size()), nullptr, log.data());
    const Problems said = readShaderLog(stage.source.files, QString::fromUtf8(log.constData()));
    problems += said.isEmpty()
                    ? Problems{{stage.source.files.constFirst(), 0, QStringLiteral("does not compile")}}
                    : said;
    gl.glDeleteShader(shader);
    return 0;
}

Problem linkFailure(Gl& gl, GLuint program, std::span<const ShaderStage> stages) {
    GLint logLength = 0;
    gl.glGetProgramiv(program, GL_INFO_LOG_LENGTH, &logLength);
    QByteArray log(std::max(logLength, 1), '\0');
    gl.glGetProgramInfoLog(program, static_cast<GLsizei>(log.size()), nullptr, log.data());
    // With the fragment shader's file, which is the one that is being written.
    QString file;
    for (const ShaderStage& stage : stages)
        file = stage.source.files.constFirst();
    return {file, 0,
            QStringLiteral("does not link with its vertex shader: %1")
                .arg(QString::fromUtf8(log.constData()).trimmed().replace(u'\n', QLatin1String("; ")))};
}

} // namespace

bool ShaderProgram::build(Gl& gl, std::span<const ShaderStage> stages, Problems& problems) {
    std::vector<GLuint> shaders;
    bool good = true;
    for (const ShaderStage& stage : stages) {
        shaders.push_back(compileStage(gl, stage, problems));
        good = good && shaders.back() != 0;
    }
    GLuint program = 0;
    if (good) {
        program = gl.glCreateProgram();
        for (const GLuint shader : shaders)
            gl.glAttachShader(program, shader);
        for (std::size_t i = 0; i < kAttributeNames.size(); ++i)
            gl.glBindAttribLocation(program, static_cast<GLuint>(i), kAttributeNames[i]);
        gl.glLinkProgram(program);
        GLint linked = GL_FALSE;
        gl.glGetProgramiv(program, GL_LINK_STATUS, &linked);
        good = linked == GL_TRUE;
        if (!good)
            problems.append(linkFailure(gl, program, stages));
    }
    for (const GLuint shader : shaders)
        gl.glDeleteShader(shader); // a program keeps what is attached to it
    if (!good) {
        gl.glDeleteProgram(program);
        return false;
    }
    destroy(gl);
    m_id = program;
    for (std::size_t i = 0; i < kUniformNames.size(); ++i)
        m_locations[i] = gl.glGetUniformLocation(program, kUniformNames[i]);
    for (std::size_t i = 0; i < kAttributeNames.size(); ++i)
        m_attributes[i] = gl.glGetAttribLocation(program, kAttributeNames[i]) >= 0;
    findUniforms(gl, stages, problems);
    return true;
}

void ShaderProgram::findUniforms(Gl& gl, std::span<const ShaderStage> stages, Problems& problems) {
    std::vector<QByteArray> sources;
    for (const ShaderStage& stage : stages)
        sources.push_back(stage.source.text);
    const QString& file = stages.back().source.files.constFirst();
    m_userUniforms.clear();
    int samplers = 0;
    int spareUnit = kFirstSpareUnit;
    GLint count = 0;
    gl.glGetProgramiv(m_id, GL_ACTIVE_UNIFORMS, &count);
    for (GLint i = 0; i < count; ++i) {
        std::array<char, 256> buffer{};
        GLint size = 0;
        GLenum type = 0;
        gl.glGetActiveUniform(m_id, static_cast<GLuint>(i), static_cast<GLsizei>(buffer.size()), nullptr,
                              &size, &type, buffer.data());
        const QByteArray name(buffer.data());
        const GLint location = gl.glGetUniformLocation(m_id, name.constData());
        if (location < 0 || isOurs(name.left(name.indexOf('['))) || isOurs(name))
            continue;
        const std::optional<UniformSpec::Type> known = typeOf(type);
        if (!known || size != 1) {
            problems.append(withoutControl(file, name));
            // Two kinds of sampler at one unit, and nothing would be drawn.
            if (isSampler(type) && type != GL_SAMPLER_2D && spareUnit < kUnits) {
                use(gl);
                gl.glUniform1i(location, spareUnit++);
            }
        } else if (*known == UniformSpec::Type::Sampler2D && ++samplers > kMostUserSamplers) {
            problems.append(oneTooMany(file, name));
        } else {
            addUserUniform(gl, name, *known, location, sources);
        }
    }
    sortAsDeclared(sources.back());
}

void ShaderProgram::addUserUniform(Gl& gl, const QByteArray& name, UniformSpec::Type type, GLint location,
                                   const std::vector<QByteArray>& sources) {
    UserUniform& uniform = m_userUniforms.emplace_back();
    uniform.location = location;
    uniform.spec.name = QString::fromLatin1(name);
    uniform.spec.type = type;
    if (type == UniformSpec::Type::Bool || type == UniformSpec::Type::Int) {
        GLint value = 0;
        gl.glGetUniformiv(m_id, location, &value);
        uniform.spec.initial.numbers[0] = static_cast<float>(value);
    } else if (type != UniformSpec::Type::Sampler2D) {
        gl.glGetUniformfv(m_id, location, uniform.spec.initial.numbers.data());
    }
    annotate(uniform.spec, sources);
}

// Drivers list them in any order; people read them in that of the file. Those of the vertex shader alone come
// last.
void ShaderProgram::sortAsDeclared(const QByteArray& source) {
    const QString text = QString::fromUtf8(source);
    const auto place = [&text](const UserUniform& uniform) {
        const QRegularExpression declaration(
            QStringLiteral("\\buniform\\s+\\w+\\s+%1\\b").arg(QRegularExpression::escape(uniform.spec.name)));
        const qsizetype index = text.indexOf(declaration);
        return index < 0 ? text.size() : index;
    };
    std::stable_sort(m_userUniforms.begin(), m_userUniforms.end(),
                     [&](const UserUniform& a, const UserUniform& b) { return place(a) < place(b); });
}

void ShaderProgram::destroy(Gl& gl) {
    gl.glDeleteProgram(m_id);
    *this = ShaderProgram();
}

void ShaderProgram::set(Gl& gl, Uniform uniform, int value) const {
    gl.glUniform1i(location(uniform), value);
}

void ShaderProgram::set(Gl& gl, Uniform uniform, float value) const {
    gl.glUniform1f(location(uniform), value);
}

void ShaderProgram::set(Gl& gl, Uniform uniform, const QVector2D& value) const {
    gl.glUniform2f(location(uniform), value.x(), value.y());
}

void ShaderProgram::set(Gl& gl, Uniform uniform, const QVector3D& value) const {
    gl.glUniform3f(location(uniform), value.x(), value.y(), value.z());
}

void ShaderProgram::set(Gl& gl, Uniform uniform, const QVector4D& value) const {
    gl.glUniform4f(location(uniform), value.x(), value.y(), value.z(), value.w());
}

void ShaderProgram::set(Gl& gl, Uniform uniform, const QMatrix4x4& value) const {
    gl.glUniformMatrix4fv(location(uniform), 1, GL_FALSE, value.constData());
}

void ShaderProgram::set(Gl& gl, Uniform uniform, std::span<const QVector3D> values) const {
    static_assert(sizeof(QVector3D) == 3 * sizeof(float));
    gl.glUniform3fv(location(uniform), static_cast<GLsizei>(values.size()),
                    reinterpret_cast<const GLfloat*>(values.data()));
}

void ShaderProgram::set(Gl& gl, const UserUniform& uniform, const std::array<float, 4>& numbers) const {
    switch (uniform.spec.type) {
    case UniformSpec::Type::Bool:
    case UniformSpec::Type::Int:
    case UniformSpec::Type::Sampler2D: // its texture unit
        gl.glUniform1i(uniform.location, static_cast<GLint>(std::lround(numbers[0])));
        break;
    case UniformSpec::Type::Float:
        gl.glUniform1f(uniform.location, numbers[0]);
        break;
    case UniformSpec::Type::Vec2:
        gl.glUniform2fv(uniform.location, 1, numbers.data());
        break;
    case UniformSpec::Type::Vec3:
        gl.glUniform3fv(uniform.location, 1, numbers.data());
        break;
    case UniformSpec::Type::Vec4:
        gl.glUniform4fv(uniform.location, 1, numbers.data());
        break;
    }
}

} // namespace clothlab::render
