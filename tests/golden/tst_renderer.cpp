// Pictures against formulas: what the renderer draws into a framebuffer object, pixel by pixel.
#include "app/render/renderer.h"
#include "app/render/shapes.h"

#include <QDir>
#include <QFile>
#include <QGuiApplication>
#include <QImage>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>
#include <QTemporaryDir>
#include <QTest>

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>

using namespace clothlab::render;

namespace {

const QString kShaders = QStringLiteral(CLOTHLAB_SOURCE_DIR "/shaders");
constexpr QSize kSize(320, 240);

// A context and a framebuffer to draw into.
class Canvas {
public:
    explicit Canvas(int samples = 0) : m_samples(samples) {
        QSurfaceFormat format;
        format.setVersion(3, 3);
        format.setProfile(QSurfaceFormat::CoreProfile);
        m_context.setFormat(format);
        m_surface.setFormat(format);
        m_surface.create();
        m_good = m_context.create() && m_context.makeCurrent(&m_surface);
    }

    bool isGood() const { return m_good; }

    QImage draw(Renderer& renderer, const RenderFrame& frame, QSize size = kSize) {
        QOpenGLFramebufferObjectFormat format;
        format.setAttachment(QOpenGLFramebufferObject::CombinedDepthStencil);
        format.setSamples(m_samples);
        QOpenGLFramebufferObject target(size, format);
        target.bind();
        renderer.render(frame, size);
        if (m_context.functions()->glGetError() != GL_NO_ERROR)
            return QImage();
        return target.toImage().convertToFormat(QImage::Format_ARGB32);
    }

private:
    int m_samples;
    bool m_good = false;
    QOpenGLContext m_context;
    QOffscreenSurface m_surface;
};

QMatrix4x4 viewFrom(const QVector3D& camera) {
    QMatrix4x4 view;
    view.perspective(35, float(kSize.width()) / float(kSize.height()), 0.01F, 100);
    view.lookAt(camera, QVector3D(0.5F, 0.5F, 0.5F), QVector3D(0, 1, 0));
    return view;
}

// A square of 1 m in y = 0.5, seen from above, with nothing else in the picture.
RenderFrame flatFrame(int points) {
    RenderFrame frame;
    frame.groundGrid = false;
    frame.axes = false;
    frame.sheet.width = points;
    frame.sheet.height = points;
    for (int y = 0; y < points; ++y)
        for (int x = 0; x < points; ++x)
            frame.sheet.positions.insert(frame.sheet.positions.end(),
                                         {static_cast<float>(x) / static_cast<float>(points - 1), 0.5F,
                                          static_cast<float>(y) / static_cast<float>(points - 1)});
    frame.cameraPosition = QVector3D(0.5F, 2, 1.2F);
    frame.viewProjection = viewFrom(frame.cameraPosition);
    return frame;
}

QPoint toPixel(const RenderFrame& frame, const QVector3D& world) {
    const QVector3D ndc = frame.viewProjection.map(world);
    return {int((ndc.x() + 1) / 2 * float(kSize.width())), int((1 - ndc.y()) / 2 * float(kSize.height()))};
}

// Where the middle of a pixel sees the plane y = height.
QVector3D toPlane(const RenderFrame& frame, QPoint pixel, float height) {
    const QMatrix4x4 inverse = frame.viewProjection.inverted();
    const float x = (float(pixel.x()) + 0.5F) / float(kSize.width()) * 2 - 1;
    const float y = 1 - (float(pixel.y()) + 0.5F) / float(kSize.height()) * 2;
    const QVector3D from = inverse.map(QVector3D(x, y, -1));
    const QVector3D along = inverse.map(QVector3D(x, y, 0.9F)) - from;
    return from + (height - from.y()) / along.y() * along;
}

bool isNear(QRgb a, QRgb b, int tolerance) {
    return std::abs(qRed(a) - qRed(b)) <= tolerance && std::abs(qGreen(a) - qGreen(b)) <= tolerance &&
           std::abs(qBlue(a) - qBlue(b)) <= tolerance;
}

int countPixels(const QImage& image, QColor color, int tolerance = 12) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += isNear(image.pixel(x, y), color.rgb(), tolerance) ? 1 : 0;
    return count;
}

bool write(const QString& path, const QByteArray& text) {
    QFile file(path);
    return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
}

constexpr const char* kRedShader =
    "#version 330\nout vec4 out_color;\nvoid main() { out_color = vec4(1, 0, 0, 1); }\n";

} // namespace

class RendererTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup();

    void saysWhyThereIsNothingToDrawWith();
    void backgroundIsOpaqueAndExact();
    void diffuseIsLambert();
    void bothSidesAreLit();
    void normalShaderShowsDirections();
    void phongIsBrighterInTheLightAndNeverBlownOut();
    void attributesOfTheCourse();
    void attributesWithTheirFourthComponent();
    void springTogglesChangeThePicture();
    void springsLieOverTheSurface();
    void springsAreAsWideAsTheScale();
    void sphereIsDrawnSmaller();
    void planeIsDrawnFromBothSides();
    void pinnedAndHighlightedShowThroughFaintly();
    void pinnedIndicesOutOfRangeAreLeftOut();
    void axesAndGridCanBeSwitchedOff();
    void listsShadersOnly();
    void brokenShaderKeepsDrawing();
    void editedShaderIsReadAgain();
    void directoryCanChange();
    void shaderWithItsOwnVertexShader();
    void directoryWithoutAnyShader();
    void survivesALostContext();
    void oddSheets_data();
    void oddSheets();
    void largeSheet();
    void multisampledEdgesAreSmooth();

private:
    std::unique_ptr<Canvas> m_canvas;
    std::unique_ptr<Renderer> m_renderer;
};

void RendererTest::initTestCase() {
    if (Canvas().isGood())
        return;
    if (qEnvironmentVariable("CLOTHLAB_REQUIRE_GL") == QLatin1String("1"))
        QFAIL("No OpenGL 3.3 core context can be made here, and CLOTHLAB_REQUIRE_GL=1 asks for one.");
    QSKIP("No OpenGL 3.3 core context can be made here (no display?).");
}

void RendererTest::init() {
    m_canvas = std::make_unique<Canvas>();
    m_renderer = std::make_unique<Renderer>();
    QString error;
    QVERIFY2(m_renderer->initialize(&error), qPrintable(error));
    m_renderer->setShaderDirectory(kShaders);
}

void RendererTest::cleanup() {
    if (m_renderer)
        m_renderer->release();
    m_renderer.reset();
    m_canvas.reset();
}

void RendererTest::saysWhyThereIsNothingToDrawWith() {
    m_renderer->release();
    m_canvas.reset();
    QString error;
    QVERIFY(!m_renderer->initialize(&error));
    QVERIFY2(error.contains(QStringLiteral("context")), qPrintable(error));
    QVERIFY(!m_renderer->initialize(nullptr));
    QVERIFY(!m_renderer->isInitialized());
    m_renderer->render(flatFrame(4), kSize);
    m_renderer->release();
}

void RendererTest::backgroundIsOpaqueAndExact() {
    RenderFrame frame = flatFrame(4);
    frame.sheet = SheetShape();
    const QImage image = m_canvas->draw(*m_renderer, frame);
    QCOMPARE(countPixels(image, frame.background, 0), kSize.width() * kSize.height());
    QCOMPARE(qAlpha(image.pixel(0, 0)), 255);
    m_renderer->render(frame, QSize(0, 10));
}

void RendererTest::diffuseIsLambert() {
    RenderFrame frame = flatFrame(20);
    frame.shader = QStringLiteral("Diffuse");
    frame.color = QVector4D(0.9F, 0.6F, 0.3F, 1);
    const QImage image = m_canvas->draw(*m_renderer, frame);
    QVERIFY2(m_renderer->messages().isEmpty(), qPrintable(m_renderer->messages().join(u'\n')));
    for (int i = 0; i < 10; ++i) {
        const QPoint pixel =
            toPixel(frame, QVector3D(0.05F + 0.1F * float(i), 0.5F, 0.08F + 0.09F * float((i * 7) % 10)));
        const QVector3D toLight = frame.lightPosition - toPlane(frame, pixel, 0.5F);
        const float cosine = toLight.normalized().y();
        const QVector3D lit =
            frame.color.toVector3D() * frame.lightIntensity * (cosine / toLight.lengthSquared());
        const auto channel = [](float value) { return int(std::lround(255 * std::min(value, 1.0F))); };
        const QRgb expected = qRgb(channel(lit.x()), channel(lit.y()), channel(lit.z()));
        QVERIFY2(isNear(image.pixel(pixel), expected, 2),
                 qPrintable(QStringLiteral("%1 at %2,%3, expected %4")
                                .arg(QColor(image.pixel(pixel)).name())
                                .arg(pixel.x())
                                .arg(pixel.y())
                                .arg(QColor(expected).name())));
    }
}

