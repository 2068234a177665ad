#include "app/simulation/frame_worker.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace clothlab {

namespace {

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
        FrameOutcome outcome = compute(request);
        if (outcome.frame || outcome.blowUp)
            m_deliver(std::move(outcome));
    }
}

FrameOutcome FrameWorker::compute(const FrameRequest& request) {
    if (!m_solver || compareScenes(m_solver->scene(), *request.scene) == SceneChange::Start)
        m_solver.emplace(*request.scene, settings());
    else
        m_solver->setScene(*request.scene);

    const auto begin = std::chrono::steady_clock::now();
    ClothState state = request.from->state;
    const FrameResult result = runFrame(*m_solver, state, m_stop);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - begin;

    FrameOutcome outcome{request.ticket,    nullptr,        result.blowUp,
                         result.blowUpStep, request.number, std::this_thread::get_id(),
                         request.scene};
    const double time = request.from->time + 1.0 / request.scene->simulation.framesPerSecond;
    if (result.finished)
        outcome.frame = std::make_shared<const Frame>(
            Frame{std::move(state), request.scene, time, result.strainLimitCorrections, took.count()});
    return outcome;
}

} // namespace clothlab
