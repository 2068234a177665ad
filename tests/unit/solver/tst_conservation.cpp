// What a sheet without outer influence keeps, and how it falls.
#include "simcore/inspect/inspect.h"
#include "simcore/solver/verlet_solver.h"
#include "tests/support/random.h"
#include "tests/support/states.h"

#include <QtTest>

#include <cmath>

using namespace clothlab;

namespace {

Scene freeSheet() {
    Scene scene;
    scene.cloth.numWidthPoints = 15;
    scene.cloth.numHeightPoints = 11;
    scene.cloth.damping = 0;
    scene.cloth.thickness = 0;
    scene.cloth.ks = 2000;
    return scene;
}

// Tumbling, waving, and with no spring near its limit.
ClothState tumbling(const Scene& scene) {
    ClothState state = startState(scene);
    throwSheet(scene, state, [](int, const Vec3& p) {
        const Vec3 centre(0.5, 1, 0.5);
        const Vec3 spin = Vec3(0.7, -0.4, 1.1).cross(p - centre);
        return Vec3(Vec3(1, 2, -0.5) + spin + Vec3(0, 0.15 * std::sin(7 * p.x()) * std::cos(5 * p.z()), 0));
    });
    return state;
}

struct Momentum {
    Vec3 linear{0, 0, 0};  // kg m/s
    Vec3 angular{0, 0, 0}; // kg m²/s, about the origin
    double size = 0;       // sum of the magnitudes of the points' linear momenta
};

Momentum momentum(const Scene& scene, const ClothState& state) {
    Momentum sum;
    const double mass = pointMass(scene.cloth);
    for (int i = 0; i < int(state.size()); ++i) {
        const Vec3 p = mass * velocity(state, i, scene.simulation.timeStep());
        sum.linear += p;
        sum.angular += state.position.at(i).cross(p);
        sum.size += p.norm();
    }
    return sum;
}

} // namespace

class TestConservation : public QObject {
    Q_OBJECT

private slots:
    void freeFall_data();
    void freeFall();
    void freeFallWithDamping();
    void fallsAlongTheSceneGravity();
    void keepsMomentum_data();
    void keepsMomentum();
    void energyErrorFallsWithTheStepSquared();
    void restStaysAtRest();
    void startVelocityLosesItsShareEachStep();
};

void TestConservation::freeFall_data() {
    QTest::addColumn<bool>("springs");
    QTest::newRow("without springs") << false;
    QTest::newRow("with springs") << true;
}

void TestConservation::freeFall() {
    QFETCH(bool, springs);
    Scene scene = freeSheet();
    scene.cloth.enableStructural = scene.cloth.enableShearing = scene.cloth.enableBending = springs;
    VerletSolver solver(scene);
    ClothState state = solver.start();
    const ClothState start = state;
    const double dt = scene.simulation.timeStep();
    for (int n = 1; n <= 1000; ++n) {
        solver.step(state);
        const Vec3 fallen(0, -9.8 * dt * dt * n * (n + 1) / 2, 0);
        double worst = 0;
        for (int i = 0; i < int(state.size()); ++i)
            worst = std::max(worst, (state.position.at(i) - start.position.at(i) - fallen).norm());
        // Half a unit in the last place each step is a velocity that stays.
        const double rounding = 1.2e-16 * n * (n + 1) / 2;
        QVERIFY2(worst < std::max(rounding, 1e-15), qPrintable(QString("step %1: %2").arg(n).arg(worst)));
        QVERIFY(n > 100 || worst < 1e-12);
        if (n == 100 || n == 1000)
            qInfo("%g m off after %d steps", worst, n);
    }
}

// The velocity v, in metres a step, follows v' = q v + g dt²: a geometric sum.
void TestConservation::freeFallWithDamping() {
    Scene scene = freeSheet();
    scene.cloth.damping = 0.2;
    VerletSolver solver(scene);
    ClothState state = solver.start();
    const double dt = scene.simulation.timeStep();
    double velocity = 0;
    double height = 1;
    for (int n = 0; n < 500; ++n) {
        solver.step(state);
        velocity = 0.998 * velocity - 9.8 * dt * dt;
        height += velocity;
    }
    const double q = 0.998;
    const double closed = 1 - 9.8 * dt * dt / (1 - q) * (500 - q * (1 - std::pow(q, 500)) / (1 - q));
    QVERIFY(std::abs(height - closed) < 1e-12);
    QVERIFY(std::abs(state.position.y[7] - closed) < 1e-11);
}

