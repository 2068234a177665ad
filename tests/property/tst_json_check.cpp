// Our walk through JSON text accepts what the library's parser accepts, and reads the same from it.
#include "simcore/scene/json_check.h"
#include "simcore/scene/json_text.h"
#include "tests/support/random_scene.h"
#include "tests/support/scene_text.h"

#include <QTest>

using namespace clothlab;

namespace {

// Ours alone refuses these.
bool isOwnRule(const Diagnostic& fault) {
    return fault.message.find("twice") != std::string::npos ||
           fault.message.find("levels") != std::string::npos;
}

// Replaces, removes, inserts or moves a few bytes, most of them marks that mean something in JSON.
std::string mutated(std::string text, std::mt19937& random) {
    constexpr std::string_view kBytes =
        "{}[]:,\"\\/-+.eE0123456789tfnull aux\n\t\xC3\xA9\xED\xA0\x80\xF0\x9F\x01\x7F";
    for (auto edits = 1 + random() % 3; edits > 0 && !text.empty(); --edits) {
        const std::size_t at = random() % text.size();
        const char byte = kBytes[random() % kBytes.size()];
        switch (random() % 4) {
        case 0:
            text[at] = byte;
            break;
        case 1:
            text.erase(at, 1 + random() % 3);
            break;
        case 2:
            text.insert(at, 1, byte);
            break;
        default:
            text.insert(at, text.substr(random() % text.size(), random() % 8));
        }
    }
    return text;
}

// Both are walked through side by side; returns where they differ.
std::string difference(json::Value ours, const test::Json& theirs, const std::string& place) {
    switch (ours.type()) {
    case json::Type::Null:
        return theirs.is_null() ? "" : place;
    case json::Type::Boolean:
        return theirs.is_boolean() && theirs.get<bool>() == ours.boolean() ? "" : place;
    case json::Type::Number:
        return theirs.is_number() && theirs.get<double>() == ours.number() ? "" : place;
    case json::Type::String:
        return theirs.is_string() && theirs.get<std::string>() == ours.string() ? "" : place;
    case json::Type::Array:
        break;
    case json::Type::Object: {
        const std::vector<json::Member> members = json::members(ours);
        if (!theirs.is_object() || members.size() != theirs.size())
            return place;
        for (const json::Member& member : members) {
            if (!theirs.contains(member.key))
                return place + "." + member.key;
            std::string inside = difference(member.value, theirs[member.key], place + "." + member.key);
            if (!inside.empty())
                return inside;
        }
        return "";
    }
    }
    json::Elements elements(ours);
    std::size_t index = 0;
    for (; const auto element = elements.next(); ++index) {
        if (!theirs.is_array() || index >= theirs.size())
            return place;
        std::string inside = difference(*element, theirs[index], place + "[" + std::to_string(index) + "]");
        if (!inside.empty())
            return inside;
    }
    return theirs.is_array() && theirs.size() == index ? "" : place;
}

} // namespace

class TestJsonCheck : public QObject {
    Q_OBJECT
private slots:
    void acceptsWhatTheLibraryAccepts() {
        std::mt19937 random(20240607);
        int accepted = 0;
        constexpr int kTexts = 40'000;
        for (int i = 0; i < kTexts; ++i) {
            const std::string text = mutated(test::randomObjectText(random, 4), random);
            const auto fault = json::checkJson(text);
            if (fault && isOwnRule(*fault))
                continue;
            const bool theirs = test::Json::accept(text);
            const std::string what = "text " + std::to_string(i) + " of seed 20240607: " + text;
            QVERIFY2(theirs == !fault, (what + (fault ? "\n" + toText(*fault, "") : "")).c_str());
            if (!theirs)
                continue;
            ++accepted;
            const std::string place = difference(json::parse(text), test::Json::parse(text), "text");
            QVERIFY2(place.empty(), (what + "\ndiffers at " + place).c_str());
        }
        QVERIFY2(accepted > kTexts / 20, "too few texts were JSON for the test to mean much");
        QVERIFY2(accepted < kTexts - kTexts / 20, "too few texts were not JSON for the test to mean much");
    }

    void numbersAreReadAsTheLibraryReadsThem_data() {
        QTest::addColumn<QByteArray>("text");
        for (const char* text : {"0",
                                 "-0",
                                 "1e308",
                                 "1.7976931348623157e308",
                                 "1.7976931348623159e308",
                                 "1e309",
                                 "-1e309",
                                 "5e-324",
                                 "2e-324",
                                 "1e-400",
                                 "-1e-400",
                                 "1e99999999999999999999",
                                 "1e-99999999999999999999",
                                 "0e99999999999999",
                                 "123456789012345678901234567890",
                                 "0.1",
                                 "01",
                                 "1.",
                                 ".5",
                                 "+1",
                                 "1e",
                                 "1e+",
                                 "-",
                                 "--1",
                                 "0x10",
                                 "1_0",
                                 "0.30000000000000004",
                                 "18446744073709551616",
                                 "9007199254740993"})
            QTest::newRow(text) << QByteArray(text);
        QTest::newRow("400 digits") << QByteArray(400, '9');
        QTest::newRow("400 digits and e-200") << QByteArray(400, '9') + "e-200";
        QTest::newRow("400 zeros after the point") << "0." + QByteArray(400, '0') + "1";
        QTest::newRow("400 zeros after the point and e800") << "0." + QByteArray(400, '0') + "1e800";
        QTest::newRow("400 zeros after the point and e500") << "0." + QByteArray(400, '0') + "1e500";
    }
    void numbersAreReadAsTheLibraryReadsThem() {
        QFETCH(QByteArray, text);
        const std::string number = text.toStdString();
        const auto fault = json::checkJson(number);
        QCOMPARE(!fault.has_value(), test::Json::accept(number));
        if (!fault)
            QCOMPARE(json::parse(number).number(), test::Json::parse(number).get<double>());
    }
};

QTEST_APPLESS_MAIN(TestJsonCheck)
#include "tst_json_check.moc"
