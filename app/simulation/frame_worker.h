// Computes frames on a thread of its own. Knows no Qt, so that thread checkers see all of its locks.
#pragma once

#include "simcore/recording/recording.h"
#include "simcore/solver/frame_runner.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

namespace clothlab {

struct FrameRequest {
    std::uint64_t ticket = 0;           // comes back with the outcome
    std::shared_ptr<const Scene> scene; // with which to go on
    FramePointer from;                  // the frame before
    int number = 0;                     // of the frame to compute
};

struct FrameOutcome {
    std::uint64_t ticket = 0;
    FramePointer frame; // null if it blew up
    std::optional<BlowUp> blowUp;
    int blowUpStep = 0;
    int number = 0;
    std::thread::id computedOn;
    std::shared_ptr<const Scene> scene; // of the request
};

class FrameWorker {
public:
    // deliver is called on the worker's thread, once for each request that was not cancelled.
    explicit FrameWorker(std::function<void(FrameOutcome)> deliver);
    ~FrameWorker(); // stops within a step and joins
    FrameWorker(const FrameWorker&) = delete;
    FrameWorker& operator=(const FrameWorker&) = delete;

    // Takes the place of a request not begun yet.
    void request(FrameRequest request);
    // Forgets the request, and abandons the frame at hand between two steps. Does not wait for that; an
    // outcome may still be delivered, with a ticket that the caller then knows to be stale.
    void cancel();

private:
    void run();
    FrameOutcome compute(const FrameRequest& request);

    std::function<void(FrameOutcome)> m_deliver;
    std::mutex m_mutex; // guards the next two
    std::optional<FrameRequest> m_request;
    bool m_quit = false;
    std::condition_variable m_wake;
    std::atomic<bool> m_stop{false};
    std::optional<VerletSolver> m_solver; // the worker's thread only
    std::thread m_thread;                 // last: starts when all else is there
};

} // namespace clothlab
