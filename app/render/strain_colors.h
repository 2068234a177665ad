// The colours of signed strain.
#pragma once

#include <QVector3D>

#include <algorithm>
#include <array>
#include <cmath>

namespace clothlab::render {

// At -1, -1/2, 0, 1/2 and 1 of the range, straight in between: compressed blue, unstrained grey, stretched
// red. Blue and red stay apart for every kind of colour-blindness, and grow darker from the grey outwards.
inline const std::array<QVector3D, 5> kStrainColors{
    QVector3D(0.11F, 0.33F, 0.78F), QVector3D(0.42F, 0.64F, 0.90F), QVector3D(0.74F, 0.74F, 0.74F),
    QVector3D(0.93F, 0.55F, 0.38F), QVector3D(0.78F, 0.12F, 0.14F)};

// The colour of a strain as a part of the range; beyond it that of its end.
inline QVector3D strainColor(float part) {
    constexpr auto last = kStrainColors.size() - 1;
    const float place = (std::clamp(part, -1.0F, 1.0F) + 1) / 2 * static_cast<float>(last);
    const std::size_t below = std::min(static_cast<std::size_t>(place), last - 1);
    const float rest = place - static_cast<float>(below);
    return (1 - rest) * kStrainColors[below] + rest * kStrainColors[below + 1];
}

} // namespace clothlab::render
