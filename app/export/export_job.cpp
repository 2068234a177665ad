#include "app/export/export_job.h"

#include <QElapsedTimer>
#include <QThread>

#include <utility>

namespace clothlab {

ExportJob::ExportJob(FrameSource source, ExportRequest request, std::unique_ptr<FramePainter> painter)
    : m_source(std::move(source)), m_request(std::move(request)), m_total(m_request.frames.count()),
      m_writer(makeWriter(m_request, std::move(painter), m_stop)) {
    qRegisterMetaType<ExportResult>();
}

ExportJob::~ExportJob() {
    cancel();
    if (m_thread)
        m_thread->wait();
}

void ExportJob::start() {
    m_thread.reset(QThread::create([this] { run(); }));
    m_thread->start();
}

void ExportJob::cancel() {
    m_stop = true;
}

void ExportJob::run() {
    constexpr int milliseconds = 100; // between two signals
    QElapsedTimer sinceTold;
    sinceTold.start();
    const auto progress = [&](int written) {
        if (written < m_total && sinceTold.elapsed() < milliseconds)
            return;
        sinceTold.restart();
        emit progressed(written);
    };
    emit ended(runExport(m_source, m_request.frames, *m_writer, m_stop, progress));
}

} // namespace clothlab
