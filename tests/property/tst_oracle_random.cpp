// simcore's step against the plain reading of the model, over runs of random scenes.
#include "simcore/scene/scene_io.h"
#include "tests/support/oracle_run.h"
#include "tests/support/random_run.h"

#include <QtTest>

using namespace clothlab;

namespace {

constexpr int kRandomRuns = 12;

} // namespace

class TestOracleRandom : public QObject {
    Q_OBJECT

private slots:
    void randomRuns_data();
    void randomRuns();
    void randomRunsAreValidAndRepeatable();
};

void TestOracleRandom::randomRuns_data() {
    QTest::addColumn<quint64>("seed");
    for (quint64 seed = 0; seed < kRandomRuns; ++seed)
        QTest::addRow("%s, seed %d", name(randomRun(seed).trial).data(), int(seed)) << seed;
}

void TestOracleRandom::randomRuns() {
    QFETCH(quint64, seed);
    const RandomRun made = randomRun(seed);
    const Start start{made.scene, made.start};
    const OracleRun run = runBeside(start, kOracleSteps);
    const std::string text = made.describe() + ": " + run.describe();
    qInfo("%s", text.c_str());
    QVERIFY2(run.distance == 0 && run.strainLimits == run.counts.strainLimits, text.c_str());
    QVERIFY2(made.trial != Trial::Folded || run.counts.selfCollisions > 0, text.c_str());
    QVERIFY2(made.trial != Trial::OnSphere || run.counts.sphereContacts > 0, text.c_str());
    QVERIFY2(made.trial != Trial::OnPlane || run.counts.planeContacts > 0, text.c_str());
    QVERIFY2(made.trial != Trial::Thrown || run.counts.strainLimits > 0, text.c_str());
}

void TestOracleRandom::randomRunsAreValidAndRepeatable() {
    for (std::uint64_t seed = 0; seed < 60; ++seed) {
        const RandomRun made = randomRun(seed);
        QVERIFY2(!hasErrors(validate(made.scene)), made.describe().c_str());
        const RandomRun again = randomRun(seed);
        QVERIFY2(made.scene == again.scene && made.start == again.start, made.describe().c_str());
    }
}

QTEST_APPLESS_MAIN(TestOracleRandom)
#include "tst_oracle_random.moc"
