// Spheres and planes, one point at a time.
#include "simcore/kernels/model_constants.h"
#include "simcore/solver/verlet_solver.h"
#include "tests/support/in_rows.h"

#include <QtTest>

#include <cmath>

using namespace clothlab;

namespace {

struct Point {
    Vec3 last;
    Vec3 position;
};

// With every instruction set, which must all do the same.
void collide(const Scene& scene, const std::vector<std::uint8_t>& pinned, ClothState& state) {
    const ClothState before = state;
    collideWith(scene, InstructionSet::Scalar, pinned, state);
    for (const InstructionSet set : supportedInstructionSets()) {
        ClothState other = before;
        collideWith(scene, set, pinned, other);
        if (stateHash(other) != stateHash(state))
            state.position.set(0, Vec3(NAN, NAN, NAN));
    }
}

void collide(const Sphere& sphere, const std::vector<std::uint8_t>& pinned, ClothState& state) {
    Scene scene;
    scene.spheres = {sphere};
    collide(scene, pinned, state);
}

void collide(const Plane& plane, const std::vector<std::uint8_t>& pinned, ClothState& state) {
    Scene scene;
    scene.planes = {plane};
    collide(scene, pinned, state);
}

template <typename Collider>
Vec3 collided(const Collider& collider, const Point& point, bool pinned = false) {
    ClothState state{PointArray(3), PointArray(3)};
    // Neighbours far from anything, so that a wrong index shows.
    for (int i = 0; i < 3; ++i) {
        state.position.set(i, Vec3(50 + i, 60, 70));
        state.lastPosition.set(i, Vec3(50 + i, 60, 70));
    }
    state.position.set(1, point.position);
    state.lastPosition.set(1, point.last);
    const ClothState before = state;
    collide(collider, {0, std::uint8_t(pinned ? 1 : 0), 0}, state);
    if (!(state.position.at(0) == before.position.at(0) && state.position.at(2) == before.position.at(2) &&
          state.lastPosition == before.lastPosition))
        return Vec3(NAN, NAN, NAN);
    return state.position.at(1);
}

bool near(const Vec3& a, const Vec3& b) {
    return (a - b).norm() < 1e-15;
}

const Sphere kSphere{Vec3(1, 2, 3), 0.5, 0, {}};
const Plane kFloor{Vec3(0, 0.25, 0), Vec3(0, 1, 0), 0, {}};

Sphere withFriction(Sphere sphere, double friction) {
    sphere.friction = friction;
    return sphere;
}

Plane withFriction(Plane plane, double friction) {
    plane.friction = friction;
    return plane;
}

} // namespace

class TestColliders : public QObject {
    Q_OBJECT

private slots:
    void sphereWithoutFriction();
    void sphereWithFriction();
    void outsideOfASphereIsFree();
    void originOfASphere();
    void planeFromEitherSide();
    void planeWithFriction();
    void planeWithANormalOfAnyLength();
    void slantedPlane();
    void notCrossingAPlaneIsFree();
    void lastPositionOnThePlane();
    void pinnedPointsStay();
    void manyPoints();
    void sheetRestsOnThePlane();
    void frictionHoldsTheSheet();
};

void TestColliders::sphereWithoutFriction() {
    const Vec3 inside = kSphere.origin + Vec3(0.18, 0, 0.24); // 0.3 from the middle
    const Vec3 onSurface = kSphere.origin + Vec3(0.3, 0, 0.4);
    QVERIFY(near(collided(kSphere, {Vec3(9, 9, 9), inside}), onSurface));
}

void TestColliders::sphereWithFriction() {
    const Vec3 last = kSphere.origin + Vec3(0.5, 0.1, 0.4);
    const Vec3 inside = kSphere.origin + Vec3(0.18, 0, 0.24);
    const Vec3 onSurface = kSphere.origin + Vec3(0.3, 0, 0.4);
    QVERIFY(near(collided(withFriction(kSphere, 0.25), {last, inside}), last + 0.75 * (onSurface - last)));
    QVERIFY(near(collided(withFriction(kSphere, 1), {last, inside}), last));
}

void TestColliders::outsideOfASphereIsFree() {
    const Vec3 inside = kSphere.origin + Vec3(0.1, 0, 0);
    const Vec3 outside = kSphere.origin + Vec3(0.3, 0.3, 0.3);
    QCOMPARE(collided(kSphere, {inside, outside}), outside);
    const Vec3 onSurface = kSphere.origin + Vec3(0.5, 0, 0);
    QCOMPARE(collided(kSphere, {inside, onSurface}), onSurface);
}

void TestColliders::originOfASphere() {
    const Vec3 top = kSphere.origin + Vec3(0, 0.5, 0);
    QVERIFY(near(collided(kSphere, {Vec3(9, 9, 9), kSphere.origin}), top));
    const Vec3 barelyOff = kSphere.origin + Vec3(0, 0, 1e-15);
    QVERIFY(near(collided(kSphere, {Vec3(9, 9, 9), barelyOff}), kSphere.origin + Vec3(0, 0, 0.5)));
}

void TestColliders::planeFromEitherSide() {
    const Vec3 above(0.5, 0.3, 0.1);
    const Vec3 below(0.6, 0.2, 0.1);
    QVERIFY(near(collided(kFloor, {above, below}), Vec3(0.6, 0.2501, 0.1)));
    QVERIFY(near(collided(kFloor, {below, above}), Vec3(0.5, 0.2499, 0.1)));
    Plane ceiling = kFloor;
    ceiling.normal = -kFloor.normal;
    QVERIFY(near(collided(ceiling, {above, below}), Vec3(0.6, 0.2501, 0.1)));
    QVERIFY(near(collided(ceiling, {below, above}), Vec3(0.5, 0.2499, 0.1)));
}

