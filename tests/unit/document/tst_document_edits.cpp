// What edits do to the selection, setParameter, and any sequence of edits against a plain list of scenes.
#include "app/document/document.h"

#include "simcore/scene/scene_io.h"
#include "tests/support/tiny_scene.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <limits>
#include <random>

using namespace clothlab;

namespace {

const Parameter& parameter(const char* id) {
    const Parameter* found = findParameter(id);
    Q_ASSERT(found);
    return *found;
}

Scene withPoints(Scene scene, int width, int height) {
    scene.cloth.numWidthPoints = width;
    scene.cloth.numHeightPoints = height;
    return scene;
}

Selection somePointsAndSprings() {
    Selection selection;
    selection.add({Selection::Kind::Point, 3});
    selection.add({Selection::Kind::Spring, 4});
    return selection;
}

// The scenes there would be if undo kept all of them.
struct ListOfScenes {
    std::vector<Scene> scenes;
    std::vector<QString> texts; // of the edit that led to the scene of that number; none to the first
    std::vector<int> gestures;  // likewise
    std::size_t at = 0;
    std::optional<std::size_t> saved = 0;

    explicit ListOfScenes(const Scene& first) : scenes{first}, texts{""}, gestures{0} {}

    void edit(const QString& text, const Scene& after, int gesture) {
        if (after == scenes[at])
            return;
        if (saved && *saved > at)
            saved.reset();
        scenes.resize(at + 1);
        texts.resize(at + 1);
        gestures.resize(at + 1);
        const bool merges = at > 0 && gesture != 0 && gestures[at] == gesture && texts[at] == text &&
                            saved != at; // what was saved stays within reach
        if (!merges) {
            scenes.push_back(after);
            texts.push_back(text);
            gestures.push_back(gesture);
            ++at;
        } else if (after == scenes[at - 1]) {
            scenes.pop_back();
            texts.pop_back();
            gestures.pop_back();
            --at;
        } else {
            scenes[at] = after;
        }
    }
};

} // namespace

class TestDocumentEdits : public QObject {
    Q_OBJECT
private slots:
    void theSelectionIsPruned() {
        Document document;
        const Grid grid = document.grid();
        const QSignalSpy changed(&document, &Document::selectionChanged);
        Selection selection = somePointsAndSprings();
        const Selection good = selection;
        selection.add({Selection::Kind::Point, grid.pointCount()});
        selection.add({Selection::Kind::Point, -1});
        selection.add({Selection::Kind::Spring, grid.springCount()});
        document.setSelection(selection);
        QVERIFY(document.selection() == good);
        document.setSelection(selection);
        QCOMPARE(changed.count(), 1); // only when it changed
        document.setSelection({});
        QCOMPARE(changed.count(), 2);
    }

    void anotherGridClearsTheSelection() {
        Document document;
        document.edit("sheet", test::tinyScene());
        document.setSelection(somePointsAndSprings());
        QSignalSpy changed(&document, &Document::selectionChanged);
        document.edit("stiffer", [&] {
            Scene scene = document.scene();
            scene.cloth.ks = 7;
            scene.cloth.width = 2; // a start edit, but the same points
            return scene;
        }());
        QVERIFY(document.selection() == somePointsAndSprings());

        document.edit("finer", withPoints(document.scene(), 4, 5));
        QVERIFY(document.selection().empty());
        QCOMPARE(changed.count(), 1);
        document.setSelection(somePointsAndSprings());
        document.undoStack().undo();
        QVERIFY(document.selection().empty());
        document.setSelection(somePointsAndSprings());
        document.undoStack().redo();
        QVERIFY(document.selection().empty());
        QCOMPARE(changed.count(), 5);
    }

    void aGridOfAsManyPointsIsAnotherGrid() {
        Document document;
        Scene scene = test::tinyScene();
        scene.cloth.pinned = {};
        document.edit("sheet", withPoints(scene, 3, 4));
        document.setSelection(somePointsAndSprings());
        document.edit("turned", withPoints(scene, 4, 3));
        QVERIFY(document.selection().empty());
    }

    void whileTheSelectionGoesItIsStillThere() {
        Document document;
        document.setSelection(somePointsAndSprings());
        std::vector<Grid> grids;
        connect(&document, &Document::selectionChanged, &document, [&] { grids.push_back(document.grid()); });
        document.edit("sheet", test::tinyScene());
        document.undoStack().undo();
        const Grid before = document.grid();
        QCOMPARE(grids.size(), 1U);
        QVERIFY(grids[0] == before);
    }

    void aParameterIsAnEdit() {
        Document document;
        QVERIFY(!document.setParameter(parameter("cloth.ks"), 77, 3));
        QVERIFY(!document.setParameter(parameter("cloth.ks"), 78, 3));
        QCOMPARE(document.scene().cloth.ks, 78.0);
        QCOMPARE(document.undoStack().count(), 1);
        QVERIFY(document.undoStack().text(0).contains("Stiffness"));
        QVERIFY(!document.setParameter(parameter("cloth.damping"), 1, 3));
        QCOMPARE(document.undoStack().count(), 2); // another parameter is another gesture
        QVERIFY(!document.setParameter(parameter("cloth.damping"), 1));
        QCOMPARE(document.undoStack().count(), 2); // no change, no step
    }

    void everyParameterTakesTheEndsOfItsRange() {
        for (const Parameter& each : parameters()) {
            if (each.object() == "cloth" && each.kind == Parameter::Kind::Integer)
                continue; // bounded by the number of points and by the pins as well
            for (const double value : {each.minimum, each.maximum, each.defaultValue()}) {
                Document document;
                const auto error = document.setParameter(each, value);
                QVERIFY2(!error, qPrintable(error.value_or("")));
                QCOMPARE(each.get(document.scene()), value);
            }
        }
    }

