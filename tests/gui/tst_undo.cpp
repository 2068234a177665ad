// Every control of every panel and bar changes the document, and undo takes both back. The controls are
// found, not listed: one that is new is tested, too.
#include "app/docks/appearance_panel.h"
#include "app/widgets/button_row.h"
#include "tests/gui/test_window.h"

#include "app/widgets/value_slider.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>
#include <QLineEdit>
#include <QToolBar>

#include <algorithm>
#include <functional>

using namespace clothlab;

namespace {

struct Control {
    QString name;
    std::function<void()> change;   // by hand
    std::function<QString()> shown; // what the widget shows
};

} // namespace

class TestUndo : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { m_window.reset(); }

    void everyControlIsUndoneAndRedoneByKeys();
    void everySliderDragIsOneStep();
    void aDragThereAndBackIsNoStep();
    void stepsOfAFieldInOneGoAreOneStep();
    void typedValuesAreStepsOfTheirOwn();
    void theColourChooserIsOneStepAndFollowsUndo();
    void keepingTheViewIsUndone();
    void theStatusBarSaysWhatWasUndone();
    void theMenuSaysWhatWouldBeUndone();

private:
    QList<Control> controls();
    QList<ParameterRow*> rows() { return (*m_window)->findChildren<ParameterRow*>(); }
    void undo() { m_window->key(Qt::Key_Z, Qt::ControlModifier); }
    void redo() { m_window->key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier); }
    void roundTrip(const Control& control);

    std::unique_ptr<TestWindow> m_window;
};

void TestUndo::init() {
    m_window = std::make_unique<TestWindow>();
    Scene scene = smallScene();
    scene.appearance.shader = "Wireframe"; // where the boxes of springs can be used
    QVERIFY(m_window->load(scene));
    m_window->unfoldAll();
}

QList<Control> TestUndo::controls() {
    QList<Control> found;
    for (ParameterRow* row : rows())
        found << Control{row->objectName(),
                         [this, row] {
                             m_window->click(row->field());
                             m_window->key(Qt::Key_Up);
                         },
                         [row] { return row->field()->text(); }};
    for (QCheckBox* box : (*m_window)->findChildren<QCheckBox*>())
        found << Control{box->objectName() + box->text(),
                         // On its square; the row may be wider than the box.
                         [this, box] {
                             m_window->click(box, {8, box->height() / 2});
                         },
                         [box] { return box->isChecked() ? QStringLiteral("on") : QStringLiteral("off"); }};
    for (QComboBox* box : (*m_window)->findChildren<QComboBox*>()) {
        if ((*m_window)->timelinePanel().isAncestorOf(box))
            continue; // how something is played and plotted is no edit
        found << Control{box->objectName() + box->accessibleName(),
                         [this, box] {
                             box->setFocus();
                             m_window->key(box->currentIndex() > 0 ? Qt::Key_Up : Qt::Key_Down);
                         },
                         [box] { return box->currentText(); }};
    }
    auto* bar = (*m_window)->findChild<QToolBar*>();
    for (QToolButton* button : bar->findChildren<QToolButton*>())
        if (button->isVisible() && button->isCheckable() &&
            button->defaultAction() != (*m_window)->actions().hidePanels)
            found << Control{button->text(), [this, button] { m_window->click(button); },
                             [button] { return QString::number(button->isChecked()); }};
    return found;
}

void TestUndo::roundTrip(const Control& control) {
    const Scene before = m_window->scene();
    const QString shownBefore = control.shown();
    const int index = m_window->document().undoStack().index();
    control.change();
    const Scene after = m_window->scene();
    const QString shownAfter = control.shown();
    QVERIFY2(after != before, "the document has not changed");
    QVERIFY2(shownAfter != shownBefore, "the widget has not changed");
    QCOMPARE(m_window->document().undoStack().index(), index + 1);

    undo();
    QVERIFY2(m_window->scene() == before, "undo has not restored the document");
    QCOMPARE(control.shown(), shownBefore);
    redo();
    QVERIFY2(m_window->scene() == after, "redo has not restored the document");
    QCOMPARE(control.shown(), shownAfter);
    undo();
    QVERIFY(m_window->scene() == before);
}

void TestUndo::everyControlIsUndoneAndRedoneByKeys() {
    const QList<Control> all = controls();
    // Every parameter of the table that moves the sheet is among them.
    const SimulationPanel& panel = (*m_window)->simulationPanel();
    const auto moves = [](const Parameter& parameter) { return parameter.object() != "appearance"; };
    const qsizetype parametersOfMotion = std::ranges::count_if(parameters(), moves);
    QCOMPARE(panel.findChildren<ParameterRow*>().size() + panel.findChildren<QCheckBox*>().size(),
             parametersOfMotion);
    // Springs, shaders, types in the bar; of the look all, the samples in a box.
    QVERIFY(all.size() >= qsizetype(parameters().size()) + 5 + 2 + 3);
    for (const Control& control : all) {
        qInfo("%s", qPrintable(control.name));
        roundTrip(control);
        if (QTest::currentTestFailed())
            return;
    }
    QVERIFY(!(*m_window)->isWindowModified());
}

