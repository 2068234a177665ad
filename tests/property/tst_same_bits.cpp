// Instruction sets, threads and the cutting of a run into pieces have no influence on any bit of a state.
//
// With CLOTHLAB_LONG=1 in the environment, the scenes of the course run 10,000 steps in every way, and random
// scenes run in all ways instead of one each. That takes minutes, more than ctest allows: start
// build/release/tests/property_same_bits itself, with QTEST_FUNCTION_TIMEOUT=3600000.
#include "tests/support/oracle_run.h"
#include "tests/support/random_run.h"
#include "tests/support/settings.h"
#include "tests/support/shipped_scene.h"
#include "tests/support/states.h"

#include <QElapsedTimer>
#include <QtTest>

#include <span>

using namespace clothlab;

namespace {

constexpr int kLongSteps = 10'000;
constexpr int kStepsToContact = 2000; // by then every scene of the course has folds or lies on something
constexpr int kShortSteps = 60;       // more threads than cores take a few milliseconds a step
constexpr int kRandomRuns = 50;
constexpr int kRandomSteps = 300;

bool isLong() {
    return qEnvironmentVariableIntValue("CLOTHLAB_LONG") != 0;
}

// False if it blew up.
bool advance(VerletSolver& solver, ClothState& state, int steps) {
    const std::atomic<bool> stop = false;
    return solver.run(state, steps, stop).steps == steps;
}

// Also what is told of a run belongs to what must be the same.
struct Outcome {
    std::uint64_t hash = 0;
    std::int64_t strainLimitCorrections = 0;
    int steps = 0;
    friend bool operator==(const Outcome&, const Outcome&) = default;
};

Outcome outcome(const Scene& scene, ClothState state, int steps, const SolverSettings& settings) {
    const std::atomic<bool> stop = false;
    VerletSolver solver(scene, settings);
    const RunResult result = solver.run(state, steps, stop);
    return {stateHash(state), result.strainLimitCorrections, result.steps};
}

std::string hashText(const Outcome& of) {
    return QString::number(of.hash, 16).rightJustified(16, '0').toStdString();
}

// Empty if all settings give what the plain ones do, otherwise which do not.
std::string difference(const Scene& scene, const ClothState& start, int steps,
                       std::span<const SolverSettings> compared) {
    const Outcome expected = outcome(scene, start, steps, plainSettings());
    std::string text;
    for (const SolverSettings& settings : compared) {
        const Outcome is = outcome(scene, start, steps, settings);
        if (is != expected)
            text += describe(settings) + ": " + hashText(is) + ", not " + hashText(expected) + "; ";
    }
    return text;
}

// Upright and falling, so that it crumples on the plane.
Scene crumplingScene() {
    Scene scene;
    scene.cloth.numWidthPoints = 21;
    scene.cloth.numHeightPoints = 18;
    scene.cloth.orientation = Orientation::Vertical;
    scene.cloth.thickness = 0.02;
    scene.spheres.push_back({Vec3(0.5, 0.3, 0), 0.2, 0.2, {}});
    scene.planes.push_back({Vec3(0, 0.05, 0), Vec3(0.1, 1, 0), 0.4, {}});
    return scene;
}

// Edits of a running sheet, one after another.
std::vector<Scene> scenesOfARun() {
    Scene scene = crumplingScene();
    std::vector<Scene> scenes{scene};
    const auto then = [&](const auto& edit) {
        edit(scene);
        scenes.push_back(scene);
    };
    then([](Scene& s) { s.cloth.damping = 1.5; });
    then([](Scene& s) { s.cloth.ks = 900; });
    then([](Scene& s) { s.cloth.pinned = {{3, 2}, {20, 17}, {0, 9}}; });
    then([](Scene& s) { s.cloth.thickness = 0; });
    then([](Scene& s) { s.cloth.enableBending = false; });
    then([](Scene& s) { s.cloth.thickness = 0.02; });
    then([](Scene& s) { s.cloth.enableStructural = false; });
    then([](Scene& s) { s.cloth.enableShearing = false; }); // no spring at all
    then([](Scene& s) { s.cloth.pinned.clear(); });
    then([](Scene& s) { s.cloth.enableStructural = s.cloth.enableBending = true; });
    then([](Scene& s) { s.cloth.thickness = 0.012; });
    then([](Scene& s) { s.cloth.enableShearing = true; });
    then([](Scene& s) { s.cloth.thickness = 0.024; }); // twice what lists were made for
    return scenes;
}

// Hash after each of the scenes; 0 at a blow-up. One solver for all of them, or a new one for each.
enum class Solvers { One, OneForEach };
std::vector<std::uint64_t> hashesOfARun(const std::vector<Scene>& scenes, const SolverSettings& settings,
                                        Solvers solvers) {
    auto solver = std::make_unique<VerletSolver>(scenes.front(), settings);
    ClothState state = solver->start();
    foldSheet(scenes.front(), state, 0.03);
    throwSheet(scenes.front(), state, Vec3(0.5, -3, 0.2));
    std::vector<std::uint64_t> hashes;
    for (const Scene& scene : scenes) {
        if (solvers == Solvers::OneForEach)
            solver = std::make_unique<VerletSolver>(scene, settings);
        solver->setScene(scene);
        hashes.push_back(advance(*solver, state, 20) ? stateHash(state) : 0);
    }
    return hashes;
}

// Folded, stretched, and thrown on a sphere and a plane close below.
Start awkwardStart(int width, int height) {
    Start start;
    Cloth& cloth = start.scene.cloth;
    cloth.numWidthPoints = width;
    cloth.numHeightPoints = height;
    cloth.width = 0.05 * (width - 1);
    cloth.height = 0.05 * (height - 1);
    cloth.thickness = 0.02;
    cloth.pinned = {{width - 1, height - 1}};
    start.scene.spheres.push_back({Vec3(0.4 * cloth.width, 0.9, 0.5 * cloth.height), 0.08, 0.3, {}});
    start.scene.planes.push_back({Vec3(0, 0.95, 0), Vec3(0, 1, 0), 0.5, {}});
    start.state = startState(start.scene);
    foldSheet(start.scene, start.state, 0.03);
    throwSheet(start.scene, start.state, [&](int i, const Vec3& p) {
        return Vec3(8 * (p.x() - cloth.width / 2), -3 - 0.3 * (i % 4), 8 * (p.z() - cloth.height / 2));
    });
    return start;
}

} // namespace

