// Packed states: every bit, or nothing.
#include "simcore/recording/state_codec.h"
#include "tests/support/random.h"
#include "tests/support/recorded_run.h"
#include "tests/support/shipped_scene.h"

#include <QtTest>

#include <bit>

using namespace clothlab;

class TestStateCodec : public QObject {
    Q_OBJECT

private slots:
    void everyBitIsKept() {
        SplitMix64 random(1);
        ClothState state{PointArray(35), PointArray(35)};
        for (PointArray* points : {&state.position, &state.lastPosition})
            for (const auto axis : {&PointArray::x, &PointArray::y, &PointArray::z})
                for (double& value : points->*axis)
                    value = std::bit_cast<double>(random.next()); // also what is no number
        const std::string bytes = packState({7, 5}, state);
        const auto unpacked = unpackState({7, 5}, bytes);
        QVERIFY(unpacked);
        QCOMPARE(stateHash(*unpacked), stateHash(state));
        QVERIFY(!unpackState({7, 5}, bytes + '\0'));
        QVERIFY(!unpackState({7, 6}, bytes));
        for (std::size_t length = 0; length < bytes.size(); length += 3)
            QVERIFY(!unpackState({7, 5}, std::string_view(bytes).substr(0, length)));
    }
    void runsArePackedSmaller() {
        const auto run = test::runFrames(test::shippedScene("sphere"), 60);
        const ClothState& state = run.back()->state;
        const std::string bytes = packState({50, 50}, state);
        QVERIFY(*unpackState({50, 50}, bytes) == state);
        QVERIFY2(double(bytes.size()) < 0.8 * 48 * 2500, qPrintable(QString::number(bytes.size())));
    }
};

QTEST_APPLESS_MAIN(TestStateCodec)
#include "tst_state_codec.moc"
