// What becomes of frames that are added: packed, in the journal, out of memory. No event loop and no Qt
// objects: this runs under ThreadSanitizer.
#include "app/simulation/recorder.h"

#include "simcore/solver/frame_runner.h"
#include "tests/support/tiny_scene.h"

#include <QTemporaryDir>
#include <QTest>

#include <condition_variable>

using namespace clothlab;

namespace {

constexpr std::chrono::minutes kHang{2}; // longer than anything here takes on any machine

// Where the recorder delivers to.
class Outbox {
public:
    std::function<void(Packed)> deliver() {
        return [this](Packed packed) {
            const std::scoped_lock lock(m_mutex);
            m_packed.push_back(std::move(packed));
        };
    }

    // What has come until all that was added is packed.
    std::vector<Packed> flushed(Recorder& recorder) {
        bool done = false;
        recorder.flush([&] {
            const std::scoped_lock lock(m_mutex);
            done = true;
            m_arrived.notify_all();
        });
        std::unique_lock lock(m_mutex);
        if (!m_arrived.wait_for(lock, kHang, [&] { return done; }))
            return {};
        for (const Packed& packed : m_packed)
            recorder.taken(packed);
        return std::exchange(m_packed, {});
    }

private:
    std::mutex m_mutex;
    std::condition_variable m_arrived;
    std::vector<Packed> m_packed;
};

// Frames of a run that gets another stiffness in its middle.
std::vector<FramePointer> runOf(int frames) {
    const auto scene = std::make_shared<const Scene>(test::tinyScene());
    auto soft = std::make_shared<Scene>(*scene);
    soft->cloth.ks = 100;
    VerletSolver solver(*scene);
    std::vector<FramePointer> run{startFrame(scene)};
    const std::atomic<bool> stop{false};
    while (int(run.size()) < frames) {
        Frame frame = *run.back();
        if (int(run.size()) == frames / 2) {
            solver.setScene(*soft);
            frame.scene = soft;
        }
        runFrame(solver, frame.state, stop);
        frame.time += 1.0 / scene->simulation.framesPerSecond;
        run.push_back(std::make_shared<const Frame>(std::move(frame)));
    }
    return run;
}

std::shared_ptr<const Sheet> sheetOf(const std::vector<FramePointer>& run) {
    return std::make_shared<const Sheet>(Sheet{gridOf(run[0]->scene->cloth), run[0]->state.position});
}

void addAll(Recorder& recorder, TakeId take, const std::vector<FramePointer>& run) {
    const auto sheet = sheetOf(run);
    recorder.setTake({take, 0, 0, "Take " + std::to_string(take), false});
    for (int i = 0; i < int(run.size()); ++i)
        recorder.add(take, sheet, i, run[std::size_t(i)]);
}

double greatestDifference(const PointArray& a, const PointArray& b) {
    double greatest = 0;
    for (int i = 0; i < int(a.size()); ++i)
        greatest = std::max(greatest, (a.at(i) - b.at(i)).cwiseAbs().maxCoeff());
    return greatest;
}

} // namespace

class TestRecorder : public QObject {
    Q_OBJECT
private slots:
    void everyFrameIsPackedOnce() {
        const auto run = runOf(150);
        Outbox outbox;
        Recorder recorder(outbox.deliver(), 1 << 20);
        recorder.begin(7, {}, kDefaultError);
        addAll(recorder, 3, run);
        int next = 0;
        int checkpoints = 0;
        for (const Packed& packed : outbox.flushed(recorder)) {
            QCOMPARE(packed.session, 7);
            QVERIFY(packed.problem.empty());
            if (packed.checkpoint) {
                ++checkpoints;
                QVERIFY(stateOf(*packed.checkpoint) == run[std::size_t(packed.checkpoint->frame)]->state);
                continue;
            }
            QCOMPARE(packed.group->take, TakeId(3));
            QCOMPARE(packed.group->first, next);
            for (; next < packed.group->end(); ++next) {
                const Frame& frame = *run[std::size_t(next)];
                const FrameEntry& entry = packed.group->frames[std::size_t(next - packed.group->first)];
                QCOMPARE(entry.facts.stateHash, stateHash(frame.state));
                QCOMPARE(recorder.scene(entry.scene), frame.scene);
                const auto positions = positionsOf(*packed.group, next);
                QVERIFY(positions && greatestDifference(*positions, frame.state.position) <= kDefaultError);
            }
        }
        QCOMPARE(next, 150);
        QCOMPARE(checkpoints, 3); // frames 0, 60, 120
        QCOMPARE(recorder.bytesWaiting(), std::size_t(0));
        QVERIFY(recorder.bytesInMemory() > 0);
    }

    void whatIsInTheJournalNeedNotBeInMemory() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("journal.clothtake").toStdString();
        const auto run = runOf(100);
        Outbox outbox;
        Recorder recorder(outbox.deliver(), 0);
        recorder.begin(1, path, kDefaultError);
        addAll(recorder, 1, run);
        const std::vector<Packed> packed = outbox.flushed(recorder);
        QVERIFY(recorder.hasJournal());
        QCOMPARE(recorder.bytesInMemory(), std::size_t(0));
        for (const Packed& one : packed)
            if (one.group) {
                QCOMPARE(one.group->payload->bytesInMemory(), std::size_t(0));
                const auto positions = positionsOf(*one.group, one.group->first);
                const Frame& frame = *run[std::size_t(one.group->first)];
                QVERIFY(positions && greatestDifference(*positions, frame.state.position) <= kDefaultError);
            }

