// clothlab render with many frames, on a real display: sequences and videos.
#include "app/picture/camera.h"
#include "simcore/scene/scene_io.h"
#include "tests/support/program.h"
#include "tests/support/tiny_scene.h"
#include "tests/support/video.h"

#include <QDir>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

using namespace clothlab;

class TestProgramVideo : public QObject {
    Q_OBJECT
private slots:
    void initTestCase() {
        const bool required = qEnvironmentVariable("CLOTHLAB_REQUIRE_GL") == "1";
        const bool there = !qEnvironmentVariable("DISPLAY").isEmpty();
        QVERIFY2(there || !required, "CLOTHLAB_REQUIRE_GL is 1, and there is no display");
        if (!there)
            QSKIP("There is no display.");
    }

    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(QDir(m_folder->path()).mkdir("out"));
        Scene scene;
        scene.cloth.numWidthPoints = scene.cloth.numHeightPoints = 8;
        scene.cloth.pinned = {{0, 0}, {7, 0}};
        scene.cloth.thickness = 0;
        scene.simulation.stepsPerFrame = 4;
        scene.camera = homeView(scene.cloth);
        scene.camera->elevation = 90; // from above, with the sheet in the middle
        QVERIFY(!saveScene(scene, in("scene.json").toStdString()));
    }

    void aSequenceHasEveryFrameFromTheStart() {
        auto run = render({"--output", out("a 50%% %03d.png"), "--frames", "6", "--size", "160x100"});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QCOMPARE(files().size(), 7);
        QCOMPARE(files().constFirst(), "a 50% 000.png");
        // Each is that of the command for one picture.
        for (const int frame : {0, 3, 6}) {
            run = render({"--output", in("one.png"), "--frame", QString::number(frame), "--size", "160x100"});
            QVERIFY2(run.status == 0, qPrintable(run.err));
            QCOMPARE(QImage(out(QStringLiteral("a 50% %1.png").arg(frame, 3, 10, QChar('0')))),
                     QImage(in("one.png")));
        }
        QVERIFY(QImage(out("a 50% 006.png")) != QImage(out("a 50% 000.png")));
    }

    void fpsTakesTheNearestFrames() {
        const auto run =
            render({"--output", out("%d.png"), "--frames", "15", "--fps", "24", "--size", "80x50"});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QCOMPARE(files(), QStringList({"0.png", "1.png", "2.png", "3.png", "4.png"})); // 0, 4, 8, 11, 15
    }

    void fitKeepsOneCameraForAllFrames() {
        const auto run = render({"--output", out("%d.png"), "--frames", "40", "--fps", "3", "--fit", "--size",
                                 "160x100", "--shader", "Normal"});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QCOMPARE(files().size(), 2);
        // The corner is held by a pin: it is where it was, as the camera is.
        QVERIFY(QImage(out("0.png")) != QImage(out("1.png")));
    }

    void aVideoRunsInRealTime_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<double>("framesPerSecond");
        QTest::addColumn<int>("frames");
        QTest::newRow("mp4") << "a.mp4" << QStringList{} << 30.0 << 31;
        QTest::newRow("webm") << "a.webm" << QStringList{"--fps", "45"} << 45.0 << 46;
    }
    void aVideoRunsInRealTime() {
        CLOTHLAB_NEEDS_FFMPEG();
        QFETCH(QString, name);
        QFETCH(QStringList, arguments);
        QFETCH(double, framesPerSecond);
        QFETCH(int, frames);
        const auto run =
            render(QStringList{"--output", out(name), "--frames", "90", "--size", "160x100"} + arguments);
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QCOMPARE(files(), QStringList{name});
        const test::Video video = test::probe(out(name));
        QCOMPARE(video.size, QSize(160, 100));
        QCOMPARE(video.frames, frames);
        QCOMPARE(video.framesPerSecond, framesPerSecond);
        QVERIFY2(std::abs(video.seconds - 1) < 1.5 / framesPerSecond,
                 qPrintable(QString::number(video.seconds)));
        // The sheet swings out of the middle: what is seen there changes, and is not black.
        const QByteArray pixels = test::middlePixels(out(name), {160, 100});
        QCOMPARE(pixels.size(), 3 * frames);
        QVERIFY(quint8(pixels[0]) > 60);
        QVERIFY(std::abs(int(quint8(pixels[0])) - int(quint8(pixels[3 * frames - 3]))) > 20);
        for (const char value : pixels)
            QVERIFY(quint8(value) > 8);
    }

    void aBlowUpEndsTheVideo() {
        CLOTHLAB_NEEDS_FFMPEG();
        QVERIFY(!saveScene(test::unstableScene(), in("scene.json").toStdString()));
        const auto run =
            render({"--output", out("a.mp4"), "--frames", "300", "--fps", "90", "--size", "80x50"});
        QVERIFY2(run.status == 4, qPrintable(run.err));
        QVERIFY(test::probe(out("a.mp4")).frames > 0);
    }

    void interruptedItLeavesNothingHalf_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<bool>("video");
        QTest::newRow("png") << "%d.png" << false;
        QTest::newRow("mp4") << "a.mp4" << true;
        QTest::newRow("webm") << "a.webm" << true;
    }
    void interruptedItLeavesNothingHalf() {
        QFETCH(QString, name);
        QFETCH(bool, video);
        if (video)
            CLOTHLAB_NEEDS_FFMPEG();
        QProcess process;
        prepare(process, {"--output", out(name), "--frames", "100000", "--size", "160x100"});
        process.start();
        QTRY_VERIFY_WITH_TIMEOUT(!files().isEmpty(), test::kProgramHangs);
        QTest::qWait(300);
        ::kill(pid_t(process.processId()), SIGINT);
        const auto run = test::finish(process);
        QVERIFY2(run.status == 130, qPrintable(run.err));
        QVERIFY2(run.err.contains("interrupted after"), qPrintable(run.err));
        QCOMPARE(files().isEmpty(), video);
        for (const QString& file : files())
            QCOMPARE(QImage(out(file)).size(), QSize(160, 100)); // whole
    }

    void aVideoThatCannotBeWritten() {
        CLOTHLAB_NEEDS_FFMPEG();
        const auto run = render({"--output", in("none/a.mp4"), "--frames", "3", "--size", "160x100"});
        QVERIFY2(run.status == 6, qPrintable(run.err));
        QVERIFY2(run.err.contains("none/a.mp4: there is no such"), qPrintable(run.err));
    }

private:
    QString in(const QString& name) const { return m_folder->filePath(name); }
    QString out(const QString& name) const { return m_folder->filePath("out/" + name); }
    QStringList files() const {
        return QDir(m_folder->filePath("out"))
            .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
    }
    void prepare(QProcess& process, const QStringList& arguments) const {
        test::prepare(process, QStringList{"render", in("scene.json")} + arguments);
        QProcessEnvironment environment = process.processEnvironment();
        environment.insert("DISPLAY", qEnvironmentVariable("DISPLAY"));
        process.setProcessEnvironment(environment);
    }
    test::ProgramResult render(const QStringList& arguments) const {
        QProcess process;
        prepare(process, arguments);
        process.start();
        return test::finish(process);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_GUILESS_MAIN(TestProgramVideo)
#include "tst_program_video.moc"
