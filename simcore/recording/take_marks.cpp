#include "simcore/recording/take_marks.h"

#include <algorithm>
#include <utility>

namespace clothlab {

const Marker* findMarker(const TakeMarks& marks, int frame) {
    const auto found = std::ranges::lower_bound(marks.markers, frame, {}, &Marker::frame);
    return found != marks.markers.end() && found->frame == frame ? &*found : nullptr;
}

void setMarker(TakeMarks& marks, Marker marker) {
    removeMarker(marks, marker.frame);
    const auto place = std::ranges::lower_bound(marks.markers, marker.frame, {}, &Marker::frame);
    marks.markers.insert(place, std::move(marker));
}

void removeMarker(TakeMarks& marks, int frame) {
    std::erase_if(marks.markers, [frame](const Marker& marker) { return marker.frame == frame; });
}

} // namespace clothlab
