// Words of the renderer that the user sees.
#pragma once

#include <QCoreApplication>

namespace clothlab::render {

inline QString tr(const char* text) {
    return QCoreApplication::translate("Render", text);
}

} // namespace clothlab::render
