// From any frame of a take, however it is kept, a run goes on with the same bits as if it had never stopped.
#include "app/simulation/simulation.h"

#include "tests/support/shipped_scene.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <random>

using namespace clothlab;

namespace {

constexpr int kPatience = 120'000; // ms
constexpr int kFrames = 100;

struct Run {
    QTemporaryDir folder;
    Document document;
    Simulation simulation;

    // Memory for few exact frames; the rest is packed, and much of that is in the journal only.
    explicit Run(const Scene& scene)
        : simulation((document.setScene(scene, {}), document), nullptr,
                     12 * bytesOf(*startFrame(std::make_shared<const Scene>(scene)))) {
        simulation.setJournals([this] { return folder.filePath("journal.clothtake"); });
    }

    void record() {
        QSignalSpy shown(&simulation, &Simulation::frameShown);
        simulation.simulateFrame();
        QVERIFY(simulation.isSimulating());
        while (simulation.isSimulating())
            QVERIFY(shown.wait(kPatience));
    }
    void edit(const char* parameter, double value) {
        QVERIFY(!document.setParameter(*findParameter(parameter), value));
    }
    void waitUntilPacked() {
        bool packed = false;
        simulation.whenPacked([&] { packed = true; });
        QTRY_VERIFY_WITH_TIMEOUT(packed, kPatience);
    }
};

// A run with edits while it runs: something is changed about every ten frames.
void recordWithEdits(Run& run, std::mt19937& random) {
    const auto below = [&](int n) { return int(random() % unsigned(n)); };
    while (run.simulation.recording().lastFrame() < kFrames) {
        if (below(10) == 0)
            run.edit("cloth.ks", 2000 + 1000 * below(5));
        if (below(20) == 0)
            run.edit("cloth.damping", 0.1 * below(5));
        if (below(30) == 0)
            run.edit("simulation.gravity[0]", below(5) - 2);
        run.record();
        if (QTest::currentTestFailed())
            return;
    }
}

} // namespace

class TestExactness : public QObject {
    Q_OBJECT
private slots:
    void everyFrameIsHadAgain_data() {
        QTest::addColumn<QString>("scene");
        for (const char* scene : {"pinned2", "pinned4", "sphere", "plane", "selfCollision"})
            QTest::newRow(scene) << scene;
    }
    void everyFrameIsHadAgain() {
        QFETCH(QString, scene);
        Scene start = test::shippedScene(scene.toStdString());
        start.cloth.numWidthPoints = start.cloth.numHeightPoints = 30;
        start.cloth.pinned.clear();
        if (scene.startsWith("pinned"))
            start.cloth.pinned = {{0, 0}, {29, 0}};
        Run run(start);
        std::mt19937 random(unsigned(scene.size()) + 17);
        recordWithEdits(run, random);
        run.waitUntilPacked();
        const Take& take = *run.simulation.recording().take();
        int kept = 0;
        for (int i = 0; i <= kFrames; ++i)
            kept += std::as_const(take).frame(i).exact != nullptr;
        QVERIFY2(kept < 15, "most frames must be had again, or this shows nothing");

        for (int i = 0; i < 20; ++i) {
            const int from = int(random() % kFrames);
            run.simulation.showFrame(from);
            QTRY_VERIFY_WITH_TIMEOUT(run.simulation.shownFrame()->exact, kPatience);
            goesOnAsRecorded(take, from, run.simulation.shownFrame()->state);
            if (QTest::currentTestFailed())
                return;
        }
    }

    // By the program itself: the run goes on from a frame that is not in memory any more.
    void goingOnFromAPackedFrame() {
        Scene start = test::shippedScene("sphere");
        start.cloth.numWidthPoints = start.cloth.numHeightPoints = 20;
        Run run(start);
        while (run.simulation.recording().lastFrame() < 60 && !QTest::currentTestFailed())
            run.record();
        run.waitUntilPacked();
        const TakePointer first = run.simulation.recording().take();
        QVERIFY(!std::as_const(*first).frame(31).exact);
        run.simulation.showFrame(31);
        run.edit("cloth.ks", 700);
        run.document.undoStack().undo(); // what follows is current again
        run.edit("cloth.damping", 0.3);
        run.record();
        QVERIFY(run.simulation.recording().take() != first);
        QCOMPARE(run.simulation.currentFrame(), 32);
        VerletSolver solver(*std::as_const(*first).frame(0).scene);
        ClothState state = solver.start();
        const std::atomic<bool> stop{false};
        for (int i = 0; i < 31; ++i)
            runFrame(solver, state, stop);
        solver.setScene(run.document.scene());
        runFrame(solver, state, stop);
        QVERIFY(run.simulation.shownFrame()->state == state);
    }

private:
    static void goesOnAsRecorded(const Take& take, int from, ClothState state) {
        VerletSolver solver(*take.frame(from).scene);
        QCOMPARE(stateHash(state), factsOf(take, from)->stateHash);
        const std::atomic<bool> stop{false};
        for (int i = from + 1; i <= take.lastFrame(); ++i) {
            solver.setScene(*take.frame(i).scene);
            runFrame(solver, state, stop);
            QVERIFY2(stateHash(state) == factsOf(take, i)->stateHash, qPrintable(QString::number(i)));
        }
    }
};

QTEST_GUILESS_MAIN(TestExactness)
#include "tst_exactness.moc"
