#include "app/cli/take_info_text.h"

#include "simcore/scene/json_text.h"
#include "simcore/scene/scene_differences.h"

#include <cstdio>

namespace clothlab::cli {
namespace {

template <typename... Values>
std::string format(const char* pattern, Values... values) {
    std::string text(std::size_t(std::snprintf(nullptr, 0, pattern, values...)), '\0');
    std::snprintf(text.data(), text.size() + 1, pattern, values...);
    return text;
}

std::string megabytes(std::uint64_t bytes) {
    return format("%.2f MB", double(bytes) * 1e-6);
}

struct Sizes {
    std::uint64_t frames = 0, frameBytes = 0, rawBytes = 0, checkpoints = 0, checkpointBytes = 0;
};

Sizes sizesOf(const TakeFileContents& contents) {
    Sizes sizes;
    for (const RecordedTake& take : contents.takes) {
        for (const FrameGroup& group : take.groups) {
            sizes.frames += group.frames.size();
            sizes.frameBytes += group.payload->length();
            sizes.rawBytes += 12 * group.frames.size() * std::uint64_t(group.grid.pointCount());
        }
        for (const Checkpoint& checkpoint : take.checkpoints) {
            ++sizes.checkpoints;
            sizes.checkpointBytes += checkpoint.payload->length();
        }
    }
    return sizes;
}

std::string errorText(double error) {
    return error == 0 ? std::string("none: positions keep their bits")
                      : json::numberText(error * 1000) + " mm at most";
}

// The scene with which the frame before a take's first was computed; null for a root.
const Scene* sceneBefore(const TakeFileContents& contents, const TakeInfo& info) {
    const FrameGroup* group = info.parent == 0 ? nullptr : findGroup(contents, info.parent, info.branchFrame);
    if (group == nullptr)
        return nullptr;
    return contents.scenes.at(group->frames[std::size_t(info.branchFrame - group->first)].scene).get();
}

std::string changesText(const TakeFileContents& contents, const RecordedTake& take,
                        const std::string& indent) {
    std::string text;
    const Scene* before = sceneBefore(contents, take.info);
    for (const FrameGroup& group : take.groups)
        for (std::size_t i = 0; i < group.frames.size(); ++i) {
            const Scene* scene = contents.scenes.at(group.frames[i].scene).get();
            std::string changes;
            if (before != nullptr && before != scene)
                for (const SceneDifference& change : motionDifferences(*before, *scene))
                    changes += (changes.empty() ? "" : ", ") + toText(change);
            if (!changes.empty())
                text += indent + format("frame %d: ", group.first + int(i)) + changes + "\n";
            before = scene;
        }
    return text;
}

std::string sheetText(const Grid& grid) {
    return format("%d x %d points, %d springs", grid.width, grid.height, grid.springCount());
}

std::string takeText(const TakeFileContents& contents, const RecordedTake& take, const std::string& indent) {
    const TakeInfo& info = take.info;
    std::string text = indent + format("%u '%s'", info.id, info.name.c_str());
    text += info.parent == 0 ? ", " + sheetText(take.groups.front().grid)
                             : format(", branches off frame %d of %u", info.branchFrame, info.parent);
    if (take.groups.empty())
        text += ", no frames of its own";
    else
        text += format(", frames %d to %d, up to %.3f s", info.firstOwnFrame(), take.end() - 1,
                       take.groups.back().frames.back().facts.time);
    text += info.hidden ? ", deleted\n" : "\n";
    return text + changesText(contents, take, indent + "    ");
}

int depthOf(const TakeFileContents& contents, const TakeInfo& info) {
    int depth = 0;
    for (const RecordedTake* take = findTake(contents, info.parent); take != nullptr;
         take = findTake(contents, take->info.parent))
        ++depth;
    return depth;
}

std::string treeText(const TakeFileContents& contents) {
    constexpr int deepest = 20; // that is shown as such
    std::string text = "takes\n";
    for (const RecordedTake& take : contents.takes)
        text +=
            takeText(contents, take,
                     std::string(2 + 2 * std::size_t(std::min(depthOf(contents, take.info), deepest)), ' '));
    return text;
}

} // namespace

std::string takeInfoText(const TakeFileReading& reading) {
    const TakeFileContents& contents = *reading.contents;
    const Sizes sizes = sizesOf(contents);
    const TakeMeta& meta = contents.meta;
    std::string text =
        format("format       %u, %s\n", reading.version, reading.finished ? "finished" : "not finished") +
        format("written by   %s %s\n", meta.program.c_str(), meta.version.c_str()) + "error        " +
        errorText(meta.error) + "\n" +
        format("frames       %llu, %s, %.2f times smaller than as floats\n",
               static_cast<unsigned long long>(sizes.frames), megabytes(sizes.frameBytes).c_str(),
               double(sizes.rawBytes) / double(std::max<std::uint64_t>(sizes.frameBytes, 1))) +
        format("checkpoints  %llu, %s\n", static_cast<unsigned long long>(sizes.checkpoints),
               megabytes(sizes.checkpointBytes).c_str()) +
        "file         " + megabytes(reading.bytes) + "\n" + treeText(contents);
    for (const FrameMarker& marker : meta.markers)
        text += format("marker at frame %d of take %u: %s\n", marker.frame, marker.take, marker.name.c_str());
    return text;
}

} // namespace clothlab::cli
