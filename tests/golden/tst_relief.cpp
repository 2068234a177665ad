// Bump mapping and displacement against the surface that a height map makes, differentiated numerically.
#include "tests/golden/canvas.h"

#include <functional>
#include <numbers>
#include <optional>

using namespace clothlab::render;

namespace {

constexpr float kDepth = 0.06F; // metres of white
constexpr int kSide = 64;       // texels of the height map
constexpr float kPi = std::numbers::pi_v<float>;

float height(float u, float v) {
    return 0.5F + 0.2F * std::sin(4 * kPi * u) * std::cos(2 * kPi * v) + 0.2F * std::sin(2 * kPi * (u + v));
}

using Surface = std::function<QVector3D(float, float)>;

QVector3D flat(float u, float v) {
    return {u, 0.5F, v};
}

// Tilted, and not as long as it is wide, so that u and v are not metres.
QVector3D stretched(float u, float v) {
    return {1.3F * u - 0.15F, 0.3F + 0.4F * u, 0.1F + 0.7F * v};
}

QVector3D arched(float u, float v) {
    return {0.5F + std::sin(u - 0.5F), std::cos(u - 0.5F) - 0.4F, v};
}

const QVector3D kCentre(0.5F, 0.5F, 0.5F);

QVector3D ball(float u, float v) {
    const float ring = std::sin(kPi * v);
    const QVector3D direction(ring * std::cos(2 * kPi * u), std::cos(kPi * v), -ring * std::sin(2 * kPi * u));
    return kCentre + 0.46F * direction;
}

QVector3D normalOf(const Surface& surface, float u, float v) {
    const float step = 2e-3F;
    const QVector3D du = surface(u + step, v) - surface(u - step, v);
    const QVector3D dv = surface(u, v + step) - surface(u, v - step);
    return QVector3D::crossProduct(dv, du).normalized();
}

Surface displaced(const Surface& surface) {
    return [surface](float u, float v) {
        return surface(u, v) + kDepth * height(u, v) * normalOf(surface, u, v);
    };
}

// A picture of a shader whose output is a value of 0 … 1 for each channel.
QByteArray fragment(const char* output) {
    return QByteArray(
               "#version 330\n#include \"relief.glsl\"\n"
               "in vec4 v_position; in vec4 v_base; in vec4 v_normal; in vec2 v_uv; out vec4 out_color;\n"
               "uniform sampler2D u_texture_2; uniform sampler2D u_texture_3;\n"
               "uniform float u_height_scaling; uniform float u_depth;\n"
               "void main() {\n  vec3 n = normalize(v_normal.xyz);\n  vec3 shown = ") +
           output + ";\n  out_color = vec4(shown, 1.0);\n}\n";
}

QByteArray contentOf(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

} // namespace

class ReliefTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup() { m_studio.reset(); }

    void bumpNormals_data();
    void bumpNormals();
    void displacedPoints_data();
    void displacedPoints();
    void displacedSphereAtItsVertices();
    void displacedNormals_data();
    void displacedNormals();
    void scalingsMultiply();

private:
    RenderFrame frameOf(const QString& surface, int resolution) const;
    void compareNormals(const QString& surface, int resolution, bool moved);
    QImage drawn(RenderFrame& frame, const char* shader);

    ShaderDirectory m_directory;
    std::optional<Studio> m_studio;
};

