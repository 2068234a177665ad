// Packed frames: within the error, small, and never more than what they were made of.
#include "simcore/recording/frame_group.h"
#include "simcore/recording/group_order.h"
#include "tests/support/random.h"
#include "tests/support/recorded_run.h"
#include "tests/support/shipped_scene.h"

#include <QtTest>

#include <cmath>
#include <limits>

using namespace clothlab;

namespace {

std::vector<FrameGroup> packAll(const std::vector<PointArray>& frames, const Grid& grid, double error) {
    FramePacker packer(grid, error);
    std::vector<FrameGroup> groups;
    for (std::size_t i = 0; i < frames.size(); i += kFramesPerGroup) {
        std::vector<FrameToPack> group;
        for (std::size_t j = i; j < std::min(frames.size(), i + kFramesPerGroup); ++j)
            group.push_back({&frames[j], {}, 1});
        groups.push_back(packGroup(packer, 1, int(i), group));
    }
    return groups;
}

// The greatest difference over all frames, m; infinite if one cannot be unpacked.
double worstOf(const std::vector<PointArray>& frames, const std::vector<FrameGroup>& groups) {
    double worst = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const auto unpacked = positionsOf(groups[i / kFramesPerGroup], int(i));
        worst = std::max(worst, unpacked ? test::greatestDifference(*unpacked, frames[i])
                                         : std::numeric_limits<double>::infinity());
    }
    return worst;
}

std::vector<PointArray> positionsIn(const std::vector<FramePointer>& run) {
    std::vector<PointArray> positions;
    for (const FramePointer& frame : run)
        positions.push_back(frame->state.position);
    return positions;
}

// How many times smaller than three floats a point.
double ratio(const std::vector<FrameGroup>& groups) {
    double raw = 0;
    double packed = 0;
    for (const FrameGroup& group : groups) {
        raw += 12.0 * double(group.frames.size()) * group.grid.pointCount();
        packed += double(chunkOf(group)->payload.size());
    }
    return raw / packed;
}

PointArray randomPoints(SplitMix64& random, std::size_t count, double middle, double spread) {
    PointArray points(count);
    for (const auto axis : {&PointArray::x, &PointArray::y, &PointArray::z})
        for (double& value : points.*axis)
            value = middle + random.real(-spread, spread);
    return points;
}

} // namespace

class TestFrameCodec : public QObject {
    Q_OBJECT

private slots:
    void violentTakesAreWithinTheErrorAndSmall_data();
    void violentTakesAreWithinTheErrorAndSmall();
    void anyPlaceIsWithinTheError_data();
    void anyPlaceIsWithinTheError();
    void losslessKeepsEveryBit();
    void whatIsNotFiniteKeepsItsBits();
    void anyGridAndNumberOfFrames();
    void fiveFramesAtMostAreUnpacked();
    void trimmedGroupsKeepTheirFrames();
    void otherBytesAreNoFrames();
};

void TestFrameCodec::violentTakesAreWithinTheErrorAndSmall_data() {
    QTest::addColumn<double>("density");
    QTest::addColumn<double>("error");
    QTest::addColumn<double>("atLeast"); // times smaller
    QTest::newRow("crumple, 0.01 mm") << 150.0 << 1e-5 << 4.9;
    QTest::newRow("crumple, 0.1 mm") << 150.0 << 1e-4 << 8.7;
    QTest::newRow("violent, 0.01 mm") << 1500.0 << 1e-5 << 4.9;
    QTest::newRow("violent, 0.1 mm") << 1500.0 << 1e-4 << 8.7;
}

