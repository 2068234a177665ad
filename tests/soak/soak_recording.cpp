// An hour of a recording, as fast as it can be packed: does it stay within its memory, and how long does it
// take to see any of its frames? soak_recording [FRAMES [BUDGET_MIB]]
#include "app/simulation/recorder.h"
#include "simcore/recording/recording.h"
#include "simcore/solver/frame_runner.h"
#include "tests/support/shipped_scene.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <random>
#include <sys/resource.h>
#include <unistd.h>

using namespace clothlab;

namespace {

using Clock = std::chrono::steady_clock;

double milliseconds(Clock::duration duration) {
    return std::chrono::duration<double, std::milli>(duration).count();
}

// Frames of a sheet that falls and crumples; recorded again and again, as simulating an hour takes one.
std::vector<FramePointer> crumple(const std::shared_ptr<const Scene>& scene, int frames) {
    VerletSolver solver(*scene);
    std::vector<FramePointer> made{startFrame(scene)};
    const std::atomic<bool> stop{false};
    while (int(made.size()) < frames) {
        Frame frame = *made.back();
        runFrame(solver, frame.state, stop);
        frame.time = double(made.size()) / scene->simulation.framesPerSecond;
        frame.milliseconds = 3;
        made.push_back(std::make_shared<const Frame>(std::move(frame)));
    }
    return made;
}

// The window's side of a recording, without a window.
class Session {
public:
    Session(const std::shared_ptr<const Scene>& scene, const std::string& journal, std::size_t budget)
        : m_recording(scene), m_budget(budget), m_recorder(
                                                    [this](Packed packed) {
                                                        const std::scoped_lock lock(m_mutex);
                                                        m_packed.push_back(std::move(packed));
                                                    },
                                                    budget / 4) {
        m_recorder.begin(0, journal, kDefaultError);
        m_recorder.setTake({1, 0, 0, "Take 1", false});
        m_recorder.add(1, m_recording.take()->sharedSheet(), 0, m_recording.frame(0).exact);
    }

    void record(FramePointer frame) {
        m_recording.append(frame);
        m_recorder.add(1, m_recording.take()->sharedSheet(), m_recording.lastFrame(), std::move(frame));
        receive();
        while (m_recorder.bytesWaiting() > m_budget / 8) {
            usleep(1000);
            receive();
        }
        m_most = std::max(m_most, m_recording.bytesKept() + m_recorder.bytesInMemory());
    }

    double secondsToFinish() {
        const auto begin = Clock::now();
        std::atomic<bool> done{false};
        m_recorder.flush([&] { done = true; });
        while (!done)
            usleep(1000);
        receive();
        return milliseconds(Clock::now() - begin) / 1000;
    }

    // The positions of a frame, as scrubbing shows them.
    bool look(int number) {
        const RecordedFrame& frame = m_recording.frame(number);
        return frame.exact || (frame.group && m_reader.positionsOf(*frame.group, number));
    }

    const Recording& recording() const { return m_recording; }
    std::size_t mostBytes() const { return m_most; }

private:
    void receive() {
        std::vector<Packed> packed;
        {
            const std::scoped_lock lock(m_mutex);
            packed.swap(m_packed);
        }
        Take& take = *m_recording.take();
        for (const Packed& one : packed) {
            m_recorder.taken(one);
            if (!one.problem.empty())
                std::fprintf(stderr, "%s\n", one.problem.c_str());
            if (one.group)
                for (int frame = one.group->first; frame < one.group->end(); ++frame)
                    take.frame(frame).group = one.group;
            if (one.checkpoint)
                take.frame(one.checkpoint->frame).checkpoint = one.checkpoint;
        }
        m_recording.trim(m_budget / 2);
    }

    Recording m_recording;
    GroupReader m_reader;
    std::size_t m_budget;
    std::size_t m_most = 0;
    std::mutex m_mutex;
    std::vector<Packed> m_packed;
    Recorder m_recorder;
};

} // namespace

int main(int argc, char** argv) {
    const int frames = argc > 1 ? std::atoi(argv[1]) : 3600 * 90;
    const std::size_t budget = std::size_t(argc > 2 ? std::atoi(argv[2]) : 1024) << 20U;
    const auto scene = std::make_shared<const Scene>(test::shippedScene("selfCollision"));
    const std::vector<FramePointer> loop = crumple(scene, 300);

    const auto folder =
        std::filesystem::temp_directory_path() / ("soak_recording-" + std::to_string(getpid()));
    std::filesystem::create_directories(folder);
    const std::string journal = folder / "journal.clothtake";
    int status = 0;
    {
        Session session(scene, journal, budget);
        const auto begin = Clock::now();
        for (int i = 1; i < frames; ++i) {
            // A copy of its own, as a run makes one.
            session.record(std::make_shared<const Frame>(*loop[std::size_t(i) % loop.size()]));
            if (i % 32400 == 0)
                std::fprintf(stderr, "%d frames\n", i);
        }
        session.secondsToFinish();
        const double seconds = milliseconds(Clock::now() - begin) / 1000;

        std::mt19937 random(1);
        std::vector<double> seeks;
        for (int i = 0; i < 2000; ++i) {
            const int frame = int(random() % unsigned(frames));
            const auto from = Clock::now();
            if (!session.look(frame))
                status = 1;
            seeks.push_back(milliseconds(Clock::now() - from));
        }
        std::ranges::sort(seeks);
        rusage usage{};
        getrusage(RUSAGE_SELF, &usage);
        std::printf(
            "frames %d, %.3f ms each; exact and packed in memory at most %.1f MiB of %.0f; resident at most "
            "%.1f MiB; journal %.1f MiB; seek p50 %.3f ms, p95 %.3f ms\n",
            frames, 1000 * seconds / frames, double(session.mostBytes()) / (1 << 20),
            double(budget) / (1 << 20), double(usage.ru_maxrss) / 1024,
            double(std::filesystem::file_size(journal)) / (1 << 20), seeks[seeks.size() / 2],
            seeks[seeks.size() * 95 / 100]);
        // Resident are also the program and the frames that it records again and again.
        const std::size_t besides = std::size_t(64) << 20U;
        if (session.mostBytes() > budget || std::size_t(usage.ru_maxrss) * 1024 > budget + besides)
            status = 1;
    }
    std::filesystem::remove_all(folder);
    return status;
}
