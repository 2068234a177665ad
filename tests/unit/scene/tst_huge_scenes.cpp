// Files of the largest size that is read, made to cost as much time and memory as they can.
#include "tests/support/scene_text.h"

#include <QTest>

#include <array>
#include <chrono>
#include <functional>

#include <sys/resource.h>

using namespace clothlab;
using test::courseText;
using test::replaced;

// Memory is then the sanitizer's. GCC tells by a macro, Clang by a feature.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool kSanitized = true;
#elif defined(__has_feature)
constexpr bool kSanitized = __has_feature(address_sanitizer) || __has_feature(thread_sanitizer);
#else
constexpr bool kSanitized = false;
#endif

namespace {

std::string repeated(const std::string& part, std::size_t bytes) {
    std::string text;
    text.reserve(bytes);
    while (text.size() + part.size() <= bytes)
        text += part;
    return text;
}

struct HugeScene {
    const char* name;
    std::function<std::string()> make;
};

constexpr std::size_t kHuge = kMaxSceneBytes - 1000;

// Course scene with something long in place of its pins.
std::string withPins(const std::string& pin) {
    std::string pins = repeated(pin + ",", kHuge);
    pins.pop_back();
    return replaced(courseText(), "[0,0],[49,0]", pins);
}

std::string manyKeys(std::size_t bytes) {
    std::string text;
    for (int i = 0; text.size() < bytes; ++i)
        text += "\"k" + std::to_string(i) + "\":1,";
    return text;
}

std::string withUniforms(const std::string& uniforms) {
    return "{\"cloth\":{},\"appearance\":{\"uniforms\":" + uniforms + "}}";
}

std::string manyShaders(std::size_t bytes) {
    std::string values = manyKeys(200);
    values.pop_back();
    std::string text = "{";
    for (int i = 0; text.size() < bytes; ++i)
        text += "\"s" + std::to_string(i) + "\":{" + values + "},";
    return text + "\"z\":{}}";
}

const std::array kHugeScenes{
    HugeScene{"16 MB of [", [] { return std::string(kHuge, '['); }},
    HugeScene{"16 MB of {\"a\":", [] { return repeated("{\"a\":", kHuge); }},
    HugeScene{"16 MB of spaces", [] { return std::string(kHuge, ' '); }},
    HugeScene{"16 MB of empty lines and a word", [] { return std::string(kHuge, '\n') + "x"; }},
    HugeScene{"16 MB of zero bytes", [] { return std::string(kHuge, '\0'); }},
    HugeScene{"16 MB of digits", [] { return std::string(kHuge, '9'); }},
    HugeScene{"16 MB of exponent", [] { return "[1e" + std::string(kHuge, '9') + "]"; }},
    HugeScene{"16 MB of backslashes", [] { return "\"" + std::string(kHuge, '\\'); }},
    HugeScene{"16 MB of string without end", [] { return "\"" + std::string(kHuge, 'a'); }},
    HugeScene{"16 MB of string", [] { return "{\"a\":\"" + std::string(kHuge, 'a') + "\"}"; }},
    HugeScene{"16 MB of escapes", [] { return "{\"a\":\"" + repeated("\\u0041", kHuge) + "\"}"; }},
    HugeScene{"16 MB of key", [] { return "{\"" + std::string(kHuge, 'a') + "\":1}"; }},
    HugeScene{"16 MB of word", [] { return std::string(kHuge, 'a'); }},
    HugeScene{"a shader's name of 16 MB",
              [] { return replaced(test::everyKeyScene().dump(), "Mirror", std::string(kHuge, 'a')); }},
    HugeScene{"16 MB of one uniform's numbers",
              [] { return withUniforms("{\"A\":{\"u\":[" + repeated("0,", kHuge) + "0]}}"); }},
    HugeScene{"16 MB of a shader of uniforms",
              [] { return withUniforms("{\"" + std::string(kHuge, 'a') + "\":{\"u\":1}}"); }},
    HugeScene{"16 MB of shaders with uniforms", [] { return withUniforms(manyShaders(kHuge)); }},
    HugeScene{"16 MB of distinct keys", [] { return "{" + manyKeys(kHuge) + "\"z\":1}"; }},
    HugeScene{"16 MB of one key", [] { return "{" + repeated("\"a\":1,", kHuge) + "\"a\":1}"; }},
    HugeScene{"16 MB of keys in nested objects",
              [] { return repeated("{" + manyKeys(300'000) + "\"z\":", kHuge); }},
    HugeScene{"16 MB of pins outside the grid", [] { return withPins("[0,50]"); }},
    HugeScene{"16 MB of pins that are no pairs", [] { return withPins("[0]"); }},
    HugeScene{"16 MB of pins of long numbers", [] { return withPins("[1e-9,0.000000000000000000000001]"); }},
    HugeScene{"16 MB of empty pins", [] { return withPins("[]"); }},
    HugeScene{"16 MB in one pin", [] { return withPins("0"); }},
    HugeScene{"16 MB of empty spheres",
              [] {
                  return replaced(courseText(), "{\"origin\":[0.5,0.2,0.5],\"radius\":0.2,\"friction\":0.3}",
                                  "[" + repeated("{},", kHuge) + "{}]");
              }},
    HugeScene{"16 MB of good spheres",
              [] {
                  return replaced(courseText(), "{\"origin\":[0.5,0.2,0.5],\"radius\":0.2,\"friction\":0.3}",
                                  "[" + repeated("{\"origin\":[5,0,0],\"radius\":1},", kHuge) +
                                      "{\"origin\":[5,0,0],\"radius\":1}]");
              }},
    HugeScene{"16 MB of cloths", [] { return "{\"cloth\":[" + repeated("{},", kHuge) + "{}]}"; }},
    HugeScene{"16 MB of unknown list and no cloth",
              [] { return "{\"a\":[" + repeated("1,", kHuge) + "1]}"; }},
    HugeScene{"one byte more than 16 MB", [] { return courseText() + std::string(kMaxSceneBytes, ' '); }},
};

} // namespace

class TestHugeScenes : public QObject {
    Q_OBJECT
private slots:
    void hugeFilesAreAnsweredSoonAndWithLittleMemory() {
        double worstSeconds = 0;
        const char* slowest = "";
        for (const HugeScene& huge : kHugeScenes) {
            const std::string text = huge.make();
            const auto start = std::chrono::steady_clock::now();
            const SceneReading reading = readScene(text);
            const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
            const std::string wrong = test::badAnswer(reading);
            QVERIFY2(wrong.empty(), (std::string(huge.name) + ": " + wrong).c_str());
            if (seconds.count() > worstSeconds) {
                worstSeconds = seconds.count();
                slowest = huge.name;
            }
        }
        struct rusage usage {};
        ::getrusage(RUSAGE_SELF, &usage);
        const long megabytes = usage.ru_maxrss / 1024;
        qInfo("slowest: %s, %.3f s; at most %ld MB, the text in hand and in the making included", slowest,
              worstSeconds, megabytes);
        if (!kSanitized)
            QVERIFY2(megabytes < 200, std::to_string(megabytes).c_str());
    }
};

QTEST_APPLESS_MAIN(TestHugeScenes)
#include "tst_huge_scenes.moc"
