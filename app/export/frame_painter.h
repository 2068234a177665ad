// Makes pictures of frames, one after the other.
#pragma once

#include "app/render/offscreen_picture.h"
#include "simcore/recording/recording.h"

#include <functional>

namespace clothlab {

// Made and destroyed in the GUI's thread; begin(), paint() and end() are called in one thread, which may be
// another. end() is called in any case, and may be called again.
class FramePainter {
public:
    virtual ~FramePainter() = default;
    virtual std::optional<std::string> begin() = 0; // what went wrong, in words
    virtual QImage paint(const Frame& frame) = 0;   // each of size()
    virtual void end() = 0;
    virtual QSize size() const = 0;
};

// What every picture of a sequence shows beside the positions of its frame.
struct PictureLook {
    render::RenderFrame frame;          // camera and look; the sheet is put in
    std::shared_ptr<const Scene> scene; // appearance and pins; files are named absolutely
    Sheet sheet;
    QSize size; // pixels
    render::PictureSource source;
    // Told in the thread that paints when there are others than in the picture before; may be empty.
    std::function<void(const render::Problems&)> onProblems{};
};

std::unique_ptr<FramePainter> makeFramePainter(PictureLook look);

} // namespace clothlab
