// No value and no key of a scene is lost or changed by saving and loading it.
#include "tests/support/random_scene.h"
#include "tests/support/scene_text.h"

#include <QTest>

using namespace clothlab;

class TestSceneRoundTrip : public QObject {
    Q_OBJECT
private slots:
    void randomScenesComeBackTheSame() {
        constexpr std::uint32_t kScenes = 1000;
        for (std::uint32_t seed = 1; seed <= kScenes; ++seed) {
            const std::string what = "seed " + std::to_string(seed);
            const Scene scene = test::randomScene(seed);
            const Diagnostics found = validate(scene);
            QVERIFY2(!hasErrors(found), (what + ": not valid: " + test::toText(found)).c_str());

            const std::string text = writeScene(scene);
            const SceneReading reading = readScene(text);
            QVERIFY2(reading.scene.has_value(),
                     (what + ": " + test::toText(reading.diagnostics) + text).c_str());
            QVERIFY2(*reading.scene == scene, (what + ": read back as another scene\n" + text).c_str());
            // Equal text as well: 0 and -0 are equal numbers.
            QVERIFY2(writeScene(*reading.scene) == text,
                     (what + ": written again as another text\n" + text).c_str());
        }
    }

    void whatIsWrittenIsJsonForOthersToo() {
        for (std::uint32_t seed = 1; seed <= 200; ++seed) {
            const Scene scene = test::randomScene(seed);
            const test::Json json = test::Json::parse(writeScene(scene), nullptr, false);
            QVERIFY2(!json.is_discarded(), ("seed " + std::to_string(seed)).c_str());
            QCOMPARE(json["cloth"]["ks"].get<double>(), scene.cloth.ks);
            QCOMPARE(json["cloth"]["width"].get<double>(), scene.cloth.width);
            QCOMPARE(json["cloth"]["pinned"].size(), scene.cloth.pinned.size());
        }
    }
};

QTEST_APPLESS_MAIN(TestSceneRoundTrip)
#include "tst_scene_round_trip.moc"
