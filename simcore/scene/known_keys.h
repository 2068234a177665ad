// The keys of each object of a scene file, in the order in which they are written.
#pragma once

#include <array>
#include <span>
#include <string_view>

namespace clothlab {

using Keys = std::span<const std::string_view>;

inline constexpr std::array<std::string_view, 6> kSceneKeys{"cloth",      "sphere",     "plane",
                                                            "simulation", "appearance", "camera"};
inline constexpr std::array<std::string_view, 13> kClothKeys{
    "damping",     "density", "ks",     "enable_structural", "enable_shearing",   "enable_bending",
    "orientation", "width",   "height", "num_width_points",  "num_height_points", "thickness",
    "pinned"};
inline constexpr std::array<std::string_view, 3> kSphereKeys{"origin", "radius", "friction"};
inline constexpr std::array<std::string_view, 3> kPlaneKeys{"point", "normal", "friction"};
inline constexpr std::array<std::string_view, 4> kSimulationKeys{"gravity", "frames_per_second",
                                                                 "steps_per_frame", "seed"};
inline constexpr std::array<std::string_view, 21> kAppearanceKeys{
    "shader",
    "color",
    "back_color",
    "two_sided",
    "springs_drawn",
    "springs_over_surface",
    "springs_colored_by",
    "strain_range",
    "light_position",
    "light_intensity",
    "shadows",
    "background",
    "ground_grid",
    "axes",
    "samples",
    "mesh_resolution",
    "normal_scaling",
    "height_scaling",
    "textures",
    "cubemap",
    "uniforms",
};
inline constexpr std::array<std::string_view, 3> kSpringsDrawnKeys{"structural", "shearing", "bending"};
inline constexpr std::array<std::string_view, 4> kTextureKeys{"texture_1", "texture_2", "texture_3",
                                                              "texture_4"};
inline constexpr std::array<std::string_view, 4> kCameraKeys{"target", "distance", "azimuth", "elevation"};

bool isKnown(std::string_view key, Keys keys);

// The key that key is likely a misspelling of; empty if none is near.
std::string_view closestKey(std::string_view key, Keys keys);

} // namespace clothlab
