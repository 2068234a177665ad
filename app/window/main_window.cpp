#include "app/window/main_window.h"

#include "app/docks/appearance_panel.h"
#include "app/docks/inspector_panel.h"
#include "app/docks/output_panel.h"
#include "app/docks/shader_editor.h"
#include "app/docks/simulation_panel.h"
#include "app/docks/springs_panel.h"
#include "app/docks/timeline_panel.h"
#include "app/document/data_files.h"
#include "app/picture/save_picture.h"
#include "app/render/shader_folder.h"
#include "app/viewport/viewport.h"
#include "app/widgets/icons.h"
#include "app/window/actions.h"
#include "app/window/export_controller.h"
#include "app/window/file_controller.h"
#include "app/window/message_bar.h"
#include "app/window/system_theme.h"

#include <QApplication>
#include <QCloseEvent>
#include <QDateTime>
#include <QDockWidget>
#include <QFileInfo>
#include <QLocale>
#include <QMimeData>
#include <QStatusBar>
#include <QVBoxLayout>

#include <utility>

namespace clothlab {
namespace {

const QString kRecordingErrorKey = QStringLiteral("recordingError");

int framesIn(const TakeFileContents& contents) {
    int frames = 0;
    for (const RecordedTake& take : contents.takes)
        frames += take.end() - take.info.firstOwnFrame();
    return frames;
}

// Neither simulated nor edited.
bool isNothing(const TakeFileContents& contents) {
    return contents.takes.empty() || (framesIn(contents) <= 1 && contents.meta.scene == 0);
}

} // namespace

MainWindow::MainWindow(std::unique_ptr<QSettings> settings, const QString& shaderDirectory,
                       const QString& recoveryDirectory, QWidget* parent)
    : QMainWindow(parent), m_settings(std::move(settings)), m_recovery(recoveryDirectory),
      m_simulation(m_document), m_actions(new Actions(*this)),
      m_files(new FileController(m_document, m_simulation, *m_settings, *this)), m_messageBar(new MessageBar),
      m_viewport(new Viewport(m_document, m_simulation)),
      m_shaderFolder(new render::ShaderFolder(
          shaderDirectory.isEmpty() ? dataDirectory("shaders") : shaderDirectory, this)),
      m_systemTheme(new SystemTheme(this)), m_textureDirectory(dataDirectory("textures")) {
    setObjectName("mainWindow");
    setWindowIcon(themedIcon("cloth-app"));
    setAcceptDrops(true);
    setDockOptions(AnimatedDocks | AllowNestedDocks | AllowTabbedDocks);
    resize(1440, 900);

    m_viewport->setDirectories(m_shaderFolder->path(), m_textureDirectory);
    auto* centre = new QWidget;
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_messageBar);
    layout->addWidget(m_viewport, 1);
    setCentralWidget(centre);

    m_exports = new ExportController(m_document, m_simulation, *m_viewport,
                                     {m_shaderFolder->path(), m_textureDirectory}, *this);
    makePanels();
    makeToolBar();
    makeMenus();
    makeStatusBar();
    connectFileActions();
    connectSimulationActions();
    connectViewActions();
    connectShaders();
    connectMessages();
    updateTitle();
    updateTransport();
    updateAppearanceControls();
    connect(m_systemTheme, &SystemTheme::changed, this, &MainWindow::applyChosenTheme);
    applyChosenTheme();
    m_viewport->setFocus();
    m_simulation.setJournals([this] { return newJournal(); });
    offerRecovery();
}

MainWindow::~MainWindow() {
    // The panels look at document and simulation, which are gone before QWidget deletes its children.
    delete m_exports;
    const auto children = findChildren<QWidget*>(Qt::FindDirectChildrenOnly);
    qDeleteAll(children);
}

QDockWidget* MainWindow::dock(const QString& name) const {
    return findChild<QDockWidget*>(name);
}

// --- what a crash leaves

QString MainWindow::newJournal() {
    QString problem;
    QString path = m_recovery.begin(problem);
    if (!problem.isEmpty())
        say(problem);
    return path;
}

