#include "app/cli/render_frames.h"

#include "app/cli/arguments.h"
#include "app/cli/run_control.h"
#include "app/export/export_request.h"
#include "app/export/picture_writers.h"
#include "app/picture/scene_frame.h"
#include "simcore/export/run_export.h"
#include "simcore/inspect/blow_up_text.h"
#include "simcore/solver/frame_runner.h"

#include <cstdio>

namespace clothlab::cli {
namespace {

// Frames as they are asked for, in increasing order.
class LiveRun {
public:
    LiveRun(VerletSolver& solver, const std::atomic<bool>& stop)
        : m_solver(solver), m_stop(stop), m_scene(std::make_shared<const Scene>(solver.scene())),
          m_state(solver.start()) {}

    FramePointer frame(int number, std::string& reason) {
        for (; m_number < number; ++m_number) {
            const FrameResult result = runFrame(m_solver, m_state, m_stop);
            if (result.finished)
                continue;
            reason = result.blowUp ? describeBlowUp(*result.blowUp, result.blowUpStep, m_number + 1, *m_scene)
                                   : "interrupted";
            return nullptr;
        }
        const double time = double(number) / m_scene->simulation.framesPerSecond;
        return std::make_shared<const Frame>(Frame{m_state, m_scene, time, 0, 0});
    }

private:
    VerletSolver& m_solver;
    const std::atomic<bool>& m_stop;
    std::shared_ptr<const Scene> m_scene;
    ClothState m_state;
    int m_number = 0;
};

FrameSource sourceOf(VerletSolver& solver, int frames, const std::atomic<bool>& stop) {
    return {frames + 1, solver.sheet(),
            [run = std::make_shared<LiveRun>(solver, stop)](int number, std::string& reason) {
                return run->frame(number, reason);
            }};
}

void tell(const render::Problems& problems) {
    for (const render::Problem& problem : problems)
        std::fprintf(stderr, "clothlab: %s\n", qPrintable(render::words(problem)));
}

// The box around the sheet in all of the frames, so that the camera need not move. It takes the run once
// more.
Eigen::AlignedBox3d boxOfAll(VerletSolver& solver, const ExportRange& range, const std::atomic<bool>& stop) {
    const FrameSource source = sourceOf(solver, range.last, stop);
    Eigen::AlignedBox3d box;
    std::string reason;
    for (int i = 0; i < range.count(); ++i) {
        const FramePointer frame = source.frame(range.frameAt(i), reason);
        if (!frame)
            break;
        box.extend(boxAround(frame->state.position));
    }
    return box;
}

PictureLook lookOf(VerletSolver& solver, const Scene& scene, const RenderOptions& options,
                   const ExportRange& range, const std::atomic<bool>& stop) {
    PictureLook look;
    look.scene = std::make_shared<const Scene>(scene);
    look.sheet = solver.sheet();
    look.size = options.size;
    look.source = options.source;
    look.onProblems = tell;
    Camera camera;
    camera.view = scene.camera.value_or(homeView(scene.cloth));
    if (options.fit)
        fitCamera(boxOfAll(solver, range, stop), options.size, camera);
    look.frame.viewProjection = camera.viewProjection(options.size);
    look.frame.cameraPosition = camera.eye();
    fillLook(scene, look.frame);
    return look;
}

std::unique_ptr<FrameWriter> writerOf(const RenderOptions& options, double framesPerSecond, PictureLook look,
                                      const std::atomic<bool>& stop) {
    auto painter = makeFramePainter(std::move(look));
    if (options.video)
        return makeVideoWriter(options.path.forFrame(0).toStdString(), *options.video, framesPerSecond,
                               std::move(painter), stop);
    return makePngWriter([path = options.path](int frame) { return path.forFrame(frame).toStdString(); },
                         std::move(painter));
}

int exitStatus(const ExportResult& result) {
    switch (result.end) {
    case ExportEnd::Done:
        break;
    case ExportEnd::Cancelled:
        return fail(Interrupted, QStringLiteral("interrupted after %1 pictures").arg(result.written));
    case ExportEnd::NoFrame:
        return fail(SimulationBlewUp, QString::fromStdString(result.reason));
    case ExportEnd::NotWritten:
        return fail(OutputNotWritten, QString::fromStdString(result.reason));
    }
    return Done;
}

} // namespace

Eigen::AlignedBox3d boxAround(const PointArray& position) {
    Eigen::AlignedBox3d box;
    for (int i = 0; i < int(position.size()); ++i)
        box.extend(position.at(i));
    return box;
}

void fitCamera(const Eigen::AlignedBox3d& box, QSize size, Camera& camera) {
    if (box.isEmpty())
        return;
    const Vec3 centre = box.center();
    camera.frame({float(centre.x()), float(centre.y()), float(centre.z())}, box.diagonal().norm() / 2, size);
}

int renderFrames(VerletSolver& solver, const Scene& scene, const RenderOptions& options) {
    const int recorded = scene.simulation.framesPerSecond;
    if (options.framesPerSecond && *options.framesPerSecond > recorded)
        return fail(
            WrongUsage,
            QStringLiteral("--fps: the scene has %1 frames per second; ask for no more").arg(recorded));
    if (options.video && findFfmpeg().isEmpty()) // said before anything is simulated
        return fail(OutputNotWritten, options.output + ": " + howToGetFfmpeg());
    const double step = options.framesPerSecond ? double(recorded) / *options.framesPerSecond
                        : options.video         ? videoStep(recorded)
                                                : 1;
    const ExportRange range{0, options.frames, step};
    const std::atomic<bool>& stop = stopOnInterrupt();
    const auto writer = writerOf(options, recorded / step, lookOf(solver, scene, options, range, stop), stop);
    const int count = range.count();
    showProgress(0, count);
    return exitStatus(runExport(
        sourceOf(solver, options.frames, stop), range, *writer, stop,
        [count](int written) { showProgress(written, count); }, IfAFrameFails::KeepThoseBefore));
}

} // namespace clothlab::cli
