#include "tests/support/take_file_invariants.h"

#include "simcore/base/checksum.h"
#include "simcore/base/little_endian.h"
#include "simcore/recording/chunk_heads.h"

namespace clothlab::test {
namespace {

std::string brokenTake(const TakeFileContents& contents, const RecordedTake& take) {
    const std::string name = "take " + std::to_string(take.info.id);
    if (take.info.id == 0)
        return name + " has no number";
    if (take.info.parent == 0 && take.groups.empty())
        return name + " is a root without frames";
    if (take.info.parent != 0) {
        const RecordedTake* parent = findTake(contents, take.info.parent);
        if (parent == nullptr || parent >= &take)
            return name + " is not behind its parent";
        if (take.info.branchFrame >= parent->end())
            return name + " branches off nothing";
    }
    int next = take.info.firstOwnFrame();
    for (const FrameGroup& group : take.groups) {
        if (group.first != next || group.frames.empty() || group.take != take.info.id)
            return name + " has a gap";
        next = group.end();
        GroupReader reader;
        for (int frame = group.first; frame < group.end(); ++frame) {
            const auto scene = contents.scenes.find(group.frames[std::size_t(frame - group.first)].scene);
            if (scene == contents.scenes.end() || gridOf(scene->second->cloth) != group.grid)
                return name + " has a frame without its scene";
            const auto positions = reader.positionsOf(group, frame);
            if (positions && int(positions->size()) != group.grid.pointCount())
                return name + " has a frame of another size";
        }
    }
    for (const Checkpoint& checkpoint : take.checkpoints) {
        const auto state = stateOf(checkpoint);
        if (state && int(state->size()) != checkpoint.grid.pointCount())
            return name + " has a state of another size";
        if (checkpoint.frame < take.info.firstOwnFrame() || checkpoint.frame >= take.end())
            return name + " has a state of a frame that is not there";
    }
    return {};
}

void putChecksum(std::string& bytes, std::size_t at, std::string_view of) {
    std::string sum;
    appendLittleEndian(sum, checksum(of));
    bytes.replace(at, sum.size(), sum);
}

// Those in the head of a chunk of frames or of a checkpoint.
void rightBlobs(std::string& bytes, std::size_t at, const ChunkHeader& header) {
    const std::size_t head = at + kChunkHeaderBytes;
    const std::size_t payload = head + header.headLength;
    const std::string_view payloadBytes = std::string_view(bytes).substr(payload, header.payloadLength);
    constexpr std::size_t checkpointSum = 16; // where it is in the head
    constexpr std::size_t entries = 26, entryBytes = 72;
    if (ChunkType{header.type} == ChunkType::Checkpoint && header.headLength >= checkpointSum + 8)
        putChecksum(bytes, head + checkpointSum, std::string(payloadBytes));
    if (ChunkType{header.type} != ChunkType::Frames)
        return;
    std::uint64_t begin = 0;
    for (std::size_t entry = entries; entry + entryBytes <= header.headLength; entry += entryBytes) {
        LittleEndianReader length(std::string_view(bytes).substr(head + entry + entryBytes - 12, 4));
        const auto count = length.read<std::uint32_t>();
        if (begin > header.payloadLength || count > header.payloadLength - begin)
            return;
        putChecksum(bytes, head + entry + entryBytes - 8, bytes.substr(payload + std::size_t(begin), count));
        begin += count;
    }
}

} // namespace

std::string withRightChecksums(std::string bytes) {
    if (bytes.size() >= kFileHeaderBytes)
        putChecksum(bytes, kFileHeaderBytes - 8, std::string_view(bytes).substr(0, kFileHeaderBytes - 8));
    for (std::size_t at = bytes.find(kChunkMagic); at != std::string::npos;
         at = bytes.find(kChunkMagic, at + 1)) {
        const auto header = readChunkHeader(std::string_view(bytes).substr(at));
        const std::size_t left = bytes.size() - at;
        if (!header || header->headLength > left - std::min<std::size_t>(left, kChunkHeaderBytes) ||
            header->payloadLength > left - kChunkHeaderBytes - header->headLength)
            continue;
        rightBlobs(bytes, at, *header);
        const std::string covered = bytes.substr(at, kChunkHeaderBytes - 8) +
                                    bytes.substr(at + kChunkHeaderBytes, header->headLength);
        putChecksum(bytes, at + kChunkHeaderBytes - 8, covered);
    }
    return bytes;
}

std::string brokenTakeFileInvariant(const TakeFileReading& reading) {
    for (const Diagnostic& diagnostic : reading.diagnostics)
        if (diagnostic.message.empty())
            return "a problem without words";
    if (reading.contents.has_value() == hasErrors(reading.diagnostics))
        return "contents and errors, or neither";
    if (!reading.contents)
        return {};
    const TakeFileContents& contents = *reading.contents;
    if (contents.takes.empty())
        return "contents without takes";
    for (const RecordedTake& take : contents.takes)
        if (std::string broken = brokenTake(contents, take); !broken.empty())
            return broken;
    const RecordedTake* active = findTake(contents, contents.meta.activeTake);
    if (active == nullptr || contents.meta.shownFrame < 0 || contents.meta.shownFrame >= active->end())
        return "a frame is shown that is not there";
    return {};
}

} // namespace clothlab::test
