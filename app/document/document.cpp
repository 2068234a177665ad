#include "app/document/document.h"

#include "app/document/edit_scene_command.h"
#include "app/document/scene_files.h"
#include "simcore/inspect/stability.h"
#include "simcore/scene/pins.h"
#include "simcore/scene/range.h"
#include "simcore/scene/scene_io.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <utility>

namespace clothlab {
namespace {

Scene hungUpSheet() {
    Scene scene;
    scene.cloth.pinned = {{0, 0}, {scene.cloth.numWidthPoints - 1, 0}};
    return scene;
}

} // namespace

Document::Document(QObject* parent) : QObject(parent), m_scene(std::make_shared<const Scene>(hungUpSheet())) {
    connect(&m_undoStack, &QUndoStack::cleanChanged, this, &Document::fileChanged);
}

QString Document::folder() const {
    return m_path.isEmpty() ? QString() : QFileInfo(m_path).absolutePath();
}

QString Document::displayName() const {
    return m_path.isEmpty() ? tr("Untitled") : QFileInfo(m_path).fileName();
}

void Document::newScene() {
    setScene(hungUpSheet(), {});
}

Diagnostics Document::open(const QString& path) {
    SceneReading reading = loadScene(path.toStdString());
    if (reading.scene) {
        warnOfStep(*reading.scene, reading.diagnostics);
        setScene(withAbsoluteFiles(std::move(*reading.scene), QFileInfo(path).absolutePath()),
                 QFileInfo(path).absoluteFilePath());
    }
    return reading.diagnostics;
}

void Document::setScene(Scene scene, const QString& path) {
    setSelection({});
    m_scene = std::make_shared<const Scene>(std::move(scene));
    m_path = path;
    m_recordingModified = false;
    m_recovered = false;
    m_undoStack.clear();
    m_undoStack.setClean();
    emit sceneReplaced();
    emit fileChanged();
}

std::optional<QString> Document::save(const QString& path) {
    const Scene scene = withRelativeFiles(*m_scene, QFileInfo(path).absolutePath());
    if (const auto error = saveScene(scene, path.toStdString()))
        return QString::fromStdString(*error);
    setSaved(path, m_revision);
    return std::nullopt;
}

void Document::setSaved(const QString& path, int revision) {
    m_path = QFileInfo(path).absoluteFilePath();
    m_recovered = false;
    if (revision == m_revision) {
        m_recordingModified = false;
        m_undoStack.setClean();
    }
    emit fileChanged();
}

void Document::setRecovered() {
    m_recovered = true;
    emit fileChanged();
}

bool Document::isRecording() const {
    return m_path.endsWith(QLatin1String(".clothtake"), Qt::CaseInsensitive);
}

void Document::setRecordingModified() {
    ++m_revision;
    if (std::exchange(m_recordingModified, true) || !isRecording())
        return;
    emit fileChanged();
}

void Document::edit(const QString& text, Scene after, int gesture) {
    if (after != *m_scene)
        m_undoStack.push(new EditSceneCommand(*this, text, std::move(after), gesture));
}

std::optional<QString> Document::setParameter(const Parameter& parameter, double value, int gesture) {
    const auto words = [this](const Diagnostic& diagnostic) {
        return QString::fromStdString(toText(diagnostic, displayName().toStdString()));
    };
    // Before it is set: what is out of range may not fit into its type.
    if (const Range range = rangeOf(parameter); !range.contains(value))
        return words({Severity::Error, std::string(parameter.id), outOfRange(value), writeWithin(range)});
    Scene after = *m_scene;
    parameter.set(after, value);
    if (gridOf(after.cloth) != gridOf(m_scene->cloth)) {
        // From where the drag began: on its way it may pass through grids too coarse to tell pins apart.
        after.cloth.pinned =
            movedPins(sceneBefore(gesture).cloth, after.cloth.numWidthPoints, after.cloth.numHeightPoints);
    }
    for (const Diagnostic& diagnostic : validate(after))
        if (diagnostic.severity == Severity::Error)
            return words(diagnostic);
    const QString label =
        QString::fromUtf8(parameter.label.data(), static_cast<qsizetype>(parameter.label.size()));
    edit(tr("change %1").arg(QCoreApplication::translate("Parameter", label.toUtf8())), std::move(after),
         gesture);
    return std::nullopt;
}

const Scene& Document::sceneBefore(int gesture) const {
    const auto* last =
        m_undoStack.index() > 0
            ? dynamic_cast<const EditSceneCommand*>(m_undoStack.command(m_undoStack.index() - 1))
            : nullptr;
    return last && gesture != 0 && last->gesture() == gesture ? last->otherScene() : *m_scene;
}

void Document::exchangeScene(std::shared_ptr<const Scene>& other) {
    // While what is selected is still there. In another grid the numbers would mean other springs.
    if (gridOf(other->cloth) != gridOf(m_scene->cloth))
        setSelection({});
    std::swap(m_scene, other);
    ++m_revision;
    emit sceneChanged(compareScenes(*other, *m_scene));
}

void Document::setSelection(Selection selection) {
    selection.prune(grid());
    if (selection == m_selection)
        return;
    m_selection = std::move(selection);
    emit selectionChanged();
}

} // namespace clothlab
