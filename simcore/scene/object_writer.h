// The text of objects and lists. What they hold is made before them, so each is told how deep it will stand.
#pragma once

#include "simcore/base/vec3.h"

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace clothlab {

struct Entry {
    std::string key; // with quotes
    std::string value;
};
using Entries = std::vector<Entry>;

std::string objectText(const Entries& entries, int level);
std::string listText(const std::vector<std::string>& elements, int level);
std::string flagText(bool value);
std::string tripleText(const std::array<double, 3>& numbers);
std::string tripleText(const Vec3& v);

void add(Entries& entries, std::string_view key, std::string value);
// The members of the text of an object; of none if it is empty.
void addUnknown(Entries& entries, const std::string& unknownKeys);

} // namespace clothlab
