// The chunks of a .clothtake file. docs/clothtake.md has the format.
#pragma once

#include "simcore/recording/take_meta.h"

#include <iosfwd>

namespace clothlab {

// By the four letters that are in the file.
enum class ChunkType : std::uint32_t {
    Scene = 0x4E454353,      // "SCEN"
    Take = 0x454B4154,       // "TAKE"
    Frames = 0x4D415246,     // "FRAM"
    Checkpoint = 0x54504B43, // "CKPT"
    Meta = 0x4154454D,       // "META"
    Index = 0x58444E49,      // "INDX"
};

// What is in memory is what is in the file, after a head of its own.
struct Chunk {
    ChunkType type{};
    std::string head;
    std::string payload;
};

inline constexpr std::uint64_t kChunkHeaderBytes = 32;
std::uint64_t sizeOf(const Chunk& chunk); // in the file
// Where its payload begins, from where the chunk begins.
inline std::uint64_t payloadOffset(const Chunk& chunk) {
    return kChunkHeaderBytes + chunk.head.size();
}

Chunk sceneChunk(SceneId id, const Scene& scene);
Chunk takeChunk(const TakeInfo& take); // takes the place of an earlier one of the same take
Chunk removedTakeChunk(TakeId take);   // the take and its frames are gone; no branch may need them
Chunk metaChunk(const TakeMeta& meta); // takes the place of an earlier one
// Nothing if the payload cannot be read.
std::optional<Chunk> chunkOf(const FrameGroup& group);
std::optional<Chunk> chunkOf(const Checkpoint& checkpoint);

// Writes chunks to a stream, which it does not own. Trouble of the stream is the stream's to tell.
class TakeFileWriter {
public:
    // At the start of a new file: writes its header. At the end of one that is there (`at` its length, chunks
    // those it has, as far as they are known): goes on.
    explicit TakeFileWriter(std::ostream& out);
    TakeFileWriter(std::ostream& out, std::uint64_t at, std::vector<std::uint64_t> chunks);

    std::uint64_t add(const Chunk& chunk);      // returns where it begins in the file
    std::uint64_t size() const { return m_at; } // of the file so far
    void finish();                              // writes index and trailer; more may be added after it

private:
    std::ostream& m_out;
    std::uint64_t m_at = 0;
    std::vector<std::uint64_t> m_chunks; // where they begin
};

} // namespace clothlab
