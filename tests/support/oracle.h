// The oracle: the cloth model read as plainly as it can be, to check simcore against and to measure it by.
// An array of structs, a list of springs, a hash map for self-collision. It shares no code with the solver,
// only the scene's plain values. Its sums and products are in the order that simcore's are, so that the two
// agree to the last bit: cloth that bounces or crowds doubles any rounding error every few steps, and within
// 300 steps two right answers would part by more than a tolerance could tell from a wrong one.
#pragma once

#include "simcore/scene/scene.h"

#include <cstdint>
#include <vector>

namespace clothlab::oracle {

struct PointMass {
    Vec3 position{0, 0, 0};     // m
    Vec3 lastPosition{0, 0, 0}; // m, one step earlier
    Vec3 force{0, 0, 0};        // N
    bool pinned = false;
};

struct Spring {
    int a = 0;
    int b = 0;
    double restLength = 0; // m
    double stiffness = 0;  // N/m
    SpringType type = SpringType::Structural;
};

// How often each phase moved a point, so that a test can tell that it tested something.
struct Counts {
    std::int64_t selfCollisions = 0;
    std::int64_t sphereContacts = 0;
    std::int64_t planeContacts = 0;
    std::int64_t strainLimits = 0;
};

class Cloth {
public:
    explicit Cloth(const Scene& scene); // precondition: validate(scene) has no errors

    void step();

    std::vector<PointMass> points; // row-major; may be moved between steps
    std::vector<Spring> springs;   // all types, in the order of the strain limit
    Counts counts;

private:
    bool enabled(SpringType type) const;
    void computeForces();
    void moveByVerlet();
    void moveApart();
    void collideWithSphere(const Sphere& sphere);
    void collideWithPlane(const Plane& plane);
    void limitStrain();

    Scene m_scene;
    double m_pointMass = 0; // kg
};

// For each point that is not pinned, the mean of the vectors that put it at `distance` from each other point
// nearer than that, times share. neighbours: how many there were. Points at the same place part nowhere.
struct Correction {
    Vec3 vector{0, 0, 0};
    int neighbours = 0;
};
std::vector<Correction> selfCollisionAllPairs(const std::vector<PointMass>& points, double distance,
                                              double share);
std::vector<Correction> selfCollisionHashed(const std::vector<PointMass>& points, double distance,
                                            double share); // the same vectors up to the order of the sum

} // namespace clothlab::oracle
