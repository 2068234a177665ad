// The stability of the step in the panel Simulation: true after every edit, undo and opening.
#include "tests/gui/test_window.h"

#include "app/docks/stability_readout.h"
#include "app/widgets/theme.h"

#include <QLabel>

using namespace clothlab;

class TestStabilityReadout : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { m_window.reset(); }

    void itFollowsAnEditAndItsUndo();
    void itFollowsEveryParameterThatCounts_data();
    void itFollowsEveryParameterThatCounts();
    void itFollowsABoxOfSprings();
    void itFollowsOpeningAndNew();
    void unstableIsSaidNotOnlyInColour();
    void itIsReadableInBothThemesAndNotClipped();
    void theStepsThatItNamesAreStable();
    void openingWarnsOfAnUnstableStep();

private:
    StabilityReadout* readout() { return (*m_window)->simulationPanel().stabilityReadout(); }
    QString shown() { return readout()->dtOmegaText() + ", from " + readout()->stepsText(); }
    // What it has to show.
    QString expected() {
        const Stability found = stability(m_window->scene());
        return QString("%1 of %2%3, from %4 step%5 per frame")
            .arg(found.dtOmega, 0, 'f', 2)
            .arg(found.limit, 0, 'f', 2)
            .arg(found.stable() ? "" : " – unstable")
            .arg(found.stableStepsPerFrame.value_or(0))
            .arg(found.stableStepsPerFrame == 1 ? "" : "s");
    }
    void enter(const char* parameter, const QString& text) {
        m_window->typeInto(m_window->field(parameter), text);
        m_window->key(Qt::Key_Return);
    }
    QList<QLabel*> labels() { return readout()->findChildren<QLabel*>(); }
    bool hasSign() {
        return std::ranges::any_of(labels(),
                                   [](QLabel* l) { return l->isVisible() && !l->pixmap().isNull(); });
    }
    QLabel* labelWith(const QString& text) {
        for (QLabel* label : labels())
            if (label->text() == text)
                return label;
        return nullptr;
    }

    std::unique_ptr<TestWindow> m_window;
};

void TestStabilityReadout::init() {
    m_window = std::make_unique<TestWindow>();
    QVERIFY(m_window->load(smallScene()));
    QCOMPARE(shown(), expected());
}

void TestStabilityReadout::itFollowsAnEditAndItsUndo() {
    const QString before = shown();
    enter("cloth.ks", "500000");
    const QString after = shown();
    QCOMPARE(after, expected());
    QVERIFY(after != before);
    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(shown(), before);
    m_window->key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
    QCOMPARE(shown(), after);
}

void TestStabilityReadout::itFollowsEveryParameterThatCounts_data() {
    QTest::addColumn<QByteArray>("parameter");
    QTest::addColumn<QString>("value");
    const auto row = [](const char* parameter, const char* value) {
        QTest::newRow(parameter) << QByteArray(parameter) << QString(value);
    };
    row("cloth.ks", "20000");
    row("cloth.density", "1");
    row("cloth.damping", "50");
    row("simulation.frames_per_second", "24");
    row("simulation.steps_per_frame", "1");
    row("cloth.width", "0.1");
    row("cloth.height", "0.1");
    row("cloth.num_width_points", "60");
    row("cloth.num_height_points", "60");
}

void TestStabilityReadout::itFollowsEveryParameterThatCounts() {
    QFETCH(QByteArray, parameter);
    QFETCH(QString, value);
    const QString before = shown();
    enter(parameter, value);
    QCOMPARE(shown(), expected());
    QVERIFY2(shown() != before, qPrintable(before));
}

void TestStabilityReadout::itFollowsABoxOfSprings() {
    const QString before = shown();
    QCheckBox* box = (*m_window)->simulationPanel().checkBox("cloth.enable_shearing");
    m_window->click(box, {8, box->height() / 2});
    QCOMPARE(shown(), expected());
    QVERIFY(shown() != before);
}

void TestStabilityReadout::itFollowsOpeningAndNew() {
    Scene scene = smallScene();
    scene.cloth.ks = 3e6;
    QVERIFY(m_window->load(scene));
    QCOMPARE(shown(), expected());
    const QString opened = shown();
    m_window->document().newScene();
    QCOMPARE(shown(), expected());
    QVERIFY(shown() != opened);
}

void TestStabilityReadout::unstableIsSaidNotOnlyInColour() {
    QVERIFY(!hasSign());
    QVERIFY(!shown().contains("unstable"));
    enter("simulation.steps_per_frame", "1");
    enter("cloth.ks", "1e6");
    QVERIFY(hasSign());
    QVERIFY(readout()->dtOmegaText().endsWith("unstable"));
    QVERIFY(readout()->accessibleName().contains("unstable"));
    QCOMPARE(labelWith(readout()->dtOmegaText())->palette().color(QPalette::WindowText),
             themeColors().warning);
    enter("cloth.ks", "0");
    QVERIFY(!hasSign());
    QCOMPARE(shown(), QStringLiteral("0.00 of 2.00, from 1 step per frame"));
    QVERIFY(labelWith(readout()->dtOmegaText())->palette().color(QPalette::WindowText) !=
            themeColors().warning);
}

void TestStabilityReadout::itIsReadableInBothThemesAndNotClipped() {
    enter("simulation.frames_per_second", "1");
    enter("simulation.steps_per_frame", "1");
    enter("cloth.density", "1e-7"); // the lightest
    enter("cloth.ks", "1e9");
    QVERIFY2(readout()->stepsText().contains("up to 100000"), qPrintable(shown()));
    QCOMPARE(m_window->document().undoStack().count(), 4);
    for (const Theme theme : {Theme::Light, Theme::Dark}) {
        applyTheme(*qApp, theme);
        QCoreApplication::processEvents();
        QCOMPARE(labelWith(readout()->dtOmegaText())->palette().color(QPalette::WindowText),
                 themeColors(theme).warning);
        for (QLabel* label : labels()) {
            const int needed =
                label->wordWrap() ? label->heightForWidth(label->width()) : label->sizeHint().height();
            QVERIFY2(label->height() >= needed, qPrintable(label->text()));
            const QRect text = label->fontMetrics().boundingRect(
                QRect(0, 0, label->width(), 1000), label->wordWrap() ? Qt::TextWordWrap : 0, label->text());
            QVERIFY2(text.width() <= label->width(), qPrintable(label->text()));
            QVERIFY(readout()->rect().contains(QRect(label->mapTo(readout(), QPoint()), label->size())));
        }
    }
}

void TestStabilityReadout::theStepsThatItNamesAreStable() {
    enter("cloth.ks", "3e7");
    QVERIFY(readout()->dtOmegaText().endsWith("unstable"));
    enter("simulation.steps_per_frame", readout()->stepsText().section(' ', 0, 0));
    QVERIFY2(!readout()->dtOmegaText().contains("unstable"), qPrintable(shown()));
}

void TestStabilityReadout::openingWarnsOfAnUnstableStep() {
    QVERIFY(!m_window->output().contains("dt·ω"));
    Scene scene = smallScene();
    scene.cloth.ks = 3e7;
    QVERIFY(m_window->load(scene));
    const QString words =
        QString("dt·ω is %1, beyond 2.00 where the step becomes unstable; %2 steps per frame")
            .arg(stability(scene).dtOmega, 0, 'f', 1)
            .arg(*stability(scene).stableStepsPerFrame);
    QVERIFY2(m_window->output().contains(words), qPrintable(m_window->output()));
}

CLOTHLAB_GUI_TEST_MAIN(TestStabilityReadout)
#include "tst_stability_readout.moc"
