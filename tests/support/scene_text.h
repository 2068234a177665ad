// Scene files to take apart.
#pragma once

#include "simcore/scene/scene_io.h"

#include <nlohmann/json.hpp>

#include <string>

namespace clothlab::test {

using Json = nlohmann::ordered_json;

Json courseScene();   // every key that the course's loader asks for, one sphere, one plane
Json everyKeyScene(); // as well as every key of ours, none at its default

std::string courseText(); // of courseScene(), without space

std::string replaced(std::string text, const std::string& from,
                     const std::string& to); // once; from must be there

// What is wrong with how a bad file was answered; empty if nothing is.
std::string badAnswer(const SceneReading& reading);

// Each diagnostic on a line, for failure messages.
std::string toText(const Diagnostics& diagnostics);

// The first of a severity at a place; null if there is none.
const Diagnostic* find(const Diagnostics& diagnostics, Severity severity, const std::string& place);

std::string scenePath(const std::string& name); // of a scene in scenes/

std::string readText(const std::string& path); // empty if it cannot be read

} // namespace clothlab::test