        // What a crash would leave now.
        const TakeFileReading reading = readTakeFile(path);
        QVERIFY(reading.contents && !reading.finished);
        QCOMPARE(reading.contents->takes.size(), std::size_t(1));
        QCOMPARE(reading.contents->takes[0].end(), 100);
        QCOMPARE(reading.contents->takes[0].info.name, std::string("Take 1"));
    }

    void takesMayTakeTurns() {
        const auto run = runOf(20);
        const auto sheet = sheetOf(run);
        Outbox outbox;
        Recorder recorder(outbox.deliver(), 1 << 20);
        recorder.begin(1, {}, 0);
        for (int i = 0; i < 20; ++i)
            for (const TakeId take : {1U, 2U})
                recorder.add(take, sheet, i, run[std::size_t(i)]);
        std::array<int, 3> frames{};
        for (const Packed& packed : outbox.flushed(recorder))
            if (packed.group) {
                frames[packed.group->take] += int(packed.group->frames.size());
                QVERIFY(positionsOf(*packed.group, packed.group->first) ==
                        run[std::size_t(packed.group->first)]->state.position); // no error was allowed
            }
        QCOMPARE(frames[1], 20);
        QCOMPARE(frames[2], 20);
    }

    void anotherErrorHoldsFromTheNextFrame() {
        const auto run = runOf(20);
        const auto sheet = sheetOf(run);
        Outbox outbox;
        Recorder recorder(outbox.deliver(), 1 << 20);
        recorder.begin(1, {}, 1e-4);
        for (int i = 0; i < 20; ++i) {
            if (i == 10)
                recorder.setError(0);
            recorder.add(1, sheet, i, run[std::size_t(i)]);
        }
        for (const Packed& packed : outbox.flushed(recorder))
            if (packed.group) {
                QVERIFY(packed.group->end() <= 10 || packed.group->first >= 10);
                QCOMPARE(packed.group->error, packed.group->first < 10 ? 1e-4 : 0.0);
            }
    }

    // Within the time that a crash may cost, though the group is not full.
    void fewFramesArePackedSoon() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("journal.clothtake").toStdString();
        Outbox outbox;
        Recorder recorder(outbox.deliver(), 0);
        recorder.begin(1, path, kDefaultError);
        addAll(recorder, 1, runOf(3));
        QTRY_VERIFY_WITH_TIMEOUT(readTakeFile(path).contents.has_value(), 60'000);
        QCOMPARE(readTakeFile(path).contents->takes[0].end(), 3);
    }

    void aJournalThatCannotBeWrittenIsSaid() {
        const auto run = runOf(5);
        Outbox outbox;
        Recorder recorder(outbox.deliver(), 0);
        recorder.begin(1, "/nowhere at all/journal.clothtake", kDefaultError);
        addAll(recorder, 1, run);
        int problems = 0;
        int frames = 0;
        for (const Packed& packed : outbox.flushed(recorder)) {
            problems += packed.problem.empty() ? 0 : 1;
            frames += packed.group ? int(packed.group->frames.size()) : 0;
        }
        QCOMPARE(problems, 1);
        QCOMPARE(frames, 5); // which stay in memory
        QVERIFY(recorder.bytesInMemory() > 0);
        QVERIFY(!recorder.hasJournal());
    }

    // The same journal read by one thread while the recorder writes it, and payloads while it releases them.
    void readingWhileRecording() {
        const QTemporaryDir folder;
        const auto run = runOf(400);
        std::mutex mutex;
        std::vector<std::shared_ptr<const FrameGroup>> groups;
        Recorder recorder(
            [&](Packed packed) {
                const std::scoped_lock lock(mutex);
                if (packed.group)
                    groups.push_back(packed.group);
            },
            2000);
        recorder.begin(1, folder.filePath("journal.clothtake").toStdString(), kDefaultError);
        std::atomic<bool> done{false};
        std::atomic<int> wrong{0};
        std::thread reader([&] {
            std::size_t i = 0;
            while (!done) {
                std::shared_ptr<const FrameGroup> group;
                {
                    const std::scoped_lock lock(mutex);
                    if (!groups.empty())
                        group = groups[i++ % groups.size()];
                }
                if (group && !positionsOf(*group, group->first))
                    ++wrong;
            }
        });
        addAll(recorder, 1, run);
        std::atomic<bool> flushed{false};
        recorder.flush([&] { flushed = true; });
        while (!flushed)
            std::this_thread::yield();
        done = true;
        reader.join();
        QCOMPARE(wrong.load(), 0);
        QVERIFY(groups.size() >= 400 / kFramesPerGroup);
    }

    void anotherSessionForgetsTheOne() {
        const auto run = runOf(10);
        Outbox outbox;
        Recorder recorder(outbox.deliver(), 1 << 20);
        recorder.begin(1, {}, kDefaultError);
        addAll(recorder, 1, run);
        recorder.begin(2, {}, kDefaultError);
        addAll(recorder, 1, run);
        std::array<int, 3> frames{};
        for (const Packed& packed : outbox.flushed(recorder))
            if (packed.group)
                frames[std::size_t(packed.session)] += int(packed.group->frames.size());
        QCOMPARE(frames[1], 10);
        QCOMPARE(frames[2], 10);
        QCOMPARE(recorder.idOfScene(*run[0]->scene), SceneId(1));
    }
};

QTEST_GUILESS_MAIN(TestRecorder)
#include "tst_recorder.moc"
