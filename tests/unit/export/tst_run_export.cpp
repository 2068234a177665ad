// Frames from a source through a writer: which, in which order, and how it ends.
#include "simcore/export/run_export.h"
#include "tests/support/export_frames.h"

#include <QtTest>

#include <stdexcept>

using namespace clothlab;
using test::sampleFrames;

namespace {

class LoggingWriter : public FrameWriter {
public:
    struct Log {
        int begunFor = 0, discarded = 0;
        std::vector<FramePointer> frames;
        bool finished = false;
    };
    // Fails at that frame; -2: in begin(), the number of frames: in finish().
    LoggingWriter(Log& log, int fails = -1) : FrameWriter("file"), m_log(log), m_fails(fails) {}

private:
    Trouble open(const Sheet&, int framesAtMost) override {
        m_log.begunFor = framesAtMost;
        return m_fails == -2 ? Trouble("no") : std::nullopt;
    }
    Trouble write(const FramePointer& frame) override {
        m_log.frames.push_back(frame);
        return m_fails == added() ? Trouble("full") : std::nullopt;
    }
    Trouble complete() override {
        m_log.finished = m_fails != added();
        return m_log.finished ? std::nullopt : Trouble("late");
    }
    void discard() override { ++m_log.discarded; }

    Log& m_log;
    int m_fails;
};

FrameSource sourceOf(const std::vector<FramePointer>& frames) {
    return {int(frames.size()), test::sheetOf(*frames.front()),
            [frames](int frame, std::string& reason) -> FramePointer {
                if (frame == 7) {
                    reason = "it is damaged";
                    return nullptr;
                }
                if (frame == 8)
                    throw std::runtime_error("bad luck");
                return frames[std::size_t(frame)];
            }};
}

} // namespace

class TestRunExport : public QObject {
    Q_OBJECT
private slots:
    void ranges_data() {
        QTest::addColumn<int>("first");
        QTest::addColumn<int>("last");
        QTest::addColumn<double>("step");
        QTest::addColumn<QList<int>>("frames");
        const auto row = [](const char* name, int first, int last, double step, const QList<int>& frames) {
            QTest::newRow(name) << first << last << step << frames;
        };
        row("all", 0, 3, 1, {0, 1, 2, 3});
        row("one", 5, 5, 1, {5});
        row("none", 5, 4, 1, {});
        row("each third", 1, 10, 3, {1, 4, 7, 10});
        row("the last is passed over", 0, 5, 2, {0, 2, 4});
        row("not whole", 0, 11, 3.75, {0, 4, 8, 11});
        row("half a frame rounded up goes past the end", 0, 7, 2.5, {0, 3, 5});
        row("below one", 0, 3, 0.5, {});
        row("farther than the last", 0, 3, 100, {0});
    }
    void ranges() {
        QFETCH(int, first);
        QFETCH(int, last);
        QFETCH(double, step);
        QFETCH(QList<int>, frames);
        const ExportRange range{first, last, step};
        QList<int> numbers;
        for (int i = 0; i < range.count(); ++i)
            numbers << range.frameAt(i);
        QCOMPARE(numbers, frames);
    }

    void theFramesOfTheRangeAreWritten() {
        const auto frames = sampleFrames(6);
        LoggingWriter::Log log;
        LoggingWriter writer(log);
        std::vector<int> told;
        const ExportResult result = runExport(sourceOf(frames), {1, 5, 2}, writer, m_go,
                                              [&](int written) { told.push_back(written); });
        QVERIFY(result.end == ExportEnd::Done && result.reason.empty());
        QCOMPARE(result.written, 3);
        QVERIFY(log.finished && log.discarded == 0);
        QCOMPARE(log.begunFor, 3);
        QVERIFY((log.frames == std::vector<FramePointer>{frames[1], frames[3], frames[5]}));
        QVERIFY((told == std::vector<int>{1, 2, 3}));
    }

