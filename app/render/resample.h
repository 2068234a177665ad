// The sheet as a finer or coarser grid than the simulated one.
#pragma once

#include "app/render/render_frame.h"

namespace clothlab::render {

// Replaces `out` by the same sheet in cells × cells cells: a bicubic surface through the sheet's points
// (Catmull and Rom 1974, with straight ends), strains linear between them. Without pinned points and rest
// positions. A sheet whose positions don't fit its size gives an empty one. cells >= 1.
void resample(const SheetShape& sheet, int cells, SheetShape& out);

} // namespace clothlab::render
