// Which frame is to be shown next while playing, and when. Knows no clock and no recording: both are told.
#pragma once

#include "simcore/recording/take_marks.h"

#include <array>
#include <functional>
#include <optional>

namespace clothlab {

enum class Direction { Forward, Backward };
enum class Repeat { Once, Loop, PingPong };

struct PlaybackSettings {
    double speed = 1; // one of kSpeeds
    // Leaves frames out where there is no time to show them all; otherwise each is shown, however late.
    bool realTime = false;
    Repeat repeat = Repeat::Once;
    friend bool operator==(const PlaybackSettings&, const PlaybackSettings&) = default;
};

inline constexpr std::array<double, 7> kSpeeds{0.125, 0.25, 0.5, 1, 2, 4, 8};
double fasterThan(double speed); // the next of kSpeeds, or the last
double slowerThan(double speed);

// Played forward and once, a run goes on beyond its end: new frames are recorded, none is left out, and stale
// ones are not shown. It stops at the out point if it began before it. Everything else plays what is
// recorded, stale or not, and records nothing: backward as far as the in point if it began after it, loops
// between in and out point.
//
// Frames are as far apart as their times say, divided by the speed. Time is in milliseconds, from any moment.
class Playback {
public:
    // What there is to play.
    struct Played {
        int lastFrame = 0;
        int endOfRun = 0; // after it, the next frame is a new one
        std::optional<InOutPoints> range;
        std::function<double(int frame)> time; // simulated seconds
        double newFrame = 0.01;                // simulated seconds that one adds
    };

    const PlaybackSettings& settings() const { return m_settings; }
    void setSettings(const PlaybackSettings& settings, double now);

    // Which frame it starts from, which may not be the current one; nothing if there is nothing to play.
    std::optional<int> begin(Direction direction, int current, const Played& played, double now);
    bool isDue(double now) const { return now >= m_due - kEarly; } // the next frame

    struct Step {
        int frame = 0;        // to show now
        bool ended = false;   // and that was all
        bool records = false; // the frame after it is a new one
        double due = 0;       // of the frame after it
    };
    // May be called at any time. frame: that is shown.
    Step step(int frame, const Played& played, double now);

    bool records() const { return m_direction == Direction::Forward && m_settings.repeat == Repeat::Once; }
    Direction direction() const { return m_direction; } // of ping-pong, where it goes now

private:
    struct Limits {
        int first;
        int last;
    };
    Limits limits(const Played& played) const;
    std::optional<int> after(int frame, const Played& played);     // nothing: it ends; may turn round
    double interval(int from, int to, const Played& played) const; // ms

    static constexpr double kEarly = 0.5; // ms; timers are no better

    PlaybackSettings m_settings;
    Direction m_direction = Direction::Forward;
    bool m_keepsToRange = false; // played once: it stops at an end of the range
    double m_due = 0;
};

} // namespace clothlab
