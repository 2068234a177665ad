#include "app/render/springs.h"

#include <array>

namespace clothlab::render {
namespace {

struct Offset {
    int x;
    int y;
};

constexpr std::array<std::array<Offset, 2>, kSpringTypes> kStencils{{
    {{{-1, 0}, {0, -1}}},
    {{{-1, -1}, {1, -1}}},
    {{{-2, 0}, {0, -2}}},
}};

} // namespace

std::vector<std::uint32_t> springIndices(int width, int height, SpringType type) {
    std::vector<std::uint32_t> indices;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            for (const Offset offset : kStencils[static_cast<std::size_t>(type)]) {
                const int otherX = x + offset.x;
                const int otherY = y + offset.y;
                if (otherX < 0 || otherX >= width || otherY < 0)
                    continue;
                indices.push_back(static_cast<std::uint32_t>(y * width + x));
                indices.push_back(static_cast<std::uint32_t>(otherY * width + otherX));
            }
        }
    }
    return indices;
}

} // namespace clothlab::render
