#include "app/window/actions.h"

#include "app/widgets/icons.h"
#include "app/widgets/number_field.h"

#include <QActionGroup>
#include <QWidget>

namespace clothlab {

Actions::Actions(QWidget& window) : QObject(&window), m_window(window) {
    addFileActions();
    addSimulationActions();
    addPrecisionActions();
    addPlaybackActions();
    addViewActions();
    addOtherActions();
}

QAction* Actions::add(const char* name, const QString& text, const QString& icon,
                      const QList<QKeySequence>& shortcuts, const QString& tip) {
    auto* action = new QAction(text, &m_window);
    action->setObjectName(name);
    if (!icon.isEmpty())
        action->setIcon(themedIcon(icon));
    action->setShortcuts(shortcuts);
    QStringList names;
    for (const QKeySequence& key : shortcuts)
        names << key.toString(QKeySequence::NativeText);
    action->setToolTip(shortcuts.isEmpty() ? tip
                                           : QStringLiteral("%1 (%2)").arg(tip, names.join(tr(" or "))));
    action->setStatusTip(tip);
    // Works wherever the focus is, floating docks included.
    action->setShortcutContext(Qt::ApplicationShortcut);
    m_window.addAction(action);
    // Before anything else: buttons and keys leave the focus, and so what is being typed, where it is.
    connect(action, &QAction::triggered, this, &commitFocusedField);
    return action;
}

void Actions::addFileActions() {
    newScene = add("newScene", tr("&New"), "new", {QKeySequence::New}, tr("New scene"));
    open = add("open", tr("&Open…"), "open", {QKeySequence::Open}, tr("Open a scene or a recording"));
    save = add("save", tr("&Save"), "save", {QKeySequence::Save},
               tr("Save the scene, or the recording that was opened"));
    saveAs =
        add("saveAs", tr("Save &As…"), "save-as", {QKeySequence("Ctrl+Shift+S")}, tr("Save the scene as"));
    saveRecording = add("saveRecording", tr("Save with &Recording As…"), {}, {QKeySequence("Ctrl+Alt+S")},
                        tr("Save the scene with all takes of its recording"));
    screenshot = add("screenshot", tr("Save a &Picture of the Window…"), "screenshot", {QKeySequence("F12")},
                     tr("Save a picture of the window"));
    picture = add("picture", tr("Save a Picture of the &View…"), {}, {QKeySequence("Shift+F12")},
                  tr("Save a picture of the view in any size"));
    exportFrames = add("exportFrames", tr("&Export…"), {}, {QKeySequence("Ctrl+Shift+E")},
                       tr("Export recorded frames as meshes, caches, pictures or video"));
    quit = add("quit", tr("&Quit"), {}, {QKeySequence("Ctrl+Q")}, tr("Quit ClothLab"));
}

void Actions::addSimulationActions() {
    playPause = add("playPause", tr("Play"), "play", {QKeySequence("Space"), QKeySequence("P")},
                    tr("Play or pause; after the last frame, simulate on"));
    stepBack =
        add("stepBack", tr("One Frame Back"), "step-back", {QKeySequence("Left")}, tr("One frame back"));
    stepForward = add("stepForward", tr("One Frame Forward"), "step-forward", {QKeySequence("Right")},
                      tr("One frame forward"));
    tenBack = add("tenBack", tr("Ten Frames Back"), {}, {QKeySequence("Shift+Left")}, tr("Ten frames back"));
    tenForward = add("tenForward", tr("Ten Frames Forward"), {}, {QKeySequence("Shift+Right")},
                     tr("Ten frames forward"));
    firstFrame =
        add("firstFrame", tr("First Frame"), "first", {QKeySequence("Ctrl+Home")}, tr("First frame"));
    lastFrame = add("lastFrame", tr("Last Frame"), "last", {QKeySequence("Ctrl+End")}, tr("Last frame"));
    simulateFrame = add("simulateFrame", tr("Simulate One Frame"), "record",
                        {QKeySequence("N"), QKeySequence(".")}, tr("Simulate and record one more frame"));
    restart = add("restart", tr("Reset"), "reset", {QKeySequence("R")},
                  tr("Back to the start, with a new recording"));
    for (QAction* action : {stepBack, stepForward, tenBack, tenForward, simulateFrame})
        action->setAutoRepeat(true);
    for (QAction* action : {playPause, restart})
        action->setAutoRepeat(false);
}

void Actions::addPrecisionActions() {
    recordHundredth =
        add("recordHundredth", tr("To 0.01 &mm"), {}, {},
            tr("Positions of recorded frames are kept to 0.01 mm; any exact state is computed again"));
    recordTenth = add("recordTenth", tr("To 0.&1 mm"), {}, {},
                      tr("Positions of recorded frames are kept to 0.1 mm, which takes half the place"));
    recordExactly =
        add("recordExactly", tr("To the Last &Bit"), {}, {},
            tr("Positions of recorded frames are kept as they are, which takes ten times the place"));
    auto* precisions = new QActionGroup(this);
    for (const auto& [action, error] :
         {std::pair(recordHundredth, 1e-5), {recordTenth, 1e-4}, {recordExactly, 0.0}}) {
        action->setCheckable(true);
        action->setData(error);
        precisions->addAction(action);
    }
}

void Actions::addPlaybackActions() {
    playBackward = add("playBackward", tr("Play Backward"), "play-backward", {QKeySequence("Shift+Space")},
                       tr("Play what is recorded backward, or pause; from the start, begins at the end"));
    slower = add("slower", tr("Play Slower"), {}, {QKeySequence("[")}, tr("Play at half the speed"));
    faster = add("faster", tr("Play Faster"), {}, {QKeySequence("]")}, tr("Play at twice the speed"));
    loop = add("loop", tr("Loop"), "loop", {QKeySequence("L")},
               tr("Play again and again between in and out point; records nothing"));
    setIn = add("setIn", tr("Set the In Point"), {}, {QKeySequence("I")},
                tr("Loops begin, and playing backward ends, at this frame"));
    setOut = add("setOut", tr("Set the Out Point"), {}, {QKeySequence("O")},
                 tr("Loops, and playing from before it, end at this frame"));
    clearRange = add("clearRange", tr("Clear In and Out Point"), {}, {QKeySequence("Alt+X")},
                     tr("Play from the first to the last frame again"));
    addMarker =
        add("addMarker", tr("Add a Marker"), "marker", {QKeySequence("M")}, tr("Add a marker at this frame"));
    nextMarker =
        add("nextMarker", tr("Next Marker"), {}, {QKeySequence("Ctrl+Right")}, tr("Go to the next marker"));
    previousMarker = add("previousMarker", tr("Previous Marker"), {}, {QKeySequence("Ctrl+Left")},
                         tr("Go to the marker before"));
    loop->setCheckable(true);
    for (QAction* action : {playBackward, loop, setIn, setOut, clearRange, addMarker})
        action->setAutoRepeat(false);
}

void Actions::addViewActions() {
    home = add("home", tr("&Home"), "home", {QKeySequence("Home")}, tr("Camera back to where it started"));
    frameSelection = add("frameSelection", tr("Frame &Selection"), "frame-selection", {QKeySequence("F")},
                         tr("Move the camera so that the selection fills the view"));
    frameAll = add("frameAll", tr("Frame &All"), "frame-all", {QKeySequence("A")},
                   tr("Move the camera so that the cloth fills the view"));
    front = add("front", tr("Front"), {}, {QKeySequence("1")}, tr("Look from the front, along -z"));
    back = add("back", tr("Back"), {}, {QKeySequence("Ctrl+1")}, tr("Look from behind, along +z"));
    right = add("right", tr("Right"), {}, {QKeySequence("3")}, tr("Look from the right, along -x"));
    left = add("left", tr("Left"), {}, {QKeySequence("Ctrl+3")}, tr("Look from the left, along +x"));
    top = add("top", tr("Top"), {}, {QKeySequence("7")}, tr("Look from above, along -y"));
    bottom = add("bottom", tr("Bottom"), {}, {QKeySequence("Ctrl+7")}, tr("Look from below, along +y"));
    orthographic = add("orthographic", tr("&Orthographic"), {}, {QKeySequence("5")},
                       tr("Switch between perspective and orthographic"));
    orthographic->setCheckable(true);
    keepView = add("keepView", tr("&Keep This View in the Scene"), {}, {},
                   tr("The scene opens with the camera where it is now"));
    fullScreen = add("fullScreen", tr("&Full Screen"), {}, {QKeySequence("F11")}, tr("Full screen"));
    fullScreen->setCheckable(true);
    hidePanels = add("hidePanels", tr("Hide All &Panels"), "panels", {}, tr("Hide or show all panels"));
    hidePanels->setCheckable(true);
    hidePanels->setToolTip(tr("Hide or show all panels (Tab in the view)"));
    resetLayout = add("resetLayout", tr("&Reset Layout"), {}, {}, tr("Put every panel back in its place"));
    auto* themes = new QActionGroup(this);
    systemTheme = add("systemTheme", tr("Theme of the S&ystem"), {}, {},
                      tr("Dark or light panels as the system has them; dark where it does not say"));
    darkTheme = add("darkTheme", tr("&Dark Theme"), {}, {}, tr("Dark panels"));
    lightTheme = add("lightTheme", tr("&Light Theme"), {}, {}, tr("Light panels"));
    for (QAction* theme : {systemTheme, darkTheme, lightTheme}) {
        theme->setCheckable(true);
        themes->addAction(theme);
    }
}

void Actions::addOtherActions() {
    boxSelect = add("boxSelect", tr("Select in a &Box"), "select", {QKeySequence("B")},
                    tr("Then drag a box around points; Shift adds, Ctrl removes"));
    clearSelection = add("clearSelection", tr("Select &Nothing"), {}, {}, tr("Select nothing"));
    editShader = add("editShader", tr("&Edit the Shader"), "shaded", {QKeySequence("Ctrl+E")},
                     tr("Open the file of the shader that is drawn"));
    reloadShaders = add("reloadShaders", tr("&Reload Shaders and Textures"), {}, {QKeySequence("F5")},
                        tr("Read the files of shaders and textures again"));
    keys = add("keys", tr("&Keys and Mouse"), "help", {QKeySequence("F1"), QKeySequence("?")},
               tr("List every key and what the mouse does"));
    about = add("about", tr("&About ClothLab"), {}, {}, tr("What ClothLab is, and its version"));
}

void Actions::showPlaying(bool playing, bool backward) {
    if (m_shownPlaying == std::pair(playing, backward))
        return; // icons are not made anew with every frame
    m_shownPlaying = {playing, backward};
    playPause->setText(playing ? tr("Pause") : tr("Play"));
    playPause->setIcon(themedIcon(playing && !backward ? "pause" : "play"));
    playBackward->setIcon(themedIcon(backward ? "pause" : "play-backward"));
}

void setUsable(QAction* action, bool usable, const QString& whyNot) {
    if (action->isEnabled() == usable)
        return;
    constexpr const char* kOwnTip = "ownToolTip";
    if (!usable)
        action->setProperty(kOwnTip, action->toolTip());
    action->setEnabled(usable);
    action->setToolTip(usable ? action->property(kOwnTip).toString() : whyNot);
}

} // namespace clothlab
