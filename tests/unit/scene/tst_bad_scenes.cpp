// Whatever a scene file holds, it gives words and never a crash, a hang or a scene that cannot be simulated.
#include "tests/support/scene_text.h"

#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <functional>

#include <sys/stat.h>
#include <unistd.h>

using namespace clothlab;
using test::Json;

namespace {

Json with(const char* pointer, const Json& value) {
    Json json = test::everyKeyScene();
    json[Json::json_pointer(pointer)] = value;
    return json;
}

Json manyUniforms(int shaders, int ofEach) {
    Json values = Json::object();
    for (int i = 0; i < ofEach; ++i)
        values["u_" + std::to_string(i)] = i;
    Json all = Json::object();
    for (int i = 0; i < shaders; ++i)
        all["Shader " + std::to_string(i)] = values;
    return all;
}

bool isUniformValue(const Json& value) {
    return value.is_boolean() || value.is_number() || value.is_string() ||
           (value.is_array() && value.size() > 1 && value[0].is_number());
}

std::string utf16(const std::string& ascii) {
    std::string text = "\xFF\xFE";
    for (const char c : ascii)
        text.append({c, '\0'});
    return text;
}

} // namespace

class TestBadScenes : public QObject {
    Q_OBJECT
private slots:
    void aSceneCutOffAnywhere() {
        for (const std::string& text : {test::courseText(), test::everyKeyScene().dump(2)}) {
            for (std::size_t length = 0; length < text.size(); ++length) {
                const SceneReading reading = readScene(std::string_view(text).substr(0, length));
                const std::string wrong = test::badAnswer(reading);
                QVERIFY2(wrong.empty(), (std::to_string(length) + " bytes: " + wrong).c_str());
                QVERIFY(length == 0 || !reading.diagnostics.front().place.empty());
            }
        }
    }

    void aValueOfTheWrongType() {
        const std::array<Json, 9> values{nullptr,
                                         true,
                                         "text",
                                         -0.5,
                                         Json::array(),
                                         Json::object(),
                                         Json::array({1}),
                                         Json::array({1, 2, 3, 4}),
                                         Json::array({"a", "b", "c"})};
        int count = 0;
        const std::function<void(const Json&, const std::string&, const std::string&)> go =
            [&](const Json& good, const std::string& pointer, const std::string& place) {
                for (const Json& value : values) {
                    const bool fits = value.type() == good.type() ||
                                      (value.is_number() && good.is_number()) ||
                                      (good.is_array() && value.empty());
                    if (place.starts_with("appearance.uniforms.") && isUniformValue(good) &&
                        isUniformValue(value))
                        continue;
                    const bool mayBeEmpty = value.is_array() && value.empty();
                    const bool isListOfObjects =
                        place == "sphere" || place == "plane" || place == "cloth.pinned";
                    if (fits && !(value.is_array() && !value.empty()))
                        continue;
                    if (mayBeEmpty && isListOfObjects)
                        continue;
                    const SceneReading reading = readScene(with(pointer.c_str(), value).dump());
                    const std::string wrong = test::badAnswer(reading);
                    QVERIFY2(wrong.empty(), (place + " = " + value.dump() + ": " + wrong).c_str());
                    QVERIFY2(
                        reading.diagnostics.front().place.starts_with(place),
                        (place + " = " + value.dump() + ": " + test::toText(reading.diagnostics)).c_str());
                    ++count;
                }
                if (good.is_object()) {
                    for (const auto& [key, member] : good.items())
                        go(member, pointer + "/" + key, place.empty() ? key : place + "." + key);
                }
            };
        const Json every = test::everyKeyScene();
        for (const auto& [key, member] : every.items())
            go(member, "/" + key, key);
        QVERIFY(count > 200);
    }

