#pragma once

namespace clothlab::cli {

enum ExitStatus {
    Done = 0,
    CheckFoundWarnings = 1,
    WrongUsage = 2,
    InvalidInput = 3,
    SimulationBlewUp = 4,
    RecordingDiffers = 5,
    OutputNotWritten = 6,
    Interrupted = 130,
};

} // namespace clothlab::cli
