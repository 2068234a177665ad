// Shaders written for the course's simulator run as they are, and find all that they know from there.
#include "tests/golden/canvas.h"
#include "tests/golden/course_shaders.h"

#include <optional>

using namespace clothlab::render;
using namespace clothlab;

namespace {

// Each texture has its size and its colour.
constexpr std::array<QSize, kTextureCount> kSizes{QSize(8, 4), QSize(16, 32), QSize(64, 64), QSize(5, 3)};
constexpr std::array<QRgb, kTextureCount> kColors{0xFFFF0000, 0xFF00FF00, 0xFF0000FF, 0xFFFFFF00};

const QRgb kYes = qRgb(0, 255, 0);

QByteArray answering(const QByteArray& condition) {
    return course::kAllUniforms + course::kInputs +
           "bool near(vec3 a, vec3 b) { return distance(a, b) < 0.01; }\n"
           "void main() { out_color = " +
           condition + " ? vec4(0, 1, 0, 1) : vec4(1, 0, 0, 1); }\n";
}

} // namespace

class CourseShadersTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup() { m_studio.reset(); }

    void uniforms_data();
    void uniforms();
    void modelMatrices();
    void viewAndCamera();
    void attributes_data();
    void attributes();
    void allAtOnceWithoutAProblem();
    void shadersOfTheCourse_data();
    void shadersOfTheCourse();
    void phongIsItsFormula();
    void displacementMovesTheSheet();
    void wireframeDrawsSprings();
    void partnerOrDefault();

private:
    QImage draw(const QByteArray& fragments, const RenderFrame& frame);
    void answersYes(const QByteArray& condition, const RenderFrame& frame, const QVector3D& place);

    ShaderDirectory m_textures;
    std::optional<ShaderDirectory> m_shaders;
    std::optional<Studio> m_studio;
};

void CourseShadersTest::initTestCase() {
    SKIP_WITHOUT_OPENGL();
    for (std::size_t i = 0; i < kTextureCount; ++i) {
        QImage image(kSizes[i], QImage::Format_RGB888);
        image.fill(kColors[i]);
        QVERIFY(image.save(m_textures.path(QStringLiteral("texture_%1.png").arg(i + 1))));
    }
    QVERIFY(QDir(m_textures.path()).mkdir(QStringLiteral("cubemap")));
    int shade = 40;
    for (const char* face : {"posx", "negx", "posy", "negy", "posz", "negz"}) {
        QImage image(16, 16, QImage::Format_RGB888);
        image.fill(QColor(shade, 0, 255 - shade));
        shade += 30;
        QVERIFY(image.save(m_textures.path(QStringLiteral("cubemap/%1.png").arg(QLatin1String(face)))));
    }
}

void CourseShadersTest::init() {
    QVERIFY(m_studio.emplace().isGood());
    m_shaders.emplace();
    m_studio->renderer.setShaderDirectory(m_shaders->path());
    m_studio->renderer.setTextureDirectory(m_textures.path());
}

QImage CourseShadersTest::draw(const QByteArray& fragments, const RenderFrame& frame) {
    RenderFrame own = frame;
    own.surface.shader = QStringLiteral("Mine");
    if (!m_shaders->write(QStringLiteral("Mine.frag"), fragments))
        return QImage();
    m_studio->renderer.reloadFiles();
    return m_studio->draw(own);
}

void CourseShadersTest::answersYes(const QByteArray& condition, const RenderFrame& frame,
                                   const QVector3D& place) {
    const QPoint pixel = toPixel(frame, place);
    const QImage image = draw(answering(condition), frame);
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
    QVERIFY2(image.pixel(pixel) == kYes, condition + ' ' + seen(image, pixel, kYes));
    const QImage opposite = draw(answering("!(" + condition + ")"), frame);
    QVERIFY2(opposite.pixel(pixel) == qRgb(255, 0, 0), condition); // the question can be answered otherwise
}

