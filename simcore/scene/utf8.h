#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace clothlab {

// Where text stops being UTF-8 (Unicode 15, table 3-7) without zero bytes; its size if it does not.
std::size_t firstNotUtf8(std::string_view text);
inline bool isUtf8(std::string_view text) {
    return firstNotUtf8(text) == text.size();
}

// Each of these for UTF-8.
std::size_t characterCount(std::string_view text);
// What a message shows, on one line, of text that may be long.
std::string shortened(std::string_view text);

} // namespace clothlab
