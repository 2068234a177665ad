// What `clothlab simulate --report` says of a run.
#pragma once

#include "simcore/recording/frame.h"
#include "simcore/solver/frame_runner.h"

#include <optional>
#include <string>

namespace clothlab::cli {

struct RunBlowUp {
    BlowUp blowUp;
    int frame = 0;
    int step = 0; // of the frame
};

struct RunSummary {
    int frames = 0; // simulated, all of them good
    double seconds = 0;
    int threads = 1; // that computed
    std::int64_t strainLimitCorrections = 0;
    std::optional<RunBlowUp> blowUp;
    bool interrupted = false;
};

// JSON, ended by a line feed. The measures are those of the last good frame.
std::string reportText(const RunSummary& summary, const Sheet& sheet, const Frame& last);

} // namespace clothlab::cli
