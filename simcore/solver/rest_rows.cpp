#include "simcore/solver/rest_rows.h"

#include <map>

namespace clothlab {

RestRows::RestRows(const Sheet& sheet, const RowLayout& layout) {
    std::map<Row, const double*> known; // rest lengths are numbers, so the order of rows is total
    const auto stored = [&](const Row& row) {
        const auto [at, isNew] = known.try_emplace(row, nullptr);
        if (isNew)
            at->second = m_stored.emplace_back(row).data();
        return at->second;
    };
    const Row none(std::size_t(layout.stride), kNoSpring);
    for (int s = 0; s < int(kStencils.size()); ++s) {
        const Stencil& stencil = kStencils[std::size_t(s)];
        const StencilRange range = sheet.grid.range(stencil);
        std::vector<const double*>& rows = m_rows[std::size_t(s)];
        rows.assign(std::size_t(layout.height + RowLayout::kRowsAfter), stored(none));
        for (int y = range.yBegin; y < range.yEnd; ++y) {
            Row row = none;
            for (int x = range.xBegin; x < range.xEnd; ++x)
                row[std::size_t(x)] = sheet.restLengthOf(
                    {s, sheet.grid.index(x, y), sheet.grid.index(x + stencil.dx, y + stencil.dy)});
            rows[std::size_t(y)] = stored(row);
        }
    }
}

std::size_t RestRows::bytes() const {
    std::size_t sum = 0;
    for (const Row& row : m_stored)
        sum += row.capacity() * sizeof(double);
    for (const auto& rows : m_rows)
        sum += rows.capacity() * sizeof(double*);
    return sum;
}

} // namespace clothlab
