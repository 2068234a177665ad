#include "simcore/recording/chunk_walk.h"

#include <algorithm>

namespace clothlab {
namespace {

constexpr std::uint64_t kMostHeadBytes = std::uint64_t(64) << 20U;
constexpr std::size_t kReadAhead = 4096; // most heads are shorter
constexpr std::size_t kWindow = std::size_t(1) << 20U;

class Walker {
public:
    explicit Walker(const SharedFile& file) : m_file(file), m_size(file.size()) { readIndex(); }

    std::uint64_t size() const { return m_size; }

    // The chunk that begins there, if it is good. Its head is valid until the next call.
    std::optional<FoundChunk> chunkAt(std::uint64_t at) {
        if (at > m_size || m_size - at < kChunkHeaderBytes)
            return std::nullopt;
        m_bytes.resize(std::size_t(std::min<std::uint64_t>(kReadAhead, m_size - at)));
        if (!m_file.read(at, m_bytes.data(), m_bytes.size()))
            return std::nullopt;
        const auto header = readChunkHeader(m_bytes);
        const std::uint64_t left = m_size - at - kChunkHeaderBytes;
        if (!header || header->headLength > std::min(left, kMostHeadBytes) ||
            header->payloadLength > left - header->headLength)
            return std::nullopt;
        const std::uint64_t length = kChunkHeaderBytes + header->headLength;
        const std::size_t had = m_bytes.size();
        m_bytes.resize(std::size_t(length));
        if (length > had && !m_file.read(at + had, &m_bytes[had], std::size_t(length) - had))
            return std::nullopt;
        const std::string_view head = std::string_view(m_bytes).substr(kChunkHeaderBytes);
        if (!matches(m_bytes, *header, head))
            return std::nullopt;
        return FoundChunk{at, ChunkType{header->type}, head, at + length, header->payloadLength};
    }

    // Where the next good chunk after `at` begins; the file's size if there is none.
    std::uint64_t nextAfter(std::uint64_t at) {
        const auto listed = std::upper_bound(m_index.begin(), m_index.end(), at);
        for (auto it = listed; it != m_index.end(); ++it)
            if (chunkAt(*it))
                return *it;
        return listed != m_index.end() ? m_size : scan(at + 1);
    }

private:
    void readIndex() {
        if (m_size < kFileHeaderBytes + kTrailerBytes)
            return;
        std::string bytes(kTrailerBytes, '\0');
        if (!m_file.read(m_size - kTrailerBytes, bytes.data(), bytes.size()))
            return;
        const auto at = readTrailer(bytes);
        if (!at)
            return;
        const auto chunk = chunkAt(*at);
        if (!chunk || chunk->type != ChunkType::Index || chunk->end() != m_size)
            return;
        m_index = readIndexHead(chunk->head).value_or(std::vector<std::uint64_t>());
        m_index.push_back(*at);
        std::sort(m_index.begin(), m_index.end());
    }

    std::uint64_t scan(std::uint64_t from) {
        std::string window;
        while (from < m_size) {
            window.resize(std::size_t(std::min<std::uint64_t>(kWindow, m_size - from)));
            if (!m_file.read(from, window.data(), window.size()))
                return m_size;
            for (auto found = window.find(kChunkMagic); found != std::string::npos;
                 found = window.find(kChunkMagic, found + 1))
                if (chunkAt(from + found))
                    return from + found;
            if (window.size() < kWindow)
                return m_size;
            from += window.size() - (kChunkMagic.size() - 1);
        }
        return m_size;
    }

    const SharedFile& m_file;
    std::uint64_t m_size;
    std::vector<std::uint64_t> m_index; // where chunks begin, as far as the file says
    std::string m_bytes;
};

} // namespace

ChunkWalk walkChunks(const SharedFile& file, const std::function<void(const FoundChunk&)>& use) {
    Walker walker(file);
    ChunkWalk walk;
    std::uint64_t at = kFileHeaderBytes;
    while (at < walker.size()) {
        const auto chunk = walker.chunkAt(at);
        if (!chunk) {
            const std::uint64_t next = walker.nextAfter(at);
            walk.damaged.push_back({at, next});
            at = next;
            continue;
        }
        at = walk.end = chunk->end();
        walk.finished = chunk->type == ChunkType::Index && at == walker.size();
        use(*chunk);
    }
    return walk;
}

} // namespace clothlab
