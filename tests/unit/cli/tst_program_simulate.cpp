// clothlab simulate, as a program: what it computes, writes and says, and how it ends.
#include "simcore/cloth/cloth_state.h"
#include "simcore/inspect/inspect.h"
#include "simcore/inspect/stability.h"
#include "simcore/recording/recording.h"
#include "simcore/scene/scene_io.h"
#include "simcore/solver/verlet_solver.h"
#include "tests/support/program.h"
#include "tests/support/scene_text.h"
#include "tests/support/tiny_scene.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

#include <csignal>

using namespace clothlab;
using nlohmann::json;
using test::runProgram;

namespace {

// A run on the spot, as the program should make it.
struct Solved {
    Scene scene;
    VerletSolver solver{scene};
    std::vector<ClothState> states{solver.start()};
    std::int64_t corrections = 0;
    std::optional<BlowUp> blowUp;
    int blowUpStep = 0;

    Solved(Scene s, int frames) : scene(std::move(s)) {
        while (int(states.size()) <= frames) {
            ClothState state = states.back();
            std::int64_t inFrame = 0;
            for (int step = 1; step <= scene.simulation.stepsPerFrame; ++step) {
                const StepResult result = solver.step(state);
                inFrame += result.strainLimitCorrections;
                if (result.blowUp) {
                    blowUp = result.blowUp;
                    blowUpStep = step;
                    return;
                }
            }
            states.push_back(std::move(state));
            corrections += inFrame;
        }
    }
    std::string hash() const {
        char text[17];
        std::snprintf(text, sizeof text, "%016llx",
                      static_cast<unsigned long long>(stateHash(states.back())));
        return text;
    }
};

// Every collider and a sheet that stretches, so that all phases have something to do.
Scene busyScene() {
    Scene scene = test::tinyScene();
    scene.cloth.numWidthPoints = 9;
    scene.cloth.numHeightPoints = 7;
    scene.cloth.ks = 40;
    scene.cloth.orientation = Orientation::Vertical;
    scene.simulation.seed = 5;
    scene.simulation.framesPerSecond = 50;
    scene.spheres.emplace_back().origin = {0.5, 0.1, 0.05};
    scene.planes.emplace_back();
    return scene;
}

std::vector<std::vector<double>> numbersAfter(const QByteArray& text, const QByteArray& prefix,
                                              char separator) {
    std::vector<std::vector<double>> rows;
    for (const QByteArray& line : text.split('\n')) {
        if (line.isEmpty() || !line.startsWith(prefix))
            continue;
        auto& row = rows.emplace_back();
        for (const QByteArray& word : line.mid(prefix.size()).split(separator))
            row.push_back(word.toDouble());
    }
    return rows;
}

QByteArray read(const QString& path) {
    return QByteArray::fromStdString(test::readText(path.toStdString()));
}

std::vector<double> asRow(const Vec3& v) {
    return {v.x(), v.y(), v.z()};
}

} // namespace

