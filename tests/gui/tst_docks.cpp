// Panels: floated, tabbed, hidden, put back, and kept between runs.
#include "tests/gui/test_window.h"

#include <QComboBox>
#include <QMenuBar>
#include <QToolBar>

using namespace clothlab;

class TestDocks : public QObject {
    Q_OBJECT

private slots:
    void init() { m_window = std::make_unique<TestWindow>(); }
    void cleanup() { m_window.reset(); }

    void everyPanelIsThereAndMayBeMovedFloatedAndClosed();
    void theMenuPanelsHidesAndShowsEveryPanel();
    void panelsFloatByADoubleClickOnTheirTitleAndWorkThere();
    void panelsCanBeTabbed();
    void resetPutsEverythingBack();
    void theLayoutIsKeptBetweenRuns();
    void howItPlaysIsKeptBetweenRunsButNotThatItRepeats();
    void aSpoiltLayoutIsIgnored();
    void allPanelsHideAndComeBackAsTheyWere();
    void panelsHiddenWhenClosingAreThereNextTime();
    void nothingIsClippedInASmallWindow();
    void fullScreenIsLeftAsItWasEntered();
    void theThemeIsKeptBetweenRuns();
    void theThemeMayBeThatOfTheSystem();

private:
    MainWindow& window() { return **m_window; }
    const QStringList m_names{"springs",  "appearance", "inspector", "simulation",
                              "timeline", "takes",      "output",    "shader"};
    // Where each panel is and whether it can be seen.
    QMap<QString, QRect> places() {
        QMap<QString, QRect> found;
        for (const QString& name : m_names) {
            const QDockWidget* dock = window().dock(name);
            if (!dock->visibleRegion().isEmpty())
                found.insert(name, dock->geometry());
        }
        return found;
    }
    // A layout settles in the event loop.
    bool settlesTo(const QMap<QString, QRect>& expected) {
        const bool settled = QTest::qWaitFor([&] { return places() == expected; }, kPatience);
        if (!settled)
            qWarning() << "expected" << expected << "but found" << places();
        return settled;
    }

    std::unique_ptr<TestWindow> m_window;
};

void TestDocks::everyPanelIsThereAndMayBeMovedFloatedAndClosed() {
    QCOMPARE(window().findChildren<QDockWidget*>().size(), m_names.size());
    for (const QString& name : m_names) {
        const QDockWidget* dock = window().dock(name);
        QVERIFY2(dock, qPrintable(name));
        QVERIFY(!dock->isHidden());
        QVERIFY(!dock->windowTitle().isEmpty());
        const auto all = QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetMovable |
                         QDockWidget::DockWidgetFloatable;
        QCOMPARE(dock->features() & all, all);
        QCOMPARE(dock->allowedAreas(), Qt::AllDockWidgetAreas);
    }
}

void TestDocks::theMenuPanelsHidesAndShowsEveryPanel() {
    QMenu* panels = nullptr;
    for (QMenu* menu : window().menuBar()->findChildren<QMenu*>())
        if (menu->actions().contains(window().dock("springs")->toggleViewAction()))
            panels = menu;
    QVERIFY(panels);
    QVERIFY(panels->actions().contains(window().actions().hidePanels));
    QVERIFY(panels->actions().contains(window().actions().resetLayout));
    for (const QString& name : m_names) {
        QDockWidget* dock = window().dock(name);
        QAction* action = dock->toggleViewAction();
        QVERIFY(panels->actions().contains(action));
        panels->popup(window().mapToGlobal(QPoint(300, 60)));
        QVERIFY(QTest::qWaitForWindowExposed(panels, kPatience));
        QTest::mouseClick(panels, Qt::LeftButton, {}, panels->actionGeometry(action).center());
        QVERIFY2(dock->isHidden(), qPrintable(name));
        QVERIFY(!action->isChecked());
        action->trigger();
        QVERIFY(!dock->isHidden());
    }
}

