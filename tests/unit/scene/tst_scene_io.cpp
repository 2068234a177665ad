#include "simcore/scene/parameters.h"
#include "tests/support/scene_text.h"

#include <QTemporaryDir>
#include <QTest>

#include <cmath>
#include <filesystem>
#include <set>

using namespace clothlab;
using test::Json;

namespace {

constexpr std::array kCourseScenes{"pinned2.json", "pinned4.json", "plane.json", "selfCollision.json",
                                   "sphere.json"};

// What the course's loader asks of a file: these keys at the top and no others, each an object with all of
// its keys, each of the type that its JSON library is asked for. Returns the first thing it would refuse.
std::string refusalOfTheCoursesLoader(const Json& scene) {
    const auto isVector = [](const Json& v) {
        return v.is_array() && v.size() == 3 && v[0].is_number() && v[1].is_number() && v[2].is_number();
    };
    const auto missing = [](const Json& object, std::initializer_list<const char*> keys,
                            auto accepts) -> std::string {
        for (const char* key : keys) {
            if (!object.contains(key) || !accepts(object[key]))
                return key;
        }
        return "";
    };
    const auto isNumber = [](const Json& v) { return v.is_number(); };
    const auto isFlag = [](const Json& v) { return v.is_boolean(); };
    const auto isPins = [](const Json& v) {
        return v.is_array() && std::all_of(v.begin(), v.end(), [](const Json& pin) {
                   return pin.is_array() && pin.size() == 2 && pin[0].is_number() && pin[1].is_number();
               });
    };
    std::string refusal;
    for (const auto& [key, object] : scene.items()) {
        if (!object.is_object())
            return key;
        if (key == "cloth")
            refusal = missing(object,
                              {"width", "height", "num_width_points", "num_height_points", "thickness",
                               "orientation", "damping", "density", "ks"},
                              isNumber) +
                      missing(object, {"enable_structural", "enable_shearing", "enable_bending"}, isFlag) +
                      missing(object, {"pinned"}, isPins);
        else if (key == "sphere")
            refusal =
                missing(object, {"origin"}, isVector) + missing(object, {"radius", "friction"}, isNumber);
        else if (key == "plane")
            refusal =
                missing(object, {"point", "normal"}, isVector) + missing(object, {"friction"}, isNumber);
        else
            return key;
        if (!refusal.empty())
            return key + "." + refusal;
    }
    return "";
}

Scene load(const std::string& text) {
    const SceneReading reading = readScene(text);
    if (!reading.scene)
        qFatal("%s", test::toText(reading.diagnostics).c_str());
    return *reading.scene;
}

Scene load(const Json& json) {
    return load(json.dump());
}

std::vector<std::string> keysOf(const Json& object) {
    std::vector<std::string> keys;
    for (const auto& [key, value] : object.items())
        keys.push_back(key);
    return keys;
}

} // namespace

class TestSceneIo : public QObject {
    Q_OBJECT
private slots:
    void courseScenesLoadWithTheCoursesValues() {
        for (const char* name : kCourseScenes) {
            const SceneReading reading = loadScene(test::scenePath(name));
            QVERIFY2(reading.diagnostics.empty(), test::toText(reading.diagnostics).c_str());
            const Cloth& cloth = reading.scene->cloth;
            QCOMPARE(cloth.width, 1.0);
            QCOMPARE(cloth.height, 1.0);
            QCOMPARE(cloth.numWidthPoints, 50);
            QCOMPARE(cloth.numHeightPoints, 50);
            QCOMPARE(cloth.thickness, 0.0095);
            QCOMPARE(cloth.damping, 0.2);
            QCOMPARE(cloth.density, 150.0);
            QCOMPARE(cloth.ks, 5000.0);
            QVERIFY(cloth.enableStructural && cloth.enableShearing && cloth.enableBending);
            QCOMPARE(cloth.orientation == Orientation::Vertical, std::string(name) == "selfCollision.json");
            QVERIFY(reading.scene->simulation == SimulationSettings{});
            QVERIFY(reading.scene->appearance == Appearance{});
            QVERIFY(!reading.scene->camera);
        }
    }

