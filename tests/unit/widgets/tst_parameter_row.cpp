#include "app/widgets/drag_label.h"
#include "app/widgets/number_field.h"
#include "app/widgets/parameter_row.h"
#include "app/widgets/theme.h"
#include "app/widgets/value_slider.h"

#include <QApplication>
#include <QSignalSpy>
#include <QStyle>
#include <QTest>
#include <QVBoxLayout>
#include <QWheelEvent>

#include <memory>

using namespace clothlab;

class TestParameterRow : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { applyTheme(*qApp, Theme::Dark); }

    void init() {
        build({.label = "Density",
               .unit = "kg/m²",
               .toolTip = "density in kg/m²",
               .minimum = 0,
               .maximum = 10,
               .sliderMinimum = 0,
               .sliderMaximum = 1,
               .defaultValue = 0.3});
    }

    void cleanup() {
        m_edited.reset();
        m_window.reset();
    }

    void showsTheDefaultAtFirst() {
        QCOMPARE(m_row->value(), 0.3);
        QCOMPARE(slider()->value(), 300);
        QCOMPARE(m_edited->count(), 0);
    }

    void setValueIsSilent() {
        m_row->setValue(0.75);
        QCOMPARE(m_row->field()->text(), QStringLiteral("0.75"));
        QCOMPARE(slider()->value(), 750);
        m_row->setValue(5); // beyond the slider, within the range
        QCOMPARE(slider()->value(), 1000);
        QCOMPARE(m_row->value(), 5.0);
        QCOMPARE(m_edited->count(), 0);
    }

    void typedValuesStandAlone() {
        type("0.5");
        type("0.6");
        QCOMPARE(m_edited->count(), 2);
        QCOMPARE(value(0), 0.5);
        QCOMPARE(value(1), 0.6);
        QCOMPARE(gesture(0), 0);
        QCOMPARE(gesture(1), 0);
        QCOMPARE(slider()->value(), 600);
    }

    void rejectionIsPassedOn() {
        QSignalSpy rejected(m_row, &ParameterRow::rejected);
        type("11");
        QCOMPARE(rejected.count(), 1);
        QVERIFY(rejected.at(0).at(0).toString().contains(QStringLiteral("10 kg/m²")));
        QCOMPARE(m_row->value(), 0.3);
    }

    void stepsAreOneGestureUntilFocusIsLost() {
        m_row->field()->setFocus();
        QTest::keyClick(m_row->field(), Qt::Key_Up);
        wheel(120);
        wheel(120);
        QCOMPARE(m_edited->count(), 3);
        QVERIFY(gesture(0) != 0);
        QCOMPARE(gesture(1), gesture(0));
        QCOMPARE(gesture(2), gesture(0));
        m_other->setFocus();
        m_row->field()->setFocus();
        QTest::keyClick(m_row->field(), Qt::Key_Up);
        QVERIFY(gesture(3) != gesture(0));
        QVERIFY(gesture(3) != 0);
    }

    void stepsAfterTypingOrUndoAreAnotherGesture() {
        m_row->field()->setFocus();
        QTest::keyClick(m_row->field(), Qt::Key_Up);
        type("0.5");
        QTest::keyClick(m_row->field(), Qt::Key_Up);
        QCOMPARE(gesture(1), 0);
        QVERIFY(gesture(2) != gesture(0));
        m_row->setValue(m_row->value()); // the document's echo
        QTest::keyClick(m_row->field(), Qt::Key_Up);
        QCOMPARE(gesture(3), gesture(2));
        m_row->setValue(0.5); // undone
        QTest::keyClick(m_row->field(), Qt::Key_Up);
        QVERIFY(gesture(4) != gesture(2));
    }

    void sliderDragIsOneGesture() {
        const QPoint start = handle() + QPoint(3, 0); // beside its middle
        QTest::mousePress(slider(), Qt::LeftButton, {}, start);
        QTest::mouseMove(slider(), start);
        QCOMPARE(m_edited->count(), 0); // taking the handle changes nothing
        QTest::mouseMove(slider(), start + QPoint(20, 0));
        m_row->setValue(m_row->value());
        QTest::mouseMove(slider(), start + QPoint(40, 0));
        QTest::mouseRelease(slider(), Qt::LeftButton, {}, start + QPoint(40, 0));
        QCOMPARE(m_edited->count(), 2);
        QVERIFY(value(0) > 0.3);
        // 40 pixels of what the handle can travel.
        QVERIFY(qAbs(value(1) - (0.3 + 40.0 / (slider()->width() - 10))) < 0.0011);
        QCOMPARE(m_row->value(), value(1));
        QVERIFY(gesture(0) != 0);
        QCOMPARE(gesture(0), gesture(1));
        QTest::mouseMove(slider(), start); // released: nothing follows
        QCOMPARE(m_edited->count(), 2);

        QTest::mouseClick(slider(), Qt::LeftButton, {}, {2, slider()->height() / 2});
        QCOMPARE(m_edited->count(), 3);
        QCOMPARE(value(2), 0.0);
        QVERIFY(gesture(2) != gesture(0));
    }

    void sliderIgnoresWheelAndKeys() {
        QWheelEvent event(QPointF(5, 5), slider()->mapToGlobal(QPointF(5, 5)), {}, {0, 120}, Qt::NoButton,
                          Qt::NoModifier, Qt::NoScrollPhase, false);
        QApplication::sendEvent(slider(), &event);
        QVERIFY(!event.isAccepted());
        QTest::keyClick(slider(), Qt::Key_Right);
        QCOMPARE(m_edited->count(), 0);
    }

    void sliderTakesWhatWasTypedFirst() {
        m_row->field()->setFocus();
        m_row->field()->selectAll();
        QTest::keyClicks(m_row->field(), QStringLiteral("0.9"));
        QTest::mouseClick(slider(), Qt::LeftButton, {}, {2, slider()->height() / 2});
        QCOMPARE(m_edited->count(), 2);
        QCOMPARE(value(0), 0.9);
        QCOMPARE(gesture(0), 0);
        QCOMPARE(value(1), 0.0);
        QVERIFY(gesture(1) != 0);
        QCOMPARE(m_row->field()->text(), QStringLiteral("0"));
    }

    void labelDragIsOneGesture() {
        dragLabel({20, 30});
        QCOMPARE(m_edited->count(), 2);
        QVERIFY(qAbs(value(0) - 0.5) < 1e-12); // 20 px of a hundredth each
        QVERIFY(qAbs(value(1) - 0.6) < 1e-12);
        QVERIFY(gesture(0) != 0);
        QCOMPARE(gesture(0), gesture(1));
        dragLabel({-5});
        QVERIFY(qAbs(value(2) - 0.55) < 1e-12);
        QVERIFY(gesture(2) != gesture(0));
    }

    // Some parameters are 0 or at least something.
    void stepsAndDragsPassOverWhatIsBelowTheLeast() {
        build({.label = "Cells",
               .minimum = 0,
               .maximum = 512,
               .leastButZero = 16,
               .sliderMinimum = 0,
               .sliderMaximum = 512,
               .defaultValue = 0,
               .integer = true});
        m_row->field()->setFocus();
        for (const auto& [key, expected] : std::initializer_list<std::pair<Qt::Key, double>>{
                 {Qt::Key_Up, 16}, {Qt::Key_Up, 17}, {Qt::Key_Down, 16}, {Qt::Key_Down, 0}}) {
            QTest::keyClick(m_row->field(), key);
            QCOMPARE(m_row->value(), expected);
            QCOMPARE(m_edited->last().at(0).toDouble(), expected);
        }
        QCOMPARE(m_row->field()->text(), QStringLiteral("0"));
        QCOMPARE(gesture(0), gesture(3)); // one run of steps
        dragLabel({7, 9, 40});
        QCOMPARE(m_edited->count(), 6); // 7 is still 0
        QCOMPARE(value(4), 16.0);
        QCOMPARE(value(5), 40.0);
        type("5"); // whoever types is told
        QCOMPARE(value(6), 5.0);
    }

    void labelDragStaysInRange() {
        dragLabel({-500});
        QCOMPARE(m_row->value(), 0.0);
        dragLabel({5000});
        QCOMPARE(m_row->value(), 10.0);
    }

    void labelDragOverRejectedTextShows() {
        type("99");
        QCOMPARE(m_row->field()->text(), QStringLiteral("99"));
        dragLabel({20});
        QCOMPARE(m_row->field()->text(), QStringLiteral("0.5"));
    }

    void doubleClickRestoresTheDefault() {
        m_row->setValue(0.9);
        QTest::mouseDClick(label(), Qt::LeftButton);
        QCOMPARE(m_edited->count(), 1);
        QCOMPARE(value(0), 0.3);
        QCOMPARE(gesture(0), 0);
        QTest::mouseDClick(label(), Qt::LeftButton);
        QCOMPARE(m_edited->count(), 1); // nothing left to restore
    }

    void clickOnTheLabelChangesNothing() {
        QTest::mouseClick(label(), Qt::LeftButton);
        QCOMPARE(m_edited->count(), 0);
    }

    void dotShowsAChangedValue() {
        const QImage same = m_row->grab().toImage();
        const QRect right(same.width() - 8, 0, 8, same.height());
        const auto accent = [&](const QImage& image) {
            const QImage part = image.copy(right);
            for (int y = 0; y < part.height(); ++y) {
                for (int x = 0; x < part.width(); ++x) {
                    if (part.pixelColor(x, y) == themeColors().accent) {
                        return true;
                    }
                }
            }
            return false;
        };
        QVERIFY(!accent(same));
        m_row->setValue(0.4);
        QVERIFY(accent(m_row->grab().toImage()));
        m_row->setValue(0.3);
        QVERIFY(!accent(m_row->grab().toImage()));
    }

    void disabledSaysWhy() {
        m_row->setDisabledReason(QStringLiteral("The recording is being written."));
        QVERIFY(!m_row->isEnabled());
        for (QWidget* part : {static_cast<QWidget*>(m_row), static_cast<QWidget*>(m_row->field()),
                              static_cast<QWidget*>(slider()), static_cast<QWidget*>(label())}) {
            QVERIFY(part->toolTip().contains(QStringLiteral("being written")));
            QVERIFY(part->toolTip().contains(QStringLiteral("density")));
        }
        dragLabel({50});
        QCOMPARE(m_edited->count(), 0);
        m_row->setDisabledReason({});
        QVERIFY(m_row->isEnabled());
        QCOMPARE(m_row->field()->toolTip(), QStringLiteral("density in kg/m²"));
    }

    void hasAccessibleNames() {
        QCOMPARE(m_row->field()->accessibleName(), QStringLiteral("Density"));
        QVERIFY(slider()->accessibleName().contains(QStringLiteral("Density")));
    }

    void logarithmicScale() {
        build({.label = "Stiffness",
               .minimum = 0,
               .maximum = 1e9,
               .sliderMinimum = 1,
               .sliderMaximum = 1e6,
               .defaultValue = 1000,
               .logarithmic = true});
        QCOMPARE(slider()->value(), 500);
        QCOMPARE(slider()->valueAt(0), 1.0);
        QCOMPARE(slider()->valueAt(1000), 1e6);
        QCOMPARE(slider()->valueAt(500), 1000.0);
        m_row->setValue(0); // has no place on it
        QCOMPARE(slider()->value(), 0);
        QCOMPARE(m_row->value(), 0.0);
        m_row->setValue(1000);
        dragLabel({50}); // a decade
        QCOMPARE(m_row->value(), 10000.0);
    }

    void integerScale() {
        build({.label = "Substeps",
               .minimum = 1,
               .maximum = 1000,
               .sliderMinimum = 1,
               .sliderMaximum = 64,
               .defaultValue = 30,
               .integer = true});
        for (int position = 0; position <= 1000; ++position) {
            const double value = slider()->valueAt(position);
            QVERIFY(value == int(value));
        }
        dragLabel({7});
        QCOMPARE(m_row->value(), int(m_row->value()) * 1.0);
        QVERIFY(m_row->value() >= 30);
    }

    void withoutSlider() {
        build({.label = "Seed", .defaultValue = 1, .slider = false});
        QVERIFY(slider() == nullptr);
        type("5");
        QCOMPARE(m_row->value(), 5.0);
    }

