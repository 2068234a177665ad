// The panel Appearance: every control changes the look and nothing else, by one step that can be undone, and
// shows what the scene has.
#include "tests/gui/dialog_answer.h"
#include "tests/gui/test_window.h"

#include "app/widgets/button_row.h"
#include "simcore/inspect/inspect.h"

#include <QCheckBox>
#include <QColorDialog>
#include <QComboBox>

#include <functional>

using namespace clothlab;

namespace {

struct Control {
    QString name;
    std::function<void()> change;   // by hand
    std::function<QString()> shown; // what the widget shows
};

QString shownBy(ButtonRow* row) {
    return row->button()->text() + (row->resetButton()->isVisible() ? " and back" : "");
}

// A look of which nothing is at its default.
Scene colourfulScene(const QString& folder) {
    Scene scene = smallScene();
    Appearance& look = scene.appearance;
    look.shader = "Mirror";
    look.color = {0.2, 0.4, 0.6};
    look.backColor = Rgb{1, 0, 0};
    look.background = Rgb{0, 0, 1};
    look.twoSided = look.shadows = look.groundGrid = look.axes = false;
    look.springsOverSurface = true;
    look.springColoring = SpringColoring::ByStrain;
    look.springsDrawn = {false, false, false};
    look.strainRange = 0.25;
    look.lightPosition = {1, 3, 4};
    look.lightIntensity = {5, 6, 7};
    look.samples = 8;
    look.meshResolution = 64;
    look.normalScaling = 3;
    look.heightScaling = 0.5;
    for (std::string& texture : look.textures)
        texture = (folder + "/cloth.png").toStdString();
    look.cubemap = (folder + "/sky").toStdString();
    return scene;
}

} // namespace

class TestAppearance : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { m_window.reset(); }

    void everyControlIsOneStepOfTheLook();
    void everyControlShowsTheSceneThatIsOpened();
    void theColoursOfOneVisitAreOneStep();
    void coloursGoBackToTheirDefault();
    void filesAreChosenAndGoBackToTheirDefault();
    void aChooserThatIsCancelledChangesNothing();
    void filesAreKeptRelativeToTheScene();
    void theSamplesAreThoseThatThereAre();
    void theRangeOfStrainFitsTheRecording();
    void aMeshTooCoarseIsRefusedInWords();
    void stepsAndDragsPassOverMeshesTooCoarse();
    void theLookDoesNotDisturbARun();

private:
    AppearancePanel& panel() { return (*m_window)->appearancePanel(); }
    const Appearance& look() { return m_window->scene().appearance; }
    int steps() { return m_window->document().undoStack().index(); }
    void undo() { m_window->key(Qt::Key_Z, Qt::ControlModifier); }
    NumberField* field(const char* id) { return panel().row(id)->field(); }
    QList<Control> controls();
    QStringList shown() {
        QStringList all;
        for (const Control& control : controls())
            all << control.name + ": " + control.shown();
        return all;
    }
    // By hand, in the chooser of that row.
    void chooseColor(ColorRow* row, std::initializer_list<const char*> colors) {
        m_window->click(row->button());
        auto* dialog = row->findChild<QColorDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        for (const char* color : colors)
            dialog->setCurrentColor(QColor(color));
        QTest::keyClick(dialog, Qt::Key_Escape);
        QVERIFY(!dialog->isVisible());
    }
    void chooseFileFor(FileRow* row, const QString& path) {
        const DialogAnswer answer(chooseFile(path));
        m_window->click(row->button());
        QVERIFY(answer.asked());
    }

    std::unique_ptr<TestWindow> m_window;
};

void TestAppearance::init() {
    m_window = std::make_unique<TestWindow>();
    QVERIFY(m_window->load(smallScene()));
    QImage image(4, 4, QImage::Format_RGB32);
    image.fill(Qt::red);
    QVERIFY(image.save(m_window->path("cloth.png")));
    QVERIFY(QDir(m_window->path(".")).mkdir("sky"));
    m_window->unfoldAll();
}

