// Exports in every format on a thread of their own: files whole or not at all.
#include "app/export/export_job.h"
#include "tests/support/export_frames.h"
#include "tests/support/fake_painter.h"
#include "tests/support/video.h"

#include <QImage>
#include <QSignalSpy>
#include <QtTest>

#include <thread>

using namespace clothlab;
using test::FakePainter;

namespace {

constexpr int kFrames = 6;
constexpr int kPatience = 60'000; // ms
constexpr QSize kSize(32, 20);

const QByteArray kEncoders = "case \"$*\" in *-encoders*) echo ' V....D libx264 x'; echo ' V....D "
                             "libvpx-vp9 x'; exit 0;; esac\n";
// Takes what comes and writes something to the file it is told to.
const QByteArray kGoodFfmpeg = kEncoders + "for last; do :; done\nout=${last#file:}\nwc -c > \"$out\"\n";

} // namespace

class TestExportJob : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_log = {};
        m_hold = false;
        // Everywhere the same, and there even without ffmpeg.
        m_ffmpeg = std::make_unique<test::FakeFfmpeg>(m_folder->path() + "/bin", kGoodFfmpeg);
        QVERIFY(QDir(m_folder->path()).mkdir("out"));
    }
    void cleanup() { m_ffmpeg.reset(); }

    void everyFormat_data() { kinds(); }
    void everyFormat() {
        const ExportRequest request = requestFor("a 100% run %d");
        ExportJob job(source(), request, painter());
        QSignalSpy progress(&job, &ExportJob::progressed);
        const ExportResult result = run(job);
        QVERIFY2(result.end == ExportEnd::Done, result.reason.c_str());
        QCOMPARE(result.written, kFrames);
        QCOMPARE(progress.last()[0].toInt(), kFrames);
        QStringList expected;
        for (const QString& path : filesOf(request))
            expected << QFileInfo(path).fileName();
        expected.sort();
        QCOMPARE(files(), expected);
        for (const QString& path : filesOf(request))
            QVERIFY(QFileInfo(path).size() > 0);
        if (hasPictures(kind())) {
            QCOMPARE(m_log.painted, kFrames);
            QVERIFY(m_log.thread && m_log.thread != QThread::currentThread());
            QVERIFY(m_log.ended >= 1);
        }
    }

    void cancelledInTheMiddle_data() { kinds(); }
    void cancelledInTheMiddle() {
        const ExportRequest request = requestFor("run");
        // One that is there before stays as it is.
        const QString before = filesOf(request).constFirst();
        write(before, "before");
        m_hold = true;
        ExportJob job(source(), request, painter());
        const ExportResult result = wait(job, [&] {
            job.start();
            m_held.acquire(); // three frames are written
            job.cancel();
            m_hold = false;
            m_goOn.release();
        });
        QVERIFY(result.end == ExportEnd::Cancelled && result.written == 3);
        QCOMPARE(files(), QStringList{QFileInfo(before).fileName()});
        QCOMPARE(test::bytesOfFile(before.toStdString()), std::string("before"));
        QVERIFY(m_log.begun == 0 || m_log.ended >= 1);
    }

    void destroyedInTheMiddle_data() { kinds(); }
    void destroyedInTheMiddle() {
        m_hold = true;
        std::thread later;
        {
            ExportJob job(source(), requestFor("run"), painter());
            job.start();
            m_held.acquire();
            later = std::thread([this] { // once it is being destroyed
                std::this_thread::sleep_for(std::chrono::milliseconds(50));
                m_goOn.release();
            });
        }
        later.join();
        QCOMPARE(files(), QStringList());
    }

    void aSourceThatFails_data() { kinds(); }
    void aSourceThatFails() {
        FrameSource failing = source();
        failing.frame = [inner = failing.frame](int frame, std::string& reason) -> FramePointer {
            if (frame < 4)
                return inner(frame, reason);
            reason = "the recording is damaged there";
            return nullptr;
        };
        ExportJob job(failing, requestFor("run"), painter());
        const ExportResult result = run(job);
        QVERIFY(result.end == ExportEnd::NoFrame);
        QCOMPARE(result.reason, std::string("frame 4: the recording is damaged there"));
        QCOMPARE(files(), QStringList());
    }

    void aFolderThatIsNotThere_data() { kinds(); }
    void aFolderThatIsNotThere() {
        const ExportRequest request = requestFor("none/run");
        ExportJob job(source(), request, painter());
        const ExportResult result = run(job);
        QVERIFY(result.end == ExportEnd::NotWritten);
        QVERIFY2(result.reason.find("/out/none/run") != std::string::npos &&
                     result.reason.find("no such") != std::string::npos,
                 result.reason.c_str());
        QVERIFY(!QString::fromStdString(result.reason).contains(".clothlab"));
        QCOMPARE(files(), QStringList());
    }

    void aFolderInTheWay_data() { kinds(); }
    void aFolderInTheWay() {
        const ExportRequest request = requestFor("run");
        const QString there = filesOf(request).at(isSequence(kind()) ? 2 : 0);
        QVERIFY(QDir().mkpath(there));
        ExportJob job(source(), request, painter());
        const ExportResult result = run(job);
        QVERIFY(result.end == ExportEnd::NotWritten);
        QVERIFY2(result.reason.starts_with(there.toStdString() + ": is a folder"), result.reason.c_str());
        QCOMPARE(files(), QStringList{QFileInfo(there).fileName()});
    }

    void aDiskThatFillsUp_data() { kinds(); }
    void aDiskThatFillsUp() {
        if (isVideo(kind()))
            QSKIP("The limit is one of this process.");
        const ExportRequest request = requestFor("run");
        ExportJob job(source(), request, painter());
        const test::FileSizeLimit limit(60);
        const ExportResult result = run(job);
        QVERIFY(result.end == ExportEnd::NotWritten);
        QVERIFY2(result.reason.find("disk") != std::string::npos &&
                     result.reason.find(".clothlab") == std::string::npos,
                 result.reason.c_str());
        QCOMPARE(files(), QStringList());
    }

    // The files of a sequence take the place of those that are there only when all of them are written.
    void filesAreReplacedAtTheEnd() {
        ExportRequest request = requestFor("run", ExportKind::PngFiles);
        request.frames = {0, 5, 2};
        for (const char* name : {"run_0000.png", "run_0001.png", "run_0007.png"})
            write(path(name), "before");
        ExportJob job(source(), request, painter());
        QVERIFY(run(job).end == ExportEnd::Done);
        QCOMPARE(files(), QStringList({"run_0000.png", "run_0001.png", "run_0002.png", "run_0007.png"}));
        QCOMPARE(QImage(path("run_0001.png")).size(), kSize);
        QCOMPARE(QImage(path("run_0002.png")).pixelColor(3, 3), FakePainter::colorOf(2));
        QCOMPARE(test::bytesOfFile(path("run_0007.png").toStdString()), std::string("before"));
    }

    void pc2HoldsTheFramesOfTheRange() {
        ExportRequest request = requestFor("run", ExportKind::Pc2);
        request.frames = {1, 5, 2};
        request.placement = {UpAxis::Z, 100};
        const auto frames = test::sampleFrames(kFrames);
        ExportJob job(source(), request, nullptr);
        QVERIFY(run(job).end == ExportEnd::Done);
        test::ByteReader reader(test::bytesOfFile(path("run.pc2").toStdString()), 16);
        QCOMPARE(reader.little(), 20U); // points
        reader.little();
        reader.little();
        QCOMPARE(reader.little(), 3U); // frames
        for (const int frame : {1, 3, 5})
            for (int p = 0; p < 20; ++p) {
                const Vec3 place =
                    placed(request.placement, frames[std::size_t(frame)]->state.position.at(p));
                for (const double value : {place.x(), place.y(), place.z()})
                    QVERIFY(test::sameFloat(reader.littleFloat(), float(value)));
            }
        QVERIFY(reader.atEnd());
    }

