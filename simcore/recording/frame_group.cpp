#include "simcore/recording/frame_group.h"

#include "simcore/base/checksum.h"
#include "simcore/recording/state_codec.h"

namespace clothlab {
namespace {

FrameUnpacker unpackerOf(const FrameGroup& group) {
    std::vector<Blob> blobs;
    for (const auto* entries : {&group.frames, &group.beyond})
        for (const FrameEntry& entry : *entries)
            blobs.push_back(entry.blob);
    const int frames = int(blobs.size());
    return {group.grid, group.error, frames, [blobs = std::move(blobs), payload = group.payload](int index) {
                return blobs[std::size_t(index)].read(*payload);
            }};
}

} // namespace

FrameGroup packGroup(FramePacker& packer, TakeId take, int first, std::span<const FrameToPack> frames) {
    FrameGroup group{take, first, packer.grid(), packer.error(), {}, {}, nullptr};
    std::vector<const PointArray*> positions;
    for (const FrameToPack& frame : frames)
        positions.push_back(frame.positions);
    std::string bytes;
    const std::vector<std::string> packed = packer.pack(positions);
    for (std::size_t i = 0; i < frames.size(); ++i) {
        group.frames.push_back(
            {frames[i].facts, frames[i].scene, {bytes.size(), packed[i].size(), checksum(packed[i])}});
        bytes += packed[i];
    }
    group.payload = std::make_shared<Payload>(std::move(bytes));
    return group;
}

void trimGroup(FrameGroup& group, int count) {
    const auto end = group.frames.begin() + count;
    group.beyond.insert(group.beyond.begin(), end, group.frames.end());
    group.frames.erase(end, group.frames.end());
}

std::optional<PointArray> positionsOf(const FrameGroup& group, int frame) {
    if (!group.holds(frame))
        return std::nullopt;
    return unpackerOf(group).positions(frame - group.first);
}

std::optional<PointArray> GroupReader::positionsOf(const FrameGroup& group, int frame) {
    if (!group.holds(frame))
        return std::nullopt;
    if (m_payload != group.payload) {
        m_unpacker.emplace(unpackerOf(group));
        m_payload = group.payload;
    }
    return m_unpacker->positions(frame - group.first);
}

Checkpoint packCheckpoint(TakeId take, int frame, const Grid& grid, const ClothState& state) {
    std::string bytes = packState(grid, state);
    const Blob blob{0, bytes.size(), checksum(bytes)};
    return {take, frame, grid, blob, std::make_shared<Payload>(std::move(bytes))};
}

std::optional<ClothState> stateOf(const Checkpoint& checkpoint) {
    const std::optional<std::string> bytes = checkpoint.blob.read(*checkpoint.payload);
    if (!bytes)
        return std::nullopt;
    return unpackState(checkpoint.grid, *bytes);
}

} // namespace clothlab