    void aFrameThatCannotBeHad() {
        for (const auto& [first, words] : {std::pair(5, "frame 7: it is damaged"),
                                           std::pair(8, "frame 8: it could not be made (bad luck)")}) {
            LoggingWriter::Log log;
            LoggingWriter writer(log);
            const auto result = runExport(sourceOf(sampleFrames(10)), {first, 9, 1}, writer, m_go);
            QVERIFY(result.end == ExportEnd::NoFrame);
            QCOMPARE(QString::fromStdString(result.reason), QString(words));
            QVERIFY(!log.finished);
            QCOMPARE(log.discarded, 1);
        }
    }

    void itMayEndTheFileInstead() {
        LoggingWriter::Log log;
        LoggingWriter writer(log);
        auto result = runExport(sourceOf(sampleFrames(10)), {5, 9, 1}, writer, m_go, {},
                                IfAFrameFails::KeepThoseBefore);
        QVERIFY(result.end == ExportEnd::NoFrame && result.written == 2);
        QCOMPARE(result.reason, std::string("it is damaged"));
        QVERIFY(log.finished && log.discarded == 0 && log.frames.size() == 2);
        // Where there is none before, there is no file.
        LoggingWriter none(log = {});
        result =
            runExport(sourceOf(sampleFrames(10)), {7, 9, 1}, none, m_go, {}, IfAFrameFails::KeepThoseBefore);
        QVERIFY(result.end == ExportEnd::NoFrame && !log.finished && log.discarded == 1);
    }

    void troubleOfTheWriter_data() {
        QTest::addColumn<int>("fails");
        QTest::addColumn<QString>("words");
        QTest::newRow("at the beginning") << -2 << "file: no";
        QTest::newRow("at a frame") << 2 << "file: full";
        QTest::newRow("at the end") << 4 << "file: late";
    }
    void troubleOfTheWriter() {
        QFETCH(int, fails);
        QFETCH(QString, words);
        LoggingWriter::Log log;
        LoggingWriter writer(log, fails);
        const auto result = runExport(sourceOf(sampleFrames(4)), {0, 3, 1}, writer, m_go);
        QVERIFY(result.end == ExportEnd::NotWritten);
        QCOMPARE(QString::fromStdString(result.reason), words);
        QCOMPARE(log.discarded, 1);
    }

    void stoppedInTheMiddle() {
        std::atomic<bool> stop{false};
        LoggingWriter::Log log;
        LoggingWriter writer(log);
        const auto result = runExport(sourceOf(sampleFrames(6)), {0, 5, 1}, writer, stop,
                                      [&](int written) { stop = written == 3; });
        QVERIFY(result.end == ExportEnd::Cancelled && result.reason.empty());
        QCOMPARE(log.frames.size(), std::size_t(3));
        QVERIFY(!log.finished && log.discarded == 1);
    }

    // A source or a writer that comes back because it was stopped is not to blame.
    void troubleAfterAStopIsAStop() {
        std::atomic<bool> stop{false};
        LoggingWriter::Log log;
        LoggingWriter writer(log, 3);
        QVERIFY(runExport(sourceOf(sampleFrames(6)), {0, 5, 1}, writer, stop, [&](int written) {
                    stop = written == 3;
                }).end == ExportEnd::Cancelled);
        stop = false;
        LoggingWriter other(log);
        FrameSource source = sourceOf(sampleFrames(6));
        source.frame = [&stop](int, std::string& reason) -> FramePointer {
            stop = true;
            reason = "interrupted";
            return nullptr;
        };
        QVERIFY(runExport(source, {0, 5, 1}, other, stop, {}, IfAFrameFails::KeepThoseBefore).end ==
                ExportEnd::Cancelled);
    }

private:
    const std::atomic<bool> m_go{false};
};

QTEST_APPLESS_MAIN(TestRunExport)
#include "tst_run_export.moc"
