// The facts of a frame, against what the inspector says and all pairs of points.
#include "simcore/inspect/frame_measure.h"
#include "simcore/inspect/inspect.h"
#include "tests/support/random_run.h"
#include "tests/support/recorded_run.h"
#include "tests/support/tiny_scene.h"

#include <QtTest>

#include <cmath>
#include <limits>

using namespace clothlab;

namespace {

bool joined(const Grid& grid, int a, int b) {
    for (const int number : grid.springsOf(a)) {
        const Spring spring = grid.spring(number);
        if (spring.a == b || spring.b == b)
            return true;
    }
    return false;
}

// The plain reading: all pairs.
std::int64_t contactsOf(const Frame& frame, const Sheet& sheet) {
    const Scene& scene = *frame.scene;
    const PointArray& position = frame.state.position;
    std::int64_t count = 0;
    for (int a = 0; a < sheet.grid.pointCount(); ++a) {
        bool touches = false;
        for (int b = 0; b < sheet.grid.pointCount() && !touches; ++b)
            touches = a != b && (position.at(a) - position.at(b)).norm() < 2 * scene.cloth.thickness &&
                      !joined(sheet.grid, a, b);
        for (const Sphere& sphere : scene.spheres)
            touches |= (position.at(a) - sphere.origin).norm() <= sphere.radius + kContactDistance;
        for (const Plane& plane : scene.planes)
            touches |=
                std::abs(plane.normal.normalized().dot(position.at(a) - plane.point)) <= kContactDistance;
        count += touches ? 1 : 0;
    }
    return count;
}

} // namespace

class TestFrameMeasure : public QObject {
    Q_OBJECT

private slots:
    void factsAreThoseOfThePlainReading();
    void stillSheetTouchesNothing();
    void whatIsNotFiniteTouchesNothing();
    void farOutPointsAreFound();
};

void TestFrameMeasure::factsAreThoseOfThePlainReading() {
    std::int64_t touching = 0;
    for (std::uint64_t seed = 1; seed <= 20; ++seed) {
        RandomRun run = randomRun(seed);
        const Sheet sheet{gridOf(run.scene.cloth), startState(run.scene).position};
        FrameMeasure measure(sheet);
        const auto start = std::make_shared<const Frame>(
            Frame{run.start, std::make_shared<const Scene>(run.scene), 0, 0, 0});
        for (const FramePointer& frame : test::runOn(*start, 1, 8)) {
            const FrameFacts facts = measure.factsOf(*frame);
            QCOMPARE(facts.stateHash, stateHash(frame->state));
            QCOMPARE(facts.kineticEnergy, kineticEnergy(*frame->scene, frame->state));
            QCOMPARE(facts.strainLimitCorrections, frame->strainLimitCorrections);
            const auto strain = maxStrain(sheet, frame->state.position);
            double greatest = -1;
            bool any = false;
            for (int type = 0; type < kSpringTypes; ++type)
                if (frame->scene->cloth.enabled(SpringType(type)) &&
                    sheet.grid.springCount(SpringType(type)) > 0) {
                    greatest = std::max(greatest, strain[std::size_t(type)]);
                    any = true;
                }
            if (any)
                QVERIFY2(std::abs(facts.greatestStrain - greatest) < 1e-12, run.describe().c_str());
            // Single precision may see a pair at the very distance otherwise.
            QVERIFY2(std::abs(facts.contacts - contactsOf(*frame, sheet)) <= 2,
                     qPrintable(QString("%1 instead of %2; %3")
                                    .arg(facts.contacts)
                                    .arg(contactsOf(*frame, sheet))
                                    .arg(run.describe().c_str())));
            touching += facts.contacts;
        }
    }
    QVERIFY(touching > 100);
}

void TestFrameMeasure::stillSheetTouchesNothing() {
    const Scene scene = test::tinyScene();
    const Frame frame{startState(scene), std::make_shared<const Scene>(scene), 2.5, 7, 1.25};
    const FrameFacts facts = factsOf(frame, {gridOf(scene.cloth), startState(scene).position});
    QCOMPARE(facts.time, 2.5);
    QCOMPARE(facts.milliseconds, 1.25);
    QCOMPARE(facts.strainLimitCorrections, std::int64_t(7));
    QCOMPARE(facts.kineticEnergy, 0.0);
    QVERIFY(std::abs(facts.greatestStrain) < 1e-12);
    QCOMPARE(facts.contacts, std::int64_t(0));
}

void TestFrameMeasure::whatIsNotFiniteTouchesNothing() {
    const Scene scene = test::tinyScene();
    Frame frame{startState(scene), std::make_shared<const Scene>(scene), 0, 0, 0};
    frame.state.position.x[3] = std::numeric_limits<double>::quiet_NaN();
    const FrameFacts facts = factsOf(frame, {gridOf(scene.cloth), startState(scene).position});
    QCOMPARE(facts.contacts, std::int64_t(0));
    QCOMPARE(facts.stateHash, stateHash(frame.state));
}

void TestFrameMeasure::farOutPointsAreFound() {
    Scene scene = test::tinyScene();
    scene.cloth.thickness = 0.05;
    const Sheet sheet{gridOf(scene.cloth), startState(scene).position};
    Frame frame{startState(scene), std::make_shared<const Scene>(scene), 0, 0, 0};
    for (const double far : {10.0, 1e4, 1e30}) {
        frame.state.position.set(0, Vec3(far, -far, far));
        QCOMPARE(factsOf(frame, sheet).contacts, contactsOf(frame, sheet));
    }
    frame.state.position.set(0, frame.state.position.at(15) + Vec3(0.01, 0, 0));
    QCOMPARE(factsOf(frame, sheet).contacts, contactsOf(frame, sheet));
    QVERIFY(factsOf(frame, sheet).contacts >= 2);
}

QTEST_APPLESS_MAIN(TestFrameMeasure)
#include "tst_frame_measure.moc"
