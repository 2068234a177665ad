// The controls of a shader's own uniforms, without a window around them.
#include "app/docks/shader_controls.h"
#include "app/widgets/button_row.h"
#include "app/widgets/number_field.h"
#include "app/widgets/parameter_row.h"
#include "app/widgets/theme.h"
#include "simcore/scene/scene_io.h"
#include "tests/gui/dialog_answer.h"

#include <QApplication>
#include <QCheckBox>
#include <QColorDialog>
#include <QDir>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QToolButton>

#include <memory>

using namespace clothlab;
using render::UniformSpec;
using Type = UniformSpec::Type;

Q_DECLARE_METATYPE(clothlab::UniformValue)

namespace {

UniformSpec spec(const char* name, Type type, std::array<float, 4> initial = {}) {
    UniformSpec made;
    made.name = name;
    made.type = type;
    made.label = QString(name).mid(2);
    made.initial.components = render::componentsOf(type);
    made.initial.numbers = initial;
    return made;
}

UniformSpec inRange(UniformSpec made, float low, float high) {
    made.range = {low, high};
    return made;
}

UniformSpec asColor(UniformSpec made) {
    made.color = true;
    return made;
}

std::vector<UniformSpec> oneOfEach() {
    UniformSpec map = spec("u_map", Type::Sampler2D);
    map.initial.file = "texture_5.png";
    return {spec("u_glow", Type::Bool, {1}),
            inRange(spec("u_count", Type::Int, {3}), 0, 10),
            inRange(spec("u_rough", Type::Float, {0.8F}), 0, 1),
            spec("u_tiles", Type::Vec2, {4, 5}),
            spec("u_wind", Type::Vec3, {-1, 0, 1}),
            spec("u_quad", Type::Vec4, {1, 2, 3, 4}),
            asColor(spec("u_tint", Type::Vec3, {1, 0.5F, 0})),
            asColor(spec("u_haze", Type::Vec4, {0, 0, 1, 0.5F})),
            map};
}

using Numbers = std::vector<double>;

} // namespace

class TestShaderControls : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { applyTheme(*qApp, Theme::Dark); }
    void init();
    void cleanup();

    void everyTypeHasItsControl();
    void everyEditLandsAsAValueOfItsType_data();
    void everyEditLandsAsAValueOfItsType();
    void theDefaultIsNotInTheScene();
    void coloursLandAndGoBack();
    void filesLandAndGoBack();
    void onlyTheShaderThatIsShownIsSet();
    void otherUniformsMakeOtherControls();
    void theSameUniformsKeepTheirControls();
    void aValueOfAnotherTypeShowsTheDefault();
    void whatTheSceneHasIsShown();
    void whatIsOutOfRangeIsRefusedInWords();
    void aDragIsOneStep();

private:
    // Old controls go and new ones appear in the event loop.
    void show(const QString& shader, const std::vector<UniformSpec>& uniforms) {
        m_controls->setUniforms(shader, uniforms);
        QApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
        QApplication::processEvents();
    }
    template <typename Widget>
    Widget* control(const QString& name) {
        auto* widget = m_controls->findChild<Widget*>(name);
        return widget && widget->isVisible() ? widget : nullptr;
    }
    double number(const QString& name) { return control<ParameterRow>(name)->field()->value(); }
    void type(const QString& name, const QString& text) {
        NumberField* field = control<ParameterRow>(name)->field();
        field->setFocus();
        field->selectAll();
        QTest::keyClicks(field, text);
        QTest::keyClick(field, Qt::Key_Return);
    }
    const std::map<std::string, UniformValues>& values() { return m_document->scene().appearance.uniforms; }
    std::optional<UniformValue> value(const std::string& uniform, const std::string& shader = "Fur") {
        const auto of = values().find(shader);
        if (of == values().end() || !of->second.contains(uniform))
            return std::nullopt;
        return of->second.find(uniform)->second;
    }
    void put(const std::string& uniform, const UniformValue& value) {
        Scene after = m_document->scene();
        after.appearance.uniforms["Fur"][uniform] = value;
        m_document->edit("put", after);
    }
    int steps() { return m_document->undoStack().count(); }

    std::unique_ptr<Document> m_document;
    std::unique_ptr<QWidget> m_window;
    ShaderControls* m_controls = nullptr;
};

