// The run of the document's scene: its recording, the frame that is shown, and playing on from there.
// Lives on the GUI thread; every step is taken by the worker's.
#pragma once

#include "app/document/document.h"
#include "app/simulation/frame_worker.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <vector>

namespace clothlab {

// Playing shows recorded frames at their own pace and, after the last, goes on simulating. What is
// recorded is what was shown: a frame that is under way when playing stops is dropped.
//
// Staleness: a motion edit while an earlier frame is shown makes the frames after it stale. They can
// still be looked at; playing or stepping on replaces them. Undoing the edit makes them current again, and
// so does any edit to the scene that all of them were computed with.
class Simulation : public QObject {
    Q_OBJECT

public:
    explicit Simulation(Document& document, QObject* parent = nullptr,
                        std::size_t recordingBudget = kRecordingBudget);

    const Recording& recording() const { return m_recording; }
    const Sheet& sheet() const { return m_sheet; }
    int currentFrame() const { return m_current; }
    const FramePointer& shownFrame() const { return m_recording.frame(m_current); }
    // With which the run went on from the shown frame or, if that is where it would go on, will.
    const Scene& shownScene() const;
    bool isPlaying() const { return m_playing; }
    bool isSimulating() const { return m_pendingTicket != 0; } // a frame is under way
    int firstStaleFrame() const { return m_firstStale; }       // frameCount() if none is
    QString blowUp() const { return m_blowUp; }                // in words; empty if it did not
    std::thread::id lastComputedOn() const { return m_lastComputedOn; }

public slots:
    void play();
    void pause();
    void togglePlaying() { m_playing ? pause() : play(); }
    void showFrame(int frame); // pauses; clamped to what is recorded
    void moveBy(int frames) { showFrame(m_current + frames); }
    void simulateFrame(); // pauses; one frame after the last that is not stale
    void restart();       // a new recording from the start of the scene as it is now

signals:
    void frameShown();       // currentFrame() or what it holds has changed
    void recordingChanged(); // number of frames or which are stale
    void playingChanged(bool playing);
    void blowUpChanged();
    void notice(const QString& text); // something the user should know

private:
    void onSceneChanged(SceneChange change);
    void updateStaleness(std::shared_ptr<const Scene> before);
    bool areComputedAs(const Scene& scene, int first) const; // all frames from there on
    void dropStaleFrames();
    void advance();  // the next frame is due
    void schedule(); // the one after it
    void requestFrame();
    void dropPending();
    void receive(FrameOutcome outcome);
    void record(FramePointer frame);
    void stopForBlowUp(const FrameOutcome& outcome);
    void show(int frame);
    void setPlaying(bool playing);
    void setBlowUp(const QString& text);

    Document& m_document;
    Recording m_recording;
    Sheet m_sheet;
    int m_current = 0;
    int m_firstStale = 0;
    // An edit that made frames stale: what undoing it brings back.
    struct StaleEdit {
        std::shared_ptr<const Scene> before;
        int firstStale;
    };
    std::vector<StaleEdit> m_staleEdits;  // since frames were last recorded or dropped
    std::shared_ptr<const Scene> m_scene; // the document's, as last heard of
    bool m_playing = false;
    QString m_blowUp;
    std::thread::id m_lastComputedOn;

    std::uint64_t m_lastTicket = 0;
    std::uint64_t m_pendingTicket = 0; // 0: nothing under way
    FramePointer m_ready;              // computed ahead; recorded once it is due
    QTimer m_clock;                    // runs until the next frame is due
    QElapsedTimer m_sincePlay;
    double m_due = 0;     // of the next frame, in ms of m_sincePlay
    FrameWorker m_worker; // last: gone before what its outcomes touch
};

} // namespace clothlab
