#include "app/widgets/foldable_group.h"

#include <QAction>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>
#include <QToolButton>
#include <QVBoxLayout>

#include <memory>

using clothlab::FoldableGroup;

class TestFoldableGroup : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_group = std::make_unique<FoldableGroup>(QStringLiteral("Material"));
        m_inside = new QLabel(QStringLiteral("inside"));
        m_group->contentLayout()->addWidget(m_inside);
        m_group->show();
        m_group->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_group.get()));
    }

    void cleanup() { m_group.reset(); }

    void foldsByClick() {
        QSignalSpy changed(m_group.get(), &FoldableGroup::foldedChanged);
        QVERIFY(m_inside->isVisible());
        QTest::mouseClick(header(), Qt::LeftButton);
        QVERIFY(m_group->isFolded());
        QVERIFY(!m_inside->isVisible());
        QTest::mouseClick(header(), Qt::LeftButton);
        QVERIFY(m_inside->isVisible());
        QCOMPARE(changed.count(), 2);
        QCOMPARE(changed.at(0).at(0).toBool(), true);
        QCOMPARE(changed.at(1).at(0).toBool(), false);
    }

    void foldsByEnterNotBySpace() {
        header()->setFocus(Qt::TabFocusReason);
        QTest::keyClick(header(), Qt::Key_Return);
        QVERIFY(m_group->isFolded());
        QAction play;
        play.setShortcut(Qt::Key_Space);
        m_group->addAction(&play);
        QSignalSpy played(&play, &QAction::triggered);
        QTest::keyClick(header(), Qt::Key_Space);
        QCOMPARE(played.count(), 1);
        m_group->removeAction(&play);
        QTest::keyClick(header(), Qt::Key_Space);
        QVERIFY(m_group->isFolded());
    }

    void foldsByProgram() {
        QSignalSpy changed(m_group.get(), &FoldableGroup::foldedChanged);
        m_group->setFolded(true);
        m_group->setFolded(true);
        QCOMPARE(changed.count(), 1);
        QVERIFY(!m_inside->isVisible());
        QTest::mouseClick(header(), Qt::LeftButton); // the arrow went along
        QVERIFY(m_inside->isVisible());
    }

    void isNamed() {
        QCOMPARE(header()->accessibleName(), QStringLiteral("Material"));
        m_group->setTitle(QStringLiteral("Time"));
        QCOMPARE(m_group->title(), QStringLiteral("Time"));
    }

private:
    QToolButton* header() const { return m_group->findChild<QToolButton*>(); }

    std::unique_ptr<FoldableGroup> m_group;
    QLabel* m_inside = nullptr;
};

QTEST_MAIN(TestFoldableGroup)
#include "tst_foldable_group.moc"
