// Numbers and boxes of the panels: what is typed, dragged or ticked is in the document.
#include "tests/gui/dialog_answer.h"
#include "tests/gui/test_window.h"

#include "app/widgets/drag_label.h"

#include <QCheckBox>
#include <QComboBox>

using namespace clothlab;

class TestParameters : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { m_window.reset(); }

    void everyTypedNumberIsTakenByEnter();
    void everyTypedNumberIsTakenWhenTheFieldLosesTheFocus();
    void everyBoxIsTakenByAClick();
    void unitsOfThePanelAreTurnedIntoThoseOfTheFile();
    void expressionsAreComputed();
    void saveTakesWhatIsBeingTyped();
    void closingAsksAboutWhatIsBeingTyped();
    void escapeDropsWhatIsBeingTyped();
    void theLabelIsDraggedSidewaysAndItsDoubleClickRestoresTheDefault();
    void valuesOutOfRangeAreRefusedInWords();
    void nonsenseIsRefusedInWords();
    void aSmallerSheetKeepsItsPins();
    void whatIsTypedIsTakenBeforeACommandIsCarriedOut();
    void enterTicksABox();
    void drawnSpringsAndSpringsThatPullAreTwoThings();
    void countsOfSpringsAreThoseOfTheSheet();
    void bothShaderSelectorsShowTheSame();
    void aShaderThatIsNotThereIsListed();

private:
    const Parameter& parameterOf(const ParameterRow* row) {
        return *findParameter(row->objectName().toStdString());
    }
    // Another number in its range that all parameters can take.
    double another(const ParameterRow* row) { return row->value() + (row->value() < 10 ? 1 : -1); }

    std::unique_ptr<TestWindow> m_window;
};

void TestParameters::init() {
    m_window = std::make_unique<TestWindow>();
    QVERIFY(m_window->load(smallScene()));
}

void TestParameters::everyTypedNumberIsTakenByEnter() {
    const auto rows = (*m_window)->simulationPanel().findChildren<ParameterRow*>();
    QVERIFY(rows.size() >= 10);
    for (ParameterRow* row : rows) {
        const Parameter& parameter = parameterOf(row);
        const double value = parameter.id == "cloth.thickness" ? 0.01 : another(row);
        m_window->typeInto(row->field(), QString::number(value, 'g', 17));
        m_window->key(Qt::Key_Return);
        QVERIFY2(qFuzzyCompare(1 + parameter.get(m_window->scene()), 1 + value * parameter.panelDivisor),
                 qPrintable(row->objectName()));
        QCOMPARE(row->value(), value);
    }
}

void TestParameters::everyTypedNumberIsTakenWhenTheFieldLosesTheFocus() {
    for (ParameterRow* row : (*m_window)->simulationPanel().findChildren<ParameterRow*>()) {
        const Parameter& parameter = parameterOf(row);
        const double value = parameter.id == "cloth.thickness" ? 0.01 : another(row);
        m_window->typeInto(row->field(), QString::number(value, 'g', 17));
        m_window->click(&m_window->viewport(), {20, 20});
        QVERIFY(!row->field()->hasFocus());
        QVERIFY2(qFuzzyCompare(1 + parameter.get(m_window->scene()), 1 + value * parameter.panelDivisor),
                 qPrintable(row->objectName()));
    }
}

void TestParameters::everyBoxIsTakenByAClick() {
    const auto boxes = (*m_window)->simulationPanel().findChildren<QCheckBox*>();
    QCOMPARE(boxes.size(), 4);
    for (QCheckBox* box : boxes) {
        const Parameter& parameter = *findParameter(box->objectName().toStdString());
        const bool before = parameter.get(m_window->scene()) != 0;
        QCOMPARE(box->isChecked(), before);
        m_window->click(box, {8, box->height() / 2});
        QCOMPARE(parameter.get(m_window->scene()) != 0, !before);
        QCOMPARE(box->isChecked(), !before);
    }
}

