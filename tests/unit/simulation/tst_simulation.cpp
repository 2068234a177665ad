#include "app/simulation/simulation.h"

#include "tests/support/tiny_scene.h"

#include <QSignalSpy>
#include <QTest>

using namespace clothlab;

namespace {

// A document with a tiny sheet, and its run.
struct Run {
    Document document;
    Simulation simulation;
    QSignalSpy notices{&simulation, &Simulation::notice};

    explicit Run(const Scene& scene = test::tinyScene(), std::size_t budget = kRecordingBudget)
        : simulation(document, nullptr, budget) {
        document.edit("sheet", scene);
    }

    void setKs(double ks) { QVERIFY(!document.setParameter(*findParameter("cloth.ks"), ks)); }

    // Frames as simulateFrame() makes them, from the last on.
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
    const ClothState& state(int frame) const { return simulation.recording().frame(frame).exact->state; }
};

// A run of the scene by its solver alone: the states of frames 0 … frames.
std::vector<ClothState> solved(const Scene& scene, int frames) {
    VerletSolver solver(scene);
    std::vector<ClothState> states{solver.start()};
    while (int(states.size()) <= frames) {
        ClothState state = states.back();
        for (int i = 0; i < scene.simulation.stepsPerFrame; ++i)
            solver.step(state);
        states.push_back(std::move(state));
    }
    return states;
}

} // namespace

class TestSimulation : public QObject {
    Q_OBJECT
private slots:
    void itStartsWithTheStart() {
        const Run run;
        QCOMPARE(run.count(), 1);
        QCOMPARE(run.simulation.currentFrame(), 0);
        QCOMPARE(run.simulation.firstStaleFrame(), 1);
        QVERIFY(run.state(0) == startState(run.document.scene()));
        QVERIFY(run.simulation.sheet().grid == run.document.grid());
        QVERIFY(!run.simulation.isPlaying());
        QVERIFY(!run.simulation.isSimulating());
        QVERIFY(run.simulation.blowUp().isEmpty());
    }

