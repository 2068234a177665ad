#include "simcore/cloth/padded_rows.h"

#include <algorithm>
#include <cstdlib>
#include <new>

#if defined(__linux__)
#include <sys/mman.h>
#endif

namespace clothlab {
namespace {

constexpr std::size_t kCacheLine = 64;
constexpr std::size_t kPage = 4096;
constexpr std::size_t kLargePage = std::size_t(2) << 20U; // so that many rows need few entries of the TLB

std::size_t roundUp(std::size_t value, std::size_t multiple) {
    return (value + multiple - 1) / multiple * multiple;
}

} // namespace

void RowArrays::Free::operator()(double* block) const {
    std::free(block); // NOLINT(cppcoreguidelines-no-malloc): what aligned_alloc gave
}

RowArrays::RowArrays(const RowLayout& layout, int count) {
    const auto stride = std::size_t(layout.stride);
    m_first = RowLayout::kRowsBefore * stride + RowLayout::kLanes;
    const std::size_t slots =
        m_first + std::size_t(layout.slotCount()) + RowLayout::kRowsAfter * stride + RowLayout::kLanes;
    constexpr std::size_t apart = 5 * kCacheLine;
    m_spacing = (roundUp(slots * sizeof(double), kPage) + apart) / sizeof(double);
    m_bytes = std::size_t(count) * m_spacing * sizeof(double);
    const std::size_t alignment = m_bytes < kLargePage ? kCacheLine : kLargePage;
    m_bytes = roundUp(m_bytes, alignment);
    m_block.reset(static_cast<double*>(std::aligned_alloc(alignment, m_bytes)));
    if (!m_block)
        throw std::bad_alloc();
#if defined(__linux__)
    if (alignment == kLargePage)
        madvise(m_block.get(), m_bytes, MADV_HUGEPAGE); // a wish; nothing is lost if it is not granted
#endif
    std::fill_n(m_block.get(), m_bytes / sizeof(double), 0.0);
}

void copyToRows(const PointArray& points, const RowLayout& layout, PointRows rows) {
    for (int y = 0; y < layout.height; ++y) {
        const std::ptrdiff_t from = std::ptrdiff_t(y) * layout.width;
        std::copy_n(points.x.begin() + from, layout.width, rows.x + layout.slot(0, y));
        std::copy_n(points.y.begin() + from, layout.width, rows.y + layout.slot(0, y));
        std::copy_n(points.z.begin() + from, layout.width, rows.z + layout.slot(0, y));
    }
}

void copyFromRows(ConstPointRows rows, const RowLayout& layout, PointArray& points) {
    for (int y = 0; y < layout.height; ++y) {
        const std::ptrdiff_t to = std::ptrdiff_t(y) * layout.width;
        std::copy_n(rows.x + layout.slot(0, y), layout.width, points.x.begin() + to);
        std::copy_n(rows.y + layout.slot(0, y), layout.width, points.y.begin() + to);
        std::copy_n(rows.z + layout.slot(0, y), layout.width, points.z.begin() + to);
    }
}

} // namespace clothlab