void TestFrameCodec::violentTakesAreWithinTheErrorAndSmall() {
    QFETCH(double, density);
    QFETCH(double, error);
    QFETCH(double, atLeast);
    static std::map<double, std::vector<PointArray>> runs;
    std::vector<PointArray>& frames = runs[density];
    if (frames.empty()) {
        Scene scene = test::shippedScene("selfCollision");
        scene.cloth.density = density;
        frames = positionsIn(test::runFrames(scene, 300));
        QCOMPARE(int(frames.size()), 301);
    }
    const auto groups = packAll(frames, {50, 50}, error);
    const double worst = worstOf(frames, groups);
    QVERIFY2(worst <= error && worst > 0.9 * error, qPrintable(QString::number(worst)));
    QVERIFY2(ratio(groups) >= atLeast, qPrintable(QString::number(ratio(groups))));
}

void TestFrameCodec::anyPlaceIsWithinTheError_data() {
    QTest::addColumn<double>("middle");
    QTest::addColumn<double>("spread");
    QTest::addColumn<double>("error");
    QTest::newRow("a kilometre wide") << 0.0 << 1e3 << 1e-5;
    QTest::newRow("far out") << 1e6 << 1.0 << 1e-5;
    QTest::newRow("wider than 32 bits") << -1e6 << 9e5 << 1e-5;
    QTest::newRow("beyond all steps") << 1e12 << 1e3 << 1e-5;
    QTest::newRow("tiny error") << 0.0 << 1.0 << 1e-15;
    QTest::newRow("huge error") << 0.0 << 1.0 << 1e3;
    QTest::newRow("greatest numbers") << 0.0 << 1e308 << 1e-5;
}

void TestFrameCodec::anyPlaceIsWithinTheError() {
    QFETCH(double, middle);
    QFETCH(double, spread);
    QFETCH(double, error);
    SplitMix64 random(7);
    std::vector<PointArray> frames;
    for (int i = 0; i < 20; ++i) // some near, some far
        frames.push_back(randomPoints(random, 35, i % 3 == 0 ? 0 : middle, i % 3 == 0 ? 1 : spread));
    const double worst = worstOf(frames, packAll(frames, {7, 5}, error));
    QVERIFY2(worst <= error, qPrintable(QString::number(worst)));
}

void TestFrameCodec::losslessKeepsEveryBit() {
    SplitMix64 random(11);
    std::vector<PointArray> frames;
    for (int i = 0; i < 19; ++i) {
        frames.push_back(randomPoints(random, 35, 0, i % 5 == 0 ? 1e300 : 1));
        frames.back().x[3] = -0.0;
        frames.back().y[4] = std::numeric_limits<double>::denorm_min();
    }
    const auto groups = packAll(frames, {7, 5}, 0);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const auto unpacked = positionsOf(groups[i / kFramesPerGroup], int(i));
        QVERIFY(unpacked);
        QVERIFY(stateHash({*unpacked, {}}) == stateHash({frames[i], {}}));
    }
}

void TestFrameCodec::whatIsNotFiniteKeepsItsBits() {
    SplitMix64 random(5);
    for (const int broken : {0, 8, 3, 15}) {
        std::vector<PointArray> frames;
        for (int i = 0; i < 16; ++i)
            frames.push_back(randomPoints(random, 35, 0, 1));
        frames[std::size_t(broken)].x[0] = std::numeric_limits<double>::quiet_NaN();
        frames[std::size_t(broken)].z[34] = -std::numeric_limits<double>::infinity();
        const auto groups = packAll(frames, {7, 5}, 1e-5);
        for (int i = 0; i < 16; ++i) {
            const auto unpacked = positionsOf(groups[0], i);
            QVERIFY(unpacked);
            if (i == broken)
                QVERIFY(stateHash({*unpacked, {}}) == stateHash({frames[std::size_t(i)], {}}));
            else
                QVERIFY(test::greatestDifference(*unpacked, frames[std::size_t(i)]) <= 1e-5);
        }
    }
}

