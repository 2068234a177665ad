// Recordings as files, .clothtake.
#pragma once

#include "simcore/recording/take_chunks.h"

#include <functional>
#include <map>

namespace clothlab {

struct RecordedTake {
    TakeInfo info;
    std::vector<FrameGroup> groups;      // in order, the first at info.firstOwnFrame(), without gaps
    std::vector<Checkpoint> checkpoints; // of own frames, in order
    int end() const { return groups.empty() ? info.firstOwnFrame() : groups.back().end(); }
};

using SceneMap = std::map<SceneId, std::shared_ptr<const Scene>>;

struct TakeFileContents {
    std::vector<RecordedTake> takes; // a parent is before its branches; each has frames or a branch that has
    SceneMap scenes;                 // every one that a frame names is there
    TakeMeta meta;                   // names no take and no frame that is not there
};

// What makes a reading: a take ends before the first of its frames that is missing, and is left out if its
// first is missing. Each such thing is a warning; an error is that nothing could be read.
struct TakeFileReading {
    std::optional<TakeFileContents> contents; // payloads are read when they are asked for
    Diagnostics diagnostics;                  // without the file's name
    std::uint64_t bytes = 0;                  // of the file
    std::uint32_t version = 0;                // of the format
    bool finished = false;                    // it ends as a file that was finished
    std::vector<std::uint64_t> chunks;        // where each good one begins
    std::uint64_t end = 0;                    // of the last good chunk: to append, cut the file there
};
TakeFileReading readTakeFile(const std::string& path);

// Called with the share that is done, 0 … 1; false cancels.
using SaveProgress = std::function<bool(double share)>;

// Whole or not at all. Returns what went wrong, in words; "" if it was cancelled.
std::optional<std::string> writeTakeFile(const std::string& path, const TakeFileContents& contents,
                                         const SaveProgress& progress = {});

// The group of a take, or of the take it branched off, that holds a frame; null if there is none.
const FrameGroup* findGroup(const TakeFileContents& contents, TakeId take, int frame);
const RecordedTake* findTake(const TakeFileContents& contents, TakeId take);

} // namespace clothlab
