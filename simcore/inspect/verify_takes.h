// Whether a recording is what its scenes give.
#pragma once

#include "simcore/recording/take_file.h"
#include "simcore/solver/frame_runner.h"

namespace clothlab {

// The first frame of a take that is not what it says, or cannot be read.
struct TakeDifference {
    TakeId take = 0;
    int frame = 0;
    std::string what; // "the state's hash is …, that of the run …"
};

struct Verification {
    std::vector<TakeDifference> differences; // one a take at most
    std::int64_t frames = 0;                 // that were compared
    bool stopped = false;                    // by the flag
};

// Runs every take again from the start of its scene, branches from the frame they branched off, each frame
// with its recorded scene, and compares: hash of the state and number of corrections, positions to within the
// stated error, checkpoints to the last bit.
Verification verifyTakes(const TakeFileContents& contents, const SolverSettings& settings,
                         const std::atomic<bool>& stop);

} // namespace clothlab
