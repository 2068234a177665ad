// Runs scenes for a long time and changes their parameters every second, to see that nothing goes wrong.
//
//   soak [SECONDS] [SEED]
//
// Ends with 1 if a sheet was left with a place that is not finite, or changed by a step that was said to have
// failed; aborts, for a look at all threads, if a step takes more than a minute. How far a scene gets between
// two changes depends on the machine, so a seed repeats the changes, not the run.
#include "simcore/scene/scene_io.h"
#include "simcore/solver/verlet_solver.h"
#include "tests/soak/soak_changes.h"
#include "tests/soak/watchdog.h"

#include <algorithm>
#include <cinttypes>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>

using namespace clothlab;
using namespace clothlab::soak;
using Clock = Watchdog::Clock;

namespace {

constexpr std::chrono::seconds kBetweenChanges{1};
constexpr std::chrono::seconds kLongestStep{60};
constexpr int kChangesOfAScene = 20; // then it is the next one's turn

struct Summary {
    std::int64_t frames = 0; // whole ones
    std::int64_t steps = 0;
    int changes = 0;
    std::array<int, 5> blowUps{}; // by phase
    double slowestStep = 0;       // s; the mean of its frame
    std::string slowestSetup;
    int failures = 0;
};

double secondsSince(Clock::time_point begin) {
    return std::chrono::duration<double>(Clock::now() - begin).count();
}

bool isFinite(const PointArray& points) {
    const auto finite = [](double value) { return std::isfinite(value); };
    return std::ranges::all_of(points.x, finite) && std::ranges::all_of(points.y, finite) &&
           std::ranges::all_of(points.z, finite);
}

class Soak {
public:
    Soak(std::uint64_t seed, double seconds) : m_seed(seed), m_random(seed), m_seconds(seconds) {}

    bool run() { // false: the scenes do not load
        for (int turn = 0; secondsSince(m_begin) < m_seconds; ++turn)
            if (!runScene(turn))
                return false;
        return true;
    }
    const Summary& summary() const { return m_summary; }

private:
    bool runScene(int turn) {
        static constexpr std::array kNames{"selfCollision", "plane", "sphere"};
        m_setup.name = kNames[std::size_t(turn) % kNames.size()];
        const SceneReading reading =
            loadScene(std::string(CLOTHLAB_SOURCE_DIR "/scenes/") + m_setup.name + ".json");
        if (!reading.scene)
            return false;
        m_setup.scene = *reading.scene;
        makeSolver();
        m_state = m_solver->start();
        for (int n = 0; n < kChangesOfAScene && secondsSince(m_begin) < m_seconds; ++n) {
            change();
            const auto due = std::min(Clock::now() + kBetweenChanges,
                                      m_begin + std::chrono::duration_cast<Clock::duration>(
                                                    std::chrono::duration<double>(m_seconds)));
            while (Clock::now() < due)
                runFrame(due);
        }
        return true;
    }

    void makeSolver() {
        m_solver = std::make_unique<VerletSolver>(m_setup.scene, SolverSettings{m_setup.threads, 1});
    }

    // As the program does it: a new start where the sheet's shape has changed, otherwise the sheet goes on.
    void change() {
        const int threads = m_setup.threads;
        changeAtRandom(m_random, m_setup);
        const bool starts = compareScenes(m_solver->scene(), m_setup.scene) == SceneChange::Start;
        if (starts || threads != m_setup.threads)
            makeSolver();
        else
            m_solver->setScene(m_setup.scene);
        if (starts)
            m_state = m_solver->start();
        ++m_summary.changes;
        std::printf("%7.1f s  %s%s\n", secondsSince(m_begin), describe(m_setup).c_str(),
                    starts ? ", from the start" : "");
        std::fflush(stdout);
    }

    // Ends between two steps when due.
    void runFrame(Clock::time_point due) {
        const int steps = m_setup.scene.simulation.stepsPerFrame;
        m_before = m_state;
        m_watchdog.begin(due, report());
        const auto begin = Clock::now();
        const RunResult result = m_solver->run(m_state, steps, m_watchdog.due);
        const double seconds = secondsSince(begin);
        m_watchdog.done();
        m_summary.frames += result.steps == steps ? 1 : 0;
        m_summary.steps += result.steps;
        const double perStep = seconds / std::max(1, result.steps);
        if (perStep > m_summary.slowestStep && !result.blowUp) {
            m_summary.slowestStep = perStep;
            m_summary.slowestSetup = describe(m_setup);
        }
        check(result);
    }

    void check(const RunResult& result) {
        if (result.blowUp) {
            ++m_summary.blowUps.at(std::size_t(result.blowUp->phase));
            if (m_state != m_before)
                fail("The state has changed in a run that blew up");
            m_state = m_solver->start();
        } else if (!isFinite(m_state.position) || !isFinite(m_state.lastPosition)) {
            fail("Not finite, and no blow-up was reported");
            m_state = m_solver->start();
        }
    }

    void fail(const char* what) {
        ++m_summary.failures;
        std::fprintf(stderr, "FAILED: %s: %s\n", what, report().c_str());
    }

    std::string report() const {
        return "seed " + std::to_string(m_seed) + ", change " + std::to_string(m_summary.changes) + ", " +
               describe(m_setup) + "\n" + writeScene(m_setup.scene);
    }

    const std::uint64_t m_seed;
    SplitMix64 m_random;
    const double m_seconds;
    const Clock::time_point m_begin = Clock::now();
    Setup m_setup;
    std::unique_ptr<VerletSolver> m_solver;
    ClothState m_state, m_before;
    Summary m_summary;
    Watchdog m_watchdog{kLongestStep};
};

void print(const Summary& summary) {
    std::printf("\n%" PRId64 " frames, %" PRId64 " steps, %d changes, %d failures\n", summary.frames,
                summary.steps, summary.changes, summary.failures);
    for (std::size_t n = 0; n < summary.blowUps.size(); ++n)
        std::printf("%8d blow-ups in %s\n", summary.blowUps[n], name(Phase(n)).data());
    std::printf("Slowest step: %.1f ms (mean of a frame) in %s\n", 1000 * summary.slowestStep,
                summary.slowestSetup.c_str());
}

} // namespace

int main(int argc, char** argv) {
    const double seconds = argc > 1 ? std::atof(argv[1]) : 600;
    const std::uint64_t seed = argc > 2 ? std::strtoull(argv[2], nullptr, 10) : std::random_device{}();
    if (!(seconds > 0)) {
        std::fprintf(stderr, "soak [SECONDS] [SEED]\n");
        return 2;
    }
    std::printf("Seed %" PRIu64 ", %.0f s\n", seed, seconds);
    Soak soak(seed, seconds);
    if (!soak.run()) {
        std::fprintf(stderr, "The scenes do not load.\n");
        return 2;
    }
    print(soak.summary());
    return soak.summary().failures == 0 ? 0 : 1;
}