    void whatTheTypeCannotHoldIsRefused_data() {
        QTest::addColumn<double>("value");
        constexpr double inf = std::numeric_limits<double>::infinity();
        QTest::newRow("NaN") << std::numeric_limits<double>::quiet_NaN();
        QTest::newRow("infinity") << inf;
        QTest::newRow("-infinity") << -inf;
        QTest::newRow("above") << 1e300;
        QTest::newRow("below") << -1e300;
    }
    void whatTheTypeCannotHoldIsRefused() {
        QFETCH(double, value);
        for (const Parameter& each : parameters())
            verifyRefused(each, value);
    }

    void justOutsideIsRefused() {
        for (const Parameter& each : parameters()) {
            verifyRefused(each, std::nextafter(each.minimum, -1e300));
            verifyRefused(each, std::nextafter(each.maximum, 1e300));
            verifyRefused(each, each.minimum - 1);
            verifyRefused(each, each.maximum + 1);
            if (each.kind != Parameter::Kind::Real)
                verifyRefused(each, each.minimum + 0.5);
        }
    }

    void pinsKeepTheirPlaceWhenTheNumberOfPointsChanges() {
        Document document; // hung up at [0, 0] and [49, 0]
        QVERIFY(!document.setParameter(parameter("cloth.num_width_points"), 20));
        QCOMPARE(document.scene().cloth.pinned, (std::vector<GridPoint>{{0, 0}, {19, 0}}));
        QVERIFY(!document.setParameter(parameter("cloth.num_height_points"), 2));
        QCOMPARE(document.scene().cloth.pinned, (std::vector<GridPoint>{{0, 0}, {19, 0}}));
        document.undoStack().undo();
        document.undoStack().undo();
        QCOMPARE(document.scene().cloth.pinned, (std::vector<GridPoint>{{0, 0}, {49, 0}}));
    }

    void aDragThroughACoarseGridLosesNoPins() {
        Document document;
        Scene scene = document.scene();
        scene.cloth.pinned = {{0, 0}, {1, 0}, {2, 0}, {30, 7}, {49, 49}};
        document.edit("pins", scene);
        QVERIFY(!document.setParameter(parameter("cloth.num_width_points"), 2, 7));
        QCOMPARE(document.scene().cloth.pinned, (std::vector<GridPoint>{{0, 0}, {1, 7}, {1, 49}}));
        QVERIFY(!document.setParameter(parameter("cloth.num_width_points"), 99, 7));
        QCOMPARE(document.scene().cloth.pinned,
                 (std::vector<GridPoint>{{0, 0}, {2, 0}, {4, 0}, {60, 7}, {98, 49}}));
        QVERIFY(!document.setParameter(parameter("cloth.num_width_points"), 50, 7));
        QCOMPARE(document.scene(), scene);
    }

    void tooManyPointsAreRefused() {
        Document document;
        QVERIFY(!document.setParameter(parameter("cloth.num_width_points"), 1 << 16));
        const auto error = document.setParameter(parameter("cloth.num_height_points"), 1 << 16);
        QVERIFY(error.has_value());
        QVERIFY2(error->contains("4294967296"), qPrintable(*error)); // the product does not fit into an int
        QCOMPARE(document.scene().cloth.numHeightPoints, 50);
    }

    void anySequenceIsAListOfScenes_data() {
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 1; seed <= 20; ++seed)
            QTest::addRow("seed %u", seed) << seed;
    }
    void anySequenceIsAListOfScenes() {
        QFETCH(unsigned, seed);
        std::mt19937 random(seed);
        const auto below = [&](int n) { return int(random() % unsigned(n)); };
        const QTemporaryDir folder;
        Document document;
        ListOfScenes model(document.scene());
        for (int i = 0; i < 300; ++i) {
            const int dice = below(20);
            if (dice < 5) {
                document.undoStack().undo();
                model.at -= model.at > 0 ? 1 : 0;
            } else if (dice < 9) {
                document.undoStack().redo();
                model.at += model.at + 1 < model.scenes.size() ? 1 : 0;
            } else if (dice == 9) {
                QVERIFY(!document.save(folder.filePath("a.json")));
                model.saved = model.at;
            } else {
                Scene after = document.scene();
                if (below(2) == 0)
                    after.cloth.ks = below(4); // few values, so that gestures come back to their start
                else
                    after.cloth.numHeightPoints = 2 + below(3);
                const QString text = below(4) == 0 ? "b" : "a";
                const int gesture = below(3);
                document.edit(text, after, gesture);
                model.edit(text, after, gesture);
            }
            const QByteArray where = QByteArray("operation ") + QByteArray::number(i);
            QVERIFY2(document.scene() == model.scenes[model.at], where);
            QVERIFY2(document.undoStack().count() == int(model.scenes.size()) - 1, where);
            QVERIFY2(document.undoStack().index() == int(model.at), where);
            QVERIFY2(document.isModified() == (model.saved != model.at), where);
        }
    }

private:
    static void verifyRefused(const Parameter& each, double value) {
        Document document;
        const Scene before = document.scene();
        const auto error = document.setParameter(each, value);
        const QByteArray what = QByteArray(each.id.data(), qsizetype(each.id.size())) + " = " +
                                QByteArray::number(value, 'g', 17);
        QVERIFY2(error.has_value(), what + " was taken");
        QVERIFY2(error->contains(QString::fromUtf8(each.id.data(), qsizetype(each.id.size()))), what);
        QVERIFY2(document.scene() == before && document.undoStack().count() == 0, what);
    }
};

QTEST_GUILESS_MAIN(TestDocumentEdits)
#include "tst_document_edits.moc"
