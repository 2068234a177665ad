// Which frames are stale, by the words of Recording.
#include "app/simulation/simulation.h"

#include "tests/support/tiny_scene.h"

#include <QSignalSpy>
#include <QTest>

using namespace clothlab;

namespace {

struct Run {
    Document document;
    Simulation simulation{document};
    QSignalSpy notices{&simulation, &Simulation::notice};
    QSignalSpy changes{&simulation, &Simulation::recordingChanged};

    Run() { document.edit("sheet", test::tinyScene()); }

    void setKs(double ks) { QVERIFY(!document.setParameter(*findParameter("cloth.ks"), ks)); }
    void undo() { document.undoStack().undo(); }
    void redo() { document.undoStack().redo(); }
    void record(int frames) {
        QSignalSpy shown(&simulation, &Simulation::frameShown);
        for (int i = 0; i < frames; ++i) {
            simulation.simulateFrame();
            shown.clear(); // of what simulateFrame() itself showed
            QVERIFY(shown.wait(60'000));
            QVERIFY(!simulation.isSimulating());
        }
    }
    int count() const { return simulation.recording().frameCount(); }
    int stale() const { return simulation.firstStaleFrame(); }
};

} // namespace

class TestSimulationStaleness : public QObject {
    Q_OBJECT
private slots:
    void anEditWhileAnEarlierFrameIsShownMakesLaterOnesStale() {
        Run run;
        run.record(5);
        run.simulation.showFrame(2);
        run.changes.clear();
        run.setKs(1);
        QCOMPARE(run.stale(), 3);
        QCOMPARE(run.count(), 6); // still there
        QCOMPARE(run.simulation.currentFrame(), 2);
        QVERIFY(run.changes.count() >= 1);
        run.simulation.showFrame(5); // and can be looked at
        QCOMPARE(run.simulation.currentFrame(), 5);
        QCOMPARE(run.stale(), 3);
        run.setKs(2); // while a stale frame is shown: no fewer are
        QCOMPARE(run.stale(), 3);
    }

    void undoingMakesThemCurrent() {
        Run run;
        run.record(5);
        run.simulation.showFrame(2);
        run.setKs(1);
        run.setKs(2);
        run.undo();
        QCOMPARE(run.stale(), 3);
        run.simulation.showFrame(4); // from wherever
        run.undo();
        QCOMPARE(run.stale(), 6);
        run.redo();
        QCOMPARE(run.stale(), 5); // now the edit happens while frame 4 is shown
        QCOMPARE(run.notices.count(), 0);
    }

    void typingTheOldValueIsUndoingToo() {
        Run run;
        run.record(3);
        run.simulation.showFrame(0);
        run.setKs(1);
        run.setKs(5000);
        QCOMPARE(run.stale(), 4);
    }

    // The frames of one run may have been computed with several scenes.
    void undoingMakesThemCurrentAfterEditsAtTheEnd() {
        Run run;
        run.record(3);
        run.setKs(100);
        run.record(2);
        run.simulation.showFrame(1);
        run.setKs(7);
        QCOMPARE(run.stale(), 2);
        run.undo();
        QCOMPARE(run.stale(), 6);
        run.undo(); // of the edit at the end: frames 4 and 5 no longer follow
        QCOMPARE(run.stale(), 2);
        run.redo();
        QCOMPARE(run.stale(), 6);
    }

    void undoingTheSecondOfTwoEditsLeavesTheFirst() {
        Run run;
        run.record(6);
        run.simulation.showFrame(4);
        run.setKs(1);
        run.simulation.showFrame(2);
        run.setKs(2);
        QCOMPARE(run.stale(), 3);
        run.undo();
        QCOMPARE(run.stale(), 5);
        run.undo();
        QCOMPARE(run.stale(), 7);
    }

    void editsAtTheEndMakeNothingStale() {
        Run run;
        run.record(3);
        run.setKs(1);
        QCOMPARE(run.stale(), 4);
        run.undo();
        QCOMPARE(run.stale(), 4);
        run.redo();
        run.simulation.showFrame(1); // nor does looking back
        QCOMPARE(run.stale(), 4);
        run.undo(); // to what all frames were computed with
        QCOMPARE(run.stale(), 4);
        QCOMPARE(run.count(), 4);
    }

