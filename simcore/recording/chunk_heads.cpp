#include "simcore/recording/chunk_heads.h"

#include "simcore/base/checksum.h"
#include "simcore/base/little_endian.h"
#include "simcore/recording/compression.h"
#include "simcore/scene/scene_io.h"

#include <cmath>
#include <limits>

namespace clothlab {
namespace {

constexpr std::string_view kFileMagic = "CLTHTAKE";
constexpr std::string_view kTrailerMagic = "CLTHDONE";
constexpr std::uint8_t kHidden = 1, kRemoved = 2;

FrameFacts readFacts(LittleEndianReader& reader) {
    FrameFacts facts;
    facts.time = reader.read<double>();
    facts.milliseconds = reader.read<double>();
    facts.strainLimitCorrections = reader.read<std::int64_t>();
    facts.stateHash = reader.read<std::uint64_t>();
    facts.kineticEnergy = reader.read<double>();
    facts.greatestStrain = reader.read<double>();
    facts.contacts = reader.read<std::int64_t>();
    return facts;
}

std::optional<Grid> readGrid(LittleEndianReader& reader) {
    const auto width = reader.read<std::uint32_t>();
    const auto height = reader.read<std::uint32_t>();
    if (width < 1 || height < 1 || std::uint64_t(width) * height > kMaxPoints)
        return std::nullopt;
    return Grid{int(width), int(height)};
}

} // namespace

std::string fileHeader() {
    std::string bytes(kFileMagic);
    appendLittleEndian(bytes, kTakeFileVersion);
    appendLittleEndian(bytes, std::uint32_t(0)); // flags, of which there are none yet
    appendLittleEndian(bytes, checksum(bytes));
    return bytes;
}

FileHeaderCheck checkFileHeader(std::string_view bytes, std::uint32_t& version) {
    const std::string_view magic = bytes.substr(0, kFileMagic.size());
    if (magic != kFileMagic.substr(0, magic.size()))
        return FileHeaderCheck::NoTakeFile;
    if (bytes.size() < kFileHeaderBytes)
        return FileHeaderCheck::TooShort;
    LittleEndianReader reader(bytes.substr(kFileMagic.size()));
    version = reader.read<std::uint32_t>();
    const auto flags = reader.read<std::uint32_t>();
    if (reader.read<std::uint64_t>() != checksum(bytes.substr(0, kFileHeaderBytes - 8)))
        return FileHeaderCheck::Damaged;
    return version > kTakeFileVersion || flags != 0 ? FileHeaderCheck::Newer : FileHeaderCheck::Good;
}

std::string chunkHeader(const Chunk& chunk) {
    std::string bytes(kChunkMagic);
    appendLittleEndian(bytes, static_cast<std::uint32_t>(chunk.type));
    appendLittleEndian(bytes, std::uint32_t(chunk.head.size()));
    appendLittleEndian(bytes, std::uint32_t(0)); // flags, of which there are none yet
    appendLittleEndian(bytes, std::uint64_t(chunk.payload.size()));
    Checksum sum;
    sum.add(bytes);
    sum.add(chunk.head);
    appendLittleEndian(bytes, sum.value());
    return bytes;
}

std::optional<ChunkHeader> readChunkHeader(std::string_view bytes) {
    LittleEndianReader reader(bytes);
    if (reader.readBytes(kChunkMagic.size()) != kChunkMagic)
        return std::nullopt;
    ChunkHeader header;
    header.type = reader.read<std::uint32_t>();
    header.headLength = reader.read<std::uint32_t>();
    reader.read<std::uint32_t>();
    header.payloadLength = reader.read<std::uint64_t>();
    header.checksum = reader.read<std::uint64_t>();
    if (!reader.good())
        return std::nullopt;
    return header;
}

bool matches(std::string_view header, const ChunkHeader& fields, std::string_view head) {
    Checksum sum;
    sum.add(header.substr(0, kChunkHeaderBytes - 8));
    sum.add(head);
    return sum.value() == fields.checksum;
}

std::string trailer(std::uint64_t indexAt) {
    std::string bytes(kTrailerMagic);
    appendLittleEndian(bytes, indexAt);
    appendLittleEndian(bytes, checksum(bytes));
    return bytes;
}

std::optional<std::uint64_t> readTrailer(std::string_view bytes) {
    LittleEndianReader reader(bytes);
    if (reader.readBytes(kTrailerMagic.size()) != kTrailerMagic)
        return std::nullopt;
    const auto at = reader.read<std::uint64_t>();
    if (reader.read<std::uint64_t>() != checksum(bytes.substr(0, kTrailerBytes - 8)) || !reader.atEnd())
        return std::nullopt;
    return at;
}

std::optional<SceneHead> readSceneHead(std::string_view head) {
    LittleEndianReader reader(head);
    SceneHead scene;
    scene.id = reader.read<std::uint32_t>();
    if (!reader.good() || scene.id == 0 || !decompressText(reader.rest(), kMaxSceneBytes, scene.json))
        return std::nullopt;
    return scene;
}

std::optional<TakeHead> readTakeHead(std::string_view head) {
    LittleEndianReader reader(head);
    TakeHead take;
    take.info.id = reader.read<std::uint32_t>();
    take.info.parent = reader.read<std::uint32_t>();
    take.info.branchFrame = reader.read<std::int32_t>();
    const auto flags = reader.read<std::uint8_t>();
    take.info.hidden = (flags & kHidden) != 0;
    take.removed = (flags & kRemoved) != 0;
    take.info.name = reader.rest();
    const bool good = reader.good() && take.info.id != 0 && take.info.parent != take.info.id &&
                      take.info.branchFrame >= 0 && (take.info.parent != 0 || take.info.branchFrame == 0);
    if (!good)
        return std::nullopt;
    return take;
}

std::optional<FrameGroup> readFramesHead(std::string_view head, std::uint64_t payloadLength) {
    LittleEndianReader reader(head);
    FrameGroup group;
    group.take = reader.read<std::uint32_t>();
    group.first = reader.read<std::int32_t>();
    group.error = reader.read<double>();
    const auto grid = readGrid(reader);
    const int frames = reader.read<std::uint8_t>();
    const int packed = reader.read<std::uint8_t>();
    if (!reader.good() || !grid || frames < 1 || packed < frames || packed > kFramesPerGroup ||
        group.take == 0 || group.first < 0 ||
        group.first > std::numeric_limits<int>::max() - kFramesPerGroup ||
        !(group.error >= 0 && group.error <= kGreatestError))
        return std::nullopt;
    group.grid = *grid;
    std::uint64_t at = 0;
    for (int i = 0; i < packed; ++i) {
        FrameEntry entry;
        entry.facts = readFacts(reader);
        entry.scene = reader.read<std::uint32_t>();
        entry.blob.offset = at;
        entry.blob.length = reader.read<std::uint32_t>();
        entry.blob.checksum = reader.read<std::uint64_t>();
        at += entry.blob.length;
        (i < frames ? group.frames : group.beyond).push_back(entry);
    }
    if (!reader.atEnd() || at != payloadLength)
        return std::nullopt;
    return group;
}

std::optional<Checkpoint> readCheckpointHead(std::string_view head, std::uint64_t payloadLength) {
    LittleEndianReader reader(head);
    Checkpoint checkpoint;
    checkpoint.take = reader.read<std::uint32_t>();
    checkpoint.frame = reader.read<std::int32_t>();
    const auto grid = readGrid(reader);
    checkpoint.blob = {0, payloadLength, reader.read<std::uint64_t>()};
    if (!reader.atEnd() || !grid || checkpoint.take == 0 || checkpoint.frame < 0)
        return std::nullopt;
    checkpoint.grid = *grid;
    return checkpoint;
}

std::optional<std::vector<std::uint64_t>> readIndexHead(std::string_view head) {
    LittleEndianReader reader(head);
    std::vector<std::uint64_t> chunks;
    chunks.reserve(head.size() / 8);
    while (reader.good() && !reader.atEnd())
        chunks.push_back(reader.read<std::uint64_t>());
    if (!reader.good())
        return std::nullopt;
    return chunks;
}

} // namespace clothlab
