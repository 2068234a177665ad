// Bytes of a recording that are in memory, in a file, or both.
#pragma once

#include "simcore/base/shared_file.h"

#include <cstdint>
#include <memory>
#include <mutex>
#include <optional>
#include <string>

namespace clothlab {

// All functions may be called by several threads at the same time.
class Payload {
public:
    explicit Payload(std::string bytes);
    Payload(std::shared_ptr<const SharedFile> file, std::uint64_t offset, std::uint64_t length);

    std::uint64_t length() const { return m_length; }
    std::size_t bytesInMemory() const;
    bool inFile() const;

    // Nothing if they cannot be read, or are beyond the end. Not checked here: see Blob.
    std::optional<std::string> read(std::uint64_t from, std::uint64_t count) const;

    // The same bytes are there, too: written, and to be read from now on by whoever opens the file.
    void placeInFile(std::shared_ptr<const SharedFile> file, std::uint64_t offset);
    // Forgets what is in memory, if the bytes are in a file. Returns how many bytes that frees.
    std::size_t release();

private:
    std::uint64_t m_length;
    mutable std::mutex m_mutex;                  // guards the rest
    std::shared_ptr<const std::string> m_memory; // null: released
    std::shared_ptr<const SharedFile> m_file;    // null: only in memory
    std::uint64_t m_offset = 0;
};

// A part of a payload that is read alone.
struct Blob {
    std::uint64_t offset = 0; // in the payload
    std::uint64_t length = 0;
    std::uint64_t checksum = 0;

    // Nothing if it cannot be read or is not what was written.
    std::optional<std::string> read(const Payload& payload) const;
};

} // namespace clothlab
