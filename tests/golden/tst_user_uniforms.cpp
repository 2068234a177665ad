// Uniforms that a shader declares for itself: what it may be told, and what is drawn with it.
#include "tests/golden/canvas.h"

#include <optional>

using namespace clothlab::render;

class UserUniformsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { SKIP_WITHOUT_OPENGL(); }
    void init();
    void cleanup() { m_studio.reset(); }

    void listedInTheOrderOfTheFile();
    void defaultsAndSettings();
    void settingsThatDoNotFitArePassedOver();
    void texturesOfItsOwn();
    void whatHasNoControlIsSaid();
    void ourNamesWithAnotherTypeAreSaid();
    void aBrokenShaderLeavesTheSettingsOfTheOneThatIsDrawn();
    void ownShadersAreAllDescribed();

private:
    QRgb drawn(const RenderFrame& frame);
    bool write(const QByteArray& text);

    std::optional<ShaderDirectory> m_directory;
    std::optional<Studio> m_studio;
    RenderFrame m_frame;
};

void UserUniformsTest::init() {
    m_directory.emplace();
    QVERIFY(m_studio.emplace().isGood());
    m_studio->renderer.setShaderDirectory(m_directory->path());
    m_frame = flatFrame(4);
    m_frame.surface.shader = QStringLiteral("Mine");
}

bool UserUniformsTest::write(const QByteArray& text) {
    m_studio->renderer.reloadFiles();
    return m_directory->write(QStringLiteral("Mine.frag"), "#version 330\n" + text);
}

QRgb UserUniformsTest::drawn(const RenderFrame& frame) {
    return m_studio->draw(frame).pixel(kSize.width() / 2, kSize.height() / 2);
}

void UserUniformsTest::listedInTheOrderOfTheFile() {
    QVERIFY(
        write("uniform float u_z; // 0.5 [0, 2] \"Zed\" Help.\nuniform vec4 u_color;\n"
              "uniform vec3 u_a_color; // #FF8000\nuniform bool u_m = true;\nuniform int u_unused;\n"
              "uniform int u_n = 3;\nout vec4 out_color;\n"
              "void main() { out_color = u_color * vec4(u_a_color * (u_m ? u_z : 0.0), float(u_n)); }\n"));
    drawn(m_frame);
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
    const int builds = m_studio->renderer.builds();
    QVERIFY(builds > 0);
    const std::vector<UniformSpec> specs = m_studio->renderer.uniforms();
    QCOMPARE(specs.size(), std::size_t(4));
    QCOMPARE(specs[0].name, QStringLiteral("u_z"));
    QCOMPARE(specs[0].label, QStringLiteral("Zed"));
    QCOMPARE(specs[0].initial, number(0.5F));
    QCOMPARE(specs[1].name, QStringLiteral("u_a_color"));
    QVERIFY(specs[1].color);
    QCOMPARE(specs[2].type, UniformSpec::Type::Bool);
    QCOMPARE(specs[2].initial, number(1));
    QCOMPARE(specs[3].type, UniformSpec::Type::Int);
    QCOMPARE(specs[3].initial, number(3));
    drawn(m_frame);
    QCOMPARE(m_studio->renderer.builds(), builds);
}

void UserUniformsTest::defaultsAndSettings() {
    QVERIFY(write("uniform float u_f; // 0.4\nuniform vec2 u_v = vec2(0.2, 0.6);\nuniform bool u_b; // true\n"
                  "out vec4 out_color;\nvoid main() { out_color = u_b ? vec4(u_f, u_v, 1) : vec4(1); }\n"));
    QVERIFY(isNear(drawn(m_frame), toColor({0.4F, 0.2F, 0.6F}), 1));
    RenderFrame set = m_frame;
    set.surface.uniforms[set.surface.shader] = {{QStringLiteral("u_f"), number(0.8F)},
                                                {QStringLiteral("u_v"), {2, {0.1F, 0}, {}}}};
    QVERIFY(isNear(drawn(set), toColor({0.8F, 0.1F, 0}), 1));
    set.surface.uniforms[set.surface.shader][QStringLiteral("u_b")] = number(0);
    QVERIFY(isNear(drawn(set), qRgb(255, 255, 255), 0));
    QVERIFY(isNear(drawn(m_frame), toColor({0.4F, 0.2F, 0.6F}), 1)); // and back to what the file says
}

void UserUniformsTest::settingsThatDoNotFitArePassedOver() {
    QVERIFY(write("uniform vec3 u_v; // (0.2, 0.4, 0.6)\nout vec4 out_color;\n"
                  "void main() { out_color = vec4(u_v, 1); }\n"));
    for (const UniformSetting& wrong :
         {number(1), UniformSetting{2, {1, 1}, {}}, UniformSetting{4, {1, 1, 1, 1}, {}},
          UniformSetting{0, {}, QStringLiteral("texture_1.png")}}) {
        m_frame.surface.uniforms[m_frame.surface.shader] = {{QStringLiteral("u_v"), wrong},
                                                            {QStringLiteral("u_gone"), wrong}};
        QVERIFY(isNear(drawn(m_frame), toColor({0.2F, 0.4F, 0.6F}), 1));
        QVERIFY(m_studio->renderer.problems().isEmpty());
    }
}

