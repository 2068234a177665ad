#include "tests/support/tiny_scene.h"

namespace clothlab::test {

Scene tinyScene() {
    Scene scene;
    scene.cloth.numWidthPoints = 4;
    scene.cloth.numHeightPoints = 4;
    scene.cloth.pinned = {{0, 0}, {3, 0}};
    scene.simulation.framesPerSecond = 1000; // playing it takes no time
    scene.simulation.stepsPerFrame = 3;
    return scene;
}

Scene unstableScene() {
    Scene scene = tinyScene();
    scene.cloth.ks = 1e9;
    return scene;
}

} // namespace clothlab::test
