// A mirror shows the side of the cube map that the law of reflection says.
#include "app/render/irradiance.h"
#include "tests/golden/canvas.h"

#include <optional>
#include <set>

using namespace clothlab::render;

namespace {

constexpr std::array<const char*, kCubeFaces> kFaces{"posx", "negx", "posy", "negy", "posz", "negz"};
constexpr std::array<QRgb, kCubeFaces> kColors{0xFFFF0000, 0xFF00FF00, 0xFF0000FF,
                                               0xFFFFFF00, 0xFFFF00FF, 0xFF00FFFF};

// Empty near an edge of the cube, where filters mix its sides.
std::optional<QRgb> colorAlong(const QVector3D& d) {
    const std::array<float, kCubeFaces> parts{d.x(), -d.x(), d.y(), -d.y(), d.z(), -d.z()};
    std::array<float, kCubeFaces> sorted = parts;
    std::sort(sorted.begin(), sorted.end());
    if (sorted[4] > 0.9F * sorted[5])
        return std::nullopt;
    return kColors[std::size_t(std::max_element(parts.begin(), parts.end()) - parts.begin())];
}

QVector3D reflected(const QVector3D& d, const QVector3D& n) {
    return d - 2 * QVector3D::dotProduct(d, n) * n;
}

} // namespace

class MirrorTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase();
    void init() { QVERIFY(m_studio.emplace().isGood()); }
    void cleanup() { m_studio.reset(); }

    void sheetFacingEachWay_data();
    void sheetFacingEachWay();
    void sphere();
    void sidesAreTheRightWayUp();
    void brokenCubeMaps_data();
    void brokenCubeMaps();

private:
    QString path(const QString& name) const { return m_directory.filePath(name); }
    bool writeCube(const QString& folder, int side = 64) const;

    QTemporaryDir m_directory;
    std::optional<Studio> m_studio;
};

void MirrorTest::initTestCase() {
    SKIP_WITHOUT_OPENGL();
    QVERIFY(writeCube(QStringLiteral("cubemap")));
}

bool MirrorTest::writeCube(const QString& folder, int side) const {
    bool good = QDir(m_directory.path()).mkpath(folder);
    for (std::size_t i = 0; i < kCubeFaces; ++i) {
        QImage image(side, side, QImage::Format_RGB888);
        image.fill(kColors[i]);
        good = good && image.save(path(folder) + u'/' + QLatin1String(kFaces[i]) + QStringLiteral(".png"));
    }
    return good;
}

void MirrorTest::sheetFacingEachWay_data() {
    QTest::addColumn<QVector3D>("normal");
    QTest::addColumn<bool>("behind");
    for (int axis = 0; axis < 3; ++axis)
        for (const int sign : {1, -1})
            for (const bool behind : {false, true}) {
                QVector3D normal;
                normal[axis] = float(sign);
                QTest::addRow("%c%c%s", sign > 0 ? '+' : '-', 'x' + axis, behind ? " from behind" : "")
                    << normal << behind;
            }
}

void MirrorTest::sheetFacingEachWay() {
    QFETCH(QVector3D, normal);
    QFETCH(bool, behind);
    const QVector3D centre(0.5F, 0.5F, 0.5F);
    const QVector3D across(normal.z(), normal.x(), normal.y());
    const QVector3D down = QVector3D::crossProduct(across, normal); // down x across is the normal
    m_studio->renderer.setTextureDirectory(m_directory.path());
    RenderFrame frame = emptyFrame();
    frame.surface.shader = QStringLiteral("Mirror");
    frame.sheet = sheetOf(
        4, 4, [&](float u, float v) { return centre + 2 * (u - 0.5F) * across + 2 * (v - 0.5F) * down; });
    std::set<QRgb> shown;
    for (const float lean : {0.3F, -0.3F, 0.9F, -0.9F}) {
        lookFrom(frame, centre + (behind ? -1.0F : 1.0F) * normal + lean * across + 0.4F * lean * down +
                            QVector3D(0.01F, 0.01F, 0.01F));
        const QImage image = m_studio->draw(frame);
        QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
        for (int y = 5; y < kSize.height(); y += 10)
            for (int x = 5; x < kSize.width(); x += 10) {
                const Ray ray = rayThrough(frame, {x, y});
                const QVector3D place = ray.meets(centre, normal) - centre;
                const auto expected = colorAlong(reflected(ray.along, normal));
                if (!expected || std::abs(QVector3D::dotProduct(place, across)) > 0.97F ||
                    std::abs(QVector3D::dotProduct(place, down)) > 0.97F ||
                    QVector3D::dotProduct(place + centre - ray.from, ray.along) < 0)
                    continue;
                shown.insert(*expected);
                QVERIFY2(isNear(image.pixel(x, y), *expected, 2), seen(image, {x, y}, *expected));
            }
    }
    QVERIFY(shown.size() >= 3);
}

