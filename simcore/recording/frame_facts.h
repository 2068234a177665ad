// What is known of a recorded frame without its positions.
#pragma once

#include <cstdint>

namespace clothlab {

struct FrameFacts {
    double time = 0;                         // simulated seconds since the start
    double milliseconds = 0;                 // it took to compute
    std::int64_t strainLimitCorrections = 0; // in this frame
    std::uint64_t stateHash = 0;             // stateHash() of the whole state
    double kineticEnergy = 0;                // J
    double greatestStrain = 0; // of springs that are switched on: length / rest length - 1; may be negative
    std::int64_t contacts = 0; // point masses that touch something, see FrameMeasure
    friend bool operator==(const FrameFacts&, const FrameFacts&) = default;
};

} // namespace clothlab