class TestSameBits : public QObject {
    Q_OBJECT

private slots:
    void courseScenes_data();
    void courseScenes();
    void randomRuns();
    void runsCutIntoPieces_data();
    void runsCutIntoPieces();
    void editsOfARunningSheet();
    void awkwardSizes_data();
    void awkwardSizes();
};

void TestSameBits::courseScenes_data() {
    QTest::addColumn<QString>("file");
    for (const char* file : {"pinned2", "pinned4", "plane", "selfCollision", "sphere"})
        QTest::newRow(file) << file;
}

void TestSameBits::courseScenes() {
    QFETCH(QString, file);
    const Scene scene = test::shippedScene(file.toStdString());
    QVERIFY2(scene != Scene{}, "the scene does not load");
    ClothState state = startState(scene);
    if (!isLong()) {
        VerletSolver solver(scene);
        QVERIFY(advance(solver, state, kStepsToContact));
    }
    const int steps = isLong() ? kLongSteps : kShortSteps;
    const Outcome expected = outcome(scene, state, steps, plainSettings());
    QCOMPARE(expected.steps, steps);
    for (const SolverSettings& settings : allSettings()) {
        QElapsedTimer timer;
        timer.start();
        const Outcome is = outcome(scene, state, steps, settings);
        if (isLong())
            qInfo("%s: %s after %d steps, %.1f s", describe(settings).c_str(), hashText(is).c_str(), is.steps,
                  double(timer.elapsed()) / 1000);
        QVERIFY2(is == expected, describe(settings).c_str());
    }
}

