#include "simcore/scene/parameters.h"
#include "simcore/scene/scene.h"

#include <QTest>

#include <functional>

using namespace clothlab;

Q_DECLARE_METATYPE(clothlab::SceneChange)

namespace {
using Edit = std::function<void(Scene&)>;
}
Q_DECLARE_METATYPE(Edit)

class TestScene : public QObject {
    Q_OBJECT
private slots:
    void anEditIsToldByWhatItTouches_data() {
        QTest::addColumn<Edit>("edit");
        QTest::addColumn<SceneChange>("change");
        const auto row = [](const char* name, SceneChange change, Edit edit) {
            QTest::newRow(name) << std::move(edit) << change;
        };
        row("nothing", SceneChange::None, [](Scene&) {});
        row("width", SceneChange::Start, [](Scene& s) { s.cloth.width = 2; });
        row("height", SceneChange::Start, [](Scene& s) { s.cloth.height = 2; });
        row("points across", SceneChange::Start, [](Scene& s) { s.cloth.numWidthPoints = 9; });
        row("points down", SceneChange::Start, [](Scene& s) { s.cloth.numHeightPoints = 9; });
        row("orientation", SceneChange::Start, [](Scene& s) { s.cloth.orientation = Orientation::Vertical; });
        row("seed", SceneChange::Start, [](Scene& s) { s.simulation.seed = 9; });
        row("thickness", SceneChange::Motion, [](Scene& s) { s.cloth.thickness = 0; });
        row("damping", SceneChange::Motion, [](Scene& s) { s.cloth.damping = 0; });
        row("density", SceneChange::Motion, [](Scene& s) { s.cloth.density = 1; });
        row("ks", SceneChange::Motion, [](Scene& s) { s.cloth.ks = 1; });
        row("structural", SceneChange::Motion, [](Scene& s) { s.cloth.enableStructural = false; });
        row("shearing", SceneChange::Motion, [](Scene& s) { s.cloth.enableShearing = false; });
        row("bending", SceneChange::Motion, [](Scene& s) { s.cloth.enableBending = false; });
        row("pinned", SceneChange::Motion, [](Scene& s) { s.cloth.pinned.push_back({1, 1}); });
        row("a sphere more", SceneChange::Motion, [](Scene& s) { s.spheres.emplace_back(); });
        row("origin", SceneChange::Motion, [](Scene& s) { s.spheres[0].origin.z() = 1; });
        row("radius", SceneChange::Motion, [](Scene& s) { s.spheres[0].radius = 1; });
        row("friction of a sphere", SceneChange::Motion, [](Scene& s) { s.spheres[0].friction = 1; });
        row("no plane", SceneChange::Motion, [](Scene& s) { s.planes.clear(); });
        row("point", SceneChange::Motion, [](Scene& s) { s.planes[0].point.x() = 1; });
        row("normal", SceneChange::Motion, [](Scene& s) { s.planes[0].normal.x() = 1; });
        row("friction of a plane", SceneChange::Motion, [](Scene& s) { s.planes[0].friction = 1; });
        row("gravity", SceneChange::Motion, [](Scene& s) { s.simulation.gravity.y() = 0; });
        row("frames per second", SceneChange::Motion, [](Scene& s) { s.simulation.framesPerSecond = 1; });
        row("steps per frame", SceneChange::Motion, [](Scene& s) { s.simulation.stepsPerFrame = 1; });
        row("shader", SceneChange::Appearance, [](Scene& s) { s.appearance.shader = "Mirror"; });
        row("color", SceneChange::Appearance, [](Scene& s) { s.appearance.color[1] = 0; });
        row("springs drawn", SceneChange::Appearance, [](Scene& s) { s.appearance.springsDrawn[1] = false; });
        row("springs over", SceneChange::Appearance,
            [](Scene& s) { s.appearance.springsOverSurface = true; });
        row("back colour", SceneChange::Appearance, [](Scene& s) { s.appearance.backColor = Rgb{0, 0, 0}; });
        row("sides", SceneChange::Appearance, [](Scene& s) { s.appearance.twoSided = false; });
        row("springs coloured", SceneChange::Appearance,
            [](Scene& s) { s.appearance.springColoring = SpringColoring::ByStrain; });
        row("strain range", SceneChange::Appearance, [](Scene& s) { s.appearance.strainRange = 0; });
        row("light position", SceneChange::Appearance, [](Scene& s) { s.appearance.lightPosition[2] = 0; });
        row("light intensity", SceneChange::Appearance, [](Scene& s) { s.appearance.lightIntensity[1] = 0; });
        row("shadows", SceneChange::Appearance, [](Scene& s) { s.appearance.shadows = false; });
        row("background", SceneChange::Appearance, [](Scene& s) { s.appearance.background = Rgb{0, 0, 0}; });
        row("ground grid", SceneChange::Appearance, [](Scene& s) { s.appearance.groundGrid = false; });
        row("axes", SceneChange::Appearance, [](Scene& s) { s.appearance.axes = false; });
        row("samples", SceneChange::Appearance, [](Scene& s) { s.appearance.samples = 1; });
        row("mesh resolution", SceneChange::Appearance, [](Scene& s) { s.appearance.meshResolution = 16; });
        row("normal scaling", SceneChange::Appearance, [](Scene& s) { s.appearance.normalScaling = 1; });
        row("height scaling", SceneChange::Appearance, [](Scene& s) { s.appearance.heightScaling = 0; });
        row("texture", SceneChange::Appearance, [](Scene& s) { s.appearance.textures[3] = "a.png"; });
        row("cubemap", SceneChange::Appearance, [](Scene& s) { s.appearance.cubemap = "a"; });
        row("shader with a uniform", SceneChange::Appearance,
            [](Scene& s) { s.appearance.uniforms["Phong"]["u_a"] = 1.0; });
        row("shader without uniforms", SceneChange::Appearance,
            [](Scene& s) { s.appearance.uniforms["Phong"]; });
        row("unknown of appearance", SceneChange::Appearance,
            [](Scene& s) { s.appearance.unknownKeys = "{\"a\":1}"; });
        row("unknown of textures", SceneChange::Appearance,
            [](Scene& s) { s.appearance.unknownTextureKeys = "{\"a\":1}"; });
        row("camera", SceneChange::Appearance, [](Scene& s) { s.camera.emplace(); });
        row("unknown at the top", SceneChange::Appearance, [](Scene& s) { s.unknownKeys = "{\"a\":1}"; });
        row("unknown of cloth", SceneChange::Appearance, [](Scene& s) { s.cloth.unknownKeys = "{\"a\":1}"; });
        row("unknown of a sphere", SceneChange::Appearance,
            [](Scene& s) { s.spheres[0].unknownKeys = "{\"a\":1}"; });
        row("unknown of a plane", SceneChange::Appearance,
            [](Scene& s) { s.planes[0].unknownKeys = "{\"a\":1}"; });
        row("unknown of simulation", SceneChange::Appearance,
            [](Scene& s) { s.simulation.unknownKeys = "{\"a\":1}"; });
        row("unknown of springs drawn", SceneChange::Appearance,
            [](Scene& s) { s.appearance.unknownSpringKeys = "{\"a\":1}"; });
        row("the strongest of several", SceneChange::Start, [](Scene& s) {
            s.appearance.shader = "Mirror";
            s.cloth.ks = 1;
            s.cloth.width = 2;
        });
    }
    void anEditIsToldByWhatItTouches() {
        QFETCH(Edit, edit);
        QFETCH(SceneChange, change);
        Scene before;
        before.spheres.emplace_back();
        before.planes.emplace_back();
        Scene after = before;
        edit(after);
        QCOMPARE(compareScenes(before, after), change);
        QCOMPARE(compareScenes(after, before), change);
        QCOMPARE(before == after, change == SceneChange::None);
    }

    void noParameterIsForgotten() {
        for (const Parameter& parameter : parameters()) {
            Scene after;
            const bool atMaximum = parameter.get(after) == parameter.maximum;
            parameter.set(after, atMaximum ? parameter.minimum : parameter.maximum);
            const SceneChange change = compareScenes(Scene{}, after);
            const bool isLook = parameter.object() == "appearance";
            QVERIFY2(isLook ? change == SceneChange::Appearance : change >= SceneChange::Motion,
                     parameter.id.data());
        }
    }

    void eachTypeOfSpringsHasItsSwitch() {
        Cloth cloth;
        cloth.enableShearing = false;
        QVERIFY(cloth.enabled(SpringType::Structural));
        QVERIFY(!cloth.enabled(SpringType::Shearing));
        QVERIFY(cloth.enabled(SpringType::Bending));
    }
};

QTEST_APPLESS_MAIN(TestScene)
#include "tst_scene.moc"
