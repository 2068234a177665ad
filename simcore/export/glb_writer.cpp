// glTF 2.0 in one binary file: a mesh, a morph target for each frame after the first, and an animation of
// their weights. Positions go to the file as they come; what describes them goes before them in the end, into
// room that was kept.
#include "simcore/export/all_frames.h"
#include "simcore/export/bytes.h"
#include "simcore/export/glb_json.h"
#include "simcore/export/sheet_mesh.h"

#include <algorithm>
#include <cstdio>

namespace clothlab {
namespace {

constexpr std::uint64_t kHeadBytes = 20; // of the file and of its first chunk
constexpr std::uint64_t kChunkBytes = 8; // head of the second
constexpr std::uint64_t kMostBytes = 0x7fffffff;
constexpr int kMostFrames = 1000; // weights grow with the square of it, and programs read each target whole

class GlbWriter : public FrameWriter {
public:
    GlbWriter(const std::string& path, const Placement& placement)
        : FrameWriter(path), m_placement(placement) {}

private:
    Trouble open(const Sheet& sheet, int framesAtMost) override;
    Trouble write(const FramePointer& frame) override;
    Trouble complete() override;
    void discard() override { m_file.reset(); }

    void writeTopology();
    void writeFirst(const Frame& frame);
    void appendBounded(std::string& bytes, float x, float y, float z, Bounds& bounds) const;

    Placement m_placement;
    Grid m_grid;
    std::uint64_t m_jsonBytes = 0; // that are kept
    std::unique_ptr<WholeFile> m_file;
    std::vector<float> m_first; // x y z of each point of the first frame, as they are in the file
    GlbContent m_content;
};

std::optional<std::string> tooLarge(const Grid& grid, int frames, std::uint64_t bytes) {
    const std::string remedy = "; write fewer frames, or a .pc2 or .mdd, which take any number";
    if (frames > kMostFrames)
        return std::to_string(frames) + " frames are more than the " + std::to_string(kMostFrames) +
               " that a .glb can hold here" + remedy;
    if (bytes <= kMostBytes)
        return std::nullopt;
    std::array<char, 32> gib{};
    std::snprintf(gib.data(), gib.size(), "%.1f", double(bytes) / double(1U << 30U));
    return std::to_string(frames) + " frames of " + std::to_string(grid.pointCount()) + " points make " +
           gib.data() + " GiB, and a .glb can hold 2" + remedy;
}

FrameWriter::Trouble GlbWriter::open(const Sheet& sheet, int framesAtMost) {
    m_grid = sheet.grid;
    m_content.points = m_grid.pointCount();
    m_content.triangles = triangleCount(m_grid);
    m_content.about = "ClothLab, " + describe(m_placement);
    m_jsonBytes = mostJsonBytes(framesAtMost);
    const std::uint64_t bytes =
        kHeadBytes + m_jsonBytes + kChunkBytes + layoutOf(m_content, framesAtMost).bytes;
    if (auto trouble = tooLarge(m_grid, framesAtMost, bytes))
        return trouble;
    m_file = std::make_unique<WholeFile>();
    if (auto trouble = m_file->open(path()))
        return trouble;
    if (auto trouble = m_file->skip(kHeadBytes + m_jsonBytes + kChunkBytes))
        return trouble;
    writeTopology();
    return m_file->trouble();
}

void GlbWriter::writeTopology() {
    std::string bytes;
    forEachTriangle(m_grid, [&](int a, int b, int c) {
        for (const int corner : {a, b, c})
            appendLittle(bytes, static_cast<std::uint32_t>(corner));
    });
    for (int i = 0; i < m_grid.pointCount(); ++i) {
        const auto [u, v] = textureCoordinate(m_grid, m_grid.place(i));
        appendLittle(bytes, static_cast<float>(u));
        appendLittle(bytes, static_cast<float>(1 - v)); // from the upper edge of a picture, here
    }
    m_file->out() << bytes;
}

void GlbWriter::appendBounded(std::string& bytes, float x, float y, float z, Bounds& bounds) const {
    std::size_t axis = 0;
    for (const float value : {x, y, z}) {
        appendLittle(bytes, value);
        bounds.least[axis] = std::min(bounds.least[axis], value);
        bounds.greatest[axis] = std::max(bounds.greatest[axis], value);
        ++axis;
    }
}

void GlbWriter::writeFirst(const Frame& frame) {
    std::string bytes;
    for (int i = 0; i < m_grid.pointCount(); ++i)
        appendLittle(bytes, turned(m_placement, pointNormal(m_grid, frame.state.position, m_grid.place(i))));
    m_file->out() << bytes;
    m_first.assign(3 * frame.state.size(), 0); // what is written first is a difference to this
}

FrameWriter::Trouble GlbWriter::write(const FramePointer& frame) {
    if (added() == 0)
        writeFirst(*frame);
    std::string bytes;
    Bounds bounds;
    std::vector<float> now;
    now.reserve(m_first.size());
    for (int i = 0; i < m_grid.pointCount(); ++i) {
        const Vec3 place = placed(m_placement, frame->state.position.at(i));
        for (const double value : {place.x(), place.y(), place.z()})
            now.push_back(static_cast<float>(value));
        const std::size_t at = 3 * std::size_t(i);
        appendBounded(bytes, now[at] - m_first[at], now[at + 1] - m_first[at + 1],
                      now[at + 2] - m_first[at + 2], bounds);
    }
    if (added() == 0)
        m_first = std::move(now);
    m_file->out() << bytes;
    m_content.bounds.push_back(bounds);
    m_content.times.push_back(static_cast<float>(frame->time));
    return m_file->trouble();
}

FrameWriter::Trouble GlbWriter::complete() {
    const GlbLayout layout = layoutOf(m_content, added());
    if (added() > 1) {
        std::string bytes;
        for (const float time : m_content.times)
            appendLittle(bytes, time);
        for (int frame = 0; frame < added(); ++frame)
            for (int target = 1; target < added(); ++target)
                appendLittle(bytes, frame == target ? 1.0F : 0.0F);
        m_file->out() << bytes;
    }
    std::string json = jsonOf(m_content);
    if (json.size() > m_jsonBytes)
        return "its description does not fit into the room that was kept for it; use .pc2 or .mdd";
    json.resize(m_jsonBytes, ' ');

    std::string head = "glTF";
    appendLittle(head, std::uint32_t(2));
    appendLittle(head, static_cast<std::uint32_t>(kHeadBytes + m_jsonBytes + kChunkBytes + layout.bytes));
    appendLittle(head, static_cast<std::uint32_t>(m_jsonBytes));
    head += "JSON" + json;
    appendLittle(head, static_cast<std::uint32_t>(layout.bytes));
    head += std::string("BIN\0", 4);
    if (auto trouble = m_file->replace(0, head))
        return trouble;
    return m_file->finish();
}

} // namespace

std::unique_ptr<FrameWriter> makeGlbWriter(const std::string& path, const Placement& placement) {
    return std::make_unique<GlbWriter>(path, placement);
}

} // namespace clothlab
