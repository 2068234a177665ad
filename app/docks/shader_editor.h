// The text of a shader, to be changed while it is drawn.
#pragma once

#include "app/render/problem.h"

#include <QWidget>

class QLabel;
class QPushButton;

namespace clothlab {

class CodeEdit;

// Saving is what makes a change seen: the folder is watched. Files are written whole or not at all.
class ShaderEditor : public QWidget {
    Q_OBJECT

public:
    explicit ShaderEditor(QWidget* parent = nullptr);

    // What was changed and not saved stays: then the file is opened only once it is saved or dropped, and
    // false is returned. line 0: where the cursor was.
    bool open(const QString& path, int line);
    bool save(); // false if it could not be written, which is told
    void revert();
    void fileMayHaveChanged(); // on disk: shown at once, unless the text was changed here

    void setProblems(const render::Problems& problems); // their lines are marked

    bool isModified() const;
    const QString& path() const { return m_path; }
    CodeEdit& edit() const { return *m_edit; }
    QPushButton* saveButton() const { return m_save; }
    QPushButton* revertButton() const { return m_revert; }

signals:
    void problem(const QString& text);
    void notice(const QString& text);

private:
    bool read();
    void openElsewhere();
    void updateState();
    void markProblems();

    QString m_path;
    QByteArray m_saved;   // as last read or written
    bool m_isUtf8 = true; // else Latin-1
    render::Problems m_problems;
    QLabel* m_name;
    QPushButton* m_save;
    QPushButton* m_revert;
    QPushButton* m_elsewhere;
    CodeEdit* m_edit;
};

} // namespace clothlab