QList<Control> TestAppearance::controls() {
    QList<Control> found;
    for (ParameterRow* row : panel().findChildren<ParameterRow*>())
        found << Control{row->objectName(),
                         [this, row] {
                             m_window->click(row->field());
                             m_window->key(Qt::Key_Up);
                         },
                         [row] { return row->field()->text(); }};
    for (QCheckBox* box : panel().findChildren<QCheckBox*>())
        found << Control{box->objectName(),
                         [this, box] {
                             m_window->click(box, {8, box->height() / 2});
                         },
                         [box] { return QString::number(box->isChecked()); }};
    for (QComboBox* box : panel().findChildren<QComboBox*>())
        found << Control{box->accessibleName(),
                         [this, box] {
                             box->setFocus();
                             m_window->key(box->currentIndex() > 0 ? Qt::Key_Up : Qt::Key_Down);
                         },
                         [box] { return box->currentText(); }};
    for (ColorRow* row : panel().findChildren<ColorRow*>())
        found << Control{row->button()->accessibleName(), [this, row] { chooseColor(row, {"#102030"}); },
                         [row] { return shownBy(row); }};
    for (FileRow* row : panel().findChildren<FileRow*>()) {
        const bool folder = row == panel().cubemapRow();
        found << Control{
            row->button()->accessibleName(),
            [this, row, folder] { chooseFileFor(row, m_window->path(folder ? "sky" : "cloth.png")); },
            [row] { return shownBy(row); }};
    }
    return found;
}

