#include "simcore/scene/parameters.h"
#include "tests/support/scene_text.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <limits>

using namespace clothlab;

namespace {

using Edit = std::function<void(Scene&)>;

constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Nothing is wrong with this one.
Scene goodScene() {
    Scene scene;
    scene.cloth.pinned = {{0, 0}, {49, 0}};
    scene.spheres.push_back({Vec3(0.5, 0.2, 0.5), 0.2, 0.3, ""});
    scene.planes.emplace_back();
    scene.camera.emplace();
    return scene;
}

void addUniforms(Scene& scene, int shaders, int ofEach) {
    for (int i = 0; i < shaders; ++i) {
        UniformValues& values = scene.appearance.uniforms["Shader " + std::to_string(i)];
        for (int j = 0; j < ofEach; ++j)
            values["u_" + std::to_string(j)] = double(j);
    }
}

Scene edited(const Edit& edit) {
    Scene scene = goodScene();
    edit(scene);
    return scene;
}

} // namespace
Q_DECLARE_METATYPE(Edit)

class TestValidate : public QObject {
    Q_OBJECT
private slots:
    void aGoodSceneIsNotWorthAWord() {
        QVERIFY2(validate(goodScene()).empty(), test::toText(validate(goodScene())).c_str());
    }

    void everyParameterIsHeldToItsRange() {
        for (const Parameter& parameter : parameters()) {
            if (parameter.kind == Parameter::Kind::Real) {
                for (const double value :
                     {std::nextafter(parameter.minimum, -kInfinity),
                      std::nextafter(parameter.maximum, kInfinity), kNaN, kInfinity, -kInfinity})
                    expectError(parameter, value);
            } else if (parameter.kind == Parameter::Kind::Integer && parameter.maximum < 4e9) {
                expectError(parameter, parameter.minimum - 1);
                expectError(parameter, parameter.maximum + 1);
            }
        }
    }

