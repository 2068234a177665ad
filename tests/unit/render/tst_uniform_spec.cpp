// What comments after uniforms say.
#include "app/render/uniform_spec.h"

#include <QTest>

using namespace clothlab::render;

namespace {

using Type = UniformSpec::Type;

UniformSpec read(Type type, const QByteArray& declaration, const QString& name = QStringLiteral("u_x")) {
    UniformSpec spec;
    spec.name = name;
    spec.type = type;
    annotate(spec, {declaration});
    return spec;
}

UniformSpec readComment(Type type, const QByteArray& comment) {
    return read(type, "uniform thing u_x; //" + comment);
}

std::array<float, 2> rangeOf(const UniformSpec& spec) {
    return spec.range.value_or(std::array<float, 2>{0, 0});
}

} // namespace

class UniformSpecTest : public QObject {
    Q_OBJECT

private slots:
    void formsOfTheHeader();
    void whatTheFileDoesNotSay();
    void numbers_data();
    void numbers();
    void ranges_data();
    void ranges();
    void colors();
    void samplers();
    void orderIsFree();
    void helpMayBeginWithAnything();
    void nonsenseIsHelp();
    void onlyItsOwnDeclaration();
    void theLastFileSpeaks();
};

void UniformSpecTest::formsOfTheHeader() {
    UniformSpec spec =
        read(Type::Float,
             "uniform float u_roughness; // 0.5 [0, 1] \"Roughness\" of the surface: 0 is a mirror.\n",
             QStringLiteral("u_roughness"));
    QCOMPARE(spec.initial, (UniformSetting{1, {0.5F}, {}}));
    QCOMPARE(rangeOf(spec), (std::array<float, 2>{0, 1}));
    QCOMPARE(spec.label, QStringLiteral("Roughness"));
    QCOMPARE(spec.help, QStringLiteral("of the surface: 0 is a mirror."));

    spec = readComment(Type::Vec3, " color (1, 0.5, 0) \"Tint\"");
    QVERIFY(spec.color);
    QCOMPARE(spec.initial, (UniformSetting{3, {1, 0.5F, 0}, {}}));
    QCOMPARE(spec.label, QStringLiteral("Tint"));
    QVERIFY(spec.help.isEmpty());

    spec = readComment(Type::Vec3, " #FF8000 \"Tint\"");
    QVERIFY(spec.color);
    QCOMPARE(spec.initial.components, 3);
    QCOMPARE(spec.initial.numbers[0], 1.0F);
    QVERIFY(std::abs(spec.initial.numbers[1] - 128.0F / 255) < 1e-4F);
    QCOMPARE(spec.initial.numbers[2], 0.0F);

    spec = readComment(Type::Vec2, " (4, 4) [1, 64] \"Tiles\"");
    QCOMPARE(spec.initial, (UniformSetting{2, {4, 4}, {}}));
    QCOMPARE(rangeOf(spec), (std::array<float, 2>{1, 64}));

    QCOMPARE(readComment(Type::Bool, " true \"Glow\"").initial, (UniformSetting{1, {1}, {}}));
    QCOMPARE(readComment(Type::Bool, " false \"Glow\"").initial, (UniformSetting{1, {0}, {}}));

    spec = readComment(Type::Sampler2D, " srgb texture_5.png \"Colours\"");
    QVERIFY(spec.srgb);
    QCOMPARE(spec.initial, (UniformSetting{0, {}, QStringLiteral("texture_5.png")}));
    QCOMPARE(spec.label, QStringLiteral("Colours"));
}

void UniformSpecTest::whatTheFileDoesNotSay() {
    UniformSpec spec;
    spec.name = QStringLiteral("u_sheen_tint");
    spec.type = Type::Vec3;
    spec.initial.numbers = {0.1F, 0.2F, 0.3F}; // as GLSL says
    annotate(spec, {"uniform vec3 u_sheen_tint = vec3(0.1, 0.2, 0.3);\n"});
    QCOMPARE(spec.initial, (UniformSetting{3, {0.1F, 0.2F, 0.3F}, {}}));
    QCOMPARE(spec.label, QStringLiteral("Sheen tint"));
    QVERIFY(spec.help.isEmpty() && !spec.range && !spec.color && !spec.srgb);
    QCOMPARE(read(Type::Float, "", QStringLiteral("speed")).label, QStringLiteral("Speed"));
    QVERIFY(read(Type::Float, "", QStringLiteral("u_")).label.isEmpty());

    UniformSpec given;
    given.name = QStringLiteral("u_x");
    given.initial.numbers = {7};
    annotate(given, {"uniform float u_x = 7.0; // [0, 9] \"X\""});
    QCOMPARE(given.initial.numbers[0], 7.0F); // a comment without a default leaves GLSL's
}

