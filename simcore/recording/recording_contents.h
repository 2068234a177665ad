// A recording as what a file holds, and back.
#pragma once

#include "simcore/recording/recording.h"
#include "simcore/recording/take_file.h"

namespace clothlab {

TakeInfo infoOf(const Recording& recording, const Take& take);

// Markers and ranges of all takes of the list.
TakeMeta marksOf(const Recording& recording);

// All takes of the list and those that they need, with the frames that are packed. Of scenes, nothing; of the
// rest, what is open and shown.
TakeFileContents contentsOf(const Recording& recording);

// The scenes that the contents name.
std::vector<SceneId> scenesNamed(const TakeFileContents& contents);

// Their takes, with the one that was open. Precondition: contents as readTakeFile() gives them, with at least
// one take.
struct LoadedTakes {
    std::vector<TakePointer> takes; // those that are not hidden
    TakePointer open;
    int shownFrame = 0;
    std::shared_ptr<const Scene> scene; // the user's when it was saved or, without it, of the last frame
};
LoadedTakes takesOf(const TakeFileContents& contents);

} // namespace clothlab
