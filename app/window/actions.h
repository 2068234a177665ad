// Every command of the window with its name, icon, keys and tip. Who carries it out is connected by the
// window.
#pragma once

#include <QAction>
#include <QObject>

namespace clothlab {

class Actions : public QObject {
    Q_OBJECT

public:
    explicit Actions(QWidget& window);

    QAction* newScene;
    QAction* open;
    QAction* save;
    QAction* saveAs;
    QAction* screenshot;
    QAction* quit;

    QAction* playPause;
    QAction* stepBack;
    QAction* stepForward;
    QAction* tenBack;
    QAction* tenForward;
    QAction* firstFrame;
    QAction* lastFrame;
    QAction* simulateFrame;
    QAction* restart;

    QAction* home;
    QAction* frameSelection;
    QAction* frameAll;
    QAction* front;
    QAction* back;
    QAction* right;
    QAction* left;
    QAction* top;
    QAction* bottom;
    QAction* orthographic;
    QAction* keepView;
    QAction* fullScreen;
    QAction* hidePanels;
    QAction* resetLayout;
    QAction* darkTheme;
    QAction* lightTheme;

    QAction* boxSelect;
    QAction* clearSelection;

    QAction* keys;
    QAction* about;

    // The icon and name of playPause.
    void showPlaying(bool playing);

private:
    QAction* add(const char* name, const QString& text, const QString& icon,
                 const QList<QKeySequence>& shortcuts, const QString& tip);
    void addFileActions();
    void addSimulationActions();
    void addViewActions();
    void addOtherActions();

    QWidget& m_window;
};

} // namespace clothlab
