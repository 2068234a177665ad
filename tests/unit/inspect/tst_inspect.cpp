// Measures of a state against closed forms.
#include "simcore/inspect/inspect.h"

#include <QtTest>

#include <cmath>
#include <limits>

using namespace clothlab;

namespace {

// Points a metre apart in x and two in z.
Scene squareScene() {
    Scene scene;
    scene.cloth.numWidthPoints = 3;
    scene.cloth.numHeightPoints = 4;
    scene.cloth.width = 2;
    scene.cloth.height = 6;
    scene.cloth.density = 10; // 10 kg a point
    return scene;
}

struct Sample {
    Scene scene = squareScene();
    ClothState state = startState(scene);
    Sheet sheet{Grid{3, 4}, state.position};
};

} // namespace

class TestInspect : public QObject {
    Q_OBJECT

private slots:
    void velocityOfAPoint();
    void springAtRest();
    void stretchedAndCompressedSprings();
    void switchedOffSpringsHaveNoForce();
    void springWithoutRestLength();
    void greatestStrains();
    void greatestStrainOfACompressedSheet();
    void kineticEnergyOfAThrownSheet();
    void potentialEnergyOfHeight();
    void potentialEnergyOfSprings();
    void energyCountsOnlyWhatIsSwitchedOn();
    void finiteStates();
};

void TestInspect::velocityOfAPoint() {
    Sample s;
    s.state.lastPosition.set(5, s.state.position.at(5) - Vec3(0.5, -0.25, 1));
    QCOMPARE(velocity(s.state, 5, 0.125), Vec3(4, -2, 8));
    QCOMPARE(velocity(s.state, 4, 0.125), Vec3(0, 0, 0));
}

void TestInspect::springAtRest() {
    const Sample s;
    const double rest[] = {1, 2, std::sqrt(5), std::sqrt(5), 2, 4};
    for (int n = 0; n < s.sheet.grid.springCount(); ++n) {
        const Spring spring = s.sheet.grid.spring(n);
        const SpringMeasure m = measureSpring(s.scene.cloth, s.sheet, s.state.position, spring);
        QVERIFY(std::abs(m.length - rest[spring.stencil]) < 1e-15);
        QCOMPARE(m.restLength, m.length);
        QCOMPARE(m.strain, 0.0);
        QCOMPARE(m.force, 0.0);
    }
}

void TestInspect::stretchedAndCompressedSprings() {
    Sample s;
    for (int i = 0; i < int(s.state.size()); ++i) {
        const Vec3 p = s.state.position.at(i);
        s.state.position.set(i, Vec3(1.25 * p.x(), p.y(), 0.5 * p.z()));
    }
    const auto measure = [&](int stencil, int x, int y) {
        const Grid& grid = s.sheet.grid;
        const Spring spring = grid.spring(grid.springNumber(stencil, grid.index(x, y)));
        return measureSpring(s.scene.cloth, s.sheet, s.state.position, spring);
    };
    const SpringMeasure across = measure(0, 1, 1);
    QVERIFY(std::abs(across.strain - 0.25) < 1e-15);
    QVERIFY(std::abs(across.force - 5000 * 0.25) < 1e-11);
    const SpringMeasure down = measure(1, 1, 1);
    QVERIFY(std::abs(down.strain + 0.5) < 1e-15);
    QVERIFY(std::abs(down.force + 5000 * 1) < 1e-11);
    const SpringMeasure diagonal = measure(2, 1, 1);
    QVERIFY(std::abs(diagonal.length - std::hypot(1.25, 1)) < 1e-15);
    QVERIFY(std::abs(diagonal.force - 5000 * (std::hypot(1.25, 1) - std::sqrt(5))) < 1e-11);
    const SpringMeasure bending = measure(4, 2, 0);
    QVERIFY(std::abs(bending.strain - 0.25) < 1e-15);
    QVERIFY(std::abs(bending.force - 1000 * 0.5) < 1e-11);
}

void TestInspect::switchedOffSpringsHaveNoForce() {
    Sample s;
    s.scene.cloth.enableShearing = false;
    for (int i = 0; i < int(s.state.size()); ++i)
        s.state.position.set(i, 1.5 * s.state.position.at(i));
    for (int n = 0; n < s.sheet.grid.springCount(); ++n) {
        const Spring spring = s.sheet.grid.spring(n);
        const SpringMeasure m = measureSpring(s.scene.cloth, s.sheet, s.state.position, spring);
        QVERIFY(std::abs(m.strain - 0.5) < 1e-14);
        QCOMPARE(m.force != 0, spring.type() != SpringType::Shearing);
    }
}

