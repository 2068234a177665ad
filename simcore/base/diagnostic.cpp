#include "simcore/base/diagnostic.h"

#include <algorithm>

namespace clothlab {

bool hasErrors(const Diagnostics& diagnostics) {
    return std::any_of(diagnostics.begin(), diagnostics.end(),
                       [](const Diagnostic& d) { return d.severity == Severity::Error; });
}

std::string toText(const Diagnostic& diagnostic, const std::string& file) {
    std::string text;
    for (const std::string* part : {&file, &diagnostic.place}) {
        if (!part->empty())
            text += *part + ": ";
    }
    text += diagnostic.message;
    if (!diagnostic.remedy.empty())
        text += "; " + diagnostic.remedy;
    return text;
}

} // namespace clothlab
