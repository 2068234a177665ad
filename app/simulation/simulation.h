// The run of the document's scene: its recording, the frame that is shown, and playing on from there.
// Lives on the GUI thread; every step is taken by the worker's, and frames are packed by the recorder's.
#pragma once

#include "app/document/document.h"
#include "app/simulation/frame_worker.h"
#include "app/simulation/playback.h"
#include "app/simulation/recorder.h"
#include "simcore/recording/recording_contents.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <functional>

namespace clothlab {

inline constexpr std::size_t kRecordingBudget = std::size_t(1) << 30U; // bytes of memory

// Playing shows recorded frames as Playback says and, after the last, goes on simulating. What is recorded
// is what was shown: a frame that is under way when playing stops is dropped. Which frames are
// stale, and when a take begins, says Recording.
//
// A frame is shown as it is kept. If that is not exactly, its state is computed again, once playing and
// scrubbing stop, and then it is shown once more.
class Simulation : public QObject {
    Q_OBJECT

public:
    explicit Simulation(Document& document, QObject* parent = nullptr,
                        std::size_t memoryBudget = kRecordingBudget);

    // Where each recording is written to while it is made; without it, recordings stay in memory. Begins one.
    void setJournals(std::function<QString()> newPath);

    // The greatest difference, in metres, of coordinates as they are kept from what they were; 0: none. Of
    // frames that are recorded from now on.
    void setRecordingError(double error);
    double recordingError() const { return m_error; }

    // Puts a recording that was read from a file in the place of this one, after its scene was put into the
    // document. loaded: made of the contents.
    void load(const LoadedTakes& loaded, TakeFileContents contents);
    // Calls it with what a file would hold, once all of that is packed.
    void gatherContents(std::function<void(TakeFileContents)> use);

    // Whether there is more in the recording than running the scene again would bring back in a moment, and
    // no file has it: frames that took long to compute, names of takes, marks.
    bool isWorthSaving() const;
    void setSaved();                                                               // a file has it now
    void setSecondsWorthSaving(double seconds) { m_secondsWorthSaving = seconds; } // 10 unless set

    // Calls it once all that is recorded until now is packed and, if there is a journal, written there.
    void whenPacked(std::function<void()> then);
    bool hasJournal() const { return m_recorder.hasJournal(); }

    const Recording& recording() const { return m_recording; }
    const Sheet& sheet() const { return m_recording.take()->sheet(); }
    int currentFrame() const { return m_recording.shownFrame(); }
    const FramePointer& shownFrame() const { return m_shown; }
    FramePointer look(int number); // of the open take, as it is kept
    const Scene& shownScene() const { return m_recording.shownScene(); }
    bool isPlaying() const { return m_playing; }
    bool isPlayingBackward() const { return m_playing && m_playback.direction() == Direction::Backward; }
    bool isRecordingLive() const { return m_playing && m_live; } // what is shown next is new
    const PlaybackSettings& playback() const { return m_playback.settings(); }
    const TakeMarks& marks() const { return m_recording.take()->marks(); } // of the open take
    bool isSimulating() const { return m_pending && m_pending->newFrame; } // a new frame is under way
    int firstStaleFrame() const { return m_recording.firstStaleFrame(); }
    QString blowUp() const { return m_blowUp; } // in words; empty if it did not
    std::thread::id lastComputedOn() const { return m_lastComputedOn; }
    std::size_t bytesInMemory() const;

public slots:
    void play();
    void pause();
    void playBackward(); // turns round what plays forward
    void togglePlaying() { m_playing ? pause() : play(); }
    void togglePlayingBackward() { isPlayingBackward() ? pause() : playBackward(); }
    void setPlayback(const clothlab::PlaybackSettings& settings);
    void showFrame(int frame); // pauses; clamped to what is recorded
    void moveBy(int frames) { showFrame(currentFrame() + frames); }
    void simulateFrame(); // pauses; one frame after the last that is not stale
    void restart();       // a new take from the start of the scene as it is now

    // Each an undo step.
    void openTake(clothlab::TakeId id);
    void renameTake(clothlab::TakeId id, const QString& name);
    void deleteTake(clothlab::TakeId id);
    // Of the open take. Changes with the same text and the same gesture, not 0, merge into one step.
    void setMarks(const QString& text, clothlab::TakeMarks marks, int gesture = 0);
    void setMarker(int frame, const QString& name); // a new one, or another name
    void removeMarker(int frame);
    void setInPoint(int frame, int gesture = 0); // an out point before it goes
    void setOutPoint(int frame, int gesture = 0);
    void clearRange();

signals:
    void frameShown();       // currentFrame() or what it holds has changed
    void recordingChanged(); // the frames of the open take, which are stale, or how they are kept
    void takesChanged();     // which there are, their names, or which is open
    void playingChanged(bool playing);
    void playbackChanged(); // playback() or isRecordingLive()
    void marksChanged();    // of any take
    void blowUpChanged();
    void notice(const QString& text); // something the user should know

private:
    friend class OpenTakeCommand;
    friend class RenameTakeCommand;
    friend class DeleteTakeCommand;
    friend class MarksCommand;
    void exchangeView(Recording::View& other);
    void exchangeName(const TakePointer& take, std::string& other);
    void exchangeMarks(const TakePointer& take, TakeMarks& other);
    bool removeTake(const TakePointer& take);
    void insertTake(const TakePointer& take);

    // What the worker is at.
    struct Pending {
        std::uint64_t ticket;
        TakePointer take;
        int regained;  // the last frame of the take that is computed again
        bool newFrame; // and then one more
    };

    void beginSession(std::shared_ptr<const TakeFileContents> contents = nullptr);
    void onSceneReplaced();
    void onSceneChanged(SceneChange change);
    void showOtherTake();
    void announceTake(); // the open one, which has just begun, to the recorder
    void tellTake(const Take& take);
    void tellMeta();

    void begin(Direction direction); // to play
    Playback::Played played() const;
    double milliseconds() const; // since this was made
    void advance();              // the next frame may be due
    void requestFrame();
    bool isFull();
    void refine(); // the shown frame
    void request(int regained, bool newFrame);
    void dropPending();
    void receive(FrameOutcome outcome);
    void repairWay(const Pending& done);
    void receive(const Packed& packed);
    void record(FramePointer frame);
    void stopForBlowUp(const FrameOutcome& outcome);
    void show(int frame);
    void setPlaying(bool playing);
    void setBlowUp(const QString& text);

    Document& m_document;
    Recording m_recording;
    std::size_t m_budget;
    FramePointer m_shown;
    GroupReader m_reader;
    Recording::View* m_opening = nullptr; // while the scene is exchanged for that of another take
    bool m_playing = false;
    QString m_blowUp;
    bool m_hasUnsavedNames = false; // or marks
    double m_unsavedSeconds = 0;    // that frames took to compute
    double m_secondsWorthSaving = 10;
    std::thread::id m_lastComputedOn;

    std::optional<Pending> m_pending;
    std::uint64_t m_lastTicket = 0;
    FramePointer m_ready; // computed ahead; recorded once it is due
    int m_follows = 0;    // the frame that this, or the new one under way, follows
    QTimer m_clock;       // runs until the next frame is due
    QElapsedTimer m_sinceBegin;
    Playback m_playback;
    bool m_live = false; // as it last was while playing

    std::function<QString()> m_newJournal;
    double m_error = kDefaultError;
    int m_session = 0;
    Recorder m_recorder;
    FrameWorker m_worker; // last: these two are gone before what their outcomes touch
};

} // namespace clothlab
