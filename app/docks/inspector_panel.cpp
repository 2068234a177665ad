#include "app/docks/inspector_panel.h"

#include "app/docks/text.h"
#include "simcore/inspect/inspect.h"

#include <QFormLayout>
#include <QHeaderView>
#include <QScrollArea>
#include <QVBoxLayout>

#include <algorithm>

namespace clothlab {
namespace {

QString percent(double ratio) {
    return QStringLiteral("%1 %").arg(QString::number(100 * ratio, 'f', 3));
}

QString withUnit(double value, const char* unit) {
    return significant(value) + QChar(0x202F) + QString::fromUtf8(unit);
}

QString pointName(const Grid& grid, int point) {
    const GridPoint place = grid.place(point);
    return QStringLiteral("%1 (%2, %3)").arg(point).arg(place.x).arg(place.y);
}

} // namespace

InspectorPanel::InspectorPanel(Document& document, Simulation& simulation, QWidget* parent)
    : QWidget(parent), m_document(document), m_simulation(simulation), m_pages(new QStackedWidget),
      m_title(new QLabel), m_form(new QFormLayout), m_table(new QTableWidget) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_pages);

    auto* empty = new QLabel(tr("Nothing is selected.\nClick a point mass or a spring in the view."));
    empty->setAlignment(Qt::AlignCenter);
    empty->setWordWrap(true);
    empty->setForegroundRole(QPalette::PlaceholderText);
    m_pages->addWidget(empty);

    // Scrolls where there is no room: what is shown must not make the window larger.
    auto* area = new QScrollArea;
    area->setFrameShape(QFrame::NoFrame);
    area->setWidgetResizable(true);
    auto* page = new QWidget;
    area->setWidget(page);
    auto* pageLayout = new QVBoxLayout(page);
    pageLayout->setContentsMargins(10, 8, 10, 8);
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setWordWrap(true);
    pageLayout->addWidget(m_title);
    m_form->setLabelAlignment(Qt::AlignRight);
    m_form->setHorizontalSpacing(10);
    m_form->setVerticalSpacing(3);
    pageLayout->addLayout(m_form);
    m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setMinimumSectionSize(fontMetrics().height());
    m_table->verticalHeader()->setDefaultSectionSize(fontMetrics().height() + 4);
    m_table->setAlternatingRowColors(true);
    m_table->setShowGrid(false);
    m_table->setToolTip(tr("Double-click a row to select it."));
    connect(m_table, &QTableWidget::cellDoubleClicked, this, &InspectorPanel::selectRow);
    m_table->setMinimumHeight(4 * (fontMetrics().height() + 4)); // header and three rows
    pageLayout->addWidget(m_table, 1000);
    pageLayout->addStretch(1); // where there is no table
    m_pages->addWidget(area);

    connect(&document, &Document::selectionChanged, this, &InspectorPanel::refresh);
    connect(&document, &Document::sceneChanged, this, &InspectorPanel::refresh);
    connect(&simulation, &Simulation::frameShown, this, &InspectorPanel::refresh);
    connect(&simulation, &Simulation::recordingChanged, this, &InspectorPanel::refresh);
    refresh();
}

std::vector<std::pair<QString, QString>> InspectorPanel::lines() const {
    Lines lines;
    if (m_pages->currentIndex() == 1)
        for (const auto& [name, value] : m_rows)
            lines.emplace_back(name->text(), value->text());
    return lines;
}

void InspectorPanel::showEvent(QShowEvent* event) {
    refresh();
    QWidget::showEvent(event);
}

void InspectorPanel::refresh() {
    const auto active = m_document.selection().active();
    m_pages->setCurrentIndex(active ? 1 : 0);
    // A tab behind others need not be kept up to date: it is when it is shown.
    if (!active || !isVisible())
        return;
    if (active->kind == Selection::Kind::Point)
        showPoint(active->number);
    else
        showSpring(active->number);
    const auto count = m_document.selection().items.size();
    if (count > 1)
        m_title->setText(tr("%1 · last of %2 selected").arg(m_title->text()).arg(count));
}

// A number of the state, or a mark that it is still being computed again.
QString InspectorPanel::exactly(const QString& number) const {
    return m_simulation.shownFrame()->exact ? number : QString(QChar(0x2026));
}