    void courseScenesHoldWhatTheirNamesSay() {
        const auto scene = [](const char* name) { return *loadScene(test::scenePath(name)).scene; };
        const std::vector<GridPoint> two{{0, 0}, {49, 0}};
        const std::vector<GridPoint> four{{0, 0}, {49, 0}, {0, 49}, {49, 49}};
        QVERIFY(scene("pinned2.json").cloth.pinned == two);
        QVERIFY(scene("pinned4.json").cloth.pinned == four);
        const Sphere sphere = scene("sphere.json").spheres.at(0);
        QVERIFY(sphere.origin == Vec3(0.5, 0.2, 0.5));
        QCOMPARE(sphere.radius, 0.2);
        QCOMPARE(sphere.friction, 0.3);
        for (const char* name : {"plane.json", "selfCollision.json"}) {
            const Plane plane = scene(name).planes.at(0);
            QVERIFY(plane.point == Vec3(0, 0, 0) && plane.normal == Vec3(0, 1, 0));
            QCOMPARE(plane.friction, 0.5);
        }
    }

    void everySceneInTheFolderIsAsWeWriteIt() {
        int count = 0;
        for (const auto& entry : std::filesystem::directory_iterator(test::scenePath(""))) {
            const std::string path = entry.path().string();
            const SceneReading reading = loadScene(path);
            QVERIFY2(reading.scene && reading.diagnostics.empty(),
                     (path + ": " + test::toText(reading.diagnostics)).c_str());
            QCOMPARE(QString::fromStdString(writeScene(*reading.scene)),
                     QString::fromStdString(test::readText(path)));
            ++count;
        }
        QVERIFY(count >= int(kCourseScenes.size()));
    }

    void theCoursesLoaderTakesCourseScenes() {
        for (const char* name : kCourseScenes)
            QCOMPARE(
                refusalOfTheCoursesLoader(Json::parse(writeScene(*loadScene(test::scenePath(name)).scene))),
                "");
        QCOMPARE(refusalOfTheCoursesLoader(Json::parse(writeScene(Scene{}))), "");
        QCOMPARE(refusalOfTheCoursesLoader(Json::parse(writeScene(load(test::courseScene())))), "");
        // The reading of its demands is itself worth something only if it refuses.
        QVERIFY(refusalOfTheCoursesLoader(test::everyKeyScene()) == "simulation");
        Json incomplete = test::courseScene();
        incomplete["cloth"].erase("ks");
        QVERIFY(refusalOfTheCoursesLoader(incomplete) == "cloth.ks");
    }

    void keysAreWrittenInTheCoursesOrder() {
        const Json written = Json::parse(writeScene(load(test::everyKeyScene())));
        const Json every = test::everyKeyScene();
        QVERIFY(keysOf(written) == keysOf(every));
        for (const auto& [key, object] : every.items())
            QVERIFY2(keysOf(written[key]) == keysOf(object), key.c_str());
        QVERIFY(written == every);
    }

    void onlyWhatIsNotAtItsDefaultGoesBeyondTheCoursesFormat() {
        Scene scene;
        scene.simulation.stepsPerFrame = 31;
        scene.appearance.springsDrawn[1] = false;
        const Json written = Json::parse(writeScene(scene));
        QVERIFY(keysOf(written) == (std::vector<std::string>{"cloth", "simulation", "appearance"}));
        QVERIFY(written["simulation"] == Json::parse(R"({"steps_per_frame": 31})"));
        QVERIFY(
            written["appearance"] ==
            Json::parse(R"({"springs_drawn": {"structural": true, "shearing": false, "bending": true}})"));
    }

    void oneColliderIsAnObjectSeveralAreAList() {
        Json json = test::courseScene();
        const Json sphere = json["sphere"];
        for (const std::size_t count : {0U, 1U, 2U, 3U}) {
            json["sphere"] = Json::array();
            for (std::size_t i = 0; i < count; ++i)
                json["sphere"].push_back(sphere);
            const Scene scene = load(json);
            QCOMPARE(scene.spheres.size(), count);
            const Json written = Json::parse(writeScene(scene));
            QCOMPARE(written.contains("sphere"), count > 0);
            if (count > 0)
                QCOMPARE(written["sphere"].is_array(), count > 1);
            QVERIFY(load(written) == scene);
        }
    }

    void aListOfOneClothIsACloth() {
        Json json = test::courseScene();
        json["cloth"] = Json::array({json["cloth"]});
        QVERIFY(load(json) == load(test::courseScene()));
    }

