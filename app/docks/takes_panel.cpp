#include "app/docks/takes_panel.h"

#include "app/docks/text.h"
#include "app/widgets/icons.h"
#include "simcore/scene/scene_differences.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QToolButton>
#include <QVBoxLayout>

#include <functional>
#include <utility>

namespace clothlab {
namespace {

enum Column { Name, Frames, Differs };

// As panels name it, in their units.
QString textOf(const SceneDifference& difference) {
    const Parameter* parameter = difference.parameter;
    if (parameter == nullptr)
        return toQString(difference.part);
    const auto number = [&](double value) {
        if (parameter->kind == Parameter::Kind::Boolean)
            return value != 0 ? TakesPanel::tr("on") : TakesPanel::tr("off");
        return significant(value / parameter->panelDivisor);
    };
    const QString text =
        QStringLiteral("%1 %2 → %3")
            .arg(toQString(parameter->label), number(difference.before), number(difference.after));
    return parameter->unit.empty() ? text : text + ' ' + toQString(parameter->unit);
}

QStringList differences(const Scene& before, const Scene& after) {
    QStringList texts;
    for (const SceneDifference& difference : motionDifferences(before, after))
        texts << textOf(difference);
    return texts;
}

} // namespace

TakesPanel::TakesPanel(Simulation& simulation, QWidget* parent)
    : QWidget(parent), m_simulation(simulation), m_tree(new QTreeWidget) {
    m_tree->setObjectName("takes");
    m_tree->setAccessibleName(tr("Takes"));
    m_tree->setHeaderLabels({tr("Take"), tr("Frames"), tr("What differs")});
    m_tree->header()->setStretchLastSection(true);
    m_tree->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_tree->setUniformRowHeights(true);
    m_tree->setAllColumnsShowFocus(true);

    auto* row = new QHBoxLayout;
    row->setSpacing(2);
    m_openAction =
        addAction("openTake", tr("Open"), "open", tr("Show this take, with the scene it was made with"));
    m_renameAction = addAction("renameTake", tr("Rename"), "select", tr("Give this take another name (F2)"));
    m_deleteAction =
        addAction("deleteTake", tr("Delete"), "close", tr("Delete this take; undo brings it back (Del)"));
    for (QAction* action : {m_openAction, m_renameAction, m_deleteAction}) {
        auto* button = new QToolButton;
        button->setDefaultAction(action);
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::NoFocus);
        row->addWidget(button);
    }
    row->addStretch();

    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(8, 4, 8, 4);
    layout->setSpacing(4);
    layout->addLayout(row);
    layout->addWidget(m_tree, 1);

    m_renameAction->setShortcut(Qt::Key_F2);
    m_deleteAction->setShortcut(QKeySequence::Delete);
    for (QAction* action : {m_renameAction, m_deleteAction}) {
        action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
        QWidget::addAction(action);
    }
    connect(m_openAction, &QAction::triggered, this, [this] { m_simulation.openTake(selected()); });
    connect(m_renameAction, &QAction::triggered, this,
            [this] { m_tree->editItem(m_tree->currentItem(), Name); });
    connect(m_deleteAction, &QAction::triggered, this, [this] { m_simulation.deleteTake(selected()); });
    connect(m_tree, &QTreeWidget::itemActivated, m_openAction, &QAction::trigger);
    connect(m_tree, &QTreeWidget::itemChanged, this, &TakesPanel::rename);
    connect(m_tree, &QTreeWidget::currentItemChanged, this, &TakesPanel::updateActions);
    connect(&simulation, &Simulation::takesChanged, this, &TakesPanel::showTakes);
    connect(&simulation, &Simulation::recordingChanged, this, &TakesPanel::showOpenTake);
    showTakes();
}

QAction* TakesPanel::addAction(const char* name, const QString& text, const QString& icon,
                               const QString& tip) {
    auto* action = new QAction(themedIcon(icon), text, this);
    action->setObjectName(name);
    action->setToolTip(tip);
    action->setProperty("tip", tip);
    return action;
}

TakeId TakesPanel::selected() const {
    return m_tree->currentItem() ? m_tree->currentItem()->data(Name, Qt::UserRole).toUInt() : 0;
}

QTreeWidgetItem* TakesPanel::item(TakeId id) const {
    for (QTreeWidgetItemIterator it(m_tree); *it; ++it)
        if ((*it)->data(Name, Qt::UserRole).toUInt() == id)
            return *it;
    return nullptr;
}

