// On a real display, with OpenGL: a click on what is drawn selects it, at any scale of the display, and the
// picture stays when the window changes.
#include "tests/gui/on_display/display.h"

#include <QImage>
#include <QLineF>

using namespace clothlab;

namespace {

const QColor kPinned(0xCC, 0x79, 0xA7);
const QColor kSelected(0xFF, 0xD2, 0x3F);

bool isNear(QRgb a, const QColor& b, int tolerance) {
    return std::abs(qRed(a) - b.red()) <= tolerance && std::abs(qGreen(a) - b.green()) <= tolerance &&
           std::abs(qBlue(a) - b.blue()) <= tolerance;
}

// The centre of the pixels of that colour within `radius` of a place, in logical pixels; nothing if there
// are none.
std::optional<QPointF> centreOf(const QImage& image, const QColor& color, QPointF around, double radius) {
    const double scale = image.devicePixelRatio();
    QPointF sum;
    int count = 0;
    const QRectF near((around.x() - radius) * scale, (around.y() - radius) * scale, 2 * radius * scale,
                      2 * radius * scale);
    const QRect within = near.toAlignedRect() & image.rect();
    for (int y = within.top(); y <= within.bottom(); ++y)
        for (int x = within.left(); x <= within.right(); ++x) {
            const QPointF place = QPointF(x + 0.5, y + 0.5) / scale;
            if (QLineF(place, around).length() > radius || !isNear(image.pixel(x, y), color, 24))
                continue;
            sum += place;
            ++count;
        }
    return count == 0 ? std::nullopt : std::optional(sum / count);
}

} // namespace

class TestPicking : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup() { m_window.reset(); }

    void pinnedPointsAreDrawnWhereTheyArePicked();
    void aClickOnTheDrawnPointSelectsIt();
    void aClickOnAnyPointSelectsIt();
    void aClickSelectsTheSpringUnderIt();
    void whatIsSelectedIsDrawnThere();
    void pickingFollowsTheCameraAndTheRun();
    void thePictureSurvivesChangesOfTheWindow_data();
    void thePictureSurvivesChangesOfTheWindow();
    void everyShaderDrawsTheSheet_data();
    void everyShaderDrawsTheSheet();
    void hiddenSpringsAreNotDrawn();

private:
    Viewport& view() { return m_window->viewport(); }
    // The view as it is in a picture of the whole window.
    QImage picture() {
        const QImage whole = (*m_window)->grab().toImage();
        const double scale = whole.devicePixelRatio();
        const QRect place(view().mapTo(&**m_window, QPoint()), view().size());
        QImage part = whole.copy(QRectF(place.topLeft() * scale, QSizeF(place.size()) * scale).toRect());
        part.setDevicePixelRatio(scale);
        return part.convertToFormat(QImage::Format_RGB32);
    }
    // Pixels in the middle third that are not the ground.
    int drawnPixels(const QImage& image) {
        int count = 0;
        for (int y = image.height() / 3; y < image.height() * 2 / 3; ++y)
            for (int x = image.width() / 3; x < image.width() * 2 / 3; ++x)
                count += !isNear(image.pixel(x, y), themeColors(Theme::Dark).window, 6);
        return count;
    }
    // Through the window system, so that the canvas and what else lies over the view take part.
    void clickAt(QPointF at) {
        QTest::mouseClick((*m_window)->windowHandle(), Qt::LeftButton, {},
                          view().mapTo(&**m_window, at.toPoint()));
    }

    std::unique_ptr<TestWindow> m_window;
};

void TestPicking::initTestCase() {
    CLOTHLAB_NEEDS_PICTURE();
    const QString scale = qEnvironmentVariable("QT_SCALE_FACTOR");
    if (!scale.isEmpty())
        QCOMPARE(qGuiApp->devicePixelRatio(), scale.toDouble());
}

void TestPicking::init() {
    m_window = std::make_unique<TestWindow>(QSize(780, 560)); // fits the screen at scale 2, too
    for (const char* name : {"simulation", "output", "inspector", "springs", "appearance"})
        (*m_window)->dock(name)->hide();
    TRY_VERIFY(view().width() > 700);
    QVERIFY(m_window->load(smallScene()));
    TRY_VERIFY(drawnPixels(picture()) > 100);
}

void TestPicking::pinnedPointsAreDrawnWhereTheyArePicked() {
    const QImage image = picture();
    for (const int pin : {0, 5}) {
        const QPointF expected = view().positionOf(pin);
        const auto drawn = centreOf(image, kPinned, expected, 12);
        QVERIFY2(drawn, "no dot of a pin is near");
        QVERIFY2(QLineF(*drawn, expected).length() <= 2,
                 qPrintable(QStringLiteral("drawn %1 px from there").arg(QLineF(*drawn, expected).length())));
    }
    QVERIFY(!centreOf(image, kPinned, view().positionOf(14), 12)); // one that is not pinned
}

void TestPicking::aClickOnTheDrawnPointSelectsIt() {
    for (const int pin : {0, 5}) {
        // Where the picture shows it, not where the program says it is.
        const auto drawn = centreOf(picture(), kPinned, view().positionOf(pin), 12);
        QVERIFY(drawn);
        clickAt(*drawn);
        QCOMPARE(m_window->document().selection().active(),
                 std::optional(Selection::Item{Selection::Kind::Point, pin}));
    }
}

void TestPicking::aClickOnAnyPointSelectsIt() {
    m_window->key(Qt::Key_7);
    for (int point = 0; point < 36; point += 7) {
        clickAt(view().positionOf(point));
        QCOMPARE(m_window->document().selection().active(),
                 std::optional(Selection::Item{Selection::Kind::Point, point}));
    }
}

