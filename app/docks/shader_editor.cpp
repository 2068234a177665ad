#include "app/docks/shader_editor.h"

#include "app/widgets/code_edit.h"

#include <QDesktopServices>
#include <QFile>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QSaveFile>
#include <QStringDecoder>
#include <QUrl>
#include <QVBoxLayout>

namespace clothlab {

ShaderEditor::ShaderEditor(QWidget* parent)
    : QWidget(parent), m_name(new QLabel), m_save(new QPushButton(tr("Save"))),
      m_revert(new QPushButton(tr("Revert"))), m_elsewhere(new QPushButton(tr("Open Elsewhere"))),
      m_edit(new CodeEdit) {
    auto* bar = new QHBoxLayout;
    bar->setContentsMargins(8, 4, 8, 4);
    m_name->setTextInteractionFlags(Qt::TextSelectableByMouse);
    bar->addWidget(m_name, 1);
    for (QPushButton* button : {m_save, m_revert, m_elsewhere}) {
        button->setFocusPolicy(Qt::TabFocus);
        bar->addWidget(button);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addLayout(bar);
    layout->addWidget(m_edit, 1);
    m_edit->setAccessibleName(tr("Text of the shader"));
    m_edit->setPlaceholderText(
        tr("No shader is open. Choose one in Appearance and press Edit there, or click the place "
           "of an error in Output."));
    m_elsewhere->setToolTip(
        tr("Open the file in the program that the system has for it; what is saved there is drawn "
           "here at once"));
    connect(m_save, &QPushButton::clicked, this, &ShaderEditor::save);
    connect(m_edit, &CodeEdit::saveAsked, this, &ShaderEditor::save);
    connect(m_revert, &QPushButton::clicked, this, &ShaderEditor::revert);
    connect(m_elsewhere, &QPushButton::clicked, this, &ShaderEditor::openElsewhere);
    setFocusProxy(m_edit);
    connect(m_edit->document(), &QTextDocument::modificationChanged, this, &ShaderEditor::updateState);
    updateState();
}

bool ShaderEditor::open(const QString& path, int line) {
    const QString absolute = QFileInfo(path).absoluteFilePath();
    if (absolute != m_path) {
        if (isModified()) {
            emit problem(
                tr("%1 has changes that are not saved. Save or revert them in the panel Shader first.")
                    .arg(QFileInfo(m_path).fileName()));
            return false;
        }
        m_path = absolute;
        if (!read()) {
            m_path.clear();
            m_edit->clear();
            updateState();
            return false;
        }
    }
    if (line > 0)
        m_edit->goToLine(line);
    return true;
}

bool ShaderEditor::read() {
    QFile file(m_path);
    if (const QFileInfo info(m_path); info.exists() && !info.isFile()) {
        emit problem(tr("%1 is no ordinary file").arg(m_path));
        return false;
    }
    if (!file.open(QIODevice::ReadOnly)) {
        emit problem(tr("%1 cannot be read: %2").arg(m_path, file.errorString()));
        return false;
    }
    m_saved = file.readAll();
    // What is not UTF-8 is taken letter by letter, and written back so.
    QStringDecoder decoder(QStringDecoder::Utf8);
    QString text = decoder.decode(m_saved);
    m_isUtf8 = !decoder.hasError();
    m_edit->setPlainText(m_isUtf8 ? text : QString::fromLatin1(m_saved));
    m_edit->document()->setModified(false);
    updateState();
    markProblems();
    return true;
}

bool ShaderEditor::save() {
    if (!isModified())
        return true;
    QByteArray text = m_isUtf8 ? m_edit->toPlainText().toUtf8() : m_edit->toPlainText().toLatin1();
    if (m_saved.contains("\r\n")) // as the file had them
        text.replace("\n", "\r\n");
    QSaveFile file(m_path);
    if (!file.open(QIODevice::WriteOnly) || file.write(text) != text.size() || !file.commit()) {
        emit problem(tr("%1 could not be written: %2").arg(m_path, file.errorString()));
        return false;
    }
    m_saved = text;
    m_edit->document()->setModified(false);
    emit notice(tr("Saved %1").arg(QFileInfo(m_path).fileName()));
    return true;
}

void ShaderEditor::revert() {
    if (m_path.isEmpty())
        return;
    const int line = m_edit->textCursor().blockNumber() + 1;
    if (read())
        m_edit->goToLine(line);
}

void ShaderEditor::fileMayHaveChanged() {
    if (m_path.isEmpty())
        return;
    QFile file(m_path);
    if (!file.open(QIODevice::ReadOnly) || file.readAll() == m_saved)
        return;
    if (!isModified())
        revert();
    else
        emit notice(tr("%1 was changed on disk, too; Revert shows what is there now.")
                        .arg(QFileInfo(m_path).fileName()));
}

void ShaderEditor::openElsewhere() {
    if (!QDesktopServices::openUrl(QUrl::fromLocalFile(m_path)))
        emit problem(tr("The system has no program to open %1 with.").arg(m_path));
}

bool ShaderEditor::isModified() const {
    return !m_path.isEmpty() && m_edit->document()->isModified();
}

void ShaderEditor::updateState() {
    const bool any = !m_path.isEmpty();
    const bool modified = isModified();
    m_edit->setReadOnly(!any);
    m_name->setText(any ? (modified ? tr("%1 – not saved").arg(QFileInfo(m_path).fileName())
                                    : QFileInfo(m_path).fileName())
                        : tr("No shader"));
    m_name->setToolTip(m_path);
    m_save->setEnabled(modified);
    m_save->setToolTip(modified ? tr("Write the file (Ctrl+S in the text); it is drawn at once")
                       : any    ? tr("There is nothing to save")
                                : tr("No shader is open"));
    m_revert->setEnabled(modified);
    m_revert->setToolTip(modified ? tr("Drop the changes since the file was last saved")
                         : any    ? tr("There is nothing to drop")
                                  : tr("No shader is open"));
    m_elsewhere->setEnabled(any);
}

void ShaderEditor::setProblems(const render::Problems& problems) {
    m_problems = problems;
    markProblems();
}

void ShaderEditor::markProblems() {
    QList<int> lines;
    for (const render::Problem& problem : m_problems)
        if (problem.line > 0 && QFileInfo(problem.path).absoluteFilePath() == m_path)
            lines.append(problem.line);
    m_edit->setMarkedLines(lines);
}

} // namespace clothlab
