// Writing files whole or not at all.
#pragma once

#include <cstdint>
#include <functional>
#include <iosfwd>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace clothlab {

// Calls write with a stream to a new file beside path and then renames it over path, so that a reader or
// a crash sees the old file or the new one. Follows a symbolic link; keeps the permissions of an existing
// file. Returns what went wrong, in words; the file at path is then as it was.
std::optional<std::string> writeFileWhole(const std::string& path,
                                          const std::function<void(std::ostream&)>& write);

// The same for a file that grows piece by piece: until finish() nothing is at its path but what was there
// before, and what is not finished is gone. Functions return what went wrong, in words.
class WholeFile {
public:
    WholeFile();
    ~WholeFile();
    WholeFile(const WholeFile&) = delete;
    WholeFile& operator=(const WholeFile&) = delete;

    std::optional<std::string> open(const std::string& path);

    // The rest only after open() went well.
    std::ostream& out();
    std::optional<std::string> trouble() const; // of what was written so far, as far as it is known yet
    std::optional<std::string> skip(std::uint64_t count); // zeros, which take no place on most disks
    // Writes over bytes that are there.
    std::optional<std::string> replace(std::uint64_t offset, std::string_view bytes);
    // Takes bytes out; those after them move up.
    std::optional<std::string> remove(std::uint64_t offset, std::uint64_t count);
    std::optional<std::string> finish();
    // Where the bytes are until then: for another program that writes them instead of out().
    const std::string& temporaryPath() const;

private:
    struct Open;
    std::unique_ptr<Open> m_file;
};

} // namespace clothlab
