// Takes in their panel, and recordings in files, by clicks and keys.
#include "dialog_answer.h"
#include "test_window.h"

using namespace clothlab;

class TestRecordings : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_window = std::make_unique<TestWindow>();
        QVERIFY(m_window->load(smallScene()));
    }

    void thePanelShowsABranchAndWhatDiffers();
    void aDoubleClickOpensATakeWithItsScene();
    void aTakeIsRenamedByKeys();
    void aTakeIsDeletedAndComesBack();
    void whatCannotBeDoneSaysWhy();
    void rBeginsATake();
    void aRecordingIsSavedAndOpenedAndRecordedFurther();
    void aRecordingThatIsCutOffOpensWithWords();
    void whatIsNoRecordingLeavesAllAsItIs();
    void aRecordingIsAskedForBeforeItIsLost();
    void whatTookLongIsAskedForWithASceneAlone();
    void aMarkerIsAskedForWithASceneAlone();
    void howExactlyFramesAreKeptIsChosenAndStays();

private:
    QTreeWidget& tree() { return (*m_window)->takesPanel().tree(); }
    QTreeWidgetItem* item(TakeId id) { return (*m_window)->takesPanel().item(id); }
    const Recording& recording() { return m_window->simulation().recording(); }
    QAction* action(const char* name) { return (*m_window)->takesPanel().findChild<QAction*>(name); }

    void showPanel() {
        (*m_window)->dock("takes")->raise();
        TRY_VERIFY(tree().isVisible() && !tree().visibleRegion().isEmpty());
    }
    QPoint placeOf(TakeId id) {
        tree().scrollToItem(item(id));
        return tree().visualItemRect(item(id)).center();
    }

    // Take 1 of 10 frames, and Take 2 that branches off frame 4 with another stiffness.
    void branch() {
        QVERIFY(m_window->simulateTo(10));
        m_window->simulation().showFrame(4);
        m_window->typeInto(m_window->field("cloth.ks"), "900");
        m_window->key(Qt::Key_Return);
        m_window->simulation().simulateFrame();
        TRY_COMPARE(recording().takes().size(), std::size_t(2));
        QVERIFY(m_window->simulateTo(7));
    }

    std::unique_ptr<TestWindow> m_window;
};

void TestRecordings::thePanelShowsABranchAndWhatDiffers() {
    branch();
    showPanel();
    QCOMPARE(tree().topLevelItemCount(), 1);
    QCOMPARE(item(2)->parent(), item(1));
    QCOMPARE(item(1)->text(1), QStringLiteral("11"));
    QCOMPARE(item(2)->text(1), QStringLiteral("8"));
    QVERIFY2(item(2)->text(2).contains("from frame 4") && item(2)->text(2).contains("5000 → 900"),
             qPrintable(item(2)->text(2)));
    m_window->typeInto(m_window->field("cloth.ks"), "700");
    m_window->key(Qt::Key_Return);
    QVERIFY(m_window->simulateTo(8));
    QVERIFY2(item(2)->text(2).contains("1 change"), qPrintable(item(2)->text(2)));
    QVERIFY2(item(2)->toolTip(2).contains("frame 8: "), qPrintable(item(2)->toolTip(2)));
}

void TestRecordings::aDoubleClickOpensATakeWithItsScene() {
    branch();
    showPanel();
    m_window->click(tree().viewport(), placeOf(1));
    m_window->doubleClick(tree().viewport(), placeOf(1));
    QCOMPARE(recording().take()->id(), TakeId(1));
    QCOMPARE(m_window->frameCount(), 11);
    QCOMPARE(m_window->frame(), 7);
    QCOMPARE(m_window->scene().cloth.ks, 5000.0);
    QCOMPARE(m_window->field("cloth.ks")->value(), 5000.0);
    QVERIFY(item(1)->font(0).bold() && !item(2)->font(0).bold());
    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(recording().take()->id(), TakeId(2));
    QCOMPARE(m_window->scene().cloth.ks, 900.0);
    m_window->key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(recording().take()->id(), TakeId(1));
}

void TestRecordings::aTakeIsRenamedByKeys() {
    branch();
    showPanel();
    m_window->click(tree().viewport(), placeOf(2));
    m_window->key(Qt::Key_F2);
    m_window->type("soft");
    m_window->key(Qt::Key_Return);
    TRY_COMPARE(recording().take()->name(), std::string("soft"));
    TRY_COMPARE(item(2)->text(0), QStringLiteral("soft"));
    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(recording().take()->name(), std::string("Take 2"));
    QCOMPARE(item(2)->text(0), QStringLiteral("Take 2"));
}

