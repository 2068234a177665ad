#include "app/document/document.h"

#include "simcore/scene/scene_io.h"
#include "tests/support/scene_text.h"
#include "tests/support/tiny_scene.h"

#include <QDir>
#include <QFile>
#include <QRandomGenerator>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <limits>

using namespace clothlab;

Q_DECLARE_METATYPE(clothlab::SceneChange)

namespace {

Scene with(Scene scene, void (*change)(Scene&)) {
    change(scene);
    return scene;
}

Scene withKs(Scene scene, double ks) {
    scene.cloth.ks = ks;
    return scene;
}

// All that a document can be asked for.
struct DocumentState {
    Scene scene;
    QString path, displayName;
    bool modified;
    int count, index;
    QStringList steps;
    Selection selection;
    friend bool operator==(const DocumentState&, const DocumentState&) = default;
};

DocumentState stateOf(Document& document) {
    const QUndoStack& stack = document.undoStack();
    QStringList steps;
    for (int i = 0; i < stack.count(); ++i)
        steps << stack.text(i);
    return {document.scene(), document.path(), document.displayName(), document.isModified(), stack.count(),
            stack.index(),    steps,           document.selection()};
}

void write(const QString& path, const QByteArray& text) {
    QFile file(path);
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(text), text.size());
}

SceneChange changeIn(const QSignalSpy& spy, int i) {
    return spy.at(i).at(0).value<SceneChange>();
}

} // namespace

class TestDocument : public QObject {
    Q_OBJECT
private slots:
    void aNewDocumentIsAValidUnmodifiedScene() {
        Document document;
        QVERIFY(validate(document.scene()).empty());
        QVERIFY(document.path().isEmpty());
        QCOMPARE(document.displayName(), QString("Untitled"));
        QVERIFY(!document.isModified());
        QVERIFY(document.selection().empty());
        QCOMPARE(document.undoStack().count(), 0);
    }

    void undoAndRedoExchangeTheScene() {
        Document document;
        const Scene before = document.scene();
        const Scene after = withKs(before, 1);
        const auto snapshot = document.snapshot();
        document.edit("edit", after);
        QVERIFY(document.scene() == after);
        QVERIFY(*snapshot == before); // what a thread holds does not change under it
        for (int i = 0; i < 3; ++i) {
            document.undoStack().undo();
            QVERIFY(document.scene() == before);
            QVERIFY(!document.isModified());
            document.undoStack().redo();
            QVERIFY(document.scene() == after);
            QVERIFY(document.isModified());
        }
        QCOMPARE(document.undoStack().text(0), QString("edit"));
    }

    void anEditOfNothingIsNoStep() {
        Document document;
        const QSignalSpy changed(&document, &Document::sceneChanged);
        document.edit("edit", document.scene());
        QCOMPARE(document.undoStack().count(), 0);
        QCOMPARE(changed.count(), 0);
    }

    void gesturesMerge_data() {
        QTest::addColumn<QString>("text");
        QTest::addColumn<int>("gesture");
        QTest::addColumn<int>("steps");
        QTest::newRow("same text and gesture") << "change a" << 7 << 1;
        QTest::newRow("another text") << "change b" << 7 << 2;
        QTest::newRow("another gesture") << "change a" << 8 << 2;
        QTest::newRow("no gesture") << "change a" << 0 << 2;
    }
    void gesturesMerge() {
        QFETCH(QString, text);
        QFETCH(int, gesture);
        QFETCH(int, steps);
        Document document;
        const Scene before = document.scene();
        document.edit("change a", withKs(before, 1), 7);
        document.edit(text, withKs(before, 2), gesture);
        QCOMPARE(document.undoStack().count(), steps);
        document.undoStack().undo();
        QVERIFY(document.scene() == (steps == 1 ? before : withKs(before, 1)));
        document.undoStack().redo();
        QVERIFY(document.scene() == withKs(before, 2));
    }

    void editsWithoutGestureNeverMerge() {
        Document document;
        for (int i = 1; i <= 3; ++i)
            document.edit("edit", withKs(document.scene(), i));
        QCOMPARE(document.undoStack().count(), 3);
    }