void TestConservation::fallsAlongTheSceneGravity() {
    Scene scene = freeSheet();
    scene.simulation.gravity = Vec3(3, -4, 5);
    VerletSolver solver(scene);
    ClothState state = solver.start();
    const Vec3 start = state.position.at(20);
    for (int n = 0; n < 100; ++n)
        solver.step(state);
    const double dt = scene.simulation.timeStep();
    const Vec3 fallen = Vec3(3, -4, 5) * dt * dt * 5050;
    QVERIFY((state.position.at(20) - start - fallen).norm() < 1e-12);
}

void TestConservation::keepsMomentum_data() {
    QTest::addColumn<int>("types"); // a bit each
    QTest::newRow("structural") << 1;
    QTest::newRow("shearing") << 2;
    QTest::newRow("bending") << 4;
    QTest::newRow("all") << 7;
}

void TestConservation::keepsMomentum() {
    QFETCH(int, types);
    Scene scene = freeSheet();
    scene.simulation.gravity = Vec3(0, 0, 0);
    scene.cloth.enableStructural = (types & 1) != 0;
    scene.cloth.enableShearing = (types & 2) != 0;
    scene.cloth.enableBending = (types & 4) != 0;
    VerletSolver solver(scene);
    ClothState state = tumbling(scene);
    const Momentum before = momentum(scene, state);
    double linear = 0;
    double angular = 0;
    for (int n = 0; n < 1000; ++n) {
        QCOMPARE(solver.step(state).strainLimitCorrections, 0);
        const Momentum now = momentum(scene, state);
        linear = std::max(linear, (now.linear - before.linear).norm() / before.size);
        angular = std::max(angular, (now.angular - before.angular).norm() / before.size);
    }
    qInfo("drift: linear %g, angular %g", linear, angular);
    QVERIFY(linear < 1e-11);
    QVERIFY(angular < 1e-11);
    QVERIFY(potentialEnergy(scene, solver.sheet(), state.position) > 1e-3); // the springs did something
}

void TestConservation::energyErrorFallsWithTheStepSquared() {
    double before = 0;
    for (const int refinement : {1, 2, 4}) {
        Scene scene = freeSheet();
        scene.simulation.stepsPerFrame = 20 * refinement;
        VerletSolver solver(scene);
        ClothState state = tumbling(scene);
        const double dt = scene.simulation.timeStep();
        double energy = 0;
        double error = 0;
        for (int n = 0; n < 500 * refinement; ++n) {
            const ClothState old = state;
            QCOMPARE(solver.step(state).strainLimitCorrections, 0);
            double now = potentialEnergy(scene, solver.sheet(), old.position);
            for (int i = 0; i < int(state.size()); ++i) {
                const Vec3 v = (state.position.at(i) - old.lastPosition.at(i)) / (2 * dt);
                now += 0.5 * pointMass(scene.cloth) * v.squaredNorm();
            }
            energy = n == 0 ? now : energy;
            error = std::max(error, std::abs(now - energy));
        }
        qInfo("%d steps per frame: %g J off", scene.simulation.stepsPerFrame, error);
        if (refinement > 1)
            QVERIFY2(before / error > 3.7 && before / error < 4.3,
                     qPrintable(QString::number(before / error)));
        before = error;
    }
}

void TestConservation::restStaysAtRest() {
    Scene scene = freeSheet();
    scene.cloth.orientation = Orientation::Vertical;
    scene.simulation.gravity = Vec3(0, 0, 0);
    VerletSolver solver(scene);
    ClothState state = solver.start();
    for (int n = 0; n < 200; ++n)
        solver.step(state);
    QCOMPARE(state, solver.start());
}

void TestConservation::startVelocityLosesItsShareEachStep() {
    Scene scene = freeSheet();
    scene.simulation.gravity = Vec3(0, 0, 0);
    scene.cloth.damping = 1;
    VerletSolver solver(scene);
    ClothState state = solver.start();
    throwSheet(scene, state, Vec3(0, 3, 0));
    for (int n = 0; n < 100; ++n)
        solver.step(state);
    const Vec3 v = velocity(state, 12, scene.simulation.timeStep());
    QVERIFY((v - Vec3(0, 3 * std::pow(0.99, 100), 0)).norm() < 1e-9);
}

QTEST_APPLESS_MAIN(TestConservation)
#include "tst_conservation.moc"
