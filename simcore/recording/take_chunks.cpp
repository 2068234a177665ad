#include "simcore/recording/take_chunks.h"

#include "simcore/base/little_endian.h"
#include "simcore/recording/chunk_heads.h"
#include "simcore/recording/compression.h"
#include "simcore/scene/scene_io.h"

#include <ostream>
#include <utility>

namespace clothlab {
namespace {

void append(std::string& bytes, const FrameFacts& facts) {
    appendLittleEndian(bytes, facts.time);
    appendLittleEndian(bytes, facts.milliseconds);
    appendLittleEndian(bytes, facts.strainLimitCorrections);
    appendLittleEndian(bytes, facts.stateHash);
    appendLittleEndian(bytes, facts.kineticEnergy);
    appendLittleEndian(bytes, facts.greatestStrain);
    appendLittleEndian(bytes, facts.contacts);
}

void append(std::string& bytes, const Grid& grid) {
    appendLittleEndian(bytes, std::uint32_t(grid.width));
    appendLittleEndian(bytes, std::uint32_t(grid.height));
}

std::string takeHead(const TakeInfo& take, bool removed) {
    std::string head;
    appendLittleEndian(head, take.id);
    appendLittleEndian(head, take.parent);
    appendLittleEndian(head, std::int32_t(take.branchFrame));
    appendLittleEndian(head, std::uint8_t((take.hidden ? 1U : 0U) | (removed ? 2U : 0U)));
    return head + take.name;
}

} // namespace

Chunk sceneChunk(SceneId id, const Scene& scene) {
    Chunk chunk{ChunkType::Scene, {}, {}};
    appendLittleEndian(chunk.head, id);
    chunk.head += compressedText(writeScene(scene));
    return chunk;
}

Chunk takeChunk(const TakeInfo& take) {
    return {ChunkType::Take, takeHead(take, false), {}};
}

Chunk removedTakeChunk(TakeId take) {
    return {ChunkType::Take, takeHead({take, 0, 0, {}, false}, true), {}};
}

Chunk metaChunk(const TakeMeta& meta) {
    return {ChunkType::Meta, writeMeta(meta), {}};
}

std::optional<Chunk> chunkOf(const FrameGroup& group) {
    std::optional<std::string> payload = group.payload->read(0, group.payload->length());
    if (!payload)
        return std::nullopt;
    Chunk chunk{ChunkType::Frames, {}, std::move(*payload)};
    appendLittleEndian(chunk.head, group.take);
    appendLittleEndian(chunk.head, std::int32_t(group.first));
    appendLittleEndian(chunk.head, group.error);
    append(chunk.head, group.grid);
    appendLittleEndian(chunk.head, std::uint8_t(group.frames.size()));
    appendLittleEndian(chunk.head, std::uint8_t(group.frames.size() + group.beyond.size()));
    for (const auto* entries : {&group.frames, &group.beyond})
        for (const FrameEntry& entry : *entries) {
            append(chunk.head, entry.facts);
            appendLittleEndian(chunk.head, entry.scene);
            appendLittleEndian(chunk.head, std::uint32_t(entry.blob.length));
            appendLittleEndian(chunk.head, entry.blob.checksum);
        }
    return chunk;
}

std::optional<Chunk> chunkOf(const Checkpoint& checkpoint) {
    std::optional<std::string> payload = checkpoint.payload->read(0, checkpoint.payload->length());
    if (!payload)
        return std::nullopt;
    Chunk chunk{ChunkType::Checkpoint, {}, std::move(*payload)};
    appendLittleEndian(chunk.head, checkpoint.take);
    appendLittleEndian(chunk.head, std::int32_t(checkpoint.frame));
    append(chunk.head, checkpoint.grid);
    appendLittleEndian(chunk.head, checkpoint.blob.checksum);
    return chunk;
}

TakeFileWriter::TakeFileWriter(std::ostream& out) : m_out(out) {
    const std::string header = fileHeader();
    m_out.write(header.data(), std::streamsize(header.size()));
    m_at = header.size();
}

TakeFileWriter::TakeFileWriter(std::ostream& out, std::uint64_t at, std::vector<std::uint64_t> chunks)
    : m_out(out), m_at(at), m_chunks(std::move(chunks)) {}

std::uint64_t TakeFileWriter::add(const Chunk& chunk) {
    const std::string header = chunkHeader(chunk);
    for (const std::string* part : {&header, &chunk.head, &chunk.payload})
        m_out.write(part->data(), std::streamsize(part->size()));
    m_chunks.push_back(m_at);
    m_at += sizeOf(chunk);
    return m_chunks.back();
}

void TakeFileWriter::finish() {
    Chunk index{ChunkType::Index, {}, trailer(m_at)};
    for (const std::uint64_t at : m_chunks)
        appendLittleEndian(index.head, at);
    add(index);
    m_chunks.pop_back(); // an index is none of its own, nor of those after it
}

} // namespace clothlab