// In turn, so that each way meets every trial: their numbers have no common divisor.
void TestSameBits::randomRuns() {
    const std::vector<SolverSettings> all = allSettings();
    for (std::size_t seed = 0; seed < kRandomRuns; ++seed) {
        const RandomRun made = randomRun(seed);
        const std::span<const SolverSettings> ways(all);
        const std::string text = difference(made.scene, made.start, kRandomSteps,
                                            isLong() ? ways : ways.subspan(seed % ways.size(), 1));
        QVERIFY2(text.empty(), (made.describe() + ": " + text).c_str());
    }
}

void TestSameBits::runsCutIntoPieces_data() {
    QTest::addColumn<QString>("file");
    for (const char* file : {"pinned2", "selfCollision", "sphere"})
        QTest::newRow(file) << file;
}

void TestSameBits::runsCutIntoPieces() {
    QFETCH(QString, file);
    const Scene scene = test::shippedScene(file.toStdString());
    QVERIFY2(scene != Scene{}, "the scene does not load");
    ClothState start = startState(scene);
    VerletSolver reference(scene);
    QVERIFY(advance(reference, start, kStepsToContact));
    constexpr int kSteps = 210; // a multiple of each piece
    const Outcome expected = outcome(scene, start, kSteps, plainSettings());
    for (const int threads : {1, 2, 3})
        for (const int piece : {1, 7, 30, kSteps}) {
            VerletSolver solver(scene, {threads, 1});
            ClothState state = start;
            for (int done = 0; done < kSteps; done += piece)
                QVERIFY(advance(solver, state, piece));
            QVERIFY2(stateHash(state) == expected.hash,
                     qPrintable(QString("%1 threads, pieces of %2").arg(threads).arg(piece)));
        }
}

void TestSameBits::editsOfARunningSheet() {
    const std::vector<Scene> scenes = scenesOfARun();
    for (std::size_t n = 1; n < scenes.size(); ++n)
        QCOMPARE(compareScenes(scenes[n - 1], scenes[n]), SceneChange::Motion);
    const std::vector<std::uint64_t> expected = hashesOfARun(scenes, plainSettings(), Solvers::OneForEach);
    QVERIFY(std::ranges::count(expected, 0U) == 0);
    for (const SolverSettings& settings : allSettings()) {
        const std::vector<std::uint64_t> hashes = hashesOfARun(scenes, settings, Solvers::One);
        for (std::size_t n = 0; n < scenes.size(); ++n)
            QVERIFY2(hashes[n] == expected[n], (describe(settings) + ", edit " + std::to_string(n)).c_str());
    }
}

// Narrower than a vector, just below, at and above whole vectors, and fewer rows than threads.
void TestSameBits::awkwardSizes_data() {
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    constexpr int kSizes[][2] = {{2, 2}, {2, 9},  {9, 2},  {3, 3},  {4, 5},
                                 {5, 4}, {63, 3}, {64, 4}, {65, 5}, {3, 70}};
    for (const auto& [width, height] : kSizes)
        QTest::addRow("%d x %d", width, height) << width << height;
}

void TestSameBits::awkwardSizes() {
    QFETCH(int, width);
    QFETCH(int, height);
    const Start start = awkwardStart(width, height);
    for (const SolverSettings& settings : allSettings()) {
        const OracleRun run = runBeside(start, 50, settings);
        const std::string text = describe(settings) + ": " + run.describe();
        QVERIFY2(run.distance == 0 && run.strainLimits == run.counts.strainLimits, text.c_str());
        QVERIFY2(run.counts.planeContacts + run.counts.sphereContacts > 0, text.c_str());
        QVERIFY2(run.counts.strainLimits > 0 && run.counts.selfCollisions > 0, text.c_str());
    }
}

QTEST_APPLESS_MAIN(TestSameBits)
#include "tst_same_bits.moc"
