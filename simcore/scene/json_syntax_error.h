// Why a text is not JSON, in words for whoever wrote it. Each offset is that of the token at fault.
#pragma once

#include "simcore/base/diagnostic.h"

#include <cstddef>
#include <string_view>

namespace clothlab::json {

enum class Expected { Value, Key, Colon, CommaOrBrace, CommaOrBracket, End };

Diagnostic describeUnexpected(std::string_view text, std::size_t offset, Expected expected);
Diagnostic describeUnclosedString(std::string_view text, std::size_t offset);
Diagnostic describeControlCharacter(std::string_view text, std::size_t offset); // in a string
Diagnostic describeEscape(std::string_view text, std::size_t offset);           // of the backslash
Diagnostic describeNumberOverflow(std::string_view text, std::size_t offset);

// "line 3, column 7"
std::string placeOf(std::string_view text, std::size_t offset);

} // namespace clothlab::json