void CourseShadersTest::uniforms_data() {
    QTest::addColumn<QByteArray>("condition");
    const auto add = [](const char* name, const QByteArray& condition) { QTest::newRow(name) << condition; };
    add("u_model", "u_model == mat4(1.0)");
    add("u_color", "u_color == vec4(1.0)");
    add("u_light_pos", "u_light_pos == vec3(0.5, 2, 2)");
    add("u_light_intensity", "u_light_intensity == vec3(3)");
    add("u_normal_scaling", "u_normal_scaling == 2.0");
    add("u_height_scaling", "abs(u_height_scaling - 0.1) < 1e-6");
    add("u_texture_1", "near(texture(u_texture_1, v_uv).rgb, vec3(1, 0, 0))");
    add("u_texture_2", "near(texture(u_texture_2, v_uv).rgb, vec3(0, 1, 0))");
    add("u_texture_3", "near(texture(u_texture_3, v_uv).rgb, vec3(0, 0, 1))");
    add("u_texture_4", "near(texture(u_texture_4, v_uv).rgb, vec3(1, 1, 0))");
    add("textures repeat", "near(texture(u_texture_4, v_uv * 9.0 - 4.0).rgb, vec3(1, 1, 0))");
    add("u_texture_1_size", "u_texture_1_size == vec2(8, 4)");
    add("u_texture_2_size", "u_texture_2_size == vec2(16, 32)");
    add("u_texture_3_size", "u_texture_3_size == vec2(64, 64)");
    add("u_texture_4_size", "u_texture_4_size == vec2(5, 3)");
    int shade = 40;
    for (const char* d : {"1, 0, 0", "-1, 0, 0", "0, 1, 0", "0, -1, 0", "0, 0, 1", "0, 0, -1"}) {
        add(qPrintable(QStringLiteral("u_texture_cubemap ") + QLatin1String(d)),
            "near(texture(u_texture_cubemap, vec3(" + QByteArray(d) + ")).rgb, vec3(" +
                QByteArray::number(shade) + ".0, 0.0, " + QByteArray::number(255 - shade) + ".0) / 255.0)");
        shade += 30;
    }
}

void CourseShadersTest::uniforms() {
    QFETCH(QByteArray, condition);
    answersYes(condition, flatFrame(6), QVector3D(0.4F, 0.5F, 0.4F));
}

void CourseShadersTest::modelMatrices() {
    RenderFrame frame = flatFrame(4);
    frame.sheet = SheetShape();
    frame.spheres = {{QVector3D(0.25F, 0.5F, 0.75F), 0.25F}};
    answersYes(
        "distance(u_model[3], vec4(0.25, 0.5, 0.75, 1.0)) < 1e-5 && distance(u_model[0], vec4(0.23, 0, 0, "
        "0)) "
        "< 1e-5 && distance(u_model[1], vec4(0, 0.23, 0, 0)) < 1e-5 && distance(u_model[2], vec4(0, 0, 0.23, "
        "0)) < 1e-5",
        frame, QVector3D(0.25F, 0.73F, 0.75F));
    // u is the longitude, v the latitude from the north pole.
    answersYes("v_uv.y < 0.3 && v_uv.x >= 0.0 && v_uv.x <= 1.0", frame, QVector3D(0.25F, 0.72F, 0.76F));
    answersYes("abs(cos(3.14159265 * v_uv.y) - v_normal.y) < 0.01 && length(v_normal.xyz) > 0.99", frame,
               QVector3D(0.3F, 0.68F, 0.8F));
}

void CourseShadersTest::viewAndCamera() {
    RenderFrame frame = flatFrame(6);
    answersYes("distance(u_cam_pos, vec3(0.5, 2.0, 1.2)) < 1e-5", frame, QVector3D(0.4F, 0.5F, 0.4F));
    QByteArray matrix = "mat4(";
    for (int i = 0; i < 16; ++i)
        matrix +=
            QByteArray::number(double(frame.viewProjection.constData()[i]), 'f', 7) + (i < 15 ? ", " : ")");
    answersYes("distance(u_view_projection * v_position, " + matrix + " * v_position) < 1e-4", frame,
               QVector3D(0.4F, 0.5F, 0.4F));
}