void TestAppearance::everyControlIsOneStepOfTheLook() {
    const QList<Control> all = controls();
    QCOMPARE(all.size(), qsizetype(10 + 4 + 2 + 3 + 5)); // fields, boxes, lists, colours, files
    for (const Control& control : all) {
        const Scene before = m_window->scene();
        const QString shownBefore = control.shown();
        const int index = m_window->document().undoStack().index();
        control.change();
        QVERIFY2(!QTest::currentTestFailed(), qPrintable(control.name));
        const Scene after = m_window->scene();
        const QString shownAfter = control.shown();
        QVERIFY2(compareScenes(before, after) == SceneChange::Appearance, qPrintable(control.name));
        QVERIFY2(shownAfter != shownBefore, qPrintable(control.name));
        QVERIFY2(m_window->document().undoStack().index() == index + 1, qPrintable(control.name));
        QVERIFY2(validate(after).empty(), qPrintable(control.name));
        undo();
        QVERIFY2(m_window->scene() == before, qPrintable(control.name));
        QCOMPARE(control.shown(), shownBefore);
        m_window->key(Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY2(m_window->scene() == after, qPrintable(control.name));
        QCOMPARE(control.shown(), shownAfter);
        undo();
    }
}

void TestAppearance::everyControlShowsTheSceneThatIsOpened() {
    const QStringList plain = shown();
    QVERIFY(m_window->load(colourfulScene(m_window->path("."))));
    const QStringList colourful = shown();
    for (qsizetype i = 0; i < plain.size(); ++i)
        QVERIFY2(colourful[i] != plain[i], qPrintable(plain[i]));
    QCOMPARE(panel().shaderBox()->currentText(), QStringLiteral("Mirror"));
    QCOMPARE(panel().colorRow()->color(), QColor("#336699"));
    QCOMPARE(panel().backColorRow()->color(), QColor("#ff0000"));
    QCOMPARE(panel().backgroundRow()->color(), QColor("#0000ff"));
    QCOMPARE(shownBy(panel().textureRow(3)), QStringLiteral("cloth.png and back"));
    QCOMPARE(shownBy(panel().cubemapRow()), QStringLiteral("sky and back"));
    QCOMPARE(panel().samplesBox()->currentData().toInt(), 8);
    QCOMPARE(field("appearance.light_position[1]")->value(), 3.0);
    QCOMPARE(field("appearance.mesh_resolution")->value(), 64.0);
    QVERIFY(!panel().checkBox("appearance.shadows")->isChecked());
    QVERIFY((*m_window)->springsPanel().findChild<QCheckBox*>("colorByStrain")->isChecked());
    QCOMPARE(steps(), 0); // to show is not to edit
    m_window->document().newScene();
    QCOMPARE(shown(), plain);
}

void TestAppearance::theColoursOfOneVisitAreOneStep() {
    for (ColorRow* row : panel().findChildren<ColorRow*>()) {
        const Scene before = m_window->scene();
        const int first = steps();
        chooseColor(row, {"#808080", "#336699"});
        QCOMPARE(steps(), first + 1);
        QCOMPARE(row->color(), QColor("#336699"));
        chooseColor(row, {"#996633"}); // another visit
        QCOMPARE(steps(), first + 2);
        undo();
        QCOMPARE(row->color(), QColor("#336699"));
        undo();
        QVERIFY(m_window->scene() == before);
    }
}

void TestAppearance::coloursGoBackToTheirDefault() {
    const Scene before = m_window->scene();
    for (ColorRow* row : panel().findChildren<ColorRow*>()) {
        QVERIFY(!row->resetButton()->isVisible());
        chooseColor(row, {"#336699"});
        QVERIFY(row->resetButton()->isVisible());
        const Scene chosen = m_window->scene();
        m_window->click(row->resetButton());
        QVERIFY2(m_window->scene() == before, qPrintable(row->button()->accessibleName()));
        QVERIFY(!row->resetButton()->isVisible());
        undo();
        QVERIFY(m_window->scene() == chosen);
        m_window->click(row->resetButton());
    }
    QCOMPARE(panel().backColorRow()->button()->text(), QStringLiteral("As the front"));
}

void TestAppearance::filesAreChosenAndGoBackToTheirDefault() {
    const Scene before = m_window->scene();
    for (std::size_t i = 0; i < std::size_t(kTextures); ++i) {
        FileRow* row = panel().textureRow(i);
        const QString builtIn = row->button()->text();
        QCOMPARE(builtIn, QStringLiteral("Built in"));
        chooseFileFor(row, m_window->path("cloth.png"));
        QCOMPARE(look().textures[i], m_window->path("cloth.png").toStdString());
        QCOMPARE(row->button()->text(), QStringLiteral("cloth.png"));
        m_window->click(row->resetButton());
        QVERIFY(m_window->scene() == before);
        QCOMPARE(row->button()->text(), builtIn);
    }
    chooseFileFor(panel().cubemapRow(), m_window->path("sky"));
    QCOMPARE(look().cubemap, m_window->path("sky").toStdString());
    m_window->click(panel().cubemapRow()->resetButton());
    QVERIFY(m_window->scene() == before);
}

void TestAppearance::aChooserThatIsCancelledChangesNothing() {
    for (FileRow* row : {panel().textureRow(0), panel().cubemapRow()}) {
        const DialogAnswer answer(pressEscape());
        m_window->click(row->button());
        QVERIFY(answer.asked());
    }
    m_window->click(panel().colorRow()->button());
    QTest::keyClick(panel().colorRow()->findChild<QColorDialog*>(), Qt::Key_Escape);
    QCOMPARE(steps(), 0);
}

void TestAppearance::filesAreKeptRelativeToTheScene() {
    chooseFileFor(panel().textureRow(0), m_window->path("cloth.png"));
    m_window->key(Qt::Key_S, Qt::ControlModifier);
    const auto saved = loadScene(m_window->path("scene.json").toStdString()).scene;
    QVERIFY(saved);
    QCOMPARE(saved->appearance.textures[0], std::string("cloth.png"));
    QVERIFY(QDir(m_window->path(".")).mkdir("below"));
    const DialogAnswer chooser(chooseFile(m_window->path("below/b.json")));
    m_window->key(Qt::Key_S, Qt::ControlModifier | Qt::ShiftModifier);
    QVERIFY(chooser.asked());
    QCOMPARE(loadScene(m_window->path("below/b.json").toStdString()).scene->appearance.textures[0],
             std::string("../cloth.png"));
    QCOMPARE(panel().textureRow(0)->button()->text(), QStringLiteral("cloth.png"));
    undo();
    QCOMPARE(look().textures[0], std::string());
}

void TestAppearance::theSamplesAreThoseThatThereAre() {
    QComboBox* box = panel().samplesBox();
    for (const int samples : {1, 2, 4, 8}) {
        Scene scene = smallScene();
        scene.appearance.samples = samples;
        QVERIFY(m_window->load(scene));
        QCOMPARE(box->currentData().toInt(), samples);
    }
    box->setFocus();
    for (const int samples : {4, 2, 1}) {
        m_window->key(Qt::Key_Up);
        QCOMPARE(look().samples, samples);
    }
    QCOMPARE(steps(), 3);
    undo();
    QCOMPARE(box->currentData().toInt(), 2);
}

void TestAppearance::theRangeOfStrainFitsTheRecording() {
    Scene scene = smallScene();
    scene.cloth.ks = 50; // it stretches
    QVERIFY(m_window->load(scene));
    QVERIFY(m_window->simulateTo(40));
    m_window->simulation().showFrame(3); // all frames count, not only this
    double greatest = 0;
    std::vector<float> strains;
    for (int frame = 0; frame <= 40; ++frame)
        greatest = std::max(
            greatest,
            pointStrains(scene.cloth, m_window->simulation().sheet(),
                         m_window->simulation().recording().frame(frame).exact->state.position, strains));
    QVERIFY(greatest > 0.01);
    m_window->click(panel().findChild<QWidget*>("fitStrainRange"));
    QVERIFY(look().strainRange >= greatest && look().strainRange < 1.02 * greatest);
    QCOMPARE(field("appearance.strain_range")->value(), look().strainRange);
    QCOMPARE(steps(), 1);
    m_window->click(panel().findChild<QWidget*>("fitStrainRange")); // it fits
    QCOMPARE(steps(), 1);
    undo();
    QCOMPARE(look().strainRange, Appearance{}.strainRange);
    // A sheet at rest still has a range that a scene may have.
    m_window->key(Qt::Key_R);
    QCOMPARE(m_window->frameCount(), 1);
    m_window->click(panel().findChild<QWidget*>("fitStrainRange"));
    QVERIFY(look().strainRange > 0);
    QVERIFY(validate(m_window->scene()).empty());
}

void TestAppearance::aMeshTooCoarseIsRefusedInWords() {
    const Scene before = m_window->scene();
    for (const char* text : {"5", "15", "513"}) {
        m_window->typeInto(field("appearance.mesh_resolution"), text);
        m_window->key(Qt::Key_Return);
        QVERIFY2(m_window->scene() == before, text);
        QVERIFY2((*m_window)->statusBar()->currentMessage().contains("512"), text);
    }
    m_window->typeInto(field("appearance.mesh_resolution"), "5");
    m_window->key(Qt::Key_Return);
    const QString words = (*m_window)->statusBar()->currentMessage();
    QVERIFY2(words.contains("16 to 512"), qPrintable(words));
    QVERIFY(m_window->output().contains(words));
    QCOMPARE(steps(), 0);
    m_window->typeInto(field("appearance.mesh_resolution"), "16");
    m_window->key(Qt::Key_Return);
    QCOMPARE(look().meshResolution, 16);
}

void TestAppearance::stepsAndDragsPassOverMeshesTooCoarse() {
    NumberField* mesh = field("appearance.mesh_resolution");
    m_window->click(mesh);
    m_window->key(Qt::Key_Up);
    QCOMPARE(look().meshResolution, 16);
    m_window->key(Qt::Key_Up);
    QCOMPARE(look().meshResolution, 17);
    m_window->key(Qt::Key_Down);
    m_window->key(Qt::Key_Down);
    QCOMPARE(look().meshResolution, 0);
    QCOMPARE(mesh->text(), QStringLiteral("0"));
    QCOMPARE(steps(), 0); // back where the run of steps began
}

void TestAppearance::theLookDoesNotDisturbARun() {
    QVERIFY(m_window->simulateTo(5));
    m_window->simulation().showFrame(3);
    const FramePointer last = m_window->simulation().look(5);
    for (const Control& control : controls()) {
        control.change();
        QVERIFY2(m_window->frameCount() == 6 && m_window->frame() == 3, qPrintable(control.name));
        QVERIFY2(m_window->simulation().firstStaleFrame() == 6, qPrintable(control.name));
        QVERIFY2(m_window->simulation().look(5) == last, qPrintable(control.name));
    }
    // A run that goes on goes on.
    m_window->viewport().setFocus();
    m_window->key(Qt::Key_Space);
    for (const Control& control : controls()) {
        const int count = m_window->frameCount();
        undo();
        QVERIFY(m_window->simulation().isPlaying());
        QVERIFY2(m_window->frameCount() >= count, qPrintable(control.name));
    }
    const int count = m_window->frameCount();
    TRY_VERIFY(m_window->frameCount() > count);
    QCOMPARE(m_window->simulation().firstStaleFrame(), m_window->frameCount());
    m_window->key(Qt::Key_Space);
}

CLOTHLAB_GUI_TEST_MAIN(TestAppearance)
#include "tst_appearance.moc"
