// What the solver does with its inputs: phases, pins, forces, parameters of a running sheet, repeatability.
#include "simcore/solver/verlet_solver.h"
#include "tests/support/random_run.h"
#include "tests/support/states.h"

#include <QtTest>

using namespace clothlab;

namespace {

Scene smallScene() {
    Scene scene;
    scene.cloth.numWidthPoints = 9;
    scene.cloth.numHeightPoints = 6;
    scene.cloth.width = 0.8;
    scene.cloth.height = 0.5;
    return scene;
}

ClothState after(VerletSolver& solver, ClothState state, int steps) {
    for (int n = 0; n < steps; ++n)
        solver.step(state);
    return state;
}

} // namespace

class TestStep : public QObject {
    Q_OBJECT

private slots:
    void numbersOfTheModel();
    void phasesComeInOrder();
    void watchingChangesNothing();
    void pinnedPointsNeverMove();
    void lastPositionIsTheOneBefore();
    void forceOfOneStretchedSpring();
    void forcesCancelExceptTheWeight();
    void forcesAreClearedEachTime();
    void forcesOfSwitchedOffTypes();
    void sameSceneSameBits();
    void solverKeepsNothingOfAState();
    void newParametersActOnARunningSheet();
};

void TestStep::numbersOfTheModel() {
    const VerletSolver solver{Scene{}};
    QCOMPARE(solver.scene().simulation.timeStep(), 1.0 / 2700);
    QVERIFY(std::abs(solver.pointMass() - 150.0 / 2500) < 1e-17);
    Scene scene = smallScene();
    scene.cloth.density = 90;
    QVERIFY(std::abs(VerletSolver(scene).pointMass() - 0.8 * 0.5 * 90 / 54) < 1e-15);
}

void TestStep::phasesComeInOrder() {
    Scene scene = smallScene();
    for (const double thickness : {0.01, 0.0}) {
        scene.cloth.thickness = thickness;
        VerletSolver solver(scene);
        ClothState state = solver.start();
        std::vector<Phase> seen;
        const PhaseObserver observer = [&](Phase phase, const ClothState&) { seen.push_back(phase); };
        solver.step(state, &observer);
        const std::vector<Phase> expected{Phase::Forces, Phase::Verlet, Phase::SelfCollision,
                                          Phase::Colliders, Phase::StrainLimit};
        QVERIFY(seen == expected);
    }
}

void TestStep::watchingChangesNothing() {
    const RandomRun made = randomRun(3);
    VerletSolver watched(made.scene);
    VerletSolver unwatched(made.scene);
    ClothState state = made.start;
    const PhaseObserver observer = [](Phase, const ClothState&) {};
    for (int n = 0; n < 50; ++n)
        watched.step(state, &observer);
    QCOMPARE(state, after(unwatched, made.start, 50));
}

// Thrown, folded, in a sphere, through a plane, torn at: nothing moves a pin.
void TestStep::pinnedPointsNeverMove() {
    Scene scene = smallScene();
    scene.cloth.thickness = 0.03;
    scene.cloth.pinned = {{0, 0}, {4, 3}, {8, 5}, {8, 0}};
    scene.spheres.push_back({Vec3(0, 1, 0), 0.2, 0.1, {}});
    scene.planes.push_back({Vec3(0, 1, 0), Vec3(0.1, 1, 0), 0.1, {}});
    VerletSolver solver(scene);
    ClothState state = solver.start();
    foldSheet(scene, state, 0.02);
    const ClothState start = state;
    throwSheet(scene, state, Vec3(1, -5, 2));
    state = after(solver, state, 100);
    for (const GridPoint& pin : scene.cloth.pinned) {
        const int i = solver.sheet().grid.index(pin);
        QCOMPARE(state.position.at(i), start.position.at(i));
    }
}

void TestStep::lastPositionIsTheOneBefore() {
    const RandomRun made = randomRun(8);
    VerletSolver solver(made.scene);
    ClothState state = made.start;
    for (int n = 0; n < 20; ++n) {
        const PointArray before = state.position;
        solver.step(state);
        QCOMPARE(state.lastPosition, before);
    }
}

