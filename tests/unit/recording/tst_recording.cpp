// The frames of a run: kept, cut off, counted, and gone on from.
#include "simcore/recording/recording.h"
#include "simcore/solver/frame_runner.h"

#include <QtTest>

using namespace clothlab;

namespace {

Scene smallScene() {
    Scene scene;
    scene.cloth.numWidthPoints = 8;
    scene.cloth.numHeightPoints = 5;
    scene.cloth.pinned = {{0, 0}, {7, 0}};
    scene.cloth.orientation = Orientation::Vertical;
    return scene;
}

FramePointer frameAt(double time, std::size_t points = 10) {
    Frame frame;
    frame.state = {PointArray(points), PointArray(points)};
    frame.time = time;
    return std::make_shared<const Frame>(std::move(frame));
}

FramePointer nextFrame(VerletSolver& solver, const Frame& before) {
    Frame frame = before;
    const std::atomic<bool> stop = false;
    frame.strainLimitCorrections = runFrame(solver, frame.state, stop).strainLimitCorrections;
    frame.time += 1.0 / solver.scene().simulation.framesPerSecond;
    return std::make_shared<const Frame>(std::move(frame));
}

Recording record(const Scene& scene, int frames) {
    VerletSolver solver(scene);
    Frame start;
    start.state = solver.start();
    start.scene = std::make_shared<const Scene>(scene);
    Recording recording;
    recording.restart(std::make_shared<const Frame>(std::move(start)));
    while (recording.lastFrame() < frames)
        recording.append(nextFrame(solver, *recording.frame(recording.lastFrame())));
    return recording;
}

std::size_t bytesOfAll(const Recording& recording) {
    std::size_t sum = 0;
    for (int i = 0; i < recording.frameCount(); ++i)
        sum += bytesOf(*recording.frame(i));
    return sum;
}

} // namespace

class TestRecording : public QObject {
    Q_OBJECT

private slots:
    void emptyAtFirst();
    void framesInOrder();
    void restartForgets();
    void truncateKeepsTheFirst();
    void framesOutliveTheRecording();
    void bytesAreThoseOfTheFrames();
    void fullBeforeTheBudgetIsExceeded();
    void bytesGrowWithTheSheet();
    void goesOnFromAnyFrameWithTheSameBits();
};

void TestRecording::emptyAtFirst() {
    const Recording recording(1000);
    QCOMPARE(recording.frameCount(), 0);
    QCOMPARE(recording.lastFrame(), -1);
    QCOMPARE(recording.bytes(), std::size_t(0));
    QCOMPARE(recording.budget(), std::size_t(1000));
    QCOMPARE(Recording().budget(), std::size_t(1) << 30U);
}

void TestRecording::framesInOrder() {
    Recording recording;
    recording.restart(frameAt(0));
    recording.append(frameAt(1));
    const FramePointer third = frameAt(2);
    recording.append(third);
    QCOMPARE(recording.frameCount(), 3);
    QCOMPARE(recording.lastFrame(), 2);
    for (int i = 0; i < 3; ++i)
        QCOMPARE(recording.frame(i)->time, double(i));
    QCOMPARE(recording.frame(2).get(), third.get()); // kept, not copied
}

void TestRecording::restartForgets() {
    Recording recording;
    recording.restart(frameAt(0));
    recording.append(frameAt(1));
    recording.restart(frameAt(7, 3));
    QCOMPARE(recording.frameCount(), 1);
    QCOMPARE(recording.frame(0)->time, 7.0);
    QCOMPARE(recording.bytes(), bytesOf(*recording.frame(0)));
}

void TestRecording::truncateKeepsTheFirst() {
    Recording recording;
    recording.restart(frameAt(0));
    for (int i = 1; i < 6; ++i)
        recording.append(frameAt(i, std::size_t(i)));
    recording.truncate(9);
    QCOMPARE(recording.frameCount(), 6);
    recording.truncate(3);
    QCOMPARE(recording.frameCount(), 3);
    QCOMPARE(recording.frame(2)->time, 2.0);
    QCOMPARE(recording.bytes(), bytesOfAll(recording));
    recording.append(frameAt(30));
    QCOMPARE(recording.frame(3)->time, 30.0);
    recording.truncate(1);
    QCOMPARE(recording.frameCount(), 1);
    QCOMPARE(recording.frame(0)->time, 0.0);
}

void TestRecording::framesOutliveTheRecording() {
    FramePointer kept;
    {
        Recording recording;
        recording.restart(frameAt(0));
        recording.append(frameAt(5));
        kept = recording.frame(1);
        recording.truncate(1);
    }
    QCOMPARE(kept->time, 5.0);
    QCOMPARE(int(kept->state.size()), 10);
}

void TestRecording::bytesAreThoseOfTheFrames() {
    Recording recording;
    recording.restart(frameAt(0, 100));
    for (int i = 1; i < 10; ++i) {
        recording.append(frameAt(i, std::size_t(10 * i)));
        QCOMPARE(recording.bytes(), bytesOfAll(recording));
    }
}

void TestRecording::fullBeforeTheBudgetIsExceeded() {
    const std::size_t one = bytesOf(*frameAt(0));
    Recording recording(3 * one + one / 2);
    recording.restart(frameAt(0));
    while (!recording.full())
        recording.append(frameAt(1));
    QCOMPARE(recording.frameCount(), 3);
    QVERIFY(recording.bytes() <= recording.budget());
    recording.truncate(2);
    QVERIFY(!recording.full());

    Recording exact(2 * one);
    exact.restart(frameAt(0));
    QVERIFY(!exact.full());
    exact.append(frameAt(1));
    QVERIFY(exact.full());
}

// Positions and last positions, three numbers each.
void TestRecording::bytesGrowWithTheSheet() {
    const std::size_t step = bytesOf(*frameAt(0, 1100)) - bytesOf(*frameAt(0, 100));
    QCOMPARE(step, std::size_t(1000 * 6 * 8));
}

void TestRecording::goesOnFromAnyFrameWithTheSameBits() {
    const Scene scene = smallScene();
    const Recording whole = record(scene, 8);
    for (int from = 0; from < 8; ++from) {
        Recording part = whole;
        part.truncate(from + 1);
        VerletSolver solver(*part.frame(from)->scene);
        while (part.lastFrame() < 8)
            part.append(nextFrame(solver, *part.frame(part.lastFrame())));
        for (int i = 0; i <= 8; ++i) {
            QCOMPARE(part.frame(i)->state, whole.frame(i)->state);
            QCOMPARE(part.frame(i)->strainLimitCorrections, whole.frame(i)->strainLimitCorrections);
        }
    }
    QVERIFY(!(whole.frame(8)->state == whole.frame(0)->state));
}

QTEST_APPLESS_MAIN(TestRecording)
#include "tst_recording.moc"
