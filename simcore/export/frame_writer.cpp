#include "simcore/export/frame_writer.h"

#include "simcore/export/all_frames.h"

#include <exception>

namespace clothlab {
namespace {

class LastFrameWriter : public FrameWriter {
public:
    LastFrameWriter(ExportFormat format, const std::string& path, const Placement& placement)
        : FrameWriter(path), m_format(format), m_placement(placement) {}

private:
    Trouble open(const Sheet&, int) override { return std::nullopt; }
    Trouble write(const FramePointer& frame) override {
        m_last = frame;
        return std::nullopt;
    }
    Trouble complete() override { return exportFrame(*m_last, m_format, path(), m_placement); }

    ExportFormat m_format;
    Placement m_placement;
    FramePointer m_last;
};

class SequenceWriter : public FrameWriter {
public:
    SequenceWriter(ExportFormat format, std::function<std::string(int)> pathOf, const Placement& placement)
        : FrameWriter({}), m_format(format), m_pathOf(std::move(pathOf)), m_placement(placement) {}

private:
    Trouble open(const Sheet&, int) override { return std::nullopt; }
    Trouble write(const FramePointer& frame) override {
        return exportFrame(*frame, m_format, m_pathOf(added()), m_placement);
    }
    Trouble complete() override { return std::nullopt; }
    std::string place() const override { return m_pathOf(added()); }

    ExportFormat m_format;
    std::function<std::string(int)> m_pathOf;
    Placement m_placement;
};

} // namespace

template <typename Call>
FrameWriter::Trouble FrameWriter::guarded(Call call) {
    if (m_trouble)
        return m_trouble;
    try {
        m_trouble = call();
    } catch (const std::exception& e) {
        m_trouble = std::string("its content could not be made (") + e.what() + "); try again";
    } catch (...) {
        m_trouble = "its content could not be made; try again";
    }
    if (!m_trouble)
        return std::nullopt;
    m_trouble = place() + ": " + *m_trouble;
    discard();
    return m_trouble;
}

std::optional<std::string> FrameWriter::begin(const Sheet& sheet, int framesAtMost) {
    m_points = sheet.start.size();
    m_framesAtMost = framesAtMost;
    return guarded([&] { return open(sheet, framesAtMost); });
}

std::optional<std::string> FrameWriter::add(const FramePointer& frame) {
    return guarded([&]() -> Trouble {
        if (frame->state.size() != m_points)
            return "frame " + std::to_string(m_added) +
                   " has another number of points than the sheet; write it to a file of its own";
        if (m_finished)
            return "is finished; begin another";
        if (m_added == m_framesAtMost)
            return "more frames come than the " + std::to_string(m_framesAtMost) +
                   " it was begun for; begin it for more";
        if (auto trouble = write(frame))
            return trouble;
        ++m_added;
        return std::nullopt;
    });
}

std::optional<std::string> FrameWriter::finish() {
    return guarded([&]() -> Trouble {
        if (m_added == 0)
            return "there is no frame to write; simulate one first";
        if (m_finished)
            return "is finished; begin another";
        m_finished = true;
        return complete();
    });
}

void FrameWriter::abandon() {
    (void)guarded([] { return Trouble("was given up; begin another"); });
}

std::string meshBesidePath(const std::string& path) {
    return path.substr(0, path.size() - 4) + ".obj"; // all endings have three letters
}

std::unique_ptr<FrameWriter> makeFrameWriter(ExportFormat format, const std::string& path,
                                             const ExportSettings& settings) {
    switch (format) {
    case ExportFormat::Pc2:
        return makePc2Writer(path, settings);
    case ExportFormat::Mdd:
        return makeMddWriter(path, settings);
    case ExportFormat::Glb:
        return makeGlbWriter(path, settings.placement);
    case ExportFormat::Obj:
    case ExportFormat::Csv:
    case ExportFormat::Ply:
        break;
    }
    return std::make_unique<LastFrameWriter>(format, path, settings.placement);
}

std::unique_ptr<FrameWriter> makeSequenceWriter(ExportFormat format, std::function<std::string(int)> pathOf,
                                                const Placement& placement) {
    return std::make_unique<SequenceWriter>(format, std::move(pathOf), placement);
}

} // namespace clothlab