void TestPicking::aClickSelectsTheSpringUnderIt() {
    m_window->key(Qt::Key_7);
    clickAt((view().positionOf(14) + view().positionOf(21)) / 2);
    const auto active = m_window->document().selection().active();
    QVERIFY(active && active->kind == Selection::Kind::Spring);
    QCOMPARE(m_window->document().grid().spring(active->number).type(), SpringType::Shearing);
}

void TestPicking::whatIsSelectedIsDrawnThere() {
    m_window->key(Qt::Key_7);
    const QPointF place = view().positionOf(14);
    QVERIFY(!centreOf(picture(), kSelected, place, 12));
    clickAt(place);
    std::optional<QPointF> drawn;
    TRY_VERIFY((drawn = centreOf(picture(), kSelected, place, 12)));
    QVERIFY(QLineF(*drawn, place).length() <= 2);
}

void TestPicking::pickingFollowsTheCameraAndTheRun() {
    const QImage flat = picture();
    QVERIFY(m_window->simulateTo(20));
    TRY_VERIFY(picture() != flat);
    m_window->drag(&view(), {100, 100}, {180, 130});
    for (const int pin : {0, 5}) {
        std::optional<QPointF> drawn;
        TRY_VERIFY((drawn = centreOf(picture(), kPinned, view().positionOf(pin), 12)));
        QVERIFY(QLineF(*drawn, view().positionOf(pin)).length() <= 2);
        clickAt(*drawn);
        QCOMPARE(m_window->document().selection().active(),
                 std::optional(Selection::Item{Selection::Kind::Point, pin}));
    }
}

void TestPicking::thePictureSurvivesChangesOfTheWindow_data() {
    QTest::addColumn<int>("what");
    QTest::newRow("hidden and shown") << 0;
    QTest::newRow("full screen and back") << 1;
    QTest::newRow("a panel floated and back") << 2;
    QTest::newRow("panels hidden and shown") << 3;
    QTest::newRow("resized") << 4;
    QTest::newRow("minimized and restored") << 5;
    QTest::newRow("another theme") << 6;
}

void TestPicking::thePictureSurvivesChangesOfTheWindow() {
    QFETCH(const int, what);
    MainWindow& window = **m_window;
    QDockWidget* timeline = window.dock("timeline");
    if (what == 0) {
        window.hide();
        window.show();
    } else if (what == 1) {
        window.showFullScreen();
        TRY_VERIFY(drawnPixels(picture()) > 100);
        window.showNormal();
    } else if (what == 2) {
        timeline->setFloating(true);
        QVERIFY(QTest::qWaitForWindowExposed(timeline, kPatience));
        TRY_VERIFY(drawnPixels(picture()) > 100);
        timeline->setFloating(false);
    } else if (what == 3) {
        window.actions().hidePanels->trigger();
        TRY_VERIFY(drawnPixels(picture()) > 100);
        window.actions().hidePanels->trigger();
    } else if (what == 4) {
        window.resize(700, 600);
        TRY_COMPARE(window.size(), QSize(700, 600));
    } else if (what == 5) {
        window.showMinimized();
        window.showNormal();
    } else {
        window.setTheme(Theme::Light);
        window.setTheme(Theme::Dark);
    }
    QVERIFY(QTest::qWaitForWindowExposed(&window, kPatience));
    QApplication::processEvents();
    std::optional<QPointF> drawn;
    TRY_VERIFY((drawn = centreOf(picture(), kPinned, view().positionOf(5), 12)));
    QVERIFY(QLineF(*drawn, view().positionOf(5)).length() <= 2);
    QVERIFY(drawnPixels(picture()) > 100);
    QCOMPARE(window.messageBar().text(), QString());
    clickAt(*drawn);
    QCOMPARE(m_window->document().selection().active(),
             std::optional(Selection::Item{Selection::Kind::Point, 5}));
}

void TestPicking::everyShaderDrawsTheSheet_data() {
    QTest::addColumn<QString>("shader");
    for (const char* name : {"Wireframe", "Normal", "Diffuse", "Phong"})
        QTest::newRow(name) << QString(name);
}

void TestPicking::everyShaderDrawsTheSheet() {
    QFETCH(const QString, shader);
    m_window->key(Qt::Key_7);
    const QImage other = picture();
    Scene scene = smallScene();
    scene.appearance.shader = shader.toStdString();
    QVERIFY(m_window->load(scene));
    m_window->key(Qt::Key_7);
    if (shader != "Phong")
        TRY_VERIFY(picture() != other);
    QVERIFY(drawnPixels(picture()) > 500);
    QCOMPARE((*m_window)->messageBar().text(), QString());
}

void TestPicking::hiddenSpringsAreNotDrawn() {
    Scene scene = smallScene();
    scene.appearance.shader = "Wireframe";
    QVERIFY(m_window->load(scene));
    m_window->key(Qt::Key_7);
    const QPointF crossing = (view().positionOf(14) + view().positionOf(21)) / 2;
    const QColor shearing(0xE6, 0x9F, 0x00);
    const QColor drawn = themeColors(Theme::Dark).shearing;
    QVERIFY2(std::abs(drawn.hslHueF() - shearing.hslHueF()) < 0.06, qPrintable(drawn.name()));
    TRY_VERIFY(centreOf(picture(), drawn, crossing, 4));
    setSpringsDrawn(m_window->document(), SpringType::Shearing, false);
    TRY_VERIFY(!centreOf(picture(), drawn, crossing, 4));
}

CLOTHLAB_DISPLAY_TEST_MAIN(TestPicking)
#include "tst_picking.moc"
