// Drivers' compiler logs, in one form for people.
#pragma once

#include <QString>
#include <QStringList>

namespace clothlab::render {

// One entry a non-empty line of `log`, each beginning with `file:line: ` where the driver names a line (Mesa,
// NVIDIA, and the `ERROR: 0:12:` form of AMD, Intel and Apple are understood), else with `file: `.
QStringList readableShaderLog(const QString& file, const QString& log);

} // namespace clothlab::render
