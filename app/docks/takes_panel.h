// The takes of the recording as a tree: what branched off what, how long each is, and what differs.
#pragma once

#include "app/simulation/simulation.h"

#include <QAction>
#include <QTreeWidget>
#include <QWidget>

#include <map>

namespace clothlab {

class TakesPanel : public QWidget {
    Q_OBJECT

public:
    explicit TakesPanel(Simulation& simulation, QWidget* parent = nullptr);

    QTreeWidget& tree() { return *m_tree; }
    QTreeWidgetItem* item(TakeId id) const; // null if there is none

protected:
    void showEvent(QShowEvent* event) override;

private:
    // Changes of the scene among a take's own frames, as far as they have been looked through.
    struct Changes {
        int frames = 0;
        QStringList texts;
    };

    QAction* addAction(const char* name, const QString& text, const QString& icon, const QString& tip);
    TakeId selected() const; // 0: none
    void showTakes();
    void showOpenTake();
    void showTake(QTreeWidgetItem& item, const Take& take);
    const QStringList& changesOf(const Take& take);
    QString differenceOf(const Take& take) const;
    void updateActions();
    void rename(QTreeWidgetItem* item);

    Simulation& m_simulation;
    QTreeWidget* m_tree;
    QAction* m_openAction;
    QAction* m_renameAction;
    QAction* m_deleteAction;
    TakeId m_open = 0; // as last shown
    std::map<TakeId, Changes> m_changes;
    bool m_showing = false; // what changes in the tree was not typed
};

} // namespace clothlab