void TestShaderControls::init() {
    m_document = std::make_unique<Document>();
    m_window = std::make_unique<QWidget>();
    m_controls = new ShaderControls(*m_document, m_window.get());
    // As the panel does it.
    connect(m_document.get(), &Document::sceneChanged, m_controls, [this] { m_controls->showScene(); });
    m_controls->resize(400, 600);
    m_window->resize(400, 600);
    m_window->show();
    m_window->activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(m_window.get()));
    show("Fur", oneOfEach());
}

void TestShaderControls::cleanup() {
    m_window.reset();
    m_document.reset();
}

void TestShaderControls::everyTypeHasItsControl() {
    QVERIFY(control<QCheckBox>("u_glow") && control<QCheckBox>("u_glow")->isChecked());
    QCOMPARE(number("u_count"), 3.0);
    QVERIFY(control<ParameterRow>("u_count")->spec().integer);
    QCOMPARE(number("u_rough"), 0.8); // not 0.800000012
    QCOMPARE(control<ParameterRow>("u_rough")->spec().maximum, 1.0);
    for (const auto& [name, shown] : std::initializer_list<std::pair<const char*, double>>{
             {"u_tiles.x", 4}, {"u_tiles.y", 5}, {"u_wind.x", -1}, {"u_wind.z", 1}, {"u_quad.w", 4}}) {
        QVERIFY2(control<ParameterRow>(name), name);
        QCOMPARE(number(name), shown);
    }
    QVERIFY(!control<ParameterRow>("u_tiles.z"));
    QVERIFY(!control<ParameterRow>("u_tint.x"));
    QCOMPARE(control<ColorRow>("u_tint")->color(), QColor::fromRgbF(1, 0.5F, 0));
    QCOMPARE(control<ColorRow>("u_haze")->color(), QColor("#0000ff"));
    QCOMPARE(number("u_haze.w"), 0.5); // its opacity
    QCOMPARE(control<FileRow>("u_map")->button()->text(), QStringLiteral("Built in"));
    QVERIFY(values().empty());
    QCOMPARE(steps(), 0);
}

void TestShaderControls::everyEditLandsAsAValueOfItsType_data() {
    QTest::addColumn<QString>("control");
    QTest::addColumn<QString>("text"); // none: a click
    QTest::addColumn<QString>("uniform");
    QTest::addColumn<UniformValue>("value");
    QTest::newRow("bool") << "u_glow"
                          << ""
                          << "u_glow" << UniformValue(false);
    QTest::newRow("int") << "u_count"
                         << "7"
                         << "u_count" << UniformValue(7.0);
    QTest::newRow("float") << "u_rough"
                           << "0.3"
                           << "u_rough" << UniformValue(0.3);
    QTest::newRow("vec2") << "u_tiles.y"
                          << "9"
                          << "u_tiles" << UniformValue(Numbers{4, 9});
    QTest::newRow("vec3") << "u_wind.x"
                          << "0.1"
                          << "u_wind" << UniformValue(Numbers{0.1, 0, 1});
    QTest::newRow("vec4") << "u_quad.w"
                          << "-2"
                          << "u_quad" << UniformValue(Numbers{1, 2, 3, -2});
    QTest::newRow("opacity") << "u_haze.w"
                             << "0.25"
                             << "u_haze" << UniformValue(Numbers{0, 0, 1, 0.25});
}

