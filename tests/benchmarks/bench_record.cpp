// What recording costs a simulation: frames simulated by one thread, with and without a recorder that packs
// them and writes its journal on another. Items are frames.
#include "app/simulation/recorder.h"
#include "simcore/solver/frame_runner.h"
#include "tests/support/shipped_scene.h"

#include <benchmark/benchmark.h>

#include <filesystem>
#include <unistd.h>

using namespace clothlab;

namespace {

void simulate(benchmark::State& state, bool recording) {
    auto changed = test::shippedScene("sphere");
    changed.cloth.numWidthPoints = changed.cloth.numHeightPoints = int(state.range(0));
    const auto scene = std::make_shared<const Scene>(changed);
    SolverSettings settings;
    settings.threads = 1;
    VerletSolver solver(*scene, settings);
    const auto path = std::filesystem::temp_directory_path() / ("bench_record-" + std::to_string(getpid()));
    std::optional<Recorder> recorder;
    if (recording) {
        recorder.emplace([](const Packed&) {}, std::size_t(1) << 28U);
        recorder->begin(1, path.string(), kDefaultError);
    }
    FramePointer last = startFrame(scene);
    const auto sheet = std::make_shared<const Sheet>(Sheet{gridOf(scene->cloth), last->state.position});
    const std::atomic<bool> stop{false};
    int number = 0;
    for ([[maybe_unused]] auto frame : state) {
        Frame next = *last;
        runFrame(solver, next.state, stop);
        last = std::make_shared<const Frame>(std::move(next));
        if (recorder)
            recorder->add(1, sheet, number++, last);
    }
    state.SetItemsProcessed(state.iterations());
    recorder.reset();
    std::filesystem::remove(path);
}

// Of 180 frames, so that the sheet has fallen onto the sphere.
BENCHMARK_CAPTURE(simulate, alone, false)->Arg(50)->Arg(100)->Iterations(180)->UseRealTime();
BENCHMARK_CAPTURE(simulate, recorded, true)->Arg(50)->Arg(100)->Iterations(180)->UseRealTime();

} // namespace

BENCHMARK_MAIN();
