#include "simcore/export/take_writer.h"

#include "simcore/base/whole_file.h"
#include "simcore/inspect/frame_measure.h"
#include "simcore/recording/take_chunks.h"

namespace clothlab {
namespace {

constexpr TakeId kTake = 1;

class TakeWriter : public FrameWriter {
public:
    TakeWriter(const std::string& path, double error, std::string version)
        : FrameWriter(path), m_error(error), m_version(std::move(version)) {}

private:
    Trouble open(const Sheet& sheet, int) override;
    Trouble write(const FramePointer& frame) override;
    Trouble complete() override;
    void discard() override { m_file.reset(); }

    void writeScene(const std::shared_ptr<const Scene>& scene);
    void writeGroup();
    void writeCheckpoint(int number, const Frame& frame);

    double m_error;
    std::string m_version;
    Grid m_grid;
    std::optional<FrameMeasure> m_measure;
    std::optional<FramePacker> m_packer;
    std::unique_ptr<WholeFile> m_file;
    std::optional<TakeFileWriter> m_writer;
    std::shared_ptr<const Scene> m_scene; // that was written last
    SceneId m_sceneId = 0;
    std::vector<FramePointer> m_waiting; // for their group to be full
    std::vector<FrameToPack> m_group;
    int m_groupBegin = 0;
    FramePointer m_last;
};

FrameWriter::Trouble TakeWriter::open(const Sheet& sheet, int) {
    m_grid = sheet.grid;
    m_measure.emplace(sheet);
    m_packer.emplace(sheet.grid, m_error);
    m_file = std::make_unique<WholeFile>();
    if (auto trouble = m_file->open(path()))
        return trouble;
    m_writer.emplace(m_file->out());
    m_writer->add(takeChunk({kTake, 0, 0, "Take 1", false}));
    return std::nullopt;
}

void TakeWriter::writeScene(const std::shared_ptr<const Scene>& scene) {
    if (scene == m_scene)
        return;
    m_scene = scene;
    m_writer->add(sceneChunk(++m_sceneId, *scene));
}

void TakeWriter::writeGroup() {
    if (m_group.empty())
        return;
    m_writer->add(*chunkOf(packGroup(*m_packer, kTake, m_groupBegin, m_group)));
    m_groupBegin += int(m_group.size());
    m_group.clear();
    m_waiting.clear();
}

void TakeWriter::writeCheckpoint(int number, const Frame& frame) {
    m_writer->add(*chunkOf(packCheckpoint(kTake, number, m_grid, frame.state)));
}

FrameWriter::Trouble TakeWriter::write(const FramePointer& frame) {
    writeScene(frame->scene);
    m_waiting.push_back(frame);
    m_group.push_back({&frame->state.position, m_measure->factsOf(*frame), m_sceneId});
    if (m_group.size() == kFramesPerGroup)
        writeGroup();
    if (added() % kFramesPerCheckpoint == 0)
        writeCheckpoint(added(), *frame);
    m_last = frame;
    return m_file->trouble();
}

FrameWriter::Trouble TakeWriter::complete() {
    writeGroup();
    const int last = added() - 1;
    if (last % kFramesPerCheckpoint != 0)
        writeCheckpoint(last, *m_last);
    TakeMeta meta;
    meta.version = m_version;
    meta.error = m_error;
    meta.activeTake = kTake;
    meta.shownFrame = last;
    m_writer->add(metaChunk(meta));
    m_writer->finish();
    return m_file->finish();
}

} // namespace

std::unique_ptr<FrameWriter> makeTakeWriter(const std::string& path, double error,
                                            const std::string& version) {
    return std::make_unique<TakeWriter>(path, error, version);
}

} // namespace clothlab
