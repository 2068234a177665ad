// The part of the main window that carries out what concerns the view, and the windows of Help.
#include "app/docks/appearance_panel.h"
#include "app/viewport/viewport.h"
#include "app/window/actions.h"
#include "app/window/main_window.h"

#include <QApplication>
#include <QComboBox>
#include <QDialog>
#include <QDir>
#include <QFileDialog>
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

    connect(m_actions->fullScreen, &QAction::triggered, this,
            [this](bool full) { setWindowState(windowState().setFlag(Qt::WindowFullScreen, full)); });
    connect(m_actions->hidePanels, &QAction::triggered, this, &MainWindow::setPanelsHidden);
    connect(m_viewport, &Viewport::tabPressed, m_actions->hidePanels, &QAction::trigger);
    connect(m_actions->resetLayout, &QAction::triggered, this, &MainWindow::resetLayout);
    connect(m_actions->darkTheme, &QAction::triggered, this, [this] { setTheme(Theme::Dark); });
    connect(m_actions->lightTheme, &QAction::triggered, this, [this] { setTheme(Theme::Light); });
    connect(m_actions->keys, &QAction::triggered, this, &MainWindow::showKeys);
    connect(m_actions->about, &QAction::triggered, this, &MainWindow::showAbout);

    connect(m_shaderSelector, &QComboBox::textActivated, this,
            [this](const QString& shader) { setShader(m_document, shader); });
    connect(&m_document, &Document::sceneChanged, this, &MainWindow::updateAppearanceControls);
    connect(&m_document, &Document::sceneReplaced, this, &MainWindow::updateAppearanceControls);
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
    const QString mouse =
        tr("<p><b>In the view:</b> left drag orbits; right, middle or Shift+left drag pans; the wheel "
           "zooms to the cursor; a click selects a point mass or a spring, Shift+click adds, "
           "Ctrl+click removes; Tab hides all panels.</p><p><b>In number fields:</b> expressions such "
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
