// clothlab simulate, as a program: what it computes, writes and says, and how it ends.
#include "simcore/cloth/cloth_state.h"
#include "simcore/inspect/inspect.h"
#include "simcore/inspect/stability.h"
#include "simcore/recording/frame.h"
#include "simcore/scene/scene_io.h"
#include "simcore/solver/verlet_solver.h"
#include "tests/support/export_frames.h"
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

    void aFileForAllFramesHoldsThem() {
        const Solved expected(busyScene(), 5);
        saveAs(expected.scene);
        const auto run = runProgram({"simulate", m_scene, "--frames", "5", "--output", in("a.pc2"),
                                     "--output", in("b.mdd"), "--output", in("c.glb"), "--output",
                                     in("d.ply"), "--output", in("e%d.ply"), "--output", in("f%d.obj")});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        QCOMPARE(files(), QStringList({"a.obj", "a.pc2", "b.mdd", "b.obj", "c.glb", "d.ply", "e0.ply",
                                       "e1.ply", "e2.ply", "e3.ply", "e4.ply", "e5.ply", "f0.obj", "f1.obj",
                                       "f2.obj", "f3.obj", "f4.obj", "f5.obj", "scene.json"}));
        QCOMPARE(frames("a.pc2", expected), 6);
        QCOMPARE(frames("b.mdd", expected), 6);
        QVERIFY(read(in("c.glb")).contains("\"frame 5\"") && !read(in("c.glb")).contains("\"frame 6\""));
        QCOMPARE(read(in("a.obj")), read(in("f0.obj")));
        QCOMPARE(read(in("b.obj")), read(in("f0.obj")));
        QCOMPARE(read(in("d.ply")), read(in("e5.ply")));
        QVERIFY(read(in("d.ply")) != read(in("e4.ply")));
    }

    // A mesh that the user asked for is not replaced by the one beside a cache, whatever its name is written
    // like.
    void theMeshBesideACacheYields() {
        saveAs(busyScene());
        for (const QString& obj : {in("a.obj"), in("./a.obj")}) {
            QCOMPARE(runProgram({"simulate", m_scene, "--frames", "4", "--output", obj, "--output",
                                 in("a.pc2"), "--output", in("b.obj")})
                         .status,
                     0);
            QCOMPARE(files(), QStringList({"a.obj", "a.pc2", "b.obj", "scene.json"}));
            QCOMPARE(read(in("a.obj")), read(in("b.obj")));
        }
        // Two caches of one name share it.
        QCOMPARE(runProgram({"simulate", m_scene, "--frames", "4", "--output", in("c.pc2"), "--output",
                             in("c.mdd"), "--output", in("d%d.obj")})
                     .status,
                 0);
        QCOMPARE(read(in("c.obj")), read(in("d0.obj")));
    }

    void axisAndScaleHoldForEveryFormat() {
        const Solved expected(busyScene(), 2);
        saveAs(expected.scene);
        const auto run = runProgram({"simulate",  m_scene,       "--frames",  "2",         "--axis",
                                     "z",         "--scale",     "100",       "--output",  in("a.obj"),
                                     "--output",  in("b%d.csv"), "--output",  in("c.ply"), "--output",
                                     in("d.glb"), "--output",    in("e.pc2"), "--output",  in("f.mdd")});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        for (const char* file : {"a.obj", "c.ply", "d.glb", "e.obj", "f.obj"})
            QVERIFY2(read(in(file)).contains("ClothLab, 100 units per metre, z up"), file);
        const Vec3 last = expected.states.back().position.at(62);
        const std::vector<double> place{100 * last.x(), -100 * last.z(), 100 * last.y()};
        QVERIFY(numbersAfter(read(in("a.obj")), "v ", ' ').at(62) == place);
        const auto row = numbersAfter(read(in("b2.csv")), "62,", ',').at(0);
        QVERIFY(std::vector(row.begin() + 2, row.begin() + 5) == place);
        for (const char* file : {"e.pc2", "f.mdd"}) {
            const QByteArray bytes = read(in(file));
            test::ByteReader point(bytes.toStdString(), std::size_t(bytes.size()) - 12);
            for (const double value : place)
                QVERIFY(
                    test::sameFloat(file[0] == 'e' ? point.littleFloat() : point.bigFloat(), float(value)));
        }
    }

    void measuresOfEveryFrame() {
        const Solved expected(busyScene(), 12);
        saveAs(expected.scene);
        const auto run = runProgram({"simulate", m_scene, "--frames", "12", "--measures", in("m.csv"),
                                     "--report", "-", "--scale", "9"});
        QVERIFY2(run.status == 0, qPrintable(run.err));
        const json report = test::report(run.out);
        const QByteArray text = read(in("m.csv"));
        const auto rows = numbersAfter(text.mid(text.indexOf('\n') + 1), "", ',');
        QCOMPARE(rows.size(), 13U);
        const std::vector<double> last{12,
                                       12 / 50.0,
                                       report.at("kinetic_energy").get<double>(),
                                       report.at("potential_energy").get<double>(),
                                       report.at("max_strain").at("structural").get<double>(),
                                       report.at("max_strain").at("shearing").get<double>(),
                                       report.at("max_strain").at("bending").get<double>()};
        for (std::size_t i = 0; i < last.size(); ++i)
            QVERIFY(qFuzzyCompare(rows[12][i], last[i]));
        double corrections = 0;
        for (const auto& row : rows)
            corrections += row.at(7);
        QCOMPARE(corrections, double(expected.corrections));
    }

    void aBlowUpKeepsTheGoodFrames() {
        const Solved expected(test::unstableScene(), 100);
        const int good = int(expected.states.size()); // with frame 0
        saveAs(expected.scene);
        const auto run =
            runProgram({"simulate", m_scene, "--frames", "100", "--output", in("a.pc2"), "--output",
                        in("b.mdd"), "--output", in("c.glb"), "--measures", in("m.csv")});
        QCOMPARE(run.status, 4);
        QCOMPARE(files(), QStringList({"a.obj", "a.pc2", "b.mdd", "b.obj", "c.glb", "m.csv", "scene.json"}));
        QCOMPARE(frames("a.pc2", expected), good);
        QCOMPARE(frames("b.mdd", expected), good);
        QCOMPARE(read(in("m.csv")).count('\n'), good + 1);
        QVERIFY(!read(in("c.glb")).contains(QString("\"frame %1\"").arg(good).toLatin1()));
    }

    void aFileThatIsTooLargeIsRefusedBeforeTheRun() {
        saveAs(busyScene());
        const auto run = runProgram({"simulate", m_scene, "--frames", "100000000", "--output", in("a.glb")});
        QCOMPARE(run.status, 6);
        QVERIFY2(run.err.contains("a.glb: 100000001 frames are more than the 1000"), qPrintable(run.err));
        QCOMPARE(files(), QStringList{"scene.json"});
    }

    // One output that fails ends the run; what the others have is kept.
    void anOutputThatFailsLeavesTheOthers() {
        const Solved expected(busyScene(), 3);
        saveAs(expected.scene);
        QVERIFY(QDir(m_folder->path()).mkdir("b2.obj"));
        const auto run = runProgram({"simulate", m_scene, "--frames", "50", "--output", in("a.pc2"),
                                     "--output", in("b%d.obj"), "--output", in("c.ply")});
        QCOMPARE(run.status, 6);
        QVERIFY2(run.err.contains("clothlab: " + in("b2.obj") + ": is a folder"), qPrintable(run.err));
        QCOMPARE(frames("a.pc2", expected), 3);
        QCOMPARE(files(),
                 QStringList({"a.obj", "a.pc2", "b0.obj", "b1.obj", "b2.obj", "c.ply", "scene.json"}));
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
        QTest::newRow("cache, no such folder") << QStringList{"--output", "FOLDER/none/a.pc2"};
        QTest::newRow("binary, in a file") << QStringList{"--output", "FOLDER/scene.json/a.glb"};
        QTest::newRow("cache and mesh, a folder")
            << QStringList{"--output", "FOLDER/a.mdd", "--output", "FOLDER/folder.csv/../none/b.mdd"};
        QTest::newRow("measures are a folder") << QStringList{"--measures", "FOLDER/folder.csv"};
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
                                in("f%d.obj"), "--output", in("last.csv"), "--output", in("cache.mdd"),
                                "--report", "-"});
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
        // 0 … frames, the last one, the cache, its mesh, the scene; nothing temporary
        QCOMPARE(files().size(), frames + 1 + 4);
        QCOMPARE(read(in("cache.obj")), read(in("f0.obj")));
        const QByteArray cache = read(in("cache.mdd"));
        QCOMPARE(int(test::ByteReader(cache.toStdString()).big()), frames + 1);
        QCOMPARE(cache.size(), 8 + (frames + 1) * (4 + 63 * 12));
        for (int frame = 0; frame <= frames; ++frame) {
            const QByteArray text = read(in(QString("f%1.obj").arg(frame)));
            QVERIFY(text.endsWith('\n'));
            QCOMPARE(text.count("\nf "), 2 * 8 * 6);
        }
        QCOMPARE(read(in("last.csv")).count('\n'), 64);
    }

private:
    // How many frames a cache holds; -1 if it is not one of these frames.
    int frames(const QString& file, const Solved& expected) const {
        const std::string bytes = read(in(file)).toStdString();
        const bool pc2 = file.endsWith("pc2");
        test::ByteReader reader(bytes, pc2 ? 28 : 0);
        const int count = int(pc2 ? reader.little() : reader.big());
        if (count > int(expected.states.size()))
            return -1;
        if (!pc2)
            reader.text(4 + 4 * std::size_t(count));
        for (int frame = 0; frame < count; ++frame)
            for (int i = 0; i < expected.solver.sheet().grid.pointCount(); ++i)
                for (const double value : expected.states[std::size_t(frame)].position.at(i))
                    if ((pc2 ? reader.littleFloat() : reader.bigFloat()) != float(value))
                        return -1;
        return reader.atEnd() ? count : -1;
    }
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
