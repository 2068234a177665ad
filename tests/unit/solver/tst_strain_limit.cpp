// Phase 5 alone: without gravity and stiffness, nothing else moves a sheet at rest.
#include "simcore/solver/verlet_solver.h"
#include "tests/support/random.h"

#include <QtTest>

using namespace clothlab;

namespace {

enum Types { kStructural = 1, kShearing = 2, kBending = 4, kAll = 7 };

// Points a metre apart.
Scene stillScene(int nx, int ny, int types) {
    Scene scene;
    scene.cloth.numWidthPoints = nx;
    scene.cloth.numHeightPoints = ny;
    scene.cloth.width = nx - 1;
    scene.cloth.height = ny - 1;
    scene.cloth.ks = 0;
    scene.cloth.thickness = 0;
    scene.cloth.enableStructural = (types & kStructural) != 0;
    scene.cloth.enableShearing = (types & kShearing) != 0;
    scene.cloth.enableBending = (types & kBending) != 0;
    scene.simulation.gravity = Vec3(0, 0, 0);
    return scene;
}

void place(ClothState& state, int i, const Vec3& p) {
    state.position.set(i, p);
    state.lastPosition.set(i, p);
}

// The springs of whose ends none is an end of a later one: nothing moves these after they were limited.
std::vector<Spring> lastTouched(const Scene& scene, const Grid& grid) {
    std::vector<Spring> last;
    std::vector<bool> touched(std::size_t(grid.pointCount()), false);
    for (int n = grid.springCount() - 1; n >= 0; --n) {
        const Spring s = grid.spring(n);
        if (!scene.cloth.enabled(s.type()))
            continue;
        if (!touched[std::size_t(s.a)] && !touched[std::size_t(s.b)])
            last.push_back(s);
        touched[std::size_t(s.a)] = touched[std::size_t(s.b)] = true;
    }
    return last;
}

} // namespace

class TestStrainLimit : public QObject {
    Q_OBJECT

private slots:
    void bothEndsMoveHalf();
    void onlyTheFreeEndMoves_data();
    void onlyTheFreeEndMoves();
    void pinnedEndsStay();
    void atTheLimitNothingMoves();
    void compressedSpringsStay();
    void oneAfterTheOther();
    void typesTakeTurns();
    void switchedOffTypesAreNotLimited();
    void springsTouchedLastKeepTheLimit_data();
    void springsTouchedLastKeepTheLimit();
    void chainFromAPinIsLimitedAllAlong();
    void pointsAtOnePlaceStayThere();
};

// The diagonal from (0, 0) to (1, 1), pulled to three times its length along itself.
void TestStrainLimit::bothEndsMoveHalf() {
    VerletSolver solver(stillScene(2, 2, kShearing));
    ClothState state = solver.start();
    place(state, 0, Vec3(-1, 1, -1));
    place(state, 3, Vec3(2, 1, 2));
    const ClothState before = state;
    QCOMPARE(solver.step(state).strainLimitCorrections, 1);
    QVERIFY((state.position.at(0) - Vec3(-0.05, 1, -0.05)).norm() < 1e-15);
    QVERIFY((state.position.at(3) - Vec3(1.05, 1, 1.05)).norm() < 1e-15);
    QCOMPARE(state.position.at(1), before.position.at(1));
    QCOMPARE(state.position.at(2), before.position.at(2));
    QCOMPARE(state.lastPosition, before.lastPosition);
}

void TestStrainLimit::onlyTheFreeEndMoves_data() {
    QTest::addColumn<bool>("startPinned");
    QTest::newRow("the point the spring starts from is pinned") << true;
    QTest::newRow("the other is pinned") << false;
}

