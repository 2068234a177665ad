// The solver on several threads. Also run under ThreadSanitizer, so sheets are small and runs are short;
// whether all bits are the same is the business of tests/property/tst_same_bits.cpp.
#include "simcore/solver/verlet_solver.h"
#include "tests/support/states.h"

#include <QtTest>

#include <optional>
#include <set>

#include <thread>

using namespace clothlab;

namespace {

// As in scenes/selfCollision.json, but on its way into itself and onto the plane.
double thickness = 0; // of the sheets of the test at hand

Scene crowdedScene() {
    Scene scene;
    scene.cloth.numWidthPoints = 20;
    scene.cloth.numHeightPoints = 20;
    scene.cloth.orientation = Orientation::Vertical;
    scene.cloth.thickness = thickness;
    scene.spheres.push_back({Vec3(0.2, 0.5, 0), 0.15, 0.3, {}});
    scene.planes.push_back({Vec3(0, 0.02, 0), Vec3(0, 1, 0), 0.5, {}});
    return scene;
}

ClothState crowdedStart(const Scene& scene) {
    ClothState state = startState(scene);
    foldSheet(scene, state, 0.03);
    throwSheet(scene, state, [](int, const Vec3& p) { return Vec3(p.y(), -2, 0.5 * p.x()); });
    return state;
}

SolverSettings onThreads(int threads) {
    return {threads, 1};
}

std::uint64_t hashAfter(VerletSolver& solver, int steps) {
    const std::atomic<bool> stop = false;
    ClothState state = crowdedStart(solver.scene());
    const RunResult result = solver.run(state, steps, stop);
    return result.steps == steps ? stateHash(state) : 0;
}

std::uint64_t hashAfter(int threads, int steps) {
    VerletSolver solver(crowdedScene(), onThreads(threads));
    return hashAfter(solver, steps);
}

} // namespace

class TestThreads : public QObject {
    Q_OBJECT

private slots:
    void initTestCase_data();
    void init();

    void asManyAsAreAskedFor();
    void theSameOnThreeAsOnOne();
    void theSameWhereEveryStepIsARun();
    void theSameWhileEdited();
    void theSameWhenItBlowsUp();
    void stopsForAnotherThread();
    void endsRightAfterARun();
    void twoSolversAtOnce();
};

void TestThreads::initTestCase_data() {
    QTest::addColumn<double>("thickness");
    QTest::newRow("with self-collision") << 0.02;
    QTest::newRow("without") << 0.0;
}

void TestThreads::init() {
    QFETCH_GLOBAL(const double, thickness);
    ::thickness = thickness;
}

void TestThreads::asManyAsAreAskedFor() {
    const Scene scene = crowdedScene();
    QCOMPARE(VerletSolver(scene, onThreads(3)).threads(), 3);
    QCOMPARE(VerletSolver(scene, onThreads(64)).threads(), 20); // one a row
    QCOMPARE(VerletSolver(scene, {8, 100}).threads(), 4);       // 100 points each
    QCOMPARE(VerletSolver(scene).threads(), 1);                 // not worth two
}

void TestThreads::theSameOnThreeAsOnOne() {
    const std::uint64_t expected = hashAfter(1, 100);
    QVERIFY(expected != 0);
    QCOMPARE(hashAfter(3, 100), expected);
}

void TestThreads::theSameWhereEveryStepIsARun() {
    VerletSolver solver(crowdedScene(), onThreads(3));
    ClothState state = crowdedStart(solver.scene());
    const PhaseObserver observer = [](Phase, const ClothState&) {};
    for (int n = 0; n < 30; ++n)
        QVERIFY(!solver.step(state, n % 2 == 0 ? &observer : nullptr).blowUp);
    QCOMPARE(stateHash(state), hashAfter(1, 30));
}

void TestThreads::theSameWhileEdited() {
    std::array<std::uint64_t, 2> hashes{};
    for (const int threads : {1, 3}) {
        Scene scene = crowdedScene();
        VerletSolver solver(scene, onThreads(threads));
        ClothState state = crowdedStart(scene);
        for (const double thickness : {0.0, 0.015, 0.02}) {
            scene.cloth.thickness = thickness;
            scene.cloth.enableShearing = !scene.cloth.enableShearing;
            scene.cloth.pinned.push_back({int(scene.cloth.pinned.size()), 7});
            solver.setScene(scene);
            for (int n = 0; n < 20; ++n)
                QVERIFY(!solver.step(state).blowUp);
        }
        hashes[threads == 1 ? 0 : 1] = stateHash(state);
    }
    QCOMPARE(hashes[1], hashes[0]);
}

void TestThreads::theSameWhenItBlowsUp() {
    std::set<int> lengths; // of the runs before they blow up
    for (const double ks : {3e8, 1e9, 1e11, 1e13}) {
        Scene scene = crowdedScene();
        scene.cloth.ks = ks;
        const ClothState start = crowdedStart(scene);
        std::optional<RunResult> expected;
        for (const int threads : {1, 2, 3, 5}) {
            const std::atomic<bool> stop = false;
            VerletSolver solver(scene, onThreads(threads));
            ClothState state = start;
            const RunResult result = solver.run(state, 1000, stop);
            QVERIFY(result.blowUp);
            QCOMPARE(state, start);
            if (!expected)
                expected = result;
            QCOMPARE(result.steps, expected->steps);
            QCOMPARE(result.blowUp->phase, expected->blowUp->phase);
            QCOMPARE(result.blowUp->point, expected->blowUp->point);
        }
        lengths.insert(expected->steps);
    }
    QVERIFY(lengths.size() > 1);
}

void TestThreads::stopsForAnotherThread() {
    std::atomic<bool> stop = false;
    VerletSolver solver(crowdedScene(), onThreads(3));
    ClothState state = crowdedStart(solver.scene());
    std::thread other([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(30));
        stop = true;
    });
    const RunResult result = solver.run(state, 1'000'000'000, stop);
    other.join();
    QVERIFY(!result.blowUp);
    QCOMPARE(stateHash(state), hashAfter(1, result.steps));
}

void TestThreads::endsRightAfterARun() {
    const std::uint64_t expected = hashAfter(1, 2);
    for (int n = 0; n < 30; ++n)
        QCOMPARE(hashAfter(2 + n % 3, 2), expected);
    for (int n = 0; n < 30; ++n)
        const VerletSolver unused(crowdedScene(), onThreads(2 + n % 3));
}

// Whatever they share would be a race.
void TestThreads::twoSolversAtOnce() {
    std::array<std::uint64_t, 2> hashes{};
    std::thread other([&] { hashes[0] = hashAfter(2, 60); });
    hashes[1] = hashAfter(3, 60);
    other.join();
    const std::uint64_t expected = hashAfter(1, 60);
    QCOMPARE(hashes[0], expected);
    QCOMPARE(hashes[1], expected);
}

QTEST_APPLESS_MAIN(TestThreads)
#include "tst_threads.moc"
