#include "simcore/scene/scene_io.h"

#include "simcore/base/read_file.h"
#include "simcore/base/whole_file.h"

#include <algorithm>
#include <exception>
#include <ostream>

namespace clothlab {
namespace {

const Diagnostic* firstError(const Diagnostics& diagnostics) {
    const auto found = std::find_if(diagnostics.begin(), diagnostics.end(),
                                    [](const Diagnostic& d) { return d.severity == Severity::Error; });
    return found == diagnostics.end() ? nullptr : &*found;
}

std::optional<std::string> saveChecked(const Scene& scene, const std::string& path) {
    if (const auto diagnostics = validate(scene); const Diagnostic* error = firstError(diagnostics))
        return "the scene is not valid: " + toText(*error, "");
    const std::string text = writeScene(scene);
    // A file that could not be opened again would be worth nothing: it may be too large or nested too deep.
    if (const auto reading = readScene(text); const Diagnostic* error = firstError(reading.diagnostics))
        return "the scene could not be read back: " + toText(*error, "");
    return writeFileWhole(path, [&](std::ostream& out) { out << text; });
}

} // namespace

SceneReading loadScene(const std::string& path) {
    FileText file = readFile(path, kMaxSceneBytes);
    if (!file.text)
        return {std::nullopt, std::move(file.diagnostics)};
    return readScene(*file.text);
}

std::optional<std::string> saveScene(const Scene& scene, const std::string& path) {
    try {
        return saveChecked(scene, path);
    } catch (const std::exception&) {
        return "the scene does not fit into the memory; close other programs and try again";
    }
}

} // namespace clothlab
