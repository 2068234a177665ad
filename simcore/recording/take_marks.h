// What the user marks in a take: frames by name, and the part of it to play.
#pragma once

#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace clothlab {

struct Marker {
    int frame = 0;
    std::string name;
    friend bool operator==(const Marker&, const Marker&) = default;
};

// The out point of a range that goes on to the last frame, however many there will be.
inline constexpr int kOpenEnd = std::numeric_limits<int>::max();

// In and out points, both included; in <= out.
struct InOutPoints {
    int in = 0;
    int out = kOpenEnd;
    friend bool operator==(const InOutPoints&, const InOutPoints&) = default;
};

struct TakeMarks {
    std::vector<Marker> markers; // by frame, at most one a frame
    std::optional<InOutPoints> range;
    friend bool operator==(const TakeMarks&, const TakeMarks&) = default;
};

// The marker of a frame; null if there is none.
const Marker* findMarker(const TakeMarks& marks, int frame);
// Puts it in its place; one that is at that frame goes.
void setMarker(TakeMarks& marks, Marker marker);
void removeMarker(TakeMarks& marks, int frame);

} // namespace clothlab
