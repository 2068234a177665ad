// A titled part of a panel that folds.
#pragma once

#include <QWidget>

class QToolButton;
class QVBoxLayout;

namespace clothlab {

// Folds by a click on the title, or by Enter on it (Space stays with the window's shortcuts). Open at first;
// whether it was folded last time is remembered by its owner.
class FoldableGroup : public QWidget {
    Q_OBJECT

public:
    explicit FoldableGroup(const QString& title, QWidget* parent = nullptr);

    QString title() const;
    void setTitle(const QString& title);

    bool isFolded() const { return m_folded; }
    void setFolded(bool folded);

    // What folds goes in here.
    QVBoxLayout* contentLayout() const { return m_contentLayout; }

signals:
    // However it came to be.
    void foldedChanged(bool folded);

private:
    QToolButton* m_header;
    QWidget* m_content;
    QVBoxLayout* m_contentLayout;
    bool m_folded = false;
};

} // namespace clothlab