    void missingKeysTakeTheirDefaultWithAWarning() {
        const Scene byDefault;
        const Json cloth = test::courseScene()["cloth"];
        for (const auto& [key, value] : cloth.items()) {
            Json json = test::courseScene();
            json["cloth"].erase(key);
            const SceneReading reading = readScene(json.dump());
            QVERIFY2(reading.scene.has_value(), key.c_str());
            QVERIFY2(test::find(reading.diagnostics, Severity::Warning, "cloth." + key), key.c_str());
        }
        const SceneReading reading = readScene(R"({"cloth": {}})");
        QVERIFY(reading.scene && reading.scene->cloth == byDefault.cloth);
    }

    void missingKeysOfExtensionsAreNotWorthAWord() {
        const SceneReading reading = readScene(
            R"({"cloth": )" + test::courseScene()["cloth"].dump() +
            R"(, "simulation": {}, "appearance": {"springs_drawn": {}, "textures": {}, "uniforms": {}}, "camera": {}})");
        QVERIFY2(reading.diagnostics.empty(), test::toText(reading.diagnostics).c_str());
        QVERIFY(reading.scene->simulation == SimulationSettings{});
        QVERIFY(reading.scene->appearance == Appearance{});
        QVERIFY(reading.scene->camera == CameraView{});
    }

    void unknownKeysSurviveAtEveryLevelToTheLetter() {
        const std::string own =
            R"("zeta": [1.50, 1E2, {"a": "\u00e9 \/"}], "alpha": 12345678901234567890123)";
        const std::string kept = R"({"zeta":[1.50,1E2,{"a":"\u00e9 \/"}],"alpha":12345678901234567890123})";
        const auto object = [&](const Json& known) {
            const std::string text = known.dump();
            return text.substr(0, text.size() - 1) + (known.empty() ? "" : ", ") + own + "}";
        };
        const Json every = test::everyKeyScene();
        Json appearance = every["appearance"];
        const std::string springs = object(appearance["springs_drawn"]);
        const std::string textures = object(appearance["textures"]);
        appearance.erase("springs_drawn");
        appearance.erase("textures");
        std::string appearanceText = object(appearance);
        appearanceText.insert(1, R"("springs_drawn": )" + springs + R"(, "textures": )" + textures + ", ");
        const std::string text = R"({"cloth": )" + object(every["cloth"]) + R"(, "sphere": [)" +
                                 object(every["sphere"]) + ", " + every["sphere"].dump() + R"(], "plane": )" +
                                 object(every["plane"]) + R"(, "simulation": )" +
                                 object(every["simulation"]) + R"(, "appearance": )" + appearanceText +
                                 R"(, "camera": )" + object(every["camera"]) + ", " + own + "}";
        const Scene scene = load(text);
        for (const std::string& unknown :
             {scene.unknownKeys, scene.cloth.unknownKeys, scene.spheres[0].unknownKeys,
              scene.planes[0].unknownKeys, scene.simulation.unknownKeys, scene.appearance.unknownKeys,
              scene.appearance.unknownSpringKeys, scene.appearance.unknownTextureKeys,
              scene.camera->unknownKeys})
            QCOMPARE(unknown, kept);
        QCOMPARE(scene.spheres[1].unknownKeys, "");
        QVERIFY(load(writeScene(scene)) == scene);
        QVERIFY(nlohmann::json::parse(writeScene(scene)) == nlohmann::json::parse(text));
    }

    void unknownKeysAreWarnedAboutWithAGuess() {
        Json json = test::courseScene();
        json["cloth"]["kss"] = 3;
        json["cloth"]["enable_shear"] = true;
        json["spheres"] = Json::array();
        json["cloth"]["colour_of_the_label"] = "red";
        const SceneReading reading = readScene(json.dump());
        const auto remedy = [&](const char* place) {
            const Diagnostic* d = test::find(reading.diagnostics, Severity::Warning, place);
            return d ? d->remedy : "no warning";
        };
        QCOMPARE(remedy("cloth.kss"), "did you mean ks?");
        QCOMPARE(remedy("cloth.enable_shear"), "did you mean enable_shearing?");
        QCOMPARE(remedy("spheres"), "did you mean sphere?");
        QCOMPARE(remedy("cloth.colour_of_the_label"), "");
        QVERIFY(reading.scene.has_value());
    }

