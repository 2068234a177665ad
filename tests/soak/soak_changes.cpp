#include "tests/soak/soak_changes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace clothlab::soak {
namespace {

// As likely within each factor of ten.
double logUniform(SplitMix64& random, double low, double high) {
    return std::exp(random.real(std::log(low), std::log(high)));
}

int logUniform(SplitMix64& random, int low, int high) {
    return std::clamp(int(std::lround(logUniform(random, double(low), double(high)))), low, high);
}

void pinAtRandom(SplitMix64& random, Cloth& cloth) {
    if (!cloth.pinned.empty()) {
        cloth.pinned.clear();
        return;
    }
    const int count = random.integer(1, 8);
    for (int n = 0; n < count; ++n) {
        const int x = random.integer(0, cloth.numWidthPoints - 1);
        const GridPoint pin{x, random.integer(0, cloth.numHeightPoints - 1)};
        if (std::ranges::find(cloth.pinned, pin) == cloth.pinned.end())
            cloth.pinned.push_back(pin);
    }
}

// Thickness half the time as it is: a fine sheet then crowds in itself from the start. Otherwise as the
// spacing allows.
void resizeAtRandom(SplitMix64& random, Cloth& cloth) {
    cloth.numWidthPoints = logUniform(random, 2, 200);
    cloth.numHeightPoints = random.chance(0.5) ? cloth.numWidthPoints : logUniform(random, 2, 200);
    const int most = std::max(cloth.numWidthPoints, cloth.numHeightPoints);
    cloth.thickness = random.chance(0.5) ? 0.0095 : std::min(0.02, 0.45 / (most - 1));
    std::erase_if(cloth.pinned, [&](const GridPoint& pin) {
        return pin.x >= cloth.numWidthPoints || pin.y >= cloth.numHeightPoints;
    });
}

} // namespace

void changeAtRandom(SplitMix64& random, Setup& setup) {
    Cloth& cloth = setup.scene.cloth;
    const int count = random.integer(1, 3);
    for (int n = 0; n < count; ++n)
        switch (random.integer(0, 6)) {
        case 0:
            cloth.ks = logUniform(random, 5.0, 5e5);
            break;
        case 1:
            cloth.density = logUniform(random, 0.15, 1500.0);
            break;
        case 2: // mostly as people have it
            cloth.damping = random.chance(0.5) ? random.real(0, 1) : random.real(0, 100);
            break;
        case 3:
            setup.scene.simulation.stepsPerFrame = logUniform(random, 1, 200);
            break;
        case 4:
            pinAtRandom(random, cloth);
            break;
        case 5:
            resizeAtRandom(random, cloth);
            break;
        default:
            setup.threads = 3 - setup.threads;
        }
}

std::string describe(const Setup& setup) {
    const Cloth& cloth = setup.scene.cloth;
    char text[200];
    std::snprintf(
        text, sizeof text,
        "%s, %d x %d, %d threads, ks %.4g, density %.4g, damping %.3g, thickness %.3g, %d steps, %d "
        "pins",
        setup.name.c_str(), cloth.numWidthPoints, cloth.numHeightPoints, setup.threads, cloth.ks,
        cloth.density, cloth.damping, cloth.thickness, setup.scene.simulation.stepsPerFrame,
        int(cloth.pinned.size()));
    return text;
}

} // namespace clothlab::soak
