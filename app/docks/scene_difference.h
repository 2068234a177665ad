#pragma once

#include "simcore/scene/scene.h"

#include <QStringList>

namespace clothlab {

// What makes one scene move otherwise than another, each in words: "Stiffness ks 5000 → 900 N/m". Empty if
// nothing does.
QStringList differences(const Scene& before, const Scene& after);

} // namespace clothlab
