#include "simcore/cloth/grid.h"

#include <algorithm>
#include <cassert>

namespace clothlab {

StencilRange Grid::range(const Stencil& stencil) const {
    return {std::max(0, -stencil.dx), width - std::max(0, stencil.dx), std::max(0, -stencil.dy),
            height - std::max(0, stencil.dy)};
}

int Grid::springCount() const {
    int count = 0;
    for (const Stencil& stencil : kStencils)
        count += range(stencil).count();
    return count;
}

int Grid::springCount(SpringType type) const {
    int count = 0;
    for (const Stencil& stencil : kStencils)
        count += stencil.type == type ? range(stencil).count() : 0;
    return count;
}

Spring Grid::spring(int number) const {
    assert(number >= 0 && number < springCount());
    int stencil = 0;
    while (number >= range(kStencils[std::size_t(stencil)]).count())
        number -= range(kStencils[std::size_t(stencil++)]).count();
    const Stencil& s = kStencils[std::size_t(stencil)];
    const StencilRange r = range(s);
    const int x = r.xBegin + number % r.columns();
    const int y = r.yBegin + number / r.columns();
    return {stencil, index(x, y), index(x + s.dx, y + s.dy)};
}

int Grid::springNumber(int stencil, int a) const {
    const StencilRange r = range(kStencils[std::size_t(stencil)]);
    const GridPoint p = place(a);
    if (p.x < r.xBegin || p.x >= r.xEnd || p.y < r.yBegin || p.y >= r.yEnd)
        return -1;
    int first = 0;
    for (int s = 0; s < stencil; ++s)
        first += range(kStencils[std::size_t(s)]).count();
    return first + (p.y - r.yBegin) * r.columns() + p.x - r.xBegin;
}

std::vector<int> Grid::springsOf(int point) const {
    std::vector<int> numbers;
    const GridPoint p = place(point);
    for (int s = 0; s < int(kStencils.size()); ++s) {
        const Stencil& stencil = kStencils[std::size_t(s)];
        if (const int starting = springNumber(s, point); starting >= 0)
            numbers.push_back(starting);
        const GridPoint other{p.x - stencil.dx, p.y - stencil.dy};
        if (other.x < 0 || other.x >= width || other.y < 0 || other.y >= height)
            continue;
        if (const int ending = springNumber(s, index(other)); ending >= 0)
            numbers.push_back(ending);
    }
    std::ranges::sort(numbers);
    return numbers;
}

std::string_view name(SpringType type) {
    constexpr std::array<std::string_view, kSpringTypes> names{"structural", "shearing", "bending"};
    return names[std::size_t(type)];
}

} // namespace clothlab
