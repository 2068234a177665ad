// One point on one spring against the closed form, discrete and continuous.
#include "simcore/inspect/inspect.h"
#include "simcore/solver/verlet_solver.h"

#include <QtTest>

#include <cmath>
#include <numbers>

using namespace clothlab;

namespace {

// A sheet of which only the points in `moving` are free, each on a single spring along `axis`.
struct Oscillator {
    Scene scene;
    std::vector<int> moving;
    Vec3 axis{1, 0, 0};
    double stiffness = 0; // N/m

    double mass() const {
        const Cloth& c = scene.cloth;
        return c.width * c.height * c.density / (c.numWidthPoints * c.numHeightPoints);
    }
    double frequency() const { return std::sqrt(stiffness / mass()); } // rad/s
    // Of the Verlet scheme: the second difference of cos(w t) is -4 sin²(w dt / 2) cos(w t).
    double discreteFrequency() const {
        const double dt = scene.simulation.timeStep();
        return 2 / dt * std::asin(frequency() * dt / 2);
    }
};

Scene quietScene(int nx, int ny) {
    Scene scene;
    scene.cloth.numWidthPoints = nx;
    scene.cloth.numHeightPoints = ny;
    scene.cloth.width = 0.8;
    scene.cloth.height = 0.6;
    scene.cloth.damping = 0;
    scene.cloth.thickness = 0;
    scene.cloth.enableStructural = scene.cloth.enableShearing = scene.cloth.enableBending = false;
    scene.simulation.gravity = Vec3(0, 0, 0);
    scene.simulation.framesPerSecond = 50;
    scene.simulation.stepsPerFrame = 20;
    return scene;
}

Oscillator makeOscillator(SpringType type) {
    Oscillator o;
    switch (type) {
    case SpringType::Structural:
        // Both points of a row move alike, so that the spring between them stays at rest.
        o.scene = quietScene(2, 2);
        o.scene.cloth.enableStructural = true;
        o.scene.cloth.pinned = {{0, 0}, {1, 0}};
        o.moving = {2, 3};
        o.axis = Vec3(0, 0, 1);
        break;
    case SpringType::Shearing:
        o.scene = quietScene(2, 2);
        o.scene.cloth.enableShearing = true;
        o.scene.cloth.pinned = {{1, 0}, {0, 1}, {1, 1}};
        o.moving = {0};
        o.axis = Vec3(0.8, 0, 0.6);
        break;
    case SpringType::Bending:
        o.scene = quietScene(3, 2);
        o.scene.cloth.enableBending = true;
        o.scene.cloth.pinned = {{1, 0}, {2, 0}, {0, 1}, {1, 1}, {2, 1}};
        o.moving = {0};
        break;
    }
    // About 40 steps a period.
    o.scene.cloth.ks = o.mass() * 157 * 157;
    o.stiffness = type == SpringType::Bending ? 0.2 * o.scene.cloth.ks : o.scene.cloth.ks;
    return o;
}

constexpr double kAmplitude = 0.03; // m; below a tenth of every spring's length

// Displacements along the axis, step by step, from rest at the amplitude: the state lies on the crest of
// the discrete cosine.
std::vector<double> run(const Oscillator& o, int steps) {
    VerletSolver solver(o.scene);
    ClothState state = solver.start();
    const ClothState rest = state;
    const double dt = o.scene.simulation.timeStep();
    for (const int i : o.moving) {
        state.position.set(i, rest.position.at(i) + kAmplitude * o.axis);
        const double before = kAmplitude * std::cos(o.discreteFrequency() * dt);
        state.lastPosition.set(i, rest.position.at(i) + before * o.axis);
    }
    std::vector<double> displacement{kAmplitude};
    for (int n = 0; n < steps; ++n) {
        solver.step(state);
        const int i = o.moving.front();
        displacement.push_back((state.position.at(i) - rest.position.at(i)).dot(o.axis));
    }
    return displacement;
}

// From the first falling zero to the last, in steps; where between two steps is exact for a cosine.
double measuredPeriod(const std::vector<double>& displacement) {
    std::vector<double> zeros;
    for (std::size_t n = 0; n + 1 < displacement.size(); ++n) {
        if (displacement[n] > 0 && displacement[n + 1] <= 0) {
            const double before = std::asin(displacement[n] / kAmplitude);
            const double after = std::asin(-displacement[n + 1] / kAmplitude);
            zeros.push_back(double(n) + before / (before + after));
        }
    }
    return (zeros.back() - zeros.front()) / double(zeros.size() - 1);
}

} // namespace

