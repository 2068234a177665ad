// Positions of consecutive frames of a sheet, packed in groups. docs/clothtake.md has the format.
#pragma once

#include "simcore/cloth/cloth_state.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace clothlab {

inline constexpr double kDefaultError = 1e-5; // m
inline constexpr double kGreatestError = 1e3; // m, that may be asked for
inline constexpr int kFramesPerGroup = 16;    // at most; five of them are unpacked at most to see one

// Packs groups of frames. Holds its buffers. To be used by one thread at a time.
class FramePacker {
public:
    // error: the greatest difference of a coordinate, in metres, up to kGreatestError; 0 keeps the bits. A
    // frame whose coordinates are not finite, or too far out for the error, keeps its bits, too.
    FramePacker(const Grid& grid, double error);
    ~FramePacker();
    FramePacker(FramePacker&&) noexcept;
    FramePacker& operator=(FramePacker&&) noexcept;

    const Grid& grid() const;
    double error() const;

    // 1 … kFramesPerGroup frames in order of time, each of as many points as the grid has. The bytes of each.
    std::vector<std::string> pack(std::span<const PointArray* const> frames);

private:
    struct Work;
    std::unique_ptr<Work> m_work;
};

// Unpacks frames of a group in any order, and keeps what it has unpacked.
class FrameUnpacker {
public:
    // The bytes of a frame of the group; nothing if they are not to be had.
    using BytesOf = std::function<std::optional<std::string>(int index)>;

    FrameUnpacker(const Grid& grid, double error, int frames, BytesOf bytesOf);
    ~FrameUnpacker();
    FrameUnpacker(FrameUnpacker&&) noexcept;
    FrameUnpacker& operator=(FrameUnpacker&&) noexcept;

    // Nothing if the bytes of the frame, or of those it is predicted from, are no frames of such a group.
    // Reads no byte beyond them, whatever they are. 0 <= index < frames.
    std::optional<PointArray> positions(int index);

private:
    struct Work;
    std::unique_ptr<Work> m_work;
};

} // namespace clothlab
