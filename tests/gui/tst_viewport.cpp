// The view without its picture: camera, picking and selection by mouse and keys.
#include "tests/gui/test_window.h"

#include <QWheelEvent>

using namespace clothlab;

class TestViewport : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { m_window.reset(); }

    void withoutOpenGlTheViewSaysSo();
    void aLeftDragOrbits();
    void aRightMiddleOrShiftDragPans_data();
    void aRightMiddleOrShiftDragPans();
    void theWheelZoomsToTheCursor();
    void homeUndoesEveryMoveOfTheCamera();
    void keysLookFromEverySide();
    void fiveSwitchesToOrthographicAndBack();
    void frameSelectionAndFrameAllFit();
    void aTremblingClickSelectsAndDoesNotOrbit();
    void aClickSelectsThePointUnderIt();
    void aClickSelectsTheSpringUnderIt();
    void aClickBesideTheSheetSelectsNothing();
    void hiddenTypesOfSpringsAreNotPicked();
    void shiftAddsAndControlRemoves();
    void bThenADragSelectsTheBox();
    void shiftAndControlWorkForBoxesToo();
    void escapeLeavesTheBoxAndThenTheSelection();
    void pickingFollowsTheFrameAndTheCamera();
    void aNewSceneGetsItsOwnView();
    void theViewTakesTheKeysOfTheWindow();

private:
    Viewport& view() { return m_window->viewport(); }
    const Selection& selection() { return m_window->document().selection(); }
    QPoint at(int point) { return view().positionOf(point).toPoint(); }
    void wheel(QPoint position, int notches);
    Selection points(std::vector<int> numbers) {
        Selection made;
        for (const int number : numbers)
            made.items.push_back({Selection::Kind::Point, number});
        return made;
    }

    std::unique_ptr<TestWindow> m_window;
};

void TestViewport::init() {
    m_window = std::make_unique<TestWindow>();
    Scene scene = smallScene();
    scene.appearance.shader = "Wireframe"; // nothing hides behind the surface
    QVERIFY(m_window->load(scene));
    m_window->key(Qt::Key_7); // from above, where a flat sheet has every point apart
}

void TestViewport::wheel(QPoint position, int notches) {
    QWheelEvent event(position, view().mapToGlobal(position), {}, {0, 120 * notches}, Qt::NoButton,
                      Qt::NoModifier, Qt::NoScrollPhase, false);
    QApplication::sendEvent(&view(), &event);
}

void TestViewport::withoutOpenGlTheViewSaysSo() {
    QVERIFY(!view().hasPicture());
    QCOMPARE(view().overlay().placeholder(), QStringLiteral("OpenGL is not available"));
    // And draws it: there are bright letters on the dark ground, in the middle.
    const QImage image = view().grab().toImage();
    const int middle = image.height() / 2;
    int bright = 0;
    for (int y = middle - 60; y < middle + 60; ++y)
        for (int x = 0; x < image.width(); ++x)
            bright += qGray(image.pixel(x, y)) > 150;
    QVERIFY2(bright > 100, QByteArray::number(bright));
}

void TestViewport::aLeftDragOrbits() {
    m_window->key(Qt::Key_Home);
    const CameraView before = view().camera().view;
    m_window->drag(&view(), {300, 300}, {400, 330});
    const CameraView after = view().camera().view;
    QVERIFY(after.azimuth < before.azimuth);     // the scene follows the hand to the right
    QVERIFY(after.elevation > before.elevation); // and shows more of its top
    QCOMPARE(after.distance, before.distance);
    QVERIFY(after.target == before.target);
    QVERIFY(selection().empty());
}

void TestViewport::aRightMiddleOrShiftDragPans_data() {
    QTest::addColumn<Qt::MouseButton>("button");
    QTest::addColumn<Qt::KeyboardModifiers>("modifiers");
    QTest::newRow("right") << Qt::RightButton << Qt::KeyboardModifiers();
    QTest::newRow("middle") << Qt::MiddleButton << Qt::KeyboardModifiers();
    QTest::newRow("shift") << Qt::LeftButton << Qt::KeyboardModifiers(Qt::ShiftModifier);
}

void TestViewport::aRightMiddleOrShiftDragPans() {
    QFETCH(const Qt::MouseButton, button);
    QFETCH(const Qt::KeyboardModifiers, modifiers);
    const CameraView before = view().camera().view;
    const QPointF target = view().camera().project(view().camera().target(), view().size()).position;
    const QVector3D old = view().camera().target();
    m_window->drag(&view(), {300, 300}, {380, 260}, modifiers, button);
    const CameraView after = view().camera().view;
    QCOMPARE(after.azimuth, before.azimuth);
    QCOMPARE(after.elevation, before.elevation);
    QCOMPARE(after.distance, before.distance);
    // What was looked at goes with the hand, except for the way that told the drag from a click.
    const QPointF moved = view().camera().project(old, view().size()).position - target;
    QVERIFY2(std::abs(moved.x() - 80) < 12 && std::abs(moved.y() + 40) < 12,
             qPrintable(QStringLiteral("%1 %2").arg(moved.x()).arg(moved.y())));
}

