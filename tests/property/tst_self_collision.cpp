// The accelerated self-collision against all pairs: the same bits, whatever the cloud.
#include "tests/support/in_rows.h"
#include "tests/support/oracle.h"
#include "tests/support/random.h"
#include "tests/support/states.h"

#include <QtTest>

#include <bit>
#include <cmath>

using namespace clothlab;

namespace {

constexpr int kClouds = 100;

struct Cloud {
    std::string kind;
    PointArray points;
    std::vector<std::uint8_t> pinned;
    double distance = 0;
    double share = 0;
};

Vec3 uniformPoint(SplitMix64& random, double size) {
    const double x = random.real(-size, size);
    const double y = random.real(-size, size);
    return {x, y, random.real(-size, size)};
}

// A few units in the last place up or down, or none.
double nudged(SplitMix64& random, double value) {
    for (int n = random.integer(0, 3); n > 0; --n)
        value = std::nextafter(value, random.chance(0.5) ? INFINITY : -INFINITY);
    return value;
}

using Place = Vec3 (*)(SplitMix64&, double distance, const PointArray& before, int index);

Vec3 dense(SplitMix64& random, double d, const PointArray&, int) {
    return uniformPoint(random, 2 * d);
}
Vec3 sparse(SplitMix64& random, double d, const PointArray&, int) {
    return uniformPoint(random, 20 * d);
}

Vec3 clustered(SplitMix64& random, double d, const PointArray& before, int i) {
    if (i < 5)
        return uniformPoint(random, 50 * d);
    return before.at(random.integer(0, 4)) + uniformPoint(random, d);
}

Vec3 coincident(SplitMix64& random, double d, const PointArray& before, int i) {
    if (i > 0 && random.chance(0.7))
        return before.at(random.integer(0, i - 1));
    return uniformPoint(random, 3 * d);
}

Vec3 onCellBorders(SplitMix64& random, double d, const PointArray&, int) {
    const double x = random.integer(-5, 5) * d;
    const double y = random.integer(-5, 5) * d;
    return {x, y, random.integer(-5, 5) * d};
}

Vec3 besideCellBorders(SplitMix64& random, double d, const PointArray&, int) {
    const double x = nudged(random, random.integer(-9, 9) * d);
    const double y = nudged(random, random.integer(-1, 1) * d);
    return {x, y, nudged(random, random.integer(-1, 1) * d)};
}

Vec3 farAway(SplitMix64& random, double d, const PointArray&, int) {
    const Vec3 corner(1e12, -1e12, 1e9);
    return corner + uniformPoint(random, 5 * d + 1e-3);
}

Vec3 atEveryScale(SplitMix64& random, double d, const PointArray& before, int i) {
    if (i > 0 && random.chance(0.5))
        return before.at(random.integer(0, i - 1)) + uniformPoint(random, 0.6 * d);
    return uniformPoint(random, std::pow(10, random.real(-6, 12)));
}

struct Kind {
    const char* name;
    Place place;
};
constexpr Kind kKinds[] = {{"dense", dense},
                           {"sparse", sparse},
                           {"clustered", clustered},
                           {"coincident", coincident},
                           {"on cell borders", onCellBorders},
                           {"beside cell borders", besideCellBorders},
                           {"far away", farAway},
                           {"at every scale", atEveryScale}};

Cloud makeCloud(std::uint64_t seed) {
    SplitMix64 random(seed);
    const Kind& kind = kKinds[seed % std::size(kKinds)];
    Cloud cloud;
    cloud.kind = kind.name;
    const int count = random.integer(2, 500);
    cloud.distance = random.chance(0.5) ? 0.019 : random.real(0.001, 0.5);
    cloud.share = 1.0 / random.integer(1, 60);
    cloud.points = PointArray(std::size_t(count));
    for (int i = 0; i < count; ++i) {
        cloud.points.set(i, kind.place(random, cloud.distance, cloud.points, i));
        cloud.pinned.push_back(random.chance(0.1) ? 1 : 0);
    }
    return cloud;
}

bool sameBits(const std::vector<double>& a, const std::vector<double>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](double x, double y) {
        return std::bit_cast<std::uint64_t>(x) == std::bit_cast<std::uint64_t>(y);
    });
}

bool sameBits(const PointArray& a, const PointArray& b) {
    return sameBits(a.x, b.x) && sameBits(a.y, b.y) && sameBits(a.z, b.z);
}

const CloudLayout kLayouts[] = {
    {InstructionSet::Scalar, 0, 1}, {InstructionSet::Sse2, 0, 1},    {InstructionSet::Avx2, 2, 1},
    {InstructionSet::Avx2, 5, 3},   {InstructionSet::Sse2, 3, 4},    {InstructionSet::Scalar, 7, 2},
    {InstructionSet::Avx2, 41, 8},  {InstructionSet::Avx2, 1, 2},    {InstructionSet::Avx512, 0, 1},
    {InstructionSet::Avx512, 7, 3}, {InstructionSet::Avx512, 41, 2}, {InstructionSet::Avx512, 1, 2}};

