// Runs that are recorded as takes, to write, damage and read.
#pragma once

#include "simcore/recording/recording.h"
#include "simcore/recording/take_file.h"

#include <functional>

namespace clothlab::test {

// Frames 0 … frames of a run. edit: changes the scene with which frame number `frame` is computed; the sheet
// stays.
using SceneEdit = std::function<void(int frame, Scene& scene)>;
std::vector<FramePointer> runFrames(const Scene& scene, int frames, const SceneEdit& edit = {});
// The same from a state on: frames number first … last.
std::vector<FramePointer> runOn(const Frame& from, int first, int last, const SceneEdit& edit = {});

// Adds a take of these frames to the contents, with a checkpoint every checkpointEvery frames and at the end.
void addTake(TakeFileContents& contents, const TakeInfo& info, const std::vector<FramePointer>& frames,
             double error, int checkpointEvery = 60);

// Two takes, the second branching off frame 9 of the first, with an edit in each; small, on a 9 by 7 sheet.
struct TwoTakes {
    std::vector<FramePointer> first;  // frames 0 … 40
    std::vector<FramePointer> branch; // frames 10 … 30
    TakeFileContents contents;
};
TwoTakes twoTakes(double error);

std::string bytesOf(const TakeFileContents& contents); // of the file

// The greatest difference of a coordinate, m.
double greatestDifference(const PointArray& a, const PointArray& b);

} // namespace clothlab::test