// With light and camera mirrored at the sheet, the picture from below is as bright as that from above.
void RendererTest::bothSidesAreLit() {
    for (const char* shader : {"Diffuse", "Phong"}) {
        RenderFrame frame = flatFrame(10);
        frame.shader = QString::fromLatin1(shader);
        const QPoint middle = toPixel(frame, QVector3D(0.4F, 0.5F, 0.4F));
        const QRgb above = m_canvas->draw(*m_renderer, frame).pixel(middle);
        frame.cameraPosition.setY(1 - frame.cameraPosition.y());
        frame.lightPosition.setY(1 - frame.lightPosition.y());
        frame.viewProjection = viewFrom(frame.cameraPosition);
        const QRgb below =
            m_canvas->draw(*m_renderer, frame).pixel(toPixel(frame, QVector3D(0.4F, 0.5F, 0.4F)));
        QVERIFY(qRed(below) > 60);
        // The sky is brighter than the ground; the lamp is the same.
        QVERIFY(isNear(above, below, frame.shader == QLatin1String("Phong") ? 40 : 2));
    }
}

void RendererTest::normalShaderShowsDirections() {
    RenderFrame frame = flatFrame(10);
    frame.shader = QStringLiteral("Normal");
    const QImage up = m_canvas->draw(*m_renderer, frame);
    for (const float u : {0.1F, 0.35F, 0.5F, 0.9F})
        QVERIFY(isNear(up.pixel(toPixel(frame, QVector3D(u, 0.5F, 1 - u))), qRgb(128, 255, 128), 1));
    for (std::size_t i = 0; i < frame.sheet.positions.size(); i += 3) // tilted: y grows with x by 1 : 1
        frame.sheet.positions[i + 1] = frame.sheet.positions[i];
    const QImage tilted = m_canvas->draw(*m_renderer, frame);
    const int high = int(std::lround(255 * (0.5 + 0.5 * std::sqrt(0.5))));
    QVERIFY(
        isNear(tilted.pixel(toPixel(frame, QVector3D(0.5F, 0.5F, 0.5F))), qRgb(255 - high, high, 128), 1));
}

void RendererTest::phongIsBrighterInTheLightAndNeverBlownOut() {
    RenderFrame frame = flatFrame(20);
    const QPoint nearLight = toPixel(frame, QVector3D(0.5F, 0.5F, 0.9F));
    const QPoint far = toPixel(frame, QVector3D(0.1F, 0.5F, 0.1F));
    const QImage lit = m_canvas->draw(*m_renderer, frame);
    QVERIFY(qRed(lit.pixel(nearLight)) > qRed(lit.pixel(far)) + 10);
    QVERIFY(qRed(lit.pixel(far)) > 100); // well lit
    frame.lightIntensity *= 20;
    const QImage glaring = m_canvas->draw(*m_renderer, frame);
    QVERIFY(qRed(glaring.pixel(nearLight)) < 255);
    QVERIFY(qRed(glaring.pixel(nearLight)) > qRed(glaring.pixel(far)));
    frame.lightIntensity = QVector3D();
    const QRgb dark = m_canvas->draw(*m_renderer, frame).pixel(far);
    QVERIFY(qRed(dark) > qRed(frame.background.rgb()) + 20); // ambient light is left
}

