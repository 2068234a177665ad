// Takes, by the words of Recording: what is kept, what is stale, and what opens what.
#include "simcore/recording/recording.h"

#include <QtTest>

using namespace clothlab;

namespace {

std::shared_ptr<const Scene> sceneOf(double ks, double width = 1) {
    auto scene = std::make_shared<Scene>();
    scene->cloth.numWidthPoints = 3;
    scene->cloth.numHeightPoints = 2;
    scene->cloth.width = width;
    scene->cloth.ks = ks;
    return scene;
}

// Frames that name their place by their time; nothing is simulated.
void record(Recording& recording, int frames) {
    for (int i = 0; i < frames; ++i) {
        Frame frame;
        frame.state = startState(*recording.scene());
        frame.scene = recording.scene();
        frame.time = recording.endOfRun() + 1;
        recording.append(std::make_shared<const Frame>(std::move(frame)));
        recording.show(recording.lastFrame());
    }
}

QStringList names(const Recording& recording) {
    QStringList list;
    for (const TakePointer& take : recording.takes())
        list << QString::fromStdString(take->name());
    return list;
}

} // namespace

class TestRecording : public QObject {
    Q_OBJECT

private slots:
    void beginsWithAStart();
    void aBranchKeepsWhatWasThere();
    void aBranchOfABranch();
    void aBranchWithinTheSharedFramesIsOneOfTheParent();
    void restartKeepsTheTake();
    void anotherSheetOpensATakeAndBackTheOldOne();
    void emptyTakesGo();
    void appearanceChangesNothing();
    void aViewBringsBackWhatWasStale();
    void openingATakeBringsBackItsScene();
    void theOpenTakeStays();
    void branchesOfARemovedTakeStay();
    void takesComeBackInTheirPlace();
    void exactFramesAreKeptUntilTheyArePacked();
};

void TestRecording::beginsWithAStart() {
    const Recording recording(sceneOf(1));
    QCOMPARE(recording.frameCount(), 1);
    QCOMPARE(recording.firstStaleFrame(), 1);
    QCOMPARE(recording.endOfRun(), 0);
    QCOMPARE(names(recording), QStringList{"Take 1"});
    QVERIFY(recording.frame(0).exact->state == startState(*sceneOf(1)));
    QVERIFY(!recording.take()->parent());
}

void TestRecording::aBranchKeepsWhatWasThere() {
    Recording recording(sceneOf(1));
    record(recording, 5);
    const TakePointer first = recording.take();
    recording.show(2);
    QCOMPARE(recording.setScene(sceneOf(2)), Recording::Effect::Staleness);
    QCOMPARE(recording.firstStaleFrame(), 3);
    QCOMPARE(recording.take(), first); // until a frame is recorded
    record(recording, 1);
    QVERIFY(recording.take() != first);
    QCOMPARE(recording.take()->parent(), first);
    QCOMPARE(recording.take()->branchFrame(), 2);
    QCOMPARE(recording.frameCount(), 4);
    QCOMPARE(recording.firstStaleFrame(), 4);
    QCOMPARE(first->frameCount(), 6);
    QCOMPARE(&recording.frame(2), &std::as_const(*first).frame(2)); // shared
    QCOMPARE(recording.frame(3).scene->cloth.ks, 2.0);
    QCOMPARE(std::as_const(*first).frame(3).scene->cloth.ks, 1.0);
    QCOMPARE(names(recording), (QStringList{"Take 1", "Take 2"}));
}

void TestRecording::aBranchOfABranch() {
    Recording recording(sceneOf(1));
    record(recording, 5);
    recording.show(2);
    recording.setScene(sceneOf(2));
    record(recording, 4);
    const TakePointer second = recording.take();
    recording.show(5);
    recording.setScene(sceneOf(3));
    record(recording, 1);
    QCOMPARE(recording.take()->parent(), second);
    QCOMPARE(recording.take()->branchFrame(), 5);
    const std::vector<double> ks{1, 1, 1, 2, 2, 2, 3};
    for (int i = 0; i < recording.frameCount(); ++i) {
        QCOMPARE(recording.frame(i).scene->cloth.ks, ks[std::size_t(i)]);
        QCOMPARE(recording.frame(i).time, double(i));
    }
}

