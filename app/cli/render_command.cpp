#include "app/cli/render_command.h"

#include "app/cli/arguments.h"
#include "app/cli/render_frames.h"
#include "app/document/scene_files.h"
#include "app/picture/camera.h"
#include "app/picture/save_picture.h"
#include "app/picture/scene_frame.h"
#include "app/render/offscreen_picture.h"
#include "app/render/shader_library.h"
#include "simcore/inspect/blow_up_text.h"
#include "simcore/scene/scene_io.h"
#include "simcore/solver/frame_runner.h"

#include <QFileInfo>
#include <QPainter>

#include <cstdio>

namespace clothlab::cli {
namespace {

// Up to the frame asked for. What went wrong, in words; empty if nothing did.
QString simulateTo(int frame, VerletSolver& solver, ClothState& state) {
    const std::atomic<bool> never{false};
    for (int number = 1; number <= frame; ++number)
        if (const FrameResult result = runFrame(solver, state, never); result.blowUp)
            return QString::fromStdString(
                describeBlowUp(*result.blowUp, result.blowUpStep, number, solver.scene()));
    return {};
}

render::RenderFrame frameOf(const Scene& scene, const RenderOptions& options, const VerletSolver& solver,
                            const ClothState& state) {
    render::RenderFrame frame;
    Camera camera;
    camera.view = scene.camera.value_or(homeView(scene.cloth));
    if (options.fit)
        fitCamera(boxAround(state.position), options.size, camera);
    frame.viewProjection = camera.viewProjection(options.size);
    frame.cameraPosition = camera.eye();
    frame.time = float(options.frame) / float(scene.simulation.framesPerSecond);
    fillLook(scene, frame);
    fillSheet(scene, solver.sheet(), state.position,
              render::takesStrain(options.source.shaderDirectory, frame.surface.shader), frame);
    return frame;
}

// Pictures side by side, each with the name of its shader under it.
QImage contactSheet(const std::vector<std::pair<QString, QImage>>& pictures, const QColor& background) {
    constexpr int most = 4; // in a row
    constexpr int gap = 8;
    const QSize size = pictures.front().second.size();
    const int columns = std::min(most, int(pictures.size()));
    const int rows = (int(pictures.size()) + columns - 1) / columns;
    const int caption = std::max(16, size.height() / 10);
    QImage sheet(columns * (size.width() + gap) + gap, rows * (size.height() + caption + gap) + gap,
                 QImage::Format_RGB32);
    sheet.fill(background.lighter(130));
    QPainter painter(&sheet);
    QFont font = painter.font();
    font.setPixelSize(6 * caption / 10);
    painter.setFont(font);
    painter.setPen(QColor(0xE4, 0xE6, 0xE8));
    for (int i = 0; i < int(pictures.size()); ++i) {
        const QPoint corner(gap + i % columns * (size.width() + gap),
                            gap + i / columns * (size.height() + caption + gap));
        painter.drawImage(corner, pictures[std::size_t(i)].second);
        painter.drawText(QRect(corner + QPoint(0, size.height()), QSize(size.width(), caption)),
                         Qt::AlignCenter, pictures[std::size_t(i)].first);
    }
    return sheet;
}

int drawAndWrite(Scene& scene, const RenderOptions& options, const VerletSolver& solver,
                 const ClothState& state) {
    const QStringList shaders =
        options.shader == kAllShaders ? render::listShaders(options.source.shaderDirectory)
        : options.shader.isEmpty()    ? QStringList{QString::fromStdString(scene.appearance.shader)}
                                      : QStringList{options.shader};
    std::vector<std::pair<QString, QImage>> pictures;
    QColor background;
    for (const QString& shader : shaders) {
        scene.appearance.shader = shader.toStdString();
        const render::RenderFrame frame = frameOf(scene, options, solver, state);
        background = frame.background;
        render::Problems problems;
        QString reason;
        const auto picture = render::renderPicture(frame, options.size, options.source, problems, reason);
        if (!picture)
            return fail(WrongUsage, reason);
        for (const render::Problem& problem : problems)
            std::fprintf(stderr, "clothlab: %s\n", qPrintable(render::words(problem)));
        pictures.emplace_back(shader, *picture);
    }
    const auto error =
        savePicture(pictures.size() == 1 ? pictures.front().second : contactSheet(pictures, background),
                    options.path.forFrame(0));
    return error ? fail(OutputNotWritten, *error) : int(Done);
}

} // namespace

int renderCommand(const QStringList& arguments) {
    RenderOptions options;
    if (const QString error = parseRender(arguments, options); !error.isEmpty())
        return fail(WrongUsage, error + "; see clothlab --help");
    SceneReading reading = loadScene(options.scene.toStdString());
    for (const Diagnostic& diagnostic : reading.diagnostics)
        std::fprintf(stderr, "%s\n", toText(diagnostic, options.scene.toStdString()).c_str());
    if (!reading.scene)
        return InvalidInput;
    SolverSettings settings;
    settings.threads = options.threads.value_or(0);
    VerletSolver solver(*reading.scene, settings);
    Scene scene = withAbsoluteFiles(*reading.scene, QFileInfo(options.scene).absolutePath());
    if (!options.shader.isEmpty() && !options.isOnePicture())
        scene.appearance.shader = options.shader.toStdString();
    if (!options.isOnePicture())
        return renderFrames(solver, scene, options);
    ClothState state = solver.start();
    if (const QString error = simulateTo(options.frame, solver, state); !error.isEmpty())
        return fail(SimulationBlewUp, error);
    return drawAndWrite(scene, options, solver, state);
}

} // namespace clothlab::cli