void TestFrameCodec::anyGridAndNumberOfFrames() {
    SplitMix64 random(3);
    for (const Grid grid :
         {Grid{1, 1}, Grid{1, 9}, Grid{70, 1}, Grid{2, 2}, Grid{32, 3}, Grid{33, 4}, Grid{65, 2}})
        for (int count = 1; count <= kFramesPerGroup; ++count) {
            std::vector<PointArray> frames;
            for (int i = 0; i < count; ++i)
                frames.push_back(randomPoints(random, std::size_t(grid.pointCount()), 0.2 * i, 0.01));
            const double worst = worstOf(frames, packAll(frames, grid, 1e-4));
            QVERIFY2(
                worst <= 1e-4,
                qPrintable(
                    QString("%1x%2, %3 frames: %4").arg(grid.width).arg(grid.height).arg(count).arg(worst)));
        }
}

void TestFrameCodec::fiveFramesAtMostAreUnpacked() {
    SplitMix64 random(9);
    std::vector<PointArray> frames;
    for (int i = 0; i < kFramesPerGroup; ++i)
        frames.push_back(randomPoints(random, 35, 0.001 * i, 0.0001));
    FramePacker packer({7, 5}, 1e-5);
    std::vector<const PointArray*> pointers;
    for (const PointArray& frame : frames)
        pointers.push_back(&frame);
    const std::vector<std::string> packed = packer.pack(pointers);
    for (int i = 0; i < kFramesPerGroup; ++i) {
        int asked = 0;
        FrameUnpacker unpacker({7, 5}, 1e-5, kFramesPerGroup, [&](int index) {
            ++asked;
            return std::optional(packed[std::size_t(index)]);
        });
        QVERIFY(unpacker.positions(i));
        QVERIFY(asked >= 1 && asked <= 5);
        for (int again = 0; again < kFramesPerGroup; ++again)
            QVERIFY(unpacker.positions(again));
        QCOMPARE(asked, kFramesPerGroup); // each once
    }
}

void TestFrameCodec::trimmedGroupsKeepTheirFrames() {
    SplitMix64 random(13);
    std::vector<PointArray> frames;
    for (int i = 0; i < 16; ++i)
        frames.push_back(randomPoints(random, 35, 0, 1));
    FrameGroup group = packAll(frames, {7, 5}, 1e-5)[0];
    trimGroup(group, 11);
    trimGroup(group, 6);
    QCOMPARE(group.end(), 6);
    for (int i = 0; i < 6; ++i)
        QVERIFY(test::greatestDifference(*positionsOf(group, i), frames[std::size_t(i)]) <= 1e-5);
    QVERIFY(!positionsOf(group, 6));
    QVERIFY(!positionsOf(group, -1));
}

// Whatever the bytes: no crash, and no more than the grid.
void TestFrameCodec::otherBytesAreNoFrames() {
    SplitMix64 random(17);
    std::vector<PointArray> frames;
    for (int i = 0; i < 16; ++i)
        frames.push_back(randomPoints(random, 35, 0, i % 4 == 3 ? 1e200 : 1));
    std::vector<const PointArray*> pointers;
    for (const PointArray& frame : frames)
        pointers.push_back(&frame);
    const std::vector<std::string> packed = FramePacker({7, 5}, 1e-5).pack(pointers);
    for (int trial = 0; trial < 3000; ++trial) {
        std::vector<std::string> damaged = packed;
        std::string& bytes = damaged[std::size_t(random.integer(0, 15))];
        if (random.chance(0.3))
            bytes.resize(std::size_t(random.integer(0, int(bytes.size()))));
        else
            for (int flips = random.integer(1, 4); flips > 0; --flips)
                bytes[std::size_t(random.integer(0, int(bytes.size()) - 1))] =
                    char(random.integer(-128, 127));
        FrameUnpacker unpacker({7, 5}, 1e-5, 16,
                               [&](int index) { return std::optional(damaged[std::size_t(index)]); });
        for (int i = 0; i < 16; ++i)
            if (const auto positions = unpacker.positions(i))
                QCOMPARE(int(positions->size()), 35);
    }
    QCOMPARE(int(groupOrder(1).size()), 1);
}

QTEST_APPLESS_MAIN(TestFrameCodec)
#include "tst_frame_codec.moc"
