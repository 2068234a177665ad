#include "simcore/scene/scene_differences.h"

#include "simcore/scene/json_text.h"

namespace clothlab {
namespace {

bool movesTheSheet(const Parameter& parameter) {
    return parameter.object() == "cloth" || parameter.object() == "simulation";
}

} // namespace

std::vector<SceneDifference> motionDifferences(const Scene& before, const Scene& after) {
    std::vector<SceneDifference> found;
    for (const Parameter& parameter : parameters()) {
        const double from = parameter.get(before);
        const double to = parameter.get(after);
        if (movesTheSheet(parameter) && from != to)
            found.push_back({&parameter, from, to, {}});
    }
    const auto add = [&](bool same, std::string_view part) {
        if (!same)
            found.push_back({nullptr, 0, 0, part});
    };
    add(before.cloth.pinned == after.cloth.pinned, "the pins");
    add(before.spheres == after.spheres, "the spheres");
    add(before.planes == after.planes, "the planes");
    return found;
}

std::string toText(const SceneDifference& difference) {
    if (difference.parameter == nullptr)
        return std::string(difference.part);
    return std::string(difference.parameter->id) + " " + json::numberText(difference.before) + " -> " +
           json::numberText(difference.after);
}

} // namespace clothlab
