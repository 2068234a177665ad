// The program's words and exit statuses: help, wrong usage, bad scenes, check, and windows without a display.
#include "simcore/inspect/stability.h"
#include "simcore/scene/scene_io.h"
#include "tests/support/program.h"
#include "tests/support/scene_text.h"
#include "tests/support/tiny_scene.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>
#include <QTest>

using namespace clothlab;
using test::runProgram;

class TestProgramUsage : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_scene = in("scene.json");
        QVERIFY(!saveScene(test::tinyScene(), m_scene.toStdString()));
    }

    void helpNamesAllThatThereIs() {
        const auto help = runProgram({"--help"});
        QCOMPARE(help.status, 0);
        QVERIFY(help.err.isEmpty());
        // The options that these tests try; one that help names must be among them.
        const QSet<QString> tried{"--screenshot", "--frames",  "--theme",    "--size",       "--fps",
                                  "--steps",      "--threads", "--output",   "--report",     "--help",
                                  "--version",    "--frame",   "--shader",   "--shader-dir", "--fit",
                                  "--axis",       "--scale",   "--measures", "--error"};
        QSet<QString> named;
        static const QRegularExpression option("--[a-z-]+");
        for (auto it = option.globalMatch(help.out); it.hasNext();)
            named.insert(it.next().captured());
        QCOMPARE(named, tried);
        for (const char* words :
             {"clothlab simulate SCENE", "clothlab render SCENE", "clothlab check SCENE",
              "clothlab info RECORDING", "clothlab verify RECORDING", "5 a recording", "%04d", "0 done",
              "1 check", "2 wrong usage", "3 the input", "4 the simulation", "6 an output", "130 "})
            QVERIFY2(help.out.contains(words), words);
        QCOMPARE(runProgram({"-h"}).out, help.out);
        const auto version = runProgram({"--version"});
        QCOMPARE(version.status, 0);
        static const QRegularExpression number("^clothlab \\d+\\.\\d+\\.\\d+\n$");
        QVERIFY2(number.match(version.out).hasMatch(), qPrintable(version.out));
    }

    void wrongUsage_data() {
        QTest::addColumn<QStringList>("arguments");
        QTest::addColumn<QString>("words"); // that the message must hold
        const auto row = [](const char* arguments, const char* words) {
            QTest::newRow(arguments) << QString(arguments).split(' ') << words;
        };
        row("simulate", "SCENE");
        row("simulate SCENE SCENE", "one scene");
        row("simulate SCENE --frobnicate", "frobnicate");
        row("simulate SCENE --frames", "frames");
        row("simulate SCENE --frames -1", "--frames");
        row("simulate SCENE --frames 1.5", "'1.5'");
        row("simulate SCENE --frames many", "'many'");
        row("simulate SCENE --frames 99999999999", "--frames");
        row("simulate SCENE --fps 0", "--fps");
        row("simulate SCENE --fps 100001", "from 1 to 100000");
        row("simulate SCENE --steps 0", "--steps");
        row("simulate SCENE --steps x", "'x'");
        row("simulate SCENE --threads 0", "--threads");
        row("simulate SCENE --output a.stl", ".obj, .ply, .csv, .pc2, .mdd, .glb or .clothtake");
        row("simulate SCENE --output a", ".glb or .clothtake");
        row("simulate SCENE --output .obj", ".glb or .clothtake");
        row("simulate SCENE --output a%d.pc2", "leave out %d");
        row("simulate SCENE --output %04d.mdd", "all frames");
        row("simulate SCENE --output a_%04d.glb", "all frames");
        row("simulate SCENE --axis x", "'x'");
        row("simulate SCENE --axis Z", "y or z");
        row("simulate SCENE --scale 0", "--scale");
        row("simulate SCENE --scale -1", "'-1'");
        row("simulate SCENE --scale nan", "'nan'");
        row("simulate SCENE --scale 1e7", "1e+06");
        row("simulate SCENE --scale 1m", "'1m'");
        row("simulate SCENE --measures a.obj", ".csv");
        row("simulate SCENE --measures=", ".csv");
        row("simulate SCENE --output a.csv --measures ./a.csv", "another name");
        row("simulate SCENE --output a.obj --output b.txt", "b.txt");
        row("simulate SCENE --output %s.obj", "%d");
        row("simulate SCENE --output %d%d.obj", "%04d");
        row("simulate SCENE --report=", "--report");
        row("check", "SCENE");
        row("check SCENE SCENE", "SCENE");
        row("check --frames", "SCENE");
    }
    void wrongUsage() {
        QFETCH(QStringList, arguments);
        QFETCH(QString, words);
        arguments.replaceInStrings("SCENE", m_scene);
        const QStringList before = QDir(m_folder->path()).entryList();
        const auto run = runProgram(arguments);
        QCOMPARE(run.status, 2);
        QVERIFY(run.out.isEmpty());
        QVERIFY2(run.err.startsWith("clothlab: ") && run.err.contains(words), qPrintable(run.err));
        QCOMPARE(QDir(m_folder->path()).entryList(), before);
    }

    void badScenes_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QStringList>("words"); // place and remedy
        QTest::newRow("missing") << QByteArray("-") << QStringList{"no such file", "check its name"};
        QTest::newRow("folder") << QByteArray("/") << QStringList{"is a folder", "name a file in it"};
        QTest::newRow("no JSON") << QByteArray("{\"cloth\": {},\n \"sphere\" 3}")
                                 << QStringList{"line 2, column 11"};
        QTest::newRow("wrong type") << QByteArray(R"({"cloth": {"ks": "stiff"}})")
                                    << QStringList{"cloth.ks: must be a number", "give a number from 0 to"};
        QTest::newRow("out of range") << QByteArray(R"({"cloth": {"num_width_points": 1}})")
                                      << QStringList{"cloth.num_width_points: ", "from 2 to 65536"};
        QTest::newRow("a pin outside") << QByteArray(R"({"cloth": {"pinned": [[0, 0], [0, 50]]}})")
                                       << QStringList{"cloth.pinned[1]: ", "y from 0 to 49"};
        QTest::newRow("several") << QByteArray(R"({"cloth": {"ks": -1, "damping": 101}})")
                                 << QStringList{"cloth.ks: ", "cloth.damping: "};
    }
    void badScenes() {
        QFETCH(QByteArray, text);
        QFETCH(QStringList, words);
        const QString path = text == "/" ? m_folder->path() : in("bad.json");
        if (text.size() > 1)
            write(path, text);
        for (const QStringList& arguments :
             {QStringList{"simulate", path, "--report", in("r.json"), "--output", in("a.obj")},
              QStringList{"check", path}}) {
            const auto run = runProgram(arguments);
            QCOMPARE(run.status, 3);
            QVERIFY(!run.out.contains("no problems"));
            words << path + ": ";
            for (const QString& word : words)
                QVERIFY2(run.err.contains(word), qPrintable(word + " is not in " + run.err));
        }
        QVERIFY(!QFile::exists(in("r.json")) && !QFile::exists(in("a.obj")));
        // And a window for a picture says the same.
        const auto window = picture({path});
        QCOMPARE(window.status, 3);
        QVERIFY2(window.err.contains(words.first()), qPrintable(window.err));
        QVERIFY(!QFile::exists(in("a.png")));
    }

    void checkSaysWhatItFound() {
        const auto good = runProgram({"check", m_scene});
        QCOMPARE(good.status, 0);
        QCOMPARE(good.out, m_scene + ": no problems\n");
        QVERIFY(good.err.isEmpty());

        Scene doubtful = test::tinyScene();
        doubtful.cloth.pinned = {};
        QVERIFY(!saveScene(doubtful, in("doubtful.json").toStdString()));
        const auto warned = runProgram({"check", in("doubtful.json")});
        QCOMPARE(warned.status, 1);
        QVERIFY2(warned.out.contains("cloth.pinned: ") && warned.out.contains("falls forever"),
                 qPrintable(warned.out));
        QVERIFY(warned.err.isEmpty());
        // Doubtful scenes run, and the warning is not lost in what they print.
        const auto run = runProgram({"simulate", in("doubtful.json"), "--frames", "1", "--report", "-"});
        QCOMPARE(run.status, 0);
        QVERIFY(run.err.contains("falls forever"));
        QVERIFY(test::report(run.out).is_object());
    }

    void checkWarnsOfAStepTooLong() {
        Scene scene = test::tinyScene();
        scene.simulation.framesPerSecond = 90;
        const auto check = [&](int steps) {
            scene.simulation.stepsPerFrame = steps;
            return saveScene(scene, m_scene.toStdString()) ? test::ProgramResult{}
                                                           : runProgram({"check", m_scene});
        };
        scene.cloth.ks = 1e7;
        const int least = stability(scene).stableStepsPerFrame.value_or(0);
        QVERIFY(least > 10);
        const auto stable = check(least);
        QCOMPARE(stable.status, 0);
        QCOMPARE(stable.out, m_scene + ": no problems\n");
        const auto unstable = check(least / 2);
        QCOMPARE(unstable.status, 1);
        QVERIFY(unstable.err.isEmpty());
        QCOMPARE(unstable.out,
                 m_scene + QString(": simulation.steps_per_frame: dt·ω is %1, beyond 2.00 where "
                                   "the step becomes unstable; %2 steps per frame or more are "
                                   "stable\n")
                               .arg(stability(scene).dtOmega, 0, 'f', 2)
                               .arg(least));
        // A run warns of the step that it takes, not of that in the file.
        const QStringList run{"simulate", m_scene, "--frames", "0", "--steps"};
        QVERIFY(runProgram(run + QStringList{QString::number(least - 1)}).err.contains("beyond 2.00"));
        QVERIFY(runProgram(run + QStringList{QString::number(least)}).err.isEmpty());
    }

    void theScenesThatComeWithTheProgramAreGood() {
        for (const QString& file : QDir(CLOTHLAB_SOURCE_DIR "/scenes").entryList({"*.json"})) {
            const auto run = runProgram({"check", CLOTHLAB_SOURCE_DIR "/scenes/" + file});
            QVERIFY2(run.status <= 1, qPrintable(run.err));
        }
    }

    void aWindowWithoutADisplayIsRefusedInWords_data() {
        QTest::addColumn<QStringList>("environment");
        QTest::newRow("no display") << QStringList{};
        QTest::newRow("empty") << QStringList{"DISPLAY="};
        QTest::newRow("a display that is not there") << QStringList{"DISPLAY=:59999"};
        QTest::newRow("a platform that is not there") << QStringList{"QT_QPA_PLATFORM=nonsense"};
    }
    void aWindowWithoutADisplayIsRefusedInWords() {
        QFETCH(QStringList, environment);
        for (const QStringList& arguments :
             {QStringList{}, QStringList{m_scene}, QStringList{m_scene, "--screenshot", in("a.png")}}) {
            const auto run = runProgram(arguments, environment);
            QVERIFY2(run.status == 2, qPrintable(run.err));
            QVERIFY2(run.err.contains("clothlab: no display"), qPrintable(run.err));
            QVERIFY2(run.err.contains("clothlab simulate needs none"),
                     qPrintable(run.err)); // what to do instead
        }
    }

    void wrongUsageOfAWindow_data() {
        QTest::addColumn<QString>("arguments");
        QTest::addColumn<QString>("words");
        QTest::newRow("option") << "--frobnicate"
                                << "frobnicate";
        QTest::newRow("theme") << "--theme pink"
                               << "'pink'";
        QTest::newRow("size") << "--size 10"
                              << "--size";
        QTest::newRow("size of nothing") << "--size 0x100"
                                         << "--size";
        QTest::newRow("frames") << "--screenshot a.png --frames -3"
                                << "--frames";
        QTest::newRow("two scenes") << "a.json b.json"
                                    << "one scene";
        QTest::newRow("no name") << "--screenshot="
                                 << "--screenshot";
        QTest::newRow("no folder of shaders") << "--shader-dir none"
                                              << "no folder 'none'";
        QTest::newRow("no name of a folder of shaders") << "--shader-dir="
                                                        << "--shader-dir";
        QTest::newRow("no value") << "--theme"
                                  << "theme";
    }
    void wrongUsageOfAWindow() {
        QFETCH(QString, arguments);
        QFETCH(QString, words);
        const auto run = runProgram(arguments.split(' '), {"QT_QPA_PLATFORM=offscreen"});
        QCOMPARE(run.status, 2);
        QVERIFY2(run.err.contains("clothlab: ") && run.err.contains(words), qPrintable(run.err));
    }

    void aPictureOfTheWindow() {
        const auto dark = picture({m_scene, "--frames", "2", "--size", "1200x800", "--theme", "dark"});
        QVERIFY2(dark.status == 0, qPrintable(dark.err));
        const QImage darkImage(in("a.png"));
        QCOMPARE(darkImage.size(), QSize(1200, 800));
        const auto light = picture({m_scene, "--frames", "2", "--size", "1200x800", "--theme", "light"});
        QCOMPARE(light.status, 0);
        const QImage lightImage(in("a.png"));
        QVERIFY(brightness(lightImage) > brightness(darkImage) + 30);
    }

    void aPictureOfABlowUpSaysSo() {
        QVERIFY(!saveScene(test::unstableScene(), m_scene.toStdString()));
        const auto run = picture({m_scene, "--frames", "50"});
        QVERIFY2(run.status == 4, qPrintable(run.err));
        QVERIFY2(run.err.contains("clothlab: ") && run.err.contains("frame"), qPrintable(run.err));
        QVERIFY(!QImage(in("a.png")).isNull());
    }

    void aPictureThatCannotBeWritten() {
        const auto run = runProgram({m_scene, "--frames", "0", "--screenshot", in("none/a.png")},
                                    {"QT_QPA_PLATFORM=offscreen"});
        QCOMPARE(run.status, 6);
        QVERIFY(run.err.contains("clothlab: "));
    }

private:
    QString in(const QString& name) const { return m_folder->filePath(name); }
    static void write(const QString& path, const QByteArray& text) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(text), text.size());
    }
    test::ProgramResult picture(const QStringList& arguments) const {
        return runProgram(QStringList{"--screenshot", in("a.png")} + arguments,
                          {"QT_QPA_PLATFORM=offscreen", "XDG_CONFIG_HOME=" + m_folder->path()});
    }
    static double brightness(const QImage& image) {
        const QImage one = image.scaled(1, 1, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
        return qGray(one.pixel(0, 0));
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_scene;
};

QTEST_GUILESS_MAIN(TestProgramUsage)
#include "tst_program_usage.moc"
