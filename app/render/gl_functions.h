// The one place that says which OpenGL the renderer speaks: 3.3 core.
#pragma once

#include <QOpenGLFunctions_3_3_Core>

namespace clothlab::render {

using Gl = QOpenGLFunctions_3_3_Core;

} // namespace clothlab::render
