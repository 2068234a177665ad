// Frames from wherever they are into files, until all are written or somebody stops it.
#pragma once

#include "simcore/export/frame_writer.h"

#include <atomic>

namespace clothlab {

// Frames 0 … frames - 1 of one sheet. frame() is called by the thread of the export, in increasing order; it
// may take its time. It returns null, with the reason in words, for a frame that cannot be had.
struct FrameSource {
    int frames = 0;
    Sheet sheet;
    std::function<FramePointer(int frame, std::string& reason)> frame;
};

// Frames from first to last, both included, each `step` after the one before; rounded where it is not whole.
struct ExportRange {
    int first = 0;
    int last = 0;
    double step = 1; // 1 or more

    int count() const; // 0 if last < first
    int frameAt(int index) const;
};

enum class ExportEnd { Done, Cancelled, NoFrame, NotWritten };

struct ExportResult {
    ExportEnd end = ExportEnd::Done;
    std::string reason; // in words; of NoFrame and NotWritten
    int written = 0;    // frames
};

enum class IfAFrameFails { WriteNothing, KeepThoseBefore };

// Takes the frames through the writer, from begin() to finish(). Unless it ends with Done, the writer is
// abandoned in this thread; with KeepThoseBefore, a frame that cannot be had is instead the end of the file.
// After each frame `progress` is told how many are written; it may be empty. Throws nothing.
ExportResult runExport(const FrameSource& source, const ExportRange& range, FrameWriter& writer,
                       const std::atomic<bool>& stop, const std::function<void(int written)>& progress = {},
                       IfAFrameFails ifAFrameFails = IfAFrameFails::WriteNothing);

} // namespace clothlab
