// simcore's step against the plain reading of the model, over whole runs.
#include "simcore/scene/scene_io.h"
#include "simcore/solver/verlet_solver.h"
#include "tests/support/oracle_run.h"
#include "tests/support/random_run.h"
#include "tests/support/states.h"

#include <QtTest>

using namespace clothlab;

namespace {

constexpr int kSteps = 300;
constexpr double kTolerance = 1e-9;        // m, after a run
constexpr double kStepTolerance = 1e-14;   // m, in one step
constexpr double kPredictable = 1e-12;     // m
constexpr int kLeastPredictableSteps = 80; // of a scene that loses its predictability
constexpr int kRandomRuns = 12;

Start courseScene(const QString& file) {
    const SceneReading reading = loadScene(CLOTHLAB_SOURCE_DIR "/scenes/" + file.toStdString());
    if (!reading.scene)
        return {};
    return {*reading.scene, startState(*reading.scene)};
}

// Fast enough to reach the sphere or the plane in time, and with ends that stretch the sheet.
Start thrownCourseScene(const QString& file) {
    Start start = courseScene(file);
    const double width = start.scene.cloth.width;
    const Vec3 down(0, start.scene.planes.empty() ? -8 : -12, 0);
    throwSheet(start.scene, start.state, [&](int, const Vec3& p) {
        return Vec3(down + Vec3(3 * (p.x() - width / 2), 0, 0.5 * p.x() * p.z()));
    });
    return start;
}

Start foldedCourseScene(const QString& file) {
    Start start = courseScene(file);
    foldSheet(start.scene, start.state, 1.2 * start.scene.cloth.thickness);
    throwSheet(start.scene, start.state, [](int, const Vec3& p) { return Vec3(0, -1 + p.x(), 0.1 * p.z()); });
    return start;
}

// What is wrong with a run that starts there; empty if nothing is. A scene that amplifies rounding errors
// is compared for as long as the oracle agrees with itself, and step by step to the end.
std::string disagreement(const Start& start, const OracleRun& run) {
    if (!(run.distanceInOneStep < kStepTolerance))
        return "a step differs: " + run.describe();
    if (run.distance < kTolerance)
        return run.strainLimits == run.counts.strainLimits ? "" : "other strain limits: " + run.describe();
    const int predictable = predictableSteps(start, kSteps, kPredictable);
    if (predictable == kSteps || predictable < kLeastPredictableSteps)
        return run.describe() + "; predictable for " + std::to_string(predictable);
    const OracleRun part = runBeside(start, predictable);
    qInfo("predictable for %d steps: %s", predictable, part.describe().c_str());
    return part.distance < kTolerance ? "" : "while predictable: " + part.describe();
}

} // namespace

class TestOracle : public QObject {
    Q_OBJECT

private slots:
    void startsAtTheSamePlace_data() { courseFiles(); }
    void startsAtTheSamePlace();
    void courseSceneAsItIs_data() { courseFiles(); }
    void courseSceneAsItIs();
    void courseSceneThrown_data() { courseFiles(); }
    void courseSceneThrown();
    void courseSceneFolded_data() { courseFiles(); }
    void courseSceneFolded();
    void randomRuns_data();
    void randomRuns();
    void randomRunsAreValidAndRepeatable();

private:
    void courseFiles() {
        QTest::addColumn<QString>("file");
        for (const char* name : {"pinned2", "pinned4", "plane", "selfCollision", "sphere"})
            QTest::newRow(name) << QString(name) + ".json";
    }
};

void TestOracle::startsAtTheSamePlace() {
    QFETCH(QString, file);
    const Start start = courseScene(file);
    QVERIFY2(start.state.size() > 0, "the scene does not load");
    const oracle::Cloth cloth(start.scene);
    QCOMPARE(greatestDistance(start.state.position, cloth.points), 0.0);
    const VerletSolver solver(start.scene);
    QCOMPARE(int(cloth.springs.size()), solver.sheet().grid.springCount());
    for (int n = 0; n < int(cloth.springs.size()); ++n) {
        const Spring spring = solver.sheet().grid.spring(n);
        const oracle::Spring& expected = cloth.springs[std::size_t(n)];
        QCOMPARE(spring.a, expected.a);
        QCOMPARE(spring.b, expected.b);
        QVERIFY(std::abs(solver.sheet().restLengthOf(spring) - expected.restLength) < 1e-15);
    }
}

void TestOracle::courseSceneAsItIs() {
    QFETCH(QString, file);
    const Start start = courseScene(file);
    QVERIFY2(start.state.size() > 0, "the scene does not load");
    const OracleRun run = runBeside(start, kSteps);
    qInfo("%s", run.describe().c_str());
    const std::string wrong = disagreement(start, run);
    QVERIFY2(wrong.empty(), wrong.c_str());
}

void TestOracle::courseSceneThrown() {
    QFETCH(QString, file);
    const Start start = thrownCourseScene(file);
    const OracleRun run = runBeside(start, kSteps);
    qInfo("%s", run.describe().c_str());
    const std::string wrong = disagreement(start, run);
    QVERIFY2(wrong.empty(), wrong.c_str());
    QVERIFY(run.counts.strainLimits > 0);
    QVERIFY(start.scene.spheres.empty() || run.counts.sphereContacts > 0);
    QVERIFY(start.scene.planes.empty() || run.counts.planeContacts > 0);
}

void TestOracle::courseSceneFolded() {
    QFETCH(QString, file);
    const Start start = foldedCourseScene(file);
    const OracleRun run = runBeside(start, kSteps);
    qInfo("%s", run.describe().c_str());
    const std::string wrong = disagreement(start, run);
    QVERIFY2(wrong.empty(), wrong.c_str());
    QVERIFY(run.counts.selfCollisions > 0);
}

void TestOracle::randomRuns_data() {
    QTest::addColumn<quint64>("seed");
    for (quint64 seed = 0; seed < kRandomRuns; ++seed)
        QTest::addRow("%s, seed %d", name(randomRun(seed).trial).data(), int(seed)) << seed;
}

void TestOracle::randomRuns() {
    QFETCH(quint64, seed);
    const RandomRun made = randomRun(seed);
    const Start start{made.scene, made.start};
    const OracleRun run = runBeside(start, kSteps);
    const std::string text = made.describe() + ": " + run.describe();
    qInfo("%s", text.c_str());
    const std::string wrong = disagreement(start, run);
    QVERIFY2(wrong.empty(), (made.describe() + ": " + wrong).c_str());
    QVERIFY2(made.trial != Trial::Folded || run.counts.selfCollisions > 0, text.c_str());
    QVERIFY2(made.trial != Trial::OnSphere || run.counts.sphereContacts > 0, text.c_str());
    QVERIFY2(made.trial != Trial::OnPlane || run.counts.planeContacts > 0, text.c_str());
    QVERIFY2(made.trial != Trial::Thrown || run.counts.strainLimits > 0, text.c_str());
}

void TestOracle::randomRunsAreValidAndRepeatable() {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const RandomRun made = randomRun(seed);
        QVERIFY2(!hasErrors(validate(made.scene)), made.describe().c_str());
        const RandomRun again = randomRun(seed);
        QVERIFY2(made.scene == again.scene && made.start == again.start, made.describe().c_str());
    }
}

QTEST_APPLESS_MAIN(TestOracle)
#include "tst_oracle.moc"
