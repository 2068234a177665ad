// Numbers and names as panels write them.
#pragma once

#include "simcore/cloth/grid.h"

#include <QColor>
#include <QString>

#include <string_view>

namespace clothlab {

inline QString toQString(std::string_view text) {
    return QString::fromUtf8(text.data(), static_cast<qsizetype>(text.size()));
}

QString typeName(SpringType type);   // "Structural"
QColor typeColor(SpringType type);   // in the theme at hand
QString significant(double value);   // six significant digits, "1.46667"
QString vectorText(const Vec3& v);   // "(0.5, 1, 0.25)", six significant digits each
QString groupedNumber(qint64 value); // "14 502", with narrow no-break spaces

} // namespace clothlab