void TestDocks::panelsFloatByADoubleClickOnTheirTitleAndWorkThere() {
    QVERIFY(m_window->load(smallScene()));
    for (const QString& name : m_names) {
        window().dock(name)->raise();
        TRY_VERIFY(!window().dock(name)->visibleRegion().isEmpty());
        QTest::mouseDClick(window().dock(name), Qt::LeftButton, {}, {30, 8});
        QVERIFY2(window().dock(name)->isFloating(), qPrintable(name));
        QVERIFY(QTest::qWaitForWindowExposed(window().dock(name), kPatience));
    }
    // Fields take numbers there, and keys of the window work.
    QDockWidget* dock = window().dock("simulation");
    dock->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(dock, kPatience));
    m_window->typeInto(m_window->field("cloth.ks"), "700");
    m_window->key(Qt::Key_Return);
    QCOMPARE(m_window->scene().cloth.ks, 700.0);
    m_window->key(Qt::Key_Space);
    QVERIFY(m_window->simulation().isPlaying());
    m_window->key(Qt::Key_Space);
    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(m_window->scene().cloth.ks, 5000.0);
}

void TestDocks::panelsCanBeTabbed() {
    QVERIFY(window().tabifiedDockWidgets(window().dock("timeline")).contains(window().dock("output")));
    window().tabifyDockWidget(window().dock("springs"), window().dock("appearance"));
    QVERIFY(window().tabifiedDockWidgets(window().dock("springs")).contains(window().dock("appearance")));
    window().dock("appearance")->raise();
    TRY_VERIFY(window().dock("springs")->visibleRegion().isEmpty());
    QVERIFY(!window().dock("appearance")->visibleRegion().isEmpty());
}

void TestDocks::resetPutsEverythingBack() {
    const auto before = places();
    QVERIFY(before.contains("timeline") && !before.contains("output"));
    window().dock("springs")->setFloating(true);
    window().dock("inspector")->hide();
    window().addDockWidget(Qt::LeftDockWidgetArea, window().dock("simulation"));
    window().tabifyDockWidget(window().dock("simulation"), window().dock("appearance"));
    TRY_VERIFY(places() != before);
    window().actions().resetLayout->trigger();
    QVERIFY(!window().dock("springs")->isFloating());
    QVERIFY2(settlesTo(before), "a panel is not where it was at first");
}

void TestDocks::theLayoutIsKeptBetweenRuns() {
    window().dock("springs")->hide();
    window().dock("inspector")->setFloating(true);
    window().addDockWidget(Qt::LeftDockWidgetArea, window().dock("simulation"));
    window().dock("output")->raise();
    window().resize(1300, 850);
    TRY_VERIFY(!window().dock("output")->visibleRegion().isEmpty());
    TRY_COMPARE(window().size(), QSize(1300, 850));
    QVERIFY(window().close());

    m_window->open();
    TRY_COMPARE(window().size(), QSize(1300, 850));
    QVERIFY(window().dock("springs")->isHidden());
    QVERIFY(window().dock("inspector")->isFloating());
    QCOMPARE(window().dockWidgetArea(window().dock("simulation")), Qt::LeftDockWidgetArea);
    TRY_VERIFY(!window().dock("output")->visibleRegion().isEmpty());
    QVERIFY(window().dock("timeline")->visibleRegion().isEmpty());
}

void TestDocks::howItPlaysIsKeptBetweenRunsButNotThatItRepeats() {
    m_window->key(Qt::Key_BracketRight);
    m_window->key(Qt::Key_L);
    auto* pace = window().findChild<QComboBox*>("playbackPace");
    auto* quantity = window().findChild<QComboBox*>("plotQuantity");
    for (QComboBox* choice : {pace, quantity}) {
        choice->setFocus();
        m_window->key(Qt::Key_Down);
    }
    const QString plotted = quantity->currentText();
    const PlaybackSettings before = m_window->simulation().playback();
    QCOMPARE(before.speed, 2.0);
    QVERIFY(before.realTime && before.repeat == Repeat::Loop);
    QVERIFY(window().close());

    m_window->open();
    const PlaybackSettings kept = m_window->simulation().playback();
    QCOMPARE(kept.speed, 2.0);
    QVERIFY(kept.realTime && kept.repeat == Repeat::Once);
    QCOMPARE(window().findChild<QComboBox*>("playbackSpeed")->currentText(), QStringLiteral("2×"));
    QCOMPARE(window().findChild<QComboBox*>("plotQuantity")->currentText(), plotted);
}

