// What a blow-up is said to be: where it was, and whether the step is to blame.
#include "simcore/inspect/blow_up_text.h"
#include "simcore/inspect/stability.h"

#include <QtTest>

using namespace clothlab;

namespace {

Scene sheetOf(double ks) {
    Scene scene;
    scene.cloth.numWidthPoints = 20;
    scene.cloth.numHeightPoints = 15;
    scene.cloth.ks = ks;
    return scene;
}

QString described(const Scene& scene) {
    return QString::fromStdString(describeBlowUp({Phase::StrainLimit, 47}, 3, 12, scene));
}

} // namespace

class TestBlowUpText : public QObject {
    Q_OBJECT

private slots:
    void beginsWithTheMomentAndThePlace();
    void namesTheStepsThatAreEnough();
    void saysWhereNoStepsAreEnough();
    void looksElsewhereWhereTheStepIsStable();
};

void TestBlowUpText::beginsWithTheMomentAndThePlace() {
    const QString where = "blew up in frame 12, step 3, phase " +
                          QString::fromUtf8(name(Phase::StrainLimit).data()) +
                          ", at point 47 (7, 2); dt·ω is ";
    for (const double ks : {0.0, 5000.0, 5e6, 1e9})
        QVERIFY2(described(sheetOf(ks)).startsWith(where), qPrintable(described(sheetOf(ks))));
}

void TestBlowUpText::namesTheStepsThatAreEnough() {
    Scene scene = sheetOf(5e6);
    const Stability before = stability(scene);
    QVERIFY(!before.stable() && before.stableStepsPerFrame);
    const QString text = described(scene);
    const QString expected =
        QString("dt·ω is %1, beyond 2.00: at least %2 steps per frame (or a lower ks, a higher "
                "density) make the step stable")
            .arg(before.dtOmega, 0, 'f', 2)
            .arg(*before.stableStepsPerFrame);
    QVERIFY2(text.endsWith(expected), qPrintable(text));
    scene.simulation.stepsPerFrame = *before.stableStepsPerFrame;
    QVERIFY(!described(scene).contains("beyond"));
}

void TestBlowUpText::saysWhereNoStepsAreEnough() {
    Scene scene = sheetOf(1e9);
    scene.cloth.density = 1e-6;
    const QString text = described(scene);
    QVERIFY2(text.contains("beyond 2.00: no number of steps per frame up to 100000"), qPrintable(text));
    QVERIFY(text.contains("lower ks or a higher density"));
}

void TestBlowUpText::looksElsewhereWhereTheStepIsStable() {
    const QString text = described(sheetOf(5000));
    QVERIFY(stability(sheetOf(5000)).stable());
    for (const char* part :
         {" of 2.00, so the step is stable for the sheet at rest", "a collider", "self-collision", "strain"})
        QVERIFY2(text.contains(part), qPrintable(text));
    QVERIFY(!text.contains("beyond") && !text.contains("steps per frame"));
}

QTEST_APPLESS_MAIN(TestBlowUpText)
#include "tst_blow_up_text.moc"