void TestUndo::everySliderDragIsOneStep() {
    for (ParameterRow* row : rows()) {
        auto* slider = row->findChild<ValueSlider*>();
        QVERIFY(slider);
        roundTrip({row->objectName(),
                   [this, slider] {
                       const int y = slider->height() / 2;
                       m_window->drag(slider, {slider->width() / 2, y}, {slider->width() - 12, y});
                   },
                   [row] { return row->field()->text(); }});
        QVERIFY2(!QTest::currentTestFailed(), qPrintable(row->objectName()));
    }
}

void TestUndo::aDragThereAndBackIsNoStep() {
    auto* slider = (*m_window)->simulationPanel().row("cloth.damping")->findChild<ValueSlider*>();
    QVERIFY(slider);
    const Scene before = m_window->scene();
    // Taken by its handle, at a tenth of its range.
    const QPoint handle(6 + (slider->width() - 12) / 10, slider->height() / 2);
    QTest::mousePress(slider, Qt::LeftButton, {}, handle);
    QTest::mouseEvent(QTest::MouseMove, slider, Qt::NoButton, {}, handle + QPoint(20, 0));
    QVERIFY(m_window->scene() != before);
    QTest::mouseEvent(QTest::MouseMove, slider, Qt::NoButton, {}, handle);
    QTest::mouseRelease(slider, Qt::LeftButton, {}, handle);
    QVERIFY(m_window->scene() == before);
    QVERIFY(!(*m_window)->isWindowModified());
}

void TestUndo::stepsOfAFieldInOneGoAreOneStep() {
    const Scene before = m_window->scene();
    m_window->click(m_window->field("cloth.ks"));
    for (int i = 0; i < 5; ++i)
        m_window->key(Qt::Key_Up);
    QCOMPARE(m_window->scene().cloth.ks, 5500.0);
    QCOMPARE(m_window->document().undoStack().count(), 1);
    // Another run of steps after the focus was elsewhere.
    m_window->click(m_window->field("cloth.damping"));
    m_window->click(m_window->field("cloth.ks"));
    m_window->key(Qt::Key_Down);
    QCOMPARE(m_window->document().undoStack().count(), 2);
    undo();
    QCOMPARE(m_window->scene().cloth.ks, 5500.0);
    undo();
    QVERIFY(m_window->scene() == before);
}

void TestUndo::typedValuesAreStepsOfTheirOwn() {
    NumberField* field = m_window->field("cloth.ks");
    for (const char* text : {"4000", "3000"}) {
        m_window->typeInto(field, text);
        m_window->key(Qt::Key_Return);
    }
    QCOMPARE(m_window->document().undoStack().count(), 2);
    undo();
    QCOMPARE(m_window->scene().cloth.ks, 4000.0);
    QCOMPARE(field->text(), QStringLiteral("4000"));
}

void TestUndo::theColourChooserIsOneStepAndFollowsUndo() {
    QToolButton* button = (*m_window)->appearancePanel().colorRow()->button();
    const Scene before = m_window->scene();
    m_window->click(button);
    auto* dialog = (*m_window)->findChild<QColorDialog*>();
    QVERIFY(dialog && dialog->isVisible() && !dialog->isModal());
    dialog->setCurrentColor(QColor("#808080"));
    dialog->setCurrentColor(QColor("#336699"));
    QCOMPARE(button->text(), QStringLiteral("#336699"));
    QCOMPARE(m_window->document().undoStack().count(), 1);
    undo();
    QVERIFY(m_window->scene() == before);
    QCOMPARE(button->text(), QStringLiteral("#ffffff"));
    QCOMPARE(dialog->currentColor(), QColor("#ffffff"));
    redo();
    QCOMPARE(button->text(), QStringLiteral("#336699"));
    QCOMPARE(dialog->currentColor(), QColor("#336699"));
    QCOMPARE(m_window->document().undoStack().count(), 1);
}

void TestUndo::keepingTheViewIsUndone() {
    m_window->key(Qt::Key_7);
    (*m_window)->actions().keepView->trigger();
    QVERIFY(m_window->scene().camera.has_value());
    undo();
    QVERIFY(!m_window->scene().camera.has_value());
}

void TestUndo::theStatusBarSaysWhatWasUndone() {
    m_window->typeInto(m_window->field("cloth.ks"), "4000");
    m_window->key(Qt::Key_Return);
    undo();
    QCOMPARE((*m_window)->statusBar()->currentMessage(), QStringLiteral("Undone: change Stiffness ks"));
}

void TestUndo::theMenuSaysWhatWouldBeUndone() {
    auto* action = (*m_window)->findChild<QAction*>("undo");
    auto* again = (*m_window)->findChild<QAction*>("redo");
    QVERIFY(action && !action->isEnabled() && !again->isEnabled());
    m_window->typeInto(m_window->field("cloth.ks"), "4000");
    m_window->key(Qt::Key_Return);
    QVERIFY(action->isEnabled());
    QVERIFY(action->text().contains("change Stiffness ks"));
    action->trigger();
    QVERIFY(!action->isEnabled());
    QVERIFY(again->isEnabled());
}

CLOTHLAB_GUI_TEST_MAIN(TestUndo)
#include "tst_undo.moc"
