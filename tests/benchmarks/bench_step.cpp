// Point-steps a second: of each phase, and of whole steps beside the oracle, the plain reading of the model,
// which is compiled with the same flags. What is compared is measured in turns within this run; at the end,
// ratios.
//
//   bench_step [--benchmark_filter=REGEX] …   (options of Google Benchmark)
#include "simcore/solver/verlet_solver.h"
#include "tests/support/oracle.h"
#include "tests/support/shipped_scene.h"
#include "tests/support/states.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <map>
#include <thread>

using namespace clothlab;

namespace {

constexpr int kStepsPerRun = 30;
const std::atomic<bool> kGoOn = false;

// A scene of the course with other numbers of points. Thickness goes with the spacing, so that points have as
// many neighbours, and stiffness with its square, so that the step is as stable.
Scene courseScene(const std::string& name, int size, bool selfCollision) {
    Scene scene = test::shippedScene(name);
    const double finer = size / 50.0;
    for (GridPoint& pin : scene.cloth.pinned)
        pin = {pin.x * (size - 1) / 49, pin.y * (size - 1) / 49};
    scene.cloth.numWidthPoints = scene.cloth.numHeightPoints = size;
    scene.cloth.thickness = selfCollision ? scene.cloth.thickness / finer : 0;
    if (size > 50)
        scene.cloth.ks /= finer * finer;
    scene.simulation.stepsPerFrame = kStepsPerRun;
    return scene;
}

SolverSettings settingsOf(int threads, InstructionSet set = bestInstructionSet()) {
    SolverSettings settings;
    settings.threads = threads;
    settings.instructionSet = set;
    return settings;
}

// A state some frames into a run; the same one is asked for again and again.
const ClothState& stateAt(const std::string& key, const Scene& scene, int frame) {
    static std::map<std::string, ClothState> known;
    const auto [at, isNew] = known.try_emplace(key + std::to_string(frame));
    if (isNew) {
        VerletSolver solver(scene);
        at->second = solver.start();
        for (int n = 0; n < frame; ++n)
            solver.run(at->second, kStepsPerRun, kGoOn);
    }
    return at->second;
}

void count(benchmark::State& state, const Scene& scene, double steps) {
    const double pointSteps = double(state.iterations()) * steps * scene.cloth.pointCount();
    state.counters["point_steps"] = benchmark::Counter(pointSteps, benchmark::Counter::kIsRate);
}

struct Case {
    std::string scene;
    int size;
    bool selfCollision;
    int frame; // from which on
    std::string key() const {
        return scene + "/" + std::to_string(size) + (selfCollision ? "/self-collision" : "/without");
    }
    std::string text() const { return key() + "/frame " + std::to_string(frame); }
};

// Each iteration is a frame, from the same state and with the lists that a run would have.
void runSolver(benchmark::State& state, const Case& which, const SolverSettings& settings) {
    const Scene scene = courseScene(which.scene, which.size, which.selfCollision);
    const ClothState& start = stateAt(which.key(), scene, which.frame);
    VerletSolver solver(scene, settings);
    ClothState warm = start;
    solver.run(warm, kStepsPerRun, kGoOn);
    for ([[maybe_unused]] const auto _ : state) {
        state.PauseTiming();
        ClothState now = start;
        state.ResumeTiming();
        if (solver.run(now, kStepsPerRun, kGoOn).blowUp)
            state.SkipWithError("blew up");
    }
    count(state, scene, kStepsPerRun);
    state.counters["bytes_per_point"] = double(solver.bytes()) / scene.cloth.pointCount();
}

void runOracle(benchmark::State& state, const Case& which) {
    const Scene scene = courseScene(which.scene, which.size, which.selfCollision);
    oracle::Cloth cloth(scene);
    copyState(stateAt(which.key(), scene, which.frame), cloth.points);
    const std::vector<oracle::PointMass> start = cloth.points;
    for ([[maybe_unused]] const auto _ : state) {
        state.PauseTiming();
        cloth.points = start;
        state.ResumeTiming();
        for (int step = 0; step < kStepsPerRun; ++step)
            cloth.step();
    }
    count(state, scene, kStepsPerRun);
}

// One kernel alone, on a sheet at rest in padded rows.
void runPhase(benchmark::State& state, const std::string& phase, int size, InstructionSet set) {
    const Scene scene = courseScene("pinned2", size, true);
    const RowLayout layout(gridOf(scene.cloth));
    const Sheet sheet{gridOf(scene.cloth), startState(scene).position};
    RowArrays arrays(layout, 9);
    const RestRows rest(sheet, layout);
    StepData data;
    data.layout = layout;
    data.position = arrays.points(0);
    data.last = arrays.points(3);
    copyToRows(sheet.start, layout, data.position);
    copyToRows(sheet.start, layout, data.last);
    copyToRows(sheet.start, layout, arrays.points(6));
    const std::vector<std::uint8_t> pinned(std::size_t(layout.slotCount() + 4 * layout.stride), 1);
    data.pinned = pinned.data(); // so that every pass finds the same
    data.runawayDistance = 1;
    for (std::size_t s = 0; s < kStencils.size(); ++s) {
        data.restLength[s] = rest.of(int(s));
        data.stiffness[s] = stiffness(scene.cloth, kStencils[s].type);
        data.enabled[s] = true;
    }
    ForceRows forces(layout);
    std::vector<SlotPair> pairs(std::size_t(4 * layout.slotCount()));
    const Kernels& kernels = kernelsFor(set);
    const RowRange all{0, layout.height};
    const double distance = 2 * scene.cloth.thickness;
    for ([[maybe_unused]] const auto _ : state) {
        if (phase == "forces and Verlet")
            benchmark::DoNotOptimize(kernels.verletRows(data, all, forces, false));
        else if (phase == "strain limit")
            for (int y = 0; y < layout.height; ++y) {
                std::array<StencilRow, kStencils.size()> rows{};
                for (int s = 0; s < int(rows.size()); ++s)
                    rows[std::size_t(s)] = {s, y};
                benchmark::DoNotOptimize(kernels.limitRows(data, rows.data(), int(rows.size())));
            }
        else if (phase == "colliders")
            kernels.collideSphere(data, all, {0.5, 0.9, 0.5, 0.15, 0.3});
        else if (phase == "adjacent pairs")
            benchmark::DoNotOptimize(
                kernels.adjacentPairs(layout, all, data.position, distance, pairs.data()));
        else
            benchmark::DoNotOptimize(
                kernels.farthestSquared(layout, all, data.position, arrays.points(6), {0, 0, 0}));
    }
    count(state, scene, 1);
}

void registerPhases() {
    for (const char* phase :
         {"forces and Verlet", "strain limit", "colliders", "adjacent pairs", "motion since listing"})
        for (const int size : {50, 256, 1024})
            for (const InstructionSet set :
                 {InstructionSet::Scalar, InstructionSet::Sse2, InstructionSet::Avx2, InstructionSet::Avx512})
                if (isSupported(set))
                    benchmark::RegisterBenchmark(
                        ("phase/" + std::string(phase) + "/" + std::to_string(size) + "/" +
                         std::string(name(set)))
                            .c_str(),
                        [=](benchmark::State& state) { runPhase(state, phase, size, set); });
}

void registerCase(const Case& which, bool withOracle) {
    if (withOracle)
        benchmark::RegisterBenchmark(("step/" + which.text() + "/oracle").c_str(),
                                     [=](benchmark::State& state) { runOracle(state, which); })
            ->Unit(benchmark::kMillisecond);
    for (const int threads : {1, 2})
        benchmark::RegisterBenchmark(
            ("step/" + which.text() + "/" + std::to_string(threads) + (threads == 1 ? " thread" : " threads"))
                .c_str(),
            [=](benchmark::State& state) { runSolver(state, which, settingsOf(threads)); })
            ->Unit(benchmark::kMillisecond)
            ->UseRealTime();
}

// Falling, folding or meeting something, and at rest.
void registerSteps() {
    for (const char* scene : {"pinned2", "sphere", "selfCollision"})
        for (const int frame : {10, 60, 300})
            for (const bool selfCollision : {false, true})
                registerCase({scene, 50, selfCollision, frame}, true);
    for (const int size : {75, 100, 200, 512, 1024})
        for (const bool selfCollision : {false, true})
            registerCase({"pinned2", size, selfCollision, size > 200 ? 1 : 5}, size <= 200);
}

// A word to another core and back: what two threads can gain depends on it. Virtual machines may move their
// cores between places that are near each other and far.
void runRoundTrip(benchmark::State& state) {
    alignas(64) std::atomic<std::int64_t> sent = 0;
    alignas(64) std::atomic<std::int64_t> returned = 0;
    std::thread other([&] {
        for (std::int64_t n = 1; n > 0; ++n) {
            waitUntil(sent, [&](std::int64_t value) { return value < 0 || value == n; });
            if (sent.load(std::memory_order_relaxed) < 0)
                return;
            returned.store(n, std::memory_order_release);
        }
    });
    std::int64_t n = 0;
    for ([[maybe_unused]] const auto _ : state) {
        sent.store(++n, std::memory_order_release);
        waitUntil(returned, [&](std::int64_t value) { return value == n; });
    }
    sent.store(-1, std::memory_order_release);
    other.join();
}

// Prints as usual, and keeps the rates.
class RatioReporter : public benchmark::ConsoleReporter {
public:
    void ReportRuns(const std::vector<Run>& runs) override {
        ConsoleReporter::ReportRuns(runs);
        for (const Run& run : runs)
            if (const auto rate = run.counters.find("point_steps"); rate != run.counters.end()) {
                double& best = m_rates[cutOff(run.benchmark_name())];
                best = std::max(best, double(rate->second));
            }
    }

