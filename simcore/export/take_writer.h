// A run as a recording, .clothtake.
#pragma once

#include "simcore/export/frame_writer.h"

namespace clothlab {

// A file with one take of all frames, and checkpoints of every kFramesPerCheckpoint-th and the last. error:
// in metres, 0 keeps the bits; see FramePacker. version: of the program.
std::unique_ptr<FrameWriter> makeTakeWriter(const std::string& path, double error,
                                            const std::string& version);

} // namespace clothlab