void InspectorPanel::showPoint(int point) {
    const Scene& scene = m_simulation.shownScene();
    const Grid grid = m_document.grid();
    const Frame& frame = *m_simulation.shownFrame();
    const GridPoint place = grid.place(point);
    const Vec3 v = velocity(frame.state, point, frame.scene->simulation.timeStep());
    const std::vector<int> springs = grid.springsOf(point);
    const bool pinned = std::ranges::find(scene.cloth.pinned, place) != scene.cloth.pinned.end();

    m_title->setText(tr("Point mass %1").arg(point));
    showLines({{tr("Index"), QString::number(point)},
               {tr("Grid place"), QStringLiteral("(%1, %2)").arg(place.x).arg(place.y)},
               {tr("Position"), exactly(vectorText(frame.state.position.at(point)) + " m")},
               {tr("Velocity"), exactly(vectorText(v) + " m/s")},
               {tr("Speed"), exactly(withUnit(v.norm(), "m/s"))},
               {tr("Mass"), withUnit(pointMass(scene.cloth), "kg")},
               {tr("Pinned"), pinned ? tr("yes") : tr("no")},
               {tr("Springs"), QString::number(springs.size())}});
    fillTable(springs, point);
}

void InspectorPanel::showSpring(int number) {
    const Frame& frame = *m_simulation.shownFrame();
    const Grid grid = m_document.grid();
    const Spring spring = grid.spring(number);
    const Cloth& cloth = m_simulation.shownScene().cloth;
    const SpringMeasure m = measureSpring(cloth, m_simulation.sheet(), frame.state.position, spring);

    m_title->setText(tr("%1 spring %2").arg(typeName(spring.type())).arg(number));
    showLines(
        {{tr("Type"), typeName(spring.type()) + (cloth.enabled(spring.type()) ? QString() : tr(" (off)"))},
         {tr("From"), pointName(grid, spring.a)},
         {tr("To"), pointName(grid, spring.b)},
         {tr("Length"), exactly(withUnit(m.length, "m"))},
         {tr("Rest length"), withUnit(m.restLength, "m")},
         {tr("Strain"), exactly(percent(m.strain))},
         {tr("Force"), exactly(withUnit(m.force, "N") + (m.force > 0   ? tr(" pulling")
                                                         : m.force < 0 ? tr(" pushing")
                                                                       : QString()))},
         {tr("Stiffness"), withUnit(stiffness(cloth, spring.type()), "N/m")}});
    fillTable({}, 0);
}

void InspectorPanel::showLines(const Lines& lines) {
    while (m_rows.size() < lines.size()) {
        auto* name = new QLabel;
        auto* value = new QLabel;
        name->setForegroundRole(QPalette::PlaceholderText);
        value->setTextInteractionFlags(Qt::TextSelectableByMouse);
        value->setWordWrap(true); // so that no long number makes the panel wider
        m_form->addRow(name, value);
        m_rows.emplace_back(name, value);
    }
    for (std::size_t i = 0; i < m_rows.size(); ++i) {
        const bool used = i < lines.size();
        m_rows[i].first->setVisible(used);
        m_rows[i].second->setVisible(used);
        m_rows[i].first->setText(used ? lines[i].first : QString());
        m_rows[i].second->setText(used ? lines[i].second : QString());
    }
}

void InspectorPanel::fillTable(const std::vector<int>& springs, int point) {
    const Grid grid = m_document.grid();
    const PointArray& position = m_simulation.shownFrame()->state.position;
    m_table->setVisible(!springs.empty());
    m_tableSprings = springs;
    if (m_table->columnCount() == 0) {
        m_table->setColumnCount(5);
        m_table->setHorizontalHeaderLabels(
            {tr("Type"), tr("Other end"), tr("Length m"), tr("Strain"), tr("Force N")});
        m_table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
        m_table->horizontalHeader()->setHighlightSections(false);
    }
    m_table->setRowCount(int(springs.size()));
    for (int row = 0; row < int(springs.size()); ++row) {
        const Spring spring = grid.spring(springs[std::size_t(row)]);
        const SpringMeasure m =
            measureSpring(m_simulation.shownScene().cloth, m_simulation.sheet(), position, spring);
        const int other = spring.a == point ? spring.b : spring.a;
        const GridPoint place = grid.place(other);
        const std::array<QString, 5> texts{
            typeName(spring.type()), QStringLiteral("(%1, %2)").arg(place.x).arg(place.y),
            exactly(significant(m.length)), exactly(percent(m.strain)), exactly(significant(m.force))};
        for (int column = 0; column < int(texts.size()); ++column) {
            if (!m_table->item(row, column))
                m_table->setItem(row, column, new QTableWidgetItem);
            m_table->item(row, column)->setText(texts[std::size_t(column)]);
        }
        m_table->item(row, 0)->setForeground(typeColor(spring.type()));
    }
}

void InspectorPanel::selectRow(int row) {
    if (row >= 0 && row < int(m_tableSprings.size()))
        m_document.setSelection(Selection{{{Selection::Kind::Spring, m_tableSprings[std::size_t(row)]}}});
}

} // namespace clothlab
