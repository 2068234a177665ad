// The colours of strain, on the surface and on springs, are those of the legend.
#include "app/render/strain_colors.h"
#include "tests/golden/canvas.h"

#include <optional>

using namespace clothlab::render;

class StrainTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { SKIP_WITHOUT_OPENGL(); }
    void init() { QVERIFY(m_studio.emplace().isGood()); }
    void cleanup() { m_studio.reset(); }

    void surfaceInTheColorsOfTheLegend_data();
    void surfaceInTheColorsOfTheLegend();
    void sheetsWithoutStrainsAreUnstrained();
    void springsInTheColorsOfTheLegend_data();
    void springsInTheColorsOfTheLegend();
    void springsWithoutRestHaveNoStrain();

private:
    std::optional<Studio> m_studio;
};

void StrainTest::surfaceInTheColorsOfTheLegend_data() {
    QTest::addColumn<float>("range");
    QTest::addColumn<int>("resolution");
    for (const float range : {0.02F, 0.1F, 0.5F})
        for (const int resolution : {0, 33})
            QTest::addRow("%g, %d", double(range), resolution) << range << resolution;
}

// Strain grows from -1.2 to 1.2 of the range across the sheet.
void StrainTest::surfaceInTheColorsOfTheLegend() {
    QFETCH(float, range);
    QFETCH(int, resolution);
    RenderFrame frame = flatFrame(49);
    frame.surface.shader = QStringLiteral("Strain");
    frame.surface.meshResolution = resolution;
    frame.surface.uniforms[frame.surface.shader][QStringLiteral("u_shading")] = number(0);
    frame.strainRange = range;
    const auto part = [](float u) { return 1.2F * (2 * u - 1); };
    for (int i = 0; i < 49 * 49; ++i)
        frame.sheet.strains.push_back(range * part(float(i % 49) / 48));
    const QImage image = m_studio->draw(frame);
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
    for (int i = 1; i < 100; ++i) {
        const QPoint pixel = toPixel(frame, QVector3D(0.01F * float(i), 0.5F, 0.6F));
        const QRgb expected = toColor(strainColor(part(toPlane(frame, pixel, 0.5F).x())));
        QVERIFY2(isNear(image.pixel(pixel), expected, 3), seen(image, pixel, expected));
    }
}

void StrainTest::sheetsWithoutStrainsAreUnstrained() {
    RenderFrame frame = flatFrame(5);
    frame.surface.shader = QStringLiteral("Strain");
    frame.surface.uniforms[frame.surface.shader][QStringLiteral("u_shading")] = number(0);
    frame.spheres = {{QVector3D(0.5F, 0.6F, 0.5F), 0.2F}};
    const QPoint corner = toPixel(frame, QVector3D(0.1F, 0.5F, 0.1F));
    const QPoint ball = toPixel(frame, QVector3D(0.5F, 0.784F, 0.5F));
    const QRgb grey = toColor(strainColor(0));
    for (const std::size_t count : {0U, 7U, 25U, 24U}) { // of the sheet's 25 points
        frame.sheet.strains.assign(count, 0.1F);
        const QImage image = m_studio->draw(frame);
        const QRgb expected = count == 25 ? toColor(strainColor(1)) : grey;
        QVERIFY2(isNear(image.pixel(corner), expected, 2), seen(image, corner, expected));
        QVERIFY2(isNear(image.pixel(ball), grey, 2), seen(image, ball, grey));
    }
}

void StrainTest::springsInTheColorsOfTheLegend_data() {
    QTest::addColumn<float>("strain");
    for (const float strain : {-0.2F, -0.1F, -0.05F, -0.02F, 0.0F, 0.03F, 0.05F, 0.1F, 0.4F})
        QTest::addRow("%g", double(strain)) << strain;
}

// Stretched along x only: springs along x have all of the strain, those along z none.
void StrainTest::springsInTheColorsOfTheLegend() {
    QFETCH(float, strain);
    RenderFrame frame = flatFrame(6);
    auto rest = std::make_shared<std::vector<float>>(frame.sheet.positions);
    for (std::size_t i = 0; i < rest->size(); i += 3)
        (*rest)[i] /= 1 + strain;
    frame.sheet.restPositions = rest;
    frame.surface.shader = QStringLiteral("Wireframe");
    frame.springs.drawn = {true, false, false};
    frame.springs.coloredByStrain = true;
    frame.devicePixelRatio = 3; // thick enough to have a middle
    const QImage image = m_studio->draw(frame);
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
    const QRgb strained = toColor(strainColor(strain / frame.strainRange));
    const QRgb unstrained = toColor(strainColor(0));
    for (int i = 0; i < 5; ++i) {
        const float middle = 0.2F * float(i) + 0.1F;
        const QPoint alongX = toPixel(frame, QVector3D(middle, 0.5F, 0.6F));
        const QPoint alongZ = toPixel(frame, QVector3D(0.4F, 0.5F, middle));
        QVERIFY2(isNear(image.pixel(alongX), strained, 3), seen(image, alongX, strained));
        QVERIFY2(isNear(image.pixel(alongZ), unstrained, 3), seen(image, alongZ, unstrained));
    }
    frame.springs.coloredByStrain = false;
    const QImage plain = m_studio->draw(frame);
    const QPoint pixel = toPixel(frame, QVector3D(0.5F, 0.5F, 0.6F));
    QVERIFY(isNear(plain.pixel(pixel), frame.springs.colors[0].rgb(), 3));
}

void StrainTest::springsWithoutRestHaveNoStrain() {
    RenderFrame frame = flatFrame(6);
    frame.surface.shader = QStringLiteral("Wireframe");
    frame.springs.coloredByStrain = true;
    frame.devicePixelRatio = 3;
    const QImage unstrained = m_studio->draw(frame);
    const QPoint pixel = toPixel(frame, QVector3D(0.5F, 0.5F, 0.6F));
    QVERIFY(isNear(unstrained.pixel(pixel), toColor(strainColor(0)), 3));

    auto rest = std::make_shared<std::vector<float>>(frame.sheet.positions);
    for (float& coordinate : *rest)
        coordinate /= 2;
    frame.sheet.restPositions = rest;
    QVERIFY(m_studio->draw(frame) != unstrained);
    rest = std::make_shared<std::vector<float>>(*rest);
    rest->pop_back(); // of another size
    frame.sheet.restPositions = rest;
    QCOMPARE(m_studio->draw(frame), unstrained);
    frame.sheet.restPositions = std::make_shared<std::vector<float>>(frame.sheet.positions.size(), 0.0F);
    QCOMPARE(m_studio->draw(frame), unstrained); // no length to compare with
}

int main(int argc, char** argv) {
    return runOnDisplay<StrainTest>(argc, argv);
}
#include "tst_strain.moc"
