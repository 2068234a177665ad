// A sequence of files that is there as a whole or not at all.
#pragma once

#include "simcore/export/frame_writer.h"

#include <functional>
#include <memory>

namespace clothlab {

// Makes a writer of a sequence, a file a frame, that writes to these paths.
using MakeSequence = std::function<std::unique_ptr<FrameWriter>(std::function<std::string(int)> pathOf)>;

// Writes the sequence into a hidden folder beside its files and, once it is complete, moves them to where
// they belong, over those that are there. Without finish() nothing has changed. pathOf: of the frames 0, 1,
// …, all in one folder.
std::unique_ptr<FrameWriter> makeStagedSequence(std::function<std::string(int)> pathOf,
                                                const MakeSequence& makeSequence);

} // namespace clothlab