void TestParameters::unitsOfThePanelAreTurnedIntoThoseOfTheFile() {
    m_window->typeInto(m_window->field("cloth.density"), "20");
    m_window->key(Qt::Key_Return);
    QCOMPARE(m_window->scene().cloth.density, 200.0); // 20 g/cm² in kg/m²
    QCOMPARE(m_window->field("cloth.density")->unit(), QString::fromUtf8("g/cm²"));
    QCOMPARE(m_window->field("cloth.damping")->unit(), QStringLiteral("%"));
}

void TestParameters::expressionsAreComputed() {
    m_window->typeInto(m_window->field("cloth.ks"), "2*(300+20)");
    m_window->key(Qt::Key_Return);
    QCOMPARE(m_window->scene().cloth.ks, 640.0);
}

void TestParameters::saveTakesWhatIsBeingTyped() {
    m_window->typeInto(m_window->field("cloth.ks"), "1234");
    m_window->key(Qt::Key_S, Qt::ControlModifier);
    QCOMPARE(m_window->scene().cloth.ks, 1234.0);
    QVERIFY(!m_window->document().isModified());
    const SceneReading reading = loadScene(m_window->document().path().toStdString());
    QVERIFY(reading.scene);
    QCOMPARE(reading.scene->cloth.ks, 1234.0);
}

void TestParameters::closingAsksAboutWhatIsBeingTyped() {
    m_window->typeInto(m_window->field("cloth.ks"), "1234");
    DialogAnswer answer(QMessageBox::Cancel);
    QVERIFY(!(*m_window)->close());
    QVERIFY(answer.asked());
    QCOMPARE(m_window->scene().cloth.ks, 1234.0);
}

void TestParameters::escapeDropsWhatIsBeingTyped() {
    NumberField* field = m_window->field("cloth.ks");
    m_window->typeInto(field, "1234");
    m_window->key(Qt::Key_Escape);
    QCOMPARE(field->text(), QStringLiteral("5000"));
    m_window->click(&m_window->viewport(), {20, 20});
    QCOMPARE(m_window->scene().cloth.ks, 5000.0);
}

void TestParameters::theLabelIsDraggedSidewaysAndItsDoubleClickRestoresTheDefault() {
    ParameterRow* row = (*m_window)->simulationPanel().row("cloth.damping");
    auto* label = row->findChild<DragLabel*>();
    const QPoint start(10, label->height() / 2);
    m_window->drag(label, start, start + QPoint(80, 0));
    QVERIFY(m_window->scene().cloth.damping > 0.2);
    QCOMPARE(m_window->document().undoStack().count(), 1);
    m_window->doubleClick(label, start);
    QCOMPARE(m_window->scene().cloth.damping, 0.2);
}

void TestParameters::valuesOutOfRangeAreRefusedInWords() {
    NumberField* field = m_window->field("cloth.damping");
    m_window->typeInto(field, "101");
    m_window->key(Qt::Key_Return);
    QCOMPARE(m_window->scene().cloth.damping, 0.2);
    QVERIFY2(m_window->output().contains("from 0 % to 100 %"), qPrintable(m_window->output()));
    QVERIFY((*m_window)->statusBar()->currentMessage().contains("101"));
    m_window->click(&m_window->viewport(), {20, 20});
    QCOMPARE(field->text(), QStringLiteral("0.2"));
}

void TestParameters::nonsenseIsRefusedInWords() {
    m_window->typeInto(m_window->field("cloth.ks"), "soft");
    m_window->key(Qt::Key_Return);
    QCOMPARE(m_window->scene().cloth.ks, 5000.0);
    QVERIFY(m_window->output().contains("soft"));
    QVERIFY(m_window->output().contains("not a number"));
}

void TestParameters::aSmallerSheetKeepsItsPins() {
    NumberField* field = m_window->field("cloth.num_width_points");
    m_window->typeInto(field, "3"); // and (5, 0) is pinned
    m_window->key(Qt::Key_Return);
    QCOMPARE(m_window->scene().cloth.numWidthPoints, 3);
    QCOMPARE(m_window->scene().cloth.pinned.back(), (GridPoint{2, 0}));
}