    void editsOfAppearanceMakeNothingStale() {
        Run run;
        run.record(3);
        run.simulation.showFrame(0);
        Scene scene = run.document.scene();
        scene.appearance.shader = "Normal";
        scene.camera.emplace();
        run.changes.clear();
        run.document.edit("look", scene);
        run.undo();
        run.redo();
        QCOMPARE(run.stale(), 4);
        QCOMPARE(run.changes.count(), 0);
        run.setKs(1);
        run.document.edit("look", [&] {
            Scene other = run.document.scene();
            other.appearance.shader = "Phong";
            return other;
        }());
        QCOMPARE(run.stale(), 1);
        run.undo();
        run.undo();
        QCOMPARE(run.stale(), 4);
    }

    void simulatingBranchesOffStaleFrames() {
        Run run;
        run.record(5);
        run.simulation.showFrame(2);
        run.setKs(1);
        run.simulation.showFrame(5);
        run.record(1);
        QCOMPARE(run.count(), 4);
        QCOMPARE(run.stale(), 4);
        QCOMPARE(run.simulation.currentFrame(), 3);
        QCOMPARE(run.notices.count(), 1);
        QVERIFY(run.notices.at(0).at(0).toString().contains("3")); // how many
        QCOMPARE(run.simulation.recording().takes().size(), std::size_t(2));
        QCOMPARE(run.simulation.recording().takes()[0]->frameCount(), 6);
        QCOMPARE(run.simulation.shownFrame()->scene->cloth.ks, 1.0);
    }

    void playingBranchesOffStaleFrames() {
        Run run;
        run.record(5);
        run.simulation.showFrame(2);
        run.setKs(1);
        run.simulation.showFrame(4);
        run.simulation.play();
        QCOMPARE(run.simulation.currentFrame(), 2); // the last that is not stale
        QCOMPARE(run.count(), 6);                   // until another frame is there
        QTRY_VERIFY_WITH_TIMEOUT(run.simulation.recording().takes().size() == 2 && run.count() > 5, 60'000);
        run.simulation.pause();
        QCOMPARE(run.stale(), run.count());
        for (int i = 3; i < run.count(); ++i)
            QCOMPARE(run.simulation.recording().frame(i).scene->cloth.ks, 1.0);
        QCOMPARE(run.notices.count(), 1);
    }

    void editsWhilePlayingHoldFromTheNextFrames() {
        Run run;
        run.record(400);
        run.simulation.showFrame(0);
        run.simulation.play(); // of recorded frames: 0.4 s of them
        run.setKs(1);
        const int edited = run.simulation.currentFrame();
        QTRY_VERIFY_WITH_TIMEOUT(run.simulation.currentFrame() > edited + 3, 60'000);
        run.simulation.pause();
        QCOMPARE(run.simulation.recording().frame(edited + 1).scene->cloth.ks, 1.0);
        QCOMPARE(run.stale(), run.count());
    }

    // The frame under way follows the last one; when that has become stale, it must not hide that.
    void anEditDropsAFrameUnderWayBehindStaleOnes() {
        Run run;
        run.record(5);
        run.simulation.showFrame(2);
        run.simulation.simulateFrame();
        run.setKs(1);
        QTRY_VERIFY_WITH_TIMEOUT(!run.simulation.isSimulating(), 60'000);
        QCOMPARE(run.count(), 6);
        QCOMPARE(run.stale(), 3);
        run.record(1);
        QCOMPARE(run.count(), 4);
        QCOMPARE(run.simulation.shownFrame()->scene->cloth.ks, 1.0);
    }

    void anEditAtTheEndLeavesTheFrameUnderWay() {
        Run run;
        run.record(2);
        run.simulation.simulateFrame();
        run.setKs(1);
        QVERIFY(run.simulation.isSimulating());
        QTRY_VERIFY_WITH_TIMEOUT(!run.simulation.isSimulating(), 60'000);
        QCOMPARE(run.count(), 4);
        QCOMPARE(run.stale(), 4);
        QCOMPARE(run.simulation.shownFrame()->scene->cloth.ks, 5000.0); // with which it was begun
    }
};

QTEST_GUILESS_MAIN(TestSimulationStaleness)
#include "tst_simulation_staleness.moc"
