#pragma once

#include "simcore/base/diagnostic.h"

#include <cstddef>
#include <optional>
#include <string_view>

namespace clothlab::json {

inline constexpr int kMaxLevels = 64;
inline constexpr std::size_t kMaxKeys = 100'000; // of the objects that are open at one place of the text

// The first thing that keeps text from being UTF-8 JSON (RFC 8259) with distinct keys in each object, at
// most kMaxLevels levels, no zero bytes, and numbers that a double can hold. A place is a line and a
// column, in characters, or for keys and levels the path of keys. Text without a byte order mark.
std::optional<Diagnostic> checkJson(std::string_view text);

} // namespace clothlab::json