void UserUniformsTest::texturesOfItsOwn() {
    QByteArray text = "out vec4 out_color; in vec2 v_uv;\n";
    QByteArray sum = "vec4(0)";
    for (int i = 0; i < 10; ++i) {
        QImage image(4, 4, QImage::Format_RGB888);
        image.fill(QColor(20 * i, 255 - 20 * i, 128));
        const QString file = QStringLiteral("%1.png").arg(i);
        QVERIFY(image.save(m_directory->path(file)));
        const QByteArray name = "u_map_" + QByteArray::number(i);
        text += "uniform sampler2D " + name + "; // " + (i == 9 ? "srgb " : "") +
                m_directory->path(file).toUtf8() + "\n";
        sum += " + (u_which == " + QByteArray::number(i) + " ? texture(" + name + ", v_uv) : vec4(0))";
    }
    QVERIFY(write(text + "uniform int u_which;\nvoid main() { out_color = " + sum + "; }\n"));
    for (int i = 0; i < 10; ++i) {
        m_frame.surface.uniforms[m_frame.surface.shader][QStringLiteral("u_which")] = number(float(i));
        // 180, 75, 128 of sRGB in linear light.
        const QRgb expected = i == 9 ? qRgb(116, 18, 55) : qRgb(20 * i, 255 - 20 * i, 128);
        QVERIFY2(isNear(drawn(m_frame), expected, 1), qPrintable(QColor(drawn(m_frame)).name()));
    }
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
    m_frame.surface.uniforms[m_frame.surface.shader][QStringLiteral("u_map_9")] = {
        0, {}, QStringLiteral("not_there.png")};
    drawn(m_frame);
    QVERIFY(m_studio->faults().startsWith(QStringLiteral("not_there.png: ")));
}

void UserUniformsTest::whatHasNoControlIsSaid() {
    QVERIFY(write("uniform mat3 u_turn; uniform float u_list[3]; out vec4 out_color;\n"
                  "void main() { out_color = vec4(u_turn[0] + u_list[1], 1) + vec4(0, 1, 0, 0); }\n"));
    QVERIFY(isNear(drawn(m_frame), qRgb(0, 255, 0), 1)); // it is drawn all the same
    QCOMPARE(m_studio->renderer.problems().size(), 2);
    QVERIFY(m_studio->faults().contains(QStringLiteral("u_turn")));
    QVERIFY(m_studio->faults().contains(QStringLiteral("u_list")));
}

void UserUniformsTest::ourNamesWithAnotherTypeAreSaid() {
    QVERIFY(write(
        "uniform vec3 u_color; uniform float u_cam_pos; uniform sampler2D u_texture_cubemap;\n"
        "uniform vec3 u_light_pos; out vec4 out_color;\n"
        "void main() { out_color = vec4(u_color, 1) + vec4(u_cam_pos) + texture(u_texture_cubemap, vec2(0))\n"
        "  + vec4(0, u_light_pos == vec3(0.5, 2, 2) ? 1 : 0, 0, 0); }\n"));
    QCOMPARE(qGreen(drawn(m_frame)), 255); // it is drawn all the same, with what has the right type
    QCOMPARE(m_studio->renderer.problems().size(), 3);
    for (const char* name : {"u_color", "u_cam_pos", "u_texture_cubemap"})
        QVERIFY2(m_studio->faults().contains(QLatin1String(name)), qPrintable(m_studio->faults()));
    QVERIFY(m_studio->renderer.uniforms().empty());
}

void UserUniformsTest::aBrokenShaderLeavesTheSettingsOfTheOneThatIsDrawn() {
    QVERIFY(
        write("uniform float u_x; // 0.2\nout vec4 out_color;\nvoid main() { out_color = vec4(u_x); }\n"));
    QVERIFY(isNear(drawn(m_frame), qRgb(51, 51, 51), 1));
    const QString good = m_frame.surface.shader;
    m_frame.surface.shader = QStringLiteral("NotThere");
    m_frame.surface.uniforms[good][QStringLiteral("u_x")] = number(0.8F);
    m_frame.surface.uniforms[m_frame.surface.shader][QStringLiteral("u_x")] = number(0.4F);
    QVERIFY(isNear(drawn(m_frame), qRgb(204, 204, 204), 1));
    QCOMPARE(m_studio->renderer.shaderInUse(), good);
}

// What the program's own shaders let the user set has a label and, for numbers, a range that holds the
// default.
void UserUniformsTest::ownShadersAreAllDescribed() {
    m_studio->renderer.setShaderDirectory(kShaders);
    for (const QString& file : QDir(kShaders).entryList({QStringLiteral("*.frag")})) {
        m_frame.surface.shader = QFileInfo(file).completeBaseName();
        drawn(m_frame);
        QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
        for (const UniformSpec& spec : m_studio->renderer.uniforms()) {
            const QByteArray name = (file + u' ' + spec.name).toUtf8();
            QVERIFY2(!spec.label.isEmpty(), name);
            const bool isNumber =
                spec.type == UniformSpec::Type::Float || spec.type == UniformSpec::Type::Vec2;
            QVERIFY2(!isNumber || spec.range, name);
            for (int i = 0; isNumber && i < spec.initial.components; ++i) {
                const float value = spec.initial.numbers[static_cast<std::size_t>(i)];
                QVERIFY2(value >= (*spec.range)[0] && value <= (*spec.range)[1], name);
            }
        }
    }
}

int main(int argc, char** argv) {
    return runOnDisplay<UserUniformsTest>(argc, argv);
}
#include "tst_user_uniforms.moc"