void UniformSpecTest::numbers_data() {
    QTest::addColumn<QByteArray>("comment");
    QTest::addColumn<float>("expected");
    QTest::newRow("whole") << QByteArray("3") << 3.0F;
    QTest::newRow("negative") << QByteArray(" -2.5 ") << -2.5F;
    QTest::newRow("signed") << QByteArray(" +4") << 4.0F;
    QTest::newRow("dot first") << QByteArray(" .5") << 0.5F;
    QTest::newRow("dot last") << QByteArray(" 2.") << 2.0F;
    QTest::newRow("exponent") << QByteArray(" 1e-3") << 0.001F;
    QTest::newRow("version") << QByteArray(" 1.2.3") << 0.0F;
    QTest::newRow("unit") << QByteArray(" 5m") << 0.0F;
    QTest::newRow("tuple") << QByteArray(" (1, 2)") << 0.0F;
    QTest::newRow("hex") << QByteArray(" #FF8000") << 0.0F;
    QTest::newRow("tabs") << QByteArray("\t8\t") << 8.0F;
}

void UniformSpecTest::numbers() {
    QFETCH(QByteArray, comment);
    QFETCH(float, expected);
    QCOMPARE(readComment(Type::Float, comment).initial, (UniformSetting{1, {expected}, {}}));
}

void UniformSpecTest::ranges_data() {
    QTest::addColumn<QByteArray>("comment");
    QTest::addColumn<bool>("good");
    QTest::newRow("spaces") << QByteArray(" [ -1 , 2 ]") << true;
    QTest::newRow("none") << QByteArray("[-1,2]") << true;
    QTest::newRow("reversed") << QByteArray(" [2, -1]") << false;
    QTest::newRow("empty") << QByteArray(" [1, 1]") << false;
    QTest::newRow("one number") << QByteArray(" [1]") << false;
    QTest::newRow("open") << QByteArray(" [-1, 2") << false;
    QTest::newRow("words") << QByteArray(" [low, high]") << false;
}

void UniformSpecTest::ranges() {
    QFETCH(QByteArray, comment);
    QFETCH(bool, good);
    const UniformSpec spec = readComment(Type::Float, comment);
    QCOMPARE(spec.range.has_value(), good);
    if (good)
        QCOMPARE(rangeOf(spec), (std::array<float, 2>{-1, 2}));
}

void UniformSpecTest::colors() {
    QVERIFY(read(Type::Vec3, "", QStringLiteral("u_warp_color")).color);
    QVERIFY(read(Type::Vec4, "", QStringLiteral("u_RimColour")).color);
    QVERIFY(!read(Type::Vec3, "", QStringLiteral("u_colors_used")).color);
    QVERIFY(!read(Type::Float, "", QStringLiteral("u_color")).color);
    QVERIFY(!readComment(Type::Vec2, " color (1, 2)").color);
    QVERIFY(readComment(Type::Vec4, " colour").color);
    const UniformSpec opaque = readComment(Type::Vec4, " #00ff00");
    QCOMPARE(opaque.initial, (UniformSetting{4, {0, 1, 0, 1}, {}}));
    QCOMPARE(readComment(Type::Vec4, " (0, 1, 0, 0.5)").initial, (UniformSetting{4, {0, 1, 0, 0.5F}, {}}));
    QCOMPARE(readComment(Type::Vec3, " (0, 1)").initial, (UniformSetting{3, {}, {}})); // too few
    for (const char* wrong : {" #F80", " #GG0000", " #FF80001"})
        QCOMPARE(readComment(Type::Vec3, wrong).initial, (UniformSetting{3, {}, {}}));
}