void TestStrainLimit::onlyTheFreeEndMoves() {
    QFETCH(bool, startPinned);
    Scene scene = stillScene(2, 2, kShearing);
    scene.cloth.pinned = {startPinned ? GridPoint{1, 1} : GridPoint{0, 0}}; // springs start at (1, 1)
    VerletSolver solver(scene);
    ClothState state = solver.start();
    place(state, 0, Vec3(-1, 1, -1));
    place(state, 3, Vec3(2, 1, 2));
    QCOMPARE(solver.step(state).strainLimitCorrections, 1);
    const Vec3 first = startPinned ? Vec3(0.9, 1, 0.9) : Vec3(-1, 1, -1);
    const Vec3 last = startPinned ? Vec3(2, 1, 2) : Vec3(0.1, 1, 0.1);
    QVERIFY((state.position.at(0) - first).norm() < 1e-15);
    QVERIFY((state.position.at(3) - last).norm() < 1e-15);
}

void TestStrainLimit::pinnedEndsStay() {
    Scene scene = stillScene(2, 2, kAll);
    scene.cloth.pinned = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
    VerletSolver solver(scene);
    ClothState state = solver.start();
    place(state, 0, Vec3(-9, 1, -9));
    const ClothState before = state;
    QCOMPARE(solver.step(state).strainLimitCorrections, 0);
    QCOMPARE(state, before);
}

void TestStrainLimit::atTheLimitNothingMoves() {
    VerletSolver solver(stillScene(2, 2, kStructural));
    ClothState state = solver.start();
    place(state, 1, Vec3(1.1, 1, 0));
    place(state, 3, Vec3(1.1, 1, 1));
    const ClothState before = state;
    QCOMPARE(solver.step(state).strainLimitCorrections, 0);
    QCOMPARE(state, before);
    place(state, 1, Vec3(std::nextafter(1.1, 2), 1, 0));
    QCOMPARE(solver.step(state).strainLimitCorrections, 1);
}

void TestStrainLimit::compressedSpringsStay() {
    VerletSolver solver(stillScene(5, 4, kAll));
    ClothState state = solver.start();
    for (int i = 0; i < int(state.size()); ++i)
        place(state, i, 0.3 * state.position.at(i));
    const ClothState before = state;
    QCOMPARE(solver.step(state).strainLimitCorrections, 0);
    QCOMPARE(state, before);
}

// Rows at 0, 1.5, 3. The first spring draws its ends to 0.2 and 1.3; the second finds 1.3 and 3 and draws
// them to 1.6 and 2.7.
void TestStrainLimit::oneAfterTheOther() {
    VerletSolver solver(stillScene(3, 2, kStructural));
    ClothState state = solver.start();
    for (int i = 0; i < 6; ++i)
        place(state, i, Vec3(1.5 * (i % 3), 1, i / 3));
    QCOMPARE(solver.step(state).strainLimitCorrections, 4);
    const double expected[] = {0.2, 1.6, 2.7};
    for (int i = 0; i < 6; ++i)
        QVERIFY((state.position.at(i) - Vec3(expected[i % 3], 1, i / 3)).norm() < 1e-14);
}

// Structural springs left, then up: point (1, 1) of a square whose rows and columns are both too long.
void TestStrainLimit::typesTakeTurns() {
    VerletSolver solver(stillScene(2, 2, kStructural));
    ClothState state = solver.start();
    place(state, 3, Vec3(2, 1, 1)); // left spring: 2 long, starts at 3
    solver.step(state);
    // Left: 0.9 too long; points 2 and 3 go to x = 0.45 and 1.55. Up: from there to (1, 0) and (0, 0).
    const Vec3 up2 = Vec3(0.45, 0, 1);
    const Vec3 up3 = Vec3(0.55, 0, 1);
    const auto excess = [](const Vec3& v) { return std::max(0.0, v.norm() - 1.1); };
    const Vec3 p2 = Vec3(0.45, 1, 1) - 0.5 * excess(up2) * up2.normalized();
    const Vec3 p3 = Vec3(1.55, 1, 1) - 0.5 * excess(up3) * up3.normalized();
    QVERIFY((state.position.at(2) - p2).norm() < 1e-14);
    QVERIFY((state.position.at(3) - p3).norm() < 1e-14);
}

