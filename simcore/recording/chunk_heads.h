// The heads of chunks, read back. Nothing that they say is believed before it is checked.
#pragma once

#include "simcore/recording/take_chunks.h"

namespace clothlab {

// In front of a file and of each chunk, and at the end of a finished file.
std::string fileHeader();
enum class FileHeaderCheck { Good, TooShort, NoTakeFile, Newer, Damaged };
FileHeaderCheck checkFileHeader(std::string_view bytes, std::uint32_t& version);

inline constexpr std::string_view kChunkMagic = "CTCK";
std::string chunkHeader(const Chunk& chunk);
struct ChunkHeader {
    std::uint32_t type = 0;
    std::uint32_t headLength = 0;
    std::uint64_t payloadLength = 0;
    std::uint64_t checksum = 0;
};
std::optional<ChunkHeader> readChunkHeader(std::string_view bytes); // checks its magic alone
// Whether header and head are what was written.
bool matches(std::string_view header, const ChunkHeader& fields, std::string_view head);

std::string trailer(std::uint64_t indexAt);
std::optional<std::uint64_t> readTrailer(std::string_view bytes); // where the index begins

struct SceneHead {
    SceneId id = 0;
    std::string json;
};
std::optional<SceneHead> readSceneHead(std::string_view head);

struct TakeHead {
    TakeInfo info;
    bool removed = false;
};
std::optional<TakeHead> readTakeHead(std::string_view head);

// Without payloads, whose length is checked against what the head says of it.
std::optional<FrameGroup> readFramesHead(std::string_view head, std::uint64_t payloadLength);
std::optional<Checkpoint> readCheckpointHead(std::string_view head, std::uint64_t payloadLength);

std::optional<std::vector<std::uint64_t>> readIndexHead(std::string_view head);

} // namespace clothlab
