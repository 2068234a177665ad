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

    std::string shaderName() {
        constexpr std::array<const char*, 5> kNames{"Phong", "Wireframe", "Seide \"ö\"", "\xF0\x9F\xA7\xB5",
                                                    "a\tb"};
        return kNames[static_cast<std::size_t>(below(int(kNames.size())))];
    }

    std::string fileName() {
        const std::array<std::string, 6> names{"",
                                               "linen.png",
                                               "../Wäsche \"1\".png",
                                               "c:\\silk\\\xF0\x9F\xA7\xB5",
                                               "a\nb\x7F",
                                               std::string(kMaxFileNameBytes, '\x01')};
        return names[static_cast<std::size_t>(below(int(names.size())))];
    }

    double anyNumber() { return chance(0.2) ? -0.0 : std::ldexp(uniform(-1, 1), below(2040) - 1020); }
    Rgb color() { return {within(kShare), within(kShare), within(kShare)}; }

    UniformValue uniformValue() {
        switch (below(4)) {
        case 0:
            return chance(0.5);
        case 1:
            return anyNumber();
        case 2:
            return fileName();
        default:
            std::vector<double> numbers(std::size_t(2 + below(3)));
            for (double& number : numbers)
                number = anyNumber();
            return numbers;
        }
    }

    std::map<std::string, UniformValues> uniforms() {
        const std::array<std::string, 5> names{"u_tint", "_", "R2D2", "uniform_u", std::string(200, 'u')};
        std::map<std::string, UniformValues> shaders;
        for (int i = below(4); i > 0; --i) {
            UniformValues& values = shaders[shaderName()];
            for (int j = below(5); j > 0; --j)
                values[names[static_cast<std::size_t>(below(int(names.size())))]] = uniformValue();
        }
        return shaders;
    }

    void decorate(Scene& scene) {
        Appearance& appearance = scene.appearance;
        if (chance(0.5))
            appearance.shader = shaderName();
        for (double& channel : appearance.color)
            channel = chance(0.5) ? channel : within(kShare);
        if (chance(0.5))
            appearance.backColor = color();
        if (chance(0.5))
            appearance.background = color();
        appearance.springColoring = chance(0.5) ? SpringColoring::ByStrain : SpringColoring::ByType;
        for (std::string& texture : appearance.textures)
            texture = fileName();
        appearance.cubemap = fileName();
        if (chance(0.7))
            appearance.uniforms = uniforms();
        for (bool& drawn : appearance.springsDrawn)
            drawn = chance(0.7);
        appearance.springsOverSurface = chance(0.3);
        appearance.unknownKeys = unknown();
        appearance.unknownSpringKeys = unknown();
        appearance.unknownTextureKeys = unknown();
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
