// clothlab simulate --output x.clothtake, info and verify, as a program.
#include "simcore/recording/take_file.h"
#include "simcore/scene/scene_io.h"
#include "tests/support/program.h"
#include "tests/support/recorded_run.h"
#include "tests/support/scene_text.h"
#include "tests/support/tiny_scene.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

using namespace clothlab;
using test::runProgram;

class TestProgramTakes : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(!saveScene(test::tinyScene(), in("scene.json").toStdString()));
    }

    void simulateWritesWhatVerifyRepeats_data() {
        QTest::addColumn<QString>("error");
        QTest::newRow("default") << QString();
        QTest::newRow("coarse") << QString("0.001");
        QTest::newRow("lossless") << QString("0");
    }
    void simulateWritesWhatVerifyRepeats() {
        QFETCH(QString, error);
        const QString file = in("run.clothtake");
        QStringList arguments{"simulate", in("scene.json"), "--frames", "130", "--output", file};
        if (!error.isEmpty())
            arguments << "--error" << error;
        QCOMPARE(runProgram(arguments).status, 0);
        const auto verified = runProgram({"verify", file, "--threads", "2"});
        QCOMPARE(verified.status, 0);
        QVERIFY2(verified.out.contains("131 frames"), qPrintable(verified.out));

        const TakeFileReading reading = readTakeFile(file.toStdString());
        QVERIFY(reading.contents && reading.finished);
        const double stated = error.isEmpty() ? kDefaultError : error.toDouble();
        QCOMPARE(reading.contents->meta.error, stated);
        QCOMPARE(int(reading.contents->takes[0].checkpoints.size()), 4); // 0, 60, 120, 130
        const auto run = test::runFrames(test::tinyScene(), 130);
        for (int f = 0; f <= 130; ++f)
            QVERIFY(test::greatestDifference(*positionsOf(*findGroup(*reading.contents, 1, f), f),
                                             run[std::size_t(f)]->state.position) <= stated);
    }

    void goodFramesOfABlowUpAreKept() {
        QVERIFY(!saveScene(test::unstableScene(), in("unstable.json").toStdString()));
        const QString file = in("run.clothtake");
        QCOMPARE(runProgram({"simulate", in("unstable.json"), "--output", file}).status, 4);
        const auto verified = runProgram({"verify", file});
        QCOMPARE(verified.status, 0);
        QVERIFY2(verified.out.contains("4 frames"), qPrintable(verified.out));
    }

    void nothingIsThereUntilItIsFinished() {
        const auto result = runProgram(
            {"simulate", in("scene.json"), "--output", in("no/such/folder/run.clothtake"), "--frames", "3"});
        QCOMPARE(result.status, 6);
        QVERIFY(result.err.contains("run.clothtake"));
        QVERIFY(!QFile::exists(in("no")));
    }

    void infoSaysWhatIsThere() {
        const QString file = in("two.clothtake");
        QVERIFY(!writeTakeFile(file.toStdString(), test::twoTakes(kDefaultError).contents));
        const auto info = runProgram({"info", file});
        QCOMPARE(info.status, 0);
        for (const char* words : {"0.01 mm", "1 'Take 1', 9 x 7 points, 300 springs, frames 0 to 40",
                                  "frame 12: simulation.gravity[0] 0 -> 3",
                                  "2 'softer', branches off frame 9 of 1, frames 10 to 30",
                                  "frame 10: cloth.ks 5000 -> 3000", "marker at frame 29 of take 2: ends"})
            QVERIFY2(info.out.contains(words), qPrintable(QString(words) + " in\n" + info.out));
        QVERIFY(info.err.isEmpty());
    }

    void verifySaysWhereItDiffers() {
        test::TwoTakes made = test::twoTakes(kDefaultError);
        made.contents.takes[1].groups[0].frames[4].facts.stateHash ^= 1;
        const QString file = in("other.clothtake");
        QVERIFY(!writeTakeFile(file.toStdString(), made.contents));
        const auto result = runProgram({"verify", file});
        QCOMPARE(result.status, 5);
        QVERIFY2(result.err.contains("frame 14 of take 2 'softer'"), qPrintable(result.err));
    }

    void damagedFilesAreTold() {
        const std::string bytes = test::bytesOf(test::twoTakes(kDefaultError).contents);
        const QString file = in("cut.clothtake");
        const auto write = [&](const std::string& what) {
            QFile out(file);
            return out.open(QIODevice::WriteOnly) && out.write(what.data(), qint64(what.size())) >= 0;
        };
        QVERIFY(write(bytes.substr(0, bytes.size() * 2 / 3)));
        for (const char* command : {"info", "verify"}) {
            const auto result = runProgram({command, file});
            QCOMPARE(result.status, 1);
            QVERIFY2(result.err.contains("cut.clothtake: is cut off after frame"), qPrintable(result.err));
        }
        QVERIFY(write("{}"));
        for (const char* command : {"info", "verify"}) {
            QCOMPARE(runProgram({command, file}).status, 3);
            QCOMPARE(runProgram({command, in("none.clothtake")}).status, 3);
            QCOMPARE(runProgram({command}).status, 2);
            QCOMPARE(runProgram({command, file, file}).status, 2);
            QCOMPARE(runProgram({command, file, "--frobnicate"}).status, 2);
        }
        const auto wrong = runProgram({"simulate", in("scene.json"), "--error", "-1", "--output", file});
        QCOMPARE(wrong.status, 2);
        QVERIFY2(wrong.err.contains("--error"), qPrintable(wrong.err));
        QCOMPARE(runProgram({"simulate", in("scene.json"), "--output", in("a_%d.clothtake")}).status, 2);
    }

private:
    QString in(const QString& name) const { return m_folder->filePath(name); }
    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_GUILESS_MAIN(TestProgramTakes)
#include "tst_program_takes.moc"
