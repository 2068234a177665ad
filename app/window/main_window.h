// The window: panels around the view, the actions, and who says what to whom.
#pragma once

#include "app/document/document.h"
#include "app/simulation/simulation.h"
#include "app/widgets/theme.h"
#include "app/window/recovery.h"

#include <QMainWindow>
#include <QSettings>

#include <array>
#include <memory>

class QComboBox;
class QDockWidget;

namespace clothlab {

namespace render {
class ShaderFolder;
}

class Actions;
class AppearancePanel;
class ExportController;
class FileController;
class InspectorPanel;
class MessageBar;
class OutputPanel;
class PictureDialog;
class ShaderEditor;
class SimulationPanel;
class SpringsPanel;
class SystemTheme;
class TakesPanel;
class TimelinePanel;
class Viewport;

class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    // Layout, theme and recent files are read from and kept in `settings`.
    // shaderDirectory: empty for that which comes with the program.
    // recoveryDirectory: where recordings are written to while they are made; empty: nowhere.
    explicit MainWindow(std::unique_ptr<QSettings> settings, const QString& shaderDirectory = {},
                        const QString& recoveryDirectory = {}, QWidget* parent = nullptr);
    ~MainWindow() override;

    Document& document() { return m_document; }
    Simulation& simulation() { return m_simulation; }
    Viewport& viewport() { return *m_viewport; }
    Actions& actions() { return *m_actions; }
    FileController& files() { return *m_files; }
    ExportController& exports() { return *m_exports; }
    MessageBar& messageBar() { return *m_messageBar; }
    SimulationPanel& simulationPanel() { return *m_simulationPanel; }
    SpringsPanel& springsPanel() { return *m_springsPanel; }
    AppearancePanel& appearancePanel() { return *m_appearancePanel; }
    InspectorPanel& inspectorPanel() { return *m_inspectorPanel; }
    TimelinePanel& timelinePanel() { return *m_timelinePanel; }
    TakesPanel& takesPanel() { return *m_takesPanel; }
    OutputPanel& outputPanel() { return *m_outputPanel; }
    ShaderEditor& shaderEditor() { return *m_shaderEditor; }
    render::ShaderFolder& shaderFolder() { return *m_shaderFolder; }
    QDockWidget* dock(const QString& name) const;

    void setTheme(std::optional<Theme> theme); // none: that of the system, dark if it has no preference
    void resetLayout();

    // Writes a PNG of the window as it is, whole or not at all. Returns what went wrong, in words.
    std::optional<QString> savePicture(const QString& path);

public slots:
    void say(const QString& text);         // in the status bar and in Output
    void showProblem(const QString& text); // above the view and in Output

protected:
    void closeEvent(QCloseEvent* event) override;
    void dragEnterEvent(QDragEnterEvent* event) override;
    void dropEvent(QDropEvent* event) override;
    void showEvent(QShowEvent* event) override;

private:
    void makePanels();
    QDockWidget* addDock(const QString& name, const QString& title, QWidget* panel, Qt::DockWidgetArea area,
                         bool scrolls);
    void makeMenus();
    void makeToolBar();
    void makeStatusBar();
    void connectFileActions();
    void connectSimulationActions();
    void connectPrecisionActions();
    void connectPlaybackActions();
    void connectViewActions();
    void connectShaders();
    void connectMessages();

    void arrangeDocks();
    void restoreLayout();
    void keepLayout();
    void keepPlayback();
    void restorePlayback();
    void setPanelsHidden(bool hidden);
    void updateTitle();
    void updateTransport();
    void updateAppearanceControls();
    void keepView();
    void choosePicture();
    void showPictureDialog();
    void openShader(const QString& path, int line);
    void tellProblems();
    void applyChosenTheme();
    bool mayDropShaderText();
    QString newJournal();
    void offerRecovery();
    void recover(const QString& journal);
    void showKeys();
    void showAbout();

    std::unique_ptr<QSettings> m_settings;
    Recovery m_recovery; // before the simulation, whose journals it removes
    Document m_document;
    Simulation m_simulation;
    Actions* m_actions;
    FileController* m_files;
    MessageBar* m_messageBar;
    Viewport* m_viewport;
    SimulationPanel* m_simulationPanel = nullptr;
    SpringsPanel* m_springsPanel = nullptr;
    AppearancePanel* m_appearancePanel = nullptr;
    InspectorPanel* m_inspectorPanel = nullptr;
    TimelinePanel* m_timelinePanel = nullptr;
    TakesPanel* m_takesPanel = nullptr;
    OutputPanel* m_outputPanel = nullptr;
    ShaderEditor* m_shaderEditor = nullptr;
    render::ShaderFolder* m_shaderFolder;
    SystemTheme* m_systemTheme;
    QString m_textureDirectory;
    QString m_shaderProblem; // as shown above the view
    PictureDialog* m_pictureDialog = nullptr;
    ExportController* m_exports = nullptr;
    QComboBox* m_shaderSelector = nullptr;
    std::array<QAction*, kSpringTypes> m_springActions{};
    QByteArray m_defaultState;
    QByteArray m_shownLayout; // while hidePanels has hidden them; otherwise empty
    bool m_laidOut = false;
};

} // namespace clothlab
