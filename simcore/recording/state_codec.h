// A whole state, packed without loss. docs/clothtake.md has the format.
#pragma once

#include "simcore/cloth/cloth_state.h"

#include <optional>
#include <string>
#include <string_view>

namespace clothlab {

std::string packState(const Grid& grid, const ClothState& state); // precondition: points as the grid has

// Nothing if the bytes are no state of this grid.
std::optional<ClothState> unpackState(const Grid& grid, std::string_view bytes);

} // namespace clothlab