void ReliefTest::initTestCase() {
    SKIP_WITHOUT_OPENGL();
    QImage map(kSide, kSide, QImage::Format_Grayscale8);
    for (int y = 0; y < kSide; ++y)
        for (int x = 0; x < kSide; ++x) {
            const int level =
                int(std::lround(255 * height((float(x) + 0.5F) / kSide, (float(y) + 0.5F) / kSide)));
            map.setPixel(x, y, qRgb(level, level, level));
        }
    for (const char* name : {"texture_2.png", "texture_3.png"})
        QVERIFY(map.save(m_directory.path(QLatin1String(name))));

    const QByteArray mover = contentOf(kShaders + QStringLiteral("/Displacement.vert"));
    QVERIFY(mover.contains("v_base"));
    const auto write = [&](const char* name, const char* output, bool moves) {
        const QString file = QLatin1String(name);
        QByteArray text = fragment(output);
        if (!moves)
            text.replace("in vec4 v_base; ", "");
        return m_directory.write(file + QStringLiteral(".frag"), text) &&
               (!moves || m_directory.write(file + QStringLiteral(".vert"), mover));
    };
    QVERIFY(write("Where", "vec3(v_uv, 0.0)", false));
    QVERIFY(write("Bumped",
                  "0.5 + 0.5 * relief_normal(n, v_position.xyz, v_uv, u_texture_2, u_height_scaling)",
                  false));
    QVERIFY(write("MovedWhere", "vec3(v_uv, 0.0)", true));
    QVERIFY(write("Moved",
                  "0.5 + 0.5 * relief_normal(n, v_base.xyz, v_uv, u_texture_3, u_depth * u_height_scaling)",
                  true));
    QVERIFY(write("MovedBy", "vec3(v_uv, dot(v_position.xyz - v_base.xyz, n) / (u_depth * u_height_scaling))",
                  true));
    QVERIFY(write("MovedTo", "vec3(v_uv, (v_position.y - 0.5) / (u_depth * u_height_scaling))", true));
}

void ReliefTest::init() {
    QVERIFY(m_studio.emplace().isGood());
    m_studio->renderer.setShaderDirectory(m_directory.path());
    m_studio->renderer.setTextureDirectory(m_directory.path());
}

RenderFrame ReliefTest::frameOf(const QString& surface, int resolution) const {
    RenderFrame frame = emptyFrame();
    frame.surface.meshResolution = resolution;
    frame.surface.heightScaling = kDepth;
    frame.surface.uniforms[frame.surface.shader][QStringLiteral("u_depth")] = number(1);
    if (surface == QLatin1String("ball"))
        frame.spheres = {{kCentre, 0.5F}};
    else
        frame.sheet = sheetOf(60, 60,
                              surface == QLatin1String("flat")        ? flat
                              : surface == QLatin1String("stretched") ? stretched
                                                                      : arched);
    return frame;
}

QImage ReliefTest::drawn(RenderFrame& frame, const char* shader) {
    // What was set is for whichever shader is drawn.
    const UniformSettings settings = frame.surface.uniforms.begin()->second;
    frame.surface.uniforms = {{QLatin1String(shader), settings}};
    frame.surface.shader = QLatin1String(shader);
    const QImage image = m_studio->draw(frame);
    return m_studio->faults().isEmpty() ? image : QImage();
}

// Two pictures of one place: which point of the surface a pixel shows, and the normal there. 8 bits of u and
// v, the map's 8 bits and its 64 texels make the tolerance; a wrong sign or scale is off by three times that.
void ReliefTest::compareNormals(const QString& name, int resolution, bool moved) {
    const Surface surface = name == QLatin1String("flat")        ? Surface(flat)
                            : name == QLatin1String("stretched") ? Surface(stretched)
                            : name == QLatin1String("arched")    ? Surface(arched)
                                                                 : Surface(ball);
    RenderFrame frame = frameOf(name, resolution);
    const QImage where = drawn(frame, moved ? "MovedWhere" : "Where");
    const QImage normals = drawn(frame, moved ? "Moved" : "Bumped");
    QVERIFY2(!where.isNull() && !normals.isNull(), qPrintable(m_studio->faults()));
    int compared = 0;
    double sum = 0;
    for (int y = 0; y < kSize.height(); ++y) {
        for (int x = 0; x < kSize.width(); ++x) {
            const QVector3D uv = toVector(where.pixel(x, y));
            const QVector3D n = normalOf(surface, uv.x(), uv.y());
            const QVector3D away = surface(uv.x(), uv.y()) - frame.cameraPosition;
            // The background, borders, poles and what is seen edge on.
            if (where.pixel(x, y) == frame.background.rgb() || uv.x() < 0.04F || uv.x() > 0.96F ||
                uv.y() < 0.12F || uv.y() > 0.88F || -QVector3D::dotProduct(n, away.normalized()) < 0.4F)
                continue;
            const QVector3D expected = normalOf(displaced(surface), uv.x(), uv.y());
            const QVector3D seenNormal = 2 * toVector(normals.pixel(x, y)) - QVector3D(1, 1, 1);
            const float off = (seenNormal - expected).length();
            QVERIFY2(off < 0.12F,
                     seen(normals, {x, y}, toColor(0.5F * expected + QVector3D(0.5F, 0.5F, 0.5F))));
            sum += double(off);
            ++compared;
        }
    }
    QVERIFY2(compared > 2000, qPrintable(QString::number(compared)));
    QVERIFY2(sum / compared < 0.03, qPrintable(QString::number(sum / compared)));
}

