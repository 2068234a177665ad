// What `clothlab info` says of a recording.
#pragma once

#include "simcore/recording/take_file.h"

#include <string>

namespace clothlab::cli {

// Lines, ended by a line feed each. Precondition: there are contents.
std::string takeInfoText(const TakeFileReading& reading);

} // namespace clothlab::cli
