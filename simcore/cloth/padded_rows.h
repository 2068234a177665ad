// The layout the solver works on: a structure of arrays whose rows are padded, so that vector code may go
// past either end of a row.
#pragma once

#include "simcore/cloth/cloth_state.h"

#include <cstddef>
#include <memory>

namespace clothlab {

// Slot of point (x, y): y * stride + x. Around the points of a row there are slots that belong to that row
// alone: two before the first, and after the last up to a multiple of kLanes and one more. Whole rows lie
// before row 0 and after the last. All of these hold finite numbers that no spring joins.
struct RowLayout {
    static constexpr int kLanes = 8; // doubles in the widest vector in use
    static constexpr int kRowsBefore = 2;
    static constexpr int kRowsAfter = 3;

    int width = 0;
    int height = 0;
    int stride = 0; // an odd multiple of four

    RowLayout() = default;
    explicit RowLayout(const Grid& grid)
        : width(grid.width), height(grid.height), stride(spread(grid.width + kLanes + 1)) {}

    // The next length from which arrays or rows that follow each other come to lie all over a page: loads and
    // stores at the same place of different pages hold each other up.
    static constexpr int spread(int length) { return (length + 3) / 8 * 8 + 4; }

    int slot(int x, int y) const { return y * stride + x; }
    int slotCount() const { return height * stride; } // of the points and what is around them
};

// Rows [begin, end).
struct RowRange {
    int begin = 0;
    int end = 0;
};

// A pointer to slot 0 of each coordinate.
template <typename T>
struct BasicPointRows {
    T* x = nullptr;
    T* y = nullptr;
    T* z = nullptr;
    operator BasicPointRows<const T>() const { return {x, y, z}; }
};
using PointRows = BasicPointRows<double>;
using ConstPointRows = BasicPointRows<const double>;

// Several arrays of a layout in one block of memory, all zero at first. They begin at different places of a
// page: at the same one they would drive each other out of the first-level cache.
class RowArrays {
public:
    RowArrays() = default;
    RowArrays(const RowLayout& layout, int count);

    double* array(int n) { return m_block.get() + std::size_t(n) * m_spacing + m_first; }
    PointRows points(int first) { return {array(first), array(first + 1), array(first + 2)}; }
    std::size_t bytes() const { return m_bytes; }

private:
    struct Free {
        void operator()(double* block) const;
    };
    std::unique_ptr<double[], Free> m_block;
    std::size_t m_spacing = 0; // from an array to the next
    std::size_t m_first = 0;   // slot 0 within an array
    std::size_t m_bytes = 0;
};

void copyToRows(const PointArray& points, const RowLayout& layout, PointRows rows);
void copyFromRows(ConstPointRows rows, const RowLayout& layout, PointArray& points); // of the right size

} // namespace clothlab
