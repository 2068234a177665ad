// The pieces that a recording is kept in: groups of packed frames, and checkpoints.
#pragma once

#include "simcore/recording/frame_codec.h"
#include "simcore/recording/frame_facts.h"
#include "simcore/recording/payload.h"

#include <memory>
#include <span>
#include <vector>

namespace clothlab {

using TakeId = std::uint32_t;  // 1, 2, …; 0: none
using SceneId = std::uint32_t; // 1, 2, …

struct FrameEntry {
    FrameFacts facts;
    SceneId scene = 0; // with which it was computed
    Blob blob;
};

// Consecutive frames of a take. Copies share the payload.
struct FrameGroup {
    TakeId take = 0;
    int first = 0; // frame
    Grid grid;
    double error = kDefaultError;   // m, see FramePacker
    std::vector<FrameEntry> frames; // 1 … kFramesPerGroup
    std::vector<FrameEntry> beyond; // packed with them, but frames of the take no more: see trimGroup()
    std::shared_ptr<Payload> payload;

    int end() const { return first + int(frames.size()); }
    bool holds(int frame) const { return frame >= first && frame < end(); }
};

// A frame to pack.
struct FrameToPack {
    const PointArray* positions = nullptr;
    FrameFacts facts;
    SceneId scene = 0;
};

// 1 … kFramesPerGroup frames that follow each other.
FrameGroup packGroup(FramePacker& packer, TakeId take, int first, std::span<const FrameToPack> frames);

// Keeps the first count frames, 1 or more; the others may be needed to unpack them.
void trimGroup(FrameGroup& group, int count);

// Positions of a frame of the group, by its number in the take. Nothing if it is not in the group, or cannot
// be read, or is damaged. May be called by several threads at the same time.
std::optional<PointArray> positionsOf(const FrameGroup& group, int frame);

// Keeps what it has unpacked of the group at hand: frames that follow each other cost one each. To be used by
// one thread at a time.
class GroupReader {
public:
    std::optional<PointArray> positionsOf(const FrameGroup& group, int frame);

private:
    std::shared_ptr<const Payload> m_payload; // of the group at hand
    std::optional<FrameUnpacker> m_unpacker;
};

inline constexpr int kFramesPerCheckpoint = 60; // so many are computed at most to have a state again

// A whole state, without loss.
struct Checkpoint {
    TakeId take = 0;
    int frame = 0;
    Grid grid;
    Blob blob;
    std::shared_ptr<Payload> payload;
};

Checkpoint packCheckpoint(TakeId take, int frame, const Grid& grid, const ClothState& state);
std::optional<ClothState> stateOf(const Checkpoint& checkpoint); // as positionsOf()

} // namespace clothlab