void UniformSpecTest::samplers() {
    QCOMPARE(readComment(Type::Sampler2D, " my/maps/wool.JPG").initial.file.isEmpty(), true);
    QCOMPARE(readComment(Type::Sampler2D, " my/maps/wool.jpg").initial.file,
             QStringLiteral("my/maps/wool.jpg"));
    QCOMPARE(readComment(Type::Sampler2D, " /maps/a.jpeg \"A\"").initial.file,
             QStringLiteral("/maps/a.jpeg"));
    QVERIFY(!readComment(Type::Sampler2D, " a.png").srgb);
    QVERIFY(readComment(Type::Sampler2D, " a.png srgb").srgb);
    QVERIFY(readComment(Type::Float, " a.png").initial.file.isEmpty());
}

void UniformSpecTest::orderIsFree() {
    const UniformSpec spec = readComment(Type::Float, " [0, 1] 0.5 \"Rim\" of light");
    QCOMPARE(spec.initial.numbers[0], 0.5F);
    QCOMPARE(rangeOf(spec), (std::array<float, 2>{0, 1}));
    QCOMPARE(spec.label, QStringLiteral("Rim"));
    QCOMPARE(spec.help, QStringLiteral("of light"));
    QVERIFY(readComment(Type::Vec3, " (1, 2, 3) color").color);
}

void UniformSpecTest::helpMayBeginWithAnything() {
    for (const char* help : {"0 would be a mirror, 1 is matt.", "1: highlights", "[0, 3] is best",
                             "true to life", "color of the rim", "\"in quotes\"", "a.png is fine"}) {
        const UniformSpec spec =
            readComment(Type::Float, QByteArray(" 0.5 [0, 1] \"Rim\" ") + QByteArray(help));
        QCOMPARE(spec.initial, (UniformSetting{1, {0.5F}, {}}));
        QCOMPARE(rangeOf(spec), (std::array<float, 2>{0, 1}));
        QCOMPARE(spec.label, QStringLiteral("Rim"));
        QCOMPARE(spec.help, QString::fromLatin1(help));
    }
}

void UniformSpecTest::nonsenseIsHelp() {
    for (const char* comment : {"what?", "\"unclosed", "[0 1]", "(1; 2)", "###", "\"\"", "TODO \"x\" 3"}) {
        const UniformSpec spec = readComment(Type::Float, QByteArray(" ") + QByteArray(comment));
        QCOMPARE(spec.initial, (UniformSetting{1, {0}, {}}));
        QCOMPARE(spec.label, QStringLiteral("X"));
        QCOMPARE(spec.help, QString::fromLatin1(comment));
    }
    QVERIFY(readComment(Type::Float, "").help.isEmpty());
    QVERIFY(readComment(Type::Float, "  \t ").help.isEmpty());
    QCOMPARE(readComment(Type::Float, " \xFF\xFE").initial.numbers[0], 0.0F); // not UTF-8
    QCOMPARE(readComment(Type::Float, " \"H\xC3\xB6he\"").label, QStringLiteral("Höhe"));
}

void UniformSpecTest::onlyItsOwnDeclaration() {
    const QByteArray text = "// uniform float u_x; // 1\n"
                            "uniform float u_xy; // 2\n"
                            "uniform float v_u_x; // 3\n"
                            "  uniform  float\tu_x = 0.5 ; // 4 [0, 9]\n"
                            "uniform float u_x; // 5\n";
    QCOMPARE(read(Type::Float, text).initial.numbers[0], 4.0F);
    // A name that means something to a regular expression is only a name.
    QCOMPARE(read(Type::Float, "uniform float u_x; // 4", QStringLiteral("u.x")).initial.numbers[0], 0.0F);
    // The comment of the next line is not this one's.
    QVERIFY(read(Type::Float, "uniform float u_x;\n// 4\n").help.isEmpty());
}

void UniformSpecTest::theLastFileSpeaks() {
    UniformSpec spec;
    spec.name = QStringLiteral("u_x");
    annotate(spec, {"uniform float u_x; // 1\n", "uniform float u_x; // 2\n", "uniform float u_x;\n"});
    QCOMPARE(spec.initial.numbers[0], 2.0F);
    annotate(spec, {});
    QCOMPARE(spec.initial.components, 1);
}

QTEST_APPLESS_MAIN(UniformSpecTest)
#include "tst_uniform_spec.moc"
