// The files that a scene names: textures, the cube map, and those of samplers of a shader.
#pragma once

#include "simcore/scene/scene.h"

#include <QString>

namespace clothlab {

// A scene file names them relative to its own folder, so that both can be moved together; in memory they are
// named absolutely, so that a scene may be saved elsewhere. Empty names, what comes with the program, stay.
Scene withAbsoluteFiles(Scene scene, const QString& folder);
Scene withRelativeFiles(Scene scene, const QString& folder);

} // namespace clothlab
