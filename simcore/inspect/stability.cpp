#include "simcore/inspect/stability.h"

#include "simcore/scene/parameters.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>

namespace clothlab {
namespace {

// Springs reach two points far, so the middle of 5 × 5 points has all that any point of a sheet has.
constexpr int kPoints = 5;

// Ap in the plane of the sheet; across it there is nothing.
struct PointStiffness {
    double xx = 0, xy = 0, yy = 0; // N/m

    void add(double k, double dx, double dy) { // of a spring with ends that far apart
        const double length = std::hypot(dx, dy);
        xx += k * (dx / length) * (dx / length);
        xy += k * (dx / length) * (dy / length);
        yy += k * (dy / length) * (dy / length);
    }
    double greatestEigenvalue() const { return (xx + yy) / 2 + std::hypot((xx - yy) / 2, xy); }
};

double greatestPointStiffness(const Cloth& cloth) {
    const Grid whole = gridOf(cloth);
    const double dx = cloth.width / (whole.width - 1); // of no use, and not used, in a sheet of one column
    const double dy = cloth.height / (whole.height - 1);
    const Grid grid{std::min(whole.width, kPoints), std::min(whole.height, kPoints)};
    std::array<PointStiffness, std::size_t(kPoints) * kPoints> points;
    for (const Stencil& stencil : kStencils) {
        if (!cloth.enabled(stencil.type))
            continue;
        const double k = stiffness(cloth, stencil.type);
        const double across = stencil.dx == 0 ? 0 : stencil.dx * dx;
        const double down = stencil.dy == 0 ? 0 : stencil.dy * dy;
        const StencilRange range = grid.range(stencil);
        for (int y = range.yBegin; y < range.yEnd; ++y)
            for (int x = range.xBegin; x < range.xEnd; ++x) {
                points[std::size_t(grid.index(x, y))].add(k, across, down);
                points[std::size_t(grid.index(x + stencil.dx, y + stencil.dy))].add(k, across, down);
            }
    }
    double greatest = 0;
    for (const PointStiffness& point : points) {
        const double eigenvalue = point.greatestEigenvalue();
        if (std::isnan(eigenvalue))
            return eigenvalue;
        greatest = std::max(greatest, eigenvalue);
    }
    return greatest;
}

double dtOmegaAt(double omega, int framesPerSecond, int stepsPerFrame) {
    SimulationSettings settings;
    settings.framesPerSecond = framesPerSecond;
    settings.stepsPerFrame = stepsPerFrame;
    return omega * settings.timeStep();
}

std::optional<int> leastStableSteps(double omega, int framesPerSecond, double limit) {
    const double estimate = std::ceil(omega / (limit * framesPerSecond));
    if (!(estimate <= maxStepsPerFrame())) // before it is made an int; infinite and NaN are among these
        return std::nullopt;
    // Rounding may have put the estimate one beside the least.
    for (int steps = std::max(1, int(estimate) - 1); steps <= maxStepsPerFrame(); ++steps)
        if (dtOmegaAt(omega, framesPerSecond, steps) <= limit)
            return steps;
    return std::nullopt;
}

// In no locale's way.
std::string withDecimals(double value, int decimals) {
    std::array<char, 400> text{}; // the longest double has 309 digits before the point
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed, decimals);
    return {text.data(), end.ptr};
}

// Two decimals, or three digits of what is 10 or more.
std::string withFewDigits(double value) {
    constexpr double kLargest = 1e6; // written out
    if (value < kLargest)
        return withDecimals(value, value < 10 ? 2 : value < 100 ? 1 : 0);
    std::array<char, 32> text{};
    const auto end =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 3);
    return {text.data(), end.ptr};
}

} // namespace

double greatestAngularFrequency(const Cloth& cloth) {
    const double stiffness = greatestPointStiffness(cloth);
    return stiffness == 0 ? 0 : std::sqrt(2 * stiffness / pointMass(cloth));
}

Stability stability(const Scene& scene) {
    const SimulationSettings& settings = scene.simulation;
    const double omega = greatestAngularFrequency(scene.cloth);
    Stability result;
    result.dtOmega = dtOmegaAt(omega, settings.framesPerSecond, settings.stepsPerFrame);
    if (std::isnan(result.dtOmega))
        result.dtOmega = std::numeric_limits<double>::infinity();
    const double c = 1 - scene.cloth.damping / 100;
    result.limit = std::sqrt(2 * (1 + c));
    result.stableStepsPerFrame = leastStableSteps(omega, settings.framesPerSecond, result.limit);
    return result;
}

StabilityText textOf(const Stability& stability) {
    StabilityText text{withFewDigits(stability.dtOmega), withDecimals(stability.limit, 2)};
    constexpr int kAllDecimals = 17;
    for (int decimals = 3; !stability.stable() && text.dtOmega == text.limit && decimals <= kAllDecimals;
         ++decimals)
        text = {withDecimals(stability.dtOmega, decimals), withDecimals(stability.limit, decimals)};
    return text;
}

int maxStepsPerFrame() {
    static const int most = int(findParameter("simulation.steps_per_frame")->maximum);
    return most;
}

void warnOfStep(const Scene& scene, Diagnostics& diagnostics) {
    const Stability found = stability(scene);
    if (found.stable())
        return;
    const StabilityText text = textOf(found);
    diagnostics.insert(
        diagnostics.begin(),
        {Severity::Warning, "simulation.steps_per_frame",
         "dt·ω is " + text.dtOmega + ", beyond " + text.limit + " where the step becomes unstable",
         found.stableStepsPerFrame
             ? std::to_string(*found.stableStepsPerFrame) + " steps per frame or more are stable"
             : "no number of steps per frame up to " + std::to_string(maxStepsPerFrame()) +
                   " is stable, so give a smaller cloth.ks or a greater cloth.density"});
}

} // namespace clothlab
