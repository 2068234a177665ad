// PC2, the point cache of 3ds Max: little endian, a head of 32 bytes, then x y z of each point of each frame.
#include "simcore/export/all_frames.h"
#include "simcore/export/bytes.h"

namespace clothlab {
namespace {

class Pc2Writer : public PointCacheWriter {
public:
    using PointCacheWriter::PointCacheWriter;

private:
    std::string head(std::uint32_t points, std::uint32_t frames) const override {
        std::string bytes("POINTCACHE2\0", 12);
        appendLittle(bytes, std::uint32_t(1)); // version
        appendLittle(bytes, points);
        appendLittle(bytes, 0.0F); // first frame
        appendLittle(bytes, 1.0F); // frames from one to the next
        appendLittle(bytes, frames);
        return bytes;
    }
    void append(std::string& bytes, const Vec3& position) const override { appendLittle(bytes, position); }
};

} // namespace

std::unique_ptr<FrameWriter> makePc2Writer(const std::string& path, const ExportSettings& settings) {
    return std::make_unique<Pc2Writer>(path, settings);
}

} // namespace clothlab
