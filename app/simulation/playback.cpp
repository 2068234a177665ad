#include "app/simulation/playback.h"

#include <algorithm>
#include <cmath>

namespace clothlab {
namespace {

constexpr double kShortestFrame = 1e-5; // s
constexpr double kMostLate = 10'000;    // ms; more is not playing any more, but a machine that slept

bool isOpen(const std::optional<InOutPoints>& range) {
    return !range || range->out == kOpenEnd;
}

} // namespace

double fasterThan(double speed) {
    const auto* next = std::ranges::upper_bound(kSpeeds, speed);
    return next == kSpeeds.end() ? kSpeeds.back() : *next;
}

double slowerThan(double speed) {
    const auto* next = std::ranges::lower_bound(kSpeeds, speed);
    return next == kSpeeds.begin() ? kSpeeds.front() : *std::prev(next);
}

void Playback::setSettings(const PlaybackSettings& settings, double now) {
    if (m_due > now)
        m_due = now + (m_due - now) * m_settings.speed / settings.speed;
    m_settings = settings;
}

// Of what is played without recording.
Playback::Limits Playback::limits(const Played& played) const {
    const InOutPoints range = played.range.value_or(InOutPoints{});
    if (m_settings.repeat == Repeat::Once)
        return {m_keepsToRange ? range.in : 0, played.lastFrame};
    return {range.in, std::min(range.out, played.lastFrame)};
}

std::optional<int> Playback::begin(Direction direction, int current, const Played& played, double now) {
    m_direction = direction;
    m_due = now;
    if (records()) {
        m_keepsToRange = !isOpen(played.range) && current < played.range->out;
        return std::min(current, played.endOfRun);
    }
    m_keepsToRange = played.range && current >= played.range->in;
    const Limits within = limits(played);
    if (within.first >= within.last)
        return std::nullopt;
    const bool forward = direction == Direction::Forward;
    const bool atItsEnd = current == (forward ? within.last : within.first);
    const bool turnsRound = m_settings.repeat == Repeat::PingPong;
    if (current >= within.first && current <= within.last && (!atItsEnd || turnsRound))
        return current;
    // There is nothing in that direction: from the other end.
    int start = forward ? within.first : within.last;
    if (!forward && m_keepsToRange)
        start = std::min(start, played.range->out);
    if (start == current)
        return std::nullopt;
    m_due = now + interval(start, forward ? start + 1 : start - 1, played);
    return start;
}

double Playback::interval(int from, int to, const Played& played) const {
    if (std::abs(to - from) != 1) // from one end to the other: as long as the frame before
        to = from > to ? from - 1 : from + 1;
    const int later = std::max(from, to);
    const bool isNew = later > played.lastFrame || (records() && later > played.endOfRun);
    double seconds = isNew ? played.newFrame : std::abs(played.time(to) - played.time(from));
    if (!(seconds >= kShortestFrame) || !std::isfinite(seconds)) // a file may say anything
        seconds = std::max(kShortestFrame, played.newFrame);
    return 1000 * seconds / m_settings.speed;
}

std::optional<int> Playback::after(int frame, const Played& played) {
    if (records()) {
        const bool stops = m_keepsToRange && !isOpen(played.range) && frame >= played.range->out;
        return stops ? std::nullopt : std::optional(frame + 1);
    }
    const auto [first, last] = limits(played);
    if (first >= last)
        return std::nullopt;
    const auto next = [&] { return m_direction == Direction::Forward ? frame + 1 : frame - 1; };
    if (next() >= first && next() <= last)
        return next();
    switch (m_settings.repeat) {
    case Repeat::Once:
        return std::nullopt;
    case Repeat::Loop:
        return m_direction == Direction::Forward ? first : last;
    case Repeat::PingPong:
        m_direction = frame >= last ? Direction::Backward : Direction::Forward;
        return std::clamp(next(), first, last);
    }
    return std::nullopt;
}

Playback::Step Playback::step(int frame, const Played& played, double now) {
    m_due = std::max(m_due, now - kMostLate);
    while (true) {
        const std::optional<int> next = after(frame, played);
        const bool isNew = next && records() && *next > played.endOfRun;
        if (!next || isNew || !isDue(now))
            return {frame, !next, isNew, m_due};
        frame = *next;
        const std::optional<int> following = after(frame, played);
        if (!following)
            return {frame, true, false, m_due};
        m_due += interval(frame, *following, played);
        // What is late is made up for by leaving frames out, or not at all.
        const bool followingIsNew = records() && *following > played.endOfRun;
        if (m_settings.realTime && !followingIsNew)
            continue;
        m_due = std::max(m_due, now);
        return {frame, false, followingIsNew, m_due};
    }
}

} // namespace clothlab