class TestProgramSimulate : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_scene = in("scene.json");
    }

    void theReportIsThatOfTheSolver() {
        const Solved expected(busyScene(), 40);
        QVERIFY(expected.corrections > 0);
        saveAs(expected.scene);
        const auto run = runProgram({"simulate", m_scene, "--frames", "40", "--report", "-"});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QVERIFY(run.out.endsWith('\n'));
        const json report = test::report(run.out);
        QVERIFY2(report.is_object(), qPrintable(run.out));
        const std::int64_t steps = 40 * 3;
        QCOMPARE(report.at("points").get<int>(), 63);
        QCOMPARE(report.at("springs").get<int>(), expected.solver.sheet().grid.springCount());
        QCOMPARE(report.at("frames").get<int>(), 40);
        QCOMPARE(report.at("steps").get<std::int64_t>(), steps);
        QCOMPARE(report.at("strain_limit_corrections").get<std::int64_t>(), expected.corrections);
        const auto seconds = report.at("seconds").get<double>();
        QVERIFY(seconds > 0);
        QVERIFY(
            qFuzzyCompare(report.at("point_steps_per_second").get<double>(), 63.0 * double(steps) / seconds));
        QVERIFY(qFuzzyCompare(report.at("milliseconds_per_frame").get<double>(), 1000 * seconds / 40));
        const ClothState& last = expected.states.back();
        const auto strain = maxStrain(expected.solver.sheet(), last.position);
        QCOMPARE(report.at("max_strain").at("structural").get<double>(), strain[0]);
        QCOMPARE(report.at("max_strain").at("shearing").get<double>(), strain[1]);
        QCOMPARE(report.at("max_strain").at("bending").get<double>(), strain[2]);
        QCOMPARE(report.at("max_strain").size(), 3U);
        QCOMPARE(report.at("kinetic_energy").get<double>(), kineticEnergy(expected.scene, last));
        QCOMPARE(report.at("potential_energy").get<double>(),
                 potentialEnergy(expected.scene, expected.solver.sheet(), last.position));
        QCOMPARE(report.at("state_hash").get<std::string>(), expected.hash());
        QVERIFY(report.at("finite").get<bool>());
        QVERIFY(!report.contains("blow_up") && !report.contains("interrupted"));
    }

    void theSameRunTwiceHasTheSameHash() {
        saveAs(busyScene());
        const QStringList arguments{"simulate", m_scene, "--frames", "10", "--report", "-"};
        const json once = test::report(runProgram(arguments).out);
        const json again = test::report(runProgram(arguments).out);
        const json threads = test::report(runProgram(arguments + QStringList{"--threads", "2"}).out);
        QVERIFY(once.is_object() && once.contains("state_hash"));
        for (const json& other : {again, threads}) {
            QVERIFY(other.at("state_hash") == once.at("state_hash"));
            QVERIFY(other.at("kinetic_energy") == once.at("kinetic_energy"));
        }
    }

    void theDefaultIsNinetyFrames() {
        saveAs(test::tinyScene());
        const json report = test::report(runProgram({"simulate", m_scene, "--report=-"}).out);
        QCOMPARE(report.at("frames").get<int>(), 90);
        QCOMPARE(report.at("state_hash").get<std::string>(), Solved(test::tinyScene(), 90).hash());
    }

    void noFramesIsTheStart() {
        saveAs(busyScene());
        const auto run = runProgram({"simulate", m_scene, "--frames", "0", "--report", "-", "--output",
                                     in("%d.csv"), "--output", in("a.obj")});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        const json report = test::report(run.out);
        QCOMPARE(report.at("steps").get<int>(), 0);
        QCOMPARE(report.at("milliseconds_per_frame").get<double>(), 0.0);
        QCOMPARE(report.at("point_steps_per_second").get<double>(), 0.0);
        QCOMPARE(report.at("state_hash").get<std::string>(), Solved(busyScene(), 0).hash());
        QCOMPARE(files(), QStringList({"0.csv", "a.obj", "scene.json"}));
    }

    void framesAndStepsReplaceThoseOfTheScene() {
        saveAs(busyScene());
        Scene changed = busyScene();
        changed.simulation.framesPerSecond = 77;
        changed.simulation.stepsPerFrame = 11;
        const auto run = runProgram(
            {"simulate", m_scene, "--frames", "6", "--fps", "77", "--steps", "11", "--report", in("r.json")});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QVERIFY(run.out.isEmpty());
        const json report = test::report(read(in("r.json")));
        QCOMPARE(report.at("steps").get<int>(), 66);
        QCOMPARE(report.at("state_hash").get<std::string>(), Solved(changed, 6).hash());
        QVERIFY(Solved(changed, 6).hash() != Solved(busyScene(), 6).hash());
    }

    void anObjReadsBack() {
        const Solved expected(busyScene(), 12);
        saveAs(expected.scene);
        QCOMPARE(runProgram({"simulate", m_scene, "--frames", "12", "--output", in("a.obj")}).status, 0);
        const QByteArray text = read(in("a.obj"));
        const auto vertices = numbersAfter(text, "v ", ' ');
        QCOMPARE(vertices.size(), 63U);
        for (int i = 0; i < 63; ++i)
            QVERIFY(vertices[std::size_t(i)] == asRow(expected.states.back().position.at(i)));
        QCOMPARE(numbersAfter(text, "vt ", ' ').size(), 63U);
        QCOMPARE(numbersAfter(text, "vn ", ' ').size(), 63U);
        QCOMPARE(text.count("\nf "), 2 * 8 * 6);
        QVERIFY(text.contains(" 63/63/63") && !text.contains(" 64/") && !text.contains(" 0/"));
    }

    void aCsvReadsBack() {
        const Solved expected(busyScene(), 12);
        saveAs(expected.scene);
        QCOMPARE(runProgram({"simulate", m_scene, "--frames", "12", "--output", in("a.CSV")}).status, 0);
        const QByteArray text = read(in("a.CSV"));
        const QByteArrayList header = text.left(text.indexOf('\n')).split(',');
        const auto rows = numbersAfter(text.mid(text.indexOf('\n') + 1), "", ',');
        QCOMPARE(rows.size(), 63U);
        const auto columns = [&](int i, const QByteArray& name) {
            std::vector<double> xyz;
            for (const char* axis : {"_x", "_y", "_z"})
                xyz.push_back(rows[std::size_t(i)].at(std::size_t(header.indexOf(name + axis))));
            return xyz;
        };
        const ClothState& state = expected.states.back();
        for (int i = 0; i < 63; ++i) {
            QVERIFY(columns(i, "position") == asRow(state.position.at(i)));
            QVERIFY(columns(i, "last_position") == asRow(state.lastPosition.at(i)));
            QVERIFY(columns(i, "velocity") ==
                    asRow(velocity(state, i, expected.scene.simulation.timeStep())));
            QCOMPARE(rows[std::size_t(i)].back(), i == 0 || i == 3 ? 1.0 : 0.0);
        }
    }

    void aSequenceHoldsEveryFrame() {
        const Solved expected(busyScene(), 3);
        saveAs(expected.scene);
        const auto run = runProgram({"simulate", m_scene, "--frames", "3", "--output", in("a_%04d.obj"),
                                     "--output", in("b%d.csv"), "--output", in("last%%.obj")});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QCOMPARE(files(), QStringList({"a_0000.obj", "a_0001.obj", "a_0002.obj", "a_0003.obj", "b0.csv",
                                       "b1.csv", "b2.csv", "b3.csv", "last%.obj", "scene.json"}));
        for (int frame = 0; frame <= 3; ++frame) {
            const auto vertices = numbersAfter(read(in(QString("a_000%1.obj").arg(frame))), "v ", ' ');
            QVERIFY(vertices.at(62) == asRow(expected.states[std::size_t(frame)].position.at(62)));
        }
        QCOMPARE(read(in("last%.obj")), read(in("a_0003.obj")));
    }

    void aBlowUpIsToldByPlace() {
        const Solved expected(test::unstableScene(), 100);
        QVERIFY(expected.blowUp.has_value());
        const int frame = int(expected.states.size());
        saveAs(expected.scene);
        const auto run = runProgram({"simulate", m_scene, "--frames", "100", "--report", "-", "--output",
                                     in("%d.csv"), "--output", in("a.obj")});
        QCOMPARE(run.status, 4);
        const json report = test::report(run.out);
        QVERIFY2(report.is_object(), qPrintable(run.out));
        const json& blowUp = report.at("blow_up");
        QCOMPARE(blowUp.at("frame").get<int>(), frame);
        QCOMPARE(blowUp.at("step").get<int>(), expected.blowUpStep);
        QCOMPARE(blowUp.at("point").get<int>(), expected.blowUp->point);
        QCOMPARE(blowUp.at("x").get<int>(), expected.blowUp->point % 4);
        QCOMPARE(blowUp.at("y").get<int>(), expected.blowUp->point / 4);
        QCOMPARE(blowUp.at("phase").get<std::string>(), std::string(name(expected.blowUp->phase)));
        QVERIFY(!report.at("finite").get<bool>());
        QCOMPARE(report.at("frames").get<int>(), frame - 1);
        QCOMPARE(report.at("state_hash").get<std::string>(), expected.hash()); // of the last good frame
        const QString place = QString("frame %1, step %2, ").arg(frame).arg(expected.blowUpStep);
        QVERIFY2(run.err.contains(place), qPrintable(run.err));
        QVERIFY2(run.err.contains(QString("point %1 ").arg(expected.blowUp->point)), qPrintable(run.err));
        const QString steps = QString("beyond 2.00: at least %1 steps per frame")
                                  .arg(stability(expected.scene).stableStepsPerFrame.value_or(0));
        QVERIFY2(run.err.contains(steps), qPrintable(run.err));
        QCOMPARE(files().size(), frame + 2); // frames 0 to the last good one, that one again, and the scene
        QCOMPARE(numbersAfter(read(in("a.obj")), "v ", ' ').size(), 16U);
    }

    void outputsThatCannotBeWritten_data() {
        QTest::addColumn<QStringList>("options");
        QTest::newRow("no such folder") << QStringList{"--output", "FOLDER/none/a.obj"};
        QTest::newRow("sequence, no such folder") << QStringList{"--output", "FOLDER/none/%d.obj"};
        QTest::newRow("a folder") << QStringList{"--output", "FOLDER/folder.csv"};
        QTest::newRow("in a file") << QStringList{"--output", "FOLDER/scene.json/a.obj"};
        QTest::newRow("report, no such folder") << QStringList{"--report", "FOLDER/none/r.json"};
        QTest::newRow("report is a folder") << QStringList{"--report", "FOLDER"};
        QTest::newRow("report is a device") << QStringList{"--report", "/dev/full"};
    }
    void outputsThatCannotBeWritten() {
        QFETCH(QStringList, options);
        options.replaceInStrings("FOLDER", m_folder->path());
        saveAs(test::tinyScene());
        QVERIFY(QDir(m_folder->path()).mkdir("folder.csv"));
        const auto run = runProgram(QStringList{"simulate", m_scene, "--frames", "2"} + options);
        QCOMPARE(run.status, 6);
        QVERIFY2(run.err.startsWith("clothlab: ") && run.err.size() > 20, qPrintable(run.err));
        QCOMPARE(files(), QStringList({"folder.csv", "scene.json"})); // no half file
        QVERIFY(QDir(in("folder.csv")).isEmpty());
    }

    void aReportThatStdoutCannotTake() {
        saveAs(test::tinyScene());
        QProcess process;
        test::prepare(process, {"simulate", m_scene, "--frames", "1", "--report", "-"});
        process.setStandardOutputFile("/dev/full");
        process.start();
        QCOMPARE(test::finish(process).status, 6);
    }

    void interruptingEndsCleanly_data() {
        QTest::addColumn<int>("signal");
        QTest::newRow("SIGINT") << SIGINT;
        QTest::newRow("SIGTERM") << SIGTERM;
    }
    void interruptingEndsCleanly() {
        QFETCH(int, signal);
        saveAs(busyScene());
        QProcess process;
        test::prepare(process, {"simulate", m_scene, "--frames", "100000000", "--steps", "3000", "--output",
                                in("f%d.obj"), "--output", in("last.csv"), "--report", "-"});
        process.start();
        QTRY_VERIFY_WITH_TIMEOUT(QFile::exists(in("f1.obj")), 120'000); // it is well under way
        QCOMPARE(::kill(pid_t(process.processId()), signal), 0);
        const auto run = test::finish(process);
        QVERIFY2(run.status == 130, qPrintable(run.err));
        QVERIFY2(run.err.contains("interrupted"), qPrintable(run.err));
        const json report = test::report(run.out);
        QVERIFY2(report.is_object(), qPrintable(run.out));
        QVERIFY(report.at("interrupted").get<bool>());
        QVERIFY(report.at("finite").get<bool>());
        const int frames = report.at("frames").get<int>();
        QVERIFY(frames >= 1);
        QCOMPARE(files().size(), frames + 1 + 2); // 0 … frames, the last one, the scene; nothing temporary
        for (int frame = 0; frame <= frames; ++frame) {
            const QByteArray text = read(in(QString("f%1.obj").arg(frame)));
            QVERIFY(text.endsWith('\n'));
            QCOMPARE(text.count("\nf "), 2 * 8 * 6);
        }
        QCOMPARE(read(in("last.csv")).count('\n'), 64);
    }

private:
    QString in(const QString& name) const { return m_folder->filePath(name); }
    void saveAs(const Scene& scene) const {
        const auto error = saveScene(scene, m_scene.toStdString());
        QVERIFY2(!error, error ? error->c_str() : "");
    }
    QStringList files() const {
        return QDir(m_folder->path())
            .entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot, QDir::Name);
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    QString m_scene;
};

QTEST_GUILESS_MAIN(TestProgramSimulate)
#include "tst_program_simulate.moc"
