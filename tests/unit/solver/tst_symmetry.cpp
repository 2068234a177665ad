// A moved or mirrored scene gives the moved or mirrored result.
#include "simcore/solver/verlet_solver.h"
#include "tests/support/random.h"
#include "tests/support/states.h"

#include <QtTest>

#include <Eigen/Geometry>

#include <numbers>

using namespace clothlab;

namespace {

constexpr int kSteps = 200;
constexpr double kTolerance = 1e-9; // m

// A rotation, or a rotation and a reflection, and then a translation.
struct Motion {
    Eigen::Matrix3d linear = Eigen::Matrix3d::Identity();
    Vec3 translation{0, 0, 0};

    Vec3 operator()(const Vec3& p) const { return linear * p + translation; }

    Scene operator()(Scene scene) const {
        for (Sphere& s : scene.spheres)
            s.origin = (*this)(s.origin);
        for (Plane& p : scene.planes) {
            p.point = (*this)(p.point);
            p.normal = linear * p.normal;
        }
        scene.simulation.gravity = linear * scene.simulation.gravity;
        return scene;
    }
};

// Every phase acts: the sheet is thrown onto a sphere and a slanted plane, folded, and stretched.
Scene busyScene() {
    Scene scene;
    scene.cloth.numWidthPoints = 14;
    scene.cloth.numHeightPoints = 9;
    scene.cloth.thickness = 0.03;
    scene.cloth.density = 10;
    scene.cloth.pinned = {{0, 8}, {3, 0}};
    scene.spheres.push_back({Vec3(0.3, 0.65, 0.4), 0.2, 0.3, {}});
    scene.planes.push_back({Vec3(0, 0.8, 0.9), Vec3(0.2, 1, -0.9), 0.5, {}});
    return scene;
}

ClothState busyState(const Scene& scene) {
    ClothState state = startState(scene);
    foldSheet(scene, state, 0.04);
    throwSheet(scene, state,
               [](int i, const Vec3& p) { return Vec3(2 * p.x(), -3 - p.z(), 3 * p.z() - 0.1 * (i % 3)); });
    return state;
}

int strainLimits(VerletSolver& solver, ClothState& state) {
    int sum = 0;
    for (int n = 0; n < kSteps; ++n)
        sum += solver.step(state).strainLimitCorrections;
    return sum;
}

int phasesThatMoved(const Scene& scene, ClothState state) {
    VerletSolver solver(scene);
    std::array<bool, 5> moved{};
    PointArray before = state.position;
    const PhaseObserver observer = [&](Phase phase, const ClothState& s) {
        moved[std::size_t(phase)] = moved[std::size_t(phase)] || !(s.position == before);
        before = s.position;
    };
    for (int n = 0; n < kSteps; ++n)
        solver.step(state, &observer);
    return int(std::count(moved.begin(), moved.end(), true));
}

double distanceAfterMotion(const Motion& motion) {
    const Scene scene = busyScene();
    VerletSolver solver(scene);
    VerletSolver movedSolver(motion(scene));
    ClothState state = busyState(scene);
    ClothState movedState = mapState(state, motion);
    strainLimits(solver, state);
    strainLimits(movedSolver, movedState);
    return greatestDistance(mapState(state, motion).position, movedState.position);
}

Motion rotation(double degrees, const Vec3& axis) {
    return {Eigen::AngleAxisd(degrees * std::numbers::pi / 180, axis.normalized()).toRotationMatrix(),
            Vec3(0, 0, 0)};
}

Motion reflection(const Vec3& normal) {
    const Vec3 n = normal.normalized();
    return {Eigen::Matrix3d::Identity() - 2 * n * n.transpose(), Vec3(0, 0, 0)};
}

} // namespace

class TestSymmetry : public QObject {
    Q_OBJECT

private slots:
    void everyPhaseActs();
    void motions_data();
    void motions();
    void quarterTurnIsExact();
    void mirroredSheet();
};

void TestSymmetry::everyPhaseActs() {
    const Scene scene = busyScene();
    QCOMPARE(phasesThatMoved(scene, busyState(scene)), 4); // forces move nothing yet
}

void TestSymmetry::motions_data() {
    QTest::addColumn<Eigen::Matrix3d>("linear");
    QTest::addColumn<Vec3>("translation");
    const auto row = [](const char* text, const Motion& m) {
        QTest::newRow(text) << m.linear << m.translation;
    };
    row("translation", {Eigen::Matrix3d::Identity(), Vec3(0.5, -2, 0.25)});
    row("quarter turn about y", rotation(90, Vec3(0, 1, 0)));
    row("37 degrees about y", rotation(37, Vec3(0, 1, 0)));
    row("70 degrees about a slanted axis", rotation(70, Vec3(1, 2, -3)));
    row("turn and translation", {rotation(-130, Vec3(-2, 1, 1)).linear, Vec3(1, 1, -1)});
    // The order of the strain limit belongs to the indices, which a reflection in space leaves alone.
    row("reflection in x", reflection(Vec3(1, 0, 0)));
    row("reflection in a slanted plane", reflection(Vec3(1, -1, 2)));
}

void TestSymmetry::motions() {
    QFETCH(Eigen::Matrix3d, linear);
    QFETCH(Vec3, translation);
    const double distance = distanceAfterMotion({linear, translation});
    qInfo("%g m", distance);
    QVERIFY2(distance < kTolerance, qPrintable(QString::number(distance)));
}

// It only changes the names and signs of coordinates; what is left is the order in which squares are added.
void TestSymmetry::quarterTurnIsExact() {
    Motion turn;
    turn.linear << 0, 0, 1, 0, 1, 0, -1, 0, 0;
    QVERIFY(distanceAfterMotion(turn) < 1e-12);
}

// A sheet that is symmetric in its indices stays so. The strain limit goes through the springs from one
// side, so this holds only where it does not act.
void TestSymmetry::mirroredSheet() {
    Scene scene;
    scene.cloth.numWidthPoints = 14;
    scene.cloth.numHeightPoints = 9;
    scene.cloth.thickness = 0.03;
    scene.cloth.density = 1;
    scene.cloth.ks = 500;
    scene.cloth.pinned = {{0, 0}, {13, 0}};
    scene.spheres.push_back({Vec3(0.5, 0.79, 0.6), 0.2, 0.3, {}});
    scene.planes.push_back({Vec3(0.5, 0.97, 1), Vec3(0, 1, 0), 0.5, {}});
    VerletSolver solver(scene);
    ClothState state = solver.start();
    QCOMPARE(strainLimits(solver, state), 0);
    double worst = 0;
    double moved = 0;
    for (int i = 0; i < int(state.size()); ++i) {
        const GridPoint p = solver.sheet().grid.place(i);
        const Vec3 other = state.position.at(solver.sheet().grid.index(13 - p.x, p.y));
        worst = std::max(worst, (state.position.at(i) - Vec3(1 - other.x(), other.y(), other.z())).norm());
        moved = std::max(moved, (state.position.at(i) - solver.start().position.at(i)).norm());
    }
    qInfo("%g m", worst);
    QVERIFY(moved > 0.02);
    QVERIFY(worst < kTolerance);
}

QTEST_APPLESS_MAIN(TestSymmetry)
#include "tst_symmetry.moc"