void MainWindow::offerRecovery() {
    const QStringList left = m_recovery.left();
    if (left.isEmpty())
        return;
    const QString& journal = left.constFirst();
    const TakeFileReading reading = readTakeFile(journal.toStdString());
    if (!reading.contents || isNothing(*reading.contents)) {
        if (m_recovery.claim(journal))
            m_recovery.discard(journal);
        return;
    }
    auto* open = new QAction(tr("Open It"));
    open->setObjectName("openRecovered");
    open->setToolTip(tr("Open what was recorded; save it to keep it"));
    auto* discard = new QAction(tr("Discard It"));
    discard->setObjectName("discardRecovered");
    discard->setToolTip(tr("Delete what was recorded, for good"));
    connect(open, &QAction::triggered, this, [this, journal] { recover(journal); });
    connect(discard, &QAction::triggered, this, [this, journal] {
        if (m_recovery.claim(journal))
            m_recovery.discard(journal);
        offerRecovery(); // there may be more
    });
    m_messageBar->offer(tr("A crash left a recording, made until %1 (frames: %2).")
                            .arg(QLocale::c().toString(QFileInfo(journal).lastModified(), "yyyy-MM-dd HH:mm"))
                            .arg(framesIn(*reading.contents)),
                        {open, discard});
}

void MainWindow::recover(const QString& journal) {
    if (!m_recovery.claim(journal) || !m_files->openRecovered(journal))
        return;
    // Only now that it is in the journal of this run.
    m_simulation.whenPacked([this, journal] {
        if (m_simulation.hasJournal())
            m_recovery.discard(journal);
    });
}

void MainWindow::connectFileActions() {
    connect(m_actions->newScene, &QAction::triggered, m_files, &FileController::newScene);
    connect(m_actions->open, &QAction::triggered, m_files, &FileController::chooseAndOpen);
    connect(m_actions->save, &QAction::triggered, m_files, &FileController::save);
    connect(m_actions->saveAs, &QAction::triggered, m_files, &FileController::saveAs);
    connect(m_actions->saveRecording, &QAction::triggered, m_files, &FileController::saveRecordingAs);
    connect(m_files, &FileController::savingProgress, this, [this](int percent) {
        statusBar()->showMessage(tr("Saving the recording: %1 %").arg(percent), 2000);
    });
    connect(m_actions->screenshot, &QAction::triggered, this, &MainWindow::choosePicture);
    connect(m_actions->exportFrames, &QAction::triggered, m_exports, &ExportController::showDialog);
    connect(m_actions->quit, &QAction::triggered, this, &QWidget::close);
    connect(&m_document, &Document::fileChanged, this, &MainWindow::updateTitle);
}

void MainWindow::connectSimulationActions() {
    Simulation* s = &m_simulation;
    connect(m_actions->playPause, &QAction::triggered, s, &Simulation::togglePlaying);
    connect(m_actions->stepBack, &QAction::triggered, s, [s] { s->moveBy(-1); });
    connect(m_actions->stepForward, &QAction::triggered, s, [s] { s->moveBy(1); });
    connect(m_actions->tenBack, &QAction::triggered, s, [s] { s->moveBy(-10); });
    connect(m_actions->tenForward, &QAction::triggered, s, [s] { s->moveBy(10); });
    connect(m_actions->firstFrame, &QAction::triggered, s, [s] { s->showFrame(0); });
    connect(m_actions->lastFrame, &QAction::triggered, s, [s] { s->showFrame(s->recording().lastFrame()); });
    connect(m_actions->simulateFrame, &QAction::triggered, s, &Simulation::simulateFrame);
    connect(m_actions->restart, &QAction::triggered, s, &Simulation::restart);
    connectPlaybackActions();
    restorePlayback();
    connectPrecisionActions();
    connect(s, &Simulation::frameShown, this, &MainWindow::updateTransport);
    connect(s, &Simulation::recordingChanged, this, &MainWindow::updateTransport);
}

