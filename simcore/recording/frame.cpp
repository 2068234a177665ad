#include "simcore/recording/frame.h"

#include <utility>

namespace clothlab {

std::size_t bytesOf(const Frame& frame) {
    return sizeof(Frame) + 6 * sizeof(double) * frame.state.size();
}

FramePointer startFrame(std::shared_ptr<const Scene> scene) {
    Frame frame;
    frame.state = startState(*scene);
    frame.scene = std::move(scene);
    return std::make_shared<const Frame>(std::move(frame));
}

} // namespace clothlab
