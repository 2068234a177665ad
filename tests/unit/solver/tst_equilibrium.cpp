// Where cloth comes to rest: the elastic catenary, and Hooke's law row by row.
#include "simcore/inspect/inspect.h"
#include "simcore/solver/verlet_solver.h"

#include <QtTest>

#include <cmath>

using namespace clothlab;

namespace {

Scene settlingScene(int nx, int ny) {
    Scene scene;
    scene.cloth.numWidthPoints = nx;
    scene.cloth.numHeightPoints = ny;
    scene.cloth.enableShearing = scene.cloth.enableBending = false;
    scene.cloth.thickness = 0;
    scene.cloth.damping = 1;
    scene.cloth.density = 10;
    scene.simulation.framesPerSecond = 50;
    scene.simulation.stepsPerFrame = 20;
    return scene;
}

double mass(const Cloth& c) {
    return c.width * c.height * c.density / (c.numWidthPoints * c.numHeightPoints);
}

// Steps until nothing moves faster than a nanometre a second.
void settle(VerletSolver& solver, ClothState& state) {
    for (int n = 0; n < 200000; ++n) {
        const StepResult result = solver.step(state);
        if (n < 1000 || n % 100 != 0)
            continue;
        QCOMPARE(result.strainLimitCorrections, 0);
        if (kineticEnergy(solver.scene(), state) < 1e-20)
            return;
    }
    QFAIL("does not settle");
}

// Links of a chain with the horizontal tension H: link i carries H across and the weight of the points
// between it and the middle, and is as long as Hooke makes it.
struct Chain {
    int links = 0;
    double restLength = 0;  // m
    double stiffness = 0;   // N/m
    double pointWeight = 0; // N

    Vec3 link(int i, double tension) const {
        const double vertical = (i - (links - 1) / 2.0) * pointWeight;
        const double pull = std::hypot(tension, vertical);
        const double length = restLength + pull / stiffness;
        return {length * tension / pull, length * vertical / pull, 0};
    }
    double span(double tension) const {
        double sum = 0;
        for (int i = 0; i < links; ++i)
            sum += link(i, tension).x();
        return sum;
    }
    double tensionFor(double width) const {
        double low = 0;
        double high = 1e6;
        for (int n = 0; n < 200; ++n) {
            const double middle = (low + high) / 2;
            (span(middle) < width ? low : high) = middle;
        }
        return low;
    }
};

} // namespace

class TestEquilibrium : public QObject {
    Q_OBJECT

private slots:
    void chainHangsAsACatenary_data();
    void chainHangsAsACatenary();
    void stripFollowsHooke_data();
    void stripFollowsHooke();
    void verticalStripFollowsHooke();
    void sagDependsOnStiffnessOverDensity();
};

void TestEquilibrium::chainHangsAsACatenary_data() {
    QTest::addColumn<int>("points");
    QTest::addColumn<double>("slack");
    QTest::newRow("20 links, much slack") << 21 << 0.3;
    QTest::newRow("20 links, little slack") << 21 << 0.05;
    QTest::newRow("11 links, none in the middle") << 12 << 0.2;
}

// A sheet of two rows, pinned at its corners: each row is a chain of its own, the springs between stay at
// rest.
void TestEquilibrium::chainHangsAsACatenary() {
    QFETCH(int, points);
    QFETCH(double, slack);
    Scene scene = settlingScene(points, 2);
    const int last = points - 1;
    scene.cloth.pinned = {{0, 0}, {last, 0}, {0, 1}, {last, 1}};
    scene.cloth.ks = 20000;
    VerletSolver solver(scene);
    ClothState state = solver.start();
    const double width = scene.cloth.width * (1 - slack);
    for (int i = 0; i < int(state.size()); ++i) {
        const double share = state.position.x[std::size_t(i)];
        state.position.x[std::size_t(i)] = share * width;
        state.position.y[std::size_t(i)] -= 1.5 * std::sqrt(slack) * share * (1 - share);
    }
    state.lastPosition = state.position;
    settle(solver, state);

    const Chain chain{last, scene.cloth.width / last, scene.cloth.ks, mass(scene.cloth) * 9.8};
    const double tension = chain.tensionFor(width);
    Vec3 expected(0, 1, 0);
    double sag = 0;
    double worst = 0;
    for (int x = 0; x < points; ++x) {
        for (int row = 0; row < 2; ++row) {
            const Vec3 at(expected.x(), expected.y(), row * scene.cloth.height);
            worst = std::max(worst, (state.position.at(row * points + x) - at).norm());
        }
        sag = std::max(sag, 1 - expected.y());
        if (x < last)
            expected += chain.link(x, tension);
    }
    QVERIFY(std::abs(expected.x() - width) < 1e-12);
    qInfo("sag %g m, off by %g of it", sag, worst / sag);
    QVERIFY(sag > 0.05);
    QVERIFY(worst < 1e-3 * sag);
}