    void aGestureBackToItsStartIsNoStep() {
        Document document;
        const Scene before = document.scene();
        document.edit("earlier", withKs(before, 9));
        for (const double ks : {1.0, 2.0, 9.0})
            document.edit("drag", withKs(before, ks), 5);
        QCOMPARE(document.undoStack().count(), 1);
        QCOMPARE(document.undoStack().undoText(), QString("earlier"));
        QCOMPARE(document.scene().cloth.ks, 9.0);
        document.undoStack().undo();
        QVERIFY(document.scene() == before);
        QVERIFY(!document.isModified());
    }

    void aGestureThatReturnsIsUnmodifiedAgain() {
        Document document;
        const QSignalSpy file(&document, &Document::fileChanged);
        const double ks = document.scene().cloth.ks;
        document.edit("drag", withKs(document.scene(), 1), 5);
        QVERIFY(document.isModified());
        document.edit("drag", withKs(document.scene(), ks), 5);
        QVERIFY(!document.isModified());
        QVERIFY(file.count() >= 2); // each told, so that a title bar can follow
    }

    void aGestureAcrossASaveDoesNotSwallowWhatWasSaved() {
        const QTemporaryDir folder;
        Document document;
        document.edit("drag", withKs(document.scene(), 1), 5);
        QVERIFY(!document.save(folder.filePath("a.json")));
        document.edit("drag", withKs(document.scene(), 2), 5);
        QVERIFY(document.isModified());
        document.undoStack().undo();
        QVERIFY(!document.isModified());
        QCOMPARE(document.scene().cloth.ks, 1.0);
    }

    void changesAreToldByTheirKind() {
        Document document;
        const QSignalSpy changed(&document, &Document::sceneChanged);
        document.edit("a", with(document.scene(), [](Scene& s) { s.appearance.shader = "Normal"; }));
        document.edit("b", with(document.scene(), [](Scene& s) { s.cloth.damping = 1; }));
        document.edit("c", with(document.scene(), [](Scene& s) { s.cloth.width = 2; }));
        document.edit("d", with(document.scene(), [](Scene& s) {
                          s.appearance.shader = "Phong";
                          s.cloth.damping = 0;
                      }));
        for (int i = 0; i < 4; ++i)
            document.undoStack().undo();
        const SceneChange expected[] = {SceneChange::Appearance, SceneChange::Motion,    SceneChange::Start,
                                        SceneChange::Motion,     SceneChange::Motion,    SceneChange::Start,
                                        SceneChange::Motion,     SceneChange::Appearance};
        QCOMPARE(changed.count(), 8);
        for (int i = 0; i < 8; ++i)
            QCOMPARE(changeIn(changed, i), expected[i]);
    }

    void slotsSeeTheNewScene() {
        Document document;
        QList<double> seen;
        connect(&document, &Document::sceneChanged, &document,
                [&] { seen << document.scene().cloth.ks << (document.isModified() ? 1 : 0); });
        const double before = document.scene().cloth.ks;
        document.edit("edit", withKs(document.scene(), 3));
        document.undoStack().undo();
        QCOMPARE(seen.value(0), 3.0);
        QCOMPARE(seen.value(2), before);
    }

    void openingReplacesAll() {
        const QTemporaryDir folder;
        const QString path = folder.filePath("tiny.json");
        QVERIFY(!saveScene(test::tinyScene(), path.toStdString()));
        Document document;
        document.edit("edit", withKs(document.scene(), 3));
        Selection selection;
        selection.add({Selection::Kind::Point, 2});
        document.setSelection(selection);
        const QSignalSpy replaced(&document, &Document::sceneReplaced);
        const QSignalSpy changed(&document, &Document::sceneChanged);
        const QSignalSpy deselected(&document, &Document::selectionChanged);
        QVERIFY(document.open(path).empty());
        const DocumentState expected{test::tinyScene(), path, "tiny.json", false, 0, 0, {}, {}};
        QVERIFY(stateOf(document) == expected);
        QCOMPARE(replaced.count(), 1);
        QCOMPARE(changed.count(), 0);
        QCOMPARE(deselected.count(), 1);
        document.newScene();
        QVERIFY(document.path().isEmpty());
        QVERIFY(validate(document.scene()).empty());
        QCOMPARE(replaced.count(), 2);
    }

    void aRelativePathIsKeptWhole() {
        const QTemporaryDir folder;
        const QString before = QDir::currentPath();
        QVERIFY(QDir::setCurrent(folder.path()));
        Document document;
        const auto error = document.save("here.json");
        QVERIFY(QDir::setCurrent(before));
        QVERIFY2(!error, qPrintable(error.value_or("")));
        QVERIFY(QDir::isAbsolutePath(document.path()));
        QVERIFY(!document.save(document.path()));
    }

