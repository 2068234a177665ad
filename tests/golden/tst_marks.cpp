// Springs, dots, axes and grid over the picture.
#include "tests/golden/canvas.h"

#include <optional>

using namespace clothlab::render;

class MarksTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { SKIP_WITHOUT_OPENGL(); }
    void init() { QVERIFY(m_studio.emplace().isGood()); }
    void cleanup() { m_studio.reset(); }

    void springTogglesChangeThePicture();
    void springsLieOverTheSurface();
    void springsAreAsWideAsTheScale();
    void pinnedAndHighlightedShowThroughFaintly();
    void pinnedIndicesOutOfRangeAreLeftOut();
    void axesAndGridCanBeSwitchedOff();

private:
    std::optional<Studio> m_studio;
};

void MarksTest::springTogglesChangeThePicture() {
    RenderFrame frame = flatFrame(6);
    frame.surface.shader = QStringLiteral("Wireframe");
    for (int shown = 0; shown < 8; ++shown) {
        for (std::size_t type = 0; type < 3; ++type)
            frame.springs.drawn[type] = (shown >> type) & 1;
        const QImage image = m_studio->draw(frame);
        QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
        for (std::size_t type = 0; type < 3; ++type) {
            // On a flat sheet structural springs cover the middle of bending ones: an edge is left to see.
            const int seen = countPixels(image, frame.springs.colors[type], 40);
            QVERIFY2(
                frame.springs.drawn[type] ? seen > 25 : seen == 0,
                qPrintable(QStringLiteral("shown %1, type %2: %3 pixels").arg(shown).arg(type).arg(seen)));
        }
        if (shown == 0)
            QCOMPARE(countPixels(image, frame.background, 0), kSize.width() * kSize.height());
    }
}

void MarksTest::springsLieOverTheSurface() {
    RenderFrame frame = flatFrame(6);
    const QImage without = m_studio->draw(frame);
    QCOMPARE(countPixels(without, frame.springs.colors[0], 40), 0);
    frame.springs.overSurface = true;
    frame.springs.drawn = {true, false, false};
    const QImage with = m_studio->draw(frame);
    // Along a whole spring no pixel is lost to the surface in which it lies.
    for (int i = 5; i <= 95; ++i) {
        const QPoint pixel = toPixel(frame, QVector3D(0.4F, 0.5F, 0.01F * float(i)));
        bool seen = false;
        for (int dx = -1; dx <= 1; ++dx)
            seen = seen || isNear(with.pixel(pixel + QPoint(dx, 0)), frame.springs.colors[0].rgb(), 60);
        QVERIFY(seen);
    }
}

void MarksTest::springsAreAsWideAsTheScale() {
    RenderFrame frame = flatFrame(4);
    frame.surface.shader = QStringLiteral("Wireframe");
    frame.springs.drawn = {true, false, false};
    const int thin = countPixels(m_studio->draw(frame), frame.background, 0);
    frame.devicePixelRatio = 3;
    const int thick = countPixels(m_studio->draw(frame), frame.background, 0);
    const int all = kSize.width() * kSize.height();
    QVERIFY(all - thick > 2 * (all - thin) - (all - thin) / 4);
}

void MarksTest::pinnedAndHighlightedShowThroughFaintly() {
    RenderFrame frame = flatFrame(5);
    frame.surface.shader = QStringLiteral("Normal"); // one known colour under the dots
    const QRgb surface = qRgb(128, 255, 128);
    frame.sheet.pinned = {12, 4'000'000};
    const QPoint middle = toPixel(frame, QVector3D(0.5F, 0.5F, 0.5F));
    QVERIFY(isNear(m_studio->draw(frame).pixel(middle), frame.pinnedColor.rgb(), 2));

    frame.sheet.pinned.clear();
    QVERIFY(isNear(m_studio->draw(frame).pixel(middle), surface, 1));
    frame.highlight.points = {QVector3D(0.5F, 0.5F, 0.5F)};
    QVERIFY(isNear(m_studio->draw(frame).pixel(middle), frame.highlightColor.rgb(), 2));
    frame.highlight.points.clear();
    frame.highlight.segments = {{QVector3D(0.3F, 0.5F, 0.5F), QVector3D(0.7F, 0.5F, 0.5F)}};
    QVERIFY(isNear(m_studio->draw(frame).pixel(middle), frame.highlightColor.rgb(), 2));

    frame.highlight.segments.clear();
    frame.highlight.points = {QVector3D(0.5F, 0.2F, 0.5F)}; // below the sheet
    const QPoint below = toPixel(frame, QVector3D(0.5F, 0.2F, 0.5F));
    const QRgb ghost = m_studio->draw(frame).pixel(below);
    const auto mixed = [&](int under, int over) { return int(std::lround(0.7 * under + 0.3 * over)); };
    QVERIFY(isNear(ghost,
                   qRgb(mixed(128, frame.highlightColor.red()), mixed(255, frame.highlightColor.green()),
                        mixed(128, frame.highlightColor.blue())),
                   3));
}

// Drivers that guard reads past a buffer make zeros of them: a dot at the origin.
void MarksTest::pinnedIndicesOutOfRangeAreLeftOut() {
    RenderFrame frame = flatFrame(5);
    for (std::size_t i = 1; i < frame.sheet.positions.size(); i += 3)
        frame.sheet.positions[i] = -1; // out of the way of the origin
    const QImage without = m_studio->draw(frame);
    frame.sheet.pinned = {25, 4'000'000, 0xFFFFFFFF};
    QCOMPARE(m_studio->draw(frame), without);
}

void MarksTest::axesAndGridCanBeSwitchedOff() {
    RenderFrame frame = flatFrame(4);
    frame.sheet = SheetShape();
    const int all = kSize.width() * kSize.height();
    frame.axes = true;
    const QImage axes = m_studio->draw(frame);
    QVERIFY(countPixels(axes, QColor(0xE6, 0x61, 0x66), 20) > 10); // x goes to the right
    for (int y = 0; y < kSize.height(); ++y)
        for (int x = 0; x < kSize.width(); ++x)
            QVERIFY((x < 100 && y > kSize.height() - 100) ||
                    isNear(axes.pixel(x, y), frame.background.rgb(), 0));
    frame.axes = false;
    frame.groundGrid = true;
    QVERIFY(countPixels(m_studio->draw(frame), frame.background, 0) < all - 500);
    frame.gridOpacity = 0;
    QCOMPARE(countPixels(m_studio->draw(frame), frame.background, 0), all);
}

int main(int argc, char** argv) {
    return runOnDisplay<MarksTest>(argc, argv);
}
#include "tst_marks.moc"
