#include "tests/support/random_scene.h"

#include "simcore/scene/parameters.h"
#include "simcore/scene/range.h"

#include <array>
#include <cmath>

namespace clothlab::test {
namespace {

class SceneMaker {
public:
    explicit SceneMaker(std::uint32_t seed) : m_random(seed) {}

    Scene make() {
        Scene scene;
        for (const Parameter& parameter : parameters()) {
            if (chance(0.7))
                parameter.set(scene, within(rangeOf(parameter)));
        }
        limitPoints(scene.cloth);
        for (int i = below(6); i > 0; --i)
            scene.cloth.pinned.push_back(
                {below(scene.cloth.numWidthPoints), below(scene.cloth.numHeightPoints)});
        for (int i = below(4); i > 0; --i)
            scene.spheres.push_back({vector(kCoordinate), within(kLength), within(kShare), unknown()});
        for (int i = below(4); i > 0; --i)
            scene.planes.push_back({vector(kCoordinate), normal(), within(kShare), unknown()});
        scene.simulation.unknownKeys = unknown();
        scene.cloth.unknownKeys = unknown();
        scene.unknownKeys = unknown();
        decorate(scene);
        return scene;
    }

private:
    int below(int limit) { return std::uniform_int_distribution<int>(0, limit - 1)(m_random); }
    bool chance(double share) { return std::bernoulli_distribution(share)(m_random); }
    double uniform(double a, double b) { return std::uniform_real_distribution<double>(a, b)(m_random); }
    std::string unknown() { return chance(0.8) ? std::string() : randomObjectText(m_random, 3); }

    double within(const Range& range) {
        const double value = anyWithin(range);
        const double whole = range.whole ? std::floor(value) : value;
        return range.contains(whole) ? whole : range.maximum;
    }

    double anyWithin(const Range& range) {
        switch (below(5)) {
        case 0:
            return range.minimum;
        case 1:
            return range.maximum;
        case 2: // of every magnitude
            return (range.minimum < 0 && chance(0.5) ? -1 : 1) * std::pow(10.0, uniform(-12, 9));
        case 3:
            return std::nextafter(uniform(range.minimum, range.maximum), range.maximum);
        default:
            return std::round(uniform(range.minimum, range.maximum) * 8) / 8;
        }
    }

    Vec3 vector(const Range& range) {
        const double x = within(range);
        const double y = within(range);
        return {x, y, within(range)};
    }

    Vec3 normal() {
        const Vec3 n = vector({-1, 1});
        return n.squaredNorm() > 1e-20 ? n : Vec3(0, 0, -1);
    }

    static void limitPoints(Cloth& cloth) {
        while (std::int64_t(cloth.numWidthPoints) * cloth.numHeightPoints > kMaxPoints)
            (cloth.numWidthPoints > cloth.numHeightPoints ? cloth.numWidthPoints : cloth.numHeightPoints) /=
                2;
    }

    void decorate(Scene& scene) {
        constexpr std::array<const char*, 5> kNames{"Phong", "Wireframe", "Seide \"ö\"", "\xF0\x9F\xA7\xB5",
                                                    "a\tb"};
        Appearance& appearance = scene.appearance;
        if (chance(0.5))
            appearance.shader = kNames[static_cast<std::size_t>(below(int(kNames.size())))];
        for (double& channel : appearance.color)
            channel = chance(0.5) ? channel : within(kShare);
        for (bool& drawn : appearance.springsDrawn)
            drawn = chance(0.7);
        appearance.springsOverSurface = chance(0.3);
        appearance.unknownKeys = unknown();
        appearance.unknownSpringKeys = unknown();
        if (chance(0.5))
            scene.camera = CameraView{vector(kCoordinate), within(kLength), within(kAzimuth),
                                      within(kElevation), unknown()};
    }

    std::mt19937 m_random;
};

std::string randomValueText(std::mt19937& random, int levels) {
    constexpr std::array<const char*, 12> kPlain{
        "null",   "true", "-0", "1.50",  "12345678901234567890123", R"("")", R"("\u00e9\\\"\ud83e\uddf5")",
        "0.1e-9", "[]",   "{}", "false", R"("a: [b, {c}]")"};
    const auto kind = random() % 16;
    if (kind < kPlain.size() || levels == 0)
        return kPlain[kind % kPlain.size()];
    if (kind < 14)
        return "[" + randomValueText(random, levels - 1) + "," + randomValueText(random, levels - 1) + "]";
    return randomObjectText(random, levels - 1);
}

} // namespace

std::string randomObjectText(std::mt19937& random, int levels) {
    std::string text;
    const auto count = 1 + random() % 3;
    for (unsigned i = 0; i < count; ++i) {
        text += (i == 0 ? "{\"" : ",\"") + std::string(i % 2 == 0 ? "new key " : "n\\u00fc") +
                std::to_string(i) + "\":" + randomValueText(random, levels);
    }
    return text + "}";
}

Scene randomScene(std::uint32_t seed) {
    return SceneMaker(seed).make();
}

} // namespace clothlab::test
