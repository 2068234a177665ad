#include "app/document/selection.h"

#include <QTest>

using namespace clothlab;

namespace {

using Kind = Selection::Kind;
using Item = Selection::Item;

Selection selectionOf(std::vector<Item> items) {
    Selection selection;
    selection.items = std::move(items);
    return selection;
}

} // namespace

class TestSelection : public QObject {
    Q_OBJECT
private slots:
    void anEmptyOneHasNoActiveItem() {
        const Selection selection;
        QVERIFY(selection.empty());
        QVERIFY(!selection.active());
        QVERIFY(!selection.contains({Kind::Point, 0}));
    }

    void theLastAddedIsActive() {
        Selection selection;
        selection.add({Kind::Point, 3});
        selection.add({Kind::Spring, 3});
        QVERIFY(selection.active() == Item({Kind::Spring, 3}));
        QVERIFY(selection.contains({Kind::Point, 3}));
        QVERIFY(selection.contains({Kind::Spring, 3}));
        QVERIFY(!selection.contains({Kind::Point, 4}));
    }

    void addingAgainMakesActiveAndDoesNotDouble() {
        Selection selection = selectionOf({{Kind::Point, 1}, {Kind::Point, 2}, {Kind::Spring, 1}});
        selection.add({Kind::Point, 1});
        QVERIFY(selection == selectionOf({{Kind::Point, 2}, {Kind::Spring, 1}, {Kind::Point, 1}}));
    }

    void removingTheActiveOneMakesTheOneBeforeActive() {
        Selection selection = selectionOf({{Kind::Point, 1}, {Kind::Point, 2}});
        selection.remove({Kind::Point, 2});
        QVERIFY(selection.active() == Item({Kind::Point, 1}));
        selection.remove({Kind::Spring, 1}); // the spring of that number is not selected
        QVERIFY(selection == selectionOf({{Kind::Point, 1}}));
        selection.remove({Kind::Point, 1});
        QVERIFY(selection.empty());
    }

    void pruningKeepsWhatTheGridHas_data() {
        QTest::addColumn<int>("width");
        QTest::addColumn<int>("height");
        for (const QSize size : {QSize(1, 1), QSize(2, 2), QSize(4, 4), QSize(3, 7)})
            QTest::addRow("%d by %d", size.width(), size.height()) << size.width() << size.height();
    }
    void pruningKeepsWhatTheGridHas() {
        QFETCH(int, width);
        QFETCH(int, height);
        const Grid grid{width, height};
        Selection selection;
        std::vector<Item> kept;
        for (const int number : {-1, 0, grid.pointCount() - 1, grid.pointCount(), grid.springCount() - 1,
                                 grid.springCount(), 1 << 30}) {
            for (const Item item : {Item{Kind::Point, number}, Item{Kind::Spring, number}}) {
                const int count = item.kind == Kind::Point ? grid.pointCount() : grid.springCount();
                if (selection.contains(item))
                    continue;
                selection.add(item);
                if (number >= 0 && number < count)
                    kept.push_back(item);
            }
        }
        selection.prune(grid);
        QVERIFY(selection == selectionOf(kept)); // and in the same order
    }
};

QTEST_APPLESS_MAIN(TestSelection)
#include "tst_selection.moc"