void TestShaderControls::everyEditLandsAsAValueOfItsType() {
    QFETCH(QString, control);
    QFETCH(QString, text);
    QFETCH(QString, uniform);
    QFETCH(UniformValue, value);
    if (text.isEmpty())
        QTest::mouseClick(this->control<QCheckBox>(control), Qt::LeftButton, {}, {8, 8});
    else
        type(control, text);
    QVERIFY(this->value(uniform.toStdString()) == value);
    QCOMPARE(values().at("Fur").size(), std::size_t(1));
    QCOMPARE(steps(), 1);
    QVERIFY(validate(m_document->scene()).empty());
    // It is read back as it is written.
    const QTemporaryDir folder;
    QVERIFY(!m_document->save(folder.filePath("a.json")));
    QVERIFY(loadScene(folder.filePath("a.json").toStdString()).scene == m_document->scene());
    m_document->undoStack().undo();
    QVERIFY(values().empty());
    m_document->undoStack().redo();
    QVERIFY(this->value(uniform.toStdString()) == value);
}

void TestShaderControls::theDefaultIsNotInTheScene() {
    type("u_rough", "0.3");
    type("u_count", "7");
    QCOMPARE(values().at("Fur").size(), std::size_t(2));
    type("u_rough", "0.8");
    QVERIFY(!value("u_rough"));
    QCOMPARE(values().at("Fur").size(), std::size_t(1));
    type("u_count", "3");
    QVERIFY(values().empty()); // nor is the shader
    QTest::mouseClick(control<QCheckBox>("u_glow"), Qt::LeftButton, {}, {8, 8});
    QTest::mouseClick(control<QCheckBox>("u_glow"), Qt::LeftButton, {}, {8, 8});
    QVERIFY(values().empty());
}

void TestShaderControls::coloursLandAndGoBack() {
    auto* row = control<ColorRow>("u_tint");
    QTest::mouseClick(row->button(), Qt::LeftButton);
    auto* dialog = row->findChild<QColorDialog*>();
    QVERIFY(dialog && dialog->isVisible());
    dialog->setCurrentColor(QColor("#00ff00"));
    dialog->setCurrentColor(QColor("#0000ff"));
    dialog->close();
    QCOMPARE(steps(), 1);
    QVERIFY(value("u_tint") == UniformValue(Numbers{0, 0, 1}));
    QVERIFY(row->resetButton()->isVisible());
    QTest::mouseClick(row->resetButton(), Qt::LeftButton);
    QVERIFY(values().empty());
    QVERIFY(!row->resetButton()->isVisible());
    m_document->undoStack().undo();
    QCOMPARE(row->color(), QColor("#0000ff"));
    // The opacity of a colour stays as it was.
    type("u_haze.w", "0.25");
    auto* haze = control<ColorRow>("u_haze");
    emit haze->edited(QColor("#ff0000"), 1);
    QVERIFY(value("u_haze") == UniformValue(Numbers{1, 0, 0, 0.25}));
}

void TestShaderControls::filesLandAndGoBack() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("map.png");
    QVERIFY(QImage(2, 2, QImage::Format_RGB32).save(path));
    auto* row = control<FileRow>("u_map");
    const DialogAnswer answer(chooseFile(path));
    QTest::mouseClick(row->button(), Qt::LeftButton);
    QVERIFY(answer.asked());
    QVERIFY(value("u_map") == UniformValue(path.toStdString()));
    QCOMPARE(row->button()->text(), QStringLiteral("map.png"));
    QVERIFY(!m_document->save(folder.filePath("a.json"))); // a folder to be relative to
    QCOMPARE(row->button()->text(), QStringLiteral("map.png"));
    QTest::mouseClick(row->resetButton(), Qt::LeftButton);
    QVERIFY(values().empty());
    QCOMPARE(row->button()->text(), QStringLiteral("Built in"));
}

void TestShaderControls::onlyTheShaderThatIsShownIsSet() {
    type("u_rough", "0.3");
    show("Felt", {spec("u_rough", Type::Float, {0.5F})});
    QCOMPARE(number("u_rough"), 0.5);
    type("u_rough", "0.1");
    QVERIFY(value("u_rough", "Felt") == UniformValue(0.1));
    QVERIFY(value("u_rough", "Fur") == UniformValue(0.3));
    show("Fur", oneOfEach());
    QCOMPARE(number("u_rough"), 0.3);
}