// Point (0, 0) drawn out along its only spring: the diagonal of a square, then two columns to the right.
void TestStep::forceOfOneStretchedSpring() {
    Scene scene;
    scene.cloth.numWidthPoints = scene.cloth.numHeightPoints = 2;
    scene.cloth.enableStructural = false;
    scene.cloth.enableBending = false;
    scene.simulation.gravity = Vec3(0, 0, 0);
    VerletSolver solver(scene);
    PointArray position = solver.start().position;
    position.set(0, Vec3(-0.3, 1, -0.3));
    PointArray force(4);
    solver.forces(position, force);
    const Vec3 expected = 5000 * 0.3 * Vec3(1, 0, 1); // stiffness times stretch, towards (1, 1)
    QVERIFY((force.at(0) - expected).norm() < 1e-9);
    QVERIFY((force.at(3) + expected).norm() < 1e-9);
    QCOMPARE(force.at(1), Vec3(0, 0, 0));

    scene.cloth.enableShearing = false;
    scene.cloth.enableBending = true;
    scene.cloth.numWidthPoints = 3;
    VerletSolver bending(scene);
    position = bending.start().position;
    position.set(0, Vec3(-0.3, 1, 0));
    force = PointArray(6);
    bending.forces(position, force);
    QVERIFY((force.at(0) - Vec3(0.2 * 5000 * 0.3, 0, 0)).norm() < 1e-9);
    QCOMPARE(force.at(1), Vec3(0, 0, 0));
}

void TestStep::forcesCancelExceptTheWeight() {
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
        const RandomRun made = randomRun(seed);
        VerletSolver solver(made.scene);
        PointArray position = made.start.position;
        for (int i = 0; i < int(position.size()); ++i)
            position.set(i, position.at(i) + 0.01 * Vec3(i % 3, i % 5, i % 7));
        PointArray force(position.size());
        solver.forces(position, force);
        Vec3 sum(0, 0, 0);
        double size = 0;
        for (int i = 0; i < int(force.size()); ++i) {
            sum += force.at(i);
            size += force.at(i).norm();
        }
        const Cloth& cloth = made.scene.cloth;
        const Vec3 weight = cloth.width * cloth.height * cloth.density * made.scene.simulation.gravity;
        QVERIFY2((sum - weight).norm() < 1e-12 * size, made.describe().c_str());
    }
}

void TestStep::forcesAreClearedEachTime() {
    const RandomRun made = randomRun(4);
    VerletSolver solver(made.scene);
    PointArray first(made.start.size());
    PointArray second(made.start.size());
    second.set(1, Vec3(1e9, -1e9, 7));
    solver.forces(made.start.position, first);
    solver.forces(made.start.position, second);
    QCOMPARE(first, second);
}

void TestStep::forcesOfSwitchedOffTypes() {
    Scene scene = smallScene();
    scene.cloth.enableStructural = scene.cloth.enableShearing = scene.cloth.enableBending = false;
    VerletSolver solver(scene);
    PointArray position = solver.start().position;
    for (int i = 0; i < int(position.size()); ++i)
        position.set(i, position.at(i) * (1 + 0.1 * i));
    PointArray force(position.size());
    solver.forces(position, force);
    for (int i = 0; i < int(force.size()); ++i)
        QVERIFY((force.at(i) - solver.pointMass() * Vec3(0, -9.8, 0)).norm() < 1e-14);
}

void TestStep::sameSceneSameBits() {
    const RandomRun made = randomRun(13);
    VerletSolver one(made.scene);
    VerletSolver other(made.scene);
    const ClothState a = after(one, made.start, 100);
    const ClothState b = after(other, made.start, 100);
    QCOMPARE(stateHash(a), stateHash(b));
    QCOMPARE(a, b);
}

void TestStep::solverKeepsNothingOfAState() {
    const RandomRun made = randomRun(3);
    VerletSolver used(made.scene);
    ClothState other = used.start();
    throwSheet(made.scene, other, Vec3(0, -3, 1));
    after(used, other, 40);
    VerletSolver fresh(made.scene);
    QCOMPARE(after(used, made.start, 40), after(fresh, made.start, 40));
}

void TestStep::newParametersActOnARunningSheet() {
    Scene before = smallScene();
    before.cloth.pinned = {{0, 0}};
    Scene changed = before;
    changed.cloth.ks = 9000;
    changed.cloth.density = 100;
    changed.cloth.damping = 1;
    changed.cloth.thickness = 0.02;
    changed.cloth.enableShearing = false;
    changed.simulation.gravity = Vec3(1, -5, 0);
    changed.spheres.push_back({Vec3(0.4, 0.9, 0.2), 0.1, 0.3, {}});
    changed.planes.push_back({Vec3(0, 0.9, 0), Vec3(0, 1, 0), 0.3, {}});
    VerletSolver running(before);
    const ClothState middle = after(running, running.start(), 60);
    running.setScene(changed);
    VerletSolver fresh(changed);
    const ClothState expected = after(fresh, middle, 60);
    QCOMPARE(after(running, middle, 60), expected);
    VerletSolver unchanged(before);
    QVERIFY(!(after(unchanged, middle, 60) == expected));
}

QTEST_APPLESS_MAIN(TestStep)
#include "tst_step.moc"
