#include "app/render/irradiance.h"

#include <cmath>
#include <numbers>

namespace clothlab::render {
namespace {

constexpr float kPi = std::numbers::pi_v<float>;

std::array<float, 256> decodingTable() {
    std::array<float, 256> table{};
    for (std::size_t i = 0; i < table.size(); ++i) {
        const float encoded = static_cast<float>(i) / 255;
        table[i] = encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
    }
    return table;
}

// The polynomials of the nine harmonics, in the order of Irradiance.
std::array<float, 9> polynomials(const QVector3D& n) {
    const float x = n.x();
    const float y = n.y();
    const float z = n.z();
    return {1, y, z, x, x * y, y * z, 3 * z * z - 1, x * z, x * x - y * y};
}

// The square of each harmonic's constant, times what a cosine lobe leaves of its band (1, 2/3, 1/4).
constexpr std::array<float, 9> kWeights{1 / (4 * kPi),         3 / (4 * kPi) * 2 / 3, 3 / (4 * kPi) * 2 / 3,
                                        3 / (4 * kPi) * 2 / 3, 15 / (4 * kPi) / 4,    15 / (4 * kPi) / 4,
                                        5 / (16 * kPi) / 4,    15 / (4 * kPi) / 4,    15 / (16 * kPi) / 4};

void addFace(const Image& image, std::size_t face, Irradiance& sums, float& solidAngle) {
    static const std::array<float, 256> decoded = decodingTable();
    for (int row = 0; row < image.height; ++row) {
        for (int column = 0; column < image.width; ++column) {
            const float s = 2 * (static_cast<float>(column) + 0.5F) / static_cast<float>(image.width) - 1;
            const float t = 2 * (static_cast<float>(row) + 0.5F) / static_cast<float>(image.height) - 1;
            const float lengthSquared = 1 + s * s + t * t;
            const float weight = 4 / (static_cast<float>(image.width * image.height) * lengthSquared *
                                      std::sqrt(lengthSquared));
            const std::uint8_t* texel =
                image.rgba.data() + 4 * (static_cast<std::ptrdiff_t>(row) * image.width + column);
            const QVector3D light(decoded[texel[0]], decoded[texel[1]], decoded[texel[2]]);
            const std::array<float, 9> values =
                polynomials(cubeDirection(face, s, t) / std::sqrt(lengthSquared));
            for (std::size_t i = 0; i < values.size(); ++i)
                sums[i] += weight * values[i] * light;
            solidAngle += weight;
        }
    }
}

} // namespace

QVector3D cubeDirection(std::size_t face, float s, float t) {
    switch (face) {
    case 0:
        return {1, -t, -s};
    case 1:
        return {-1, -t, s};
    case 2:
        return {s, 1, t};
    case 3:
        return {s, -1, -t};
    case 4:
        return {s, -t, 1};
    default:
        return {-s, -t, -1};
    }
}

Irradiance irradianceOf(const CubeImages& faces) {
    Irradiance sums{};
    float solidAngle = 0;
    for (std::size_t face = 0; face < faces.size(); ++face)
        addFace(faces[face], face, sums, solidAngle);
    if (!(solidAngle > 0))
        return sums;
    // The sum of the texels' solid angles is 4 pi but for rounding.
    for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i] *= kWeights[i] * 4 * kPi / solidAngle;
    return sums;
}

} // namespace clothlab::render
