// Light from all around, against sums over many directions.
#include "app/render/irradiance.h"

#include <QTest>

#include <cmath>
#include <numbers>
#include <random>

using namespace clothlab::render;

namespace {

float decoded(float encoded) {
    return encoded <= 0.04045F ? encoded / 12.92F : std::pow((encoded + 0.055F) / 1.055F, 2.4F);
}

std::uint8_t encoded(float light) {
    const float value = light <= 0.0031308F ? 12.92F * light : 1.055F * std::pow(light, 1 / 2.4F) - 0.055F;
    return static_cast<std::uint8_t>(std::lround(255 * std::clamp(value, 0.0F, 1.0F)));
}

// Faces of `side` texels that show `light`, a function of the unit direction.
template <typename Light>
CubeImages cubeOf(int side, Light light) {
    CubeImages faces;
    for (std::size_t face = 0; face < faces.size(); ++face) {
        faces[face] = {side, side, {}};
        for (int row = 0; row < side; ++row)
            for (int column = 0; column < side; ++column) {
                const float s = 2 * (float(column) + 0.5F) / float(side) - 1;
                const float t = 2 * (float(row) + 0.5F) / float(side) - 1;
                const QVector3D colour = light(cubeDirection(face, s, t).normalized());
                for (const float channel : {colour.x(), colour.y(), colour.z(), 1.0F})
                    faces[face].rgba.push_back(encoded(channel));
            }
    }
    return faces;
}

// As the header says it.
QVector3D evaluated(const Irradiance& c, const QVector3D& n) {
    const float x = n.x();
    const float y = n.y();
    const float z = n.z();
    return c[0] + c[1] * y + c[2] * z + c[3] * x + c[4] * (x * y) + c[5] * (y * z) + c[6] * (3 * z * z - 1) +
           c[7] * (x * z) + c[8] * (x * x - y * y);
}

// Directions all around at equal solid angles: a spiral of Fibonacci's.
QVector3D direction(int i, int count) {
    const float y = 1 - 2 * (float(i) + 0.5F) / float(count);
    const float turn = 2 * std::numbers::pi_v<float> * std::fmod(float(i) * 0.618034F, 1.0F);
    const float ring = std::sqrt(1 - y * y);
    return {ring * std::cos(turn), y, ring * std::sin(turn)};
}

// The integral of light times cosine over the half sphere, over pi.
template <typename Light>
QVector3D integrated(const QVector3D& n, Light light) {
    constexpr int kCount = 20000;
    QVector3D sum;
    for (int i = 0; i < kCount; ++i) {
        const QVector3D from = direction(i, kCount);
        if (const float cosine = QVector3D::dotProduct(from, n); cosine > 0)
            sum += 4 * cosine / kCount * light(from);
    }
    return sum;
}

template <typename Light>
float worst(Light light) {
    const Irradiance coefficients = irradianceOf(cubeOf(32, light));
    float far = 0;
    for (int i = 0; i < 40; ++i) {
        const QVector3D n = direction(i, 40);
        const QVector3D difference = evaluated(coefficients, n) - integrated(n, light);
        for (int c = 0; c < 3; ++c)
            far = std::max(far, std::abs(difference[c]));
    }
    return far;
}

} // namespace

class IrradianceTest : public QObject {
    Q_OBJECT

private slots:
    void directionsAreOpenGls();
    void constantLightIsItself();
    void linearLightIsExact();
    void eachHarmonicIsInItsPlace();
    void aSkyIsCloseEnough();
    void texelsAreDecoded();
    void facesOfOddSizes();
};

