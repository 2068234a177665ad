#include "app/document/scene_files.h"

#include "simcore/scene/range.h"

#include <QDir>

#include <functional>
#include <string>
#include <utility>
#include <variant>

namespace clothlab {
namespace {

Scene withFiles(Scene scene, const std::function<QString(const QString&)>& renamed) {
    const auto rename = [&](std::string& name) {
        if (name.empty())
            return;
        // One that would be too long for a scene stays as it is.
        if (std::string other = renamed(QString::fromStdString(name)).toStdString();
            other.size() <= kMaxFileNameBytes)
            name = std::move(other);
    };
    for (std::string& texture : scene.appearance.textures)
        rename(texture);
    rename(scene.appearance.cubemap);
    for (auto& [shader, values] : scene.appearance.uniforms)
        for (auto& [name, value] : values)
            if (auto* file = std::get_if<std::string>(&value))
                rename(*file);
    return scene;
}

} // namespace

Scene withAbsoluteFiles(Scene scene, const QString& folder) {
    return withFiles(std::move(scene),
                     [&](const QString& name) { return QDir::cleanPath(QDir(folder).filePath(name)); });
}

Scene withRelativeFiles(Scene scene, const QString& folder) {
    return withFiles(std::move(scene),
                     [&](const QString& name) { return QDir(folder).relativeFilePath(name); });
}

} // namespace clothlab
