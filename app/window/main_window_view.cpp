// The part of the main window that carries out what concerns the view, and the windows of Help.
#include "app/docks/appearance_panel.h"
#include "app/docks/output_panel.h"
#include "app/docks/shader_editor.h"
#include "app/render/shader_folder.h"
#include "app/viewport/viewport.h"
#include "app/window/actions.h"
#include "app/window/main_window.h"
#include "app/window/message_bar.h"
#include "app/window/picture_dialog.h"

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>
#include <QTextBrowser>
#include <QVBoxLayout>

namespace clothlab {

void MainWindow::connectViewActions() {
    connect(m_actions->home, &QAction::triggered, m_viewport, &Viewport::goHome);
    connect(m_actions->frameSelection, &QAction::triggered, m_viewport, &Viewport::frameSelection);
    connect(m_actions->frameAll, &QAction::triggered, m_viewport, &Viewport::frameAll);
    const std::initializer_list<std::pair<QAction*, ViewDirection>> directions{
        {m_actions->front, ViewDirection::Front}, {m_actions->back, ViewDirection::Back},
        {m_actions->right, ViewDirection::Right}, {m_actions->left, ViewDirection::Left},
        {m_actions->top, ViewDirection::Top},     {m_actions->bottom, ViewDirection::Bottom}};
    for (const auto& [action, direction] : directions)
        connect(action, &QAction::triggered, m_viewport,
                [this, direction = direction] { m_viewport->look(direction); });
    connect(m_actions->orthographic, &QAction::triggered, m_viewport, &Viewport::toggleOrthographic);
    connect(m_viewport, &Viewport::cameraChanged, this,
            [this] { m_actions->orthographic->setChecked(m_viewport->camera().orthographic); });
    connect(m_actions->keepView, &QAction::triggered, this, &MainWindow::keepView);
    connect(m_actions->boxSelect, &QAction::triggered, m_viewport, &Viewport::beginBoxSelection);
    connect(m_actions->clearSelection, &QAction::triggered, this, [this] { m_document.setSelection({}); });

    connect(m_actions->picture, &QAction::triggered, this, &MainWindow::showPictureDialog);
    connect(m_actions->fullScreen, &QAction::triggered, this,
            [this](bool full) { setWindowState(windowState().setFlag(Qt::WindowFullScreen, full)); });
    connect(m_actions->hidePanels, &QAction::triggered, this, &MainWindow::setPanelsHidden);
    connect(m_viewport, &Viewport::tabPressed, m_actions->hidePanels, &QAction::trigger);
    connect(m_actions->resetLayout, &QAction::triggered, this, &MainWindow::resetLayout);
    connect(m_actions->systemTheme, &QAction::triggered, this, [this] { setTheme(std::nullopt); });
    connect(m_actions->darkTheme, &QAction::triggered, this, [this] { setTheme(Theme::Dark); });
    connect(m_actions->lightTheme, &QAction::triggered, this, [this] { setTheme(Theme::Light); });
    connect(m_actions->keys, &QAction::triggered, this, &MainWindow::showKeys);
    connect(m_actions->about, &QAction::triggered, this, &MainWindow::showAbout);

    connect(m_shaderSelector, &QComboBox::textActivated, this,
            [this](const QString& shader) { setShader(m_document, shader); });
    connect(&m_document, &Document::sceneChanged, this, &MainWindow::updateAppearanceControls);
    connect(&m_document, &Document::sceneReplaced, this, &MainWindow::updateAppearanceControls);
}

void MainWindow::connectShaders() {
    m_appearancePanel->setShaders(m_shaderFolder->names());
    connect(m_shaderFolder, &render::ShaderFolder::namesChanged, this, [this] {
        m_appearancePanel->setShaders(m_shaderFolder->names());
        updateAppearanceControls();
    });
    connect(m_shaderFolder, &render::ShaderFolder::filesChanged, m_viewport, &Viewport::reloadShaders);
    connect(m_shaderFolder, &render::ShaderFolder::filesChanged, m_shaderEditor,
            &ShaderEditor::fileMayHaveChanged);
    connect(m_viewport, &Viewport::shaderShown, m_appearancePanel, &AppearancePanel::setUniforms);
    const auto editShader = [this] {
        openShader(m_shaderFolder->fileOf(QString::fromStdString(m_document.scene().appearance.shader)), 0);
    };
    connect(m_appearancePanel, &AppearancePanel::editShaderAsked, this, editShader);
    connect(m_actions->editShader, &QAction::triggered, this, editShader);
    connect(m_actions->reloadShaders, &QAction::triggered, m_viewport, &Viewport::reloadFiles);
}

void MainWindow::openShader(const QString& path, int line) {
    if (!m_shaderEditor->open(path, line))
        return;
    QDockWidget* panel = dock("shader");
    panel->show();
    panel->raise();
    if (panel->height() < height() / 3)
        resizeDocks({panel}, {height() / 3}, Qt::Vertical);
    m_shaderEditor->setFocus();
}

// All in Output, the first above the view, where it goes away once it is mended.
void MainWindow::tellProblems() {
    const render::Problems& problems = m_viewport->problems();
    m_shaderEditor->setProblems(problems);
    for (const render::Problem& problem : problems)
        m_outputPanel->add(problem);
    if (problems.isEmpty()) {
        if (m_messageBar->text() == m_shaderProblem)
            m_messageBar->hide();
        say(tr("Shaders and textures are in order."));
        return;
    }
    const auto more = problems.size() - 1;
    m_shaderProblem = render::words(problems.constFirst()) +
                      (more > 0 ? tr("\n… and %1 more, in Output").arg(more) : QString());
    m_messageBar->showProblem(m_shaderProblem);
}

bool MainWindow::mayDropShaderText() {
    if (!m_shaderEditor->isModified())
        return true;
    QMessageBox box(QMessageBox::Question, tr("Unsaved shader"),
                    tr("Save the changes to %1?").arg(QFileInfo(m_shaderEditor->path()).fileName()),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, this);
    box.setInformativeText(tr("They are lost otherwise."));
    box.setDefaultButton(QMessageBox::Save);
    const int answer = box.exec();
    return answer == QMessageBox::Discard || (answer == QMessageBox::Save && m_shaderEditor->save());
}

void MainWindow::showPictureDialog() {
    if (!m_pictureDialog) {
        m_pictureDialog = new PictureDialog(*m_viewport, m_shaderFolder->path(), m_textureDirectory, this);
        connect(m_pictureDialog, &PictureDialog::problem, this, &MainWindow::showProblem);
        connect(m_pictureDialog, &PictureDialog::saved, this,
                [this](const QString& path) { say(tr("Saved %1").arg(path)); });
    }
    m_pictureDialog->show();
    m_pictureDialog->raise();
}

void MainWindow::keepView() {
    Scene after = m_document.scene();
    after.camera = m_viewport->camera().view;
    m_document.edit(tr("keep the view"), std::move(after));
    say(tr("The scene now opens with this view."));
}

void MainWindow::choosePicture() {
    // Before the chooser covers the window.
    const QString path = QFileDialog::getSaveFileName(
        this, tr("Save a picture of the window"), QDir::homePath() + "/clothlab.png", tr("Pictures (*.png)"));
    if (path.isEmpty())
        return;
    if (const auto error = savePicture(path))
        showProblem(*error);
    else
        say(tr("Saved %1").arg(path));
}

void MainWindow::showKeys() {
    QString rows;
    for (const QAction* action : QWidget::actions()) {
        QStringList names;
        for (const QKeySequence& key : action->shortcuts())
            names << key.toString(QKeySequence::NativeText).toHtmlEscaped();
        if (!names.isEmpty())
            rows += QStringLiteral("<tr><td><b>%1</b></td><td style='padding-left:16px'>%2</td></tr>")
                        .arg(names.join(", "),
                             (action->statusTip().isEmpty() ? action->text() : action->statusTip())
                                 .toHtmlEscaped());
    }
    const QString mouse = tr(
        "<p><b>In the view:</b> left drag orbits; right, middle or Shift+left drag pans; the wheel "
        "zooms to the cursor; a click selects a point mass or a spring, Shift+click adds, "
        "Ctrl+click removes; Tab hides all panels.</p><p><b>In the timeline:</b> a drag shows the frames; "
        "rest on one for a picture of it; click a marker to go there, double-click it to rename, Delete "
        "removes it; drag [ and ] to move in and out point.</p><p><b>In number fields:</b> expressions such "
        "as 1/90; Up, Down and the wheel step; drag the label sideways; double-click it for the "
        "default.</p>");
    auto* dialog = new QDialog(this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setWindowTitle(tr("Keys and mouse"));
    auto* text = new QTextBrowser;
    text->setHtml(mouse + "<p></p><table>" + rows + "</table>");
    auto* layout = new QVBoxLayout(dialog);
    layout->addWidget(text);
    dialog->resize(560, 640);
    dialog->show();
}

void MainWindow::showAbout() {
    auto* box = new QMessageBox(QMessageBox::NoIcon, tr("About ClothLab"),
                                tr("<b>ClothLab %1</b><p>An editor and inspector for mass-spring cloth.</p>")
                                    .arg(QStringLiteral(CLOTHLAB_VERSION)),
                                QMessageBox::Close, this);
    box->setAttribute(Qt::WA_DeleteOnClose);
    box->setModal(false);
    box->show();
}

} // namespace clothlab