// Table 3.19 of OpenGL 3.3: the major axis gives s = (sc / |ma| + 1) / 2 and t = (tc / |ma| + 1) / 2.
void IrradianceTest::directionsAreOpenGls() {
    std::mt19937 random(7);
    std::uniform_real_distribution<float> part(-0.99F, 0.99F);
    for (int i = 0; i < 600; ++i) {
        const auto face = static_cast<std::size_t>(i % 6);
        const float s = part(random);
        const float t = part(random);
        const QVector3D r = cubeDirection(face, s, t);
        const std::array<std::array<float, 3>, 6> sideways{{{-r.z(), -r.y(), r.x()},
                                                            {r.z(), -r.y(), -r.x()},
                                                            {r.x(), r.z(), r.y()},
                                                            {r.x(), -r.z(), -r.y()},
                                                            {r.x(), -r.y(), r.z()},
                                                            {-r.x(), -r.y(), -r.z()}}};
        const auto [sc, tc, major] = sideways[face];
        QVERIFY(major > 0.999F && major >= std::abs(sc) && major >= std::abs(tc));
        QVERIFY(std::abs(sc / major - s) < 1e-6F);
        QVERIFY(std::abs(tc / major - t) < 1e-6F);
    }
}

void IrradianceTest::constantLightIsItself() {
    const auto white = [](const QVector3D&) { return QVector3D(1, 1, 1); };
    const Irradiance coefficients = irradianceOf(cubeOf(8, white));
    for (int i = 0; i < 100; ++i)
        QVERIFY((evaluated(coefficients, direction(i, 100)) - QVector3D(1, 1, 1)).length() < 1e-4F);
}

void IrradianceTest::linearLightIsExact() {
    const auto linear = [](const QVector3D& d) {
        return QVector3D(0.5F + 0.4F * d.x(), 0.5F - 0.3F * d.y() + 0.1F * d.z(), 0.3F + 0.2F * d.z());
    };
    QVERIFY(worst(linear) < 0.004F);
}

// Light that is one harmonic of the second band alone, which keeps its form.
void IrradianceTest::eachHarmonicIsInItsPlace() {
    const auto product = [](const QVector3D& d) {
        return QVector3D(0.5F + 0.6F * d.x() * d.y(), 0.5F + 0.6F * d.y() * d.z(),
                         0.5F + 0.6F * d.x() * d.z());
    };
    QVERIFY(worst(product) < 0.004F);
    const auto square = [](const QVector3D& d) {
        return QVector3D(0.5F + 0.2F * (3 * d.z() * d.z() - 1), 0.5F + 0.4F * (d.x() * d.x() - d.y() * d.y()),
                         0.5F);
    };
    QVERIFY(worst(square) < 0.004F);
}

// "Within a few percent": a sharp horizon is the hardest that is usual.
void IrradianceTest::aSkyIsCloseEnough() {
    const auto sky = [](const QVector3D& d) {
        return d.y() > 0 ? QVector3D(0.9F, 0.95F, 1) : QVector3D(0.1F, 0.08F, 0.05F);
    };
    QVERIFY(worst(sky) < 0.04F);
}

void IrradianceTest::texelsAreDecoded() {
    CubeImages faces = cubeOf(4, [](const QVector3D&) { return QVector3D(); });
    for (Image& face : faces)
        for (std::size_t i = 0; i < face.rgba.size(); i += 4)
            face.rgba[i] = 128;
    const QVector3D grey = evaluated(irradianceOf(faces), QVector3D(0, 0, 1));
    QVERIFY(std::abs(grey.x() - decoded(128.0F / 255)) < 1e-4F);
    QVERIFY(std::abs(grey.y()) < 1e-6F);
}

void IrradianceTest::facesOfOddSizes() {
    const auto white = [](const QVector3D&) { return QVector3D(1, 1, 1); };
    CubeImages faces = cubeOf(1, white);
    QVERIFY((evaluated(irradianceOf(faces), QVector3D(1, 0, 0)) - QVector3D(1, 1, 1)).length() < 0.01F);
    faces[2] = cubeOf(16, white)[2];
    const Irradiance mixed = irradianceOf(faces);
    QVERIFY(std::isfinite(mixed[0].x()) && std::abs(mixed[0].x() - 1) < 0.1F);
    QCOMPARE(irradianceOf(CubeImages{}), Irradiance{}); // no texels at all
}

QTEST_APPLESS_MAIN(IrradianceTest)
#include "tst_irradiance.moc"