// A shader that returns its inputs: names, w components and values of all attributes, through our
// Default.vert.
void RendererTest::attributesOfTheCourse() {
    QTemporaryDir directory;
    QVERIFY(
        write(directory.filePath(QStringLiteral("Show.frag")),
              "#version 330\nin vec4 v_position; in vec4 v_normal; in vec4 v_tangent; in vec2 v_uv;\n"
              "uniform vec4 u_color; uniform vec3 u_cam_pos; uniform vec3 u_light_pos; out vec4 out_color;\n"
              "void main() {\n"
              "  bool good = abs(v_position.w - 1.0) < 1e-4 && v_normal.w == 0.0 && v_tangent.w == 0.0\n"
              "    && abs(v_position.y - 0.5) < 1e-4 && distance(v_position.xz, v_uv) < 1e-3\n"
              "    && distance(v_normal.xyz, vec3(0, 1, 0)) < 1e-3 && distance(v_tangent.xyz, vec3(1, 0, 0)) "
              "< 1e-3\n"
              "    && distance(u_cam_pos, vec3(0.5, 2.0, 1.2)) < 1e-4 && u_light_pos == vec3(0.5, 2, 2);\n"
              "  out_color = vec4(v_uv, good ? u_color.b : 0.0, 0.0);\n}\n"));
    m_renderer->setShaderDirectory(directory.path());
    RenderFrame frame = flatFrame(10);
    frame.shader = QStringLiteral("Show");
    const QImage image = m_canvas->draw(*m_renderer, frame);
    QVERIFY2(m_renderer->messages().isEmpty(), qPrintable(m_renderer->messages().join(u'\n')));
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
void RendererTest::attributesWithTheirFourthComponent() {
    QTemporaryDir directory;
    QVERIFY(write(directory.filePath(QStringLiteral("Raw.vert")),
                  "#version 330\nuniform mat4 u_model; uniform mat4 u_view_projection;\n"
                  "in vec4 in_position; in vec4 in_normal; in vec4 in_tangent; flat out vec4 v_color;\n"
                  "void main() {\n  gl_Position = u_view_projection * u_model * in_position;\n"
                  "  v_color = vec4(in_position.w, in_normal.w, in_tangent.w, 1.0);\n}\n"));
    QVERIFY(write(
        directory.filePath(QStringLiteral("Raw.frag")),
        "#version 330\nflat in vec4 v_color; out vec4 out_color;\nvoid main() { out_color = v_color; }\n"));
    m_renderer->setShaderDirectory(directory.path());
    RenderFrame frame = flatFrame(10);
    frame.shader = QStringLiteral("Raw");
    frame.spheres = {{QVector3D(0.5F, 0.6F, 0.5F), 0.3F}};
    const QImage image = m_canvas->draw(*m_renderer, frame);
    QVERIFY2(m_renderer->messages().isEmpty(), qPrintable(m_renderer->messages().join(u'\n')));
    for (const QVector3D place : {QVector3D(0.05F, 0.5F, 0.5F), QVector3D(0.5F, 0.85F, 0.5F)})
        QCOMPARE(image.pixel(toPixel(frame, place)), qRgb(255, 0, 0));
}

void RendererTest::springTogglesChangeThePicture() {
    RenderFrame frame = flatFrame(6);
    frame.shader = QStringLiteral("Wireframe");
    for (int shown = 0; shown < 8; ++shown) {
        for (std::size_t type = 0; type < 3; ++type)
            frame.springsDrawn[type] = (shown >> type) & 1;
        const QImage image = m_canvas->draw(*m_renderer, frame);
        QVERIFY2(m_renderer->messages().isEmpty(), qPrintable(m_renderer->messages().join(u'\n')));
        for (std::size_t type = 0; type < 3; ++type) {
            // On a flat sheet structural springs cover the middle of bending ones: an edge is left to see.
            const int seen = countPixels(image, frame.springColors[type], 40);
            QVERIFY2(
                frame.springsDrawn[type] ? seen > 25 : seen == 0,
                qPrintable(QStringLiteral("shown %1, type %2: %3 pixels").arg(shown).arg(type).arg(seen)));
        }
        if (shown == 0)
            QCOMPARE(countPixels(image, frame.background, 0), kSize.width() * kSize.height());
    }
}

void RendererTest::springsLieOverTheSurface() {
    RenderFrame frame = flatFrame(6);
    const QImage without = m_canvas->draw(*m_renderer, frame);
    QCOMPARE(countPixels(without, frame.springColors[0], 40), 0);
    frame.springsOverSurface = true;
    frame.springsDrawn = {true, false, false};
    const QImage with = m_canvas->draw(*m_renderer, frame);
    // Along a whole spring no pixel is lost to the surface in which it lies.
    for (int i = 5; i <= 95; ++i) {
        const QPoint pixel = toPixel(frame, QVector3D(0.4F, 0.5F, 0.01F * float(i)));
        bool seen = false;
        for (int dx = -1; dx <= 1; ++dx)
            seen = seen || isNear(with.pixel(pixel + QPoint(dx, 0)), frame.springColors[0].rgb(), 60);
        QVERIFY(seen);
    }
}

void RendererTest::springsAreAsWideAsTheScale() {
    RenderFrame frame = flatFrame(4);
    frame.shader = QStringLiteral("Wireframe");
    frame.springsDrawn = {true, false, false};
    const int thin = countPixels(m_canvas->draw(*m_renderer, frame), frame.background, 0);
    frame.devicePixelRatio = 3;
    const int thick = countPixels(m_canvas->draw(*m_renderer, frame), frame.background, 0);
    const int all = kSize.width() * kSize.height();
    QVERIFY(all - thick > 2 * (all - thin) - (all - thin) / 4);
}

void RendererTest::sphereIsDrawnSmaller() {
    QTemporaryDir directory;
    QVERIFY(write(directory.filePath(QStringLiteral("Show.frag")),
                  "#version 330\nin vec4 v_normal; in vec2 v_uv; out vec4 out_color;\n"
                  "void main() { out_color = vec4(0.5 + 0.5 * v_normal.xy, v_uv.y, 1); }\n"));
    m_renderer->setShaderDirectory(directory.path());
    RenderFrame frame = flatFrame(4);
    frame.sheet = SheetShape();
    frame.shader = QStringLiteral("Show");
    frame.viewProjection = QMatrix4x4();
    frame.viewProjection.ortho(-1.6F, 1.6F, -1.2F, 1.2F, -5, 5); // 100 pixels a metre, looking along -z
    frame.spheres = {{QVector3D(0, 0, 0), 1.0F}, {QVector3D(1, 1, 0), 0.0F}};
    const QImage image = m_canvas->draw(*m_renderer, frame);
    const int covered = kSize.width() * kSize.height() - countPixels(image, frame.background, 0);
    QVERIFY(std::abs(covered - 3.14159 * 92 * 92) < 0.005 * covered);
    QVERIFY(isNear(image.pixel(160, 120), qRgb(128, 128, 128), 2));      // the equator
    QVERIFY(isNear(image.pixel(160 + 65, 120), qRgb(218, 128, 128), 4)); // 45 degrees to the right
    QVERIFY(isNear(image.pixel(160, 120 - 65), qRgb(128, 218, 64), 4));  // 45 degrees to the north pole
}

void RendererTest::planeIsDrawnFromBothSides() {
    RenderFrame frame = flatFrame(4);
    frame.sheet = SheetShape();
    for (const QVector3D normal : {QVector3D(0, 1, 0), QVector3D(0, -1, 0)}) {
        frame.planes = {{QVector3D(0.5F, 0, 0.5F), normal}};
        const QImage image = m_canvas->draw(*m_renderer, frame);
        const QRgb middle = image.pixel(kSize.width() / 2, kSize.height() / 2);
        QVERIFY(qRed(middle) > qRed(frame.background.rgb()) + 20); // lit
        QVERIFY(qRed(middle) < 160);                               // and calmer than the sheet
    }
    frame.planes = {{QVector3D(), QVector3D()}};
    QCOMPARE(countPixels(m_canvas->draw(*m_renderer, frame), frame.background, 0),
             kSize.width() * kSize.height());
}

void RendererTest::pinnedAndHighlightedShowThroughFaintly() {
    RenderFrame frame = flatFrame(5);
    frame.shader = QStringLiteral("Normal"); // one known colour under the dots
    const QRgb surface = qRgb(128, 255, 128);
    frame.sheet.pinned = {12, 4'000'000};
    const QPoint middle = toPixel(frame, QVector3D(0.5F, 0.5F, 0.5F));
    QVERIFY(isNear(m_canvas->draw(*m_renderer, frame).pixel(middle), frame.pinnedColor.rgb(), 2));

    frame.sheet.pinned.clear();
    QVERIFY(isNear(m_canvas->draw(*m_renderer, frame).pixel(middle), surface, 1));
    frame.highlight.points = {QVector3D(0.5F, 0.5F, 0.5F)};
    QVERIFY(isNear(m_canvas->draw(*m_renderer, frame).pixel(middle), frame.highlightColor.rgb(), 2));
    frame.highlight.points.clear();
    frame.highlight.segments = {{QVector3D(0.3F, 0.5F, 0.5F), QVector3D(0.7F, 0.5F, 0.5F)}};
    QVERIFY(isNear(m_canvas->draw(*m_renderer, frame).pixel(middle), frame.highlightColor.rgb(), 2));

    frame.highlight.segments.clear();
    frame.highlight.points = {QVector3D(0.5F, 0.2F, 0.5F)}; // below the sheet
    const QPoint below = toPixel(frame, QVector3D(0.5F, 0.2F, 0.5F));
    const QRgb ghost = m_canvas->draw(*m_renderer, frame).pixel(below);
    const auto mixed = [&](int under, int over) { return int(std::lround(0.7 * under + 0.3 * over)); };
    QVERIFY(isNear(ghost,
                   qRgb(mixed(128, frame.highlightColor.red()), mixed(255, frame.highlightColor.green()),
                        mixed(128, frame.highlightColor.blue())),
                   3));
}

// Drivers that guard reads past a buffer make zeros of them: a dot at the origin.
void RendererTest::pinnedIndicesOutOfRangeAreLeftOut() {
    RenderFrame frame = flatFrame(5);
    for (std::size_t i = 1; i < frame.sheet.positions.size(); i += 3)
        frame.sheet.positions[i] = -1; // out of the way of the origin
    const QImage without = m_canvas->draw(*m_renderer, frame);
    frame.sheet.pinned = {25, 4'000'000, 0xFFFFFFFF};
    QCOMPARE(m_canvas->draw(*m_renderer, frame), without);
}

void RendererTest::axesAndGridCanBeSwitchedOff() {
    RenderFrame frame = flatFrame(4);
    frame.sheet = SheetShape();
    const int all = kSize.width() * kSize.height();
    frame.axes = true;
    const QImage axes = m_canvas->draw(*m_renderer, frame);
    QVERIFY(countPixels(axes, QColor(0xE6, 0x61, 0x66), 20) > 10); // x goes to the right
    for (int y = 0; y < kSize.height(); ++y)
        for (int x = 0; x < kSize.width(); ++x)
            QVERIFY((x < 100 && y > kSize.height() - 100) ||
                    isNear(axes.pixel(x, y), frame.background.rgb(), 0));
    frame.axes = false;
    frame.groundGrid = true;
    QVERIFY(countPixels(m_canvas->draw(*m_renderer, frame), frame.background, 0) < all - 500);
    frame.gridOpacity = 0;
    QCOMPARE(countPixels(m_canvas->draw(*m_renderer, frame), frame.background, 0), all);
}

void RendererTest::listsShadersOnly() {
    QCOMPARE(listShaders(kShaders).first(), QStringLiteral("Wireframe"));
    for (const char* name : {"Diffuse", "Normal", "Phong"})
        QVERIFY(listShaders(kShaders).contains(QLatin1String(name)));
    QVERIFY(!listShaders(kShaders).contains(QStringLiteral("line")));
    QVERIFY(listShaders(QStringLiteral("/nowhere")).isEmpty());
    QVERIFY(listShaders(QString()).isEmpty());

    QTemporaryDir directory;
    for (const char* name : {"b.frag", "A.frag", "Wireframe.frag", "Default.vert", "notes.txt"})
        QVERIFY(write(directory.filePath(QLatin1String(name)), " "));
    QCOMPARE(listShaders(directory.path()),
             QStringList({QStringLiteral("Wireframe"), QStringLiteral("A"), QStringLiteral("b")}));
}

void RendererTest::brokenShaderKeepsDrawing() {
    QTemporaryDir directory;
    QVERIFY(write(directory.filePath(QStringLiteral("Red.frag")), kRedShader));
    QVERIFY(write(directory.filePath(QStringLiteral("Broken.frag")),
                  "#version 330\nout vec4 out_color;\nvoid main() {\n  out_color = nonsense;\n}\n"));
    QVERIFY(write(
        directory.filePath(QStringLiteral("Unlinked.frag")),
        "#version 330\nvec4 elsewhere();\nout vec4 out_color;\nvoid main() { out_color = elsewhere(); }\n"));
    QVERIFY(write(directory.filePath(QStringLiteral("Wireframe.frag")), "#version 330\nvoid main() { !\n"));
    m_renderer->setShaderDirectory(directory.path());
    RenderFrame frame = flatFrame(5);
    const QPoint middle = toPixel(frame, QVector3D(0.4F, 0.5F, 0.4F));

    frame.shader = QStringLiteral("Broken"); // nothing was good before: plain
    QVERIFY(qRed(m_canvas->draw(*m_renderer, frame).pixel(middle)) > 150);
    QVERIFY2(m_renderer->messages().first().startsWith(QStringLiteral("Broken.frag:4: ")),
             qPrintable(m_renderer->messages().join(u'\n')));

    frame.shader = QStringLiteral("Red");
    QVERIFY(isNear(m_canvas->draw(*m_renderer, frame).pixel(middle), qRgb(255, 0, 0), 0));
    QVERIFY(m_renderer->messages().isEmpty());

    for (const char* name : {"Broken", "Unlinked", "Missing"}) {
        frame.shader = QLatin1String(name);
        QVERIFY(isNear(m_canvas->draw(*m_renderer, frame).pixel(middle), qRgb(255, 0, 0), 0));
        QVERIFY2(m_renderer->messages().join(u'\n').contains(frame.shader + QStringLiteral(".frag")),
                 qPrintable(m_renderer->messages().join(u'\n')));
    }

    frame.shader = QStringLiteral("Wireframe");
    QVERIFY(countPixels(m_canvas->draw(*m_renderer, frame), frame.springColors[0], 40) > 50);
    QVERIFY(m_renderer->messages().join(u'\n').contains(QStringLiteral("Wireframe.frag:2: ")));
}

void RendererTest::editedShaderIsReadAgain() {
    QTemporaryDir directory;
    const QString path = directory.filePath(QStringLiteral("Mine.frag"));
    QVERIFY(write(path, kRedShader));
    m_renderer->setShaderDirectory(directory.path());
    RenderFrame frame = flatFrame(5);
    frame.shader = QStringLiteral("Mine");
    const QPoint middle = toPixel(frame, QVector3D(0.4F, 0.5F, 0.4F));
    QVERIFY(isNear(m_canvas->draw(*m_renderer, frame).pixel(middle), qRgb(255, 0, 0), 0));

    QVERIFY(write(path, QByteArray("\xEF\xBB\xBF") + QByteArray(kRedShader).replace("1, 0, 0", "0, 0, 1")));
    QVERIFY(isNear(m_canvas->draw(*m_renderer, frame).pixel(middle), qRgb(255, 0, 0), 0));
    m_renderer->reloadShaders();
    QVERIFY(isNear(m_canvas->draw(*m_renderer, frame).pixel(middle), qRgb(0, 0, 255), 0));
    QVERIFY(write(path, "#version 330\n\nsyntax!\n"));
    m_renderer->reloadShaders();
    QVERIFY(isNear(m_canvas->draw(*m_renderer, frame).pixel(middle), qRgb(0, 0, 255), 0));
    QVERIFY(m_renderer->messages().first().startsWith(QStringLiteral("Mine.frag:3: ")));
}

void RendererTest::directoryCanChange() {
    QTemporaryDir red;
    QTemporaryDir blue;
    QVERIFY(write(red.filePath(QStringLiteral("Mine.frag")), kRedShader));
    QVERIFY(write(blue.filePath(QStringLiteral("Mine.frag")),
                  QByteArray(kRedShader).replace("1, 0, 0", "0, 0, 1")));
    RenderFrame frame = flatFrame(5);
    frame.shader = QStringLiteral("Mine");
    const QPoint middle = toPixel(frame, QVector3D(0.4F, 0.5F, 0.4F));
    m_renderer->setShaderDirectory(red.path());
    QVERIFY(isNear(m_canvas->draw(*m_renderer, frame).pixel(middle), qRgb(255, 0, 0), 0));
    m_renderer->setShaderDirectory(blue.path());
    QVERIFY(isNear(m_canvas->draw(*m_renderer, frame).pixel(middle), qRgb(0, 0, 255), 0));
}

void RendererTest::shaderWithItsOwnVertexShader() {
    QTemporaryDir directory;
    QVERIFY(write(directory.filePath(QStringLiteral("Moved.frag")), kRedShader));
    QVERIFY(write(
        directory.filePath(QStringLiteral("Moved.vert")),
        "#version 330\nuniform mat4 u_view_projection; uniform float u_height_scaling;\n"
        "in vec4 in_position;\nvoid main() {\n"
        "  gl_Position = u_view_projection * (in_position + vec4(20.0 * u_height_scaling, 0, 0, 0));\n}\n"));
    m_renderer->setShaderDirectory(directory.path());
    RenderFrame frame = flatFrame(5);
    frame.shader = QStringLiteral("Moved"); // 2 m aside: out of the picture
    QCOMPARE(countPixels(m_canvas->draw(*m_renderer, frame), frame.background, 0),
             kSize.width() * kSize.height());
    QVERIFY2(m_renderer->messages().isEmpty(), qPrintable(m_renderer->messages().join(u'\n')));
}

void RendererTest::directoryWithoutAnyShader() {
    m_renderer->setShaderDirectory(QStringLiteral("/nowhere"));
    RenderFrame frame = flatFrame(5);
    frame.springsOverSurface = true;
    const QImage image = m_canvas->draw(*m_renderer, frame);
    QVERIFY(qRed(image.pixel(toPixel(frame, QVector3D(0.44F, 0.5F, 0.36F)))) > 100);
    QVERIFY(countPixels(image, frame.springColors[0], 40) > 25);
    QCOMPARE(m_renderer->messages().size(), 1);
}

void RendererTest::survivesALostContext() {
    RenderFrame frame = flatFrame(12);
    frame.groundGrid = true;
    frame.axes = true;
    frame.springsOverSurface = true;
    frame.sheet.pinned = {0, 11};
    frame.spheres = {{QVector3D(0.5F, 0.3F, 0.5F), 0.3F}};
    const QImage first = m_canvas->draw(*m_renderer, frame);
    QVERIFY(!first.isNull());

    m_renderer->release();
    QVERIFY(!m_renderer->isInitialized());
    m_canvas = std::make_unique<Canvas>();
    QVERIFY(m_renderer->initialize(nullptr));
    QCOMPARE(m_canvas->draw(*m_renderer, frame), first);

    m_canvas = std::make_unique<Canvas>(); // gone without a chance to release
    QVERIFY(m_renderer->initialize(nullptr));
    QCOMPARE(m_canvas->draw(*m_renderer, frame), first);
}

void RendererTest::oddSheets_data() {
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::addColumn<int>("floats");
    QTest::newRow("empty") << 0 << 0 << 0;
    QTest::newRow("no positions yet") << 10 << 10 << 0;
    QTest::newRow("too few positions") << 10 << 10 << 299;
    QTest::newRow("one point") << 1 << 1 << 3;
    QTest::newRow("one row") << 5 << 1 << 15;
    QTest::newRow("one column") << 1 << 5 << 15;
    QTest::newRow("two by two") << 2 << 2 << 12;
    QTest::newRow("negative") << -2 << -2 << 12;
}

void RendererTest::oddSheets() {
    QFETCH(int, width);
    QFETCH(int, height);
    QFETCH(int, floats);
    RenderFrame frame = flatFrame(8);
    for (const char* shader : {"Phong", "Wireframe"}) {
        for (const float value : {0.5F, std::numeric_limits<float>::quiet_NaN(), 1e38F}) {
            frame.shader = QLatin1String(shader);
            frame.springsOverSurface = true;
            frame.sheet.width = width;
            frame.sheet.height = height;
            frame.sheet.positions.assign(static_cast<std::size_t>(floats), value);
            frame.sheet.pinned = {0, 1, 100};
            QVERIFY(!m_canvas->draw(*m_renderer, frame).isNull());
        }
    }
    const RenderFrame usual = flatFrame(8); // and nothing of it is left
    const QPoint middle = toPixel(usual, QVector3D(0.44F, 0.5F, 0.36F));
    QVERIFY(qRed(m_canvas->draw(*m_renderer, usual).pixel(middle)) > 100);
}

void RendererTest::largeSheet() {
    RenderFrame frame = flatFrame(512);
    frame.springsOverSurface = true;
    const QImage image = m_canvas->draw(*m_renderer, frame);
    QVERIFY(!image.isNull());
    // Springs closer than pixels tint the sheet, and leave it visible.
    const QRgb middle = image.pixel(toPixel(frame, QVector3D(0.5F, 0.5F, 0.5F)));
    QVERIFY(qRed(middle) > 80);
}

void RendererTest::multisampledEdgesAreSmooth() {
    Canvas smooth(4);
    QVERIFY(smooth.isGood());
    Renderer renderer;
    QVERIFY(renderer.initialize(nullptr));
    renderer.setShaderDirectory(kShaders);
    RenderFrame frame = flatFrame(4);
    frame.shader = QStringLiteral("Normal");
    const QImage image = smooth.draw(renderer, frame);
    const int all = kSize.width() * kSize.height();
    const int between =
        all - countPixels(image, frame.background, 1) - countPixels(image, QColor(128, 255, 128), 2);
    QVERIFY(between > 20);
    renderer.release();
}

int main(int argc, char** argv) {
    // Without a display the default platform would abort, where the test wants to say what is missing.
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM") && !qEnvironmentVariableIsSet("DISPLAY") &&
        !qEnvironmentVariableIsSet("WAYLAND_DISPLAY"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    QGuiApplication application(argc, argv);
    RendererTest test;
    return QTest::qExec(&test, argc, argv);
}
#include "tst_renderer.moc"