    void aKeyThatIsThereTwice_data() {
        QTest::addColumn<QString>("place");
        for (const char* place :
             {"cloth", "cloth.ks", "cloth.pinned", "sphere", "sphere.radius", "plane.normal",
              "simulation.seed", "appearance.shader", "appearance.springs_drawn.bending",
              "appearance.uniforms", "appearance.textures.texture_3", "appearance.uniforms.Checks",
              "appearance.uniforms.Phong.u_roughness", "camera.target"})
            QTest::newRow(place) << place;
    }
    void aKeyThatIsThereTwice() {
        QFETCH(QString, place);
        const std::string key = place.section('.', -1).toStdString();
        const std::string text = test::replaced(test::everyKeyScene().dump(),
                                                "\"" + key + "\":", "\"" + key + "\":0,\"" + key + "\":");
        const SceneReading reading = readScene(text);
        QCOMPARE(test::badAnswer(reading), "");
        QCOMPARE(reading.diagnostics.front().place, place.toStdString());
    }

    void aBadValue_data();
    void aBadValue() {
        QFETCH(QByteArray, text);
        QFETCH(QString, place);
        const SceneReading reading = readScene(text.toStdString());
        QCOMPARE(test::badAnswer(reading), "");
        QVERIFY2(test::find(reading.diagnostics, Severity::Error, place.toStdString()),
                 test::toText(reading.diagnostics).c_str());
    }

    void textThatIsNotJson_data();
    void textThatIsNotJson() {
        QFETCH(QByteArray, text);
        QFETCH(QString, place);
        QFETCH(QString, words);
        const SceneReading reading = readScene(text.toStdString());
        QCOMPARE(test::badAnswer(reading), "");
        QCOMPARE(reading.diagnostics.size(), std::size_t(1));
        QCOMPARE(reading.diagnostics.front().place, place.toStdString());
        QVERIFY2(reading.diagnostics.front().message.find(words.toStdString()) != std::string::npos,
                 reading.diagnostics.front().message.c_str());
    }

    void whatIsNotAFile_data() {
        QTest::addColumn<QString>("kind");
        for (const char* kind : {"missing", "folder", "pipe", "device", "no permission", "no name",
                                 "zero byte", "link to itself", "too large", "through a file", "long name"})
            QTest::newRow(kind) << kind;
    }
    void whatIsNotAFile() {
        QFETCH(QString, kind);
        const QTemporaryDir folder;
        std::string path = folder.filePath("a.json").toStdString();
        if (kind == "folder")
            path = folder.path().toStdString();
        else if (kind == "pipe")
            QCOMPARE(::mkfifo(path.c_str(), 0600), 0);
        else if (kind == "device")
            path = "/dev/zero";
        else if (kind == "no name")
            path.clear();
        else if (kind == "zero byte")
            path = std::string("a\0.json", 7);
        else if (kind == "link to itself")
            QCOMPARE(::symlink(path.c_str(), path.c_str()), 0);
        else if (kind == "through a file")
            path = test::scenePath("plane.json") + "/a.json";
        else if (kind == "long name")
            path += std::string(5000, 'a');
        else if (kind != "missing")
            QVERIFY(!saveScene(Scene{}, path));
        if (kind == "no permission")
            QCOMPARE(::chmod(path.c_str(), 0), 0);
        if (kind == "too large")
            QCOMPARE(::truncate(path.c_str(), off_t(kMaxSceneBytes) + 1), 0);
        if (kind == "no permission" && ::access(path.c_str(), R_OK) == 0)
            QSKIP("this user may read every file");
        QCOMPARE(test::badAnswer(loadScene(path)), "");
    }
};

