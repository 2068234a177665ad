// Drivers' compiler logs, in one form for people.
#pragma once

#include "app/render/problem.h"

#include <QString>
#include <QStringList>

namespace clothlab::render {

// One problem a non-empty line of `log`, with file and line where the driver names them (Mesa, NVIDIA, and
// the `ERROR: 0:12:` form of AMD, Intel and Apple are understood), else with the first file. Lines from
// kLinesPerFile on say the file; for others it is the number before the line, and the first file if there is
// no such. files is not empty.
Problems readShaderLog(const QStringList& files, const QString& log);

} // namespace clothlab::render