    void playingRecordsWhatItShows() {
        Run run;
        QList<int> shown;
        QList<int> recorded;
        connect(&run.simulation, &Simulation::frameShown, this, [&] {
            shown << run.simulation.currentFrame();
            recorded << run.simulation.recording().lastFrame();
        });
        const QSignalSpy playing(&run.simulation, &Simulation::playingChanged);
        run.simulation.play();
        QVERIFY(run.simulation.isPlaying());
        QTRY_VERIFY_WITH_TIMEOUT(shown.size() >= 12, 60'000);
        run.simulation.pause();
        QVERIFY(!run.simulation.isPlaying());
        QCOMPARE(playing.count(), 2);
        for (int i = 0; i < shown.size(); ++i) {
            QCOMPARE(shown[i], i + 1);    // none left out
            QCOMPARE(recorded[i], i + 1); // and none recorded that was not shown
        }
        const auto states = solved(run.document.scene(), run.simulation.recording().lastFrame());
        for (int i = 0; i < run.count(); ++i) {
            QVERIFY(run.state(i) == states[std::size_t(i)]);
            QVERIFY(std::abs(run.simulation.recording().frame(i).time - i / 1000.0) < 1e-9);
        }
        QVERIFY(run.simulation.lastComputedOn() != std::this_thread::get_id());
    }

    void pausingDropsWhatIsUnderWay() {
        Run run;
        run.simulation.play();
        QVERIFY(run.simulation.isSimulating());
        run.simulation.pause();
        QVERIFY(!run.simulation.isSimulating());
        run.record(1); // by now the frame that was dropped would have come as well
        QCOMPARE(run.count(), 2);

        run.simulation.simulateFrame();
        run.simulation.showFrame(0);
        QVERIFY(!run.simulation.isSimulating());
        run.record(1);
        QCOMPARE(run.count(), 3);
    }

    void pausingDropsWhatIsComputedAhead() {
        Scene slow = test::tinyScene();
        slow.simulation.framesPerSecond = 1;
        slow.simulation.stepsPerFrame = 1000;
        Run run(slow);
        run.simulation.play();
        // The first frame is shown at once; the second is there long before its second is over.
        QTRY_VERIFY_WITH_TIMEOUT(run.count() == 2 && !run.simulation.isSimulating(), 60'000);
        run.simulation.pause();
        run.setKs(1);
        run.simulation.play();
        QCOMPARE(run.count(), 2);
        QTRY_COMPARE_WITH_TIMEOUT(run.count(), 3, 60'000);
        run.simulation.pause();
        QCOMPARE(run.simulation.recording().frame(2).scene->cloth.ks, 1.0);
    }

    void pausingBetweenFramesRecordsNothingMore() {
        Run run;
        run.simulation.play();
        QTRY_VERIFY_WITH_TIMEOUT(run.count() > 3, 60'000);
        run.simulation.pause();
        const int count = run.count();
        QCOMPARE(run.simulation.currentFrame(), count - 1);
        run.simulation.showFrame(0);
        const QSignalSpy shown(&run.simulation, &Simulation::frameShown);
        QCoreApplication::processEvents();
        QCOMPARE(shown.count(), 0);
        QCOMPARE(run.count(), count);
    }

    void playingFromAnEarlierFrameShowsWhatIsRecorded() {
        Run run;
        run.record(4);
        const std::vector<FramePointer> before{run.simulation.look(1), run.simulation.look(4)};
        run.simulation.showFrame(1);
        run.simulation.play();
        QTRY_VERIFY_WITH_TIMEOUT(run.count() >= 7, 60'000);
        run.simulation.pause();
        QCOMPARE(run.simulation.look(1), before[0]);
        QCOMPARE(run.simulation.look(4), before[1]);
        QVERIFY(run.state(6) == solved(run.document.scene(), 6)[6]);
    }

    void showFrameClampsAndPauses() {
        Run run;
        run.record(3);
        run.simulation.play();
        run.simulation.showFrame(99);
        QVERIFY(!run.simulation.isPlaying());
        QCOMPARE(run.simulation.currentFrame(), run.simulation.recording().lastFrame());
        run.simulation.showFrame(-5);
        QCOMPARE(run.simulation.currentFrame(), 0);
        QCOMPARE(run.simulation.shownFrame(), run.simulation.look(0));
        run.simulation.moveBy(2);
        QCOMPARE(run.simulation.currentFrame(), 2);
        run.simulation.moveBy(-99);
        QCOMPARE(run.simulation.currentFrame(), 0);
    }

    void simulateFrameAddsOneAfterTheLast() {
        Run run;
        run.record(2);
        run.simulation.showFrame(0);
        const QSignalSpy shown(&run.simulation, &Simulation::frameShown);
        run.record(1);
        QCOMPARE(run.count(), 4);
        QCOMPARE(run.simulation.currentFrame(), 3);
        QCOMPARE(shown.count(), 1);
        QVERIFY(run.state(3) == solved(run.document.scene(), 3)[3]);
        run.simulation.simulateFrame();
        run.simulation.simulateFrame(); // while the first is under way: no second
        QTRY_VERIFY_WITH_TIMEOUT(!run.simulation.isSimulating(), 60'000);
        QCOMPARE(run.count(), 5);
    }

    void simulateFramePausesPlaying() {
        Run run;
        run.simulation.play();
        run.record(1);
        QVERIFY(!run.simulation.isPlaying());
        QCOMPARE(run.count(), 2);
        QVERIFY(run.state(1) == solved(run.document.scene(), 1)[1]);
    }

    void restartGoesBackToTheStartOfTheSceneAsItIs() {
        Run run;
        run.record(2);
        run.setKs(100);
        run.simulation.play();
        run.simulation.restart();
        QVERIFY(!run.simulation.isPlaying());
        QVERIFY(!run.simulation.isSimulating());
        QCOMPARE(run.count(), 1);
        QCOMPARE(run.simulation.currentFrame(), 0);
        QCOMPARE(run.simulation.recording().frame(0).scene, run.document.snapshot());
        run.record(2);
        QVERIFY(run.state(2) == solved(run.document.scene(), 2)[2]);
    }

    void startEditsBeginAnew_data() {
        QTest::addColumn<QString>("id");
        QTest::addColumn<double>("value");
        QTest::newRow("width") << "cloth.width" << 2.0;
        QTest::newRow("points") << "cloth.num_height_points" << 6.0;
        QTest::newRow("vertical") << "cloth.orientation" << 1.0;
    }
    void startEditsBeginAnew() {
        QFETCH(QString, id);
        QFETCH(double, value);
        Run run;
        run.record(3);
        run.simulation.play();
        const qsizetype notices = run.notices.count();
        QVERIFY(!run.document.setParameter(*findParameter(id.toStdString()), value));
        QVERIFY(!run.simulation.isPlaying());
        QVERIFY(!run.simulation.isSimulating());
        QCOMPARE(run.count(), 1);
        QCOMPARE(run.notices.count(), notices + 1);
        QVERIFY(run.state(0) == startState(run.document.scene()));
        QVERIFY(run.simulation.sheet().grid == run.document.grid());
        run.record(1);
        QVERIFY(run.state(1) == solved(run.document.scene(), 1)[1]);
        QCOMPARE(run.simulation.recording().takes().size(), 2U);
        run.document.undoStack().undo(); // back in the take of the sheet before
        QCOMPARE(run.count(), 4);
        QVERIFY(run.state(0) == startState(test::tinyScene()));
        QVERIFY(run.state(3) == solved(test::tinyScene(), 3)[3]);
    }

    void anotherSceneBeginsAnew() {
        Run run;
        run.record(2);
        run.document.newScene();
        QCOMPARE(run.count(), 1);
        QVERIFY(run.state(0) == startState(run.document.scene()));
    }

    // Bit for bit, by scrubbing back and running over the end again, and by pauses at any place.
    void goingOnIsTheSameAsNeverHavingStopped() {
        Run run;
        const auto states = solved(run.document.scene(), 9);
        run.record(3);
        run.simulation.showFrame(1);
        run.record(1);
        run.simulation.play();
        QTRY_VERIFY_WITH_TIMEOUT(run.count() > 6, 60'000);
        run.simulation.pause();
        run.record(std::max(0, 10 - run.count()));
        for (int i = 0; i < std::min(run.count(), 10); ++i)
            QVERIFY2(run.state(i) == states[std::size_t(i)], qPrintable(QString::number(i)));

        run.simulation.showFrame(4);
        run.setKs(123);
        run.simulation.simulateFrame(); // the frames after 4 go; the run goes on from 4 with other springs
        QTRY_VERIFY_WITH_TIMEOUT(!run.simulation.isSimulating(), 60'000);
        QCOMPARE(run.count(), 6);
        Scene softer = test::tinyScene();
        softer.cloth.ks = 123;
        VerletSolver solver(softer);
        ClothState state = states[4];
        for (int i = 0; i < softer.simulation.stepsPerFrame; ++i)
            solver.step(state);
        QVERIFY(run.state(5) == state);
    }

    void aFullRecordingStopsWithANotice() {
        Scene scene = test::tinyScene();
        scene.cloth.numWidthPoints = scene.cloth.numHeightPoints = 30;
        const std::size_t frame = bytesOf(*startFrame(std::make_shared<const Scene>(scene)));
        Run run(scene, 8 * frame);
        run.simulation.play();
        QTRY_VERIFY_WITH_TIMEOUT(!run.simulation.isPlaying(), 60'000);
        const int count = run.count();
        QVERIFY2(count > 8, "packed frames take less"); // and the last exact ones are half of it
        QVERIFY(!run.simulation.isSimulating());
        QVERIFY(run.simulation.bytesInMemory() <= 9 * frame);
        QCOMPARE(run.notices.count(), 1);
        QVERIFY(run.notices.at(0).at(0).toString().contains("full"));
        run.simulation.simulateFrame();
        QCOMPARE(run.notices.count(), 2);
        QCOMPARE(run.count(), count);
    }

    void aBlowUpStopsWithWords() {
        Run run(test::unstableScene());
        const QSignalSpy told(&run.simulation, &Simulation::blowUpChanged);
        run.simulation.play();
        QTRY_VERIFY_WITH_TIMEOUT(!run.simulation.blowUp().isEmpty(), 60'000);
        QVERIFY(!run.simulation.isPlaying());
        QCOMPARE(told.count(), 1);
        const int last = run.simulation.recording().lastFrame();
        QVERIFY(last >= 1);
        QCOMPARE(run.simulation.currentFrame(), last); // the last good one
        QVERIFY(run.state(last) == solved(run.document.scene(), last)[std::size_t(last)]);
        const QString words = run.simulation.blowUp();
        QVERIFY2(words.contains(QString("frame %1,").arg(last + 1)), qPrintable(words));
        static const QRegularExpression place("step [1-3],.* point (\\d+) \\((\\d), (\\d)\\)");
        const QRegularExpressionMatch match = place.match(words);
        QVERIFY2(match.hasMatch(), qPrintable(words));
        QCOMPARE(match.captured(1).toInt(), match.captured(3).toInt() * 4 + match.captured(2).toInt());

        QVERIFY2(words.contains("beyond 2.00: at least "), qPrintable(words));

        run.simulation.showFrame(0); // looking around does not forget it
        QCOMPARE(run.simulation.blowUp(), words);
        run.simulation.showFrame(last);
        run.setKs(5000); // a remedy does
        QVERIFY(run.simulation.blowUp().isEmpty());
        QCOMPARE(run.count(), last + 1);
    }
};

QTEST_GUILESS_MAIN(TestSimulation)
#include "tst_simulation.moc"