void TestShaderControls::otherUniformsMakeOtherControls() {
    const auto rows = [this] { return m_controls->findChildren<ParameterRow*>().size(); };
    QCOMPARE(rows(), qsizetype(2 + 2 + 3 + 4 + 1));
    show("Fur", {spec("u_new", Type::Float, {0.5F}), spec("u_tiles", Type::Vec3)});
    QCOMPARE(rows(), qsizetype(4));
    QCOMPARE(number("u_new"), 0.5);
    QVERIFY(control<ParameterRow>("u_tiles.z"));
    QVERIFY(!control<QCheckBox>("u_glow"));
    type("u_tiles.z", "2");
    QVERIFY(value("u_tiles") == UniformValue(Numbers{0, 0, 2}));
    show("Plain", {});
    QCOMPARE(rows(), qsizetype(0));
    QCOMPARE(steps(), 1);
}

void TestShaderControls::theSameUniformsKeepTheirControls() {
    const auto* row = control<ParameterRow>("u_rough");
    show("Fur", oneOfEach());
    QCOMPARE(control<ParameterRow>("u_rough"), row); // what is typed there is not lost
}

void TestShaderControls::aValueOfAnotherTypeShowsTheDefault() {
    put("u_rough", Numbers{1, 2});
    put("u_wind", UniformValue(3.0));
    put("u_tint", UniformValue("a.png"));
    put("u_glow", UniformValue("a.png"));
    put("u_map", UniformValue(0.25));
    QCOMPARE(number("u_rough"), 0.8);
    QCOMPARE(number("u_wind.x"), -1.0);
    QCOMPARE(control<ColorRow>("u_tint")->color(), QColor::fromRgbF(1, 0.5F, 0));
    QVERIFY(control<QCheckBox>("u_glow")->isChecked());
    QCOMPARE(control<FileRow>("u_map")->button()->text(), QStringLiteral("Built in"));
    // An edit puts one of the right type in its place.
    type("u_wind.z", "5");
    QVERIFY(value("u_wind") == UniformValue(Numbers{-1, 0, 5}));
}

void TestShaderControls::whatTheSceneHasIsShown() {
    put("u_rough", UniformValue(0.25));
    put("u_wind", Numbers{7, 8, 9});
    put("u_glow", UniformValue(false));
    put("u_tint", Numbers{0, 1, 0});
    QCOMPARE(number("u_rough"), 0.25);
    QCOMPARE(number("u_wind.y"), 8.0);
    QVERIFY(!control<QCheckBox>("u_glow")->isChecked());
    QCOMPARE(control<ColorRow>("u_tint")->color(), QColor("#00ff00"));
    while (m_document->undoStack().canUndo())
        m_document->undoStack().undo();
    QCOMPARE(number("u_rough"), 0.8);
    QVERIFY(control<QCheckBox>("u_glow")->isChecked());
}

void TestShaderControls::whatIsOutOfRangeIsRefusedInWords() {
    const QSignalSpy rejected(m_controls, &ShaderControls::rejected);
    type("u_rough", "1.5");
    type("u_count", "2.5");
    QCOMPARE(rejected.count(), 2);
    QVERIFY(!rejected.at(0).at(0).toString().isEmpty());
    QVERIFY(values().empty());
}

void TestShaderControls::aDragIsOneStep() {
    auto* row = control<ParameterRow>("u_rough");
    const int gesture = ParameterRow::newGesture();
    for (const double value : {0.1, 0.2, 0.3})
        emit row->edited(value, gesture);
    QCOMPARE(steps(), 1);
    emit row->edited(0.8, gesture); // back where it began
    QCOMPARE(steps(), 0);
    QVERIFY(values().empty());
}

QTEST_MAIN(TestShaderControls)
#include "tst_shader_controls.moc"
