#include "app/render/shader_library.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <optional>

namespace clothlab::render {
namespace {

const QString kWireframe = QStringLiteral("Wireframe");
const QString kBuiltIn = QStringLiteral(":/clothlab/shaders/");
const QString kInternal = kBuiltIn + QStringLiteral("internal/");

struct StageFile {
    GLenum type;
    QString path;
};

// Empty if one of the files cannot be read.
std::vector<ShaderStage> readStages(std::initializer_list<StageFile> files, Problems& problems) {
    std::vector<ShaderStage> stages;
    for (const StageFile& file : files) {
        std::optional<ShaderSource> source = readShaderSource(file.path, kBuiltIn, problems);
        if (!source)
            return {};
        stages.push_back({file.type, std::move(*source)});
    }
    return stages;
}

bool build(Gl& gl, ShaderProgram& program, std::initializer_list<StageFile> files, Problems& problems) {
    const std::vector<ShaderStage> stages = readStages(files, problems);
    return !stages.empty() && program.build(gl, stages, problems);
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

bool takesStrain(const QString& directory, const QString& name) {
    QFile file(QDir(directory).filePath(name + QStringLiteral(".vert")));
    return QFileInfo(file).isFile() && file.open(QIODevice::ReadOnly) && file.readAll().contains("in_strain");
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
    // Programs of an earlier context that was lost have nothing to free. The surface's is made again from
    // what was good: its files may be broken by now.
    ShaderLibrary old = std::move(*this);
    *this = ShaderLibrary();
    m_directory = std::move(old.m_directory);
    m_builds = old.m_builds;
    Problems problems;
    const bool good = buildInternal(gl, problems);
    if (good && !old.m_goodSurfaceStages.empty() && m_surface.build(gl, old.m_goodSurfaceStages, problems)) {
        m_goodSurfaceName = std::move(old.m_goodSurfaceName);
        m_goodSurfaceStages = std::move(old.m_goodSurfaceStages);
    }
    if (!good && error && !problems.isEmpty())
        *error = words(problems.constFirst());
    if (!good)
        destroy(gl);
    return good;
}

bool ShaderLibrary::buildInternal(Gl& gl, Problems& problems) {
    const auto pair = [&](ShaderProgram& program, const QString& vertices, const char* fragments) {
        return build(
            gl, program,
            {{GL_VERTEX_SHADER, vertices}, {GL_FRAGMENT_SHADER, kInternal + QLatin1String(fragments)}},
            problems);
    };
    const auto internal = [](const char* name) { return kInternal + QLatin1String(name); };
    return pair(m_plainSurface, kBuiltIn + QStringLiteral("Default.vert"), "surface.frag") &&
           pair(m_dots, internal("dot.vert"), "dot.frag") &&
           pair(m_ground, internal("ground.vert"), "ground.frag") &&
           pair(m_shadow, internal("shadow.vert"), "shadow.frag") &&
           build(gl, m_lines,
                 {{GL_VERTEX_SHADER, internal("line.vert")},
                  {GL_GEOMETRY_SHADER, internal("line.geom")},
                  {GL_FRAGMENT_SHADER, internal("line.frag")}},
                 problems);
}

void ShaderLibrary::destroy(Gl& gl) {
    for (ShaderProgram* program :
         {&m_surface, &m_springs, &m_plainSurface, &m_lines, &m_dots, &m_ground, &m_shadow})
        program->destroy(gl);
}

const ShaderProgram& ShaderLibrary::surface(Gl& gl, const QString& name) {
    if (name != m_surfaceName) {
        m_surfaceName = name;
        m_surfaceProblems.clear();
        const QDir directory(m_directory);
        std::vector<ShaderStage> stages =
            readStages({{GL_VERTEX_SHADER, vertexShaderFor(directory, name)},
                        {GL_FRAGMENT_SHADER, directory.filePath(name + QStringLiteral(".frag"))}},
                       m_surfaceProblems);
        if (!stages.empty() && m_surface.build(gl, stages, m_surfaceProblems)) {
            m_goodSurfaceName = name;
            m_goodSurfaceStages = std::move(stages);
            ++m_builds;
        }
    }
    return m_surface.isValid() ? m_surface : m_plainSurface;
}

const ShaderProgram& ShaderLibrary::springs(Gl& gl) {
    if (!m_springsTried) {
        m_springsTried = true;
        m_springsProblems.clear();
        const QString fragments = QDir(m_directory).filePath(kWireframe + QStringLiteral(".frag"));
        // A directory without one is none the worse for it.
        if (QFile::exists(fragments))
            build(gl, m_springs,
                  {{GL_VERTEX_SHADER, kInternal + QStringLiteral("line.vert")},
                   {GL_GEOMETRY_SHADER, kInternal + QStringLiteral("line.geom")},
                   {GL_FRAGMENT_SHADER, fragments}},
                  m_springsProblems);
        ++m_builds;
    }
    return m_springs.isValid() ? m_springs : m_lines;
}

} // namespace clothlab::render