void TestBadScenes::aBadValue_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("place");
    const auto row = [](const char* name, const char* pointer, const Json& value, const char* place) {
        QTest::newRow(name) << QByteArray::fromStdString(with(pointer, value).dump()) << QString(place);
    };
    row("width 0", "/cloth/width", 0, "cloth.width");
    row("negative width", "/cloth/width", -1, "cloth.width");
    row("height 0", "/cloth/height", 0.0, "cloth.height");
    row("negative height", "/cloth/height", -1e-9, "cloth.height");
    row("huge width", "/cloth/width", 1e300, "cloth.width");
    row("one point across", "/cloth/num_width_points", 1, "cloth.num_width_points");
    row("one point down", "/cloth/num_height_points", 1, "cloth.num_height_points");
    row("no points", "/cloth/num_width_points", 0, "cloth.num_width_points");
    row("negative points", "/cloth/num_width_points", -50, "cloth.num_width_points");
    row("half a point", "/cloth/num_width_points", 50.5, "cloth.num_width_points");
    row("10^9 points", "/cloth/num_width_points", 1'000'000'000, "cloth.num_width_points");
    row("10^18 points", "/cloth/num_width_points", 1'000'000'000'000'000'000, "cloth.num_width_points");
    row("negative density", "/cloth/density", -150, "cloth.density");
    row("no density", "/cloth/density", 0, "cloth.density");
    row("negative ks", "/cloth/ks", -1, "cloth.ks");
    row("huge ks", "/cloth/ks", 1e10, "cloth.ks");
    row("negative damping", "/cloth/damping", -0.1, "cloth.damping");
    row("damping above 100 %", "/cloth/damping", 100.1, "cloth.damping");
    row("negative thickness", "/cloth/thickness", -0.1, "cloth.thickness");
    row("orientation 2", "/cloth/orientation", 2, "cloth.orientation");
    row("orientation 0.5", "/cloth/orientation", 0.5, "cloth.orientation");
    row("orientation true", "/cloth/orientation", true, "cloth.orientation");
    row("flag 2", "/cloth/enable_bending", 2, "cloth.enable_bending");
    row("flag as text", "/cloth/enable_bending", "true", "cloth.enable_bending");
    row("pin right of the grid", "/cloth/pinned/1", {50, 0}, "cloth.pinned[1]");
    row("pin below the grid", "/cloth/pinned/1", {0, 50}, "cloth.pinned[1]");
    row("negative pin", "/cloth/pinned/0", {-1, 0}, "cloth.pinned[0]");
    row("pin of one number", "/cloth/pinned/0", Json::array({1}), "cloth.pinned[0]");
    row("pin of three numbers", "/cloth/pinned/0", {1, 2, 3}, "cloth.pinned[0]");
    row("pin of no numbers", "/cloth/pinned/0", Json::array(), "cloth.pinned[0]");
    row("pin between points", "/cloth/pinned/0", {0.5, 0}, "cloth.pinned[0]");
    row("pin far away", "/cloth/pinned/0", {1e18, 0}, "cloth.pinned[0]");
    row("pin of text", "/cloth/pinned/0", {"0", 0}, "cloth.pinned[0][0]");
    row("pin as an index", "/cloth/pinned/0", 7, "cloth.pinned[0]");
    row("pin as an object", "/cloth/pinned/0", {{"x", 1}, {"y", 1}}, "cloth.pinned[0]");
    row("no cloths", "/cloth", Json::array(), "cloth");
    row("two cloths", "/cloth", Json::array({test::courseScene()["cloth"], test::courseScene()["cloth"]}),
        "cloth");
    row("a list in a list", "/cloth", Json::array({Json::array()}), "cloth[0]");
    row("sphere without origin", "/sphere", {{"radius", 1}, {"friction", 0}}, "sphere.origin");
    row("sphere without radius", "/sphere", {{"origin", {1, 2, 3}}}, "sphere.radius");
    row("second sphere empty", "/sphere", Json::array({test::courseScene()["sphere"], Json::object()}),
        "sphere[1].origin");
    row("number among spheres", "/sphere", Json::array({7}), "sphere[0]");
    row("radius 0", "/sphere/radius", 0, "sphere.radius");
    row("negative radius", "/sphere/radius", -0.2, "sphere.radius");
    row("huge radius", "/sphere/radius", 1e7, "sphere.radius");
    row("origin far away", "/sphere/origin", {0, 1e7, 0}, "sphere.origin[1]");
    row("origin in the plane", "/sphere/origin", {0, 1}, "sphere.origin");
    row("origin with null", "/sphere/origin", {0, 1, nullptr}, "sphere.origin[2]");
    row("friction above 1", "/sphere/friction", 1.1, "sphere.friction");
    row("negative friction", "/plane/friction", -0.1, "plane.friction");
    row("no normal", "/plane", {{"point", {0, 0, 0}}, {"friction", 0.5}}, "plane.normal");
    row("no point", "/plane", {{"normal", {0, 1, 0}}, {"friction", 0.5}}, "plane.point");
    row("zero normal", "/plane/normal", {0, 0, 0}, "plane.normal");
    row("normal too short to have a direction", "/plane/normal", {0, 1e-200, 0}, "plane.normal");
    row("gravity of two numbers", "/simulation/gravity", {0, -9.8}, "simulation.gravity");
    row("gravity of 10^9", "/simulation/gravity", {0, -1e9, 0}, "simulation.gravity[1]");
    row("no frames", "/simulation/frames_per_second", 0, "simulation.frames_per_second");
    row("half a step", "/simulation/steps_per_frame", 0.5, "simulation.steps_per_frame");
    row("negative seed", "/simulation/seed", -1, "simulation.seed");
    row("seed of 2^32", "/simulation/seed", 4294967296, "simulation.seed");
    row("color above 1", "/appearance/color", {1, 2, 1}, "appearance.color[1]");
    row("color of four numbers", "/appearance/color", {1, 1, 1, 1}, "appearance.color");
    row("shader without a name", "/appearance/shader", "", "appearance.shader");
    row("shader elsewhere", "/appearance/shader", "../../etc/passwd", "appearance.shader");
    row("shader with a zero byte", "/appearance/shader", std::string("a\0b", 3), "appearance.shader");
    row("back color of two numbers", "/appearance/back_color", {1, 1}, "appearance.back_color");
    row("background above 1", "/appearance/background", {0, 0, 256}, "appearance.background[2]");
    row("two-sided by a number", "/appearance/two_sided", 2, "appearance.two_sided");
    row("springs by their length", "/appearance/springs_colored_by", "length",
        "appearance.springs_colored_by");
    row("negative strain", "/appearance/strain_range", -0.1, "appearance.strain_range");
    row("tiny strain", "/appearance/strain_range", 1e-7, "appearance.strain_range");
    row("light far away", "/appearance/light_position", {0, 1e7, 0}, "appearance.light_position[1]");
    row("light in the plane", "/appearance/light_position", {0, 1}, "appearance.light_position");
    row("dark light", "/appearance/light_intensity", {0, 0, -1}, "appearance.light_intensity[2]");
    row("an element as a key", "/appearance/light_intensity", {{"[2]", 1}}, "appearance.light_intensity");
    row("3 samples", "/appearance/samples", 3, "appearance.samples");
    row("no samples", "/appearance/samples", 0, "appearance.samples");
    row("16 samples", "/appearance/samples", 16, "appearance.samples");
    row("half a cell", "/appearance/mesh_resolution", 16.5, "appearance.mesh_resolution");
    row("15 cells", "/appearance/mesh_resolution", 15, "appearance.mesh_resolution");
    row("513 cells", "/appearance/mesh_resolution", 513, "appearance.mesh_resolution");
    row("steep bumps", "/appearance/normal_scaling", 101, "appearance.normal_scaling");
    row("deep relief", "/appearance/height_scaling", -10.5, "appearance.height_scaling");
    row("texture with a zero byte", "/appearance/textures/texture_2", std::string("a\0b", 3),
        "appearance.textures.texture_2");
    row("long cubemap", "/appearance/cubemap", std::string(4097, 'a'), "appearance.cubemap");
    row("uniform of one number", "/appearance/uniforms/Phong/u_roughness", Json::array({1}),
        "appearance.uniforms.Phong.u_roughness");
    row("uniform of five numbers", "/appearance/uniforms/Phong/u_roughness", {1, 2, 3, 4, 5},
        "appearance.uniforms.Phong.u_roughness");
    row("uniform of text and numbers", "/appearance/uniforms/Phong/u_roughness", {1, "2"},
        "appearance.uniforms.Phong.u_roughness[1]");
    row("matrix as a uniform", "/appearance/uniforms/Phong/u_roughness", {{1, 0}, {0, 1}},
        "appearance.uniforms.Phong.u_roughness[0]");
    row("no name of a uniform", "/appearance/uniforms/Phong/u roughness", 1,
        "appearance.uniforms.Phong.u roughness");
    row("uniforms of a shader elsewhere", "/appearance/uniforms", {{"../a", Json::object()}},
        "appearance.uniforms.../a");
    row("uniforms of no shader", "/appearance/uniforms", {{"u_roughness", 0.5}},
        "appearance.uniforms.u_roughness");
    row("too many shaders", "/appearance/uniforms", manyUniforms(1001, 0), "appearance.uniforms");
    row("too many uniforms", "/appearance/uniforms", manyUniforms(7, 143), "appearance.uniforms");
    row("camera at its target", "/camera/distance", 0, "camera.distance");
    row("camera over the pole", "/camera/elevation", 91, "camera.elevation");

    Json many = test::courseScene();
    many["cloth"]["num_width_points"] = many["cloth"]["num_height_points"] = 60000;
    QTest::newRow("3.6 · 10^9 points") << QByteArray::fromStdString(many.dump()) << "cloth.num_width_points";
    QTest::newRow("no cloth") << QByteArray("{}") << "cloth";
    QTest::newRow("only a sphere") << QByteArray("{\"sphere\": {\"origin\": [0,0,0], \"radius\": 1}}")
                                   << "cloth";
    for (const char* text : {"null", "true", "7", "\"cloth\"", "[]", "[{\"cloth\": {}}]"})
        QTest::addRow("not an object: %s", text) << QByteArray(text) << "";
}

