// What all tests of pictures need: a context to draw in, a sheet to draw, and ways to look at pixels.
#pragma once

#include "app/render/renderer.h"

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
#include <optional>

namespace clothlab::render {

inline const QString kShaders = QStringLiteral(CLOTHLAB_SOURCE_DIR "/shaders");
inline const QString kTextures = QStringLiteral(CLOTHLAB_SOURCE_DIR "/resources/textures");
inline constexpr QSize kSize(320, 240);

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
        m_good = m_context.create() && makeCurrent();
    }

    bool isGood() const { return m_good; }
    bool makeCurrent() { return m_context.makeCurrent(&m_surface); }

    // A null picture if OpenGL found fault with a call.
    QImage draw(Renderer& renderer, const RenderFrame& frame, QSize size = kSize) {
        makeCurrent();
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

// A canvas with a renderer that reads the program's own shaders and textures.
class Studio {
public:
    Studio() {
        m_good = m_canvas->isGood() && renderer.initialize(nullptr);
        renderer.setShaderDirectory(kShaders);
        renderer.setTextureDirectory(kTextures);
    }
    ~Studio() {
        if (m_canvas && m_canvas->makeCurrent())
            renderer.release();
    }
    Studio(const Studio&) = delete;
    Studio& operator=(const Studio&) = delete;

    bool isGood() const { return m_good; }
    QImage draw(const RenderFrame& frame, QSize size = kSize) {
        return m_canvas->draw(renderer, frame, size);
    }

    // What is wrong with the last picture's files, in words.
    QString faults() const {
        QStringList lines;
        for (const Problem& problem : renderer.problems())
            lines.append(words(problem));
        return lines.join(u'\n');
    }

    void loseContext() { m_canvas.reset(); }
    bool beginNewContext() {
        m_canvas.emplace();
        return renderer.initialize(nullptr);
    }

private:
    std::optional<Canvas> m_canvas{std::in_place}; // outlives the renderer
    bool m_good = false;

public:
    Renderer renderer;
};

// A folder of shaders that the test writes, over textures that are the program's own.
class ShaderDirectory {
public:
    bool write(const QString& name, const QByteArray& text) const {
        QFile file(path(name));
        return file.open(QIODevice::WriteOnly) && file.write(text) == text.size();
    }
    QString path(const QString& name) const { return m_directory.filePath(name); }
    QString path() const { return m_directory.path(); }

private:
    QTemporaryDir m_directory;
};

inline QMatrix4x4 viewFrom(const QVector3D& camera, const QVector3D& target = {0.5F, 0.5F, 0.5F}) {
    QMatrix4x4 view;
    view.perspective(35, float(kSize.width()) / float(kSize.height()), 0.01F, 100);
    view.lookAt(camera, target, QVector3D(0, 1, 0));
    return view;
}

inline void lookFrom(RenderFrame& frame, const QVector3D& camera) {
    frame.cameraPosition = camera;
    frame.viewProjection = viewFrom(camera);
}

// `place` gives the point at (u, v), each 0 … 1.
template <typename Place>
SheetShape sheetOf(int width, int height, Place place) {
    SheetShape sheet;
    sheet.width = width;
    sheet.height = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const QVector3D p = place(float(x) / float(width - 1), float(y) / float(height - 1));
            sheet.positions.insert(sheet.positions.end(), {p.x(), p.y(), p.z()});
        }
    return sheet;
}

// Nothing but the background, seen from above the unit cube.
inline RenderFrame emptyFrame() {
    RenderFrame frame;
    frame.groundGrid = false;
    frame.axes = false;
    frame.light.shadows = false;
    lookFrom(frame, QVector3D(0.5F, 2, 1.2F));
    return frame;
}

// A square of 1 m in y = 0.5, seen from above, with nothing else in the picture.
inline RenderFrame flatFrame(int points) {
    RenderFrame frame = emptyFrame();
    frame.sheet = sheetOf(points, points, [](float u, float v) { return QVector3D(u, 0.5F, v); });
    return frame;
}

