// What vertices bring with them.
#include "tests/golden/canvas.h"

#include <optional>

using namespace clothlab::render;

class AttributesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { SKIP_WITHOUT_OPENGL(); }
    void init() { QVERIFY(m_studio.emplace().isGood()); }
    void cleanup() { m_studio.reset(); }

    void attributesOfTheCourse();
    void attributesWithTheirFourthComponent();

private:
    std::optional<Studio> m_studio;
};

// A shader that returns its inputs: names, w components and values of all attributes, through our
// Default.vert.
void AttributesTest::attributesOfTheCourse() {
    ShaderDirectory directory;
    QVERIFY(directory.write(
        QStringLiteral("Show.frag"),
        "#version 330\nin vec4 v_position; in vec4 v_normal; in vec4 v_tangent; in vec2 v_uv;\n"
        "uniform vec4 u_color; uniform vec3 u_cam_pos; uniform vec3 u_light_pos; out vec4 out_color;\n"
        "void main() {\n"
        "  bool good = abs(v_position.w - 1.0) < 1e-4 && v_normal.w == 0.0 && v_tangent.w == 0.0\n"
        "    && abs(v_position.y - 0.5) < 1e-4 && distance(v_position.xz, v_uv) < 1e-3\n"
        "    && distance(v_normal.xyz, vec3(0, 1, 0)) < 1e-3 && distance(v_tangent.xyz, vec3(1, 0, 0)) "
        "< 1e-3\n"
        "    && distance(u_cam_pos, vec3(0.5, 2.0, 1.2)) < 1e-4 && u_light_pos == vec3(0.5, 2, 2);\n"
        "  out_color = vec4(v_uv, good ? u_color.b : 0.0, 0.0);\n}\n"));
    m_studio->renderer.setShaderDirectory(directory.path());
    RenderFrame frame = flatFrame(10);
    frame.surface.shader = QStringLiteral("Show");
    const QImage image = m_studio->draw(frame);
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
    for (const QVector3D place : {QVector3D(0.2F, 0.5F, 0.7F), QVector3D(0.8F, 0.5F, 0.3F)}) {
        const QPoint pixel = toPixel(frame, place);
        const QVector3D seen = toPlane(frame, pixel, 0.5F);
        const QRgb expected = qRgb(int(std::lround(255 * seen.x())), int(std::lround(255 * seen.z())), 255);
        QVERIFY2(isNear(image.pixel(pixel), expected, 2),
                 qPrintable(QColor(image.pixel(pixel)).name() + u' ' + QColor(expected).name()));
        QCOMPARE(qAlpha(image.pixel(pixel)), 255); // whatever the shader writes
    }
}

// A vertex shader of its own sees what the course's simulator gives it: directions with w = 0, positions
// with 1.
void AttributesTest::attributesWithTheirFourthComponent() {
    ShaderDirectory directory;
    QVERIFY(
        directory.write(QStringLiteral("Raw.vert"),
                        "#version 330\nuniform mat4 u_model; uniform mat4 u_view_projection;\n"
                        "in vec4 in_position; in vec4 in_normal; in vec4 in_tangent; flat out vec4 v_color;\n"
                        "void main() {\n  gl_Position = u_view_projection * u_model * in_position;\n"
                        "  v_color = vec4(in_position.w, in_normal.w, in_tangent.w, 1.0);\n}\n"));
    QVERIFY(directory.write(
        QStringLiteral("Raw.frag"),
        "#version 330\nflat in vec4 v_color; out vec4 out_color;\nvoid main() { out_color = v_color; }\n"));
    m_studio->renderer.setShaderDirectory(directory.path());
    RenderFrame frame = flatFrame(10);
    frame.surface.shader = QStringLiteral("Raw");
    frame.spheres = {{QVector3D(0.5F, 0.6F, 0.5F), 0.3F}};
    const QImage image = m_studio->draw(frame);
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
    for (const QVector3D place : {QVector3D(0.05F, 0.5F, 0.5F), QVector3D(0.5F, 0.85F, 0.5F)})
        QCOMPARE(image.pixel(toPixel(frame, place)), qRgb(255, 0, 0));
}

int main(int argc, char** argv) {
    return runOnDisplay<AttributesTest>(argc, argv);
}
#include "tst_attributes.moc"
