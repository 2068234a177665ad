#include "simcore/recording/take_meta.h"

#include "simcore/scene/json_check.h"
#include "simcore/scene/json_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace clothlab {
namespace {

using json::Type;

std::string member(std::string_view key, const std::string& value) {
    return json::quoted(key) + ": " + value;
}

std::string object(const std::vector<std::string>& members) {
    std::string text;
    for (const std::string& one : members)
        text += (text.empty() ? "" : ", ") + one;
    return "{" + text + "}";
}

template <typename Item, typename TextOf>
std::string list(const std::vector<Item>& items, TextOf textOf) {
    std::string text;
    for (const Item& item : items)
        text += (text.empty() ? "" : ", ") + textOf(item);
    return "[" + text + "]";
}

// Whole numbers from 0 on; `missing` for anything else.
template <typename Int>
Int wholeNumber(json::Value value, Int missing) {
    if (value.type() != Type::Number)
        return missing;
    const double number = value.number();
    const bool fits = number >= 0 && number <= double(std::numeric_limits<std::int32_t>::max()) &&
                      number == std::floor(number);
    return fits ? Int(number) : missing;
}

// Calls it with each object in an array.
template <typename Use>
void forEachObject(json::Value array, Use use) {
    if (array.type() != Type::Array)
        return;
    json::Elements elements(array);
    while (const auto element = elements.next())
        if (element->type() == Type::Object)
            use(json::members(*element));
}

void readMarkers(json::Value array, std::vector<FrameMarker>& markers) {
    forEachObject(array, [&](const std::vector<json::Member>& members) {
        FrameMarker marker{0, -1, {}};
        for (const json::Member& m : members) {
            if (m.key == "take")
                marker.take = wholeNumber(m.value, TakeId(0));
            else if (m.key == "frame")
                marker.frame = wholeNumber(m.value, -1);
            else if (m.key == "name" && m.value.type() == Type::String)
                marker.name = m.value.string();
        }
        if (marker.take != 0 && marker.frame >= 0)
            markers.push_back(std::move(marker));
    });
}

void readRanges(json::Value array, std::vector<PlayRange>& ranges) {
    forEachObject(array, [&](const std::vector<json::Member>& members) {
        PlayRange range{0, -1, -1};
        for (const json::Member& m : members) {
            if (m.key == "take")
                range.take = wholeNumber(m.value, TakeId(0));
            else if (m.key == "in")
                range.in = wholeNumber(m.value, -1);
            else if (m.key == "out")
                range.out = wholeNumber(m.value, -1);
        }
        if (range.take != 0 && range.in >= 0 && range.out >= range.in)
            ranges.push_back(range);
    });
}

// False if the key is none of ours.
bool readMember(const json::Member& m, TakeMeta& meta) {
    const bool isText = m.value.type() == Type::String;
    if (m.key == "program")
        meta.program = isText ? m.value.string() : meta.program;
    else if (m.key == "version")
        meta.version = isText ? m.value.string() : meta.version;
    else if (m.key == "error")
        meta.error =
            m.value.type() == Type::Number ? std::clamp(m.value.number(), 0.0, kGreatestError) : meta.error;
    else if (m.key == "active_take")
        meta.activeTake = wholeNumber(m.value, meta.activeTake);
    else if (m.key == "shown_frame")
        meta.shownFrame = wholeNumber(m.value, meta.shownFrame);
    else if (m.key == "scene")
        meta.scene = wholeNumber(m.value, meta.scene);
    else if (m.key == "markers")
        readMarkers(m.value, meta.markers);
    else if (m.key == "ranges")
        readRanges(m.value, meta.ranges);
    else
        return false;
    return true;
}

} // namespace

std::string writeMeta(const TakeMeta& meta) {
    const auto number = [](auto value) { return json::numberText(double(value)); };
    std::vector<std::string> members{
        member("program", json::quoted(meta.program)),
        member("version", json::quoted(meta.version)),
        member("error", number(meta.error)),
        member("active_take", number(meta.activeTake)),
        member("shown_frame", number(meta.shownFrame)),
        member("scene", number(meta.scene)),
        member("markers", list(meta.markers,
                               [&](const FrameMarker& marker) {
                                   return object({member("take", number(marker.take)),
                                                  member("frame", number(marker.frame)),
                                                  member("name", json::quoted(marker.name))});
                               })),
        member("ranges", list(meta.ranges, [&](const PlayRange& range) {
                   return object({member("take", number(range.take)), member("in", number(range.in)),
                                  member("out", number(range.out))});
               }))};
    if (!meta.unknownKeys.empty())
        for (const json::Member& m : json::members(json::parse(meta.unknownKeys)))
            members.push_back(member(m.key, std::string(m.value.text)));
    return object(members);
}

std::optional<TakeMeta> readMeta(std::string_view text) {
    if (json::checkJson(text))
        return std::nullopt;
    const json::Value value = json::parse(text);
    if (value.type() != Type::Object)
        return std::nullopt;
    TakeMeta meta;
    std::vector<std::string> unknown;
    for (const json::Member& m : json::members(value))
        if (!readMember(m, meta))
            unknown.push_back(std::string(m.keyText) + ": " + std::string(m.value.text));
    if (!unknown.empty())
        meta.unknownKeys = object(unknown);
    return meta;
}

} // namespace clothlab