void MirrorTest::sphere() {
    m_studio->renderer.setTextureDirectory(m_directory.path());
    RenderFrame frame = emptyFrame();
    frame.surface.shader = QStringLiteral("Mirror");
    frame.surface.meshResolution = 200;
    const QVector3D centre(0.5F, 0.5F, 0.5F);
    const float radius = 0.92F * 0.5F;
    frame.spheres = {{centre, 0.5F}};
    std::set<QRgb> shown;
    for (const QVector3D camera : {QVector3D(0.6F, 0.7F, 2.4F), QVector3D(-1.5F, 0.3F, 0.2F)}) {
        lookFrom(frame, camera);
        const QImage image = m_studio->draw(frame);
        for (int y = 0; y < kSize.height(); y += 4)
            for (int x = 0; x < kSize.width(); x += 4) {
                const Ray ray = rayThrough(frame, {x, y});
                const QVector3D to = ray.from - centre;
                const float b = QVector3D::dotProduct(to, ray.along);
                const float under = b * b - to.lengthSquared() + radius * radius;
                if (under < 0.2F * radius * radius)
                    continue; // beside it, or near its edge
                const QVector3D n = (to + (-b - std::sqrt(under)) * ray.along).normalized();
                const auto expected = colorAlong(reflected(ray.along, n));
                if (!expected)
                    continue;
                shown.insert(*expected);
                QVERIFY2(isNear(image.pixel(x, y), *expected, 2), seen(image, {x, y}, *expected));
            }
    }
    QVERIFY(shown.size() >= 5);
}

// One red texel's place in posz.png, as in a photograph taken along +z by someone whose right is +x: OpenGL's
// cube maps are seen from inside and mirrored.
void MirrorTest::sidesAreTheRightWayUp() {
    QVERIFY(writeCube(QStringLiteral("marked")));
    QImage image(64, 64, QImage::Format_RGB888);
    image.fill(Qt::black);
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x)
            image.setPixel(x, y, qRgb(255, 0, 0)); // the upper left corner
    QVERIFY(image.save(path(QStringLiteral("marked/posz.png"))));
    RenderFrame frame = emptyFrame();
    frame.surface.shader = QStringLiteral("Mirror");
    frame.surface.cubemap = path(QStringLiteral("marked"));
    // A wall that is looked at along -z, and throws the looks back along +z.
    frame.sheet = sheetOf(4, 4, [](float u, float v) { return QVector3D(3 * u - 1, 2 - 3 * v, 0.5F); });
    lookFrom(frame, QVector3D(0.5F, 0.5F, 1.2F));
    const QImage picture = m_studio->draw(frame);
    for (int y = 5; y < kSize.height(); y += 10)
        for (int x = 5; x < kSize.width(); x += 10) {
            const QVector3D d = reflected(rayThrough(frame, {x, y}).along, QVector3D(0, 0, 1));
            const float s = (d.x() / d.z() + 1) / 2; // OpenGL 3.3, table 3.19
            const float t = (-d.y() / d.z() + 1) / 2;
            if (std::abs(s - 0.25F) < 0.05F || std::abs(t - 0.25F) < 0.05F || s < 0.05F || t < 0.05F)
                continue;
            const QRgb expected = s < 0.25F && t < 0.25F ? qRgb(255, 0, 0) : qRgb(0, 0, 0);
            QVERIFY2(isNear(picture.pixel(x, y), expected, 2), seen(picture, {x, y}, expected));
        }
}

void MirrorTest::brokenCubeMaps_data() {
    QTest::addColumn<QString>("folder");
    QTest::addColumn<QString>("file");
    QTest::newRow("no folder") << QStringLiteral("nowhere") << QStringLiteral("posx.png");
    QTest::newRow("a side is missing") << QStringLiteral("five") << QStringLiteral("negy.png");
    QTest::newRow("not square") << QStringLiteral("oblong") << QStringLiteral("posz.png");
    QTest::newRow("of another size") << QStringLiteral("mixed") << QStringLiteral("negz.png");
    QTest::newRow("no picture") << QStringLiteral("text") << QStringLiteral("posy.png");
}

// What can't be read is said, and a checker is seen in its place.
void MirrorTest::brokenCubeMaps() {
    QFETCH(QString, folder);
    QFETCH(QString, file);
    if (folder != QLatin1String("nowhere"))
        QVERIFY(writeCube(folder));
    const QString broken = path(folder) + u'/' + file;
    if (folder == QLatin1String("five"))
        QVERIFY(QFile::remove(broken));
    if (folder == QLatin1String("oblong"))
        QVERIFY(QImage(64, 32, QImage::Format_RGB888).save(broken));
    if (folder == QLatin1String("mixed"))
        QVERIFY(QImage(32, 32, QImage::Format_RGB888).save(broken));
    if (folder == QLatin1String("text")) {
        QFile text(broken);
        QVERIFY(text.open(QIODevice::WriteOnly) && text.write("no picture") > 0);
    }
    RenderFrame frame = flatFrame(4);
    frame.surface.shader = QStringLiteral("Mirror");
    frame.surface.cubemap = path(folder);
    const QImage image = m_studio->draw(frame);
    QCOMPARE(m_studio->renderer.problems().size(), 1);
    QCOMPARE(m_studio->renderer.problems()[0].path, broken);
    QVERIFY(countPixels(image, QColor(220, 40, 220), 20) > 30);
    frame.surface.cubemap = path(QStringLiteral("cubemap"));
    m_studio->draw(frame);
    QVERIFY(m_studio->renderer.problems().isEmpty());
}

int main(int argc, char** argv) {
    return runOnDisplay<MirrorTest>(argc, argv);
}
#include "tst_mirror.moc"
