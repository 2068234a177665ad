#include "simcore/base/whole_file.h"
#include "simcore/export/frame_writer.h"
#include "simcore/export/number.h"
#include "simcore/inspect/inspect.h"

namespace clothlab {
namespace {

class MeasuresWriter : public FrameWriter {
public:
    using FrameWriter::FrameWriter;

private:
    Trouble open(const Sheet& sheet, int) override {
        m_sheet = sheet;
        m_file = std::make_unique<WholeFile>();
        if (auto trouble = m_file->open(path()))
            return trouble;
        m_file->out() << "frame,time,kinetic_energy,potential_energy";
        for (const SpringType type : {SpringType::Structural, SpringType::Shearing, SpringType::Bending})
            m_file->out() << ",max_strain_" << name(type);
        m_file->out() << ",strain_limit_corrections\n";
        return std::nullopt;
    }
    Trouble write(const FramePointer& frame) override {
        const PointArray& position = frame->state.position;
        std::ostream& out = m_file->out();
        out << Number{added()} << ',' << Number{frame->time} << ','
            << Number{kineticEnergy(*frame->scene, frame->state)} << ','
            << Number{potentialEnergy(*frame->scene, m_sheet, position)};
        for (const double strain : maxStrain(m_sheet, position))
            out << ',' << Number{strain};
        out << ',' << Number{frame->strainLimitCorrections} << '\n';
        return m_file->trouble();
    }
    Trouble complete() override { return m_file->finish(); }
    void discard() override { m_file.reset(); }

    Sheet m_sheet;
    std::unique_ptr<WholeFile> m_file;
};

} // namespace

std::unique_ptr<FrameWriter> makeMeasuresWriter(const std::string& path) {
    return std::make_unique<MeasuresWriter>(path);
}

} // namespace clothlab