    void errorsAreFound_data() {
        QTest::addColumn<Edit>("edit");
        QTest::addColumn<QString>("place");
        const auto row = [](const char* name, const char* place, Edit edit) {
            QTest::newRow(name) << std::move(edit) << QString(place);
        };
        row("too many points", "cloth.num_width_points",
            [](Scene& s) { s.cloth.numWidthPoints = s.cloth.numHeightPoints = 2049; });
        row("orientation out of its type", "cloth.orientation",
            [](Scene& s) { s.cloth.orientation = static_cast<Orientation>(2); });
        row("pin outside", "cloth.pinned[2]", [](Scene& s) { s.cloth.pinned.push_back({50, 49}); });
        row("negative pin", "cloth.pinned[2]", [](Scene& s) { s.cloth.pinned.push_back({0, -1}); });
        row("origin", "sphere.origin[1]", [](Scene& s) { s.spheres[0].origin.y() = kNaN; });
        row("far origin", "sphere.origin[2]", [](Scene& s) { s.spheres[0].origin.z() = 1.1e6; });
        row("radius 0", "sphere.radius", [](Scene& s) { s.spheres[0].radius = 0; });
        row("radius", "sphere.radius", [](Scene& s) { s.spheres[0].radius = kInfinity; });
        row("second radius", "sphere[1].radius", [](Scene& s) { s.spheres.emplace_back().radius = kNaN; });
        row("friction", "sphere.friction", [](Scene& s) { s.spheres[0].friction = 1.01; });
        row("normal of length 0", "plane.normal", [](Scene& s) { s.planes[0].normal = Vec3::Zero(); });
        row("normal", "plane.normal[0]", [](Scene& s) { s.planes[0].normal.x() = kNaN; });
        row("point", "plane.point[0]", [](Scene& s) { s.planes[0].point.x() = -kInfinity; });
        row("friction of a plane", "plane.friction", [](Scene& s) { s.planes[0].friction = -0.01; });
        row("too many planes", "plane", [](Scene& s) { s.planes.resize(kMaxColliders + 1); });
        row("gravity", "simulation.gravity[2]", [](Scene& s) { s.simulation.gravity.z() = kNaN; });
        row("color", "appearance.color[2]", [](Scene& s) { s.appearance.color[2] = 1.5; });
        row("shader", "appearance.shader", [](Scene& s) { s.appearance.shader = "a/b"; });
        row("back color", "appearance.back_color[0]", [](Scene& s) {
            s.appearance.backColor = Rgb{-0.1, 0, 0};
        });
        row("background", "appearance.background[1]", [](Scene& s) {
            s.appearance.background = Rgb{0, kNaN, 0};
        });
        row("coloring out of its type", "appearance.springs_colored_by",
            [](Scene& s) { s.appearance.springColoring = static_cast<SpringColoring>(2); });
        row("3 samples", "appearance.samples", [](Scene& s) { s.appearance.samples = 3; });
        row("mesh of 15", "appearance.mesh_resolution", [](Scene& s) { s.appearance.meshResolution = 15; });
        row("mesh of 1", "appearance.mesh_resolution", [](Scene& s) { s.appearance.meshResolution = 1; });
        row("tiny strain", "appearance.strain_range", [](Scene& s) { s.appearance.strainRange = 9e-7; });
        row("texture", "appearance.textures.texture_3", [](Scene& s) { s.appearance.textures[2] = "\xFF"; });
        row("texture with a zero byte", "appearance.textures.texture_1",
            [](Scene& s) { s.appearance.textures[0] = std::string("a\0b", 3); });
        row("cubemap", "appearance.cubemap", [](Scene& s) { s.appearance.cubemap.assign(4097, 'a'); });
        row("infinite uniform", "appearance.uniforms.Phong.u_a",
            [](Scene& s) { s.appearance.uniforms["Phong"]["u_a"] = kInfinity; });
        row("one number", "appearance.uniforms.Phong.u_a",
            [](Scene& s) { s.appearance.uniforms["Phong"]["u_a"] = std::vector<double>(1); });
        row("five numbers", "appearance.uniforms.Phong.u_a",
            [](Scene& s) { s.appearance.uniforms["Phong"]["u_a"] = std::vector<double>(5); });
        row("number in a list", "appearance.uniforms.Phong.u_a[1]", [](Scene& s) {
            s.appearance.uniforms["Phong"]["u_a"] = std::vector<double>{0, kNaN};
        });
        row("file of a uniform", "appearance.uniforms.Phong.u_a",
            [](Scene& s) { s.appearance.uniforms["Phong"]["u_a"] = "\xC0\xAF"; });
        for (const char* name : {"", "2d", "u-a", "u a", "ü", "lights[0]"})
            QTest::addRow("uniform named '%s'", name)
                << Edit([name](Scene& s) { s.appearance.uniforms["Phong"][name] = 1.0; })
                << QString("appearance.uniforms.Phong.") + name;
        row("long uniform", "appearance.uniforms.Phong.uuuuuuuuuuuuuuuuuuuuuuuuuuuuuuuuuuuuuuuu…",
            [](Scene& s) { s.appearance.uniforms["Phong"][std::string(201, 'u')] = 1.0; });
        row("shader of uniforms", "appearance.uniforms.a/b",
            [](Scene& s) { s.appearance.uniforms["a/b"]["u_a"] = 1.0; });
        row("too many shaders", "appearance.uniforms", [](Scene& s) { addUniforms(s, 1001, 0); });
        row("too many uniforms", "appearance.uniforms", [](Scene& s) { addUniforms(s, 7, 143); });
        row("camera", "camera.distance", [](Scene& s) { s.camera->distance = 0; });
        row("camera's target", "camera.target[0]", [](Scene& s) { s.camera->target.x() = kNaN; });
        row("known key among the unknown", "cloth.ks", [](Scene& s) { s.cloth.unknownKeys = "{\"ks\":1}"; });
        row("known key at the top", "plane", [](Scene& s) { s.unknownKeys = "{\"plane\":1}"; });
        row("known key of appearance", "appearance.axes",
            [](Scene& s) { s.appearance.unknownKeys = "{\"axes\":1}"; });
        row("known key of textures", "appearance.textures.texture_1",
            [](Scene& s) { s.appearance.unknownTextureKeys = "{\"texture_1\":1}"; });
        row("unknown keys that are a list", "plane", [](Scene& s) { s.planes[0].unknownKeys = "[]"; });
    }
    void errorsAreFound() {
        QFETCH(Edit, edit);
        QFETCH(QString, place);
        const Diagnostics found = validate(edited(edit));
        const Diagnostic* error = test::find(found, Severity::Error, place.toStdString());
        QVERIFY2(error, test::toText(found).c_str());
        QVERIFY(!error->message.empty() && !error->remedy.empty());
    }

