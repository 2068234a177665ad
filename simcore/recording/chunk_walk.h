// The good chunks of a file, and where there are others.
#pragma once

#include "simcore/recording/chunk_heads.h"

#include <functional>

namespace clothlab {

struct FoundChunk {
    std::uint64_t at = 0; // in the file
    ChunkType type{};     // may be one that this version does not know
    std::string_view head;
    std::uint64_t payloadAt = 0;
    std::uint64_t payloadLength = 0;
    std::uint64_t end() const { return payloadAt + payloadLength; }
};

struct DamagedPart {
    std::uint64_t begin = 0;
    std::uint64_t end = 0; // of the file: nothing good comes after it
};

struct ChunkWalk {
    std::vector<DamagedPart> damaged;
    std::uint64_t end = kFileHeaderBytes; // of the last good chunk
    bool finished = false;                // the last good chunk is an index at the end of the file
};

// Calls use with each good chunk from the file's header on, in order. Where one is damaged, goes on with the
// next that the index lists or, if there is none, the next there is. Payloads are not read.
ChunkWalk walkChunks(const SharedFile& file, const std::function<void(const FoundChunk&)>& use);

} // namespace clothlab
