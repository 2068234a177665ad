#include "simcore/scene/parameters.h"

#include <algorithm>
#include <array>

namespace clothlab {
namespace {

using Kind = Parameter::Kind;

#define CLOTHLAB_FIELD(type, field)                                                                          \
    [](const Scene& scene) { return static_cast<double>(scene.field); },                                     \
        [](Scene& scene, double value) { scene.field = static_cast<type>(value); }

constexpr std::array kParameters = {
    Parameter{"cloth.density", "Density", "g/cm²",
              "Mass of the sheet per area; a heavier sheet sags more and stretches its springs further.",
              Kind::Real, 1e-6, 1e6, 1, 1500, true, 10, CLOTHLAB_FIELD(double, cloth.density)},
    Parameter{
        "cloth.ks", "Stiffness ks", "N/m",
        "Spring constant; low values sag and wrinkle, high values hold the shape and need smaller steps.",
        Kind::Real, 0, 1e9, 50, 100000, true, 1, CLOTHLAB_FIELD(double, cloth.ks)},
    Parameter{
        "cloth.damping", "Damping", "%",
        "Share of the velocity that each step takes away; at 0 cloth never rests, at 1 it settles without "
        "swinging.",
        Kind::Real, 0, 100, 0, 2, false, 1, CLOTHLAB_FIELD(double, cloth.damping)},
    Parameter{"cloth.thickness", "Thickness", "m",
              "Points of the sheet keep twice this distance from each other; 0 switches self-collision off.",
              Kind::Real, 0, 1, 0, 0.02, false, 1, CLOTHLAB_FIELD(double, cloth.thickness)},
    Parameter{"cloth.enable_structural", "Structural springs", "",
              "Springs to the next point left and up: they hold the sheet together.", Kind::Boolean, 0, 1, 0,
              1, false, 1, CLOTHLAB_FIELD(bool, cloth.enableStructural)},
    Parameter{"cloth.enable_shearing", "Shearing springs", "",
              "Diagonal springs: they keep the squares of the grid from folding into rhombs.", Kind::Boolean,
              0, 1, 0, 1, false, 1, CLOTHLAB_FIELD(bool, cloth.enableShearing)},
    Parameter{"cloth.enable_bending", "Bending springs", "",
              "Springs to the point after the next: they resist folding.", Kind::Boolean, 0, 1, 0, 1, false,
              1, CLOTHLAB_FIELD(bool, cloth.enableBending)},
    Parameter{"cloth.width", "Width", "m", "Length of a row of points at rest.", Kind::Real, 1e-4, 1e4, 0.1,
              4, false, 1, CLOTHLAB_FIELD(double, cloth.width)},
    Parameter{"cloth.height", "Height", "m", "Length of a column of points at rest.", Kind::Real, 1e-4, 1e4,
              0.1, 4, false, 1, CLOTHLAB_FIELD(double, cloth.height)},
    Parameter{"cloth.num_width_points", "Points across", "",
              "Point masses in a row; more show finer folds and need smaller steps.", Kind::Integer, 2,
              1 << 16, 2, 200, false, 1, CLOTHLAB_FIELD(int, cloth.numWidthPoints)},
    Parameter{"cloth.num_height_points", "Points down", "",
              "Point masses in a column; more show finer folds and need smaller steps.", Kind::Integer, 2,
              1 << 16, 2, 200, false, 1, CLOTHLAB_FIELD(int, cloth.numHeightPoints)},
    Parameter{"cloth.orientation", "Vertical", "",
              "The sheet starts upright, a little uneven so that it can fold, instead of lying flat at 1 m.",
              Kind::Boolean, 0, 1, 0, 1, false, 1, CLOTHLAB_FIELD(Orientation, cloth.orientation)},
    Parameter{"simulation.frames_per_second", "Frames", "1/s", "Frames recorded a simulated second.",
              Kind::Integer, 1, 100000, 24, 240, false, 1, CLOTHLAB_FIELD(int, simulation.framesPerSecond)},
    Parameter{"simulation.steps_per_frame", "Steps per frame", "",
              "Simulation steps a frame; more are slower, and stable for stiffer or finer sheets.",
              Kind::Integer, 1, 100000, 1, 200, false, 1, CLOTHLAB_FIELD(int, simulation.stepsPerFrame)},
    Parameter{"simulation.gravity[0]", "Gravity x", "m/s²", "Acceleration of every point along x.",
              Kind::Real, -1e6, 1e6, -20, 20, false, 1, CLOTHLAB_FIELD(double, simulation.gravity[0])},
    Parameter{"simulation.gravity[1]", "Gravity y", "m/s²",
              "Acceleration of every point along y, which is up.", Kind::Real, -1e6, 1e6, -20, 20, false, 1,
              CLOTHLAB_FIELD(double, simulation.gravity[1])},
    Parameter{"simulation.gravity[2]", "Gravity z", "m/s²", "Acceleration of every point along z.",
              Kind::Real, -1e6, 1e6, -20, 20, false, 1, CLOTHLAB_FIELD(double, simulation.gravity[2])},
    Parameter{
        "simulation.seed", "Seed", "",
        "Start of the random numbers that make a vertical sheet uneven; the same seed gives the same run.",
        Kind::Integer, 0, 4294967295.0, 0, 100, false, 1, CLOTHLAB_FIELD(std::uint32_t, simulation.seed)},
    Parameter{"appearance.two_sided", "Lit on both sides", "",
              "Each side of the sheet is lit as if it faced the light; off, the back is lit as if it were "
              "the front.",
              Kind::Boolean, 0, 1, 0, 1, false, 1, CLOTHLAB_FIELD(bool, appearance.twoSided)},
    Parameter{"appearance.strain_range", "Range", "",
              "Share of its length that a spring is longer or shorter by where the colours of strain end; 0 "
              "takes the greatest of the frame.",
              Kind::Real, 0, 10, 0, 0.5, false, 1, CLOTHLAB_FIELD(double, appearance.strainRange), 1e-6},
    Parameter{"appearance.light_position[0]", "Light x", "m", "Where the light shines from, along x.",
              Kind::Real, -1e6, 1e6, -5, 5, false, 1, CLOTHLAB_FIELD(double, appearance.lightPosition[0])},
    Parameter{"appearance.light_position[1]", "Light y", "m",
              "Where the light shines from, along y, which is up.", Kind::Real, -1e6, 1e6, -5, 5, false, 1,
              CLOTHLAB_FIELD(double, appearance.lightPosition[1])},
    Parameter{"appearance.light_position[2]", "Light z", "m", "Where the light shines from, along z.",
              Kind::Real, -1e6, 1e6, -5, 5, false, 1, CLOTHLAB_FIELD(double, appearance.lightPosition[2])},
    Parameter{"appearance.light_intensity[0]", "Red light", "",
              "How much red light arrives at 1 m from the light; it falls with the square of the distance.",
              Kind::Real, 0, 1e6, 0, 20, false, 1, CLOTHLAB_FIELD(double, appearance.lightIntensity[0])},
    Parameter{"appearance.light_intensity[1]", "Green light", "",
              "How much green light arrives at 1 m from the light; it falls with the square of the distance.",
              Kind::Real, 0, 1e6, 0, 20, false, 1, CLOTHLAB_FIELD(double, appearance.lightIntensity[1])},
    Parameter{"appearance.light_intensity[2]", "Blue light", "",
              "How much blue light arrives at 1 m from the light; it falls with the square of the distance.",
              Kind::Real, 0, 1e6, 0, 20, false, 1, CLOTHLAB_FIELD(double, appearance.lightIntensity[2])},
    Parameter{"appearance.shadows", "Shadows", "", "What is between the light and a place darkens it.",
              Kind::Boolean, 0, 1, 0, 1, false, 1, CLOTHLAB_FIELD(bool, appearance.shadows)},
    Parameter{"appearance.ground_grid", "Ground grid", "", "Draws a grid of lines on the ground.",
              Kind::Boolean, 0, 1, 0, 1, false, 1, CLOTHLAB_FIELD(bool, appearance.groundGrid)},
    Parameter{"appearance.axes", "Axes", "", "Draws the axes x, y and z at the origin.", Kind::Boolean, 0, 1,
              0, 1, false, 1, CLOTHLAB_FIELD(bool, appearance.axes)},
    Parameter{"appearance.samples", "Samples", "",
              "Samples a pixel, 1, 2, 4 or 8; more smooth the edges and take longer to draw.", Kind::Integer,
              1, 8, 1, 8, false, 1, CLOTHLAB_FIELD(int, appearance.samples), 0, true},
    Parameter{"appearance.mesh_resolution", "Mesh resolution", "",
              "Cells along a side of the drawn sheet and spheres; more let displacement show finer relief, 0 "
              "draws them as simulated.",
              Kind::Integer, 0, 512, 0, 512, false, 1, CLOTHLAB_FIELD(int, appearance.meshResolution), 16},
    Parameter{"appearance.normal_scaling", "Normal scaling", "",
              "How strongly a height map bends the light on the surface; below 0 heights become dents.",
              Kind::Real, -100, 100, -10, 10, false, 1, CLOTHLAB_FIELD(double, appearance.normalScaling)},
    Parameter{"appearance.height_scaling", "Height scaling", "",
              "How far a height map moves the surface itself; below 0 it moves inwards.", Kind::Real, -10, 10,
              -1, 1, false, 1, CLOTHLAB_FIELD(double, appearance.heightScaling)},
};

#undef CLOTHLAB_FIELD

} // namespace

std::span<const Parameter> parameters() {
    return kParameters;
}

const Parameter* findParameter(std::string_view id) {
    const auto found = std::ranges::find(kParameters, id, &Parameter::id);
    return found == kParameters.end() ? nullptr : &*found;
}

} // namespace clothlab