void TestParameters::whatIsTypedIsTakenBeforeACommandIsCarriedOut() {
    m_window->typeInto(m_window->field("cloth.ks"), "800");
    m_window->key(Qt::Key_Space);
    QCOMPARE(m_window->scene().cloth.ks, 800.0);
    (*m_window)->simulation().pause();
}

void TestParameters::enterTicksABox() {
    QCheckBox* box = (*m_window)->simulationPanel().checkBox("cloth.enable_bending");
    box->setFocus();
    m_window->key(Qt::Key_Return);
    QVERIFY(!m_window->scene().cloth.enableBending);
    m_window->key(Qt::Key_Return);
    QVERIFY(m_window->scene().cloth.enableBending);
}

void TestParameters::drawnSpringsAndSpringsThatPullAreTwoThings() {
    Scene scene = smallScene();
    scene.appearance.shader = "Wireframe";
    QVERIFY(m_window->load(scene));
    QCheckBox* drawn = (*m_window)->springsPanel().typeBox(SpringType::Bending);
    m_window->click(drawn, {8, drawn->height() / 2});
    QVERIFY(!m_window->scene().appearance.springsDrawn[2]);
    QVERIFY(m_window->scene().cloth.enableBending);
    QCheckBox* pulls = (*m_window)->simulationPanel().checkBox("cloth.enable_shearing");
    m_window->click(pulls, {8, pulls->height() / 2});
    QVERIFY(!m_window->scene().cloth.enableShearing);
    QVERIFY(m_window->scene().appearance.springsDrawn[1]);
}

void TestParameters::countsOfSpringsAreThoseOfTheSheet() {
    QStringList shown;
    for (const QLabel* label : (*m_window)->springsPanel().findChildren<QLabel*>())
        shown << label->text();
    // 6 × 6 points: 2·6·5 structural, 2·5·5 shearing, 2·6·4 bending.
    for (const char* count : {"60", "50", "48", "158"})
        QVERIFY2(shown.contains(count), count);
}

void TestParameters::bothShaderSelectorsShowTheSame() {
    const QList<QComboBox*> boxes{(*m_window)->findChild<QComboBox*>("shaderSelector"),
                                  (*m_window)->appearancePanel().shaderBox()};
    for (const char* shader : {"Wireframe", "Normal", "Diffuse", "Phong"})
        QVERIFY2(boxes[0]->findText(shader) >= 0 && boxes[1]->findText(shader) >= 0, shader);
    boxes[0]->setFocus();
    m_window->key(Qt::Key_Up);
    QCOMPARE(boxes[0]->currentText(), boxes[1]->currentText());
    QCOMPARE(boxes[0]->currentText().toStdString(), m_window->scene().appearance.shader);
    boxes[1]->setFocus();
    m_window->key(Qt::Key_Up);
    QCOMPARE(boxes[0]->currentText(), boxes[1]->currentText());
}

void TestParameters::aShaderThatIsNotThereIsListed() {
    QComboBox* own = (*m_window)->appearancePanel().shaderBox();
    const int count = own->count();
    Scene scene = smallScene();
    scene.appearance.shader = "Velvet";
    QVERIFY(m_window->load(scene));
    auto* selector = (*m_window)->findChild<QComboBox*>("shaderSelector");
    for (QComboBox* box : {own, selector}) {
        QCOMPARE(box->currentText(), QStringLiteral("Velvet"));
        QCOMPARE(box->count(), count + 1);
    }
    m_window->document().newScene();
    for (QComboBox* box : {own, selector}) {
        QCOMPARE(box->currentText(), QStringLiteral("Phong"));
        QCOMPARE(box->count(), count);
    }
}

CLOTHLAB_GUI_TEST_MAIN(TestParameters)
#include "tst_parameters.moc"
