// New, open, recent, save, drop, and the question before anything is lost.
#include "tests/gui/dialog_answer.h"
#include "tests/gui/test_window.h"

#include <QDragEnterEvent>
#include <QDropEvent>
#include <QMenu>
#include <QMimeData>

using namespace clothlab;

class TestFiles : public QObject {
    Q_OBJECT

private slots:
    void init() { m_window = std::make_unique<TestWindow>(); }
    void cleanup() { m_window.reset(); }

    void aNewWindowHoldsAnUntitledSheetThatHangsFromTwoCorners();
    void everySceneOfTheCourseOpens_data();
    void everySceneOfTheCourseOpens();
    void newBeginsAnUntitledScene();
    void theTitleMarksUnsavedChanges();
    void cancelInTheFileChooserChangesNothing();
    void saveAsksForANameOnceOnly();
    void saveAsAddsTheSuffix();
    void whatIsSavedIsWhatIsOpenedAgain();
    void savingToAPlaceThatCannotBeWrittenIsToldAndLosesNothing();
    void recentFilesAreListedNewestFirstAndOpen();
    void recentFilesThatAreGoneCannotBeChosen();
    void recentFilesAreKeptBetweenRuns();
    void aQuestionComesBeforeChangesAreLost_data();
    void aQuestionComesBeforeChangesAreLost();
    void saveInTheQuestionSavesAndGoesOn();
    void nothingIsAskedWithoutChanges();
    void closingAsksAndCancelKeepsTheWindow();
    void aDroppedFileIsOpened();
    void aFileDroppedOnAPanelIsOpened();
    void aDropOfWhatIsNoFileIsNotTaken();

private:
    MainWindow& window() { return **m_window; }
    void change() {
        m_window->typeInto(m_window->field("cloth.ks"), "777");
        m_window->key(Qt::Key_Return);
    }
    QMenu* recentMenu() {
        emit window().files().recentMenu()->aboutToShow();
        return window().files().recentMenu();
    }
    bool drop(QWidget* target, const QMimeData& data);

    std::unique_ptr<TestWindow> m_window;
};

