// Frames of a run into files, one after the other while they come. The same for every format.
#pragma once

#include "simcore/export/export.h"

#include <functional>
#include <memory>

namespace clothlab {

// begin() once, add() for each frame, finish(). Each returns what went wrong, in words that begin with the
// path; none throws. After trouble the writer is done: what is called then does nothing and says the same
// again. A file for all frames is there after finish() and not before; without it, it is as it was. May be
// used in another thread than it was made in.
class FrameWriter {
public:
    explicit FrameWriter(std::string path) : m_path(std::move(path)) {}
    virtual ~FrameWriter() = default;
    FrameWriter(const FrameWriter&) = delete;
    FrameWriter& operator=(const FrameWriter&) = delete;

    // framesAtMost: 1 or more; fewer may come.
    std::optional<std::string> begin(const Sheet& sheet, int framesAtMost);
    std::optional<std::string> add(const FramePointer& frame); // of the sheet, in order of time
    std::optional<std::string> finish();                       // after at least one frame
    // Drops what is not finished, now and in this thread; what a sequence has written stays.
    void abandon();

protected:
    using Trouble = std::optional<std::string>;

    const std::string& path() const { return m_path; }
    int added() const { return m_added; } // frames before the one that is being written

private:
    // May throw; trouble without the path.
    virtual Trouble open(const Sheet& sheet, int framesAtMost) = 0;
    virtual Trouble write(const FramePointer& frame) = 0;
    virtual Trouble complete() = 0; // of added() frames
    virtual void discard() {}       // after trouble
    // The file that trouble is about.
    virtual std::string place() const { return m_path; }

    template <typename Call>
    Trouble guarded(Call call);

    std::string m_path;
    Trouble m_trouble;
    std::size_t m_points = 0;
    int m_framesAtMost = 0;
    int m_added = 0;
    bool m_finished = false;
};

struct ExportSettings {
    Placement placement;
    bool meshBeside = true; // Pc2, Mdd: the first frame as OBJ in meshBesidePath(), too
};

// "run.obj" for "run.pc2".
std::string meshBesidePath(const std::string& path);

// A file for all frames if the format is such; otherwise one of the last frame.
std::unique_ptr<FrameWriter> makeFrameWriter(ExportFormat format, const std::string& path,
                                             const ExportSettings& settings = {});

// A file a frame, each there as soon as it is written, and staying there. pathOf: of the frames 0, 1, ….
std::unique_ptr<FrameWriter> makeSequenceWriter(ExportFormat format, std::function<std::string(int)> pathOf,
                                                const Placement& placement = {});

// CSV with a row a frame: frame,time,kinetic_energy,potential_energy,max_strain_structural,
// max_strain_shearing,max_strain_bending,strain_limit_corrections. Seconds, joules.
std::unique_ptr<FrameWriter> makeMeasuresWriter(const std::string& path);

} // namespace clothlab