void ReliefTest::bumpNormals_data() {
    QTest::addColumn<QString>("surface");
    for (const char* name : {"flat", "stretched", "arched", "ball"})
        QTest::newRow(name) << QString::fromLatin1(name);
}

void ReliefTest::bumpNormals() {
    QFETCH(QString, surface);
    compareNormals(surface, surface == QLatin1String("ball") ? 128 : 0, false);
}

void ReliefTest::displacedPoints_data() {
    QTest::addColumn<QString>("surface");
    QTest::addColumn<int>("resolution");
    for (const char* name : {"flat", "arched", "ball"})
        for (const int resolution : {16, 128})
            QTest::addRow("%s %d", name, resolution) << QString::fromLatin1(name) << resolution;
}

// The height at (u, v) of a mesh of so many cells a side, straight between its points. Cells of sheets are
// cut from (x + 1, y) to (x, y + 1), of spheres from (x, y) to (x + 1, y + 1).
float meshHeight(float u, float v, int cells, bool sphere) {
    const float x = std::min(std::floor(u * float(cells)), float(cells - 1));
    const float y = std::min(std::floor(v * float(cells)), float(cells - 1));
    const float s = u * float(cells) - x;
    const float t = v * float(cells) - y;
    const auto at = [&](int i, int j) {
        return height((x + float(i)) / float(cells), (y + float(j)) / float(cells));
    };
    if (sphere)
        return s > t ? at(0, 0) + s * (at(1, 0) - at(0, 0)) + t * (at(1, 1) - at(1, 0))
                     : at(0, 0) + t * (at(0, 1) - at(0, 0)) + s * (at(1, 1) - at(0, 1));
    return s + t < 1 ? at(0, 0) + s * (at(1, 0) - at(0, 0)) + t * (at(0, 1) - at(0, 0))
                     : at(1, 1) + (1 - s) * (at(0, 1) - at(1, 1)) + (1 - t) * (at(1, 0) - at(1, 1));
}

void ReliefTest::displacedPoints() {
    QFETCH(QString, surface);
    QFETCH(int, resolution);
    RenderFrame frame = frameOf(surface, resolution);
    const bool isFlat = surface == QLatin1String("flat");
    const QImage image = drawn(frame, isFlat ? "MovedTo" : "MovedBy");
    QVERIFY2(!image.isNull(), qPrintable(m_studio->faults()));
    int compared = 0;
    for (int y = 0; y < kSize.height(); ++y)
        for (int x = 0; x < kSize.width(); ++x) {
            const QVector3D shown = toVector(image.pixel(x, y));
            const bool onBorder = std::min({shown.x(), shown.y(), 1 - shown.x(), 1 - shown.y()}) < 0.02F;
            if (image.pixel(x, y) == frame.background.rgb() || onBorder)
                continue;
            const float expected =
                meshHeight(shown.x(), shown.y(), resolution, surface == QLatin1String("ball"));
            QVERIFY2(std::abs(shown.z() - expected) < 0.05F,
                     qPrintable(QStringLiteral("%1 instead of %2 at %3, %4")
                                    .arg(shown.z())
                                    .arg(expected)
                                    .arg(shown.x())
                                    .arg(shown.y())));
            ++compared;
        }
    QVERIFY(compared > 5000);
}

