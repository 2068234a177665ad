#include "simcore/recording/payload.h"

#include "simcore/base/checksum.h"

#include <utility>

namespace clothlab {

Payload::Payload(std::string bytes)
    : m_length(bytes.size()), m_memory(std::make_shared<const std::string>(std::move(bytes))) {}

Payload::Payload(std::shared_ptr<const SharedFile> file, std::uint64_t offset, std::uint64_t length)
    : m_length(length), m_file(std::move(file)), m_offset(offset) {}

std::size_t Payload::bytesInMemory() const {
    const std::scoped_lock lock(m_mutex);
    return m_memory ? m_memory->size() : 0;
}

bool Payload::inFile() const {
    const std::scoped_lock lock(m_mutex);
    return m_file != nullptr;
}

std::optional<std::string> Payload::read(std::uint64_t from, std::uint64_t count) const {
    if (from > m_length || count > m_length - from)
        return std::nullopt;
    std::shared_ptr<const std::string> memory;
    std::shared_ptr<const SharedFile> file;
    std::uint64_t offset = 0;
    { // reading a disk may take long
        const std::scoped_lock lock(m_mutex);
        memory = m_memory;
        file = m_file;
        offset = m_offset;
    }
    if (memory)
        return memory->substr(std::size_t(from), std::size_t(count));
    // What a file says of itself must not make us ask for more memory than the file has bytes.
    if (!file || offset + from + count < offset || offset + from + count > file->size())
        return std::nullopt;
    std::string bytes(std::size_t(count), '\0');
    if (!file->read(offset + from, bytes.data(), bytes.size()))
        return std::nullopt;
    return bytes;
}

void Payload::placeInFile(std::shared_ptr<const SharedFile> file, std::uint64_t offset) {
    const std::scoped_lock lock(m_mutex);
    m_file = std::move(file);
    m_offset = offset;
}

std::size_t Payload::release() {
    const std::scoped_lock lock(m_mutex);
    if (!m_file || !m_memory)
        return 0;
    m_memory.reset();
    return std::size_t(m_length);
}

std::optional<std::string> Blob::read(const Payload& payload) const {
    std::optional<std::string> bytes = payload.read(offset, length);
    if (bytes && clothlab::checksum(*bytes) != checksum)
        bytes.reset();
    return bytes;
}

} // namespace clothlab
