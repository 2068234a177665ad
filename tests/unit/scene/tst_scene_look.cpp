// The look of a scene in its file: which key means what, and that only what was changed is written.
#include "tests/support/scene_text.h"

#include <QTest>

#include <cmath>
#include <functional>

using namespace clothlab;
using test::Json;

namespace {

using Edit = std::function<void(Appearance&)>;

std::string withAppearance(const std::string& appearance) {
    return R"({"cloth": )" + test::courseScene()["cloth"].dump() + R"(, "appearance": )" + appearance + "}";
}

Appearance load(const std::string& appearance) {
    const SceneReading reading = readScene(withAppearance(appearance));
    if (!reading.scene || !reading.diagnostics.empty())
        qFatal("%s", test::toText(reading.diagnostics).c_str());
    return reading.scene->appearance;
}

} // namespace
Q_DECLARE_METATYPE(Edit)

class TestSceneLook : public QObject {
    Q_OBJECT
private slots:
    void aChangeIsOneKey_data() {
        QTest::addColumn<Edit>("edit");
        QTest::addColumn<QString>("text");
        const auto row = [](const char* text, Edit edit) {
            QTest::newRow(text) << std::move(edit) << QString(text);
        };
        row(R"({"shader":"Mirror"})", [](Appearance& a) { a.shader = "Mirror"; });
        row(R"({"color":[0,0.5,1]})", [](Appearance& a) { a.color = {0, 0.5, 1}; });
        row(R"({"back_color":[1,1,1]})", [](Appearance& a) { a.backColor = Rgb{1, 1, 1}; });
        row(R"({"two_sided":false})", [](Appearance& a) { a.twoSided = false; });
        row(R"({"springs_drawn":{"structural":true,"shearing":true,"bending":false}})",
            [](Appearance& a) { a.springsDrawn[2] = false; });
        row(R"({"springs_over_surface":true})", [](Appearance& a) { a.springsOverSurface = true; });
        row(R"({"springs_colored_by":"strain"})",
            [](Appearance& a) { a.springColoring = SpringColoring::ByStrain; });
        row(R"({"strain_range":0})", [](Appearance& a) { a.strainRange = 0; });
        row(R"({"light_position":[0.5,2,-2]})", [](Appearance& a) { a.lightPosition[2] = -2; });
        row(R"({"light_intensity":[9,3,0]})", [](Appearance& a) { a.lightIntensity = {9, 3, 0}; });
        row(R"({"shadows":false})", [](Appearance& a) { a.shadows = false; });
        row(R"({"background":[0,0,0.25]})", [](Appearance& a) { a.background = Rgb{0, 0, 0.25}; });
        row(R"({"ground_grid":false})", [](Appearance& a) { a.groundGrid = false; });
        row(R"({"axes":false})", [](Appearance& a) { a.axes = false; });
        row(R"({"samples":1})", [](Appearance& a) { a.samples = 1; });
        row(R"({"mesh_resolution":16})", [](Appearance& a) { a.meshResolution = 16; });
        row(R"({"normal_scaling":-0.1})", [](Appearance& a) { a.normalScaling = -0.1; });
        row(R"({"height_scaling":10})", [](Appearance& a) { a.heightScaling = 10; });
        row(R"({"textures":{"texture_1":"a.png","texture_4":"../b"}})", [](Appearance& a) {
            a.textures[0] = "a.png";
            a.textures[3] = "../b";
        });
        row(R"({"cubemap":"sky"})", [](Appearance& a) { a.cubemap = "sky"; });
        row(R"({"uniforms":{"Phong":{"u_0":0}}})", [](Appearance& a) { a.uniforms["Phong"]["u_0"] = 0.0; });
        row(R"({"uniforms":{"Phong":{}}})", [](Appearance& a) { a.uniforms["Phong"]; });
    }
    void aChangeIsOneKey() {
        QFETCH(Edit, edit);
        QFETCH(QString, text);
        Scene scene;
        edit(scene.appearance);
        QCOMPARE(QString::fromStdString(Json::parse(writeScene(scene))["appearance"].dump()), text);
        QVERIFY(load(text.toStdString()) == scene.appearance);
    }

