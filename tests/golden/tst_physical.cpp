// Light from all around, and the physical shader in a white furnace: what it sends out it has been given.
#include "app/render/image_file.h"
#include "app/render/irradiance.h"
#include "tests/golden/canvas.h"

#include <numbers>
#include <optional>

using namespace clothlab::render;

namespace {

constexpr std::array<const char*, kCubeFaces> kFaces{"posx", "negx", "posy", "negy", "posz", "negz"};

float encoded(float light) {
    return light <= 0.0031308F ? 12.92F * light : 1.055F * std::pow(light, 1 / 2.4F) - 0.055F;
}

// A bowl upside down, seen from aside: each angle to the viewer up to edge on.
SheetShape dome() {
    return sheetOf(60, 60, [](float u, float v) {
        const QVector3D out(2 * u - 1, 0.7F, 2 * v - 1);
        return QVector3D(0.5F, 0.2F, 0.5F) + 0.5F * out.normalized();
    });
}

} // namespace

class PhysicalTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init();
    void cleanup() { m_studio.reset(); }

    void irradianceComesToTheShader();
    void roughFurnace_data();
    void roughFurnace();
    void noFurnaceGivesMoreThanItGets_data();
    void noFurnaceGivesMoreThanItGets();
    void matInTheLamp();
    void mapIsDecodedFromSrgb();

private:
    RenderFrame furnace(float albedo, float roughness, float metallic) const;
    int shown(float light);
    bool writeCube(const char* folder, const std::array<QRgb, kCubeFaces>& colors) const;

    ShaderDirectory m_directory;
    std::optional<Studio> m_studio;
};

bool PhysicalTest::writeCube(const char* folder, const std::array<QRgb, kCubeFaces>& colors) const {
    const QString path = m_directory.path(QLatin1String(folder));
    bool good = QDir().mkpath(path);
    for (std::size_t i = 0; i < kCubeFaces; ++i) {
        QImage image(32, 32, QImage::Format_RGB888);
        image.fill(colors[i]);
        good = good && image.save(path + u'/' + QLatin1String(kFaces[i]) + QStringLiteral(".png"));
    }
    return good;
}

void PhysicalTest::initTestCase() {
    SKIP_WITHOUT_OPENGL();
    std::array<QRgb, kCubeFaces> white{};
    white.fill(0xFFFFFFFF);
    QVERIFY(writeCube("white", white));
    QVERIFY(writeCube("gaudy", {0xFFFF2010, 0xFF20FF40, 0xFF4060FF, 0xFF202020, 0xFFF0F020, 0xFF8000A0}));
    QFile shader(kShaders + QStringLiteral("/Physical.frag"));
    QVERIFY(shader.open(QIODevice::ReadOnly));
    QVERIFY(m_directory.write(QStringLiteral("Physical.frag"), shader.readAll()));
    QVERIFY(m_directory.write(QStringLiteral("Shown.frag"),
                              "#version 330\n#include \"light.glsl\"\nuniform float u_value;\n"
                              "out vec4 out_color;\n"
                              "void main() { out_color = vec4(soft_shoulder(vec3(u_value)), 1.0); }\n"));
    QVERIFY(m_directory.write(
        QStringLiteral("Around.frag"),
        "#version 330\nuniform vec3 u_irradiance[9]; in vec4 v_normal; out vec4 out_color;\n"
        "void main() { vec3 n = normalize(v_normal.xyz); vec3 c[9] = u_irradiance;\n"
        "  out_color = vec4(c[0] + c[1] * n.y + c[2] * n.z + c[3] * n.x + c[4] * n.x * n.y + c[5] * n.y * "
        "n.z\n"
        "    + c[6] * (3.0 * n.z * n.z - 1.0) + c[7] * n.x * n.z + c[8] * (n.x * n.x - n.y * n.y), 1.0); "
        "}\n"));
}

void PhysicalTest::init() {
    QVERIFY(m_studio.emplace().isGood());
    m_studio->renderer.setShaderDirectory(m_directory.path());
}

