// Every command of the window with its name, icon, keys and tip. Who carries it out is connected by the
// window.
#pragma once

#include <QAction>
#include <QObject>

#include <utility>

namespace clothlab {

class Actions : public QObject {
    Q_OBJECT

public:
    explicit Actions(QWidget& window);

    QAction* newScene = nullptr;
    QAction* open = nullptr;
    QAction* save = nullptr;
    QAction* saveAs = nullptr;
    QAction* saveRecording = nullptr;
    QAction* screenshot = nullptr;
    QAction* picture = nullptr;
    QAction* exportFrames = nullptr;
    QAction* quit = nullptr;

    QAction* playPause = nullptr;
    QAction* playBackward = nullptr;
    QAction* faster = nullptr;
    QAction* slower = nullptr;
    QAction* loop = nullptr;
    QAction* stepBack = nullptr;
    QAction* stepForward = nullptr;
    QAction* tenBack = nullptr;
    QAction* tenForward = nullptr;
    QAction* firstFrame = nullptr;
    QAction* lastFrame = nullptr;
    QAction* simulateFrame = nullptr;
    QAction* restart = nullptr;
    QAction* recordHundredth = nullptr; // whose data are the errors in metres
    QAction* recordTenth = nullptr;
    QAction* recordExactly = nullptr;

    QAction* setIn = nullptr;
    QAction* setOut = nullptr;
    QAction* clearRange = nullptr;
    QAction* addMarker = nullptr;
    QAction* nextMarker = nullptr;
    QAction* previousMarker = nullptr;

    QAction* home = nullptr;
    QAction* frameSelection = nullptr;
    QAction* frameAll = nullptr;
    QAction* front = nullptr;
    QAction* back = nullptr;
    QAction* right = nullptr;
    QAction* left = nullptr;
    QAction* top = nullptr;
    QAction* bottom = nullptr;
    QAction* orthographic = nullptr;
    QAction* keepView = nullptr;
    QAction* fullScreen = nullptr;
    QAction* hidePanels = nullptr;
    QAction* resetLayout = nullptr;
    QAction* systemTheme = nullptr;
    QAction* darkTheme = nullptr;
    QAction* lightTheme = nullptr;

    QAction* boxSelect = nullptr;
    QAction* clearSelection = nullptr;
    QAction* editShader = nullptr;
    QAction* reloadShaders = nullptr;

    QAction* keys = nullptr;
    QAction* about = nullptr;

    // The icons of playPause and playBackward, and what the first does.
    void showPlaying(bool playing, bool backward);

private:
    QAction* add(const char* name, const QString& text, const QString& icon,
                 const QList<QKeySequence>& shortcuts, const QString& tip);
    void addFileActions();
    void addSimulationActions();
    void addPrecisionActions();
    void addPlaybackActions();
    void addViewActions();
    void addOtherActions();

    QWidget& m_window;
    std::pair<bool, bool> m_shownPlaying{false, false};
};

// An action that cannot be used now says why in its tip.
void setUsable(QAction* action, bool usable, const QString& whyNot);

} // namespace clothlab
