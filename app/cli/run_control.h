// What the commands that run for a while share: how far they are, and Ctrl+C.
#pragma once

#include <atomic>

namespace clothlab::cli {

// From now on Ctrl+C and SIGTERM do not end the program but set this; the command then ends in order.
const std::atomic<bool>& stopOnInterrupt();

// A bar on standard error, if that is a terminal.
void showProgress(int frame, int frames);

} // namespace clothlab::cli
