// What is true of a state. Each quantity has its one name, unit and function here.
#pragma once

#include "simcore/cloth/cloth_state.h"

#include <array>
#include <vector>

namespace clothlab {

// (position - last position) / time step. m/s.
Vec3 velocity(const ClothState& state, int point, double timeStep);

struct SpringMeasure {
    double length = 0;     // m
    double restLength = 0; // m
    double strain = 0;     // (length - rest length) / rest length; 0 if the rest length is 0
    double force = 0;      // N, positive when it pulls its ends together; 0 when its type is switched off
};
SpringMeasure measureSpring(const Cloth& cloth, const Sheet& sheet, const PointArray& position,
                            const Spring& spring);

// The greatest strain of the springs of each type, switched on or not; 0 if there are none.
std::array<double, kSpringTypes> maxStrain(const Sheet& sheet, const PointArray& position);

// At each point the strain of the spring there that is strained most, stretched or compressed, among the
// types that are switched on; 0 if there is none. Returns the greatest magnitude. Replaces `strains`, one a
// point.
double pointStrains(const Cloth& cloth, const Sheet& sheet, const PointArray& position,
                    std::vector<float>& strains);

double kineticEnergy(const Scene& scene, const ClothState& state); // J
// Of springs that are switched on, and of gravity with its zero at the origin. J.
double potentialEnergy(const Scene& scene, const Sheet& sheet, const PointArray& position);

bool allFinite(const ClothState& state);

} // namespace clothlab
