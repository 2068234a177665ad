// How long it takes on the CPU to make of a state what the graphics card draws, and to hand it over. Needs a
// display.
#include "app/picture/scene_frame.h"
#include "app/render/surface_pass.h"
#include "simcore/solver/frame_runner.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLVersionFunctionsFactory>

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdio>

using namespace clothlab;

namespace {

Scene sheetOf(int points) {
    Scene scene;
    scene.cloth.numWidthPoints = scene.cloth.numHeightPoints = points;
    scene.cloth.thickness = 0;
    scene.cloth.pinned = {{0, 0}, {points - 1, 0}};
    return scene;
}

// Two states of a falling sheet in turn, so that each frame is another one, as in play.
void buildAndUpload(benchmark::State& state) {
    const Scene scene = sheetOf(int(state.range(0)));
    const VerletSolver solver(scene, SolverSettings{});
    const ClothState start = solver.start();
    std::array<PointArray, 2> positions{start.position, start.position};
    for (std::size_t i = 0; i < positions[1].size(); ++i)
        positions[1].y[i] += 0.05 * std::sin(20 * positions[1].x[i]) * std::cos(13 * positions[1].z[i]);

    auto* gl = QOpenGLVersionFunctionsFactory::get<render::Gl>(QOpenGLContext::currentContext());
    render::SurfacePass pass;
    render::ShaderLibrary shaders;
    QString error;
    if (!gl || !gl->initializeOpenGLFunctions() || !shaders.initialize(*gl, &error))
        return state.SkipWithError(qPrintable(error));
    pass.initialize(*gl);
    render::RenderFrame frame;
    fillLook(scene, frame);
    frame.light.shadows = false; // the shadow map is drawing
    std::size_t turn = 0;
    for (auto _ : state) {
        fillSheet(scene, solver.sheet(), positions[turn ^= 1], false, frame);
        pass.prepare(*gl, frame, shaders);
    }
    pass.destroy(*gl);
    shaders.destroy(*gl);
}

BENCHMARK(buildAndUpload)->Arg(50)->Arg(128)->Arg(256)->Arg(512)->Unit(benchmark::kMillisecond);

} // namespace

int main(int argc, char** argv) {
    const QGuiApplication application(argc, argv);
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    QOpenGLContext context;
    context.setFormat(format);
    QOffscreenSurface surface;
    surface.setFormat(format);
    surface.create();
    if (!context.create() || !context.makeCurrent(&surface)) {
        std::fputs("bench_frame: no OpenGL here; it needs an X server, like that of xvfb-run\n", stderr);
        return 1;
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
}
