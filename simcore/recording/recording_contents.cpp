#include "simcore/recording/recording_contents.h"

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace clothlab {
namespace {

RecordedTake recordedTake(const Recording& recording, const Take& take) {
    RecordedTake recorded;
    recorded.info = infoOf(recording, take);
    for (int i = take.branchFrame() + 1; i < take.frameCount(); ++i) {
        const RecordedFrame& frame = take.frame(i);
        if (!frame.group)
            break;
        if (i == frame.group->first)
            recorded.groups.push_back(*frame.group);
        if (frame.checkpoint)
            recorded.checkpoints.push_back(*frame.checkpoint);
    }
    return recorded;
}

TakePointer makeTake(const TakeFileContents& contents, const RecordedTake& recorded,
                     const std::map<TakeId, TakePointer>& made) {
    const TakeInfo& info = recorded.info;
    TakePointer take;
    if (info.parent == 0)
        take = std::make_shared<Take>(
            info.id, info.name, startFrame(contents.scenes.at(recorded.groups.front().frames.front().scene)));
    else
        take = std::make_shared<Take>(info.id, info.name, ownerOf(made.at(info.parent), info.branchFrame),
                                      info.branchFrame);
    for (const FrameGroup& group : recorded.groups) {
        const auto shared = std::make_shared<const FrameGroup>(group);
        for (int i = group.first; i < group.end(); ++i) {
            const FrameEntry& entry = group.frames[std::size_t(i - group.first)];
            if (i > 0)
                take->append({contents.scenes.at(entry.scene), entry.facts.time, nullptr, nullptr, nullptr});
            take->frame(i).group = shared;
        }
    }
    for (const Checkpoint& checkpoint : recorded.checkpoints)
        take->frame(checkpoint.frame).checkpoint = std::make_shared<const Checkpoint>(checkpoint);
    return take;
}

void setMarks(Take& take, const TakeMeta& meta) {
    TakeMarks marks;
    for (const FrameMarker& marker : meta.markers)
        if (marker.take == take.id())
            setMarker(marks, {marker.frame, marker.name});
    for (const PlayRange& range : meta.ranges)
        if (range.take == take.id())
            marks.range = {range.in, range.out};
    take.setMarks(std::move(marks));
}

} // namespace

TakeInfo infoOf(const Recording& recording, const Take& take) {
    const TakePointer& parent = take.parent();
    return {take.id(), parent ? parent->id() : 0, parent ? take.branchFrame() : 0, take.name(),
            !recording.isListed(take)};
}

TakeMeta marksOf(const Recording& recording) {
    TakeMeta meta;
    for (const TakePointer& take : recording.takes()) {
        const TakeMarks& marks = take->marks();
        for (const Marker& marker : marks.markers)
            meta.markers.push_back({take->id(), marker.frame, marker.name});
        if (marks.range)
            meta.ranges.push_back({take->id(), marks.range->in, marks.range->out});
    }
    return meta;
}

TakeFileContents contentsOf(const Recording& recording) {
    std::map<TakeId, const Take*> needed; // a parent has a smaller number than its branches
    for (const TakePointer& listed : recording.takes())
        for (const Take* take = listed.get(); take; take = take->parent().get())
            needed[take->id()] = take;
    TakeFileContents contents;
    for (const auto& [id, take] : needed)
        if (RecordedTake recorded = recordedTake(recording, *take); !recorded.groups.empty())
            contents.takes.push_back(std::move(recorded));
    contents.meta = marksOf(recording);
    const auto isThere = [&](TakeId take, int frame) {
        const RecordedTake* found = findTake(contents, take);
        return found && frame < found->end();
    };
    std::erase_if(contents.meta.markers, [&](const FrameMarker& m) { return !isThere(m.take, m.frame); });
    std::erase_if(contents.meta.ranges, [&](const PlayRange& r) { return !isThere(r.take, r.in); });
    contents.meta.activeTake = recording.take()->id();
    contents.meta.shownFrame = recording.shownFrame();
    if (!findTake(contents, contents.meta.activeTake))
        contents.meta.activeTake = 0;
    return contents;
}

std::vector<SceneId> scenesNamed(const TakeFileContents& contents) {
    std::set<SceneId> ids;
    for (const RecordedTake& take : contents.takes)
        for (const FrameGroup& group : take.groups)
            for (const FrameEntry& frame : group.frames)
                ids.insert(frame.scene);
    if (contents.meta.scene != 0)
        ids.insert(contents.meta.scene);
    return {ids.begin(), ids.end()};
}

LoadedTakes takesOf(const TakeFileContents& contents) {
    std::map<TakeId, TakePointer> made;
    LoadedTakes loaded;
    for (const RecordedTake& recorded : contents.takes) {
        const TakePointer take = makeTake(contents, recorded, made);
        setMarks(*take, contents.meta);
        made[take->id()] = take;
        if (!recorded.info.hidden)
            loaded.takes.push_back(take);
    }
    if (loaded.takes.empty()) // all were deleted; better one too many than none
        loaded.takes.push_back(made.at(contents.takes.back().info.id));
    loaded.open = loaded.takes.front();
    for (const TakePointer& take : loaded.takes)
        if (take->id() == contents.meta.activeTake)
            loaded.open = take;
    loaded.shownFrame = std::clamp(contents.meta.shownFrame, 0, loaded.open->lastFrame());
    loaded.scene = lastScene(*loaded.open);
    if (const auto own = contents.scenes.find(contents.meta.scene);
        own != contents.scenes.end() && compareScenes(*own->second, *loaded.scene) != SceneChange::Start)
        loaded.scene = own->second;
    return loaded;
}

} // namespace clothlab
