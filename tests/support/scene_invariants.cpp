#include "tests/support/scene_invariants.h"

#include "simcore/scene/scene_io.h"

namespace clothlab::test {
namespace {

// 16 MB of text can grow when it is written with spaces and lines; saveScene() refuses what grows too large.
bool isTooLongToReadBack(const std::string& text) {
    return text.size() > kMaxSceneBytes;
}

} // namespace

std::string brokenInvariant(std::string_view text) {
    const SceneReading reading = readScene(text);
    if (reading.scene.has_value() == hasErrors(reading.diagnostics))
        return "a scene and errors, or neither";
    for (const Diagnostic& d : reading.diagnostics) {
        if (d.message.empty())
            return "a diagnostic without a message at " + d.place;
        if (d.severity == Severity::Error && d.remedy.empty())
            return "an error without a remedy: " + toText(d, "");
    }
    if (!reading.scene)
        return "";
    if (hasErrors(validate(*reading.scene)))
        return "a scene that validate() does not accept: " + toText(validate(*reading.scene).front(), "");

    const std::string written = writeScene(*reading.scene);
    if (isTooLongToReadBack(written))
        return "";
    const SceneReading again = readScene(written);
    if (!again.scene)
        return "written text that cannot be read: " + toText(again.diagnostics.front(), "");
    if (*again.scene != *reading.scene)
        return "a scene that changes when it is written and read";
    return writeScene(*again.scene) == written ? "" : "a text that changes when it is read and written";
}

} // namespace clothlab::test
