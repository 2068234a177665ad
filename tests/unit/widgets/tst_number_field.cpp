#include "app/widgets/number_field.h"
#include "app/widgets/theme.h"

#include <QAction>
#include <QApplication>
#include <QSignalSpy>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <memory>
#include <numbers>

using clothlab::NumberField;

// A window with a field, another place for the focus, and shortcuts as the main window has them.
class TestNumberField : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { clothlab::applyTheme(*qApp, clothlab::Theme::Dark); }

    void init() {
        m_window = std::make_unique<QWidget>();
        auto* layout = new QVBoxLayout(m_window.get());
        m_field = new NumberField;
        m_other = new QLineEdit;
        layout->addWidget(m_field);
        layout->addWidget(m_other);
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        m_other->setFocus();
        m_edited = std::make_unique<QSignalSpy>(m_field, &NumberField::valueEdited);
        m_rejected = std::make_unique<QSignalSpy>(m_field, &NumberField::rejected);
    }

    void cleanup() {
        m_edited.reset();
        m_rejected.reset();
        m_window.reset();
    }

    void takesWhatIsTypedExactly() {
        type("0.12345678901234567");
        QCOMPARE(m_edited->count(), 0);
        QTest::keyClick(m_field, Qt::Key_Return);
        QVERIFY(m_field->value() == 0.12345678901234567);
        QCOMPARE(m_edited->count(), 1);
        QVERIFY(m_edited->at(0).at(0).toDouble() == 0.12345678901234567);
    }

    void takesItOnLosingFocus() {
        type("0,123456789");
        m_other->setFocus();
        QVERIFY(m_field->value() == 0.123456789);
        QCOMPARE(m_edited->count(), 1);
        QCOMPARE(m_field->text(), QStringLiteral("0.123457"));
    }

    void enterTwiceIsOneEdit() {
        type("3");
        QTest::keyClick(m_field, Qt::Key_Enter);
        QTest::keyClick(m_field, Qt::Key_Enter);
        m_other->setFocus();
        QCOMPARE(m_edited->count(), 1);
    }

    void sameValueTypedIsNoEdit() {
        m_field->setValue(0.5);
        type("1/2");
        QTest::keyClick(m_field, Qt::Key_Return);
        QCOMPARE(m_edited->count(), 0);
        QCOMPARE(m_field->text(), QStringLiteral("0.5"));
    }

    void calculates() {
        type("2*pi");
        QTest::keyClick(m_field, Qt::Key_Return);
        QVERIFY(m_field->value() == 2 * std::numbers::pi);
        type("1/90");
        m_other->setFocus();
        QVERIFY(m_field->value() == 1.0 / 90);
    }

    void unitMayBeTyped() {
        m_field->setUnit(QStringLiteral("N/m"));
        type("250N/m");
        QTest::keyClick(m_field, Qt::Key_Return);
        QCOMPARE(m_field->value(), 250.0);
        QCOMPARE(m_field->text(), QStringLiteral("250"));
    }

    void isShortWithoutFocusAndExactWithIt() {
        m_field->setValue(1.0 / 3);
        QCOMPARE(m_field->text(), QStringLiteral("0.333333"));
        m_field->setFocus();
        QCOMPARE(m_field->text(), QStringLiteral("0.3333333333333333"));
        m_other->setFocus();
        QCOMPARE(m_field->text(), QStringLiteral("0.333333"));
        QVERIFY(m_field->value() == 1.0 / 3);
        QCOMPARE(m_edited->count(), 0);
    }

    void clickSelectsAll() {
        m_field->setValue(12.5);
        QTest::mouseClick(m_field, Qt::LeftButton);
        QCOMPARE(m_field->selectedText(), QStringLiteral("12.5"));
        QTest::mouseClick(m_field, Qt::LeftButton, {}, {8, m_field->height() / 2});
        QVERIFY(!m_field->hasSelectedText());
    }

    void outOfRangeIsRejectedInWords() {
        m_field->setRange(0.5, 90);
        m_field->setUnit(QStringLiteral("kg"));
        m_field->setValue(2);
        type("91");
        QTest::keyClick(m_field, Qt::Key_Return);
        QCOMPARE(m_field->value(), 2.0);
        QCOMPARE(m_edited->count(), 0);
        QCOMPARE(m_rejected->count(), 1);
        const QString message = m_rejected->at(0).at(0).toString();
        for (const char* part : {"91", "0.5 kg", "90 kg", "stays 2"}) {
            QVERIFY2(message.contains(QLatin1String(part)), qPrintable(message));
        }
        QCOMPARE(m_field->property("rejected").toBool(), true);
        QCOMPARE(m_field->text(), QStringLiteral("91")); // to be corrected

        m_other->setFocus();
        QCOMPARE(m_rejected->count(), 1);
        QCOMPARE(m_field->text(), QStringLiteral("2"));
        QCOMPARE(m_field->property("rejected").toBool(), true);
        m_field->setFocus();
        QCOMPARE(m_field->property("rejected").toBool(), false);
    }

    void endsOfTheRangeAreAllowed() {
        m_field->setRange(0, 90);
        type("90");
        QTest::keyClick(m_field, Qt::Key_Return);
        QCOMPARE(m_field->value(), 90.0);
        type("0");
        QTest::keyClick(m_field, Qt::Key_Return);
        QCOMPARE(m_field->value(), 0.0);
        QCOMPARE(m_rejected->count(), 0);
    }

    void rejectedMayBeCorrected() {
        m_field->setRange(0, 10);
        type("11");
        QTest::keyClick(m_field, Qt::Key_Return);
        type("9");
        QCOMPARE(m_field->property("rejected").toBool(), false);
        QTest::keyClick(m_field, Qt::Key_Return);
        QCOMPARE(m_field->value(), 9.0);
    }

    void nonsenseIsRejectedOnLosingFocus() {
        m_field->setValue(4);
        type("four");
        m_other->setFocus();
        QCOMPARE(m_field->value(), 4.0);
        QCOMPARE(m_rejected->count(), 1);
        QVERIFY(m_rejected->at(0).at(0).toString().contains(QStringLiteral("four")));
        QCOMPARE(m_field->text(), QStringLiteral("4"));
    }

    void emptyIsRejected() {
        m_field->setValue(4);
        m_field->setFocus();
        m_field->selectAll();
        QTest::keyClick(m_field, Qt::Key_Delete);
        QTest::keyClick(m_field, Qt::Key_Return);
        QCOMPARE(m_field->value(), 4.0);
        QCOMPARE(m_rejected->count(), 1);
    }

    void integerTakesWholeNumbersOnly() {
        m_field->setInteger(true);
        m_field->setRange(1, 100);
        m_field->setValue(30);
        type("2.5");
        QTest::keyClick(m_field, Qt::Key_Return);
        QCOMPARE(m_field->value(), 30.0);
        QVERIFY(m_rejected->at(0).at(0).toString().contains(QStringLiteral("whole number from 1 to 100")));
        type("100/4");
        QTest::keyClick(m_field, Qt::Key_Return);
        QCOMPARE(m_field->value(), 25.0);
    }

    void escapeRestoresThenLeaves() {
        m_field->setValue(1.0 / 3);
        type("8");
        QTest::keyClick(m_field, Qt::Key_Escape);
        QCOMPARE(m_field->text(), QStringLiteral("0.3333333333333333"));
        QVERIFY(m_field->hasFocus());
        QTest::keyClick(m_field, Qt::Key_Escape);
        QVERIFY(!m_field->hasFocus());
        QCOMPARE(m_edited->count(), 0);
    }

    void setValueIsSilentAndLetsPeopleType() {
        m_field->setValue(1);
        type("12");
        m_field->setValue(99);
        QCOMPARE(m_field->text(), QStringLiteral("12"));
        QCOMPARE(m_field->value(), 99.0);
        QCOMPARE(m_edited->count(), 0);
        QTest::keyClick(m_field, Qt::Key_Escape);
        QCOMPARE(m_field->text(), QStringLiteral("99"));
        m_field->setValue(100); // nothing typed now, so it shows
        QCOMPARE(m_field->text(), QStringLiteral("100"));
        QCOMPARE(m_field->selectedText(), QStringLiteral("100"));
    }

    void steps_data() {
        QTest::addColumn<double>("start");
        QTest::addColumn<int>("key");
        QTest::addColumn<int>("modifiers");
        QTest::addColumn<double>("end");
        const int none = Qt::NoModifier;
        QTest::newRow("up") << 0.5 << int(Qt::Key_Up) << none << 0.51;
        QTest::newRow("down") << 0.5 << int(Qt::Key_Down) << none << 0.49;
        QTest::newRow("thousands") << 5000.0 << int(Qt::Key_Up) << none << 5100.0;
        QTest::newRow("small") << 0.0003 << int(Qt::Key_Up) << none << 0.00031;
        QTest::newRow("negative up") << -5.0 << int(Qt::Key_Up) << none << -4.9;
        QTest::newRow("up at a power of ten") << 1.0 << int(Qt::Key_Up) << none << 1.1;
        QTest::newRow("down at a power of ten") << 1.0 << int(Qt::Key_Down) << none << 0.99;
        QTest::newRow("back up to it") << 0.99 << int(Qt::Key_Up) << none << 1.0;
        QTest::newRow("zero") << 0.0 << int(Qt::Key_Up) << none << 0.01;
        QTest::newRow("shift") << 0.5 << int(Qt::Key_Up) << int(Qt::ShiftModifier) << 0.6;
        QTest::newRow("control") << 0.5 << int(Qt::Key_Up) << int(Qt::ControlModifier) << 0.501;
        QTest::newRow("no noise") << 0.29 << int(Qt::Key_Up) << none << 0.3;
        QTest::newRow("stops at the end") << 5999.0 << int(Qt::Key_Up) << none << 6000.0;
    }

    void steps() {
        QFETCH(double, start);
        QFETCH(int, key);
        QFETCH(int, modifiers);
        QFETCH(double, end);
        m_field->setRange(-100, 6000);
        m_field->setValue(start);
        m_field->setFocus();
        QTest::keyClick(m_field, Qt::Key(key), Qt::KeyboardModifiers(modifiers));
        QVERIFY2(m_field->value() == end, qPrintable(QString::number(m_field->value(), 'g', 17)));
        QCOMPARE(m_edited->count(), 1);
    }

    void stepsStopSilentlyAtTheEnd() {
        m_field->setRange(0, 1);
        m_field->setValue(1);
        m_field->setFocus();
        QTest::keyClick(m_field, Qt::Key_Up);
        QCOMPARE(m_field->value(), 1.0);
        QCOMPARE(m_edited->count(), 0);
        m_field->setValue(5); // as a file may have it
        QTest::keyClick(m_field, Qt::Key_Up);
        QCOMPARE(m_field->value(), 5.0);
        QTest::keyClick(m_field, Qt::Key_Down);
        QCOMPARE(m_field->value(), 1.0);
    }

    void smallestStepReachesZeroAndPasses() {
        m_field->setSmallestStep(0.1);
        m_field->setValue(0.3);
        m_field->setFocus();
        for (int i = 0; i < 3; ++i) {
            QTest::keyClick(m_field, Qt::Key_Down);
        }
        QVERIFY(m_field->value() == 0);
        QTest::keyClick(m_field, Qt::Key_Down);
        QCOMPARE(m_field->value(), -0.1);
    }

    void integerStepsAreWhole() {
        m_field->setInteger(true);
        m_field->setValue(3);
        m_field->setFocus();
        QTest::keyClick(m_field, Qt::Key_Up);
        QCOMPARE(m_field->value(), 4.0);
        QTest::keyClick(m_field, Qt::Key_Up, Qt::ControlModifier);
        QCOMPARE(m_field->value(), 5.0);
        QTest::keyClick(m_field, Qt::Key_Up, Qt::ShiftModifier);
        QCOMPARE(m_field->value(), 15.0);
    }

    void stepStartsAtWhatIsTyped() {
        m_field->setValue(1);
        type("40");
        QTest::keyClick(m_field, Qt::Key_Up);
        QCOMPARE(m_field->value(), 41.0);
    }

    void wheelNeedsFocus() {
        m_field->setValue(0.5);
        QVERIFY(!wheel(120));
        QCOMPARE(m_field->value(), 0.5);
        m_field->setFocus();
        QVERIFY(wheel(120));
        QCOMPARE(m_field->value(), 0.51);
        wheel(-240);
        QCOMPARE(m_field->value(), 0.49);
        wheel(60); // half a notch, twice
        QCOMPARE(m_field->value(), 0.49);
        wheel(60);
        QCOMPARE(m_field->value(), 0.5);
        wheel(120, Qt::ShiftModifier);
        QCOMPARE(m_field->value(), 0.6);
    }

    void tellsStepsFromTyping() {
        QList<bool> stepping;
        connect(m_field, &NumberField::valueEdited, this, [&] { stepping.append(m_field->isStepping()); });
        type("40");
        QTest::keyClick(m_field, Qt::Key_Return);
        QTest::keyClick(m_field, Qt::Key_Up);
        QCOMPARE(stepping, (QList<bool>{false, true}));
        QVERIFY(!m_field->isStepping());
    }

    void spaceIsTheWindows() {
        QAction play;
        play.setShortcut(Qt::Key_Space);
        m_window->addAction(&play);
        QSignalSpy played(&play, &QAction::triggered);
        type("12");
        QTest::keyClick(m_field, Qt::Key_Space);
        QCOMPARE(played.count(), 1);
        QCOMPARE(m_field->text(), QStringLiteral("12"));
        m_window->removeAction(&play);
        QTest::keyClick(m_field, Qt::Key_Space);
        QCOMPARE(m_field->text(), QStringLiteral("12"));
    }

    // Tab too: it takes what is typed and goes on.
    void lettersAndDigitsAreTheFields() {
        QAction action;
        action.setShortcuts({QKeySequence(Qt::Key_P), QKeySequence(Qt::Key_1), QKeySequence(Qt::Key_Tab)});
        m_window->addAction(&action);
        QSignalSpy triggered(&action, &QAction::triggered);
        type("1+pi");
        QTest::keyClick(m_field, Qt::Key_Tab);
        QCOMPARE(triggered.count(), 0);
        QVERIFY(m_field->value() == 1 + std::numbers::pi);
        QVERIFY(m_other->hasFocus());
    }

    void undoIsTheDocumentsUnlessTyping() {
        QAction undo;
        undo.setShortcut(QKeySequence::Undo);
        m_window->addAction(&undo);
        QSignalSpy undone(&undo, &QAction::triggered);
        m_field->setValue(1);
        type("12");
        QTest::keyClick(m_field, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(undone.count(), 0);
        QVERIFY(m_field->text() != QStringLiteral("12"));
        type("12");
        QTest::keyClick(m_field, Qt::Key_Return);
        QTest::keyClick(m_field, Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(undone.count(), 1);
        QCOMPARE(m_field->value(), 12.0);
    }

    void commitTakesWhatIsTyped() {
        type("6");
        m_field->commit();
        QCOMPARE(m_field->value(), 6.0);
        QCOMPARE(m_edited->count(), 1);
    }

private:
    // Over whatever is there.
    void type(const QString& text) {
        m_field->setFocus();
        m_field->selectAll();
        QTest::keyClicks(m_field, text);
    }

    // Whether the field took the event.
    bool wheel(int angle, Qt::KeyboardModifiers modifiers = Qt::NoModifier) {
        const QPointF pos = m_field->rect().center();
        QWheelEvent event(pos, m_field->mapToGlobal(pos), QPoint(), QPoint(0, angle), Qt::NoButton, modifiers,
                          Qt::NoScrollPhase, false);
        event.ignore();
        QApplication::sendEvent(m_field, &event);
        return event.isAccepted();
    }

    std::unique_ptr<QWidget> m_window;
    NumberField* m_field = nullptr;
    QLineEdit* m_other = nullptr;
    std::unique_ptr<QSignalSpy> m_edited;
    std::unique_ptr<QSignalSpy> m_rejected;
};

QTEST_MAIN(TestNumberField)
#include "tst_number_field.moc"
