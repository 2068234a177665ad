// An export on a thread of its own, while the window goes on.
#pragma once

#include "app/export/export_request.h"

#include <QObject>

class QThread;

namespace clothlab {

// Lives on the GUI thread. Frames are asked for, painted and written on the job's. One run only.
class ExportJob : public QObject {
    Q_OBJECT

public:
    // painter: if hasPictures(request.kind).
    ExportJob(FrameSource source, ExportRequest request, std::unique_ptr<FramePainter> painter);
    ~ExportJob() override; // cancels, and waits until nothing half is left

    const ExportRequest& request() const { return m_request; }
    int total() const { return m_total; } // frames

    void start();
    void cancel(); // ended() comes soon

signals:
    void progressed(int written); // frames; often enough for the eye, not for every frame
    void ended(const clothlab::ExportResult& result);

private:
    void run();

    FrameSource m_source;
    ExportRequest m_request;
    int m_total;
    std::atomic<bool> m_stop{false};
    std::unique_ptr<FrameWriter> m_writer;
    std::unique_ptr<QThread> m_thread;
};

} // namespace clothlab

Q_DECLARE_METATYPE(clothlab::ExportResult)
