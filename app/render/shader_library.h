// Finds shader files, and keeps the programs made of them.
#pragma once

#include "app/render/problem.h"
#include "app/render/shader_program.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace clothlab::render {

// Names of the surface shaders in `directory` (NAME.frag, not in subfolders), sorted, with Wireframe first if
// there is one. Empty if there is no such directory.
QStringList listShaders(const QString& directory);

// Whether the shader of that name has a vertex shader of its own that takes in_strain. Looks at its text
// only.
bool takesStrain(const QString& directory, const QString& name);

// NAME.frag is linked with NAME.vert of the same directory if there is one, else with Default.vert there,
// else with the Default.vert that is part of the program. Wireframe.frag is linked with the internal line
// shaders, which provide the same varyings. A shader that can't be read, compiled or linked says so in its
// problems, and what was last good stays: for surfaces the shader drawn before, else a plain internal one.
class ShaderLibrary {
public:
    void setDirectory(const QString& directory);

    // Reads the files again the next time they are needed.
    void reload();

    // Builds the internal programs. False, with the reason, if one does not build: then nothing can be drawn.
    bool initialize(Gl& gl, QString* error);
    void destroy(Gl& gl);

    // Always valid after initialize().
    const ShaderProgram& surface(Gl& gl, const QString& name);
    const ShaderProgram& springs(Gl& gl);
    const ShaderProgram& plainSurface() const { return m_plainSurface; }
    const ShaderProgram& lines() const { return m_lines; }
    const ShaderProgram& dots() const { return m_dots; }
    const ShaderProgram& ground() const { return m_ground; }
    const ShaderProgram& shadow() const { return m_shadow; }

    // What is wrong with the shader that surface() or springs() was last asked for; empty if nothing is.
    const Problems& surfaceProblems() const { return m_surfaceProblems; }
    const Problems& springsProblems() const { return m_springsProblems; }

    // The surface shader whose program surface() last returned; empty for the plain one. And what its user
    // may set.
    const QString& surfaceInUse() const { return m_goodSurfaceName; }
    const std::vector<UserUniform>& surfaceUniforms() const { return m_surface.userUniforms(); }
    const std::vector<UserUniform>& springUniforms() const { return m_springs.userUniforms(); }

    // How many programs were built so far: when it grows, the above may be others.
    int builds() const { return m_builds; }

private:
    bool buildInternal(Gl& gl, Problems& problems);

    QString m_directory;

    QString m_surfaceName;                        // that was last tried
    QString m_goodSurfaceName;                    // that came out well: of m_surface
    std::vector<ShaderStage> m_goodSurfaceStages; // to make it anew in another context
    ShaderProgram m_surface;
    int m_builds = 0;
    Problems m_surfaceProblems;

    bool m_springsTried = false;
    ShaderProgram m_springs;
    Problems m_springsProblems;

    ShaderProgram m_plainSurface;
    ShaderProgram m_lines;
    ShaderProgram m_dots;
    ShaderProgram m_ground;
    ShaderProgram m_shadow;
};

} // namespace clothlab::render
