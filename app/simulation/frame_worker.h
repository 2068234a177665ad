// Computes frames on a thread of its own. Knows no Qt, so that thread checkers see all of its locks.
#pragma once

#include "simcore/recording/frame.h"
#include "simcore/solver/frame_runner.h"

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace clothlab {

struct FrameToCompute {
    std::shared_ptr<const Scene> scene;
    // If it is done again: what it took the first time, and the hash of its state then.
    std::optional<double> milliseconds;
    std::optional<std::uint64_t> stateHash;
};

struct FrameRequest {
    std::uint64_t ticket = 0; // comes back with the outcome
    // Gives the exact frame before, or null if it cannot be had. Called on the worker's thread.
    std::function<FramePointer()> before;
    std::vector<FrameToCompute> frames; // one after the other; at least one
    int number = 0;                     // of the first of them
};

struct FrameOutcome {
    std::uint64_t ticket = 0;
    // The last frames that were asked for, all but few if they are large; fewer if it blew up, none if the
    // frame before was not to be had.
    std::vector<FramePointer> frames;
    int number = 0;       // of the first of these
    bool differs = false; // the state of one that was done again is not what it was
    std::optional<BlowUp> blowUp;
    int blowUpFrame = 0;
    int blowUpStep = 0;
    std::shared_ptr<const Scene> blowUpScene;
    std::thread::id computedOn;
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
    bool compute(const FrameRequest& request, FrameOutcome& outcome);
    FrameResult computeFrame(const FrameToCompute& frame, FramePointer& last);

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
