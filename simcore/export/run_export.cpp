#include "simcore/export/run_export.h"

#include <cmath>
#include <exception>

namespace clothlab {
namespace {

FramePointer frameOf(const FrameSource& source, int number, std::string& reason) {
    try {
        return source.frame(number, reason);
    } catch (const std::exception& e) {
        reason = std::string("it could not be made (") + e.what() + ")";
    } catch (...) {
        reason = "it could not be made";
    }
    return nullptr;
}

class Run {
public:
    Run(FrameWriter& writer, const std::atomic<bool>& stop) : m_writer(writer), m_stop(stop) {}

    // Trouble of a writer that was told to stop is no trouble.
    ExportResult notWritten(std::string reason) {
        return m_stop ? cancelled() : end(ExportEnd::NotWritten, std::move(reason));
    }
    ExportResult cancelled() { return end(ExportEnd::Cancelled, {}); }
    ExportResult noFrame(int number, const std::string& reason) {
        return m_stop ? cancelled()
                      : end(ExportEnd::NoFrame, "frame " + std::to_string(number) + ": " + reason);
    }
    bool stopped() const { return m_stop; }
    int written = 0;

private:
    ExportResult end(ExportEnd how, std::string reason) {
        m_writer.abandon();
        return {how, std::move(reason), written};
    }

    FrameWriter& m_writer;
    const std::atomic<bool>& m_stop;
};

} // namespace

int ExportRange::frameAt(int index) const {
    return first + static_cast<int>(std::lround(index * step));
}

int ExportRange::count() const {
    if (last < first || !(step >= 1))
        return 0;
    int count = static_cast<int>((last - first + 0.5) / step) + 1;
    while (count > 1 && frameAt(count - 1) > last) // where half a frame was rounded up
        --count;
    return count;
}

ExportResult runExport(const FrameSource& source, const ExportRange& range, FrameWriter& writer,
                       const std::atomic<bool>& stop, const std::function<void(int)>& progress,
                       IfAFrameFails ifAFrameFails) {
    Run run(writer, stop);
    const int count = range.count();
    if (auto trouble = writer.begin(source.sheet, count))
        return run.notWritten(*trouble);
    std::optional<ExportResult> ended;
    for (; run.written < count && !ended; ++run.written) {
        if (run.stopped())
            return run.cancelled();
        const int number = range.frameAt(run.written);
        std::string reason;
        const FramePointer frame = frameOf(source, number, reason);
        if (!frame && ifAFrameFails == IfAFrameFails::KeepThoseBefore && run.written > 0 && !run.stopped()) {
            ended = ExportResult{ExportEnd::NoFrame, reason, run.written};
            break;
        }
        if (!frame)
            return run.noFrame(number, reason);
        if (run.stopped()) // it may have taken long
            return run.cancelled();
        if (auto trouble = writer.add(frame))
            return run.notWritten(*trouble);
        if (progress)
            progress(run.written + 1);
    }
    if (run.stopped())
        return run.cancelled();
    if (auto trouble = writer.finish())
        return run.notWritten(*trouble);
    return ended.value_or(ExportResult{ExportEnd::Done, {}, run.written});
}

} // namespace clothlab
