#pragma once

#include <QImage>
#include <QString>

#include <optional>

namespace clothlab {

// Writes a PNG, whole or not at all. Returns what went wrong, in words.
std::optional<QString> savePicture(const QImage& image, const QString& path);

} // namespace clothlab
