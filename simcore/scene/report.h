// Collects diagnostics. A file can hold millions of mistakes; nobody reads more than the first few.
#pragma once

#include "simcore/base/diagnostic.h"

#include <array>
#include <cstddef>

namespace clothlab {

class Report {
public:
    static constexpr std::size_t kMaxOfEach = 50; // errors, and as many warnings

    void error(std::string place, std::string message, std::string remedy) {
        add({Severity::Error, std::move(place), std::move(message), std::move(remedy)});
    }
    void warn(std::string place, std::string message, std::string remedy) {
        add({Severity::Warning, std::move(place), std::move(message), std::move(remedy)});
    }

    std::size_t errors() const { return m_count[std::size_t(Severity::Error)]; }
    std::size_t warnings() const { return m_count[std::size_t(Severity::Warning)]; }
    // One more error would not be kept, so it is not worth looking for.
    bool full() const { return errors() > kMaxOfEach; }

    Diagnostics take() {
        constexpr const char* kRemedy = "correct those that are listed and try again";
        if (errors() > kMaxOfEach)
            m_diagnostics.push_back({Severity::Error, "", "there are more errors than are listed", kRemedy});
        if (warnings() > kMaxOfEach)
            m_diagnostics.push_back(
                {Severity::Warning, "", "there are more warnings than are listed", kRemedy});
        return std::move(m_diagnostics);
    }

private:
    void add(Diagnostic diagnostic) {
        if (++m_count[std::size_t(diagnostic.severity)] <= kMaxOfEach)
            m_diagnostics.push_back(std::move(diagnostic));
    }

    Diagnostics m_diagnostics;
    std::array<std::size_t, 2> m_count{};
};

} // namespace clothlab