void TestViewport::theWheelZoomsToTheCursor() {
    const double before = view().camera().view.distance;
    const QPoint corner = at(35);
    wheel(corner, 3);
    QVERIFY(view().camera().view.distance < before);
    // The wheel keeps what is under the cursor at the distance of the target; the sheet is near it.
    const QPointF stayed = view().positionOf(35) - corner;
    const QPointF other = view().positionOf(0) - corner;
    QVERIFY(std::hypot(stayed.x(), stayed.y()) < 0.2 * std::hypot(other.x(), other.y()));
    wheel(corner, -3);
    QVERIFY(std::abs(view().camera().view.distance - before) < 1e-9);
}

void TestViewport::homeUndoesEveryMoveOfTheCamera() {
    m_window->key(Qt::Key_Home);
    const CameraView home = view().camera().view;
    m_window->drag(&view(), {300, 300}, {400, 330});
    m_window->drag(&view(), {300, 300}, {400, 330}, Qt::NoModifier, Qt::RightButton);
    wheel({200, 200}, 4);
    m_window->key(Qt::Key_5);
    QVERIFY(view().camera().view != home);
    m_window->key(Qt::Key_Home);
    QVERIFY(view().camera().view == home);
    QVERIFY(!view().camera().orthographic);
    QVERIFY(!m_window->document().isModified()); // looking is no edit
}

void TestViewport::keysLookFromEverySide() {
    struct Side {
        Qt::Key key;
        Qt::KeyboardModifiers modifiers;
        QVector3D from;
    };
    for (const Side& side :
         {Side{Qt::Key_1, Qt::NoModifier, {0, 0, 1}}, Side{Qt::Key_1, Qt::ControlModifier, {0, 0, -1}},
          Side{Qt::Key_3, Qt::NoModifier, {1, 0, 0}}, Side{Qt::Key_3, Qt::ControlModifier, {-1, 0, 0}},
          Side{Qt::Key_7, Qt::NoModifier, {0, 1, 0}}, Side{Qt::Key_7, Qt::ControlModifier, {0, -1, 0}},
          Side{Qt::Key_3, Qt::KeypadModifier, {1, 0, 0}}}) {
        m_window->key(side.key, side.modifiers);
        const QVector3D from = (view().camera().eye() - view().camera().target()).normalized();
        QVERIFY((from - side.from).length() < 1e-4F);
    }
}

void TestViewport::fiveSwitchesToOrthographicAndBack() {
    m_window->key(Qt::Key_5);
    QVERIFY(view().camera().orthographic);
    QVERIFY((*m_window)->actions().orthographic->isChecked());
    m_window->key(Qt::Key_5);
    QVERIFY(!view().camera().orthographic);
    QVERIFY(!(*m_window)->actions().orthographic->isChecked());
}

void TestViewport::frameSelectionAndFrameAllFit() {
    m_window->document().setSelection(points({0, 7}));
    m_window->key(Qt::Key_F);
    const QPointF between = (view().positionOf(0) + view().positionOf(7)) / 2;
    const QPointF centre = QRectF(view().rect()).center();
    QVERIFY(std::abs(between.x() - centre.x()) < 3 && std::abs(between.y() - centre.y()) < 3);
    QVERIFY(!view().rect().contains(at(35))); // so near that the other corner is outside
    m_window->key(Qt::Key_A);
    for (const int corner : {0, 5, 30, 35})
        QVERIFY(view().rect().contains(at(corner)));
}

void TestViewport::aTremblingClickSelectsAndDoesNotOrbit() {
    const CameraView before = view().camera().view;
    const QPoint place = at(14);
    const QPoint tremble(QApplication::startDragDistance() / 2, 0);
    QTest::mousePress(&view(), Qt::LeftButton, {}, place);
    QTest::mouseEvent(QTest::MouseMove, &view(), Qt::NoButton, {}, place + tremble);
    QTest::mouseRelease(&view(), Qt::LeftButton, {}, place + tremble);
    QVERIFY(view().camera().view == before);
    QVERIFY(selection() == points({14}));
}

void TestViewport::aClickSelectsThePointUnderIt() {
    for (int point = 0; point < 36; ++point) {
        m_window->click(&view(), at(point));
        QVERIFY2(selection() == points({point}), QByteArray::number(point));
        QCOMPARE(view().itemAt(at(point)), selection().active());
    }
}