RenderFrame PhysicalTest::furnace(float albedo, float roughness, float metallic) const {
    RenderFrame frame = emptyFrame();
    frame.sheet = dome();
    lookFrom(frame, QVector3D(0.5F, 0.9F, 2.2F));
    frame.surface.shader = QStringLiteral("Physical");
    frame.surface.cubemap = m_directory.path(QStringLiteral("white"));
    const float value = encoded(albedo);
    frame.surface.color = QVector4D(value, value, value, 1);
    frame.surface.uniforms[frame.surface.shader] = {{QStringLiteral("u_roughness"), number(roughness)},
                                                    {QStringLiteral("u_metallic"), number(metallic)},
                                                    {QStringLiteral("u_use_map"), number(0)},
                                                    {QStringLiteral("u_lamp"), number(0)},
                                                    {QStringLiteral("u_surroundings"), number(1)}};
    return frame;
}

// The grey in which the shader shows so much light, 0 … 255.
int PhysicalTest::shown(float light) {
    RenderFrame frame = flatFrame(4);
    frame.surface.shader = QStringLiteral("Shown");
    frame.surface.uniforms[frame.surface.shader] = {{QStringLiteral("u_value"), number(encoded(light))}};
    return qRed(m_studio->draw(frame).pixel(kSize.width() / 2, kSize.height() / 2));
}

void PhysicalTest::irradianceComesToTheShader() {
    CubeImages faces;
    for (std::size_t i = 0; i < kCubeFaces; ++i) {
        QString reason;
        const QString file = QStringLiteral("gaudy/%1.png").arg(QLatin1String(kFaces[i]));
        faces[i] = readImage(m_directory.path(file), reason).value_or(Image());
        QVERIFY2(reason.isEmpty(), qPrintable(reason));
    }
    const Irradiance c = irradianceOf(faces);
    RenderFrame frame = emptyFrame();
    frame.surface.shader = QStringLiteral("Around");
    frame.surface.cubemap = m_directory.path(QStringLiteral("gaudy"));
    for (const QVector3D n : {QVector3D(0, 1, 0), QVector3D(0.6F, 0.8F, 0), QVector3D(-0.48F, 0.64F, 0.6F)}) {
        const QVector3D across = QVector3D::crossProduct(n, QVector3D(0, 0, 1)).normalized();
        const QVector3D down = QVector3D::crossProduct(across, n);
        frame.sheet = sheetOf(4, 4, [&](float u, float v) {
            return QVector3D(0.5F, 0.5F, 0.5F) + (u - 0.5F) * across + (v - 0.5F) * down;
        });
        lookFrom(frame, QVector3D(0.51F, 0.5F, 0.52F) + 2 * n);
        const float x = n.x();
        const float y = n.y();
        const float z = n.z();
        const QVector3D light = c[0] + c[1] * y + c[2] * z + c[3] * x + c[4] * (x * y) + c[5] * (y * z) +
                                c[6] * (3 * z * z - 1) + c[7] * (x * z) + c[8] * (x * x - y * y);
        const QPoint middle(kSize.width() / 2, kSize.height() / 2);
        const QImage image = m_studio->draw(frame);
        QVERIFY2(isNear(image.pixel(middle), toColor(light), 2), seen(image, middle, toColor(light)));
    }
}

void PhysicalTest::roughFurnace_data() {
    QTest::addColumn<float>("albedo");
    for (const float albedo : {0.05F, 0.2F, 0.5F, 0.8F, 1.0F})
        QTest::addRow("%g", double(albedo)) << albedo;
}

// A rough dielectric sends back its albedo of the white all around, and up to 0.05 that it reflects besides.
void PhysicalTest::roughFurnace() {
    QFETCH(float, albedo);
    const RenderFrame frame = furnace(albedo, 1, 0);
    const QImage image = m_studio->draw(frame);
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
    const int least = shown(albedo - 0.05F * albedo) - 1;
    const int most = shown(std::min(albedo + 0.05F, 1.0F)) + 1;
    int compared = 0;
    for (int y = 0; y < kSize.height(); y += 2)
        for (int x = 0; x < kSize.width(); x += 2) {
            if (image.pixel(x, y) == frame.background.rgb())
                continue;
            const int value = qRed(image.pixel(x, y));
            QVERIFY2(value >= least && value <= most, qPrintable(QStringLiteral("%1, not %2 to %3, at %4,%5")
                                                                     .arg(value)
                                                                     .arg(least)
                                                                     .arg(most)
                                                                     .arg(x)
                                                                     .arg(y)));
            ++compared;
        }
    QVERIFY(compared > 1000);
}