// Both answers, into buffers that held something else before.
struct Answers {
    PointArray accelerated, bruteForce;
    int corrected = 0;
};

Answers answers(CloudCollision& selfCollision, const Cloud& cloud) {
    Answers a;
    a.accelerated = cloud.points;
    a.bruteForce = cloud.points;
    a.corrected =
        selfCollision.corrections(cloud.points, cloud.pinned, cloud.distance, cloud.share, a.accelerated);
    for (const CloudLayout& layout : kLayouts) {
        if (!isSupported(layout.instructionSet))
            continue;
        PointArray other(cloud.points.size());
        CloudCollision(layout).corrections(cloud.points, cloud.pinned, cloud.distance, cloud.share, other);
        if (!sameBits(other, a.accelerated)) {
            qWarning("%s differs", layout.describe().c_str());
            a.corrected = -1;
        }
    }
    selfCollisionBruteForce(cloud.points, cloud.pinned, cloud.distance, cloud.share, a.bruteForce);
    for (std::vector<double>* coordinate : {&a.bruteForce.x, &a.bruteForce.y, &a.bruteForce.z})
        for (double& value : *coordinate)
            value += 0.0; // a negative zero moves nothing either
    return a;
}

double worstAgainstOracle(const PointArray& corrections, const std::vector<oracle::Correction>& expected) {
    double worst = 0;
    for (int i = 0; i < int(corrections.size()); ++i)
        worst = std::max(worst, (corrections.at(i) - expected[std::size_t(i)].vector).norm());
    return worst;
}

// Neighbours on opposite sides may ask for nothing in all.
int correctedPoints(const std::vector<oracle::Correction>& corrections) {
    return int(std::count_if(corrections.begin(), corrections.end(),
                             [](const oracle::Correction& c) { return !c.vector.isZero(0); }));
}

} // namespace

class TestSelfCollision : public QObject {
    Q_OBJECT

private slots:
    void randomClouds();
    void foldedSheet();
    void pairAcrossACellBorder();
    void pairAcrossEveryCorner();
    void oneNeighbour();
    void meanOfTwoNeighbours();
    void pinnedPointsPushButStay();
    void coincidentPairCountsForNothing();
    void reachIsExclusive();
    void fewPoints();
};

void TestSelfCollision::randomClouds() {
    CloudCollision selfCollision; // one for all, so that no cloud leaves anything behind for the next
    std::map<std::string, int> correctedByKind;
    for (std::uint64_t seed = 0; seed < kClouds; ++seed) {
        const Cloud cloud = makeCloud(seed);
        const std::string text = "seed " + std::to_string(seed) + ", " + cloud.kind;
        const Answers a = answers(selfCollision, cloud);
        QVERIFY2(sameBits(a.accelerated, a.bruteForce), text.c_str());
        const auto expected = oracle::selfCollisionAllPairs(toPointMasses(cloud.points, cloud.pinned),
                                                            cloud.distance, cloud.share);
        QVERIFY2(worstAgainstOracle(a.accelerated, expected) < 1e-13 * cloud.distance, text.c_str());
        QVERIFY2(a.corrected == correctedPoints(expected), text.c_str());
        correctedByKind[cloud.kind] += a.corrected;
    }
    for (const Kind& kind : kKinds)
        QVERIFY2(correctedByKind[kind.name] > 0, kind.name);
}

void TestSelfCollision::foldedSheet() {
    Scene scene;
    scene.cloth.numWidthPoints = 41;
    scene.cloth.numHeightPoints = 23;
    scene.cloth.pinned = {{0, 0}, {40, 22}};
    ClothState state = startState(scene);
    foldSheet(scene, state, scene.cloth.thickness);
    const Cloud cloud{"folded", state.position, pinnedMask(scene.cloth), 2 * scene.cloth.thickness, 1.0 / 30};
    CloudCollision selfCollision;
    const Answers a = answers(selfCollision, cloud);
    QVERIFY(sameBits(a.accelerated, a.bruteForce));
    QVERIFY(a.corrected > 800);
    const std::vector<oracle::PointMass> points = toPointMasses(cloud.points, cloud.pinned);
    QVERIFY(worstAgainstOracle(a.accelerated,
                               oracle::selfCollisionAllPairs(points, cloud.distance, cloud.share)) < 1e-15);
    QVERIFY(worstAgainstOracle(a.accelerated,
                               oracle::selfCollisionHashed(points, cloud.distance, cloud.share)) < 1e-15);
}

