// The library's parser knows where it stopped; these say why, in words for whoever wrote the file.
#pragma once

#include "simcore/base/diagnostic.h"

#include <string_view>

namespace clothlab::json {

// position: how many bytes the parser had read when it gave up; may be one past the end.
// finished: the value of the text was complete before that.
Diagnostic describeSyntaxError(std::string_view text, std::size_t position, bool finished);

Diagnostic describeNumberOverflow(std::string_view text, std::size_t position);

} // namespace clothlab::json
