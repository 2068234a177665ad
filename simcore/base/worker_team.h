// Threads that work on one thing together, step after step.
#pragma once

#include <atomic>
#include <functional>
#include <thread>
#include <vector>

namespace clothlab {

// All of a team wait here for each other; see waitUntil.
class Barrier {
public:
    explicit Barrier(int members) : m_members(members), m_missing(members) {}
    void wait();

private:
    const int m_members;
    alignas(64) std::atomic<int> m_missing; // apart, so that who counts does not disturb who watches
    alignas(64) std::atomic<unsigned> m_round{0};
};

// Waits until value satisfies done(value), for others that are at work and about to come: spins, then gives
// up its turn again and again. It does not sleep: of threads that wake each other up, a system may well leave
// two on one core and another core idle.
template <typename T, typename Done>
void waitUntil(const std::atomic<T>& value, Done done);

// A number of threads, the caller of run() among them, that sleep between runs.
class WorkerTeam {
public:
    explicit WorkerTeam(int members); // 1: no other thread
    ~WorkerTeam();
    WorkerTeam(const WorkerTeam&) = delete;
    WorkerTeam& operator=(const WorkerTeam&) = delete;

    int members() const { return int(m_threads.size()) + 1; }
    // Calls job(member) for each member, 0 on this thread, and returns when all are done. Does not allocate
    // if copying the job does not. The job must not throw.
    void run(const std::function<void(int)>& job);

private:
    void work(int member);

    const std::function<void(int)>* m_job = nullptr; // null: the threads are to end
    alignas(64) std::atomic<unsigned> m_run{0};      // counts runs; the others sleep on it
    alignas(64) std::atomic<int> m_busy{0};          // others that are not done yet
    std::vector<std::thread> m_threads;
};

void relaxProcessor(); // for the body of a loop that spins

template <typename T, typename Done>
void waitUntil(const std::atomic<T>& value, Done done) {
    constexpr int kSpins = 500;
    for (int n = 0; !done(value.load(std::memory_order_acquire)); ++n)
        if (n < kSpins)
            relaxProcessor();
        else
            std::this_thread::yield();
}

} // namespace clothlab