void PhysicalTest::noFurnaceGivesMoreThanItGets_data() {
    QTest::addColumn<float>("albedo");
    QTest::addColumn<float>("roughness");
    QTest::addColumn<float>("metallic");
    for (const float albedo : {0.5F, 1.0F})
        for (const float roughness : {0.04F, 0.3F, 0.6F, 1.0F})
            for (const float metallic : {0.0F, 0.5F, 1.0F})
                QTest::addRow("%g, %g, %g", double(albedo), double(roughness), double(metallic))
                    << albedo << roughness << metallic;
}

void PhysicalTest::noFurnaceGivesMoreThanItGets() {
    QFETCH(float, albedo);
    QFETCH(float, roughness);
    QFETCH(float, metallic);
    const RenderFrame frame = furnace(albedo, roughness, metallic);
    const QImage image = m_studio->draw(frame);
    const int most = shown(1) + 1;
    int brightest = 0;
    for (int y = 0; y < kSize.height(); ++y)
        for (int x = 0; x < kSize.width(); ++x)
            brightest = std::max(brightest, qRed(image.pixel(x, y)));
    QVERIFY2(brightest <= most, qPrintable(QStringLiteral("%1 of %2").arg(brightest).arg(most)));
    QVERIFY(brightest > shown(0.2F));
}

// A rough sheet under the lamp, with nothing around: Lambert's law times the albedo, and a little highlight.
void PhysicalTest::matInTheLamp() {
    RenderFrame frame = furnace(0.5F, 1, 0);
    frame.sheet = flatFrame(10).sheet;
    lookFrom(frame, QVector3D(0.5F, 2, 1.2F));
    frame.light.intensity = QVector3D(2, 2, 2);
    frame.surface.uniforms[frame.surface.shader][QStringLiteral("u_lamp")] = number(1);
    frame.surface.uniforms[frame.surface.shader][QStringLiteral("u_surroundings")] = number(0);
    const QImage image = m_studio->draw(frame);
    std::vector<std::pair<QPoint, float>> places;
    for (int i = 1; i < 10; ++i) {
        const QPoint pixel = toPixel(frame, QVector3D(0.1F * float(i), 0.5F, 0.1F * float(i * 7 % 10)));
        const QVector3D toLamp = frame.light.position - toPlane(frame, pixel, 0.5F);
        places.emplace_back(pixel, 2 * toLamp.normalized().y() / toLamp.lengthSquared());
    }
    for (const auto& [pixel, arriving] : places) {
        const int value = qRed(image.pixel(pixel));
        const int least = shown(0.94F * 0.5F * arriving) - 1;
        const int most = shown((0.5F + 0.06F) * arriving) + 1;
        QVERIFY2(value >= least && value <= most,
                 qPrintable(QStringLiteral("%1, not %2 to %3").arg(value).arg(least).arg(most)));
    }
}

// The base map is a picture for the eye: its middle grey is a fifth of the light.
void PhysicalTest::mapIsDecodedFromSrgb() {
    QImage grey(8, 8, QImage::Format_RGB888);
    grey.fill(QColor(128, 128, 128));
    QVERIFY(grey.save(m_directory.path(QStringLiteral("grey.png"))));
    RenderFrame mapped = furnace(1, 1, 0);
    mapped.surface.uniforms[mapped.surface.shader][QStringLiteral("u_use_map")] = number(1);
    mapped.surface.uniforms[mapped.surface.shader][QStringLiteral("u_base_map")] = {
        0, {}, m_directory.path(QStringLiteral("grey.png"))};
    const QImage withMap = m_studio->draw(mapped);
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
    const QImage withColor = m_studio->draw(furnace(0.2158605F, 1, 0));
    const QPoint middle = toPixel(mapped, QVector3D(0.5F, 0.69F, 0.5F));
    QVERIFY2(isNear(withMap.pixel(middle), withColor.pixel(middle), 2),
             seen(withMap, middle, withColor.pixel(middle)));
}

int main(int argc, char** argv) {
    return runOnDisplay<PhysicalTest>(argc, argv);
}
#include "tst_physical.moc"
