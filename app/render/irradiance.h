// The light that a matt surface gets from all around.
#pragma once

#include "app/render/image_file.h"

#include <QVector3D>

#include <array>

namespace clothlab::render {

inline constexpr std::size_t kCubeFaces = 6; // +x, -x, +y, -y, +z, -z, as OpenGL counts them
using CubeImages = std::array<Image, kCubeFaces>;

// Nine coefficients of spherical harmonics, with which irradiance over pi in the direction n = (x, y, z) is
//
//   c0 + c1 y + c2 z + c3 x + c4 xy + c5 yz + c6 (3 z² - 1) + c7 xz + c8 (x² - y²)
//
// in linear light, within a few percent for any light that is not a point (Ramamoorthi and Hanrahan 2001,
// with the constants taken into the coefficients). The faces are square, sRGB, and need not have one size.
using Irradiance = std::array<QVector3D, 9>;
Irradiance irradianceOf(const CubeImages& faces);

// Direction, not of unit length, that a face shows at (s, t), each -1 … 1, t downwards in the image
// (OpenGL 3.3, table 3.19).
QVector3D cubeDirection(std::size_t face, float s, float t);

} // namespace clothlab::render