void TestColliders::planeWithFriction() {
    const Vec3 last(0.5, 0.3, 0.1);
    const Vec3 below(0.7, 0.2, 0.2);
    const Vec3 tangent(0.7, 0.2501, 0.2);
    QVERIFY(near(collided(withFriction(kFloor, 0.75), {last, below}), last + 0.25 * (tangent - last)));
    QVERIFY(near(collided(withFriction(kFloor, 1), {last, below}), last));
}

void TestColliders::planeWithANormalOfAnyLength() {
    for (const double length : {1e-9, 0.3, 7.0, 1e9}) {
        Plane plane = kFloor;
        plane.normal *= length;
        QVERIFY(near(collided(plane, {Vec3(0, 1, 0), Vec3(0, 0, 0)}), Vec3(0, 0.2501, 0)));
    }
}

void TestColliders::slantedPlane() {
    const Plane plane{Vec3(1, 1, 1), Vec3(3, 4, 0), 0, {}};
    const Vec3 n(0.6, 0.8, 0);
    const Vec3 along(0.8, -0.6, 0.5);
    const Vec3 from = plane.point + 0.2 * n;
    const Vec3 to = plane.point - 0.1 * n + along;
    QVERIFY(near(collided(plane, {from, to}), plane.point + 0.0001 * n + along));
}

void TestColliders::notCrossingAPlaneIsFree() {
    for (const double y : {0.2, 0.3}) {
        const Vec3 to(0.5, y + (y < 0.25 ? -0.1 : 0.1), 0.5);
        QCOMPARE(collided(kFloor, {Vec3(0, y, 0), to}), to);
    }
}

void TestColliders::lastPositionOnThePlane() {
    const Vec3 on(0.1, 0.25, 0.1);
    QVERIFY(near(collided(kFloor, {on, Vec3(0.1, 0.2, 0.1)}), Vec3(0.1, 0.2501, 0.1)));
    const Vec3 up(0.1, 0.3, 0.1);
    QCOMPARE(collided(kFloor, {on, up}), up);
    QCOMPARE(collided(kFloor, {on, on}), on);
    // Arriving there from below would otherwise be a way through in two steps.
    QVERIFY(near(collided(kFloor, {Vec3(0.1, 0.2, 0.1), on}), Vec3(0.1, 0.2499, 0.1)));
}

void TestColliders::pinnedPointsStay() {
    const Vec3 inside = kSphere.origin + Vec3(0.1, 0, 0);
    QCOMPARE(collided(kSphere, {Vec3(9, 9, 9), inside}, true), inside);
    const Vec3 below(0.6, 0.2, 0.1);
    QCOMPARE(collided(kFloor, {Vec3(0.5, 0.3, 0.1), below}, true), below);
}

void TestColliders::manyPoints() {
    ClothState state{PointArray(100), PointArray(100)};
    for (int i = 0; i < 100; ++i) {
        state.lastPosition.set(i, Vec3(0.01 * i, 1, 0));
        state.position.set(i, Vec3(0.01 * i, 0.4 - 0.005 * i, 0));
    }
    collide(kFloor, std::vector<std::uint8_t>(100, 0), state);
    for (int i = 0; i < 100; ++i) {
        const double y = 0.4 - 0.005 * i;
        QVERIFY(std::abs(state.position.y[std::size_t(i)] - (i <= 30 ? y : 0.2501)) < 1e-14);
    }
}

// Never below, and never higher than half the offset in one step throws it: contact leaves that velocity.
void TestColliders::sheetRestsOnThePlane() {
    Scene scene;
    scene.cloth.numWidthPoints = 6;
    scene.cloth.numHeightPoints = 5;
    scene.cloth.thickness = 0.01;
    scene.planes.push_back({Vec3(0, 0.99, 0), Vec3(0, 1, 0), 0.5, {}});
    VerletSolver solver(scene);
    ClothState state = solver.start();
    const double speed = 0.5 * kPlaneOffset / scene.simulation.timeStep();
    const double highest = 0.99 + kPlaneOffset + speed * speed / (2 * 9.8);
    for (int n = 0; n < 3000; ++n) {
        solver.step(state);
        for (const double y : state.position.y)
            QVERIFY(y >= 0.99 && (n < 1000 || y < highest));
    }
}

// Without friction it slides as if in free fall; with full friction each contact stops it.
void TestColliders::frictionHoldsTheSheet() {
    for (const double friction : {0.0, 1.0}) {
        Scene scene;
        scene.cloth.numWidthPoints = 4;
        scene.cloth.numHeightPoints = 3;
        scene.cloth.damping = 0;
        scene.planes.push_back({Vec3(0, 0.9999, 0), Vec3(0, 1, 0), friction, {}});
        scene.simulation.gravity = Vec3(3, -9.8, 0);
        VerletSolver solver(scene);
        ClothState state = solver.start();
        for (int n = 0; n < 1000; ++n)
            solver.step(state);
        const double slid = state.position.x[5] - solver.start().position.x[5];
        const double dt = scene.simulation.timeStep();
        const double free = 3 * dt * dt * 1000 * 1001 / 2;
        QVERIFY(friction == 1 ? slid < 0.01 * free : std::abs(slid - free) < 1e-10);
    }
}

QTEST_APPLESS_MAIN(TestColliders)
#include "tst_colliders.moc"
