#include "app/simulation/frame_worker.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace clothlab {

namespace {

constexpr std::size_t kMostBytes = std::size_t(64) << 20U; // of the frames of an outcome, if more than one

// One core is left to the window.
SolverSettings settings() {
    SolverSettings settings;
    settings.threads = std::max(1, int(std::thread::hardware_concurrency()) - 1);
    return settings;
}

} // namespace

FrameWorker::FrameWorker(std::function<void(FrameOutcome)> deliver)
    : m_deliver(std::move(deliver)), m_thread([this] { run(); }) {}

FrameWorker::~FrameWorker() {
    {
        const std::scoped_lock lock(m_mutex);
        m_quit = true;
        m_stop = true;
    }
    m_wake.notify_one();
    m_thread.join();
}

void FrameWorker::request(FrameRequest request) {
    {
        const std::scoped_lock lock(m_mutex);
        m_request = std::move(request);
    }
    m_wake.notify_one();
}

void FrameWorker::cancel() {
    const std::scoped_lock lock(m_mutex);
    m_request.reset();
    m_stop = true;
}

void FrameWorker::run() {
    while (true) {
        FrameRequest request;
        {
            std::unique_lock lock(m_mutex);
            m_wake.wait(lock, [this] { return m_quit || m_request; });
            if (m_quit)
                return;
            request = std::move(*m_request);
            m_request.reset();
            m_stop = false; // under the lock, so that no cancel() is lost
        }
        FrameOutcome outcome;
        if (compute(request, outcome))
            m_deliver(std::move(outcome));
    }
}

// False if it was cancelled.
bool FrameWorker::compute(const FrameRequest& request, FrameOutcome& outcome) {
    outcome.ticket = request.ticket;
    outcome.number = request.number;
    outcome.computedOn = std::this_thread::get_id();
    FramePointer last = request.before();
    if (!last)
        return true;
    const std::size_t kept = std::max<std::size_t>(1, kMostBytes / bytesOf(*last));
    int number = request.number;
    for (const FrameToCompute& frame : request.frames) {
        const FrameResult result = computeFrame(frame, last);
        if (result.blowUp) {
            outcome.blowUp = result.blowUp;
            outcome.blowUpFrame = number;
            outcome.blowUpStep = result.blowUpStep;
            outcome.blowUpScene = frame.scene;
            return true;
        }
        if (!result.finished)
            return false;
        if (frame.stateHash && stateHash(last->state) != *frame.stateHash)
            outcome.differs = true;
        outcome.frames.push_back(last);
        if (outcome.frames.size() > kept) {
            outcome.frames.erase(outcome.frames.begin());
            ++outcome.number;
        }
        ++number;
    }
    return true;
}

// Puts the frame after `last` in its place, if it is finished.
FrameResult FrameWorker::computeFrame(const FrameToCompute& frame, FramePointer& last) {
    if (!m_solver || compareScenes(m_solver->scene(), *frame.scene) == SceneChange::Start)
        m_solver.emplace(*frame.scene, settings());
    else
        m_solver->setScene(*frame.scene);

    const auto begin = std::chrono::steady_clock::now();
    ClothState state = last->state;
    const FrameResult result = runFrame(*m_solver, state, m_stop);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;
    if (!result.finished)
        return result;
    Frame next;
    next.state = std::move(state);
    next.scene = frame.scene;
    next.time = last->time + 1.0 / frame.scene->simulation.framesPerSecond;
    next.strainLimitCorrections = result.strainLimitCorrections;
    next.milliseconds = frame.milliseconds.value_or(took.count());
    last = std::make_shared<const Frame>(std::move(next));
    return result;
}

} // namespace clothlab
