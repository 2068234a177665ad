#include "simcore/scene/scene_differences.h"

#include "simcore/scene/json_text.h"
#include "simcore/scene/parameters.h"

namespace clothlab {
namespace {

bool movesTheSheet(const Parameter& parameter) {
    return parameter.object() == "cloth" || parameter.object() == "simulation";
}

} // namespace

std::vector<std::string> motionDifferences(const Scene& before, const Scene& after) {
    std::vector<std::string> found;
    for (const Parameter& parameter : parameters()) {
        const double from = parameter.get(before);
        const double to = parameter.get(after);
        if (movesTheSheet(parameter) && from != to)
            found.push_back(std::string(parameter.id) + " " + json::numberText(from) + " -> " +
                            json::numberText(to));
    }
    const auto add = [&](bool same, const char* what) {
        if (!same)
            found.emplace_back(what);
    };
    add(before.cloth.pinned == after.cloth.pinned, "the pins");
    add(before.spheres == after.spheres, "the spheres");
    add(before.planes == after.planes, "the planes");
    return found;
}

} // namespace clothlab