    void printRatios() const {
        std::printf("\n%-44s %8s %8s %8s %8s %8s\n", "million point-steps a second; ratios", "oracle",
                    "1 thread", "2", "1/oracle", "2/1");
        for (const auto& [name, rate] : m_rates) {
            const auto end = name.rfind("/1 thread");
            if (end == std::string::npos)
                continue;
            const std::string base = name.substr(0, end);
            const double plain = rateOf(base + "/oracle"), two = rateOf(base + "/2 threads");
            std::printf("%-44s %8.1f %8.1f %8.1f %8.2f %8.2f\n", base.c_str(), plain * 1e-6, rate * 1e-6,
                        two * 1e-6, plain > 0 ? rate / plain : 0, two / rate);
        }
    }

private:
    static std::string cutOff(const std::string& name) { // what Google Benchmark adds
        const auto end = name.find("/real_time");
        return name.substr(0, end);
    }
    double rateOf(const std::string& name) const {
        const auto at = m_rates.find(name);
        return at == m_rates.end() ? 0 : at->second;
    }

    std::map<std::string, double> m_rates;
};

} // namespace

int main(int argc, char** argv) {
    benchmark::Initialize(&argc, argv);
    registerPhases();
    registerSteps();
    benchmark::RegisterBenchmark("to the other core and back", runRoundTrip)->UseRealTime();
    RatioReporter reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    reporter.printRatios();
    return 0;
}