void CourseShadersTest::attributes_data() {
    QTest::addColumn<QByteArray>("condition");
    QTest::newRow("in_position") << QByteArray("in_position.w == 1.0 && in_position.y == 0.5 && "
                                               "distance(in_position.xz, in_uv) < 1e-5");
    QTest::newRow("in_normal") << QByteArray("distance(in_normal, vec4(0, 1, 0, 0)) < 1e-5");
    QTest::newRow("in_tangent") << QByteArray("distance(in_tangent, vec4(1, 0, 0, 0)) < 1e-5");
    QTest::newRow("in_uv") << QByteArray(
        "in_uv.x >= 0.0 && in_uv.x <= 1.0 && in_uv.y >= 0.0 && in_uv.y <= 1.0");
}

// In a vertex shader of the student's own.
void CourseShadersTest::attributes() {
    QFETCH(QByteArray, condition);
    const RenderFrame frame = flatFrame(6);
    for (const bool opposite : {false, true}) {
        QVERIFY(m_shaders->write(
            QStringLiteral("Mine.vert"),
            course::kAllUniforms + course::kAttributes +
                "out float v_good;\nvoid main() {\n  v_good = " + (opposite ? "!(" : "(") + condition +
                ") ? 1.0 : 0.0;\n"
                "  gl_Position = u_view_projection * u_model * in_position;\n}\n"));
        const QImage image = draw("#version 330\nin float v_good;\nout vec4 out_color;\n"
                                  "void main() { out_color = vec4(1.0 - v_good, v_good, 0, 1); }\n",
                                  frame);
        QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
        const QPoint pixel = toPixel(frame, QVector3D(0.4F, 0.5F, 0.4F));
        QVERIFY2(image.pixel(pixel) == (opposite ? qRgb(255, 0, 0) : kYes), seen(image, pixel, kYes));
    }
}

void CourseShadersTest::allAtOnceWithoutAProblem() {
    const QImage image = draw(
        course::kAllUniforms + course::kInputs +
            "void main() {\n  vec4 sum = u_color + vec4(u_cam_pos + u_light_pos + u_light_intensity, 1.0);\n"
            "  sum += texture(u_texture_1, v_uv) + texture(u_texture_2, v_uv) + texture(u_texture_3, v_uv);\n"
            "  sum += texture(u_texture_4, v_uv) + texture(u_texture_cubemap, v_normal.xyz);\n"
            "  sum.xy += u_texture_1_size + u_texture_2_size + u_texture_3_size + u_texture_4_size;\n"
            "  sum += u_model * v_position + u_view_projection * v_tangent;\n"
            "  out_color = 0.0001 * sum * u_normal_scaling * u_height_scaling + vec4(0, 1, 0, 1);\n}\n",
        flatFrame(6));
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
    QVERIFY(m_studio->renderer.uniforms().empty()); // the course's are set by the program, not by the user
    QVERIFY(isNear(image.pixel(kSize.width() / 2, kSize.height() / 2), kYes, 12));
}

void CourseShadersTest::shadersOfTheCourse_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("Phong") << course::kPhong;
    QTest::newRow("Texture") << course::kTexture;
    QTest::newRow("Bump") << course::kBump;
    QTest::newRow("Mirror") << course::kMirror;
    QTest::newRow("Normal") << course::kNormal;
}

void CourseShadersTest::shadersOfTheCourse() {
    QFETCH(QByteArray, text);
    RenderFrame frame = flatFrame(8);
    frame.spheres = {{QVector3D(0.5F, 0.45F, 0.5F), 0.3F}};
    frame.planes = {{QVector3D(), QVector3D(0, 1, 0)}};
    const QImage image = draw(text, frame);
    QVERIFY(!image.isNull());
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
    QCOMPARE(m_studio->renderer.shaderInUse(), QStringLiteral("Mine"));
    const QPoint pixel = toPixel(frame, QVector3D(0.1F, 0.5F, 0.1F));
    QVERIFY(!isNear(image.pixel(pixel), frame.background.rgb(), 20));
    QVERIFY(!isNear(image.pixel(pixel), qRgb(0, 0, 0), 20));
}

