// What clothlab render refuses, and in which words. What it draws is in tests/gui/on_display.
#include "simcore/scene/scene_io.h"
#include "tests/support/program.h"
#include "tests/support/tiny_scene.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace clothlab;
using test::runProgram;

class TestProgramRender : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_scene = in("scene.json");
        QVERIFY(!saveScene(test::tinyScene(), m_scene.toStdString()));
    }

    void wrongUsage_data() {
        QTest::addColumn<QString>("arguments");
        QTest::addColumn<QString>("words"); // that the message must hold
        const auto row = [](const char* arguments, const char* words) {
            QTest::newRow(arguments) << QString(arguments) << words;
        };
        row("", "one scene");
        row("SCENE SCENE --output a.png", "one scene");
        row("SCENE", "--output");
        row("SCENE --output a.jpg", ".png");
        row("SCENE --output=", ".png");
        row("SCENE --output a.png --size 10", "'10'");
        row("SCENE --output a.png --size 0x10", "--size takes WIDTHxHEIGHT");
        row("SCENE --output a.png --size 10x10x10", "--size");
        row("SCENE --output a.png --frame -1", "--frame");
        row("SCENE --output a.png --frame 1.5", "'1.5'");
        row("SCENE --output a.png --threads 0", "--threads");
        row("SCENE --output a.png --shader Velvet", "no 'Velvet'");
        row("SCENE --output a.png --shader phong", "Phong"); // what there is
        row("SCENE --output a.png --shader-dir none", "no folder 'none'");
        row("SCENE --output a.png --shader-dir=", "--shader-dir");
        row("SCENE --output a.png --frames 3", "frame_%04d.png"); // a sequence's
        row("SCENE --output a.png --fps 30", "frame_%04d.png");
        row("SCENE --output a%d.png --frame 3", "--frames");
        row("SCENE --output a.mp4 --frame 3", "--frames");
        row("SCENE --output a%d.mp4", "leave out");
        row("SCENE --output a%d%d.png", "at most one");
        row("SCENE --output a%s.png", "at most one");
        row("SCENE --output a%d.png --frames -1", "'-1'");
        row("SCENE --output a%d.png --fps 0", "--fps");
        row("SCENE --output a%d.png --shader all", "one picture");
        row("SCENE --output a.webm --shader all", "one picture");
        row("SCENE --output a.mp4 --size 321x200", "even");
        row("SCENE --output a.avi", ".webm");
        row("SCENE --output", "output");
    }
    void wrongUsage() {
        QFETCH(QString, arguments);
        QFETCH(QString, words);
        QStringList all = arguments.split(' ', Qt::SkipEmptyParts);
        all.replaceInStrings("SCENE", m_scene);
        const auto run = runProgram(QStringList{"render"} + all, {"QT_QPA_PLATFORM=offscreen"});
        QVERIFY2(run.status == 2, qPrintable(run.err));
        QVERIFY(run.out.isEmpty());
        QVERIFY2(run.err.contains("clothlab: ") && run.err.contains(words), qPrintable(run.err));
        QVERIFY(run.err.contains("--help"));
    }

    void badScenes() {
        QFile file(in("bad.json"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(R"({"cloth": {"ks": "stiff"}})");
        file.close();
        for (const QString& scene : {in("bad.json"), in("missing.json"), m_folder->path()}) {
            const auto run =
                runProgram({"render", scene, "--output", in("a.png")}, {"QT_QPA_PLATFORM=offscreen"});
            QVERIFY2(run.status == 3, qPrintable(run.err));
            QVERIFY2(run.err.contains(scene + ": "), qPrintable(run.err));
            QVERIFY(!QFile::exists(in("a.png")));
        }
    }

    void aBlowUpIsNoPicture() {
        QVERIFY(!saveScene(test::unstableScene(), m_scene.toStdString()));
        const auto run = runProgram({"render", m_scene, "--frame", "50", "--output", in("a.png")},
                                    {"QT_QPA_PLATFORM=offscreen"});
        QVERIFY2(run.status == 4, qPrintable(run.err));
        QVERIFY(!QFile::exists(in("a.png")));
    }

    void noMoreFramesThanThereAre() {
        Scene scene = test::tinyScene();
        scene.simulation.framesPerSecond = 50;
        QVERIFY(!saveScene(scene, m_scene.toStdString()));
        const auto run = runProgram({"render", m_scene, "--output", in("a%d.png"), "--fps", "51"},
                                    {"QT_QPA_PLATFORM=offscreen"});
        QVERIFY2(run.status == 2, qPrintable(run.err));
        QVERIFY2(run.err.contains("the scene has 50"), qPrintable(run.err));
    }

    void videoWithoutFfmpegSaysHowToGetIt() {
        const auto run = runProgram({"render", m_scene, "--output", in("a.mp4")},
                                    {"QT_QPA_PLATFORM=offscreen", "PATH=" + m_folder->path()});
        QVERIFY2(run.status == 6, qPrintable(run.err));
        QVERIFY2(run.err.contains("a.mp4: ") && run.err.contains("apt install ffmpeg"), qPrintable(run.err));
        QVERIFY(!QFile::exists(in("a.mp4")));
    }

    void withoutADisplayItSaysWhatDoes_data() {
        QTest::addColumn<QStringList>("environment");
        QTest::newRow("no display") << QStringList{};
        QTest::newRow("empty") << QStringList{"DISPLAY="};
        QTest::newRow("a display that is not there") << QStringList{"DISPLAY=:59999"};
    }
    void withoutADisplayItSaysWhatDoes() {
        QFETCH(QStringList, environment);
        const auto run = runProgram({"render", m_scene, "--output", in("a.png")}, environment);
        QVERIFY2(run.status == 2, qPrintable(run.err));
        QVERIFY2(run.err.contains("no display"), qPrintable(run.err));
        QVERIFY2(run.err.contains("X server") && run.err.contains("xvfb-run"), qPrintable(run.err));
        QVERIFY(!QFile::exists(in("a.png")));
    }

private:
    QString in(const QString& name) const { return m_folder->filePath(name); }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_scene;
};

QTEST_GUILESS_MAIN(TestProgramRender)
#include "tst_program_render.moc"
