#include "app/render/shader_library.h"

#include "app/render/renderer.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <optional>

namespace clothlab::render {
namespace {

const QString kWireframe = QStringLiteral("Wireframe");
const QString kBuiltIn = QStringLiteral(":/clothlab/shaders/");

std::optional<ShaderStage> readStage(GLenum type, const QString& path, QStringList& messages) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        messages.append(
            QStringLiteral("%1: cannot be read: %2").arg(QFileInfo(path).fileName(), file.errorString()));
        return std::nullopt;
    }
    QByteArray source = file.readAll();
    if (source.startsWith("\xEF\xBB\xBF"))
        source.remove(0, 3); // some editors write a byte order mark, and GLSL wants #version first
    return ShaderStage{type, QFileInfo(path).fileName(), source};
}

bool build(Gl& gl, ShaderProgram& program, const std::vector<std::pair<GLenum, QString>>& files,
           QStringList& messages) {
    std::vector<ShaderStage> stages;
    for (const auto& [type, path] : files) {
        std::optional<ShaderStage> stage = readStage(type, path, messages);
        if (!stage)
            return false;
        stages.push_back(std::move(*stage));
    }
    return program.build(gl, stages, messages);
}

QString vertexShaderFor(const QDir& directory, const QString& name) {
    for (const QString& candidate : {name + QStringLiteral(".vert"), QStringLiteral("Default.vert")})
        if (directory.exists(candidate))
            return directory.filePath(candidate);
    return kBuiltIn + QStringLiteral("Default.vert");
}

} // namespace

QStringList listShaders(const QString& directory) {
    QStringList names;
    const QStringList files = directory.isEmpty()
                                  ? QStringList()
                                  : QDir(directory).entryList({QStringLiteral("*.frag")}, QDir::Files,
                                                              QDir::Name | QDir::IgnoreCase);
    for (const QString& file : files)
        names.append(QFileInfo(file).completeBaseName());
    if (names.removeOne(kWireframe))
        names.prepend(kWireframe);
    return names;
}

void ShaderLibrary::setDirectory(const QString& directory) {
    if (directory == m_directory)
        return;
    m_directory = directory;
    reload();
}

void ShaderLibrary::reload() {
    m_surfaceName.clear();
    m_springsTried = false;
}

bool ShaderLibrary::initialize(Gl& gl, QString* error) {
    const QString internal = kBuiltIn + QStringLiteral("internal/");
    const auto file = [&internal](const char* name) { return internal + QString::fromLatin1(name); };
    const std::pair<GLenum, QString> lineVertices{GL_VERTEX_SHADER, file("line.vert")};
    const std::pair<GLenum, QString> lineQuads{GL_GEOMETRY_SHADER, file("line.geom")};

    // Programs of an earlier context that was lost have nothing to free.
    QString directory = m_directory;
    *this = ShaderLibrary();
    m_directory = std::move(directory);

    QStringList messages;
    const bool good =
        build(gl, m_plainSurface,
              {{GL_VERTEX_SHADER, kBuiltIn + QStringLiteral("Default.vert")},
               {GL_FRAGMENT_SHADER, file("surface.frag")}},
              messages) &&
        build(gl, m_lines, {lineVertices, lineQuads, {GL_FRAGMENT_SHADER, file("line.frag")}}, messages) &&
        build(gl, m_dots, {{GL_VERTEX_SHADER, file("dot.vert")}, {GL_FRAGMENT_SHADER, file("dot.frag")}},
              messages) &&
        build(gl, m_ground,
              {{GL_VERTEX_SHADER, file("ground.vert")}, {GL_FRAGMENT_SHADER, file("ground.frag")}}, messages);
    if (!good && error)
        *error = messages.join(u'\n');
    if (!good)
        destroy(gl);
    return good;
}

void ShaderLibrary::destroy(Gl& gl) {
    for (ShaderProgram* program : {&m_surface, &m_springs, &m_plainSurface, &m_lines, &m_dots, &m_ground})
        program->destroy(gl);
}

const ShaderProgram& ShaderLibrary::surface(Gl& gl, const QString& name) {
    if (name != m_surfaceName) {
        m_surfaceName = name;
        m_surfaceMessages.clear();
        const QDir directory(m_directory);
        build(gl, m_surface,
              {{GL_VERTEX_SHADER, vertexShaderFor(directory, name)},
               {GL_FRAGMENT_SHADER, directory.filePath(name + QStringLiteral(".frag"))}},
              m_surfaceMessages);
        gatherMessages();
    }
    return m_surface.isValid() ? m_surface : m_plainSurface;
}

const ShaderProgram& ShaderLibrary::springs(Gl& gl) {
    if (!m_springsTried) {
        m_springsTried = true;
        m_springsMessages.clear();
        const QString internal = kBuiltIn + QStringLiteral("internal/");
        const QString fragments = QDir(m_directory).filePath(kWireframe + QStringLiteral(".frag"));
        // A directory without one is none the worse for it.
        if (QFile::exists(fragments))
            build(gl, m_springs,
                  {{GL_VERTEX_SHADER, internal + QStringLiteral("line.vert")},
                   {GL_GEOMETRY_SHADER, internal + QStringLiteral("line.geom")},
                   {GL_FRAGMENT_SHADER, fragments}},
                  m_springsMessages);
        gatherMessages();
    }
    return m_springs.isValid() ? m_springs : m_lines;
}

void ShaderLibrary::gatherMessages() {
    m_messages = m_surfaceMessages + m_springsMessages;
}

} // namespace clothlab::render
