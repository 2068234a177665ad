// Frames as pictures: a PNG each, or a video of all.
#pragma once

#include "app/export/ffmpeg.h"
#include "app/export/frame_painter.h"
#include "simcore/export/frame_writer.h"

#include <atomic>

namespace clothlab {

// Both are made and destroyed in the GUI's thread; in between all calls belong to one thread, a QThread or
// the GUI's, and the last of them is finish() or abandon(). Painters paint only between the first and that.

// As makeSequenceWriter().
std::unique_ptr<FrameWriter> makePngWriter(std::function<std::string(int)> pathOf,
                                           std::unique_ptr<FramePainter> painter);

// The video is at path after finish(), and nothing of it otherwise. While `stop` is true its functions come
// back with trouble instead of waiting for ffmpeg.
std::unique_ptr<FrameWriter> makeVideoWriter(const std::string& path, VideoFormat format,
                                             double framesPerSecond, std::unique_ptr<FramePainter> painter,
                                             const std::atomic<bool>& stop);

} // namespace clothlab