    void aBadFileLeavesEverything_data() {
        QTest::addColumn<QByteArray>("text");
        QTest::newRow("no JSON") << QByteArray("{\"cloth\": ");
        QTest::newRow("empty") << QByteArray();
        QTest::newRow("no sheet that could run") << QByteArray(R"({"cloth": {"num_width_points": 1}})");
        QTest::newRow("a pin outside") << QByteArray(R"({"cloth": {"pinned": [[50, 0]]}})");
        QTest::newRow("wrong type") << QByteArray(R"({"cloth": {"ks": "stiff"}})");
        QTest::newRow("missing") << QByteArray("-");
        QTest::newRow("folder") << QByteArray("/");
    }
    void aBadFileLeavesEverything() {
        QFETCH(QByteArray, text);
        const QTemporaryDir folder;
        QString path = folder.filePath("bad.json");
        if (text == "/")
            path = folder.path();
        else if (text != "-")
            write(path, text);

        Document document;
        QVERIFY(!document.save(folder.filePath("good.json")));
        document.edit("one", withKs(document.scene(), 1));
        document.edit("two", withKs(document.scene(), 2));
        document.undoStack().undo();
        Selection selection;
        selection.add({Selection::Kind::Spring, 5});
        document.setSelection(selection);
        const DocumentState before = stateOf(document);
        const auto snapshot = document.snapshot();
        QList<QSignalSpy*> spies;
        for (void (Document::*signal)() :
             {&Document::sceneReplaced, &Document::fileChanged, &Document::selectionChanged})
            spies << new QSignalSpy(&document, signal);

        const Diagnostics diagnostics = document.open(path);
        QVERIFY(hasErrors(diagnostics));
        QVERIFY(!diagnostics.front().message.empty());
        QVERIFY(stateOf(document) == before);
        QCOMPARE(document.snapshot(), snapshot);
        for (const QSignalSpy* spy : spies)
            QCOMPARE(spy->count(), 0);
        qDeleteAll(spies);
        document.undoStack().redo();
        QCOMPARE(document.scene().cloth.ks, 2.0);
    }

    void aSaveThatFailsLeavesPathAndMark_data() {
        QTest::addColumn<QString>("name");
        QTest::newRow("no such folder") << "none/a.json";
        QTest::newRow("a folder") << ".";
        QTest::newRow("a file for a folder") << "file/a.json";
        QTest::newRow("no name") << "";
    }
    void aSaveThatFailsLeavesPathAndMark() {
        QFETCH(QString, name);
        const QTemporaryDir folder;
        write(folder.filePath("file"), "x");
        Document document;
        QVERIFY(!document.save(folder.filePath("good.json")));
        document.edit("edit", withKs(document.scene(), 1));
        const DocumentState before = stateOf(document);
        const QSignalSpy file(&document, &Document::fileChanged);
        const QStringList entries = QDir(folder.path()).entryList();
        const auto error = document.save(name.isEmpty() ? name : folder.filePath(name));
        QVERIFY(error.has_value());
        QVERIFY(!error->isEmpty());
        QVERIFY(stateOf(document) == before);
        QVERIFY(document.isModified());
        QCOMPARE(file.count(), 0);
        QCOMPARE(QDir(folder.path()).entryList(), entries); // no half file
    }

    void theMarkFollowsTheSavedStep() {
        const QTemporaryDir folder;
        Document document;
        document.edit("one", withKs(document.scene(), 1));
        document.edit("two", withKs(document.scene(), 2));
        QVERIFY(!document.save(folder.filePath("a.json")));
        QVERIFY(!document.isModified());
        document.undoStack().undo();
        QVERIFY(document.isModified());
        document.undoStack().redo();
        QVERIFY(!document.isModified());
        document.undoStack().undo();
        document.edit("other", withKs(document.scene(), 3));
        QVERIFY(document.isModified());
        document.undoStack().undo();
        QVERIFY(document.isModified()); // what was saved is out of reach
        QVERIFY(!document.save(folder.filePath("b.json")));
        QCOMPARE(document.displayName(), QString("b.json"));
        QVERIFY(!document.isModified());
        QVERIFY(loadScene(document.path().toStdString()).scene == document.scene());
    }
};

QTEST_GUILESS_MAIN(TestDocument)
#include "tst_document.moc"
