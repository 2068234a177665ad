// What the neighbours of a point say of it, for whole numbers in a grid.
#pragma once

#include "simcore/cloth/grid.h"

#include <array>
#include <cstdint>
#include <vector>

namespace clothlab {

// Weights of the points left, above, above left and above right, in 1/64. A row is predicted from the one
// above, whose ends count as going on with the same number, and from what of it is known; the first of a row
// has the point above as its left; the first row is predicted from the left alone, and its first is 0. All
// sums are modulo 2^32.
struct PointWeights {
    static constexpr int kShift = 6;
    std::int8_t left = 32, above = 32, aboveLeft = 0, aboveRight = 0;
};

// Weights with which the numbers of a grid are predicted with the least squares of errors, or nearly.
PointWeights fitWeights(const Grid& grid, const std::int32_t* values);

// The row before; at(-1) and at(width) are its ends.
class RowAbove {
public:
    explicit RowAbove(int width) : m_values(std::size_t(width) + 2) {}
    const std::int32_t* begin() const { return m_values.data() + 1; }
    void set(const std::int32_t* row);

private:
    std::vector<std::int32_t> m_values;
};

// errors = row - prediction. above: null for the first row.
void predictRow(const PointWeights& weights, int width, const RowAbove* above, const std::int32_t* row,
                std::int32_t* errors);

// The other way round, for three rows at a time: each number waits for the one before, and three can wait
// together. rows hold the errors at first.
void restoreRows(const std::array<PointWeights, 3>& weights, int width, const std::array<RowAbove, 3>* above,
                 const std::array<std::int32_t*, 3>& rows);

} // namespace clothlab
