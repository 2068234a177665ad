// The numbers of what is selected, against what the recording holds.
#include "tests/gui/test_window.h"

#include <QRegularExpression>
#include <QTableWidget>

using namespace clothlab;

class TestInspector : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { m_window.reset(); }

    void withoutASelectionItSaysWhatToDo();
    void aPointShowsEverythingThatIsTrueOfIt();
    void aSpringShowsEverythingThatIsTrueOfIt();
    void whatItShowsMakesNoPanelLarger();
    void numbersFollowTheFrameThatIsShown();
    void numbersFollowEdits();
    void theTableListsTheSpringsOfAPoint();
    void aDoubleClickInTheTableSelectsThatSpring();
    void ofSeveralTheLastIsShownAndTheNumberTold();
    void aHiddenInspectorIsUpToDateWhenShown();
    void theSelectionIsEmptiedByAnotherSheet();

private:
    InspectorPanel& inspector() { return (*m_window)->inspectorPanel(); }
    QString line(const QString& name);
    // Numbers in a line, however it is set.
    QList<double> numbers(const QString& name);
    const Frame& frame() { return *m_window->simulation().shownFrame(); }
    void select(Selection::Kind kind, int number) { m_window->document().setSelection({{{kind, number}}}); }
    int springBetween(int a, int b);

    std::unique_ptr<TestWindow> m_window;
};

namespace {

// Shown with six significant digits.
bool isNear(double shown, double value) {
    return std::abs(shown - value) <= 1e-5 * std::abs(value) + 1e-12;
}

} // namespace

void TestInspector::init() {
    m_window = std::make_unique<TestWindow>();
    QVERIFY(m_window->load(smallScene()));
    QVERIFY(m_window->simulateTo(20));
}

QString TestInspector::line(const QString& name) {
    for (const auto& [label, value] : inspector().lines())
        if (label == name)
            return value;
    return {};
}

QList<double> TestInspector::numbers(const QString& name) {
    static const QRegularExpression pattern(R"(-?\d+(\.\d+)?(e[-+]?\d+)?)");
    QList<double> found;
    for (auto match = pattern.globalMatch(line(name)); match.hasNext();)
        found << match.next().captured().toDouble();
    return found;
}

int TestInspector::springBetween(int a, int b) {
    const Grid grid = m_window->document().grid();
    for (int number = 0; number < grid.springCount(); ++number)
        if (const Spring s = grid.spring(number); (s.a == a && s.b == b) || (s.a == b && s.b == a))
            return number;
    return -1;
}

void TestInspector::withoutASelectionItSaysWhatToDo() {
    QVERIFY(inspector().lines().empty());
    bool said = false;
    for (const QLabel* label : inspector().findChildren<QLabel*>())
        said |= label->isVisible() && label->text().contains("Click a point mass or a spring");
    QVERIFY(said);
}

void TestInspector::aPointShowsEverythingThatIsTrueOfIt() {
    constexpr int point = 4 * 6 + 2;
    select(Selection::Kind::Point, point);
    QCOMPARE(line("Index"), QStringLiteral("26"));
    QCOMPARE(line("Grid place"), QStringLiteral("(2, 4)"));
    const ClothState& state = frame().state;
    const Vec3 p = state.position.at(point);
    const QList<double> position = numbers("Position");
    QVERIFY(position.size() >= 3);
    // What moved in the last step, by that step's time.
    const Vec3 v = (p - state.lastPosition.at(point)) / frame().scene->simulation.timeStep();
    const QList<double> velocity = numbers("Velocity");
    QVERIFY(velocity.size() >= 3);
    for (int i = 0; i < 3; ++i) {
        QVERIFY2(isNear(position[i], p[i]), qPrintable(line("Position")));
        QVERIFY2(isNear(velocity[i], v[i]), qPrintable(line("Velocity")));
    }
    QVERIFY(line("Position").endsWith(" m"));
    QVERIFY(line("Velocity").endsWith(" m/s"));
    QVERIFY(v.y() < 0); // it falls
    QCOMPARE(line("Pinned"), QStringLiteral("no"));
    QCOMPARE(line("Springs"), QStringLiteral("11")); // 4 structural, 4 shearing, 3 bending
}

