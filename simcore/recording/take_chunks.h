// The chunks of a .clothtake file. docs/clothtake.md has the format.
#pragma once

#include "simcore/recording/take_meta.h"

#include <cstdint>
#include <iosfwd>
#include <optional>
#include <string>
#include <vector>

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

// What is in memory is what is in the file, after a header of its own. The payload is read only when it is
// needed; what a chunk says of it is in its head.
struct Chunk {
    ChunkType type{};
    std::string head;
    std::string payload;
};

inline constexpr std::uint32_t kTakeFileVersion = 1;
inline constexpr std::uint64_t kFileHeaderBytes = 24;
inline constexpr std::uint64_t kChunkHeaderBytes = 32;
inline constexpr std::uint64_t kTrailerBytes = 24; // the payload of the index

inline std::uint64_t sizeOf(const Chunk& chunk) { // in the file
    return kChunkHeaderBytes + chunk.head.size() + chunk.payload.size();
}
// Where its payload begins, from where the chunk begins.
inline std::uint64_t payloadOffset(const Chunk& chunk) {
    return kChunkHeaderBytes + chunk.head.size();
}

Chunk sceneChunk(SceneId id, const Scene& scene); // precondition: validate() finds no errors
Chunk takeChunk(const TakeInfo& take);            // takes the place of an earlier one of the same take
Chunk removedTakeChunk(TakeId take);              // the take is gone; no branch may need it
Chunk metaChunk(const TakeMeta& meta);            // takes the place of an earlier one
// Nothing if the payload cannot be read.
std::optional<Chunk> chunkOf(const FrameGroup& group);
std::optional<Chunk> chunkOf(const Checkpoint& checkpoint);

// Writes chunks to a stream, which it does not own. Trouble of the stream is the stream's to tell.
class TakeFileWriter {
public:
    // At the start of a new file: writes its header. Or at the end of one that is there, `at` being its
    // length and `chunks` where those begin that it has.
    explicit TakeFileWriter(std::ostream& out);
    TakeFileWriter(std::ostream& out, std::uint64_t at, std::vector<std::uint64_t> chunks);

    std::uint64_t add(const Chunk& chunk);      // returns where it begins in the file
    std::uint64_t size() const { return m_at; } // of the file so far
    void finish();                              // writes the index; more may be added after it

private:
    std::ostream& m_out;
    std::uint64_t m_at = 0;
    std::vector<std::uint64_t> m_chunks; // where they begin
};

} // namespace clothlab
