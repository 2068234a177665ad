#include "tests/support/take_file_invariants.h"

namespace clothlab::test {
namespace {

std::string brokenTake(const TakeFileContents& contents, const RecordedTake& take) {
    const std::string name = "take " + std::to_string(take.info.id);
    if (take.info.id == 0)
        return name + " has no number";
    if (take.info.parent == 0 && take.groups.empty())
        return name + " is a root without frames";
    if (take.info.parent != 0) {
        const RecordedTake* parent = findTake(contents, take.info.parent);
        if (parent == nullptr || parent >= &take)
            return name + " is not behind its parent";
        if (take.info.branchFrame >= parent->end())
            return name + " branches off nothing";
    }
    int next = take.info.firstOwnFrame();
    for (const FrameGroup& group : take.groups) {
        if (group.first != next || group.frames.empty() || group.take != take.info.id)
            return name + " has a gap";
        next = group.end();
        GroupReader reader;
        for (int frame = group.first; frame < group.end(); ++frame) {
            const auto scene = contents.scenes.find(group.frames[std::size_t(frame - group.first)].scene);
            if (scene == contents.scenes.end() || gridOf(scene->second->cloth) != group.grid)
                return name + " has a frame without its scene";
            const auto positions = reader.positionsOf(group, frame);
            if (positions && int(positions->size()) != group.grid.pointCount())
                return name + " has a frame of another size";
        }
    }
    for (const Checkpoint& checkpoint : take.checkpoints) {
        const auto state = stateOf(checkpoint);
        if (state && int(state->size()) != checkpoint.grid.pointCount())
            return name + " has a state of another size";
        if (checkpoint.frame < take.info.firstOwnFrame() || checkpoint.frame >= take.end())
            return name + " has a state of a frame that is not there";
    }
    return {};
}

} // namespace

std::string brokenTakeFileInvariant(const TakeFileReading& reading) {
    for (const Diagnostic& diagnostic : reading.diagnostics)
        if (diagnostic.message.empty())
            return "a problem without words";
    if (reading.contents.has_value() == hasErrors(reading.diagnostics))
        return "contents and errors, or neither";
    if (!reading.contents)
        return {};
    const TakeFileContents& contents = *reading.contents;
    if (contents.takes.empty())
        return "contents without takes";
    for (const RecordedTake& take : contents.takes)
        if (std::string broken = brokenTake(contents, take); !broken.empty())
            return broken;
    const RecordedTake* active = findTake(contents, contents.meta.activeTake);
    if (active == nullptr || contents.meta.shownFrame < 0 || contents.meta.shownFrame >= active->end())
        return "a frame is shown that is not there";
    return {};
}

} // namespace clothlab::test
