// MDD, the point cache of LightWave: big endian; numbers of frames and points, the time of each frame in
// seconds, then x y z of each point of each frame.
#include "simcore/export/all_frames.h"
#include "simcore/export/bytes.h"

namespace clothlab {
namespace {

class MddWriter : public PointCacheWriter {
public:
    using PointCacheWriter::PointCacheWriter;

private:
    std::string head(std::uint32_t points, std::uint32_t frames) const override {
        std::string bytes;
        appendBig(bytes, frames);
        appendBig(bytes, points);
        return bytes;
    }
    int bytesEachFrame() const override { return 4; }
    std::string eachFrame(const std::vector<double>& times) const override {
        std::string bytes;
        for (const double time : times)
            appendBig(bytes, static_cast<float>(time));
        return bytes;
    }
    void append(std::string& bytes, const Vec3& position) const override { appendBig(bytes, position); }
};

} // namespace

std::unique_ptr<FrameWriter> makeMddWriter(const std::string& path, const ExportSettings& settings) {
    return std::make_unique<MddWriter>(path, settings);
}

} // namespace clothlab
