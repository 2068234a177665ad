#pragma once

#include <QString>

namespace clothlab {

// The folder of data that comes with the program ("shaders", "scenes", "textures"): of the source tree when
// run from a build of it, else the installed one. Empty if there is neither.
QString dataDirectory(const QString& name);

} // namespace clothlab