void TestDocks::aSpoiltLayoutIsIgnored() {
    const auto before = places();
    QVERIFY(window().close());
    QSettings settings(m_window->path("settings.ini"), QSettings::IniFormat);
    settings.setValue("layout", QByteArray("spoilt"));
    settings.setValue("geometry", QByteArray("spoilt"));
    settings.setValue("recentFiles", 3.5);
    settings.setValue("theme", QByteArray("plaid"));
    settings.setValue("playbackSpeed", -1);
    settings.setValue("plotQuantity", 77);
    settings.sync();
    m_window->open();
    QVERIFY(settlesTo(before));
}

void TestDocks::allPanelsHideAndComeBackAsTheyWere() {
    const int top = window().dock("springs")->y();
    window().dock("springs")->hide();
    TRY_COMPARE(window().dock("appearance")->y(), top); // moved up
    const auto before = places();
    window().viewport().setFocus();
    m_window->key(Qt::Key_Tab);
    for (const QString& name : m_names)
        QVERIFY2(window().dock(name)->isHidden(), qPrintable(name));
    QVERIFY(window().actions().hidePanels->isChecked());
    m_window->key(Qt::Key_Tab);
    QVERIFY(!window().actions().hidePanels->isChecked());
    QVERIFY(window().dock("springs")->isHidden());
    QVERIFY2(settlesTo(before), "a panel is not where it was");
    // And by the button.
    m_window->click(window().actions().hidePanels, window().findChild<QToolBar*>());
    QVERIFY(places().isEmpty());
    m_window->click(window().actions().hidePanels, window().findChild<QToolBar*>());
    QVERIFY(settlesTo(before));
}

void TestDocks::panelsHiddenWhenClosingAreThereNextTime() {
    window().dock("springs")->hide();
    window().viewport().setFocus();
    m_window->key(Qt::Key_Tab);
    QVERIFY(window().close());
    m_window->open();
    QVERIFY(window().dock("springs")->isHidden());
    QVERIFY(!window().dock("inspector")->isHidden());
    QVERIFY(!window().actions().hidePanels->isChecked());
}

void TestDocks::nothingIsClippedInASmallWindow() {
    window().resize(1280, 720);
    TRY_COMPARE(window().size(), QSize(1280, 720));
    for (const QString& name : m_names) {
        const QDockWidget* dock = window().dock(name);
        QVERIFY2(dock->width() >= dock->minimumSizeHint().width() &&
                     dock->height() >= dock->minimumSizeHint().height(),
                 qPrintable(name));
        QVERIFY2(window().rect().contains(dock->geometry()) || dock->visibleRegion().isEmpty(),
                 qPrintable(name));
    }
    QVERIFY(window().viewport().width() >= 400);
}

void TestDocks::fullScreenIsLeftAsItWasEntered() {
    const QSize before = window().size();
    m_window->key(Qt::Key_F11);
    TRY_VERIFY(window().isFullScreen());
    QVERIFY(window().actions().fullScreen->isChecked());
    m_window->key(Qt::Key_F11);
    TRY_VERIFY(!window().isFullScreen());
    TRY_COMPARE(window().size(), before);
}

void TestDocks::theThemeIsKeptBetweenRuns() {
    QCOMPARE(currentTheme(), Theme::Dark);
    window().actions().lightTheme->trigger();
    QCOMPARE(currentTheme(), Theme::Light);
    m_window->open();
    QCOMPARE(currentTheme(), Theme::Light);
    QVERIFY(window().actions().lightTheme->isChecked());
    window().actions().darkTheme->trigger();
    QCOMPARE(currentTheme(), Theme::Dark);
}

void TestDocks::theThemeMayBeThatOfTheSystem() {
    const Actions& actions = window().actions();
    QVERIFY(actions.systemTheme->isChecked()); // as the program comes
    actions.lightTheme->trigger();
    QVERIFY(!actions.systemTheme->isChecked());
    actions.systemTheme->trigger();
    QVERIFY(!actions.lightTheme->isChecked());
    m_window->open();
    QVERIFY(window().actions().systemTheme->isChecked());
    QCOMPARE(QSettings(m_window->path("settings.ini"), QSettings::IniFormat).value("theme").toString(),
             QStringLiteral("system"));
}

CLOTHLAB_GUI_TEST_MAIN(TestDocks)
#include "tst_docks.moc"