    void numbersAreReadAsTheyAreMeant() {
        Json json = test::courseScene();
        std::string text = json.dump();
        const auto with = [&](const std::string& from, const std::string& to) {
            std::string changed = text;
            changed.replace(changed.find(from), from.size(), to);
            return load(changed);
        };
        QCOMPARE(with("\"num_width_points\":50", "\"num_width_points\":5.0e1").cloth.numWidthPoints, 50);
        QCOMPARE(with("\"ks\":5000", "\"ks\":1e9").cloth.ks, 1e9);
        QCOMPARE(with("\"ks\":5000", "\"ks\":0").cloth.ks, 0.0);
        QCOMPARE(with("\"ks\":5000", "\"ks\":5e-324").cloth.ks, 5e-324);
        QCOMPARE(with("\"ks\":5000", "\"ks\":1e-999").cloth.ks, 0.0);
        QCOMPARE(with("\"ks\":5000", "\"ks\":0.1000000000000000055511151231257827").cloth.ks, 0.1);
        QCOMPARE(with("\"ks\":5000", "\"k\\u0073\":7").cloth.ks, 7.0);
        QVERIFY(std::signbit(with("[0.5,0.2,0.5]", "[-0,0.2,0.5]").spheres[0].origin.x()));
    }

    void everyParameterMayBeAtItsLimits() {
        for (const Parameter& parameter : parameters()) {
            for (const double value : {parameter.minimum, parameter.maximum}) {
                Scene scene;
                scene.cloth.numWidthPoints = scene.cloth.numHeightPoints = 2;
                parameter.set(scene, value);
                const SceneReading reading = readScene(writeScene(scene));
                QVERIFY2(reading.scene && *reading.scene == scene, parameter.id.data());
            }
        }
    }

    void zeroAndOneAreTakenForFlags() {
        Json json = test::courseScene();
        json["cloth"]["enable_bending"] = 0;
        json["cloth"]["enable_shearing"] = 1;
        const SceneReading reading = readScene(json.dump());
        QVERIFY(reading.scene && !reading.scene->cloth.enableBending && reading.scene->cloth.enableShearing);
        QVERIFY(test::find(reading.diagnostics, Severity::Warning, "cloth.enable_bending"));
        QVERIFY(test::find(reading.diagnostics, Severity::Warning, "cloth.enable_shearing"));
    }

    void onlyTheKeysOfOpenObjectsAreCounted() {
        std::string list = "[";
        for (int i = 0; i < 60'000; ++i)
            list += R"({"a": 1, "b": 2},)";
        const std::string text = R"({"cloth": {}, "unknown": )" + list + "{}]}";
        QVERIFY(readScene(text).scene.has_value());
    }

    void aByteOrderMarkIsNoTrouble() {
        const SceneReading reading = readScene("\xEF\xBB\xBF" + test::courseScene().dump());
        QVERIFY2(reading.scene && reading.diagnostics.empty(), test::toText(reading.diagnostics).c_str());
    }

    void savingAndLoadingAFile() {
        const QTemporaryDir folder;
        const std::string path = folder.filePath("szene ü.json").toStdString();
        const Scene scene = load(test::everyKeyScene());
        const auto trouble = saveScene(scene, path);
        QVERIFY2(!trouble, trouble.value_or("").c_str());
        QVERIFY(loadScene(path).scene == scene);
    }

    void whatCouldNotBeReadBackIsNotSaved_data() {
        QTest::addColumn<QString>("kind");
        for (const char* kind : {"not finite", "unknown keys are no JSON", "known key among unknown ones",
                                 "too long", "too deep", "shader is no text"})
            QTest::newRow(kind) << kind;
    }
    void whatCouldNotBeReadBackIsNotSaved() {
        QFETCH(QString, kind);
        const QTemporaryDir folder;
        const std::string path = folder.filePath("a.json").toStdString();
        QVERIFY(!saveScene(Scene{}, path));
        const std::string before = test::readText(path);
        Scene scene;
        if (kind == "not finite")
            scene.cloth.ks = std::nan("");
        else if (kind == "unknown keys are no JSON")
            scene.cloth.unknownKeys = "{\"a\":";
        else if (kind == "known key among unknown ones")
            scene.cloth.unknownKeys = "{\"ks\":3}";
        else if (kind == "too long")
            scene.cloth.pinned.assign(1'500'000, {49, 49});
        else if (kind == "too deep") // one level deeper than where it was read
            scene.cloth.unknownKeys = "{\"a\":" + std::string(63, '[') + std::string(63, ']') + "}";
        else
            scene.appearance.shader = "\xFF";
        const auto trouble = saveScene(scene, path);
        QVERIFY(trouble && !trouble->empty());
        QVERIFY(test::readText(path) == before);
    }
};

QTEST_APPLESS_MAIN(TestSceneIo)
#include "tst_scene_io.moc"