// As the platform does it: what accepts the entry has accepted the moves. Returns whether it was taken.
bool TestFiles::drop(QWidget* target, const QMimeData& data) {
    QWindow* handle = window().windowHandle();
    const QPoint at = target->mapTo(&window(), target->rect().center());
    QDragEnterEvent enter(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(handle, &enter);
    QDragMoveEvent move(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    if (enter.isAccepted()) {
        move.setDropAction(enter.dropAction());
        move.accept();
    }
    QApplication::sendEvent(handle, &move);
    if (!move.isAccepted()) {
        QDragLeaveEvent leave;
        QApplication::sendEvent(handle, &leave);
        return false;
    }
    QDropEvent event(at, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QApplication::sendEvent(handle, &event);
    return event.isAccepted();
}

void TestFiles::aNewWindowHoldsAnUntitledSheetThatHangsFromTwoCorners() {
    QCOMPARE(window().windowTitle(), QStringLiteral("Untitled[*] — ClothLab"));
    QVERIFY(!window().isWindowModified());
    QCOMPARE(m_window->scene().cloth.pinned.size(), std::size_t(2));
}

void TestFiles::everySceneOfTheCourseOpens_data() {
    QTest::addColumn<QString>("name");
    for (const char* name : {"pinned2", "pinned4", "plane", "sphere", "selfCollision"})
        QTest::newRow(name) << QString(name);
}

void TestFiles::everySceneOfTheCourseOpens() {
    QFETCH(const QString, name);
    QVERIFY(window().files().open(QStringLiteral(CLOTHLAB_SOURCE_DIR "/scenes/%1.json").arg(name)));
    QCOMPARE(m_window->document().displayName(), name + ".json");
    QCOMPARE(window().messageBar().text(), QString());
    m_window->key(Qt::Key_N);
    TRY_COMPARE(m_window->frame(), 1);
}

void TestFiles::newBeginsAnUntitledScene() {
    QVERIFY(m_window->load(smallScene()));
    QVERIFY(m_window->simulateTo(3));
    m_window->document().setSelection({{{Selection::Kind::Point, 3}}});
    m_window->key(Qt::Key_N, Qt::ControlModifier);
    QCOMPARE(m_window->document().path(), QString());
    QCOMPARE(m_window->scene().cloth.numWidthPoints, 50);
    QCOMPARE(m_window->frameCount(), 1);
    QVERIFY(m_window->document().selection().empty());
    QCOMPARE(m_window->document().undoStack().count(), 0);
}

void TestFiles::theTitleMarksUnsavedChanges() {
    QVERIFY(m_window->load(smallScene()));
    QVERIFY(!window().isWindowModified());
    change();
    QVERIFY(window().isWindowModified());
    m_window->key(Qt::Key_S, Qt::ControlModifier);
    QVERIFY(!window().isWindowModified());
    // What was saved is the mark: undoing it is a change.
    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    QVERIFY(window().isWindowModified());
    m_window->key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(!window().isWindowModified());
}

void TestFiles::cancelInTheFileChooserChangesNothing() {
    QVERIFY(m_window->load(smallScene()));
    const Scene before = m_window->scene();
    for (const Qt::Key key : {Qt::Key_O, Qt::Key_S}) {
        DialogAnswer answer(pressEscape());
        m_window->key(key, key == Qt::Key_O ? Qt::KeyboardModifiers(Qt::ControlModifier)
                                            : Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(answer.asked());
        QVERIFY(m_window->scene() == before);
        QCOMPARE(m_window->document().displayName(), QStringLiteral("scene.json"));
        QCOMPARE(window().messageBar().text(), QString());
    }
}

void TestFiles::saveAsksForANameOnceOnly() {
    DialogAnswer chooser(chooseFile(m_window->path("first.json")));
    m_window->key(Qt::Key_S, Qt::ControlModifier);
    QVERIFY(chooser.asked());
    QVERIFY(QFile::exists(m_window->path("first.json")));
    change();
    DialogAnswer again(pressEscape());
    m_window->key(Qt::Key_S, Qt::ControlModifier);
    QVERIFY(!again.asked());
    QCOMPARE(loadScene(m_window->path("first.json").toStdString()).scene->cloth.ks, 777.0);
}

void TestFiles::saveAsAddsTheSuffix() {
    DialogAnswer chooser(chooseFile(m_window->path("no suffix")));
    m_window->key(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(chooser.asked());
    QVERIFY(QFile::exists(m_window->path("no suffix.json")));
    QCOMPARE(window().windowTitle(), QStringLiteral("no suffix.json[*] — ClothLab"));
}

void TestFiles::whatIsSavedIsWhatIsOpenedAgain() {
    QVERIFY(m_window->load(smallScene()));
    change();
    window().actions().keepView->trigger();
    const Scene saved = m_window->scene();
    m_window->key(Qt::Key_S, Qt::ControlModifier);
    m_window->key(Qt::Key_N, Qt::ControlModifier);
    QVERIFY(m_window->scene() != saved);
    QVERIFY(window().files().open(m_window->path("scene.json")));
    QVERIFY(m_window->scene() == saved);
}

void TestFiles::savingToAPlaceThatCannotBeWrittenIsToldAndLosesNothing() {
    QVERIFY(m_window->load(smallScene()));
    change();
    // The file's folder is gone. Permissions would not do: an administrator may write everywhere.
    const QString path = m_window->path("gone/scene.json");
    QVERIFY(QDir().mkdir(m_window->path("gone")));
    QVERIFY(!m_window->document().save(path).has_value());
    QVERIFY(QFile::remove(path) && QDir().rmdir(m_window->path("gone")));
    m_window->typeInto(m_window->field("cloth.ks"), "888");
    m_window->key(Qt::Key_Return);

    m_window->key(Qt::Key_S, Qt::ControlModifier);
    QVERIFY(window().messageBar().text().startsWith("The scene was not saved."));
    QVERIFY2(window().messageBar().text().contains("gone"), qPrintable(window().messageBar().text()));
    QVERIFY(m_window->document().isModified());
    QCOMPARE(m_window->scene().cloth.ks, 888.0);
    // A question that cannot save does not go on.
    DialogAnswer answer(QMessageBox::Save);
    QVERIFY(!window().files().newScene());
    QVERIFY(answer.asked());
    QCOMPARE(m_window->scene().cloth.ks, 888.0);
}

void TestFiles::recentFilesAreListedNewestFirstAndOpen() {
    const QString a = m_window->write("a.json", smallScene());
    const QString b = m_window->write("b.json", smallScene());
    QVERIFY(window().files().open(a) && window().files().open(b));
    QCOMPARE(window().files().recentFiles(), (QStringList{b, a}));
    const QList<QAction*> actions = recentMenu()->actions();
    QCOMPARE(actions.size(), 2);
    QCOMPARE(actions.at(1)->text(), QStringLiteral("a.json"));
    actions.at(1)->trigger();
    QCOMPARE(m_window->document().path(), a);
    QCOMPARE(window().files().recentFiles(), (QStringList{a, b}));
}

void TestFiles::recentFilesThatAreGoneCannotBeChosen() {
    QVERIFY(m_window->load(smallScene()));
    QVERIFY(QFile::remove(m_window->path("scene.json")));
    QCOMPARE(recentMenu()->actions().size(), 1);
    QVERIFY(!recentMenu()->actions().at(0)->isEnabled());
    QVERIFY(recentMenu()->actions().at(0)->toolTip().contains("not there any more"));
}

void TestFiles::recentFilesAreKeptBetweenRuns() {
    QVERIFY(m_window->load(smallScene()));
    m_window->open();
    QCOMPARE(window().files().recentFiles(), QStringList{m_window->path("scene.json")});
}

void TestFiles::aQuestionComesBeforeChangesAreLost_data() {
    QTest::addColumn<int>("what");
    QTest::newRow("new") << 0;
    QTest::newRow("open") << 1;
    QTest::newRow("recent") << 2;
    QTest::newRow("drop") << 3;
    QTest::newRow("choose") << 4;
}

void TestFiles::aQuestionComesBeforeChangesAreLost() {
    QFETCH(const int, what);
    const QString other = m_window->write("other.json", Scene{});
    QVERIFY(window().files().open(other) && m_window->load(smallScene()));
    change();
    const Scene before = m_window->scene();
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(other)});
    const auto lose = [&] {
        if (what == 0)
            m_window->key(Qt::Key_N, Qt::ControlModifier);
        else if (what == 1)
            window().files().open(other);
        else if (what == 2)
            recentMenu()->actions().at(1)->trigger();
        else if (what == 3)
            drop(&m_window->viewport(), data);
        else
            m_window->key(Qt::Key_O, Qt::ControlModifier);
    };

    DialogAnswer cancel(QMessageBox::Cancel);
    lose();
    TRY_VERIFY(cancel.asked());
    QVERIFY(cancel.text().contains("scene.json"));
    QVERIFY(m_window->scene() == before);
    QCOMPARE(m_window->document().undoStack().count(), 1);

    if (what == 4) // Discard leads on to the file chooser, which other tests are about
        return;
    DialogAnswer discard(QMessageBox::Discard);
    lose();
    TRY_VERIFY(discard.asked());
    TRY_VERIFY(m_window->scene() != before);
    QVERIFY(!m_window->document().isModified());
    QCOMPARE(loadScene(m_window->path("scene.json").toStdString()).scene->cloth.ks, 5000.0);
}

void TestFiles::saveInTheQuestionSavesAndGoesOn() {
    QVERIFY(m_window->load(smallScene()));
    change();
    DialogAnswer answer(QMessageBox::Save);
    m_window->key(Qt::Key_N, Qt::ControlModifier);
    QVERIFY(answer.asked());
    QCOMPARE(m_window->document().path(), QString());
    QCOMPARE(loadScene(m_window->path("scene.json").toStdString()).scene->cloth.ks, 777.0);
}

void TestFiles::nothingIsAskedWithoutChanges() {
    QVERIFY(m_window->load(smallScene()));
    change();
    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    DialogAnswer answer(QMessageBox::Cancel);
    m_window->key(Qt::Key_N, Qt::ControlModifier);
    QVERIFY(!answer.asked());
    QVERIFY(window().close());
    QVERIFY(!answer.asked());
}

void TestFiles::closingAsksAndCancelKeepsTheWindow() {
    QVERIFY(m_window->load(smallScene()));
    change();
    DialogAnswer cancel(QMessageBox::Cancel);
    m_window->key(Qt::Key_Q, Qt::ControlModifier);
    QVERIFY(cancel.asked());
    QVERIFY(window().isVisible());
    DialogAnswer discard(QMessageBox::Discard);
    QVERIFY(window().close());
    QVERIFY(discard.asked());
    QVERIFY(!window().isVisible());
}

void TestFiles::aDroppedFileIsOpened() {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(m_window->write("dropped.json", smallScene()))});
    QVERIFY(drop(&m_window->viewport(), data));
    TRY_COMPARE(m_window->document().displayName(), QStringLiteral("dropped.json"));
}

void TestFiles::aFileDroppedOnAPanelIsOpened() {
    const QList<QWidget*> targets{&window().simulationPanel(), m_window->field("cloth.ks"),
                                  &window().inspectorPanel(), window().timelinePanel().scrubber(),
                                  window().statusBar()};
    for (QWidget* target : targets) {
        m_window->document().newScene();
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(m_window->write("dropped.json", smallScene()))});
        QVERIFY2(drop(target, data), target->metaObject()->className());
        TRY_COMPARE(m_window->document().displayName(), QStringLiteral("dropped.json"));
    }
}

void TestFiles::aDropOfWhatIsNoFileIsNotTaken() {
    QMimeData link;
    link.setUrls({QUrl("https://example.org/scene.json")});
    QVERIFY(!drop(&m_window->viewport(), link));
    QMimeData two;
    two.setUrls({QUrl::fromLocalFile("/a.json"), QUrl::fromLocalFile("/b.json")});
    QVERIFY(!drop(&m_window->viewport(), two));
    QMimeData text;
    text.setText("sheet");
    QVERIFY(!drop(&m_window->viewport(), text));
}

CLOTHLAB_GUI_TEST_MAIN(TestFiles)
#include "tst_files.moc"