void TestEquilibrium::stripFollowsHooke_data() {
    QTest::addColumn<Vec3>("gravity");
    QTest::newRow("along the rows' normal") << Vec3(0, 0, 9.8);
    QTest::newRow("weak") << Vec3(0, 0, 1.6);
}

// A flat sheet hanging by its first row along its own plane, so that nothing disturbs the columns.
void TestEquilibrium::stripFollowsHooke() {
    QFETCH(Vec3, gravity);
    Scene scene = settlingScene(3, 12);
    scene.cloth.width = 0.2;
    scene.cloth.pinned = {{0, 0}, {1, 0}, {2, 0}};
    scene.cloth.ks = 5000;
    scene.simulation.gravity = gravity;
    VerletSolver solver(scene);
    ClothState state = solver.start();
    settle(solver, state);
    const double rest = scene.cloth.height / 11;
    double worst = 0;
    for (int y = 1; y < 12; ++y) {
        const double expected = (12 - y) * mass(scene.cloth) * gravity.z() / scene.cloth.ks;
        for (int x = 0; x < 3; ++x) {
            const double length = (state.position.at(y * 3 + x) - state.position.at((y - 1) * 3 + x)).norm();
            worst = std::max(worst, std::abs((length - rest) / expected - 1));
        }
    }
    qInfo("relative error %g", worst);
    QVERIFY(worst < 1e-6);
}

// The vertical sheet as it starts is uneven, so its columns pull at each other a little.
void TestEquilibrium::verticalStripFollowsHooke() {
    Scene scene = settlingScene(2, 12);
    scene.cloth.orientation = Orientation::Vertical;
    scene.cloth.pinned = {{0, 11}, {1, 11}};
    scene.cloth.ks = 5000;
    VerletSolver solver(scene);
    ClothState state = solver.start();
    settle(solver, state);
    double worst = 0;
    for (int y = 1; y < 12; ++y) {
        const double expected = y * mass(scene.cloth) * 9.8 / scene.cloth.ks;
        for (int x = 0; x < 2; ++x) {
            const int a = solver.sheet().grid.index(x, y);
            const int number = solver.sheet().grid.springNumber(1, a);
            const SpringMeasure m = measureSpring(scene.cloth, solver.sheet(), state.position,
                                                  solver.sheet().grid.spring(number));
            worst = std::max(worst, std::abs((m.length - m.restLength) / expected - 1));
        }
    }
    qInfo("relative error %g", worst);
    QVERIFY(worst < 1e-6);
}

void TestEquilibrium::sagDependsOnStiffnessOverDensity() {
    std::vector<ClothState> settled;
    for (const double scale : {1.0, 3.0}) {
        Scene scene = settlingScene(9, 7);
        scene.cloth.enableShearing = scene.cloth.enableBending = true;
        scene.cloth.pinned = {{0, 0}, {8, 0}, {0, 6}, {8, 6}};
        scene.cloth.ks = 5000 * scale;
        scene.cloth.density = 20 * scale;
        VerletSolver solver(scene);
        settled.push_back(solver.start());
        settle(solver, settled.back());
    }
    double worst = 0;
    double sag = 0;
    for (int i = 0; i < int(settled[0].size()); ++i) {
        worst = std::max(worst, (settled[0].position.at(i) - settled[1].position.at(i)).norm());
        sag = std::max(sag, 1 - settled[0].position.y[std::size_t(i)]);
    }
    QVERIFY(sag > 0.01);
    QVERIFY(worst < 1e-8);
}

QTEST_APPLESS_MAIN(TestEquilibrium)
#include "tst_equilibrium.moc"
