// Which frames are stale, by the words of the class comment, and any sequence of operations against a plain
// list of frames.
#include "app/simulation/simulation.h"

#include "tests/support/tiny_scene.h"

#include <QSignalSpy>
#include <QTest>

#include <random>

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

// Frames as the stiffness each was computed with, and the edits that made some of them stale.
struct ListOfFrames {
    struct Mark {
        double before; // stiffness before the edit
        int stale;     // first stale frame before it
    };
    std::vector<double> frames;
    int shown = 0;
    int stale = 1;
    std::vector<Mark> marks;

    explicit ListOfFrames(double ks) : frames{ks} {}
    int count() const { return int(frames.size()); }

    void changed(double before, double after) {
        if (before == after)
            return;
        for (std::size_t i = 0; i < marks.size(); ++i)
            if (marks[i].before == after) { // this and all edits since are undone
                stale = marks[i].stale;
                marks.resize(i);
                return;
            }
        const int first = std::min(stale, shown + 1);
        bool same = true;
        for (int i = first; i < count(); ++i)
            same = same && frames[std::size_t(i)] == after;
        if (same) {
            stale = count();
            return;
        }
        if (first < stale)
            marks.push_back({before, stale});
        stale = first;
    }

    void replaceStale() {
        if (stale == count())
            return;
        frames.resize(std::size_t(stale));
        marks.clear();
        shown = std::min(shown, count() - 1);
    }

    void record(double ks) {
        frames.push_back(ks);
        marks.clear();
        stale = count();
        shown = count() - 1;
    }
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

    void simulatingReplacesStaleFrames() {
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
        QCOMPARE(run.simulation.shownFrame()->scene->cloth.ks, 1.0);
    }

    void playingReplacesStaleFrames() {
        Run run;
        run.record(5);
        run.simulation.showFrame(2);
        run.setKs(1);
        run.simulation.showFrame(4);
        run.simulation.play();
        QCOMPARE(run.count(), 3);
        QCOMPARE(run.simulation.currentFrame(), 2); // the last that is still there
        QTRY_VERIFY_WITH_TIMEOUT(run.count() > 5, 60'000);
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

    void anySequenceIsAListOfFrames_data() {
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 1; seed <= 12; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void anySequenceIsAListOfFrames() {
        QFETCH(unsigned, seed);
        std::mt19937 random(seed);
        const auto below = [&](int n) { return int(random() % unsigned(n)); };
        Run run;
        const auto ks = [&] { return run.document.scene().cloth.ks; };
        ListOfFrames model(ks());
        for (int i = 0; i < 400; ++i) {
            const int dice = below(20);
            const double before = ks();
            const int points = run.document.scene().cloth.numHeightPoints;
            if (dice < 5) {
                run.record(1);
                model.replaceStale();
                model.record(ks());
            } else if (dice < 9) {
                const int frame = below(model.count() + 4) - 2;
                run.simulation.showFrame(frame);
                model.shown = std::clamp(frame, 0, model.count() - 1);
            } else if (dice < 13) {
                run.setKs(100 + below(3));
            } else if (dice < 16 && run.document.undoStack().index() > 1) { // not the first sheet
                run.undo();
            } else if (dice < 18) {
                run.redo();
            } else if (dice == 18 && below(4) == 0) {
                run.simulation.restart();
                model = ListOfFrames(ks());
            } else if (dice == 19 && below(6) == 0) {
                QVERIFY(!run.document.setParameter(*findParameter("cloth.num_height_points"), 2 + below(4)));
            } else {
                Scene scene = run.document.scene();
                scene.appearance.springsOverSurface = !scene.appearance.springsOverSurface;
                run.document.edit("look", scene);
            }
            if (run.document.scene().cloth.numHeightPoints != points)
                model = ListOfFrames(ks());
            else
                model.changed(before, ks());
            verifyAlike(run, model, QByteArray("operation ") + QByteArray::number(i));
            if (QTest::currentTestFailed())
                return;
        }
    }

private:
    static void verifyAlike(const Run& run, const ListOfFrames& model, const QByteArray& where) {
        QVERIFY2(run.count() == model.count(), where);
        QVERIFY2(run.simulation.currentFrame() == model.shown, where);
        QVERIFY2(run.stale() == model.stale, where);
        for (int frame = 0; frame < run.count(); ++frame)
            QVERIFY2(run.simulation.recording().frame(frame).scene->cloth.ks ==
                         model.frames[std::size_t(frame)],
                     where);
        // Each frame follows the one before it: whatever was replaced, no seam shows.
        if (run.count() < 2)
            return;
        const FramePointer last = run.simulation.look(run.count() - 1);
        VerletSolver solver(*last->scene);
        ClothState state = run.simulation.recording().frame(run.count() - 2).exact->state;
        for (int i = 0; i < last->scene->simulation.stepsPerFrame; ++i)
            solver.step(state);
        QVERIFY2(state == last->state, where);
    }
};

QTEST_GUILESS_MAIN(TestSimulationStaleness)
#include "tst_simulation_staleness.moc"