private:
    static void kinds() {
        QTest::addColumn<int>("kind");
        for (int i = 0; i < kExportKinds; ++i)
            QTest::newRow(qPrintable(title(ExportKind(i)))) << i;
    }
    static ExportKind kind() {
        return ExportKind(*static_cast<int*>(QTest::qData("kind", qMetaTypeId<int>())));
    }

    QString path(const QString& name) const { return m_folder->filePath("out/" + name); }
    QStringList files() const {
        return QDir(m_folder->filePath("out"))
            .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
    }
    static void write(const QString& file, const QByteArray& text) {
        QFile out(file);
        QVERIFY(out.open(QIODevice::WriteOnly));
        QCOMPARE(out.write(text), text.size());
    }
    ExportRequest requestFor(const QString& name) const { return requestFor(name, kind()); }
    ExportRequest requestFor(const QString& name, ExportKind of) const {
        ExportRequest request;
        request.kind = of;
        request.path = path(name) + ending(of);
        request.frames = {0, kFrames - 1, 1};
        request.size = kSize;
        return request;
    }
    std::unique_ptr<FramePainter> painter() { return std::make_unique<FakePainter>(kSize, m_log); }

    // Where it is told to hold, it does so after three frames.
    FrameSource source() {
        const auto frames = test::sampleFrames(kFrames);
        return {kFrames, test::sheetOf(*frames.front()), [this, frames](int frame, std::string&) {
                    if (frame == 3 && m_hold) {
                        m_held.release();
                        m_goOn.acquire();
                    }
                    return frames[std::size_t(frame)];
                }};
    }

    static ExportResult run(ExportJob& job) {
        return wait(job, [&] { job.start(); });
    }
    // For the end of what `begin` begins.
    static ExportResult wait(ExportJob& job, const std::function<void()>& begin) {
        ExportResult result{ExportEnd::NotWritten, "it does not end", 0};
        QEventLoop loop;
        connect(&job, &ExportJob::ended, &loop, [&](const ExportResult& how) {
            result = how;
            loop.quit();
        });
        QTimer::singleShot(kPatience, &loop, &QEventLoop::quit);
        begin();
        loop.exec();
        return result;
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<test::FakeFfmpeg> m_ffmpeg;
    FakePainter::Log m_log;
    std::atomic<bool> m_hold{false};
    QSemaphore m_held, m_goOn;
};

QTEST_GUILESS_MAIN(TestExportJob)
#include "tst_export_job.moc"
