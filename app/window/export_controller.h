// Export: the dialog, the job that is under way, and what is said about it.
#pragma once

#include "app/document/document.h"
#include "app/export/export_job.h"
#include "app/simulation/simulation.h"

#include <QObject>

#include <memory>

namespace clothlab {

class ExportDialog;
class ExportProgress;
class Viewport;

// One export at a time. Frames are taken as they are recorded when it begins; what is simulated or edited
// afterwards does not change it.
class ExportController : public QObject {
    Q_OBJECT

public:
    ExportController(Document& document, Simulation& simulation, Viewport& viewport,
                     render::PictureSource pictures, QWidget& window);
    ~ExportController() override; // cancels

    ExportDialog& dialog(); // made when it is first asked for
    // For the status bar; shown while the dialog is not. Whatever is painted in the window of an OpenGL view
    // composes all of it anew.
    ExportProgress* statusWidget() { return m_status; }
    bool isRunning() const { return m_job != nullptr; }

    void showDialog();
    void begin(const ExportRequest& request); // asks before it replaces files
    void cancel();
    bool mayClose(); // asks if an export is under way, and cancels it if the user says so

signals:
    void notice(const QString& text);
    void problem(const QString& text);

private:
    FrameSource frameSource(ExportKind kind) const;
    std::unique_ptr<FramePainter> painter(const ExportRequest& request);
    void updateFacts();
    bool mayReplace(const ExportRequest& request);
    void showProgress();
    void onEnded(const ExportResult& result);

    Document& m_document;
    Simulation& m_simulation;
    Viewport& m_viewport;
    render::PictureSource m_pictures;
    QWidget& m_window;
    ExportDialog* m_dialog = nullptr;
    ExportProgress* m_status;
    std::unique_ptr<ExportJob> m_job;
    int m_written = 0; // frames, as last told
};

} // namespace clothlab
