// Lists of neighbours outlive the step they were made in: on a cloud that moves, every step must still give
// the bits of all pairs.
#include "tests/support/in_rows.h"
#include "tests/support/random.h"

#include <QtTest>

using namespace clothlab;

namespace {

constexpr double kDistance = 0.02;
constexpr int kPoints = 150;
constexpr int kSteps = 200;

// How a cloud moves from one step to the next.
struct Motion {
    const char* name;
    double together; // of all points alike, m a step
    double apart;    // of each point for itself, m a step
    double spread;   // half the width of the cloud at the start, m
};

constexpr Motion kMotions[] = {{"still", 0, 0, 0.05},           {"falling", 0.5, 0, 0.05},
                               {"creeping", 0, 2e-5, 0.05},     {"simmering", 0, 4e-4, 0.05},
                               {"falling apart", 3, 3e-3, 1},   {"wild", 0, 0.03, 0.05},
                               {"at one place", 0, 1e-5, 1e-4}, {"far and fast", 1e7, 1e-4, 0.05}};

} // namespace

class TestMovingCloud : public QObject {
    Q_OBJECT

private slots:
    void everyStepEqualsAllPairs_data();
    void everyStepEqualsAllPairs();
    void anotherDistanceOrSheetIsNoticed();
    void listsLastAsLongAsTheyMay();

private:
    // The same for all motions, as a solver keeps it.
    CloudCollision m_collisions[4] = {CloudCollision(), CloudCollision({bestInstructionSet(), 10, 1}),
                                      CloudCollision({bestInstructionSet(), 10, 3}),
                                      CloudCollision({InstructionSet::Scalar, 30, 5})};

    void compare(const PointArray& points, const std::vector<std::uint8_t>& pinned, double distance,
                 int step);
};

void TestMovingCloud::compare(const PointArray& points, const std::vector<std::uint8_t>& pinned,
                              double distance, int step) {
    PointArray expected(points.size()), found(points.size());
    selfCollisionBruteForce(points, pinned, distance, 0.25, expected);
    for (CloudCollision& collision : m_collisions) {
        collision.corrections(points, pinned, distance, 0.25, found);
        QVERIFY2(expected == found, qPrintable(QStringLiteral("step %1").arg(step)));
    }
}

void TestMovingCloud::everyStepEqualsAllPairs_data() {
    QTest::addColumn<int>("motion");
    for (int i = 0; i < int(std::size(kMotions)); ++i)
        QTest::newRow(kMotions[i].name) << i;
}

void TestMovingCloud::everyStepEqualsAllPairs() {
    QFETCH(int, motion);
    const Motion& how = kMotions[motion];
    SplitMix64 random(std::uint64_t(motion) + 1);
    const auto around = [&](double size) {
        const double x = random.real(-size, size), y = random.real(-size, size);
        return Vec3(x, y, random.real(-size, size));
    };
    PointArray points(kPoints);
    std::vector<std::uint8_t> pinned(kPoints);
    for (int i = 0; i < kPoints; ++i) {
        points.set(i, around(how.spread));
        pinned[std::size_t(i)] = random.chance(0.1) ? 1 : 0;
    }
    for (int step = 0; step < kSteps; ++step) {
        compare(points, pinned, kDistance, step);
        if (QTest::currentTestFailed())
            return;
        const Vec3 together = around(how.together);
        for (int i = 0; i < kPoints; ++i)
            points.set(i, points.at(i) + together + around(how.apart));
    }
}

void TestMovingCloud::anotherDistanceOrSheetIsNoticed() {
    for (const double distance : {0.02, 0.05, 0.01, 0.02})
        for (const int count : {150, 40, 2, 300}) {
            SplitMix64 random(7);
            PointArray points{std::size_t(count)};
            for (int i = 0; i < count; ++i)
                points.set(i, Vec3(random.real(0, 0.1), random.real(0, 0.1), random.real(0, 0.1)));
            compare(points, std::vector<std::uint8_t>(std::size_t(count)), distance, count);
        }
}

// To list anew what has not moved, or has as a whole, would change no bit, but take long.
void TestMovingCloud::listsLastAsLongAsTheyMay() {
    for (const double together : {0.0, 0.3 * kDistance, 100 * kDistance}) {
        CloudCollision collision({bestInstructionSet(), 10, 3});
        SplitMix64 random(3);
        PointArray points{std::size_t(kPoints)}, found{std::size_t(kPoints)};
        for (int i = 0; i < kPoints; ++i)
            points.set(i, Vec3(random.real(0, 0.1), random.real(0, 0.1), random.real(0, 0.1)));
        const std::vector<std::uint8_t> pinned(std::size_t{kPoints});
        const auto step = [&](const Vec3& by, int movedPoints) {
            collision.corrections(points, pinned, kDistance, 0.25, found);
            for (int i = 0; i < movedPoints; ++i)
                points.set(i, points.at(i) + by);
        };
        for (int n = 0; n < 20; ++n)
            step(Vec3(0, -together, 0), kPoints);
        QCOMPARE(collision.listings(), 1);
        // There and back again.
        for (const double there : {0.1, -0.1, 0.1, -0.1, 0.1, -0.1})
            step(Vec3(there * kDistance, 0, 0), 1);
        QCOMPARE(collision.listings(), 1);
        for (int n = 0; n < 20; ++n)
            step(Vec3(0.1 * kDistance, 0, 0), 1);
        const int moved = collision.listings();
        QVERIFY(moved > 1);
        for (int n = 0; n < 10; ++n)
            step(Vec3::Zero(), 0);
        QVERIFY(collision.listings() <= moved + 1);
    }
}

QTEST_APPLESS_MAIN(TestMovingCloud)
#include "tst_moving_cloud.moc"
