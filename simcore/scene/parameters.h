// Every scalar parameter of a scene, once: its name in the file, unit, range, default and what it does.
// Files, validation, panels and reports all use this table.
#pragma once

#include "simcore/scene/scene.h"

#include <span>
#include <string_view>

namespace clothlab {

struct Parameter {
    enum class Kind { Real, Integer, Boolean };

    std::string_view id;    // "cloth.ks", "simulation.gravity[1]": its place in the file
    std::string_view label; // in panels
    std::string_view unit;  // in panels; empty if it has none
    std::string_view help;  // one sentence: what it does to cloth or to the picture
    Kind kind;
    double minimum;
    double maximum;
    double sliderMinimum; // the usual range, in the file's unit
    double sliderMaximum;
    bool logarithmic;    // of the slider
    double panelDivisor; // value in panels = value in the file / panelDivisor
    double (*get)(const Scene&);
    void (*set)(Scene&, double); // precondition: minimum <= value <= maximum
    double leastButZero = 0;     // if it is above 0: nothing between minimum, which is 0, and this
    bool powersOfTwo = false;    // only 1, 2, 4, …

    double defaultValue() const { return get(Scene{}); }
    std::string_view object() const { return id.substr(0, id.find('.')); } // "cloth"
    std::string_view key() const { return id.substr(id.find('.') + 1); }   // "ks"
};

std::span<const Parameter> parameters();
const Parameter* findParameter(std::string_view id); // null if there is none

} // namespace clothlab