void TestInspect::springWithoutRestLength() {
    Sample s;
    s.sheet.start = PointArray(s.state.size()); // all at one place
    const SpringMeasure m = measureSpring(s.scene.cloth, s.sheet, s.state.position, s.sheet.grid.spring(0));
    QCOMPARE(m.strain, 0.0);
    QCOMPARE(m.restLength, 0.0);
    QCOMPARE(m.length, 1.0);
}

void TestInspect::greatestStrains() {
    Sample s;
    QCOMPARE(maxStrain(s.sheet, s.state.position), (std::array<double, 3>{0, 0, 0}));
    s.state.position.set(0, Vec3(-0.5, 1, 0)); // the corner, half a metre to the left
    const std::array<double, 3> strain = maxStrain(s.sheet, s.state.position);
    QVERIFY(std::abs(strain[0] - 0.5) < 1e-15);
    QVERIFY(std::abs(strain[1] - (2.5 / std::sqrt(5) - 1)) < 1e-15);
    QVERIFY(std::abs(strain[2] - 0.25) < 1e-15);
}

void TestInspect::greatestStrainOfACompressedSheet() {
    Sample s;
    for (int i = 0; i < int(s.state.size()); ++i)
        s.state.position.set(i, 0.75 * s.state.position.at(i));
    for (const double strain : maxStrain(s.sheet, s.state.position))
        QVERIFY(std::abs(strain + 0.25) < 1e-15);
    const Sheet small{Grid{2, 2}, PointArray(4)}; // no bending springs
    QCOMPARE(maxStrain(small, PointArray(4))[2], 0.0);
}

void TestInspect::kineticEnergyOfAThrownSheet() {
    Sample s;
    QCOMPARE(kineticEnergy(s.scene, s.state), 0.0);
    const double dt = s.scene.simulation.timeStep();
    for (int i = 0; i < int(s.state.size()); ++i)
        s.state.lastPosition.set(i, s.state.position.at(i) - Vec3(1, 2, 2) * dt);
    QVERIFY(std::abs(kineticEnergy(s.scene, s.state) - 0.5 * 120 * 9) < 1e-8);
}

void TestInspect::potentialEnergyOfHeight() {
    Sample s;
    QVERIFY(std::abs(potentialEnergy(s.scene, s.sheet, s.state.position) - 120 * 9.8 * 1) < 1e-10);
    s.scene.simulation.gravity = Vec3(1, 0, -2);
    // The middle of the points is at x = 1, z = 3.
    QVERIFY(std::abs(potentialEnergy(s.scene, s.sheet, s.state.position) + 120 * (1 - 2 * 3)) < 1e-10);
}

void TestInspect::potentialEnergyOfSprings() {
    Sample s;
    s.scene.simulation.gravity = Vec3(0, 0, 0);
    for (int i = 0; i < int(s.state.size()); ++i)
        s.state.position.x[std::size_t(i)] *= 1.5;
    const double diagonal = std::hypot(1.5, 2) - std::sqrt(5);
    // 8 springs across and 12 diagonals of 5000 N/m, 4 bending springs across of 1000 N/m, twice as long.
    const double expected = 0.5 * (8 * 5000 * 0.25 + 12 * 5000 * diagonal * diagonal + 4 * 1000 * 1);
    QVERIFY(std::abs(potentialEnergy(s.scene, s.sheet, s.state.position) - expected) < 1e-9);
}

void TestInspect::energyCountsOnlyWhatIsSwitchedOn() {
    Sample s;
    s.scene.simulation.gravity = Vec3(0, 0, 0);
    s.scene.cloth.enableStructural = s.scene.cloth.enableShearing = false;
    for (int i = 0; i < int(s.state.size()); ++i)
        s.state.position.x[std::size_t(i)] *= 1.5;
    QVERIFY(std::abs(potentialEnergy(s.scene, s.sheet, s.state.position) - 0.5 * 4 * 1000) < 1e-9);
}

void TestInspect::finiteStates() {
    const Sample s;
    QVERIFY(allFinite(s.state));
    for (const double bad :
         {std::numeric_limits<double>::quiet_NaN(), std::numeric_limits<double>::infinity(),
          -std::numeric_limits<double>::infinity()})
        for (std::vector<double> PointArray::*axis : {&PointArray::x, &PointArray::y, &PointArray::z})
            for (PointArray ClothState::*points : {&ClothState::position, &ClothState::lastPosition}) {
                ClothState changed = s.state;
                (changed.*points.*axis).back() = bad;
                QVERIFY(!allFinite(changed));
            }
}

QTEST_APPLESS_MAIN(TestInspect)
#include "tst_inspect.moc"
