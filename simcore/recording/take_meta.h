// What a recording says of itself beside its takes.
#pragma once

#include "simcore/base/diagnostic.h"
#include "simcore/recording/frame_group.h"
#include "simcore/recording/take_marks.h"

#include <string>
#include <string_view>
#include <vector>

namespace clothlab {

struct TakeInfo {
    TakeId id = 0;
    TakeId parent = 0;   // 0: a root, which owns its frames from 0 on
    int branchFrame = 0; // of the parent, up to which they share frames; 0 for a root
    std::string name;
    bool hidden = false; // deleted, but a branch needs its frames
    int firstOwnFrame() const { return parent == 0 ? 0 : branchFrame + 1; }
    friend bool operator==(const TakeInfo&, const TakeInfo&) = default;
};

struct FrameMarker {
    TakeId take = 0;
    int frame = 0;
    std::string name;
    friend bool operator==(const FrameMarker&, const FrameMarker&) = default;
};

// In and out points of a take, both included; out may be kOpenEnd.
struct PlayRange {
    TakeId take = 0;
    int in = 0;
    int out = 0;
    friend bool operator==(const PlayRange&, const PlayRange&) = default;
};

struct TakeMeta {
    std::string program = "ClothLab";
    std::string version; // of the program
    double error = kDefaultError;
    TakeId activeTake = 0; // 0: none
    int shownFrame = 0;
    SceneId scene = 0; // of the user, which may not have been run yet; 0: that of the shown frame
    std::vector<FrameMarker> markers;
    std::vector<PlayRange> ranges;
    std::string unknownKeys; // text of a JSON object; empty: there are none
    friend bool operator==(const TakeMeta&, const TakeMeta&) = default;
};

std::string writeMeta(const TakeMeta& meta); // JSON
// Nothing if the text is no JSON object. What is of another type than it should be is left out.
std::optional<TakeMeta> readMeta(std::string_view text);

} // namespace clothlab
