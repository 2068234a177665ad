// Takes: any sequence of what a user can do, against a plain model of them.
#include "app/simulation/simulation.h"

#include "tests/support/plain_takes.h"
#include "tests/support/tiny_scene.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <random>

using namespace clothlab;

namespace {

struct Run {
    QTemporaryDir folder;
    Document document;
    Simulation simulation;

    // Small budgets, so that most frames are packed ones.
    explicit Run(std::size_t budget)
        : simulation((document.setScene(test::tinyScene(), {}), document), nullptr, budget) {
        simulation.setJournals([this] { return folder.filePath("journal.clothtake"); });
    }

    test::PlainTakes::User user() const {
        return {document.scene().cloth.ks, document.scene().cloth.numHeightPoints};
    }
    void set(const char* parameter, double value) {
        QVERIFY(!document.setParameter(*findParameter(parameter), value));
    }
    void record() {
        QSignalSpy shown(&simulation, &Simulation::frameShown);
        simulation.simulateFrame();
        while (simulation.isSimulating())
            QVERIFY(shown.wait(60'000));
    }
};

} // namespace

class TestTakes : public QObject {
    Q_OBJECT
private slots:
    void anySequenceIsThePlainModel_data() {
        QTest::addColumn<unsigned>("seed");
        QTest::addColumn<int>("steps");
        const int steps = qEnvironmentVariableIsSet("CLOTHLAB_LONG") ? 100'000 : 10'000;
        QTest::newRow("seed 1") << 1U << steps;
        for (unsigned seed = 2; seed < 8; ++seed)
            QTest::addRow("seed %u", seed) << seed << 1000;
    }
    void anySequenceIsThePlainModel() {
        QFETCH(unsigned, seed);
        QFETCH(int, steps);
        std::mt19937 random(seed);
        Run run(100'000);
        test::PlainTakes model(run.user());
        QByteArrayList done;
        for (int i = 0; i < steps; ++i) {
            done << take(run, model, [&](int n) { return int(random() % unsigned(n)); });
            const QByteArray where =
                "step " + QByteArray::number(i) + ": " + done.mid(std::max(0, i - 8)).join(", ");
            verifyAlike(run, model, where, i % 64 == 0);
            if (QTest::currentTestFailed())
                return;
        }
    }

private:
    // One step of a user. Returns what it was.
    template <typename Below>
    static QByteArray take(Run& run, test::PlainTakes& model, Below below) {
        const auto anyTake = [&] {
            return *std::next(model.listed().begin(), below(int(model.listed().size())));
        };
        const int dice = below(40);
        if (dice < 12) {
            run.record();
            model.record();
            return "record";
        }
        if (dice < 18) {
            const int frame = below(model.count() + 4) - 2;
            run.simulation.showFrame(frame);
            model.show(frame);
            return "show " + QByteArray::number(frame);
        }
        if (dice < 24) {
            const double ks = 100 + below(3);
            run.set("cloth.ks", ks);
            model.edit({ks, model.user().rows});
            return "ks " + QByteArray::number(ks);
        }
        if (dice < 29) {
            run.document.undoStack().undo();
            model.undo();
            return "undo";
        }
        if (dice < 32) {
            run.document.undoStack().redo();
            model.redo();
            return "redo";
        }
        if (dice < 34) {
            const int id = anyTake();
            run.simulation.openTake(TakeId(id));
            model.open(id);
            return "open " + QByteArray::number(id);
        }
        if (dice == 34) {
            const int id = anyTake();
            const QByteArray name = "Take " + QByteArray::number(1 + below(5));
            run.simulation.renameTake(TakeId(id), name);
            model.rename(id, name.toStdString());
            return "rename " + QByteArray::number(id);
        }
        if (dice < 37) {
            const int id = anyTake();
            run.simulation.deleteTake(TakeId(id));
            model.remove(id);
            return "delete " + QByteArray::number(id);
        }
        if (dice == 37 && below(3) == 0) {
            run.simulation.restart();
            model.restart();
            return "restart";
        }
        if (dice == 38) {
            const int rows = 2 + below(3);
            run.set("cloth.num_height_points", rows);
            model.edit({model.user().ks, rows});
            return "rows " + QByteArray::number(rows);
        }
        run.document.edit("nothing", run.document.scene());
        return "nothing";
    }

    static void verifyAlike(Run& run, const test::PlainTakes& model, const QByteArray& where, bool all) {
        const Recording& recording = run.simulation.recording();
        QVERIFY2(run.user() == model.user(), where);
        QVERIFY2(int(recording.take()->id()) == model.openTake(), where);
        QVERIFY2(run.simulation.currentFrame() == model.shown(), where);
        QVERIFY2(run.simulation.firstStaleFrame() == model.stale(), where);
        QVERIFY2(recording.takes().size() == model.listed().size(), where);
        QVERIFY2(run.simulation.shownFrame()->state.size() == run.simulation.sheet().start.size(), where);
        for (const TakePointer& take : recording.takes()) {
            const int id = int(take->id());
            QVERIFY2(model.listed().contains(id), where);
            const test::PlainTakes::Take& other = model.take(id);
            QVERIFY2(take->name() == other.name, where);
            const TakePointer parent = recording.listedParent(*take);
            QVERIFY2((parent ? int(parent->id()) : 0) == model.listedParent(id), where);
            QVERIFY2(take->branchFrame() == other.branchFrame, where);
            QVERIFY2(take->frameCount() == int(other.frames.size()), where);
            if (!all && id != model.openTake())
                continue;
            for (int i = 0; i < take->frameCount(); ++i)
                QVERIFY2(std::as_const(*take).frame(i).scene->cloth.ks == other.frames[std::size_t(i)],
                         where);
        }
        if (all)
            verifySeams(run, where);
    }

    // Each frame follows the one before it, whatever branched where.
    static void verifySeams(Run& run, const QByteArray& where) {
        const int last = run.simulation.recording().lastFrame();
        const FramePointer before = last > 0 ? run.simulation.look(last - 1) : nullptr;
        const FramePointer frame = run.simulation.look(last);
        if (!before || !before->exact || !frame->exact)
            return;
        VerletSolver solver(*frame->scene);
        ClothState state = before->state;
        for (int i = 0; i < frame->scene->simulation.stepsPerFrame; ++i)
            solver.step(state);
        QVERIFY2(state == frame->state, where);
    }
};

QTEST_GUILESS_MAIN(TestTakes)
#include "tst_takes.moc"