private:
    void build(const ParameterSpec& spec) {
        cleanup();
        m_window = std::make_unique<QWidget>();
        auto* layout = new QVBoxLayout(m_window.get());
        m_row = new ParameterRow(spec);
        m_other = new QLineEdit;
        layout->addWidget(m_row);
        layout->addWidget(m_other);
        m_window->resize(500, 80);
        m_window->show();
        m_window->activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
        m_other->setFocus();
        m_edited = std::make_unique<QSignalSpy>(m_row, &ParameterRow::edited);
    }

    ValueSlider* slider() const { return m_row->findChild<ValueSlider*>(); }
    DragLabel* label() const { return m_row->findChild<DragLabel*>(); }
    double value(int edit) const { return m_edited->at(edit).at(0).toDouble(); }
    int gesture(int edit) const { return m_edited->at(edit).at(1).toInt(); }

    void type(const QString& text) {
        m_row->field()->setFocus();
        m_row->field()->selectAll();
        QTest::keyClicks(m_row->field(), text);
        QTest::keyClick(m_row->field(), Qt::Key_Return);
    }

    void wheel(int angle) {
        const QPointF pos = m_row->field()->rect().center();
        QWheelEvent event(pos, m_row->field()->mapToGlobal(pos), {}, {0, angle}, Qt::NoButton, Qt::NoModifier,
                          Qt::NoScrollPhase, false);
        QApplication::sendEvent(m_row->field(), &event);
    }

    // Within the handle.
    QPoint handle() const {
        const int length = 10; // as the style sheet has it
        const int x = QStyle::sliderPositionFromValue(0, 1000, slider()->value(), slider()->width() - length);
        return {x + length / 2, slider()->height() / 2};
    }

    // To each of `pixels` right of where the drag began, after the distance that makes it one.
    void dragLabel(const QList<int>& pixels) {
        const QPoint press = label()->rect().center();
        const QPoint begin = press + QPoint(QApplication::startDragDistance(), 0);
        QTest::mousePress(label(), Qt::LeftButton, {}, press);
        QTest::mouseMove(label(), begin);
        for (const int x : pixels) {
            QTest::mouseMove(label(), begin + QPoint(x, 0));
        }
        QTest::mouseRelease(label(), Qt::LeftButton, {}, begin + QPoint(pixels.last(), 0));
    }

    std::unique_ptr<QWidget> m_window;
    ParameterRow* m_row = nullptr;
    QLineEdit* m_other = nullptr;
    std::unique_ptr<QSignalSpy> m_edited;
};

QTEST_MAIN(TestParameterRow)
#include "tst_parameter_row.moc"
