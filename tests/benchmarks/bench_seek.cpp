// What a recording costs: seeking in a file, and packing and measuring beside simulating.
#include "simcore/inspect/frame_measure.h"
#include "simcore/recording/take_file.h"
#include "simcore/solver/frame_runner.h"
#include "tests/support/random.h"
#include "tests/support/recorded_run.h"
#include "tests/support/shipped_scene.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>

#include <ctime>
#include <unistd.h>

namespace clothlab {
namespace {

// Of this thread, so that what else the machine does counts for little; what is read is in the system's
// cache.
double milliseconds() {
    timespec now{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
    return double(now.tv_sec) * 1e3 + double(now.tv_nsec) * 1e-6;
}

// Of selfCollision.json with so many points a side, as thick and as stiff as makes sense there.
Scene sceneOf(int side) {
    Scene scene = test::shippedScene("selfCollision");
    scene.cloth.numWidthPoints = scene.cloth.numHeightPoints = side;
    scene.cloth.thickness *= 50.0 / side;
    scene.cloth.ks *= 50.0 / side;
    return scene;
}

struct Recorded {
    std::vector<FramePointer> frames;
    double millisecondsAFrame = 0; // to simulate, on one thread
};

// Of some frames in the middle of the run.
double timeOfSimulating(const std::vector<FramePointer>& frames) {
    SolverSettings settings;
    settings.threads = 1;
    const std::atomic<bool> never{false};
    const Frame& middle = *frames[frames.size() / 2];
    VerletSolver solver(*middle.scene, settings);
    ClothState state = middle.state;
    constexpr int count = 5;
    const double begin = milliseconds();
    for (int i = 0; i < count; ++i)
        runFrame(solver, state, never);
    return (milliseconds() - begin) / count;
}

const Recorded& recorded(int side) {
    static std::map<int, Recorded> all;
    Recorded& made = all[side];
    if (made.frames.empty()) {
        made.frames = test::runFrames(sceneOf(side), side > 200 ? 31 : 127); // large sheets take long
        made.millisecondsAFrame = timeOfSimulating(made.frames);
    }
    return made;
}

void seek(benchmark::State& state) {
    const int side = int(state.range(0));
    const auto& frames = recorded(side).frames;
    const std::string path =
        (std::filesystem::temp_directory_path() / ("clothlab_seek_" + std::to_string(::getpid()))).string();
    TakeFileContents contents;
    test::addTake(contents, {1, 0, 0, "Take 1", false}, frames, kDefaultError);
    if (const auto trouble = writeTakeFile(path, contents)) {
        state.SkipWithError(trouble->c_str());
        return;
    }
    const TakeFileReading reading = readTakeFile(path);
    SplitMix64 random(1);
    std::vector<double> taken;
    for (auto _ : state) {
        const int frame = random.integer(0, int(frames.size()) - 1);
        const double begin = milliseconds();
        benchmark::DoNotOptimize(positionsOf(*findGroup(*reading.contents, 1, frame), frame));
        taken.push_back(milliseconds() - begin);
    }
    std::sort(taken.begin(), taken.end());
    const auto share = [&](double of) { return taken[std::size_t(of * double(taken.size() - 1))]; };
    state.counters["p50_ms"] = share(0.5);
    state.counters["p95_ms"] = share(0.95);
    state.counters["bytes_a_point"] = double(reading.bytes) / (double(frames.size()) * side * side);
    std::filesystem::remove(path);
}

void packing(benchmark::State& state) {
    const int side = int(state.range(0));
    const Recorded& run = recorded(side);
    FramePacker packer({side, side}, kDefaultError);
    std::size_t next = 0;
    double total = 0;
    for (auto _ : state) {
        std::vector<const PointArray*> group;
        for (int i = 0; i < kFramesPerGroup; ++i, next = (next + 1) % run.frames.size())
            group.push_back(&run.frames[next]->state.position);
        const double begin = milliseconds();
        benchmark::DoNotOptimize(packer.pack(group));
        total += milliseconds() - begin;
    }
    const double each = total / (double(state.iterations()) * kFramesPerGroup);
    state.counters["ms_a_frame"] = each;
    state.counters["share_of_simulating"] = each / run.millisecondsAFrame;
}

void facts(benchmark::State& state) {
    const int side = int(state.range(0));
    const Recorded& run = recorded(side);
    FrameMeasure measure({{side, side}, run.frames[0]->state.position});
    std::size_t next = 0;
    double total = 0;
    for (auto _ : state) {
        const double begin = milliseconds();
        benchmark::DoNotOptimize(measure.factsOf(*run.frames[next]));
        total += milliseconds() - begin;
        next = (next + 1) % run.frames.size();
    }
    const double each = total / double(state.iterations());
    state.counters["ms_a_frame"] = each;
    state.counters["share_of_simulating"] = each / run.millisecondsAFrame;
}

void checkpoint(benchmark::State& state) {
    const int side = int(state.range(0));
    const Frame& frame = *recorded(side).frames.back();
    std::size_t bytes = 0;
    for (auto _ : state)
        bytes = std::size_t(packCheckpoint(1, 1, {side, side}, frame.state).payload->length());
    state.counters["share_of_raw"] = double(bytes) / (48.0 * side * side);
}

BENCHMARK(seek)->Arg(50)->Arg(100)->Arg(512)->Unit(benchmark::kMillisecond)->MinTime(2);
BENCHMARK(packing)->Arg(50)->Arg(100)->Arg(512)->Unit(benchmark::kMillisecond);
BENCHMARK(facts)->Arg(50)->Arg(100)->Arg(512)->Unit(benchmark::kMillisecond);
BENCHMARK(checkpoint)->Arg(50)->Arg(512)->Unit(benchmark::kMillisecond);

} // namespace
} // namespace clothlab

BENCHMARK_MAIN();
