// Which points the springs of a grid join, as index pairs for GL_LINES.
#pragma once

#include <cstdint>
#include <vector>

namespace clothlab::render {

enum class SpringType { Structural, Shearing, Bending }; // in the order of RenderFrame::springsDrawn

inline constexpr int kSpringTypes = 3;

// Two indices a spring, each spring once: structural to (-1, 0) and (0, -1), shearing to (-1, -1) and (+1,
// -1), bending to (-2, 0) and (0, -2). Empty where the grid has no room for such a spring.
std::vector<std::uint32_t> springIndices(int width, int height, SpringType type);

} // namespace clothlab::render