class TestOscillator : public QObject {
    Q_OBJECT

private slots:
    void followsTheDiscreteCosine_data() { types(); }
    void followsTheDiscreteCosine();
    void periodIsTheDiscreteOne_data() { types(); }
    void periodIsTheDiscreteOne();
    void periodErrorFallsWithTheStepSquared_data() { types(); }
    void periodErrorFallsWithTheStepSquared();
    void energyErrorFallsWithTheStepSquared_data() { types(); }
    void energyErrorFallsWithTheStepSquared();
    void dampingTakesAwayVelocity();

private:
    void types() {
        QTest::addColumn<SpringType>("type");
        QTest::newRow("structural") << SpringType::Structural;
        QTest::newRow("shearing") << SpringType::Shearing;
        QTest::newRow("bending") << SpringType::Bending;
    }
};

void TestOscillator::followsTheDiscreteCosine() {
    QFETCH(SpringType, type);
    const Oscillator o = makeOscillator(type);
    const std::vector<double> u = run(o, 2000);
    const double dt = o.scene.simulation.timeStep();
    double worst = 0;
    for (std::size_t n = 0; n < u.size(); ++n)
        worst =
            std::max(worst, std::abs(u[n] - kAmplitude * std::cos(o.discreteFrequency() * dt * double(n))));
    qInfo("%g m off the cosine", worst);
    QVERIFY(worst < 1e-10 * kAmplitude);
}

void TestOscillator::periodIsTheDiscreteOne() {
    QFETCH(SpringType, type);
    const Oscillator o = makeOscillator(type);
    const double period = measuredPeriod(run(o, 8000)) * o.scene.simulation.timeStep();
    const double expected = 2 * std::numbers::pi / o.discreteFrequency();
    qInfo("relative error %g", period / expected - 1);
    QVERIFY(std::abs(period / expected - 1) < 1e-9);
}

void TestOscillator::periodErrorFallsWithTheStepSquared() {
    QFETCH(SpringType, type);
    Oscillator o = makeOscillator(type);
    const double continuous = 2 * std::numbers::pi * std::sqrt(o.mass() / o.stiffness);
    double before = 0;
    for (const int refinement : {1, 2, 4, 8}) {
        o.scene.simulation.stepsPerFrame = 20 * refinement;
        const double period = measuredPeriod(run(o, 2000 * refinement)) * o.scene.simulation.timeStep();
        const double error = std::abs(period / continuous - 1);
        QVERIFY(error < 1e-2);
        if (refinement > 1)
            QVERIFY2(std::abs(before / error - 4) < 0.05, qPrintable(QString::number(before / error)));
        before = error;
    }
}

// With the velocity at the same time as the position: half the difference of the positions a step before
// and after. The state's own velocity belongs to half a step earlier.
void TestOscillator::energyErrorFallsWithTheStepSquared() {
    QFETCH(SpringType, type);
    Oscillator o = makeOscillator(type);
    const double energy = 0.5 * o.stiffness * kAmplitude * kAmplitude;
    double before = 0;
    for (const int refinement : {1, 2, 4, 8}) {
        o.scene.simulation.stepsPerFrame = 20 * refinement;
        const double dt = o.scene.simulation.timeStep();
        const std::vector<double> u = run(o, 400 * refinement);
        double error = 0;
        for (std::size_t n = 1; n + 1 < u.size(); ++n) {
            const double v = (u[n + 1] - u[n - 1]) / (2 * dt);
            const double now = 0.5 * o.mass() * v * v + 0.5 * o.stiffness * u[n] * u[n];
            error = std::max(error, std::abs(now / energy - 1));
        }
        QVERIFY(error < 1e-2);
        if (refinement > 1)
            QVERIFY2(std::abs(before / error - 4) < 0.1, qPrintable(QString::number(before / error)));
        before = error;
    }
}

// u' - u = q (u - u_before) - s u has the solutions r^n cos(n a), r^n sin(n a) with r² = q.
void TestOscillator::dampingTakesAwayVelocity() {
    Oscillator o = makeOscillator(SpringType::Bending);
    o.scene.cloth.damping = 0.5;
    const std::vector<double> u = run(o, 400);
    const double q = 1 - 0.005;
    const double dt = o.scene.simulation.timeStep();
    const double s = o.frequency() * o.frequency() * dt * dt;
    const double r = std::sqrt(q);
    const double angle = std::acos((1 + q - s) / (2 * r));
    const double sine = (u[1] / r - u[0] * std::cos(angle)) / std::sin(angle);
    for (std::size_t n = 0; n < u.size(); ++n) {
        const double phase = angle * double(n);
        const double expected = std::pow(r, double(n)) * (u[0] * std::cos(phase) + sine * std::sin(phase));
        QVERIFY(std::abs(u[n] - expected) < 1e-12);
    }
}

QTEST_APPLESS_MAIN(TestOscillator)
#include "tst_oscillator.moc"
