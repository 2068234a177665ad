#include "tests/support/scene_text.h"

#include <QtGlobal>

#include <algorithm>
#include <fstream>
#include <iterator>

namespace clothlab::test {

Json courseScene() {
    return Json::parse(R"({
        "cloth": {"damping": 0.2, "density": 150, "ks": 5000, "enable_structural": true, "enable_shearing": true,
                  "enable_bending": true, "orientation": 0, "width": 1, "height": 1, "num_width_points": 50,
                  "num_height_points": 50, "thickness": 0.0095, "pinned": [[0, 0], [49, 0]]},
        "sphere": {"origin": [0.5, 0.2, 0.5], "radius": 0.2, "friction": 0.3},
        "plane": {"point": [0, 0, 0], "normal": [0, 1, 0], "friction": 0.5}})");
}

Json everyKeyScene() {
    Json scene = courseScene();
    scene["simulation"] = Json::parse(
        R"({"gravity": [0, -1.62, 0], "frames_per_second": 60, "steps_per_frame": 40, "seed": 7})");
    scene["appearance"] = Json::parse(R"({"shader": "Mirror", "color": [0.1, 0.2, 0.3],
        "back_color": [0.4, 0, 1], "two_sided": false,
        "springs_drawn": {"structural": true, "shearing": false, "bending": true}, "springs_over_surface": true,
        "springs_colored_by": "strain", "strain_range": 0.05, "light_position": [0.5, 3, -2],
        "light_intensity": [4, 3.5, 3], "shadows": false, "background": [0, 0, 0.25], "ground_grid": false,
        "axes": false, "samples": 8, "mesh_resolution": 128, "normal_scaling": -3, "height_scaling": 0.02,
        "textures": {"texture_1": "linen.png", "texture_2": "../felt.png", "texture_3": "c:\\\\silk.png",
                     "texture_4": "/tmp/wool \u00fc.png"}, "cubemap": "sky",
        "uniforms": {"Checks": {"u_cells": 8, "u_map": "map.png", "u_on": true, "u_tint": [1, 0, 0.5]},
                     "Phong": {"u_roughness": 0.5}}})");
    scene["camera"] =
        Json::parse(R"({"target": [0.5, 0.5, 0.5], "distance": 3, "azimuth": 30, "elevation": 20})");
    return scene;
}

std::string courseText() {
    return test::courseScene().dump();
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from);
    if (at == std::string::npos)
        qFatal("no %s", from.c_str());
    return text.replace(at, from.size(), to);
}

// What is wrong with how a bad file was answered; empty if nothing is.
std::string badAnswer(const SceneReading& reading) {
    if (reading.scene)
        return "there is a scene";
    if (!hasErrors(reading.diagnostics))
        return "there is no error";
    for (const Diagnostic& d : reading.diagnostics) {
        if (d.message.empty() || (d.severity == Severity::Error && d.remedy.empty()))
            return "an error lacks words: " + clothlab::toText(d, "");
        if (d.message.size() + d.place.size() > 1000)
            return "an error is longer than a screen";
    }
    return "";
}

std::string toText(const Diagnostics& diagnostics) {
    std::string text;
    for (const Diagnostic& d : diagnostics)
        text += (d.severity == Severity::Error ? "error: " : "warning: ") + clothlab::toText(d, "") + "\n";
    return text;
}

const Diagnostic* find(const Diagnostics& diagnostics, Severity severity, const std::string& place) {
    const auto found = std::find_if(diagnostics.begin(), diagnostics.end(), [&](const Diagnostic& d) {
        return d.severity == severity && d.place == place;
    });
    return found == diagnostics.end() ? nullptr : &*found;
}

std::string scenePath(const std::string& name) {
    return CLOTHLAB_SOURCE_DIR "/scenes/" + name;
}

std::string readText(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

} // namespace clothlab::test
