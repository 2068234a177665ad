#include "simcore/export/all_frames.h"

namespace clothlab {

FrameWriter::Trouble PointCacheWriter::ofMesh(const Trouble& trouble) const {
    return trouble ? Trouble("its mesh " + meshBesidePath(path()) + ": " + *trouble) : std::nullopt;
}

FrameWriter::Trouble PointCacheWriter::open(const Sheet& sheet, int framesAtMost) {
    m_points = static_cast<std::uint32_t>(sheet.start.size());
    m_framesAtMost = framesAtMost;
    if (m_settings.meshBeside) {
        m_mesh = std::make_unique<WholeFile>();
        if (auto trouble = ofMesh(m_mesh->open(meshBesidePath(path()))))
            return trouble;
    }
    m_file = std::make_unique<WholeFile>();
    if (auto trouble = m_file->open(path()))
        return trouble;
    m_file->out() << head(m_points, 0);
    return m_file->skip(std::uint64_t(bytesEachFrame()) * std::uint64_t(framesAtMost));
}

FrameWriter::Trouble PointCacheWriter::write(const FramePointer& frame) {
    if (added() == 0 && m_mesh) {
        writeObj(m_mesh->out(), *frame, m_settings.placement);
        if (auto trouble = ofMesh(m_mesh->trouble()))
            return trouble;
    }
    std::string bytes;
    bytes.reserve(std::size_t(m_points) * 3 * sizeof(float));
    for (int i = 0; i < int(m_points); ++i)
        append(bytes, placed(m_settings.placement, frame->state.position.at(i)));
    m_file->out() << bytes;
    m_times.push_back(frame->time);
    return m_file->trouble();
}

FrameWriter::Trouble PointCacheWriter::complete() {
    const std::string front = head(m_points, static_cast<std::uint32_t>(added())) + eachFrame(m_times);
    const auto notCome = std::uint64_t(m_framesAtMost - added());
    if (auto trouble = m_file->remove(front.size(), std::uint64_t(bytesEachFrame()) * notCome))
        return trouble;
    if (auto trouble = m_file->replace(0, front))
        return trouble;
    if (m_mesh)
        if (auto trouble = ofMesh(m_mesh->finish()))
            return trouble;
    return m_file->finish();
}

void PointCacheWriter::discard() {
    m_file.reset();
    m_mesh.reset();
}

} // namespace clothlab
