#include "app/document/selection.h"

#include <algorithm>

namespace clothlab {

bool Selection::contains(Item item) const {
    return std::ranges::find(items, item) != items.end();
}

std::optional<Selection::Item> Selection::active() const {
    return items.empty() ? std::nullopt : std::optional(items.back());
}

void Selection::add(Item item) {
    remove(item);
    items.push_back(item);
}

void Selection::remove(Item item) {
    std::erase(items, item);
}

void Selection::prune(const Grid& grid) {
    std::erase_if(items, [&](const Item& item) {
        const int count = item.kind == Kind::Point ? grid.pointCount() : grid.springCount();
        return item.number < 0 || item.number >= count;
    });
}

} // namespace clothlab