    void whatIsAtItsDefaultIsNotWritten() {
        Scene scene;
        scene.appearance = load(R"({"springs_colored_by": "type", "two_sided": true, "samples": 4,
            "textures": {"texture_1": ""}, "cubemap": "", "uniforms": {}})");
        QVERIFY(scene.appearance == Appearance{});
        QVERIFY(!Json::parse(writeScene(scene)).contains("appearance"));
    }

    void aUniformIsOfTheTypeThatItIsWrittenAs() {
        const UniformValues values = load(R"({"uniforms": {"A": {"off": false, "one": 1, "minus": -0,
            "two": [1, -0], "four": [1, 2, 3, 1e-300], "file": "ü\n.png", "none": ""}}})")
                                         .uniforms.at("A");
        QVERIFY(values.at("off") == UniformValue(false));
        QVERIFY(values.at("one") == UniformValue(1.0));
        QVERIFY(std::signbit(std::get<double>(values.at("minus"))));
        QVERIFY(values.at("two") == UniformValue(std::vector<double>{1, 0}));
        QVERIFY(std::signbit(std::get<std::vector<double>>(values.at("two"))[1]));
        QVERIFY(values.at("four") == UniformValue(std::vector<double>{1, 2, 3, 1e-300}));
        QVERIFY(values.at("file") == UniformValue("ü\n.png"));
        QVERIFY(values.at("none") == UniformValue(std::string()));
        QCOMPARE(values.size(), std::size_t(7));
    }

    void theSignOfZeroIsWritten() {
        Scene scene;
        scene.appearance.normalScaling = -0.0;
        scene.appearance.lightPosition = {0, -0.0, 0};
        scene.appearance.uniforms["A"] = {{"u", -0.0}, {"v", std::vector<double>{-0.0, 0}}};
        const std::string text = writeScene(scene);
        for (const char* part :
             {R"("normal_scaling": -0)", R"("light_position": [0, -0, 0])", R"("u": -0)", R"("v": [-0, 0])"})
            QVERIFY2(text.find(part) != std::string::npos, text.c_str());
    }

    void noUniformIsUnknown() {
        QVERIFY(
            load(R"({"uniforms": {"A b": {"ks": 1, "shader": true}, "textures": {}}})").unknownKeys.empty());
    }

    void whatIsWrongIsSaidInTheSameWordsWhereverItIsFound_data() {
        QTest::addColumn<QString>("appearance");
        QTest::addColumn<QString>("words");
        const auto row = [](const char* appearance, const char* words) {
            QTest::newRow(appearance) << appearance << QString("appearance.%1").arg(words);
        };
        row(R"({"samples": 16})", "samples: must not be 16; give 1, 2, 4 or 8");
        row(R"({"samples": 3})", "samples: must not be 3; give 1, 2, 4 or 8");
        row(R"({"samples": "4"})", "samples: must be a number, is text; give 1, 2, 4 or 8");
        row(R"({"mesh_resolution": 600})",
            "mesh_resolution: must not be 600; give 0 or a whole number from 16 to 512");
        row(R"({"strain_range": 1e-7})",
            "strain_range: must not be 1e-07; give 0 or a number from 1e-06 to 10");
        row(R"({"springs_colored_by": "force"})",
            "springs_colored_by: is not what springs can be coloured by; give \"type\" or \"strain\"");
        row(R"({"uniforms": {"A": {"u": [1]}}})",
            "uniforms.A.u: must hold 2 to 4 numbers, holds 1; give true or false, a number, a list of 2 to 4 "
            "numbers or the name of a file");
        row(R"({"uniforms": {"A": {"u": null}}})",
            "uniforms.A.u: is not the value of a uniform; give true or false, a number, a list of 2 to 4 "
            "numbers or the name of a file");
    }
    void whatIsWrongIsSaidInTheSameWordsWhereverItIsFound() {
        QFETCH(QString, appearance);
        QFETCH(QString, words);
        const SceneReading reading = readScene(withAppearance(appearance.toStdString()));
        QVERIFY(!reading.scene && !reading.diagnostics.empty());
        QCOMPARE(QString::fromStdString(clothlab::toText(reading.diagnostics.front(), "")), words);
    }
};

QTEST_APPLESS_MAIN(TestSceneLook)
#include "tst_scene_look.moc"
