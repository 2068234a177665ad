#pragma once

#include "simcore/cloth/cloth_state.h"

#include <cstdint>
#include <memory>

namespace clothlab {

// One frame of a run. A run goes on from an exact one with the same bits.
struct Frame {
    ClothState state;
    std::shared_ptr<const Scene> scene;      // with which it was computed; of frame 0, that of the start
    double time = 0;                         // simulated seconds since the start
    std::int64_t strainLimitCorrections = 0; // in this frame
    double milliseconds = 0;                 // it took to compute
    // If not, positions are as near as the recording keeps them, and last positions are the same.
    bool exact = true;
};

using FramePointer = std::shared_ptr<const Frame>;

std::size_t bytesOf(const Frame& frame);

// Frame 0 of a run of the scene.
FramePointer startFrame(std::shared_ptr<const Scene> scene);

} // namespace clothlab
