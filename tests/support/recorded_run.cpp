#include "tests/support/recorded_run.h"

#include "simcore/inspect/frame_measure.h"
#include "simcore/solver/frame_runner.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace clothlab::test {
namespace {

SceneId sceneIdOf(SceneMap& scenes, const std::shared_ptr<const Scene>& scene) {
    for (const auto& [id, known] : scenes)
        if (known == scene)
            return id;
    const SceneId id = scenes.empty() ? 1 : scenes.rbegin()->first + 1;
    scenes[id] = scene;
    return id;
}

void addGroups(RecordedTake& take, SceneMap& scenes, const std::vector<FramePointer>& frames, double error) {
    const Scene& scene = *frames.front()->scene;
    const Sheet sheet{gridOf(scene.cloth), startState(scene).position};
    FrameMeasure measure(sheet);
    FramePacker packer(sheet.grid, error);
    std::vector<FrameToPack> group;
    int first = take.info.firstOwnFrame();
    for (const FramePointer& frame : frames) {
        group.push_back({&frame->state.position, measure.factsOf(*frame), sceneIdOf(scenes, frame->scene)});
        if (group.size() == kFramesPerGroup || frame == frames.back()) {
            take.groups.push_back(packGroup(packer, take.info.id, first, group));
            first += int(group.size());
            group.clear();
        }
    }
}

} // namespace

std::vector<FramePointer> runOn(const Frame& from, int first, int last, const SceneEdit& edit) {
    std::vector<FramePointer> frames;
    std::shared_ptr<const Scene> scene = from.scene;
    VerletSolver solver(*scene);
    ClothState state = from.state;
    const std::atomic<bool> never{false};
    for (int number = first; number <= last; ++number) {
        Scene edited = *scene;
        if (edit)
            edit(number, edited);
        if (!(edited == *scene)) {
            scene = std::make_shared<const Scene>(std::move(edited));
            solver.setScene(*scene);
        }
        const FrameResult result = runFrame(solver, state, never);
        if (!result.finished)
            break;
        const double time = from.time + double(number - first + 1) / scene->simulation.framesPerSecond;
        frames.push_back(
            std::make_shared<const Frame>(Frame{state, scene, time, result.strainLimitCorrections, 1.5}));
    }
    return frames;
}

std::vector<FramePointer> runFrames(const Scene& scene, int frames, const SceneEdit& edit) {
    const auto start = std::make_shared<const Frame>(
        Frame{startState(scene), std::make_shared<const Scene>(scene), 0, 0, 0});
    std::vector<FramePointer> all{start};
    const std::vector<FramePointer> rest = runOn(*start, 1, frames, edit);
    all.insert(all.end(), rest.begin(), rest.end());
    return all;
}

void addTake(TakeFileContents& contents, const TakeInfo& info, const std::vector<FramePointer>& frames,
             double error, int checkpointEvery) {
    RecordedTake take{info, {}, {}};
    addGroups(take, contents.scenes, frames, error);
    const Grid grid = gridOf(frames.front()->scene->cloth);
    const int first = info.firstOwnFrame();
    for (int i = 0; i < int(frames.size()); ++i)
        if ((first + i) % checkpointEvery == 0 || i + 1 == int(frames.size()))
            take.checkpoints.push_back(
                packCheckpoint(info.id, first + i, grid, frames[std::size_t(i)]->state));
    contents.takes.push_back(std::move(take));
}

TwoTakes twoTakes(double error) {
    Scene scene;
    scene.cloth.numWidthPoints = 9;
    scene.cloth.numHeightPoints = 7;
    scene.cloth.thickness = 0.02;
    scene.cloth.pinned = {{0, 0}};
    scene.spheres.push_back({{0.5, 0.5, 0.5}, 0.3, 0.3, {}});
    TwoTakes made;
    made.first = runFrames(scene, 40, [](int frame, Scene& edited) {
        if (frame == 12)
            edited.simulation.gravity = {3, -5, 0};
    });
    made.branch = runOn(*made.first[9], 10, 30, [](int frame, Scene& edited) {
        if (frame == 10)
            edited.cloth.ks = 3000;
    });
    addTake(made.contents, {1, 0, 0, "Take 1", false}, made.first, error, 15);
    addTake(made.contents, {2, 1, 9, "softer", false}, made.branch, error, 15);
    made.contents.meta.version = "0.1.0";
    made.contents.meta.error = error;
    made.contents.meta.activeTake = 2;
    made.contents.meta.shownFrame = 17;
    made.contents.meta.markers = {{1, 3, "falls \"here\""}, {2, 29, "ends"}};
    made.contents.meta.ranges = {{2, 5, 25}};
    return made;
}

std::string bytesOf(const TakeFileContents& contents) {
    std::ostringstream out;
    TakeFileWriter writer(out);
    for (const auto& [id, scene] : contents.scenes)
        writer.add(sceneChunk(id, *scene));
    for (const RecordedTake& take : contents.takes)
        writer.add(takeChunk(take.info));
    for (const RecordedTake& take : contents.takes) {
        for (const FrameGroup& group : take.groups)
            writer.add(*chunkOf(group));
        for (const Checkpoint& checkpoint : take.checkpoints)
            writer.add(*chunkOf(checkpoint));
    }
    writer.add(metaChunk(contents.meta));
    writer.finish();
    return out.str();
}

double greatestDifference(const PointArray& a, const PointArray& b) {
    if (a.size() != b.size())
        return std::numeric_limits<double>::infinity();
    double greatest = 0;
    for (const auto axis : {&PointArray::x, &PointArray::y, &PointArray::z})
        for (std::size_t i = 0; i < a.size(); ++i)
            greatest = std::max(greatest, std::abs((a.*axis)[i] - (b.*axis)[i]));
    return greatest;
}

} // namespace clothlab::test