void TestRecordings::aTakeIsDeletedAndComesBack() {
    branch();
    showPanel();
    m_window->click(tree().viewport(), placeOf(2)); // the open one
    m_window->key(Qt::Key_Delete);
    QCOMPARE(recording().takes().size(), std::size_t(1));
    QCOMPARE(recording().take()->id(), TakeId(1));
    QCOMPARE(m_window->scene().cloth.ks, 5000.0);
    QVERIFY(!item(2));
    m_window->key(Qt::Key_Z, Qt::ControlModifier); // one step
    QCOMPARE(recording().take()->id(), TakeId(2));
    QCOMPARE(m_window->frameCount(), 8);
    QVERIFY(item(2));
}

void TestRecordings::whatCannotBeDoneSaysWhy() {
    showPanel();
    QVERIFY(!action("deleteTake")->isEnabled());
    QVERIFY(action("deleteTake")->toolTip().contains("only take"));
    QVERIFY(!action("openTake")->isEnabled());
    branch();
    QVERIFY(action("deleteTake")->isEnabled());
    m_window->click(tree().viewport(), placeOf(1));
    QVERIFY(action("openTake")->isEnabled());
}

void TestRecordings::rBeginsATake() {
    QVERIFY(m_window->simulateTo(5));
    m_window->viewport().setFocus();
    m_window->key(Qt::Key_R);
    QCOMPARE(m_window->frameCount(), 1);
    QCOMPARE(recording().takes().size(), std::size_t(2));
    QCOMPARE(tree().topLevelItemCount(), 2);
    QVERIFY(m_window->output().contains("Take 1 keeps its frames"));
}

void TestRecordings::aRecordingIsSavedAndOpenedAndRecordedFurther() {
    branch();
    const QString path = m_window->path("run.clothtake");
    DialogAnswer chooser(chooseFile(path));
    m_window->key(Qt::Key_S, Qt::ControlModifier | Qt::AltModifier);
    QVERIFY(chooser.asked());
    TRY_VERIFY(QFile::exists(path));
    QCOMPARE((*m_window)->windowTitle(), QStringLiteral("run.clothtake[*] — ClothLab"));
    QVERIFY(!m_window->document().isModified());
    const PointArray last = m_window->simulation().look(7)->state.position;

    m_window->open(); // another window
    QVERIFY((*m_window)->files().open(path));
    QCOMPARE(recording().takes().size(), std::size_t(2));
    QCOMPARE(recording().take()->id(), TakeId(2));
    QCOMPARE(m_window->frame(), 7);
    QCOMPARE(m_window->scene().cloth.ks, 900.0);
    QCOMPARE(recording().takes()[0]->frameCount(), 11);
    TRY_VERIFY(m_window->simulation().shownFrame()->exact);
    QCOMPARE(m_window->simulation().shownFrame()->state.position, last);
    QVERIFY(!m_window->document().isModified());

    QVERIFY(m_window->simulateTo(9));
    QVERIFY(m_window->document().isModified());
    m_window->key(Qt::Key_S, Qt::ControlModifier);
    TRY_VERIFY(!m_window->document().isModified());
    const TakeFileReading reading = readTakeFile(path.toStdString());
    QVERIFY(reading.contents && reading.diagnostics.empty());
    QCOMPARE(reading.contents->takes.size(), std::size_t(2));
    QCOMPARE(reading.contents->takes[1].end(), 10);
}

void TestRecordings::aRecordingThatIsCutOffOpensWithWords() {
    branch();
    const QString path = m_window->path("run.clothtake");
    QVERIFY((*m_window)->files().saveTo(path));
    QFile file(path);
    QVERIFY(file.resize(file.size() - 200));
    m_window->open();
    QVERIFY((*m_window)->files().open(path));
    QVERIFY2((*m_window)->messageBar().text().contains("cut off"),
             qPrintable((*m_window)->messageBar().text()));
    QVERIFY(m_window->frameCount() >= 1);
}

