#pragma once

#include "simcore/recording/take_file.h"

#include <string>

namespace clothlab::test {

// What must hold for any file whatever that is read as a recording: contents or an error; contents as
// TakeFileContents promises; words for each problem; frames and states of the right size or none. Returns
// what does not hold.
std::string brokenTakeFileInvariant(const TakeFileReading& reading);

// The same bytes with right checksums wherever there is a chunk, so that what lies behind them is reached,
// too.
std::string withRightChecksums(std::string bytes);

} // namespace clothlab::test
