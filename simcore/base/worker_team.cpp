#include "simcore/base/worker_team.h"

#if defined(__x86_64__)
#include <immintrin.h>
#endif

namespace clothlab {

void relaxProcessor() {
#if defined(__x86_64__)
    _mm_pause();
#else
    std::this_thread::yield();
#endif
}

void Barrier::wait() {
    if (m_members == 1)
        return;
    const unsigned round = m_round.load(std::memory_order_relaxed);
    if (m_missing.fetch_sub(1, std::memory_order_acq_rel) == 1) {
        m_missing.store(m_members, std::memory_order_relaxed);
        m_round.store(round + 1, std::memory_order_release);
        return;
    }
    waitUntil(m_round, [&](unsigned now) { return now != round; });
}

WorkerTeam::WorkerTeam(int members) {
    m_threads.reserve(std::size_t(members) - 1);
    for (int member = 1; member < members; ++member)
        m_threads.emplace_back([this, member] { work(member); });
}

WorkerTeam::~WorkerTeam() {
    m_job = nullptr;
    m_run.fetch_add(1, std::memory_order_release);
    m_run.notify_all();
    for (std::thread& thread : m_threads)
        thread.join();
}

void WorkerTeam::run(const std::function<void(int)>& job) {
    if (!m_threads.empty()) {
        m_job = &job;
        m_busy.store(int(m_threads.size()), std::memory_order_relaxed);
        m_run.fetch_add(1, std::memory_order_release);
        m_run.notify_all();
    }
    job(0);
    for (int busy = m_busy.load(std::memory_order_acquire); busy != 0;
         busy = m_busy.load(std::memory_order_acquire))
        m_busy.wait(busy, std::memory_order_acquire);
}

void WorkerTeam::work(int member) {
    for (unsigned seen = 0;;) {
        m_run.wait(seen, std::memory_order_acquire);
        ++seen; // runs are never missed: the next one begins only when all have ended this one
        if (m_job == nullptr)
            return;
        (*m_job)(member);
        if (m_busy.fetch_sub(1, std::memory_order_acq_rel) == 1)
            m_busy.notify_one();
    }
}

} // namespace clothlab
