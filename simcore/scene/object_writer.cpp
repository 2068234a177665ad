#include "simcore/scene/object_writer.h"

#include "simcore/scene/json_text.h"

#include <utility>

namespace clothlab {
namespace {

std::string newLine(int level) {
    return "\n" + std::string(static_cast<std::size_t>(2 * level), ' ');
}

} // namespace

std::string objectText(const Entries& entries, int level) {
    std::string text = "{";
    for (const Entry& entry : entries) {
        text += text.size() > 1 ? "," : "";
        text += newLine(level + 1) + entry.key + ": " + entry.value;
    }
    return text + (entries.empty() ? "" : newLine(level)) + "}";
}

std::string listText(const std::vector<std::string>& elements, int level) {
    std::string text = "[";
    for (const std::string& element : elements) {
        text += text.size() > 1 ? "," : "";
        text += newLine(level + 1) + element;
    }
    return text + (elements.empty() ? "" : newLine(level)) + "]";
}

std::string flagText(bool value) {
    return value ? "true" : "false";
}

std::string tripleText(const std::array<double, 3>& numbers) {
    return "[" + json::numberText(numbers[0]) + ", " + json::numberText(numbers[1]) + ", " +
           json::numberText(numbers[2]) + "]";
}

std::string tripleText(const Vec3& v) {
    return tripleText(std::array{v.x(), v.y(), v.z()});
}

void add(Entries& entries, std::string_view key, std::string value) {
    entries.push_back({json::quoted(key), std::move(value)});
}

// On one line each: indenting what is nested could make a file many times longer.
void addUnknown(Entries& entries, const std::string& unknownKeys) {
    if (unknownKeys.empty())
        return;
    for (const json::Member& member : json::members(json::parse(unknownKeys)))
        entries.push_back({std::string(member.keyText), json::spaced(member.value.text)});
}

} // namespace clothlab
