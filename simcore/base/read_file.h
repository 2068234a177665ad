// Reading whole files.
#pragma once

#include "simcore/base/diagnostic.h"

#include <cstdint>
#include <optional>
#include <string>

namespace clothlab {

// The bytes of a regular file of at most maxBytes; otherwise a diagnostic that says why not.
struct FileText {
    std::optional<std::string> text;
    Diagnostics diagnostics;
};
FileText readFile(const std::string& path, std::uint64_t maxBytes);

} // namespace clothlab
