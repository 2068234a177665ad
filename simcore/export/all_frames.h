// Writers of the formats whose files hold all frames, for makeFrameWriter().
#pragma once

#include "simcore/base/whole_file.h"
#include "simcore/export/frame_writer.h"

namespace clothlab {

std::unique_ptr<FrameWriter> makePc2Writer(const std::string& path, const ExportSettings& settings);
std::unique_ptr<FrameWriter> makeMddWriter(const std::string& path, const ExportSettings& settings);
std::unique_ptr<FrameWriter> makeGlbWriter(const std::string& path, const Placement& placement);

// What PC2 and MDD share: a head, the positions of each frame, and the mesh beside it.
class PointCacheWriter : public FrameWriter {
public:
    PointCacheWriter(const std::string& path, const ExportSettings& settings)
        : FrameWriter(path), m_settings(settings) {}

private:
    // The bytes before the positions, of a file with so many frames.
    virtual std::string head(std::uint32_t points, std::uint32_t frames) const = 0;
    // Bytes after the head that are kept free for each frame that may come, and what is there in the end.
    virtual int bytesEachFrame() const { return 0; }
    virtual std::string eachFrame(const std::vector<double>&) const { return {}; } // times, s
    virtual void append(std::string& bytes, const Vec3& position) const = 0;

    Trouble open(const Sheet& sheet, int framesAtMost) final;
    Trouble write(const FramePointer& frame) final;
    Trouble complete() final;
    void discard() final;
    Trouble ofMesh(const Trouble& trouble) const;

    ExportSettings m_settings;
    std::unique_ptr<WholeFile> m_file, m_mesh;
    std::vector<double> m_times; // s
    std::uint32_t m_points = 0;
    int m_framesAtMost = 0;
};

} // namespace clothlab