// The silhouette of a displaced sphere: its farthest points stand out by as much as the map says.
void ReliefTest::displacedSphereAtItsVertices() {
    for (const int resolution : {16, 128}) {
        RenderFrame frame = frameOf(QStringLiteral("ball"), resolution);
        QMatrix4x4 view; // 200 pixels a metre, looking down: the equator is the edge, but for what stands out
        view.ortho(-0.8F, 0.8F, -0.6F, 0.6F, -5, 5);
        view.lookAt(kCentre + QVector3D(0, 2, 0), kCentre, QVector3D(0, 0, -1));
        frame.viewProjection = view;
        const QImage image = drawn(frame, "MovedWhere");
        QVERIFY2(!image.isNull(), qPrintable(m_studio->faults()));
        for (int i = 0; i < 16; ++i) {
            const float u = float(i) / 16;
            float reach = 0; // the greatest distance from the axis at this longitude
            for (int ring = 0; ring <= resolution; ++ring) {
                const float v = float(ring) / float(resolution);
                reach = std::max(reach, (0.46F + kDepth * height(u, v)) * std::sin(kPi * v));
            }
            const QVector3D outward(std::cos(2 * kPi * u), 0, -std::sin(2 * kPi * u));
            const auto isSheet = [&](float metres) {
                return image.pixel(toPixel(frame, kCentre + metres * outward)) != frame.background.rgb();
            };
            QVERIFY2(isSheet(reach - 0.012F), qPrintable(QString::number(u)));
            QVERIFY2(!isSheet(reach + 0.012F), qPrintable(QString::number(u)));
        }
    }
}

void ReliefTest::displacedNormals_data() {
    bumpNormals_data();
}

void ReliefTest::displacedNormals() {
    QFETCH(QString, surface);
    compareNormals(surface, 128, true);
}

// The shaders of the program take the scalings as they say: all that make one product make one picture.
void ReliefTest::scalingsMultiply() {
    m_studio->renderer.setShaderDirectory(kShaders);
    RenderFrame frame = frameOf(QStringLiteral("flat"), 64);
    const auto picture = [&](const char* shader, float normal, float heightScaling, float relief,
                             float depth) {
        frame.surface.normalScaling = normal;
        frame.surface.heightScaling = heightScaling;
        frame.surface.uniforms.begin()->second = {{QStringLiteral("u_relief"), number(relief)},
                                                  {QStringLiteral("u_depth"), number(depth)}};
        return drawn(frame, shader);
    };
    QVERIFY(!picture("Bump", 2, 0.1F, 0.5F, 1).isNull());
    QCOMPARE(picture("Bump", 2, 0.125F, 0.5F, 1), picture("Bump", 1, 0.5F, 0.25F, 1));
    QVERIFY(picture("Bump", 2, 0.125F, 0.5F, 1) != picture("Bump", 2, 0.25F, 0.5F, 1));
    QCOMPARE(picture("Displacement", 2, 0.125F, 0.5F, 1), picture("Displacement", 1, 0.25F, 1, 0.5F));
    QVERIFY(picture("Displacement", 2, 0.125F, 0.5F, 1) != picture("Displacement", 1, 0.125F, 0.5F, 1));
    QVERIFY(picture("Displacement", 2, 0.125F, 0.5F, 1) != picture("Displacement", 2, 0.25F, 0.25F, 1));
}

int main(int argc, char** argv) {
    return runOnDisplay<ReliefTest>(argc, argv);
}
#include "tst_relief.moc"