void TestRecording::aBranchWithinTheSharedFramesIsOneOfTheParent() {
    Recording recording(sceneOf(1));
    record(recording, 5);
    const TakePointer first = recording.take();
    for (const int frame : {3, 1, 3}) { // the last one where the second branched off, seen from the third
        recording.setView(recording.viewOf(recording.takes().back()));
        recording.show(std::min(frame, recording.lastFrame()));
        recording.setScene(sceneOf(10 + double(recording.takes().size())));
        record(recording, 1);
    }
    QCOMPARE(recording.takes()[1]->parent(), first);
    QCOMPARE(recording.takes()[2]->parent(), first);
    QCOMPARE(recording.takes()[2]->branchFrame(), 1);
}

void TestRecording::restartKeepsTheTake() {
    Recording recording(sceneOf(1));
    record(recording, 3);
    const TakePointer first = recording.take();
    recording.restart();
    QCOMPARE(recording.frameCount(), 1);
    QVERIFY(!recording.take()->parent());
    QCOMPARE(first->frameCount(), 4);
    recording.restart(); // nothing was recorded: no third
    QCOMPARE(names(recording), (QStringList{"Take 1", "Take 2"}));
}

void TestRecording::anotherSheetOpensATakeAndBackTheOldOne() {
    Recording recording(sceneOf(1));
    record(recording, 5);
    const TakePointer first = recording.take();
    recording.show(3);
    QCOMPARE(recording.setScene(sceneOf(1, 2)), Recording::Effect::OtherTake);
    QCOMPARE(recording.frameCount(), 1);
    QCOMPARE(recording.take()->sheet().start, startState(*sceneOf(1, 2)).position);
    recording.setScene(sceneOf(1, 3));
    QCOMPARE(recording.takes().size(), std::size_t(2));
    QCOMPARE(recording.setScene(sceneOf(1)), Recording::Effect::OtherTake);
    QCOMPARE(recording.take(), first);
    QCOMPARE(recording.shownFrame(), 3);
    QCOMPARE(recording.firstStaleFrame(), 6);
    QCOMPARE(recording.takes().size(), std::size_t(1));

    recording.setScene(sceneOf(1, 2));
    record(recording, 2); // now both are kept
    recording.setScene(sceneOf(7));
    QCOMPARE(recording.take(), first);
    QCOMPARE(recording.firstStaleFrame(), 4); // the stiffness was changed while frame 3 was shown
    QCOMPARE(recording.takes().size(), std::size_t(2));
    recording.setScene(sceneOf(7, 2));
    QCOMPARE(recording.frameCount(), 3);
}

void TestRecording::emptyTakesGo() {
    Recording recording(sceneOf(1));
    for (int i = 2; i < 10; ++i)
        recording.setScene(sceneOf(1, i));
    QCOMPARE(recording.takes().size(), std::size_t(1));
    QCOMPARE(names(recording), QStringList{"Take 1"});
    QVERIFY(recording.take()->id() > 1); // no number comes twice
}

void TestRecording::appearanceChangesNothing() {
    Recording recording(sceneOf(1));
    record(recording, 5);
    recording.show(1);
    auto scene = std::make_shared<Scene>(*recording.scene());
    scene->appearance.shader = "Normal";
    scene->camera.emplace();
    QCOMPARE(recording.setScene(scene), Recording::Effect::None);
    QCOMPARE(recording.firstStaleFrame(), 6);
    QCOMPARE(recording.scene(), std::shared_ptr<const Scene>(scene));
}

void TestRecording::aViewBringsBackWhatWasStale() {
    Recording recording(sceneOf(1));
    record(recording, 5);
    recording.show(2);
    recording.setScene(sceneOf(2));
    const Recording::View view = recording.view();
    recording.restart();
    recording.setView(view);
    QCOMPARE(recording.firstStaleFrame(), 3);
    QCOMPARE(recording.shownFrame(), 2);
    recording.setScene(sceneOf(1)); // and the edit can still be undone
    QCOMPARE(recording.firstStaleFrame(), 6);
}