    void warningsAreGiven_data() {
        QTest::addColumn<Edit>("edit");
        QTest::addColumn<QString>("place");
        const auto row = [](const char* name, const char* place, Edit edit) {
            QTest::newRow(name) << std::move(edit) << QString(place);
        };
        row("pinned twice", "cloth.pinned[2]", [](Scene& s) { s.cloth.pinned.push_back({49, 0}); });
        row("all pinned", "cloth.pinned", [](Scene& s) {
            s.cloth.numWidthPoints = s.cloth.numHeightPoints = 2;
            s.cloth.pinned = {{0, 0}, {1, 0}, {0, 1}, {1, 1}};
        });
        row("no springs", "cloth", [](Scene& s) {
            s.cloth.enableStructural = s.cloth.enableShearing = s.cloth.enableBending = false;
        });
        row("thick", "cloth.thickness", [](Scene& s) { s.cloth.thickness = 0.0103; });
        row("thick for its height", "cloth.thickness", [](Scene& s) { s.cloth.height = 0.9; });
        row("in a sphere", "sphere", [](Scene& s) { s.spheres[0].origin.y() = 0.9; });
        row("in the second sphere", "sphere[1]", [](Scene& s) {
            s.spheres.push_back({{1, 1, 1}, 0.1, 0, ""});
        });
        row("across a plane", "plane", [](Scene& s) { s.planes[0] = {{0.5, 0, 0}, {2, 0, 0}, 0, ""}; });
        row("falls", "cloth.pinned", [](Scene& s) {
            s.cloth.pinned.clear();
            s.spheres.clear();
            s.planes.clear();
        });
        row("falls upwards", "cloth.pinned", [](Scene& s) {
            s.cloth.pinned.clear();
            s.simulation.gravity = {0, 9.8, 0};
        });
        row("falls beside the sphere", "cloth.pinned", [](Scene& s) {
            s.cloth.pinned.clear();
            s.spheres[0].origin.x() = 1.3;
            s.planes.clear();
        });
        row("falls along the plane", "cloth.pinned", [](Scene& s) {
            s.cloth.pinned.clear();
            s.spheres.clear();
            s.planes[0] = {{-1, 0, 0}, {1, 0, 0}, 0, ""};
        });
    }
    void warningsAreGiven() {
        QFETCH(Edit, edit);
        QFETCH(QString, place);
        const Diagnostics found = validate(edited(edit));
        QVERIFY2(!hasErrors(found), test::toText(found).c_str());
        const Diagnostic* warning = test::find(found, Severity::Warning, place.toStdString());
        QVERIFY2(warning, test::toText(found).c_str());
        QVERIFY(!warning->message.empty() && !warning->remedy.empty());
    }