inline QPoint toPixel(const RenderFrame& frame, const QVector3D& world) {
    const QVector3D ndc = frame.viewProjection.map(world);
    return {int((ndc.x() + 1) / 2 * float(kSize.width())), int((1 - ndc.y()) / 2 * float(kSize.height()))};
}

// What the middle of a pixel looks along.
struct Ray {
    QVector3D from;
    QVector3D along; // of unit length

    // Where it meets the plane, wherever that is.
    QVector3D meets(const QVector3D& point, const QVector3D& normal) const {
        return from +
               QVector3D::dotProduct(point - from, normal) / QVector3D::dotProduct(along, normal) * along;
    }
};

inline Ray rayThrough(const RenderFrame& frame, QPoint pixel) {
    const QMatrix4x4 inverse = frame.viewProjection.inverted();
    const float x = (float(pixel.x()) + 0.5F) / float(kSize.width()) * 2 - 1;
    const float y = 1 - (float(pixel.y()) + 0.5F) / float(kSize.height()) * 2;
    const QVector3D from = inverse.map(QVector3D(x, y, -1));
    return {from, (inverse.map(QVector3D(x, y, 0.9F)) - from).normalized()};
}

// Where the middle of a pixel sees the plane y = height.
inline QVector3D toPlane(const RenderFrame& frame, QPoint pixel, float height) {
    return rayThrough(frame, pixel).meets(QVector3D(0, height, 0), QVector3D(0, 1, 0));
}

inline bool isNear(QRgb a, QRgb b, int tolerance) {
    return std::abs(qRed(a) - qRed(b)) <= tolerance && std::abs(qGreen(a) - qGreen(b)) <= tolerance &&
           std::abs(qBlue(a) - qBlue(b)) <= tolerance;
}

// The colour a shader's output of 0 … 1 comes out as.
inline QRgb toColor(const QVector3D& value) {
    const auto channel = [](float v) { return int(std::lround(255 * std::clamp(v, 0.0F, 1.0F))); };
    return qRgb(channel(value.x()), channel(value.y()), channel(value.z()));
}

inline QVector3D toVector(QRgb color) {
    return QVector3D(float(qRed(color)), float(qGreen(color)), float(qBlue(color))) / 255;
}

// For messages of failed comparisons.
inline QByteArray seen(const QImage& image, QPoint pixel, QRgb expected) {
    return QStringLiteral("%1 at %2,%3, expected %4")
        .arg(QColor(image.pixel(pixel)).name())
        .arg(pixel.x())
        .arg(pixel.y())
        .arg(QColor(expected).name())
        .toUtf8();
}

inline int countPixels(const QImage& image, QColor color, int tolerance = 12) {
    int count = 0;
    for (int y = 0; y < image.height(); ++y)
        for (int x = 0; x < image.width(); ++x)
            count += isNear(image.pixel(x, y), color.rgb(), tolerance) ? 1 : 0;
    return count;
}

inline UniformSetting number(float value) {
    return {1, {value}, {}};
}

constexpr const char* kRedShader =
    "#version 330\nout vec4 out_color;\nvoid main() { out_color = vec4(1, 0, 0, 1); }\n";

// A main that says what is missing where there is no display, on which the default platform would abort.
template <typename Test>
int runOnDisplay(int argc, char** argv) {
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM") && !qEnvironmentVariableIsSet("DISPLAY") &&
        !qEnvironmentVariableIsSet("WAYLAND_DISPLAY"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    QGuiApplication application(argc, argv);
    Test test;
    return QTest::qExec(&test, argc, argv);
}

} // namespace clothlab::render

// For initTestCase(): nothing can be tested without a context.
#define SKIP_WITHOUT_OPENGL()                                                                                \
    if (!clothlab::render::Canvas().isGood()) {                                                              \
        if (qEnvironmentVariable("CLOTHLAB_REQUIRE_GL") == QLatin1String("1"))                               \
            QFAIL("No OpenGL 3.3 core context can be made here, and CLOTHLAB_REQUIRE_GL=1 asks for one.");   \
        QSKIP("No OpenGL 3.3 core context can be made here (no display?).");                                 \
    }