void TestBadScenes::textThatIsNotJson_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("place");
    QTest::addColumn<QString>("words");
    const auto row = [](const char* name, const std::string& text, const char* place, const char* words) {
        QTest::newRow(name) << QByteArray::fromStdString(text) << QString(place) << QString(words);
    };
    const auto ks = [](const std::string& value) { return "{\n \"cloth\": {\"ks\": " + value + "}}"; };
    constexpr const char* kAtValue = "line 2, column 18";
    row("NaN", ks("NaN"), kAtValue, "NaN is not a number");
    row("nan", ks("nan"), kAtValue, "nan is not a number");
    row("-Infinity", ks("-Infinity"), kAtValue, "-Infinity is not a number");
    row("1e400", ks("1e400"), kAtValue, "number out of range: 1e400");
    row("-1e400", ks("-1e400"), kAtValue, "number out of range: -1e400");
    row("leading zero", ks("05"), kAtValue, "05 is not written as JSON");
    row("plus sign", ks("+5"), kAtValue, "+5 is not written as JSON");
    row("no digit after the point", ks("5."), kAtValue, "5. is not written as JSON");
    row("no digit before the point", ks(".5"), kAtValue, ".5 is not written as JSON");
    row("hexadecimal", ks("0x10"), kAtValue, "0x10 is not written as JSON");
    row("decimal comma", ks("0,5"), "line 2, column 20", "a key in double quotes is missing");
    row("True", ks("True"), kAtValue, "the word True");
    row("single quotes", ks("'5'"), kAtValue, "single quotes");
    row("a long word", ks(std::string(1000, 'w')), kAtValue, "the word www");
    row("comment", ks("5 // stiff\n"), "line 2, column 20", "comment");
    row("comment before", "# a scene\n{}", "line 1, column 1", "comment");
    row("value missing", ks(""), kAtValue, "a value is missing before }");
    row("comma before }", ks("5,"), "line 2, column 20", "a comma stands before }");
    row("comma before ]", "[1,\n]", "line 2, column 1", "a comma stands before ]");
    row("two commas", "[1,,2]", "line 1, column 4", "a value is missing before ,");
    row("comma missing", ks("5 \"density\": 1"), "line 2, column 20",
        "a comma or } is missing before \"density\"");
    row("comma missing in a list", "[1 2]", "line 1, column 4", "a comma or ] is missing before 2");
    row("colon missing", "{\"cloth\" {}}", "line 1, column 10", "a colon is missing before {");
    row("key without quotes", "{cloth: {}}", "line 1, column 2", "a key in double quotes is missing");
    row("key that is a number", "{1: {}}", "line 1, column 2", "a key in double quotes is missing");
    row("wrong bracket", "{\"cloth\": [1}", "line 1, column 13", "a comma or ] is missing before }");
    row("bracket too many", "{\"cloth\": {}}}", "line 1, column 14", "more text after the end");
    row("two scenes", "{} {}", "line 1, column 4", "more text after the end");
    row("only a bracket", "}", "line 1, column 1", "a value is missing before }");
    row("string over a line", "{\"cl\noth\": 1}", "line 1, column 2", "goes over the end of its line");
    row("last control character", "{\"cl\x1Foth\": 1}", "line 1, column 2", "control character");
    row("control character", "{\"cl\x01oth\": 1}", "line 1, column 2", "control character");
    row("unknown escape", "{\"cl\\qoth\": 1}", "line 1, column 5", "starts no character");
    row("short \\u", "{\"cl\\u12\": 1}", "line 1, column 5", "starts no character");
    row("half a surrogate pair", "{\"\\ud83e\": 1}", "line 1, column 3", "starts no character");
    row("columns count characters", "{\"äöü\": x}", "line 1, column 9", "the word x");
    row("empty", "", "", "is empty");
    row("white space only", " \n\t\r\n", "", "is empty");
    row("byte order mark only", "\xEF\xBB\xBF", "", "is empty");
    row("not UTF-8", "{\"cloth\":\n\"\xE4\"}", "line 2, column 2", "not UTF-8");
    row("UTF-8 that is too long", "{\"\xC0\xAF\": 1}", "line 1, column 3", "not UTF-8");
    row("UTF-8 surrogate", "{\"\xED\xA0\x80\": 1}", "line 1, column 3", "not UTF-8");
    row("UTF-8 beyond Unicode", "{\"\xF4\x90\x80\x80\": 1}", "line 1, column 3", "not UTF-8");
    row("UTF-8 cut off", "{\"\xE2\x82", "line 1, column 3", "not UTF-8");
    row("UTF-16", utf16(test::courseText()), "", "UTF-16 or a binary file");
    row("UTF-16 without mark", utf16(test::courseText()).substr(2), "", "UTF-16 or a binary file");
    row("PNG", std::string("\x89PNG\r\n\x1A\n\0\0\0\rIHDR", 16), "line 1, column 1", "not UTF-8");
    row("zero byte at the end", "{\"cloth\": {}}" + std::string(1, '\0'), "line 1, column 14", "not UTF-8");
    row("65 levels", "{\"cloth\":" + std::string(64, '[') + std::string(64, ']') + "}",
        "cloth[0][0][0][0][0][0][0]…", "nested more than 64 levels");
    row("100,000 levels", std::string(100'000, '[') + std::string(100'000, ']'), "[0][0][0][0][0][0][0][0]…",
        "nested more than 64 levels");
    row("duplicate in an unknown object", "{\"cloth\": {}, \"x\": [0, {\"a\": 1, \"\\u0061\": 2}]}", "x[1].a",
        "twice");
    row("duplicate of two lines, shown on one", "{\"a\\nb\": 1, \"a\\nb\": 2}", "a b", "twice");
    row("HTML", "<!DOCTYPE html>", "line 1, column 1", "the word <!DOCTYPE");
    row("YAML", "cloth:\n  ks: 5", "line 1, column 1", "the word cloth");
}

QTEST_APPLESS_MAIN(TestBadScenes)
#include "tst_bad_scenes.moc"
