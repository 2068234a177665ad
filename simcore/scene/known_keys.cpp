#include "simcore/scene/known_keys.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace clothlab {
namespace {

char lower(char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c + ('a' - 'A')) : c;
}

// Levenshtein 1966: how many letters to insert, remove or replace, in either case.
std::size_t editDistance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j)
        row[j] = j;
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t replaced = diagonal + (lower(a[i]) == lower(b[j]) ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({replaced, diagonal + 1, row[j] + 1});
        }
    }
    return row.back();
}

} // namespace

bool isKnown(std::string_view key, Keys keys) {
    return std::ranges::find(keys, key) != keys.end();
}

std::string_view closestKey(std::string_view key, Keys keys) {
    constexpr std::size_t kLongest = 40;
    std::string_view closest;
    if (key.size() > kLongest)
        return closest;
    std::size_t least = 4; // letters; a short key may differ by half of it
    for (const std::string_view candidate : keys) {
        const std::size_t distance = editDistance(key, candidate);
        if (distance < least && 2 * distance <= std::min(key.size(), candidate.size())) {
            least = distance;
            closest = candidate;
        }
    }
    return closest;
}

} // namespace clothlab
