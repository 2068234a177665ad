// Positions of consecutive frames of a sheet, packed. docs/clothtake.md has the format.
#pragma once

#include "simcore/cloth/cloth_state.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace clothlab {

inline constexpr double kDefaultError = 1e-5; // m
inline constexpr int kFramesPerGroup = 8;     // at most: so many are unpacked to see one of them
inline constexpr double kGreatestError = 1e3; // m, that may be asked for

// Packs frames in order of time. Holds its buffers. To be used by one thread at a time.
class FramePacker {
public:
    // error: the greatest difference of a coordinate, in metres; 0 keeps the bits. A frame whose coordinates
    // are not finite, or too far out for the error, keeps its bits, too.
    FramePacker(const Grid& grid, double error);
    ~FramePacker();
    FramePacker(FramePacker&&) noexcept;
    FramePacker& operator=(FramePacker&&) noexcept;

    const Grid& grid() const;
    double error() const;

    void beginGroup(); // the next frame is packed by itself
    // Appends the packed frame to bytes. Precondition: as many points as the grid has.
    void pack(const PointArray& positions, std::string& bytes);

private:
    struct Work;
    std::unique_ptr<Work> m_work;
};

// Unpacks the frames of a group, from its first on.
class FrameUnpacker {
public:
    FrameUnpacker(const Grid& grid, double error);
    ~FrameUnpacker();
    FrameUnpacker(FrameUnpacker&&) noexcept;
    FrameUnpacker& operator=(FrameUnpacker&&) noexcept;

    void beginGroup();
    // The next frame. False if the bytes are no frame of this grid; then nothing can be unpacked until the
    // next group. Reads no byte beyond them, whatever they are.
    bool unpack(std::string_view bytes);
    PointArray positions() const; // of the frame unpacked last

private:
    struct Work;
    std::unique_ptr<Work> m_work;
};

} // namespace clothlab
