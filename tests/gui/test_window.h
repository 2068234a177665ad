// A window to test, with settings and a folder of its own, and the hands that work it. Clicks and keys go in
// where the platform's do, so that shortcuts, focus, and what lies over what all count.
#pragma once

#include "app/docks/appearance_panel.h"
#include "app/docks/inspector_panel.h"
#include "app/docks/output_panel.h"
#include "app/docks/shader_editor.h"
#include "app/docks/simulation_panel.h"
#include "app/docks/springs_panel.h"
#include "app/docks/takes_panel.h"
#include "app/docks/timeline_panel.h"
#include "app/viewport/viewport.h"
#include "app/widgets/foldable_group.h"
#include "app/widgets/number_field.h"
#include "app/widgets/parameter_row.h"
#include "app/window/actions.h"
#include "app/window/file_controller.h"
#include "app/window/main_window.h"
#include "app/window/message_bar.h"
#include "simcore/scene/scene_io.h"

#include <QApplication>
#include <QDockWidget>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QTest>
#include <QToolButton>

#include <memory>

namespace clothlab {

// How long a test waits for what has to come, in ms: much longer than it takes, as the machine may be busy.
constexpr int kPatience = 30000;

#define TRY_COMPARE(actual, expected) QTRY_COMPARE_WITH_TIMEOUT(actual, expected, kPatience)
#define TRY_VERIFY(condition) QTRY_VERIFY_WITH_TIMEOUT(condition, kPatience)

// A sheet of 6 × 6 points that hangs from two corners and takes no time to compute.
inline Scene smallScene() {
    Scene scene;
    scene.cloth.numWidthPoints = 6;
    scene.cloth.numHeightPoints = 6;
    scene.cloth.pinned = {{0, 0}, {5, 0}};
    scene.cloth.thickness = 0;
    scene.simulation.stepsPerFrame = 4;
    return scene;
}

class TestWindow {
public:
    // shaders: a folder of them; empty for that of the program.
    explicit TestWindow(QSize size = {1440, 900}, const QString& shaders = {})
        : m_size(size), m_shaders(shaders) {
        open();
    }

    MainWindow* operator->() { return m_window.get(); }
    MainWindow& operator*() { return *m_window; }
    Document& document() { return m_window->document(); }
    Simulation& simulation() { return m_window->simulation(); }
    Viewport& viewport() { return m_window->viewport(); }
    const Scene& scene() { return document().scene(); }
    int frame() { return simulation().currentFrame(); }
    int frameCount() { return simulation().recording().frameCount(); }
    NumberField* field(const QString& parameter) {
        return m_window->simulationPanel().row(parameter)->field();
    }
    QString output() { return m_window->outputPanel().toPlainText(); }

    // In the folder of this test.
    QString path(const QString& name) const { return m_folder.filePath(name); }
    QString write(const QString& name, const Scene& scene) const {
        if (const auto error = saveScene(scene, path(name).toStdString()))
            qFatal("%s", error->c_str());
        return path(name);
    }
    QString writeText(const QString& name, const QByteArray& text) const {
        QFile file(path(name));
        if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size())
            qFatal("%s could not be written", qPrintable(path(name)));
        return path(name);
    }
    bool load(const Scene& scene) { return m_window->files().openUnasked(write("scene.json", scene)); }

    // Another window with the same settings; the layout of this one is kept if it was closed.
    void open();

    void unfoldAll();          // every group of every panel, so that what is in them can be clicked
    bool simulateTo(int last); // shows that frame, simulating as far as is needed

    // A key as the keyboard sends it: to whatever has the focus.
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);
    void type(const QString& text);

    // A click on a widget at that place, or in its middle. Whatever lies over it gets the click instead.
    void click(QWidget* widget, QPoint at = {}, Qt::KeyboardModifiers modifiers = Qt::NoModifier,
               Qt::MouseButton button = Qt::LeftButton);
    void doubleClick(QWidget* widget, QPoint at = {});
    // In steps, as a hand makes them.
    void drag(QWidget* widget, QPoint from, QPoint to, Qt::KeyboardModifiers modifiers = Qt::NoModifier,
              Qt::MouseButton button = Qt::LeftButton);
    void click(QAction* action, QWidget* bar);

    // Puts the focus into a field by a click and types over what is there.
    void typeInto(NumberField* field, const QString& text);

private:
    // After a dialog is closed a window manager makes the window the active one again; there may be none
    // here.
    QWindow* focusWindow() const;

    QTemporaryDir m_folder;
    QSize m_size;
    QString m_shaders;
    std::unique_ptr<MainWindow> m_window;
};

// The application of a test of the window.
#define CLOTHLAB_GUI_TEST_MAIN(Test)                                                                         \
    int main(int argc, char** argv) {                                                                        \
        QApplication application(argc, argv);                                                                \
        Test test;                                                                                           \
        return QTest::qExec(&test, argc, argv);                                                              \
    }

} // namespace clothlab