void TestInspector::aSpringShowsEverythingThatIsTrueOfIt() {
    const int a = 3 * 6 + 2;
    const int b = 2 * 6 + 3;
    const int number = springBetween(a, b);
    QVERIFY(number >= 0);
    select(Selection::Kind::Spring, number);
    QCOMPARE(line("Type"), QStringLiteral("Shearing"));
    const QString ends = line("From") + line("To");
    QVERIFY2(ends.contains("(2, 3)") && ends.contains("(3, 2)"), qPrintable(ends));
    const double length = (frame().state.position.at(a) - frame().state.position.at(b)).norm();
    const PointArray& start = m_window->simulation().recording().frame(0).exact->state.position;
    const double rest = (start.at(a) - start.at(b)).norm();
    QVERIFY2(isNear(numbers("Length").value(0), length), qPrintable(line("Length")));
    QVERIFY2(isNear(numbers("Rest length").value(0), rest), qPrintable(line("Rest length")));
    QVERIFY2(std::abs(numbers("Strain").value(0) - 100 * (length - rest) / rest) < 0.00051,
             qPrintable(line("Strain")));
    QVERIFY2(isNear(numbers("Force").value(0), 5000 * (length - rest)), qPrintable(line("Force")));
    QVERIFY(line("Force").contains(length > rest ? "pulling" : "pushing"));
}

void TestInspector::numbersFollowTheFrameThatIsShown() {
    select(Selection::Kind::Point, 30);
    const QString late = line("Position");
    m_window->key(Qt::Key_Home, Qt::ControlModifier);
    const QString early = line("Position");
    QVERIFY(early != late);
    QCOMPARE(numbers("Speed").value(0), 0.0);
    m_window->key(Qt::Key_End, Qt::ControlModifier);
    QCOMPARE(line("Position"), late);
}

void TestInspector::numbersFollowEdits() {
    select(Selection::Kind::Spring, 0);
    const QList<double> before = numbers("Stiffness");
    QCOMPARE(before.value(0), 5000.0);
    m_window->typeInto(m_window->field("cloth.ks"), "400");
    m_window->key(Qt::Key_Return);
    QCOMPARE(numbers("Stiffness").value(0), 400.0);
    select(Selection::Kind::Point, 0);
    QCOMPARE(line("Pinned"), QStringLiteral("yes"));
}

void TestInspector::whatItShowsMakesNoPanelLarger() {
    const QSize before = inspector().minimumSizeHint();
    select(Selection::Kind::Point, 14);
    const QSize point = inspector().minimumSizeHint();
    select(Selection::Kind::Spring, 3);
    const QSize spring = inspector().minimumSizeHint();
    QVERIFY(point.height() <= before.height() && spring.height() <= before.height());
    QVERIFY(point.width() <= before.width() && spring.width() <= before.width());
}

void TestInspector::theTableListsTheSpringsOfAPoint() {
    const Grid grid = m_window->document().grid();
    for (int point = 0; point < grid.pointCount(); ++point) {
        select(Selection::Kind::Point, point);
        int ends = 0;
        for (int number = 0; number < grid.springCount(); ++number)
            ends += grid.spring(number).a == point || grid.spring(number).b == point;
        QCOMPARE(inspector().springTable()->rowCount(), ends);
        QCOMPARE(line("Springs"), QString::number(ends));
    }
}

void TestInspector::aDoubleClickInTheTableSelectsThatSpring() {
    select(Selection::Kind::Point, 14);
    QTableWidget* table = inspector().springTable();
    const QString type = table->item(2, 0)->text();
    const QString other = table->item(2, 1)->text();
    const QPoint at = table->visualItemRect(table->item(2, 0)).center();
    m_window->click(table->viewport(), at);
    m_window->doubleClick(table->viewport(), at);
    const auto active = m_window->document().selection().active();
    QVERIFY(active && active->kind == Selection::Kind::Spring);
    QCOMPARE(line("Type"), type);
    QVERIFY(line("From").endsWith(other) || line("To").endsWith(other));
}

void TestInspector::ofSeveralTheLastIsShownAndTheNumberTold() {
    m_window->document().setSelection(
        {{{Selection::Kind::Point, 3}, {Selection::Kind::Spring, 7}, {Selection::Kind::Point, 9}}});
    QCOMPARE(line("Index"), QStringLiteral("9"));
    QStringList texts;
    for (const QLabel* label : inspector().findChildren<QLabel*>())
        texts << label->text();
    QVERIFY(texts.contains("Point mass 9 · last of 3 selected"));
}

void TestInspector::aHiddenInspectorIsUpToDateWhenShown() {
    QAction* toggle = (*m_window)->dock("inspector")->toggleViewAction();
    select(Selection::Kind::Point, 30);
    const QString late = line("Position");
    toggle->trigger();
    m_window->key(Qt::Key_Home, Qt::ControlModifier);
    toggle->trigger();
    QVERIFY(line("Position") != late);
    QCOMPARE(numbers("Speed").value(0), 0.0);
}

void TestInspector::theSelectionIsEmptiedByAnotherSheet() {
    select(Selection::Kind::Point, 30);
    m_window->typeInto(m_window->field("cloth.num_height_points"), "9");
    m_window->key(Qt::Key_Return);
    QVERIFY(m_window->document().selection().empty());
    QVERIFY(inspector().lines().empty());
}

CLOTHLAB_GUI_TEST_MAIN(TestInspector)
#include "tst_inspector.moc"