    void whatIsFineGetsNoWarning_data() {
        QTest::addColumn<Edit>("edit");
        const auto row = [](const char* name, Edit edit) { QTest::newRow(name) << std::move(edit); };
        row("thin enough", [](Scene& s) { s.cloth.thickness = 0.0102; });
        row("no self-collision", [](Scene& s) { s.cloth.thickness = 0; });
        row("between the points", [](Scene& s) {
            s.spheres.push_back({{0.51 / 49, 1, 0.51 / 49}, 0.005, 0, ""});
        });
        row("strain that is found", [](Scene& s) { s.appearance.strainRange = 0; });
        row("small strain", [](Scene& s) { s.appearance.strainRange = 1e-6; });
        row("coarse mesh", [](Scene& s) { s.appearance.meshResolution = 16; });
        row("1 sample", [](Scene& s) { s.appearance.samples = 1; });
        row("2 samples", [](Scene& s) { s.appearance.samples = 2; });
        row("long file name", [](Scene& s) { s.appearance.cubemap.assign(4096, 'a'); });
        row("long name of a uniform",
            [](Scene& s) { s.appearance.uniforms["Phong"][std::string(200, 'u')] = true; });
        row("many shaders", [](Scene& s) { addUniforms(s, 1000, 0); });
        row("many uniforms", [](Scene& s) { addUniforms(s, 8, 125); });
        row("touching a plane", [](Scene& s) { s.planes[0].point.y() = 1; });
        row("weightless", [](Scene& s) {
            s.cloth.pinned.clear();
            s.planes.clear();
            s.spheres.clear();
            s.simulation.gravity = Vec3::Zero();
        });
        row("onto a sphere that a side touches", [](Scene& s) {
            s.cloth.pinned.clear();
            s.planes.clear();
            s.spheres[0].origin.x() = 1.19;
        });
        row("onto a slope", [](Scene& s) {
            s.cloth.pinned.clear();
            s.spheres.clear();
            s.planes[0] = {{0, 0, 0}, {-1, 1, 0}, 0, ""};
        });
        row("sideways onto a sphere", [](Scene& s) {
            s.cloth.pinned.clear();
            s.planes.clear();
            s.simulation.gravity = {9.8, -1, 0};
            s.spheres[0].origin = {9, 0.1, 0.5};
        });
        row("vertical onto a sphere", [](Scene& s) {
            s.cloth.pinned.clear();
            s.planes.clear();
            s.cloth.orientation = Orientation::Vertical;
            s.spheres[0].origin = {0.5, -1, 0.1};
        });
    }
    void whatIsFineGetsNoWarning() {
        QFETCH(Edit, edit);
        const Diagnostics found = validate(edited(edit));
        QVERIFY2(found.empty(), test::toText(found).c_str());
    }

    void theListOfErrorsEnds() {
        Scene scene = goodScene();
        scene.spheres.assign(5000, Sphere{{0, 0, 0}, -1, 0, ""});
        const Diagnostics found = validate(scene);
        QVERIFY(hasErrors(found) && found.size() < 100);
        QVERIFY(found.back().message.find("more errors") != std::string::npos);
    }

    void whereItIsWhatItIsAndWhatToDo() {
        const Diagnostics found = validate(edited([](Scene& s) { s.cloth.ks = -1; }));
        QCOMPARE(clothlab::toText(found.front(), "a.json"),
                 "a.json: cloth.ks: must not be -1; give a number from 0 to 1000000000");
        const auto remedy = [](const Edit& edit) { return validate(edited(edit)).front().remedy; };
        QCOMPARE(remedy([](Scene& s) { s.appearance.samples = 3; }), "give 1, 2, 4 or 8");
        QCOMPARE(remedy([](Scene& s) { s.appearance.meshResolution = 15; }),
                 "give 0 or a whole number from 16 to 512");
        QCOMPARE(remedy([](Scene& s) { s.appearance.strainRange = 11; }),
                 "give 0 or a number from 1e-06 to 10");
        QCOMPARE(clothlab::toText({Severity::Error, "", "is empty", ""}, ""), "is empty");
    }

private:
    static void expectError(const Parameter& parameter, double value) {
        Scene scene = goodScene();
        parameter.set(scene, value);
        const Diagnostics found = validate(scene);
        const std::string place(parameter.id);
        QVERIFY2(test::find(found, Severity::Error, place),
                 (place + " = " + std::to_string(value) + "\n" + test::toText(found)).c_str());
    }
};

QTEST_APPLESS_MAIN(TestValidate)
#include "tst_validate.moc"