void TestRecording::openingATakeBringsBackItsScene() {
    Recording recording(sceneOf(1));
    record(recording, 5);
    const TakePointer first = recording.take();
    recording.show(2);
    auto other = std::make_shared<Scene>(*sceneOf(2));
    other->appearance.shader = "Normal";
    recording.setScene(other);
    record(recording, 6);
    recording.setView(recording.viewOf(first));
    QCOMPARE(recording.take(), first);
    QCOMPARE(recording.shownFrame(), 5); // it has no frame 8
    QCOMPARE(recording.firstStaleFrame(), 6);
    QCOMPARE(recording.scene()->cloth.ks, 1.0);
    QCOMPARE(recording.scene()->appearance.shader, std::string("Normal"));
}

void TestRecording::theOpenTakeStays() {
    Recording recording(sceneOf(1));
    QVERIFY(!recording.remove(recording.take()));
    QCOMPARE(recording.takes().size(), std::size_t(1));
}

void TestRecording::branchesOfARemovedTakeStay() {
    Recording recording(sceneOf(1));
    record(recording, 5);
    TakePointer first = recording.take();
    recording.show(2);
    recording.setScene(sceneOf(2));
    record(recording, 3);
    TakePointer second = recording.take();
    recording.show(4);
    recording.setScene(sceneOf(3));
    record(recording, 1);
    QVERIFY(recording.remove(second));
    QCOMPARE(recording.listedParent(*recording.take()), first);
    const std::weak_ptr<Take> watched = second;
    second.reset();
    QCOMPARE(recording.frame(4).scene->cloth.ks, 2.0);
    QVERIFY(recording.findAnyTake(2) != nullptr);
    QVERIFY(!recording.findTake(2));
    QVERIFY(recording.remove(first));
    QVERIFY(!recording.listedParent(*recording.take()));
    first.reset();
    QCOMPARE(recording.frame(0).time, 0.0);
    QVERIFY(!watched.expired());
    recording.reset(sceneOf(1));
    QVERIFY(watched.expired());
    QVERIFY(!recording.findAnyTake(2));
}

void TestRecording::takesComeBackInTheirPlace() {
    Recording recording(sceneOf(1));
    for (int i = 0; i < 3; ++i) {
        record(recording, 2);
        recording.restart();
    }
    const TakePointer second = recording.takes()[1];
    QVERIFY(recording.remove(second));
    recording.insert(second);
    recording.insert(second);
    QCOMPARE(names(recording), (QStringList{"Take 1", "Take 2", "Take 3", "Take 4"}));
}

void TestRecording::exactFramesAreKeptUntilTheyArePacked() {
    Recording recording(sceneOf(1));
    record(recording, 10);
    const std::size_t one = recording.bytesKept() / 10;
    QCOMPARE(recording.bytesKept(), 10 * bytesOf(*recording.frame(1).exact));
    recording.trim(0);
    QCOMPARE(recording.bytesKept(), 10 * one);
    const auto group = std::make_shared<const FrameGroup>();
    for (int i = 1; i <= 6; ++i)
        recording.take()->frame(i).group = group;
    recording.trim(7 * one);
    QCOMPARE(recording.bytesKept(), 7 * one);
    QVERIFY(!recording.frame(3).exact);
    QVERIFY(recording.frame(4).exact);
    recording.trim(0);
    QCOMPARE(recording.bytesKept(), 4 * one);
    recording.keep(recording.take(), 2, startFrame(sceneOf(1)));
    QCOMPARE(recording.bytesKept(), 5 * one);
    QVERIFY(recording.frame(2).exact);
    QVERIFY(recording.frame(0).exact); // the start always stays
}

QTEST_APPLESS_MAIN(TestRecording)
#include "tst_recording.moc"