void TestStrainLimit::switchedOffTypesAreNotLimited() {
    VerletSolver solver(stillScene(6, 5, 0));
    ClothState state = solver.start();
    for (int i = 0; i < int(state.size()); ++i)
        place(state, i, 3 * state.position.at(i));
    const ClothState before = state;
    QCOMPARE(solver.step(state).strainLimitCorrections, 0);
    QCOMPARE(state, before);
}

void TestStrainLimit::springsTouchedLastKeepTheLimit_data() {
    QTest::addColumn<int>("types");
    QTest::newRow("structural") << int(kStructural);
    QTest::newRow("shearing") << int(kShearing);
    QTest::newRow("bending") << int(kBending);
    QTest::newRow("all") << int(kAll);
}

void TestStrainLimit::springsTouchedLastKeepTheLimit() {
    QFETCH(int, types);
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        SplitMix64 random(seed);
        const Scene scene = stillScene(random.integer(3, 12), random.integer(3, 12), types);
        VerletSolver solver(scene);
        ClothState state = solver.start();
        for (int i = 0; i < int(state.size()); ++i) {
            const double lift = random.real(-0.5, 0.5);
            place(state, i, 1.3 * state.position.at(i) + Vec3(0, lift, random.real(-0.3, 0.3)));
        }
        const std::vector<Spring> last = lastTouched(scene, solver.sheet().grid);
        const auto worstStrain = [&](const ClothState& s) {
            double worst = 0;
            for (const Spring& spring : last) {
                const double length = (s.position.at(spring.a) - s.position.at(spring.b)).norm();
                worst = std::max(worst, length / solver.sheet().restLengthOf(spring));
            }
            return worst;
        };
        double before = 0;
        double after = 0;
        const PhaseObserver observer = [&](Phase phase, const ClothState& s) {
            if (phase == Phase::Colliders)
                before = worstStrain(s);
            if (phase == Phase::StrainLimit)
                after = worstStrain(s);
        };
        solver.step(state, &observer);
        QVERIFY2(!last.empty() && before > 1.2, qPrintable(QString("seed %1").arg(seed)));
        QVERIFY2(after <= 1.1 * (1 + 1e-14),
                 qPrintable(QString("seed %1: %2").arg(seed).arg(after, 0, 'g', 17)));
    }
}

// Step after step the excess wanders towards the pins, until no spring is too long.
void TestStrainLimit::chainFromAPinIsLimitedAllAlong() {
    Scene scene = stillScene(2, 6, kStructural);
    scene.cloth.pinned = {{0, 0}, {1, 0}};
    VerletSolver solver(scene);
    ClothState state = solver.start();
    for (int i = 0; i < int(state.size()); ++i)
        place(state, i, Vec3(i % 2, 1, 1.5 * (i / 2)));
    for (int n = 0; n < 2000; ++n) {
        solver.step(state);
        state.lastPosition = state.position;
    }
    for (int y = 1; y < 6; ++y)
        QVERIFY(state.position.at(2 * y).z() - state.position.at(2 * y - 2).z() < 1.1 + 1e-9);
    QCOMPARE(state.position.at(0), Vec3(0, 1, 0));
}

void TestStrainLimit::pointsAtOnePlaceStayThere() {
    VerletSolver solver(stillScene(4, 4, kAll));
    ClothState state = solver.start();
    for (int i = 0; i < int(state.size()); ++i)
        place(state, i, Vec3(0.25, 1, 0.5));
    const ClothState before = state;
    QCOMPARE(solver.step(state).strainLimitCorrections, 0);
    QCOMPARE(state, before);
}

QTEST_APPLESS_MAIN(TestStrainLimit)
#include "tst_strain_limit.moc"
