// A scene as plain values, in SI units. The defaults are those of the course's pinned scenes without pins.
#pragma once

#include "simcore/base/vec3.h"

#include <array>
#include <compare>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace clothlab {

// Keys that this version does not know are kept as the text of a JSON object in members named
// unknownKeys (empty: there are none), so that saving a file of a newer version loses nothing.

struct GridPoint {
    int x = 0; // 0 … numWidthPoints - 1
    int y = 0; // 0 … numHeightPoints - 1
    friend auto operator<=>(const GridPoint&, const GridPoint&) = default;
};

enum class Orientation { Horizontal = 0, Vertical = 1 };

enum class SpringType { Structural = 0, Shearing = 1, Bending = 2 };
inline constexpr int kSpringTypes = 3;

struct Cloth {
    double width = 1;  // m
    double height = 1; // m
    int numWidthPoints = 50;
    int numHeightPoints = 50;
    Orientation orientation = Orientation::Horizontal;
    double thickness =
        0.0095;           // m; points of the sheet keep 2 * thickness apart; 0 switches self-collision off
    double damping = 0.2; // % of the velocity lost a step
    double density = 150; // kg/m²
    double ks = 5000;     // N/m; bending springs have 0.2 of it
    bool enableStructural = true;
    bool enableShearing = true;
    bool enableBending = true;
    std::vector<GridPoint> pinned;
    std::string unknownKeys;
    friend bool operator==(const Cloth&, const Cloth&) = default;

    bool enabled(SpringType type) const;
    int pointCount() const { return numWidthPoints * numHeightPoints; }
};

struct Sphere {
    Vec3 origin{0, 0, 0};
    double radius = 0.2; // m
    double friction = 0.3;
    std::string unknownKeys;
    friend bool operator==(const Sphere& a, const Sphere& b);
};

struct Plane {
    Vec3 point{0, 0, 0};
    Vec3 normal{0, 1, 0}; // any length but zero
    double friction = 0.5;
    std::string unknownKeys;
    friend bool operator==(const Plane& a, const Plane& b);
};

struct SimulationSettings {
    Vec3 gravity{0, -9.8, 0}; // m/s²
    int framesPerSecond = 90;
    int stepsPerFrame = 30;
    std::uint32_t seed = 0; // of the unevenness of a vertical sheet
    std::string unknownKeys;
    friend bool operator==(const SimulationSettings& a, const SimulationSettings& b);

    double timeStep() const { return 1.0 / (static_cast<double>(framesPerSecond) * stepsPerFrame); } // s
};

using Rgb = std::array<double, 3>; // sRGB, 0 … 1

// What a user set a uniform of a shader to: bool, int or float, vec2 to vec4 or a colour, a file for a
// sampler.
using UniformValue = std::variant<bool, double, std::vector<double>, std::string>;
using UniformValues = std::map<std::string, UniformValue, std::less<>>; // by the uniform's name

enum class SpringColoring { ByType, ByStrain };

inline constexpr int kTextures = 4; // u_texture_1 … u_texture_4 of the course

// Files are named relative to the scene's file, or absolutely; an empty name is what comes with the program.
struct Appearance {
    std::string shader = "Phong"; // name of a .frag in shaders/
    Rgb color{1, 1, 1};
    std::optional<Rgb> backColor; // of the sheet's other side; none: the same
    bool twoSided = true; // each side is lit as if it faced the light, or the back as if it were the front
    std::array<bool, kSpringTypes> springsDrawn{true, true, true};
    bool springsOverSurface = false; // draw springs with every shader, not only with Wireframe
    SpringColoring springColoring = SpringColoring::ByType;
    double strainRange =
        0.1; // at the ends of the colours of strain; 0: the greatest of the frame that is shown

    std::array<double, 3> lightPosition{0.5, 2, 2}; // m
    std::array<double, 3> lightIntensity{3, 3, 3};  // red, green, blue, at a distance of 1 m
    bool shadows = true;
    std::optional<Rgb> background; // none: the program's
    bool groundGrid = true;
    bool axes = true;
    int samples = 4; // a pixel: 1, 2, 4 or 8

    int meshResolution = 0; // cells of the drawn sheet and spheres along a side, 16 … 512; 0: as simulated
    double normalScaling = 2;
    double heightScaling = 0.1;
    std::array<std::string, kTextures> textures;
    std::string cubemap;                           // a folder with posx, negx, posy, negy, posz, negz
    std::map<std::string, UniformValues> uniforms; // by the shader's name; what is not there has its default

    std::string unknownKeys;
    std::string unknownSpringKeys;  // of the object springs_drawn
    std::string unknownTextureKeys; // of the object textures
    friend bool operator==(const Appearance&, const Appearance&) = default;
};

// Where the view looks from when the scene is opened; a scene without one gets the view of the course.
struct CameraView {
    Vec3 target{0, 0, 0};
    double distance = 2;  // m
    double azimuth = 0;   // degrees about +y; 0 looks along -z
    double elevation = 0; // degrees above the horizon
    std::string unknownKeys;
    friend bool operator==(const CameraView& a, const CameraView& b);
};

struct Scene {
    Cloth cloth;
    std::vector<Sphere> spheres;
    std::vector<Plane> planes;
    SimulationSettings simulation;
    Appearance appearance;
    std::optional<CameraView> camera;
    std::string unknownKeys;
    friend bool operator==(const Scene&, const Scene&) = default;
};

inline constexpr int kMaxPoints = 1 << 22;           // of one sheet: 2048 × 2048
inline constexpr std::size_t kMaxColliders = 10'000; // spheres, and as many planes

// What an edit touches. A start edit changes the sheet's rest shape or where it starts, so a run begins
// anew; a motion edit changes how a running sheet goes on; the rest changes only the picture.
enum class SceneChange { None, Appearance, Motion, Start };
SceneChange compareScenes(const Scene& before, const Scene& after); // the strongest that applies

} // namespace clothlab