void TakesPanel::showTakes() {
    const bool was = std::exchange(m_showing, true);
    // What was chosen stays so; with the open take, the one that is opened then.
    const TakeId open = m_simulation.recording().take()->id();
    const TakeId current = selected() == m_open ? open : selected();
    m_open = open;
    m_tree->clear();
    m_changes.clear();
    const Recording& recording = m_simulation.recording();
    for (const TakePointer& take : recording.takes()) {
        auto* added = new QTreeWidgetItem;
        added->setData(Name, Qt::UserRole, take->id());
        added->setFlags(added->flags() | Qt::ItemIsEditable);
        added->setTextAlignment(Frames, Qt::AlignRight | Qt::AlignVCenter);
        // Takes are listed in the order they began, so a parent is there already.
        const TakePointer parent = recording.listedParent(*take);
        if (QTreeWidgetItem* over = parent ? item(parent->id()) : nullptr)
            over->addChild(added);
        else
            m_tree->addTopLevelItem(added);
        showTake(*added, *take);
    }
    m_tree->expandAll();
    QTreeWidgetItem* chosen = item(current);
    m_tree->setCurrentItem(chosen ? chosen : item(open));
    for (const Column column : {Name, Frames})
        m_tree->resizeColumnToContents(column);
    m_showing = was;
    updateActions();
}

void TakesPanel::showEvent(QShowEvent* event) {
    QWidget::showEvent(event);
    showOpenTake();
}

// A tab behind others need not be kept up to date: it is when it is shown.
void TakesPanel::showOpenTake() {
    if (!isVisible())
        return;
    const bool was = std::exchange(m_showing, true);
    const Take& take = *m_simulation.recording().take();
    if (QTreeWidgetItem* open = item(take.id()))
        showTake(*open, take);
    m_showing = was;
}

void TakesPanel::showTake(QTreeWidgetItem& item, const Take& take) {
    const bool open = &take == m_simulation.recording().take().get();
    QFont font = m_tree->font();
    font.setBold(open);
    for (const Column column : {Name, Frames, Differs})
        item.setFont(column, font);
    item.setText(Name, QString::fromStdString(take.name()));
    item.setIcon(Name, themedIcon(open ? "play" : "minus"));
    item.setText(Frames, QString::number(take.frameCount()));
    const QStringList& changes = changesOf(take);
    QStringList texts{differenceOf(take)};
    if (!changes.isEmpty())
        texts << (changes.size() == 1 ? tr("1 change while it ran")
                                      : tr("%1 changes while it ran").arg(changes.size()));
    item.setText(Differs, texts.join(QStringLiteral("; ")));
    constexpr int most = 12;
    QStringList tip = changes.mid(0, most);
    if (changes.size() > most)
        tip << tr("… and %1 more").arg(changes.size() - most);
    tip.prepend(differenceOf(take));
    item.setToolTip(Differs, tip.join('\n'));
}

// Looks only through frames that have come since.
const QStringList& TakesPanel::changesOf(const Take& take) {
    Changes& changes = m_changes[take.id()];
    for (int i = std::max(changes.frames, take.branchFrame() + 2); i < take.frameCount(); ++i) {
        const auto& before = take.frame(i - 1).scene;
        const auto& after = take.frame(i).scene;
        if (i == 1 || before == after)
            continue; // the first frame is computed with whatever the take begins with
        if (const QStringList texts = differences(*before, *after); !texts.isEmpty())
            changes.texts << tr("frame %1: %2").arg(i).arg(texts.join(", "));
    }
    changes.frames = take.frameCount();
    return changes.texts;
}

QString TakesPanel::differenceOf(const Take& take) const {
    const int first = take.branchFrame() + 1;
    if (const TakePointer& parent = take.parent()) {
        QString from = tr("from frame %1").arg(take.branchFrame());
        if (first >= take.frameCount())
            return from;
        const Scene& other =
            first < parent->frameCount() ? *std::as_const(*parent).frame(first).scene : *lastScene(*parent);
        const QStringList texts = differences(other, *take.frame(first).scene);
        return texts.isEmpty() ? from : QStringLiteral("%1: %2").arg(from, texts.join(", "));
    }
    const TakePointer& oldest = m_simulation.recording().takes().front();
    if (oldest.get() == &take)
        return tr("from the start");
    const QStringList texts = differences(*lastScene(*oldest), *lastScene(take));
    return texts.isEmpty() ? tr("from the start") : tr("from the start: %1").arg(texts.join(", "));
}

void TakesPanel::updateActions() {
    const TakeId id = selected();
    const bool open = id == m_simulation.recording().take()->id();
    const bool only = m_simulation.recording().takes().size() < 2;
    const auto allow = [](QAction* action, bool allowed, const QString& whyNot) {
        action->setEnabled(allowed);
        action->setToolTip(allowed ? action->property("tip").toString() : whyNot);
    };
    allow(m_openAction, id != 0 && !open, id == 0 ? tr("Choose a take first") : tr("This take is open"));
    allow(m_renameAction, id != 0, tr("Choose a take first"));
    allow(m_deleteAction, id != 0 && !only,
          id == 0 ? tr("Choose a take first") : tr("This is the only take"));
}

void TakesPanel::rename(QTreeWidgetItem* item) {
    if (m_showing)
        return;
    const TakeId id = item->data(Name, Qt::UserRole).toUInt();
    m_simulation.renameTake(id, item->text(Name));
    // What is in the tree is what the take is called, even if that was refused. Not while the editor closes.
    QMetaObject::invokeMethod(this, &TakesPanel::showTakes, Qt::QueuedConnection);
}

} // namespace clothlab
