#include "tests/support/shipped_scene.h"

#include "simcore/scene/scene_io.h"

#include <cstdio>
#include <cstdlib>

namespace clothlab::test {

Scene shippedScene(const std::string& name) {
    const std::string path = CLOTHLAB_SOURCE_DIR "/scenes/" + name + ".json";
    SceneReading reading = loadScene(path);
    if (reading.scene)
        return std::move(*reading.scene);
    std::fprintf(stderr, "%s cannot be read\n", path.c_str());
    std::abort();
}

} // namespace clothlab::test