void MainWindow::connectPrecisionActions() {
    const double kept = m_settings->value(kRecordingErrorKey, kDefaultError).toDouble();
    for (QAction* action : {m_actions->recordHundredth, m_actions->recordTenth, m_actions->recordExactly}) {
        const double error = action->data().toDouble();
        connect(action, &QAction::triggered, this, [this, error] {
            m_simulation.setRecordingError(error);
            m_settings->setValue(kRecordingErrorKey, error);
        });
        if (error == kept)
            m_simulation.setRecordingError(error);
        action->setChecked(error == m_simulation.recordingError());
    }
}

void MainWindow::connectMessages() {
    connect(m_files, &FileController::notice, this, &MainWindow::say);
    connect(m_files, &FileController::problem, this, &MainWindow::showProblem);
    connect(m_exports, &ExportController::notice, this, &MainWindow::say);
    connect(m_exports, &ExportController::problem, this, &MainWindow::showProblem);
    connect(&m_document, &Document::sceneReplaced, m_messageBar, &MessageBar::closeProblem);
    connect(&m_simulation, &Simulation::notice, this, &MainWindow::say);
    connect(&m_simulation, &Simulation::blowUpChanged, this, [this] {
        if (!m_simulation.blowUp().isEmpty())
            say(tr("The cloth %1.").arg(m_simulation.blowUp()));
    });
    connect(m_simulationPanel, &SimulationPanel::rejected, this, &MainWindow::say);
    connect(m_timelinePanel, &TimelinePanel::rejected, this, &MainWindow::say);
    connect(m_appearancePanel, &AppearancePanel::rejected, this, &MainWindow::say);
    connect(m_viewport, &Viewport::problemsChanged, this, &MainWindow::tellProblems);
    connect(m_outputPanel, &OutputPanel::openAsked, this, &MainWindow::openShader);
    connect(m_shaderEditor, &ShaderEditor::problem, this, &MainWindow::showProblem);
    connect(m_shaderEditor, &ShaderEditor::notice, this, &MainWindow::say);
    // What an undo or redo did.
    connect(&m_document.undoStack(), &QUndoStack::indexChanged, this, [this, before = 0](int index) mutable {
        if (index < before)
            statusBar()->showMessage(tr("Undone: %1").arg(m_document.undoStack().text(index)), 5000);
        before = index;
    });
}

void MainWindow::say(const QString& text) {
    constexpr int milliseconds = 10000;
    statusBar()->showMessage(text.section('\n', 0, 0), milliseconds);
    m_outputPanel->add(text);
}

void MainWindow::showProblem(const QString& text) {
    m_messageBar->showProblem(text);
    m_outputPanel->add(text);
}

void MainWindow::updateTitle() {
    setWindowTitle(tr("%1[*] — ClothLab").arg(m_document.displayName()));
    setWindowModified(m_document.isModified());
    setWindowFilePath(m_document.path());
}

void MainWindow::updateAppearanceControls() {
    const Appearance& appearance = m_document.scene().appearance;
    showShader(*m_shaderSelector, m_shaderFolder->names(), QString::fromStdString(appearance.shader));
    const bool visible = appearance.shader == "Wireframe" || appearance.springsOverSurface;
    for (int type = 0; type < kSpringTypes; ++type) {
        QAction* action = m_springActions[std::size_t(type)];
        action->setChecked(appearance.springsDrawn[std::size_t(type)]);
        setUsable(action, visible,
                  tr("Springs are drawn by the shader Wireframe, or over surfaces (panel Springs)"));
    }
}

std::optional<QString> MainWindow::savePicture(const QString& path) {
    return clothlab::savePicture(grab().toImage(), path);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!m_files->mayDiscard() || !mayDropShaderText() || !m_exports->mayClose()) {
        event->ignore();
        return;
    }
    keepLayout();
    keepPlayback();
    event->accept();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    const QList<QUrl> urls = event->mimeData()->urls();
    if (urls.size() == 1 && urls.constFirst().isLocalFile())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    event->acceptProposedAction();
    const QString path = event->mimeData()->urls().constFirst().toLocalFile();
    // After the drop, so that a question does not hold up the program that it came from.
    QMetaObject::invokeMethod(
        this, [this, path] { m_files->open(path); }, Qt::QueuedConnection);
}

} // namespace clothlab
