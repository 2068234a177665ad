// The part of the main window that makes panels, menus and bars, and keeps their layout.
#include "app/docks/appearance_panel.h"
#include "app/docks/inspector_panel.h"
#include "app/docks/output_panel.h"
#include "app/docks/shader_editor.h"
#include "app/docks/simulation_panel.h"
#include "app/docks/springs_panel.h"
#include "app/docks/takes_panel.h"
#include "app/docks/text.h"
#include "app/docks/timeline_panel.h"
#include "app/viewport/viewport.h"
#include "app/widgets/icons.h"
#include "app/window/actions.h"
#include "app/window/export_controller.h"
#include "app/window/export_progress.h"
#include "app/window/file_controller.h"
#include "app/window/main_window.h"
#include "app/window/status_line.h"
#include "app/window/system_theme.h"

#include <QApplication>
#include <QComboBox>
#include <QDockWidget>
#include <QLabel>
#include <QMenuBar>
#include <QScrollArea>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>

#include <utility>

namespace clothlab {
namespace {

constexpr int kLayoutVersion = 3; // of saveState(); another number forgets what was kept

} // namespace

void MainWindow::makePanels() {
    m_springsPanel = new SpringsPanel(m_document);
    m_appearancePanel = new AppearancePanel(m_document, m_simulation);
    m_inspectorPanel = new InspectorPanel(m_document, m_simulation);
    m_simulationPanel = new SimulationPanel(m_document);
    m_timelinePanel = new TimelinePanel(m_document, m_simulation,
                                        {m_actions->firstFrame, m_actions->stepBack, m_actions->playBackward,
                                         m_actions->playPause, m_actions->stepForward, m_actions->lastFrame,
                                         m_actions->simulateFrame, m_actions->restart});
    m_timelinePanel->setCamera([this] { return m_viewport->camera(); });
    m_takesPanel = new TakesPanel(m_simulation);
    m_outputPanel = new OutputPanel;
    m_shaderEditor = new ShaderEditor;

    setCorner(Qt::BottomLeftCorner, Qt::BottomDockWidgetArea);
    setCorner(Qt::BottomRightCorner, Qt::BottomDockWidgetArea);
    addDock("springs", tr("Springs"), m_springsPanel, Qt::LeftDockWidgetArea, false);
    addDock("appearance", tr("Appearance"), m_appearancePanel, Qt::LeftDockWidgetArea, true);
    addDock("simulation", tr("Simulation"), m_simulationPanel, Qt::RightDockWidgetArea, true);
    addDock("inspector", tr("Inspector"), m_inspectorPanel, Qt::RightDockWidgetArea, false);
    addDock("timeline", tr("Timeline"), m_timelinePanel, Qt::BottomDockWidgetArea, false);
    addDock("takes", tr("Takes"), m_takesPanel, Qt::BottomDockWidgetArea, false);
    addDock("output", tr("Output"), m_outputPanel, Qt::BottomDockWidgetArea, false);
    addDock("shader", tr("Shader"), m_shaderEditor, Qt::BottomDockWidgetArea, false);
    tabifyDockWidget(dock("timeline"), dock("takes"));
    tabifyDockWidget(dock("takes"), dock("output"));
    tabifyDockWidget(dock("output"), dock("shader"));
    dock("timeline")->raise();
    m_defaultState = saveState(kLayoutVersion);
}

QDockWidget* MainWindow::addDock(const QString& name, const QString& title, QWidget* panel,
                                 Qt::DockWidgetArea area, bool scrolls) {
    auto* dockWidget = new QDockWidget(title, this);
    dockWidget->setObjectName(name);
    if (scrolls) {
        auto* scrollArea = new QScrollArea;
        scrollArea->setWidgetResizable(true);
        scrollArea->setFrameShape(QFrame::NoFrame);
        scrollArea->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
        scrollArea->setWidget(panel);
        dockWidget->setWidget(scrollArea);
    } else {
        dockWidget->setWidget(panel);
    }
    panel->setAttribute(Qt::WA_StyledBackground); // the theme's, which plain widgets do not paint
    addDockWidget(area, dockWidget);
    return dockWidget;
}

void MainWindow::makeMenus() {
    QMenu* file = menuBar()->addMenu(tr("&File"));
    file->addActions({m_actions->newScene, m_actions->open});
    file->addMenu(m_files->recentMenu());
    file->addSeparator();
    file->addActions({m_actions->save, m_actions->saveAs, m_actions->saveRecording});
    file->addSeparator();
    file->addActions({m_actions->exportFrames, m_actions->picture, m_actions->screenshot});
    file->addSeparator();
    file->addAction(m_actions->quit);

    QMenu* edit = menuBar()->addMenu(tr("&Edit"));
    edit->addActions({findChild<QAction*>("undo"), findChild<QAction*>("redo")});

    QMenu* view = menuBar()->addMenu(tr("&View"));
    view->addActions({m_actions->home, m_actions->frameSelection, m_actions->frameAll});
    QMenu* directions = view->addMenu(tr("Look &From"));
    directions->addActions({m_actions->front, m_actions->back, m_actions->right, m_actions->left,
                            m_actions->top, m_actions->bottom});
    view->addActions({m_actions->orthographic, m_actions->keepView});
    view->addSeparator();
    view->addActions({m_actions->systemTheme, m_actions->darkTheme, m_actions->lightTheme});
    view->addSeparator();
    view->addAction(m_actions->fullScreen);

    QMenu* simulation = menuBar()->addMenu(tr("&Simulation"));
    simulation->addActions({m_actions->playPause, m_actions->simulateFrame, m_actions->restart});
    QMenu* precision = simulation->addMenu(tr("&Keep Positions"));
    precision->addActions({m_actions->recordHundredth, m_actions->recordTenth, m_actions->recordExactly});
    precision->setToolTipsVisible(true);
    simulation->addSeparator();
    simulation->addActions({m_actions->firstFrame, m_actions->tenBack, m_actions->stepBack,
                            m_actions->stepForward, m_actions->tenForward, m_actions->lastFrame});
    simulation->addSeparator();
    simulation->addActions({m_actions->playBackward, m_actions->slower, m_actions->faster, m_actions->loop});
    simulation->addSeparator();
    simulation->addActions({m_actions->setIn, m_actions->setOut, m_actions->clearRange});
    simulation->addSeparator();
    simulation->addActions({m_actions->addMarker, m_actions->previousMarker, m_actions->nextMarker});

    QMenu* selection = menuBar()->addMenu(tr("Se&lection"));
    selection->addActions({m_actions->boxSelect, m_actions->clearSelection, m_actions->frameSelection});

    QMenu* tools = menuBar()->addMenu(tr("&Tools"));
    tools->addActions({m_actions->editShader, m_actions->reloadShaders});

    QMenu* panels = menuBar()->addMenu(tr("&Panels"));
    for (const char* name :
         {"springs", "appearance", "inspector", "simulation", "timeline", "takes", "output", "shader"})
        panels->addAction(dock(name)->toggleViewAction());
    panels->addSeparator();
    panels->addActions({m_actions->hidePanels, m_actions->resetLayout});

    QMenu* help = menuBar()->addMenu(tr("&Help"));
    help->addActions({m_actions->keys, m_actions->about});
    for (QMenu* menu : {file, edit, view, simulation, selection, tools, panels, help})
        menu->setToolTipsVisible(true);
}

void MainWindow::makeToolBar() {
    QAction* undo = m_document.undoStack().createUndoAction(this, tr("Undo"));
    QAction* redo = m_document.undoStack().createRedoAction(this, tr("Redo"));
    undo->setObjectName("undo");
    redo->setObjectName("redo");
    undo->setIcon(themedIcon("undo"));
    redo->setIcon(themedIcon("redo"));
    undo->setShortcut(QKeySequence("Ctrl+Z"));
    redo->setShortcut(QKeySequence("Ctrl+Shift+Z"));
    for (QAction* action : {undo, redo}) {
        action->setShortcutContext(Qt::ApplicationShortcut);
        addAction(action);
    }

    QToolBar* bar = addToolBar(tr("Tools"));
    bar->setObjectName("toolBar");
    bar->setIconSize({20, 20});
    bar->addActions({m_actions->newScene, m_actions->open, m_actions->save});
    bar->addSeparator();
    bar->addActions({undo, redo});
    bar->addSeparator();
    bar->addActions({m_actions->boxSelect, m_actions->home, m_actions->frameAll, m_actions->frameSelection});
    bar->addSeparator();
    auto* shaderLabel = new QLabel(tr(" Shader "));
    bar->addWidget(shaderLabel);
    m_shaderSelector = new QComboBox;
    m_shaderSelector->setObjectName("shaderSelector");
    m_shaderSelector->setAccessibleName(tr("Shader"));
    m_shaderSelector->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    m_shaderSelector->setToolTip(tr("How the sheet is drawn: the .frag files in the folder of shaders"));
    bar->addWidget(m_shaderSelector);
    bar->addWidget(new QLabel(tr("  Springs ")));
    for (const SpringType type : {SpringType::Structural, SpringType::Shearing, SpringType::Bending}) {
        QAction* action = bar->addAction(themedIcon(toQString(name(type))), typeName(type));
        action->setObjectName("draw_" + toQString(name(type)));
        action->setCheckable(true);
        action->setToolTip(tr("Draw %1 springs").arg(toQString(name(type))));
        connect(action, &QAction::triggered, this,
                [this, type](bool checked) { setSpringsDrawn(m_document, type, checked); });
        m_springActions[std::size_t(type)] = action;
    }
    auto* spacer = new QWidget;
    spacer->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    bar->addWidget(spacer);
    bar->addAction(m_actions->hidePanels);
    for (QToolButton* button : bar->findChildren<QToolButton*>())
        button->setFocusPolicy(Qt::NoFocus);
}

void MainWindow::makeStatusBar() {
    statusBar()->addPermanentWidget(m_exports->statusWidget());
    statusBar()->addPermanentWidget(new StatusLine(m_document, m_simulation));
    statusBar()->setSizeGripEnabled(false);
}

void MainWindow::showEvent(QShowEvent* event) {
    QMainWindow::showEvent(event);
    if (std::exchange(m_laidOut, true))
        return;
    arrangeDocks();
    restoreLayout();
}

void MainWindow::arrangeDocks() {
    const int unit = fontMetrics().horizontalAdvance("0000000000");
    resizeDocks({dock("appearance"), dock("simulation")}, {4 * unit, 4 * unit}, Qt::Horizontal);
    resizeDocks({dock("springs"), dock("appearance")}, {dock("springs")->sizeHint().height(), height()},
                Qt::Vertical);
    resizeDocks({dock("simulation"), dock("inspector")}, {height(), height()}, Qt::Vertical);
    resizeDocks({dock("timeline")}, {dock("timeline")->minimumSizeHint().height()}, Qt::Vertical);
}

void MainWindow::restoreLayout() {
    restoreGeometry(m_settings->value("geometry").toByteArray());
    restoreState(m_settings->value("layout").toByteArray(), kLayoutVersion);
}

void MainWindow::keepLayout() {
    m_settings->setValue("geometry", saveGeometry());
    m_settings->setValue("layout", m_shownLayout.isEmpty() ? saveState(kLayoutVersion) : m_shownLayout);
}

void MainWindow::resetLayout() {
    setPanelsHidden(false);
    restoreState(m_defaultState, kLayoutVersion);
    arrangeDocks();
}

// Showing docks one by one would bring another tab to the front, and share out their sizes anew.
void MainWindow::setPanelsHidden(bool hidden) {
    if (hidden) {
        m_shownLayout = saveState(kLayoutVersion);
        for (QDockWidget* each : findChildren<QDockWidget*>())
            each->hide();
    } else if (!m_shownLayout.isEmpty()) {
        restoreState(std::exchange(m_shownLayout, {}), kLayoutVersion);
    }
    m_actions->hidePanels->setChecked(hidden);
}

void MainWindow::setTheme(std::optional<Theme> theme) {
    m_settings->setValue("theme", !theme ? "system" : *theme == Theme::Light ? "light" : "dark");
    applyChosenTheme();
}

void MainWindow::applyChosenTheme() {
    const QString chosen = m_settings->value("theme").toString();
    Theme theme = m_systemTheme->preference().value_or(Theme::Dark);
    QAction* action = m_actions->systemTheme;
    if (chosen == "light" || chosen == "dark") {
        theme = chosen == "light" ? Theme::Light : Theme::Dark;
        action = chosen == "light" ? m_actions->lightTheme : m_actions->darkTheme;
    }
    action->setChecked(true);
    applyTheme(*qApp, theme);
}

} // namespace clothlab
