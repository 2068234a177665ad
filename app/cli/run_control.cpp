#include "app/cli/run_control.h"

#include <csignal>
#include <cstdint>
#include <cstdio>
#include <unistd.h>

namespace clothlab::cli {
namespace {

std::atomic<bool> stopRequested{false};
static_assert(std::atomic<bool>::is_always_lock_free, "written by a signal handler");

} // namespace

const std::atomic<bool>& stopOnInterrupt() {
    stopRequested = false;
    std::signal(SIGINT, [](int) { stopRequested = true; });
    std::signal(SIGTERM, [](int) { stopRequested = true; });
    return stopRequested;
}

void showProgress(int frame, int frames) {
    static const bool onTerminal = isatty(STDERR_FILENO) != 0;
    if (!onTerminal)
        return;
    constexpr int width = 40;
    const int done = frames > 0 ? int(std::int64_t(frame) * width / frames) : width;
    std::fprintf(stderr, "\r[%.*s%.*s] frame %d / %d%s", done, "########################################",
                 width - done, "                                        ", frame, frames,
                 frame == frames ? "\n" : "");
}

} // namespace clothlab::cli
