#include "app/export/staged_sequence.h"

#include <QDir>
#include <QFileInfo>
#include <QTemporaryDir>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <utility>

namespace clothlab {
namespace {

class StagedSequence : public FrameWriter {
public:
    StagedSequence(std::function<std::string(int)> pathOf, const MakeSequence& makeSequence)
        : FrameWriter({}), m_pathOf(std::move(pathOf)),
          m_inner(makeSequence([this](int frame) { return stagedPath(frame); })) {}

private:
    Trouble open(const Sheet& sheet, int framesAtMost) override {
        const QFileInfo first(QString::fromStdString(m_pathOf(0)));
        if (!first.absoluteDir().exists())
            return "there is no such folder; check its name";
        m_stage = std::make_unique<QTemporaryDir>(first.absolutePath() + "/.clothlab-XXXXXX");
        if (!m_stage->isValid())
            return "its folder cannot be written to; choose another place";
        return ofInner(m_inner->begin(sheet, framesAtMost));
    }
    Trouble write(const FramePointer& frame) override {
        if (QFileInfo(QString::fromStdString(m_pathOf(added()))).isDir())
            return "is a folder, not a file; move it away or choose another name";
        return ofInner(m_inner->add(frame));
    }
    Trouble complete() override {
        if (auto trouble = ofInner(m_inner->finish()))
            return trouble;
        m_moving = true;
        for (; m_moved < added(); ++m_moved)
            if (std::rename(stagedPath(m_moved).c_str(), m_pathOf(m_moved).c_str()) != 0)
                return std::string("could not be moved to its place (") + std::strerror(errno) + ")";
        m_stage.reset();
        m_moved = 0; // nothing is to be taken back any more
        return std::nullopt;
    }
    void discard() override {
        m_inner->abandon();
        m_stage.reset();
        for (; m_moved > 0; --m_moved) // they are ours, and the sequence is not whole
            std::remove(m_pathOf(m_moved - 1).c_str());
    }
    std::string place() const override { return m_pathOf(m_moving ? m_moved : added()); }

    std::string stagedPath(int frame) const {
        const QString name = QFileInfo(QString::fromStdString(m_pathOf(frame))).fileName();
        return (m_stage ? m_stage->filePath(name) : name).toStdString();
    }
    // Without the path in the hidden folder.
    Trouble ofInner(Trouble trouble) const {
        const std::string path = stagedPath(added()) + ": ";
        if (trouble && trouble->starts_with(path))
            trouble->erase(0, path.size());
        return trouble;
    }

    std::function<std::string(int)> m_pathOf;
    std::unique_ptr<QTemporaryDir> m_stage;
    std::unique_ptr<FrameWriter> m_inner;
    bool m_moving = false;
    int m_moved = 0; // files to where they belong
};

} // namespace

std::unique_ptr<FrameWriter> makeStagedSequence(std::function<std::string(int)> pathOf,
                                                const MakeSequence& makeSequence) {
    return std::make_unique<StagedSequence>(std::move(pathOf), makeSequence);
}

} // namespace clothlab