void CourseShadersTest::phongIsItsFormula() {
    const RenderFrame frame = flatFrame(8);
    const QImage image = draw(course::kPhong, frame);
    for (const QVector3D place : {QVector3D(0.1F, 0.5F, 0.2F), QVector3D(0.9F, 0.5F, 0.3F)}) {
        const QPoint pixel = toPixel(frame, place);
        const QVector3D p = toPlane(frame, pixel, 0.5F);
        const QVector3D l = frame.light.position - p;
        const QVector3D h = (l.normalized() + (frame.cameraPosition - p).normalized()).normalized();
        const float value = 0.1F + 3 / l.lengthSquared() *
                                       (l.normalized().y() + 0.5F * std::pow(std::max(h.y(), 0.0F), 32.0F));
        const QRgb expected = toColor(QVector3D(value, value, value));
        QVERIFY2(isNear(image.pixel(pixel), expected, 2), seen(image, pixel, expected));
    }
}

// The third texture is blue: nothing of it is red, and nothing moves. A red one moves everything by 0.1 m.
void CourseShadersTest::displacementMovesTheSheet() {
    QVERIFY(m_shaders->write(QStringLiteral("Mine.vert"), course::kDisplacementVertices));
    RenderFrame frame = flatFrame(8);
    const QByteArray height = course::kInputs + "void main() { out_color = vec4(v_position.y, 0, 0, 1); }\n";
    const QPoint pixel = toPixel(frame, QVector3D(0.5F, 0.55F, 0.5F));
    QVERIFY(isNear(draw("#version 330\n" + height, frame).pixel(pixel), qRgb(128, 0, 0), 1));
    frame.surface.textures[2] = QStringLiteral("texture_1.png");
    const QImage moved = draw("#version 330\n" + height, frame);
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
    QVERIFY2(isNear(moved.pixel(pixel), qRgb(153, 0, 0), 1), seen(moved, pixel, qRgb(153, 0, 0)));
}

void CourseShadersTest::wireframeDrawsSprings() {
    QVERIFY(m_shaders->write(QStringLiteral("Wireframe.frag"), course::kWireframe));
    RenderFrame frame = flatFrame(5);
    frame.surface.shader = QStringLiteral("Wireframe");
    const QImage image = m_studio->draw(frame);
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
    const int lines = countPixels(image, QColor(255, 51, 0), 2);
    const int background = countPixels(image, frame.background, 0);
    QVERIFY(lines > 300);
    QCOMPARE(lines + background, kSize.width() * kSize.height());
    QVERIFY(background > 40000);
}

// NAME.vert, else Default.vert of the folder, else the program's own.
void CourseShadersTest::partnerOrDefault() {
    const RenderFrame frame = flatFrame(6);
    const QPoint pixel = toPixel(frame, QVector3D(0.5F, 0.5F, 0.5F));
    const QByteArray fragments = "#version 330\nin vec4 v_normal;\nout vec4 out_color;\n"
                                 "void main() { out_color = abs(v_normal); }\n";
    const auto vertices = [](const char* normal) {
        return "#version 330\nuniform mat4 u_view_projection;\nin vec4 in_position;\nout vec4 v_normal;\n"
               "void main() { v_normal = vec4(" +
               QByteArray(normal) + ", 0);\n  gl_Position = u_view_projection * in_position; }\n";
    };
    QCOMPARE(draw(fragments, frame).pixel(pixel), qRgb(0, 255, 0));
    QVERIFY(m_shaders->write(QStringLiteral("Default.vert"), vertices("1, 0, 0")));
    QCOMPARE(draw(fragments, frame).pixel(pixel), qRgb(255, 0, 0));
    QVERIFY(m_shaders->write(QStringLiteral("Mine.vert"), vertices("0, 0, 1")));
    QCOMPARE(draw(fragments, frame).pixel(pixel), qRgb(0, 0, 255));
    QVERIFY(QFile::remove(m_shaders->path(QStringLiteral("Mine.vert"))));
    QCOMPARE(draw(fragments, frame).pixel(pixel), qRgb(255, 0, 0));
}

int main(int argc, char** argv) {
    return runOnDisplay<CourseShadersTest>(argc, argv);
}
#include "tst_course_shaders.moc"
