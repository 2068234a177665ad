// Scenes from and to JSON: the course's format and our extensions of it (docs: README, "Scene files").
#pragma once

#include "simcore/base/diagnostic.h"
#include "simcore/scene/scene.h"

#include <optional>
#include <string>
#include <string_view>

namespace clothlab {

struct SceneReading {
    std::optional<Scene> scene; // a valid scene, or nothing if there is any error
    Diagnostics diagnostics;    // errors and warnings
};

inline constexpr std::size_t kMaxSceneBytes = 16U << 20U;

// A missing key takes its default, with a warning; an unknown one is kept, with a warning. Out-of-range
// values, wrong types, duplicate keys, text that is not UTF-8 JSON, and more than 64 levels are errors.
SceneReading readScene(std::string_view json);
SceneReading loadScene(const std::string& path);

// Only what the course's format has, where that says it all; further keys only for values that are not at
// their default. Numbers are written so that they read back as the same bits. Precondition: validate() finds
// no errors.
std::string writeScene(const Scene& scene);

// Returns what went wrong, in words. The file is written whole or not at all; not if the scene has errors or
// could not be read back.
std::optional<std::string> saveScene(const Scene& scene, const std::string& path);

// Errors: values that no solver could run. Warnings: values that are likely a mistake.
Diagnostics validate(const Scene& scene);

} // namespace clothlab
