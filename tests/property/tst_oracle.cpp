// simcore's step against the plain reading of the model, over whole runs of the course's scenes.
#include "simcore/solver/verlet_solver.h"
#include "tests/support/oracle_run.h"
#include "tests/support/shipped_scene.h"
#include "tests/support/states.h"

#include <QtTest>

using namespace clothlab;

namespace {

Start courseScene(const QString& file) {
    const Scene scene = test::shippedScene(file.chopped(5).toStdString()); // without .json
    return {scene, startState(scene)};
}

// Fast enough to reach the sphere or the plane in time, and with ends that stretch the sheet.
Start thrownCourseScene(const QString& file) {
    Start start = courseScene(file);
    const double width = start.scene.cloth.width;
    const Vec3 down(0, start.scene.planes.empty() ? -8 : -12, 0);
    throwSheet(start.scene, start.state, [&](int, const Vec3& p) {
        return Vec3(down + Vec3(3 * (p.x() - width / 2), 0, 0.5 * p.x() * p.z()));
    });
    return start;
}

Start foldedCourseScene(const QString& file) {
    Start start = courseScene(file);
    foldSheet(start.scene, start.state, 1.2 * start.scene.cloth.thickness);
    throwSheet(start.scene, start.state, [](int, const Vec3& p) { return Vec3(0, -1 + p.x(), 0.1 * p.z()); });
    return start;
}

} // namespace

class TestOracle : public QObject {
    Q_OBJECT

private slots:
    void startsAtTheSamePlace_data() { courseFiles(); }
    void startsAtTheSamePlace();
    void courseSceneAsItIs_data() { courseFiles(); }
    void courseSceneAsItIs();
    void courseSceneThrown_data() { courseFiles(); }
    void courseSceneThrown();
    void courseSceneFolded_data();
    void courseSceneFolded();

private:
    void courseFiles() {
        QTest::addColumn<QString>("file");
        for (const char* name : {"pinned2", "pinned4", "plane", "selfCollision", "sphere"})
            QTest::newRow(name) << QString(name) + ".json";
    }
};

void TestOracle::startsAtTheSamePlace() {
    QFETCH(QString, file);
    const Start start = courseScene(file);
    QVERIFY2(start.state.size() > 0, "the scene does not load");
    const oracle::Cloth cloth(start.scene);
    QCOMPARE(greatestDistance(start.state.position, cloth.points), 0.0);
    const VerletSolver solver(start.scene);
    QCOMPARE(int(cloth.springs.size()), solver.sheet().grid.springCount());
    for (int n = 0; n < int(cloth.springs.size()); ++n) {
        const Spring spring = solver.sheet().grid.spring(n);
        const oracle::Spring& expected = cloth.springs[std::size_t(n)];
        QCOMPARE(spring.a, expected.a);
        QCOMPARE(spring.b, expected.b);
        QVERIFY(std::abs(solver.sheet().restLengthOf(spring) - expected.restLength) < 1e-15);
    }
}

void TestOracle::courseSceneAsItIs() {
    QFETCH(QString, file);
    const Start start = courseScene(file);
    QVERIFY2(start.state.size() > 0, "the scene does not load");
    const OracleRun run = runBeside(start, kOracleSteps);
    qInfo("%s", run.describe().c_str());
    QCOMPARE(run.distance, 0.0);
    QCOMPARE(run.strainLimits, run.counts.strainLimits);
}

void TestOracle::courseSceneThrown() {
    QFETCH(QString, file);
    const Start start = thrownCourseScene(file);
    QVERIFY2(start.state.size() > 0, "the scene does not load");
    const OracleRun run = runBeside(start, kOracleSteps);
    qInfo("%s", run.describe().c_str());
    QCOMPARE(run.distance, 0.0);
    QCOMPARE(run.strainLimits, run.counts.strainLimits);
    QVERIFY(run.counts.strainLimits > 0);
    QVERIFY(start.scene.spheres.empty() || run.counts.sphereContacts > 0);
    QVERIFY(start.scene.planes.empty() || run.counts.planeContacts > 0);
}

// With pins, and falling on the plane; the others would only fall.
void TestOracle::courseSceneFolded_data() {
    QTest::addColumn<QString>("file");
    for (const char* name : {"pinned2", "selfCollision"})
        QTest::newRow(name) << QString(name) + ".json";
}

void TestOracle::courseSceneFolded() {
    QFETCH(QString, file);
    const Start start = foldedCourseScene(file);
    QVERIFY2(start.state.size() > 0, "the scene does not load");
    const OracleRun run = runBeside(start, kOracleSteps);
    qInfo("%s", run.describe().c_str());
    QCOMPARE(run.distance, 0.0);
    QCOMPARE(run.strainLimits, run.counts.strainLimits);
    QVERIFY(run.counts.selfCollisions > 0);
}

QTEST_APPLESS_MAIN(TestOracle)
#include "tst_oracle.moc"
