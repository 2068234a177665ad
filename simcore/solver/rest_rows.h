// Rest lengths of a sheet by stencil and row, as the kernels read them.
#pragma once

#include "simcore/kernels/kernels.h"

#include <array>
#include <deque>
#include <vector>

namespace clothlab {

// Rows that are equal to the last bit are stored once: those of a flat sheet take only a few values, so that
// a large one reads next to nothing from memory.
class RestRows {
public:
    RestRows() = default;
    RestRows(const Sheet& sheet, const RowLayout& layout);

    // Of the rows 0 … height - 1 and those after the last; kNoSpring where no spring starts.
    const double* const* of(int stencil) const { return m_rows[std::size_t(stencil)].data(); }
    std::size_t bytes() const;

private:
    using Row = std::vector<double>;
    std::deque<Row> m_stored; // never moves what it holds
    std::array<std::vector<const double*>, kStencils.size()> m_rows;
};

} // namespace clothlab
