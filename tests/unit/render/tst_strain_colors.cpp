// The scale of strains' colours.
#include "app/render/strain_colors.h"

#include <QTest>

#include <limits>

using namespace clothlab::render;

class StrainColorsTest : public QObject {
    Q_OBJECT

private slots:
    void endsMiddleAndHalves();
    void straightBetween();
    void beyondTheEnds();
    void endsCanBeToldApart();
};

void StrainColorsTest::endsMiddleAndHalves() {
    for (std::size_t i = 0; i < kStrainColors.size(); ++i)
        QCOMPARE(strainColor(-1 + 0.5F * float(i)), kStrainColors[i]);
}

void StrainColorsTest::straightBetween() {
    for (std::size_t i = 0; i + 1 < kStrainColors.size(); ++i)
        for (const float part : {0.1F, 0.5F, 0.9F}) {
            const QVector3D expected = (1 - part) * kStrainColors[i] + part * kStrainColors[i + 1];
            QVERIFY((strainColor(-1 + 0.5F * (float(i) + part)) - expected).length() < 1e-5F);
        }
}

void StrainColorsTest::beyondTheEnds() {
    const float infinity = std::numeric_limits<float>::infinity();
    for (const float part : {1.01F, 5.0F, 1e30F, infinity}) {
        QCOMPARE(strainColor(part), kStrainColors.back());
        QCOMPARE(strainColor(-part), kStrainColors.front());
    }
}

void StrainColorsTest::endsCanBeToldApart() {
    const auto lightness = [](const QVector3D& c) { return 0.21F * c.x() + 0.72F * c.y() + 0.07F * c.z(); };
    const float middle = lightness(strainColor(0));
    for (const float end : {-1.0F, 1.0F}) {
        QVERIFY(lightness(strainColor(end / 2)) < middle);
        QVERIFY(lightness(strainColor(end)) < lightness(strainColor(end / 2)));
    }
    QVERIFY(strainColor(-1).z() > strainColor(-1).x() + 0.3F); // blue
    QVERIFY(strainColor(1).x() > strainColor(1).z() + 0.3F);   // red
}

QTEST_APPLESS_MAIN(StrainColorsTest)
#include "tst_strain_colors.moc"