void TestViewport::aClickSelectsTheSpringUnderIt() {
    const Grid grid = m_window->document().grid();
    // The middle of a square's diagonal, where two shearing springs cross, and of a structural spring.
    m_window->click(&view(), (at(14) + at(21)) / 2);
    QVERIFY(selection().active() && selection().active()->kind == Selection::Kind::Spring);
    QCOMPARE(grid.spring(selection().active()->number).type(), SpringType::Shearing);
    m_window->click(&view(), (at(14) + at(15)) / 2);
    QVERIFY(selection().active() && selection().active()->kind == Selection::Kind::Spring);
    const Spring spring = grid.spring(selection().active()->number);
    QVERIFY(spring.type() != SpringType::Shearing); // a bending spring lies over it on a flat sheet
    QVERIFY(grid.place(spring.a).y == 2 && grid.place(spring.b).y == 2);
}

void TestViewport::aClickBesideTheSheetSelectsNothing() {
    m_window->document().setSelection(points({3}));
    m_window->click(&view(), {12, 12});
    QVERIFY(selection().empty());
}

void TestViewport::hiddenTypesOfSpringsAreNotPicked() {
    const QPoint crossing = (at(14) + at(21)) / 2;
    QVERIFY(view().itemAt(crossing).has_value());
    auto* box = (*m_window)->springsPanel().typeBox(SpringType::Shearing);
    m_window->click(box, {8, box->height() / 2});
    QVERIFY(!view().itemAt(crossing).has_value());
}

void TestViewport::shiftAddsAndControlRemoves() {
    m_window->click(&view(), at(7));
    m_window->click(&view(), at(9), Qt::ShiftModifier);
    m_window->click(&view(), at(20), Qt::ShiftModifier);
    QVERIFY(selection() == points({7, 9, 20}));
    m_window->click(&view(), at(9), Qt::ControlModifier);
    QVERIFY(selection() == points({7, 20}));
    m_window->click(&view(), {12, 12}, Qt::ShiftModifier); // beside it, nothing is lost
    QVERIFY(selection() == points({7, 20}));
    m_window->click(&view(), at(9));
    QVERIFY(selection() == points({9}));
}

void TestViewport::bThenADragSelectsTheBox() {
    const CameraView before = view().camera().view;
    m_window->key(Qt::Key_B);
    m_window->drag(&view(), at(7) - QPoint(10, 10), at(14) + QPoint(10, 10));
    QVERIFY(selection() == points({7, 8, 13, 14}));
    QVERIFY(view().camera().view == before);
    // The next drag orbits again.
    m_window->drag(&view(), {300, 300}, {340, 290});
    QVERIFY(view().camera().view != before);
    QVERIFY(selection() == points({7, 8, 13, 14}));
}

void TestViewport::shiftAndControlWorkForBoxesToo() {
    const QPoint around(10, 10);
    m_window->document().setSelection(points({0}));
    m_window->key(Qt::Key_B);
    m_window->drag(&view(), at(7) - around, at(14) + around, Qt::ShiftModifier);
    QVERIFY(selection() == points({0, 7, 8, 13, 14}));
    m_window->key(Qt::Key_B);
    m_window->drag(&view(), at(13) - around, at(14) + around, Qt::ControlModifier);
    QVERIFY(selection() == points({0, 7, 8}));
}

void TestViewport::escapeLeavesTheBoxAndThenTheSelection() {
    m_window->click(&view(), at(7));
    m_window->key(Qt::Key_B);
    m_window->key(Qt::Key_Escape);
    QVERIFY(selection() == points({7}));
    const CameraView before = view().camera().view;
    m_window->drag(&view(), {300, 300}, {340, 290});
    QVERIFY(view().camera().view != before); // no box any more
    m_window->key(Qt::Key_Escape);
    QVERIFY(selection().empty());
}

void TestViewport::pickingFollowsTheFrameAndTheCamera() {
    m_window->key(Qt::Key_1);
    const QPoint flat = at(35);
    QVERIFY(m_window->simulateTo(30));
    QVERIFY((at(35) - flat).manhattanLength() > 20); // it has fallen
    m_window->click(&view(), at(35));
    QVERIFY(selection() == points({35}));
    m_window->drag(&view(), {300, 300}, {420, 350});
    m_window->click(&view(), at(30));
    QVERIFY(selection() == points({30}));
    QVERIFY(m_window->frame() == 30);
}

void TestViewport::aNewSceneGetsItsOwnView() {
    Scene scene = smallScene();
    scene.camera = CameraView{{0.5, 0.25, 0.5}, 3.5, 12, 34, {}};
    QVERIFY(m_window->load(scene));
    QVERIFY(view().camera().view == *scene.camera);
    m_window->key(Qt::Key_7);
    m_window->key(Qt::Key_Home);
    QVERIFY(view().camera().view == *scene.camera);
}

void TestViewport::theViewTakesTheKeysOfTheWindow() {
    m_window->click(&view(), {12, 12});
    QVERIFY(view().hasFocus());
    m_window->key(Qt::Key_N);
    TRY_COMPARE(m_window->frame(), 1);
    m_window->key(Qt::Key_Left);
    QCOMPARE(m_window->frame(), 0);
}

CLOTHLAB_GUI_TEST_MAIN(TestViewport)
#include "tst_viewport.moc"
