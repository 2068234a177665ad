// A thread that ends a piece of work which is due, and the program if the work does not end.
#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <cstdio>
#include <cstdlib>
#include <mutex>
#include <string>
#include <thread>

namespace clothlab::soak {

class Watchdog {
public:
    using Clock = std::chrono::steady_clock;

    explicit Watchdog(std::chrono::seconds patience) : m_patience(patience) {}
    ~Watchdog() {
        {
            const std::scoped_lock lock(m_mutex);
            m_ending = true;
        }
        m_changed.notify_all();
        m_thread.join();
    }
    Watchdog(const Watchdog&) = delete;
    Watchdog& operator=(const Watchdog&) = delete;

    // From now on `due` is false until that time. `text` is what the program says before it is aborted,
    // because done() was not called within the patience after that time.
    void begin(Clock::time_point time, std::string text) {
        const std::scoped_lock lock(m_mutex);
        m_due = time;
        m_text = std::move(text);
        m_working = true;
        due = false;
        m_changed.notify_all();
    }
    void done() {
        const std::scoped_lock lock(m_mutex);
        m_working = false;
    }

    std::atomic<bool> due{false};

private:
    void watch() {
        std::unique_lock lock(m_mutex);
        while (!m_ending) {
            if (!m_working || due)
                m_changed.wait_for(lock, std::chrono::seconds(1));
            else
                m_changed.wait_until(lock, m_due);
            if (m_working && Clock::now() >= m_due)
                due = true;
            if (m_working && Clock::now() >= m_due + m_patience) {
                std::fprintf(stderr, "HANGS: %s\n", m_text.c_str());
                std::abort();
            }
        }
    }

    const std::chrono::seconds m_patience;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    Clock::time_point m_due;
    std::string m_text;
    bool m_working = false;
    bool m_ending = false;
    std::thread m_thread{[this] { watch(); }}; // last: it uses all of the above
};

} // namespace clothlab::soak
