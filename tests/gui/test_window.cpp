#include "tests/gui/test_window.h"

#include <QScrollArea>
#include <QWindow>

namespace clothlab {
namespace {

void mouse(QTest::MouseAction action, QWidget* widget, QPoint at, Qt::KeyboardModifiers modifiers,
           Qt::MouseButton button) {
    for (QWidget* w = widget->parentWidget(); w && action == QTest::MousePress; w = w->parentWidget())
        if (auto* area = qobject_cast<QScrollArea*>(w))
            area->ensureWidgetVisible(widget);
    const QPoint place = at.isNull() ? widget->rect().center() : at;
    QTest::mouseEvent(action, widget->window()->windowHandle(), button, modifiers,
                      widget->mapTo(widget->window(), place));
}

} // namespace

void TestWindow::open() {
    m_window.reset();
    m_window = std::make_unique<MainWindow>(
        std::make_unique<QSettings>(path("settings.ini"), QSettings::IniFormat), m_shaders, path("recovery"));
    m_window->resize(m_size);
    m_window->show();
    m_window->activateWindow();
    if (!QTest::qWaitForWindowExposed(m_window.get(), kPatience) ||
        !QTest::qWaitForWindowActive(m_window.get(), kPatience))
        qFatal("the window does not appear");
}

void TestWindow::unfoldAll() {
    for (FoldableGroup* group : m_window->findChildren<FoldableGroup*>())
        group->setFolded(false);
    QApplication::processEvents();
}

bool TestWindow::simulateTo(int last) {
    while (frameCount() <= last) {
        const int before = frameCount();
        simulation().simulateFrame();
        if (!QTest::qWaitFor([&] { return frameCount() > before || !simulation().blowUp().isEmpty(); },
                             kPatience) ||
            frameCount() == before)
            return false;
    }
    simulation().showFrame(last);
    return true;
}

void TestWindow::key(Qt::Key key, Qt::KeyboardModifiers modifiers) {
    QTest::keyClick(focusWindow(), key, modifiers);
}

void TestWindow::type(const QString& text) {
    for (const QChar c : text)
        QTest::keyClick(focusWindow(), c.toLatin1());
}

void TestWindow::click(QWidget* widget, QPoint at, Qt::KeyboardModifiers modifiers, Qt::MouseButton button) {
    mouse(QTest::MousePress, widget, at, modifiers, button);
    mouse(QTest::MouseRelease, widget, at, modifiers, button);
}

void TestWindow::doubleClick(QWidget* widget, QPoint at) {
    mouse(QTest::MouseDClick, widget, at, Qt::NoModifier, Qt::LeftButton);
    mouse(QTest::MouseRelease, widget, at, Qt::NoModifier, Qt::LeftButton);
}

void TestWindow::drag(QWidget* widget, QPoint from, QPoint to, Qt::KeyboardModifiers modifiers,
                      Qt::MouseButton button) {
    constexpr int steps = 8;
    mouse(QTest::MousePress, widget, from, modifiers, button);
    for (int i = 1; i <= steps; ++i)
        mouse(QTest::MouseMove, widget, from + (to - from) * i / steps, modifiers, Qt::NoButton);
    mouse(QTest::MouseRelease, widget, to, modifiers, button);
}

void TestWindow::click(QAction* action, QWidget* bar) {
    for (QToolButton* button : bar->findChildren<QToolButton*>())
        if (button->defaultAction() == action && button->isVisible())
            return click(button);
    QFAIL(qPrintable("no button for " + action->text()));
}

void TestWindow::typeInto(NumberField* field, const QString& text) {
    click(field);
    field->selectAll();
    type(text);
}

QWindow* TestWindow::focusWindow() const {
    if (!QApplication::activeWindow()) {
        m_window->activateWindow();
        if (!QTest::qWaitForWindowActive(m_window.get(), kPatience))
            qFatal("the window does not become the active one");
    }
    return QGuiApplication::focusWindow();
}

} // namespace clothlab
