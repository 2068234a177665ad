#include "simcore/scene/utf8.h"

#include <algorithm>

namespace clothlab {
namespace {

bool continues(char c) {
    return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U;
}

// Length of the character that text starts with, 0 if it is none.
std::size_t characterLength(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    const auto follow = [&](std::size_t count) {
        return text.size() > count &&
               std::all_of(text.begin() + 1, text.begin() + 1 + std::ptrdiff_t(count), continues);
    };
    const unsigned first = byte(0);
    const unsigned second = byte(1);
    if (first < 0x80)
        return first == 0 ? 0 : 1;
    if (first < 0xC2 || first > 0xF4)
        return 0;
    if (first < 0xE0)
        return follow(1) ? 2 : 0;
    // Longer than needed, a surrogate, or beyond Unicode.
    if ((first == 0xE0 && second < 0xA0) || (first == 0xED && second >= 0xA0) ||
        (first == 0xF0 && second < 0x90) || (first == 0xF4 && second >= 0x90))
        return 0;
    if (first < 0xF0)
        return follow(2) ? 3 : 0;
    return follow(3) ? 4 : 0;
}

} // namespace

std::size_t firstNotUtf8(std::string_view text) {
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t length = characterLength(text.substr(at));
        if (length == 0)
            break;
        at += length;
    }
    return at;
}

std::size_t characterCount(std::string_view text) {
    return text.size() - static_cast<std::size_t>(std::count_if(text.begin(), text.end(), continues));
}

std::string shortened(std::string_view text) {
    constexpr std::size_t kMostBytes = 40;
    std::size_t end = std::min(text.size(), kMostBytes);
    while (end > 0 && end < text.size() && continues(text[end]))
        --end;
    std::string result(text.substr(0, end));
    std::replace_if(
        result.begin(), result.end(), [](unsigned char c) { return c < 0x20 || c == 0x7F; }, ' ');
    return end < text.size() ? result + "…" : result;
}

} // namespace clothlab
