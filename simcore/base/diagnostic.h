// What is wrong with an input: where it is, what it is, and what to do about it.
#pragma once

#include <string>
#include <vector>

namespace clothlab {

enum class Severity { Warning, Error };

struct Diagnostic {
    Severity severity = Severity::Error;
    std::string place;   // "cloth.ks", "line 3, column 7"; empty: the file as a whole
    std::string message; // what is wrong, without a full stop
    std::string remedy;  // what to do, without a full stop; may be empty
};

using Diagnostics = std::vector<Diagnostic>;

bool hasErrors(const Diagnostics& diagnostics);

// "scenes/a.json: cloth.ks: must be a number, is a string; write a number from 0 to 1e+09"
std::string toText(const Diagnostic& diagnostic, const std::string& file);

} // namespace clothlab
