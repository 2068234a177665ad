// Reading and writing whole files. A file is written whole or not at all.
#pragma once

#include "simcore/base/diagnostic.h"

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <optional>
#include <string>

namespace clothlab {

// The bytes of a regular file of at most maxBytes; otherwise a diagnostic that says why not.
struct FileText {
    std::optional<std::string> text;
    Diagnostics diagnostics;
};
FileText readFile(const std::string& path, std::uint64_t maxBytes);

// Calls write with a stream to a new file beside path and then renames it over path, so that a reader or
// a crash sees the old file or the new one. Follows a symbolic link; keeps the permissions of an existing
// file. Returns what went wrong, in words; the file at path is then as it was.
std::optional<std::string> writeFileWhole(const std::string& path,
                                          const std::function<void(std::ostream&)>& write);

} // namespace clothlab