// Two points a hair on either side of a border at many places, near together and almost out of reach,
// where a rounded quotient could put the latter two cells apart.
void TestSelfCollision::pairAcrossACellBorder() {
    SplitMix64 random(1);
    CloudCollision selfCollision;
    int withinReach = 0;
    for (int n = 0; n < 20000; ++n) {
        Cloud cloud;
        cloud.distance = random.chance(0.5) ? 0.019 : random.real(0.001, 0.1);
        cloud.share = 1;
        cloud.pinned = {0, 0};
        cloud.points = PointArray(2);
        const int border = random.integer(-70, 70);
        const int axis = random.integer(0, 2);
        Vec3 a(0.5 * cloud.distance, 0.5 * cloud.distance, 0.5 * cloud.distance);
        Vec3 b = a;
        a[axis] = nudged(random, border * cloud.distance);
        b[axis] = nudged(random, random.chance(0.5) ? (border + 1) * cloud.distance : a[axis]);
        cloud.points.set(0, a);
        cloud.points.set(1, b);
        const Answers answer = answers(selfCollision, cloud);
        QVERIFY2(sameBits(answer.accelerated, answer.bruteForce),
                 qPrintable(QString("border %1, distance %2").arg(border).arg(cloud.distance, 0, 'g', 17)));
        withinReach += answer.corrected;
    }
    QVERIFY(withinReach > 1000);
}

void TestSelfCollision::pairAcrossEveryCorner() {
    CloudCollision selfCollision;
    for (int direction = 0; direction < 27; ++direction) {
        const Vec3 towards(direction % 3 - 1, direction / 3 % 3 - 1, direction / 9 - 1);
        if (towards.isZero())
            continue;
        Cloud cloud;
        cloud.distance = 0.02;
        cloud.share = 1;
        cloud.pinned = {0, 0};
        cloud.points = PointArray(2);
        cloud.points.set(0, -0.001 * towards);
        cloud.points.set(1, 0.001 * towards);
        const Answers a = answers(selfCollision, cloud);
        QCOMPARE(a.corrected, 2);
        const Vec3 apart = (cloud.points.at(1) + a.accelerated.at(1)) - cloud.points.at(0);
        QVERIFY(std::abs(apart.norm() - cloud.distance) < 1e-15);
    }
}

void TestSelfCollision::oneNeighbour() {
    PointArray points(2);
    points.set(1, Vec3(0.006, 0, 0.008));
    PointArray correction(2);
    CloudCollision selfCollision;
    QCOMPARE(selfCollision.corrections(points, {0, 0}, 0.02, 0.1, correction), 2);
    // 0.01 apart, so 0.01 short; a tenth of that along (0.6, 0, 0.8).
    QVERIFY((correction.at(1) - Vec3(0.0006, 0, 0.0008)).norm() < 1e-17);
    QVERIFY((correction.at(0) + Vec3(0.0006, 0, 0.0008)).norm() < 1e-17);
}

void TestSelfCollision::meanOfTwoNeighbours() {
    PointArray points(3);
    points.set(1, Vec3(0.5, 0, 0));
    points.set(2, Vec3(0, 0.25, 0));
    PointArray correction(3);
    CloudCollision selfCollision;
    QCOMPARE(selfCollision.corrections(points, {0, 0, 0}, 1, 1, correction), 3);
    QVERIFY((correction.at(0) - Vec3(-0.25, -0.375, 0)).norm() < 1e-16);
}

void TestSelfCollision::pinnedPointsPushButStay() {
    PointArray points(2);
    points.set(1, Vec3(0.5, 0, 0));
    PointArray correction(2);
    correction.set(0, Vec3(7, 7, 7));
    CloudCollision selfCollision;
    QCOMPARE(selfCollision.corrections(points, {1, 0}, 1, 1, correction), 1);
    QCOMPARE(correction.at(0), Vec3(0, 0, 0));
    QVERIFY((correction.at(1) - Vec3(0.5, 0, 0)).norm() < 1e-16);
}

void TestSelfCollision::coincidentPairCountsForNothing() {
    PointArray points(3);
    points.set(2, Vec3(0.5, 0, 0));
    PointArray correction(3);
    CloudCollision selfCollision;
    selfCollision.corrections(points, {0, 0, 0}, 1, 1, correction);
    QVERIFY((correction.at(0) - Vec3(-0.5, 0, 0)).norm() < 1e-16); // not halved by the one at its own place
    QVERIFY((correction.at(2) - Vec3(0.5, 0, 0)).norm() < 1e-16);
}

void TestSelfCollision::reachIsExclusive() {
    PointArray points(2);
    points.set(1, Vec3(0.5, 0, 0));
    PointArray correction(2);
    CloudCollision selfCollision;
    QCOMPARE(selfCollision.corrections(points, {0, 0}, 0.5, 1, correction), 0);
    QCOMPARE(selfCollision.corrections(points, {0, 0}, std::nextafter(0.5, 1), 1, correction), 2);
}

void TestSelfCollision::fewPoints() {
    CloudCollision selfCollision;
    PointArray none;
    QCOMPARE(selfCollision.corrections(none, {}, 1, 1, none), 0);
    PointArray one(1);
    PointArray correction(1);
    QCOMPARE(selfCollision.corrections(one, {0}, 1, 1, correction), 0);
    QCOMPARE(correction.at(0), Vec3(0, 0, 0));
}

QTEST_APPLESS_MAIN(TestSelfCollision)
#include "tst_self_collision.moc"
