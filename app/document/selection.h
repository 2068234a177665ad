#pragma once

#include "simcore/cloth/grid.h"

#include <QMetaType>

#include <optional>
#include <vector>

namespace clothlab {

// Point masses and springs by number. What was selected last is the active one, at the end of its list.
struct Selection {
    enum class Kind { Point, Spring };
    struct Item {
        Kind kind = Kind::Point;
        int number = 0;
        friend bool operator==(const Item&, const Item&) = default;
    };
    std::vector<Item> items;
    friend bool operator==(const Selection&, const Selection&) = default;

    bool empty() const { return items.empty(); }
    bool contains(Item item) const;
    std::optional<Item> active() const;

    void add(Item item); // makes it the active one
    void remove(Item item);
    void prune(const Grid& grid); // removes what the grid does not have
};

} // namespace clothlab
