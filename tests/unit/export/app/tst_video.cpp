// Video through ffmpeg: what it is asked for, what comes out, and every way it can fail.
#include "app/export/picture_writers.h"
#include "tests/support/export_frames.h"
#include "tests/support/fake_painter.h"
#include "tests/support/video.h"

#include <QElapsedTimer>
#include <QtTest>

#include <thread>

using namespace clothlab;
using test::FakeFfmpeg;
using test::FakePainter;
using Trouble = std::optional<std::string>;

namespace {

constexpr QSize kSize(64, 48);
const QByteArray kEncoders = "case \"$*\" in *-encoders*) echo ' V....D libx264 x'; exit 0;; esac\n";

} // namespace

class TestVideo : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(QDir(m_folder->path()).mkdir("out"));
        m_log = {};
        m_stop = false;
    }

    void sizesAreMadeEven() {
        QCOMPARE(evenSize({1280, 720}), QSize(1280, 720));
        QCOMPARE(evenSize({641, 479}), QSize(640, 478));
    }

    void theBestEncoderIsChosen() {
        const auto printed = [](const QStringList& names) {
            QString text = "Encoders:\n V..... = Video\n ------\n";
            for (const QString& name : names)
                text += " V....D " + name + QString(12, ' ') + "about " + name + "\n A....D aac AAC\n";
            return text;
        };
        const auto choose = [&](VideoFormat format, const QStringList& names) {
            return chooseEncoder(format, printed(names)).value_or("none");
        };
        QCOMPARE(choose(VideoFormat::Mp4, {"mpeg4", "libx264rgb", "libx264", "libvpx-vp9"}), "libx264");
        QCOMPARE(choose(VideoFormat::Mp4, {"mpeg4", "libx264rgb", "libopenh264"}), "libopenh264");
        QCOMPARE(choose(VideoFormat::Mp4, {"msmpeg4", "mpeg4"}), "mpeg4");
        QCOMPARE(choose(VideoFormat::Mp4, {"libx264rgb", "libvpx"}), "none");
        QCOMPARE(choose(VideoFormat::WebM, {"libvpx", "libvpx-vp9"}), "libvpx-vp9");
        QCOMPARE(choose(VideoFormat::WebM, {"libvpx", "libx264"}), "libvpx");
        QCOMPARE(choose(VideoFormat::WebM, {"libx264"}), "none");
    }

    void itIsAskedForWhatPlayersTake() {
        const QStringList mp4 =
            videoArguments({VideoFormat::Mp4, {1280, 800}, 22.5}, "libx264", "/tmp/a %d-b:c.mp4");
        const auto after = [&](const QString& option) { return mp4.value(mp4.indexOf(option) + 1); };
        QCOMPARE(after("-video_size"), "1280x800");
        QCOMPARE(after("-framerate"), "22.5");
        QCOMPARE(after("-c:v"), "libx264");
        QVERIFY(after("-vf").endsWith("format=yuv420p"));
        QCOMPARE(after("-movflags"), "+faststart");
        QCOMPARE(mp4.last(), "file:/tmp/a %d-b:c.mp4");
        QVERIFY(mp4.indexOf("-framerate") < mp4.indexOf("-i")); // of what comes, not of what goes
        const QStringList webm = videoArguments({VideoFormat::WebM, {2, 2}, 30}, "libvpx-vp9", "a.webm");
        QVERIFY(webm.contains("webm") && !webm.contains("-movflags"));
        QVERIFY(webm.last().startsWith("file:/"));
    }

    void theFileIsWhatWasAskedFor_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("codec");
        QTest::newRow("mp4") << "a clip, 50% of %d.mp4"
                             << "h264";
        QTest::newRow("webm") << "-y:clip 'b'.webm"
                              << "vp9";
    }
    void theFileIsWhatWasAskedFor() {
        CLOTHLAB_NEEDS_FFMPEG();
        QFETCH(QString, name);
        QFETCH(QString, codec);
        const Trouble trouble = write(name, 9);
        QVERIFY2(!trouble, trouble.value_or("").c_str());
        QCOMPARE(files(), QStringList{name});
        const test::Video video = test::probe(in(name));
        QCOMPARE(video.codec, codec);
        QCOMPARE(video.pixelFormat, QString("yuv420p"));
        QCOMPARE(video.size, kSize);
        QCOMPARE(video.frames, 9);
        QCOMPARE(video.framesPerSecond, 22.5);
        QVERIFY(std::abs(video.seconds - 9 / 22.5) < 1 / 22.5);
        const QByteArray pixels = test::middlePixels(in(name), kSize);
        QCOMPARE(pixels.size(), 9 * 3);
        for (int frame = 0; frame < 9; ++frame) {
            const QColor expected = FakePainter::colorOf(frame);
            for (const auto& [channel, value] : {std::pair(0, expected.red()), std::pair(1, expected.green()),
                                                 std::pair(2, expected.blue())})
                QVERIFY(std::abs(int(quint8(pixels[3 * frame + channel])) - value) <= 6);
        }
    }

    void existingPermissionsStay() {
        CLOTHLAB_NEEDS_FFMPEG();
        QFile before(in("a.mp4"));
        QVERIFY(before.open(QIODevice::WriteOnly));
        before.close();
        QVERIFY(before.setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ReadGroup));
        const auto permissions = QFile::permissions(in("a.mp4"));
        QVERIFY(!write("a.mp4", 3));
        QCOMPARE(QFile::permissions(in("a.mp4")), permissions);
        QVERIFY(QFileInfo(in("a.mp4")).size() > 500);
    }

    void withoutFfmpegItSaysHowToGetIt() {
        const FakeFfmpeg none(m_folder->path() + "/bin", {});
        QVERIFY(findFfmpeg().isEmpty());
        const Trouble trouble = write("a.mp4", 2);
        QVERIFY(trouble && trouble->find("apt install ffmpeg") != std::string::npos);
        QCOMPARE(files(), QStringList());
    }

    void failures_data() {
        QTest::addColumn<QByteArray>("script");
        QTest::addColumn<QString>("words");
        QTest::newRow("at once") << kEncoders + "echo one >&2; echo 'no space, really' >&2; exit 1\n"
                                 << "ffmpeg failed: one | no space, really";
        QTest::newRow("in the middle")
            << kEncoders + "head -c 30000 >/dev/null; echo 'half way' >&2; exit 3\n"
            << "ffmpeg failed: half way";
        QTest::newRow("at the end") << kEncoders + "cat >/dev/null; for i in 1 2 3 4 5; do echo line $i; "
                                                   "done >&2; exit 1\n"
                                    << "ffmpeg failed: line 3 | line 4 | line 5";
        QTest::newRow("without a word") << kEncoders + "cat >/dev/null; exit 4\n"
                                        << "status 4";
        QTest::newRow("killed") << kEncoders + "kill -9 $$\n"
                                << "ffmpeg ended";
        QTest::newRow("no encoder") << QByteArray("echo ' V....D gif x'\n") << "libx264, libopenh264, mpeg4";
    }
    void failures() {
        QFETCH(QByteArray, script);
        QFETCH(QString, words);
        const FakeFfmpeg fake(m_folder->path() + "/bin", script);
        const Trouble trouble = write("a.mp4", 8);
        QVERIFY(trouble.has_value());
        QVERIFY2(trouble->starts_with(in("a.mp4").toStdString() + ": "), trouble->c_str());
        QVERIFY2(QString::fromStdString(*trouble).contains(words), trouble->c_str());
        QCOMPARE(files(), QStringList());
        QVERIFY(m_log.ended >= m_log.begun);
    }

    // One that takes nothing, one that takes everything and does not end, one that does not say what it can.
    void stoppingDoesNotWaitForFfmpeg_data() {
        QTest::addColumn<QByteArray>("script");
        QTest::newRow("takes nothing") << kEncoders + "echo $$ > \"$0.pid\"; exec sleep 60\n";
        QTest::newRow("does not end") << kEncoders + "echo $$ > \"$0.pid\"; cat >/dev/null; exec sleep 60\n";
        QTest::newRow("does not answer") << QByteArray("echo $$ > \"$0.pid\"; exec sleep 60\n");
    }
    void stoppingDoesNotWaitForFfmpeg() {
        QFETCH(QByteArray, script);
        const FakeFfmpeg fake(m_folder->path() + "/bin", script);
        QElapsedTimer timer;
        timer.start();
        std::thread later([this] {
            std::this_thread::sleep_for(std::chrono::milliseconds(300));
            m_stop = true;
        });
        const Trouble trouble = write("a.mp4", 40);
        later.join();
        QVERIFY(trouble.has_value());
        QVERIFY(timer.elapsed() < 20'000);
        QCOMPARE(files(), QStringList());
        const int pid = std::stoi(test::bytesOfFile((m_folder->path() + "/bin/ffmpeg.pid").toStdString()));
        QVERIFY(::kill(pid, 0) != 0); // it is gone
    }

    void oddSizesAreRefused() {
        const Trouble trouble = write("a.mp4", 2, {63, 48});
        QVERIFY(trouble && trouble->find("even") != std::string::npos);
        QCOMPARE(files(), QStringList());
    }

private:
    QString in(const QString& name) const { return m_folder->filePath("out/" + name); }
    QStringList files() const {
        return QDir(m_folder->filePath("out"))
            .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
    }
    Trouble write(const QString& name, int count, QSize size = kSize) {
        const auto format = name.endsWith(".mp4") ? VideoFormat::Mp4 : VideoFormat::WebM;
        const auto writer = makeVideoWriter(in(name).toStdString(), format, 22.5,
                                            std::make_unique<FakePainter>(size, m_log), m_stop);
        const auto frames = test::sampleFrames(count);
        if (auto trouble = writer->begin(test::sheetOf(*frames.front()), count))
            return trouble;
        for (const FramePointer& frame : frames)
            if (auto trouble = writer->add(frame))
                return trouble;
        return writer->finish();
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    FakePainter::Log m_log;
    std::atomic<bool> m_stop{false};
};

QTEST_GUILESS_MAIN(TestVideo)
#include "tst_video.moc"