void TestRecordings::whatIsNoRecordingLeavesAllAsItIs() {
    branch();
    const QString path = m_window->writeText("no.clothtake", "this is no recording");
    QVERIFY(!(*m_window)->files().openUnasked(path));
    QVERIFY2((*m_window)->messageBar().text().contains("no.clothtake"),
             qPrintable((*m_window)->messageBar().text()));
    QCOMPARE(recording().takes().size(), std::size_t(2));

    // All that is right in a file but that there are no takes, or none that is not deleted.
    QVERIFY((*m_window)->files().saveTo(m_window->path("run.clothtake")));
    TakeFileReading reading = readTakeFile(m_window->path("run.clothtake").toStdString());
    for (RecordedTake& take : reading.contents->takes)
        take.info.hidden = true;
    QVERIFY(!writeTakeFile(m_window->path("hidden.clothtake").toStdString(), *reading.contents));
    (*m_window)->files().openUnasked(m_window->path("hidden.clothtake"));
    QVERIFY(!recording().takes().empty());
    reading.contents->takes.clear();
    reading.contents->meta = {};
    QVERIFY(!writeTakeFile(m_window->path("empty.clothtake").toStdString(), *reading.contents));
    QVERIFY(!(*m_window)->files().openUnasked(m_window->path("empty.clothtake")));
    QVERIFY(!recording().takes().empty());
}

void TestRecordings::aRecordingIsAskedForBeforeItIsLost() {
    QVERIFY((*m_window)->files().saveTo(m_window->path("run.clothtake")));
    QVERIFY(m_window->simulateTo(3));
    DialogAnswer cancel(QMessageBox::Cancel);
    QVERIFY(!(*m_window)->files().newScene());
    QVERIFY(cancel.text().contains("run.clothtake"));
}

void TestRecordings::whatTookLongIsAskedForWithASceneAlone() {
    Simulation& simulation = m_window->simulation();
    QVERIFY(m_window->simulateTo(3));
    QVERIFY(!simulation.isWorthSaving()); // it can be had again in a moment
    simulation.setSecondsWorthSaving(1e-9);
    DialogAnswer cancel(QMessageBox::Cancel);
    QVERIFY(!(*m_window)->close());
    QVERIFY2(cancel.text().contains("recording of scene.json"), qPrintable(cancel.text()));
    QCOMPARE(recording().frameCount(), 4);

    QVERIFY((*m_window)->files().saveTo(m_window->path("run.clothtake")));
    QVERIFY((*m_window)->files().saveTo(m_window->path("scene.json")));
    QVERIFY(!simulation.isWorthSaving()); // run.clothtake has it
    QVERIFY(m_window->simulateTo(5));
    DialogAnswer discard(QMessageBox::Discard);
    QVERIFY((*m_window)->files().newScene());
    QVERIFY(discard.asked());
    DialogAnswer nothing(QMessageBox::Cancel);
    QVERIFY((*m_window)->files().newScene());
    QVERIFY(!nothing.asked());
}

void TestRecordings::aMarkerIsAskedForWithASceneAlone() {
    QVERIFY(m_window->simulateTo(3));
    m_window->simulation().setMarker(2, "here");
    QStringList offered;
    const auto answer = [&](const char* text) {
        return [&offered, text](QDialog& dialog) {
            offered.clear();
            for (QAbstractButton* button : qobject_cast<QMessageBox*>(&dialog)->buttons()) {
                offered << button->text().remove('&');
                if (offered.constLast() == text)
                    QTest::mouseClick(button, Qt::LeftButton);
            }
        };
    };
    DialogAnswer cancel(answer("Cancel"));
    QVERIFY(!(*m_window)->files().newScene());
    QVERIFY2(offered.contains("Save with Recording…"), qPrintable(offered.join(", ")));
    QCOMPARE(m_window->simulation().marks().markers.size(), std::size_t(1));

    DialogAnswer sceneOnly(answer("Save Scene Only"));
    QVERIFY((*m_window)->files().newScene());
    QVERIFY(sceneOnly.asked());
    QCOMPARE(m_window->document().path(), QString());
}

void TestRecordings::howExactlyFramesAreKeptIsChosenAndStays() {
    QVERIFY((*m_window)->actions().recordHundredth->isChecked());
    (*m_window)->actions().recordExactly->trigger();
    QVERIFY(m_window->simulateTo(20));
    QVERIFY((*m_window)->files().saveTo(m_window->path("run.clothtake")));
    const TakeFileReading reading = readTakeFile(m_window->path("run.clothtake").toStdString());
    QVERIFY(reading.contents);
    QCOMPARE(reading.contents->meta.error, 0.0);
    const FrameGroup* group = findGroup(*reading.contents, 1, 20);
    QVERIFY(group && positionsOf(*group, 20) == m_window->simulation().look(20)->state.position);
    m_window->open();
    QVERIFY((*m_window)->actions().recordExactly->isChecked());
    QCOMPARE(m_window->simulation().recordingError(), 0.0);
}

CLOTHLAB_GUI_TEST_MAIN(TestRecordings)
#include "tst_recordings.moc"
