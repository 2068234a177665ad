// A step that is too large for its springs is found out at once, and frames stop.
#include "simcore/inspect/inspect.h"
#include "simcore/solver/frame_runner.h"
#include "tests/support/states.h"

#include <QtTest>

#include <limits>

using namespace clothlab;

namespace {

Scene hangingScene(double ks) {
    Scene scene;
    scene.cloth.numWidthPoints = 20;
    scene.cloth.numHeightPoints = 15;
    scene.cloth.pinned = {{0, 0}, {19, 0}};
    scene.cloth.ks = ks;
    return scene;
}

bool isPlace(const BlowUp& blowUp, const ClothState& state) {
    return blowUp.point >= 0 && blowUp.point < int(state.size()) && !name(blowUp.phase).empty();
}

} // namespace

class TestBlowUp : public QObject {
    Q_OBJECT

private slots:
    void noNanPassesForFine_data();
    void noNanPassesForFine();
    void absurdStiffnessIsReported();
    void notANumberIsReported_data();
    void notANumberIsReported();
    void thrownOutByAColliderIsReported();
    void coincidentPointsAreFine();
    void frameTakesItsSteps();
    void frameStopsOnTheFlag();
    void frameStopsWhereItBlowsUp();
};

void TestBlowUp::noNanPassesForFine_data() {
    QTest::addColumn<double>("ks");
    QTest::addColumn<double>("density");
    QTest::addColumn<bool>("limited");
    for (const double ks : {0.0, 5e3, 5e5, 5e6, 1e9})
        for (const double density : {150.0, 1.0, 1e-6})
            for (const bool limited : {true, false})
                QTest::addRow("ks %g, density %g%s", ks, density, limited ? "" : ", bending springs only")
                    << ks << density << limited;
}

// Either the state is finite after a step, or the step says that it is not.
void TestBlowUp::noNanPassesForFine() {
    QFETCH(double, ks);
    QFETCH(double, density);
    QFETCH(bool, limited);
    Scene scene = hangingScene(ks);
    scene.cloth.density = density;
    scene.cloth.enableStructural = scene.cloth.enableShearing = limited;
    VerletSolver solver(scene);
    ClothState state = solver.start();
    for (int n = 0; n < 300; ++n) {
        const StepResult result = solver.step(state);
        if (result.blowUp) {
            QVERIFY(isPlace(*result.blowUp, state));
            return;
        }
        QVERIFY2(allFinite(state), qPrintable(QString("step %1").arg(n)));
    }
    QVERIFY(ks < 1e9);
}

void TestBlowUp::absurdStiffnessIsReported() {
    VerletSolver solver(hangingScene(1e9));
    ClothState state = solver.start();
    for (int n = 0; n < 300; ++n) {
        const StepResult result = solver.step(state);
        if (!result.blowUp)
            continue;
        QVERIFY(isPlace(*result.blowUp, state));
        QVERIFY(!solver.pinned()[std::size_t(result.blowUp->point)]);
        return;
    }
    QFAIL("no blow-up in 300 steps");
}

void TestBlowUp::notANumberIsReported_data() {
    QTest::addColumn<double>("value");
    QTest::addColumn<bool>("last");
    for (const bool last : {false, true}) {
        const char* where = last ? "last position" : "position";
        QTest::addRow("NaN as %s", where) << std::numeric_limits<double>::quiet_NaN() << last;
        QTest::addRow("infinity as %s", where) << std::numeric_limits<double>::infinity() << last;
        QTest::addRow("-1e300 as %s", where) << -1e300 << last;
    }
}

void TestBlowUp::notANumberIsReported() {
    QFETCH(double, value);
    QFETCH(bool, last);
    Scene scene = hangingScene(5000);
    scene.spheres.emplace_back();
    scene.planes.emplace_back();
    for (int axis = 0; axis < 3; ++axis) {
        VerletSolver solver(scene);
        ClothState state = solver.start();
        PointArray& points = last ? state.lastPosition : state.position;
        Vec3 p = points.at(137);
        p[axis] = value;
        points.set(137, p);
        const StepResult result = solver.step(state);
        QVERIFY(result.blowUp.has_value());
        QVERIFY(isPlace(*result.blowUp, state));
    }
}

// The phases after the second move points too: here a sphere far larger than the sheet that is inside it.
void TestBlowUp::thrownOutByAColliderIsReported() {
    Scene scene = hangingScene(5000);
    scene.spheres.push_back({Vec3(0.5, 0, 0.5), 1e4, 0, {}});
    VerletSolver solver(scene);
    ClothState state = solver.start();
    const StepResult result = solver.step(state);
    QVERIFY(result.blowUp.has_value());
    QVERIFY(result.blowUp->phase > Phase::SelfCollision);
    QVERIFY(!solver.pinned()[std::size_t(result.blowUp->point)]);
}

void TestBlowUp::coincidentPointsAreFine() {
    Scene scene = hangingScene(5000);
    scene.spheres.push_back({Vec3(0.5, 1, 0.5), 0.1, 0.3, {}});
    VerletSolver solver(scene);
    ClothState state = solver.start();
    for (int i = 0; i < int(state.size()); ++i)
        state.position.set(i, Vec3(0.5, 1, 0.5));
    state.lastPosition = state.position;
    for (int n = 0; n < 5; ++n) {
        QVERIFY(!solver.step(state).blowUp);
        QVERIFY(allFinite(state));
    }
}

void TestBlowUp::frameTakesItsSteps() {
    const Scene scene = hangingScene(5000);
    VerletSolver solver(scene);
    ClothState state = solver.start();
    throwSheet(scene, state, Vec3(0, -6, 0)); // away from its pins, so that springs reach their limit
    ClothState expected = state;
    const std::atomic<bool> stop = false;
    const FrameResult result = runFrame(solver, state, stop);
    QVERIFY(result.finished);
    QVERIFY(!result.blowUp);
    VerletSolver other(scene);
    std::int64_t corrections = 0;
    int inLastStep = 0;
    for (int n = 0; n < 30; ++n)
        corrections += inLastStep = other.step(expected).strainLimitCorrections;
    QCOMPARE(state, expected);
    QCOMPARE(result.strainLimitCorrections, corrections);
    QVERIFY(corrections > inLastStep);
}

void TestBlowUp::frameStopsOnTheFlag() {
    VerletSolver solver(hangingScene(5000));
    ClothState state = solver.start();
    const std::atomic<bool> stop = true;
    const FrameResult result = runFrame(solver, state, stop);
    QVERIFY(!result.finished);
    QVERIFY(!result.blowUp);
    QCOMPARE(state, solver.start());
}

void TestBlowUp::frameStopsWhereItBlowsUp() {
    VerletSolver solver(hangingScene(1e9));
    ClothState state = solver.start();
    const std::atomic<bool> stop = false;
    for (int frame = 0; frame < 10; ++frame) {
        const FrameResult result = runFrame(solver, state, stop);
        if (result.finished)
            continue;
        QVERIFY(result.blowUp.has_value());
        QVERIFY(result.blowUpStep >= 1 && result.blowUpStep <= 30);
        VerletSolver other(hangingScene(1e9));
        ClothState again = other.start();
        for (int n = 1; n < 30 * frame + result.blowUpStep; ++n)
            QVERIFY(!other.step(again).blowUp);
        QVERIFY(other.step(again).blowUp.has_value());
        return;
    }
    QFAIL("no blow-up in ten frames");
}

QTEST_APPLESS_MAIN(TestBlowUp)
#include "tst_blow_up.moc"
