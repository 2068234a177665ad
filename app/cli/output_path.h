#pragma once

#include <QString>

#include <optional>

namespace clothlab::cli {

// A file name that may hold one %d or %0Nd in its place for the frame number.
class OutputPath {
public:
    // Nothing if the name holds another conversion or more than one. "%%" stands for a percent sign.
    static std::optional<OutputPath> parse(const QString& text);

    bool isSequence() const { return m_width >= 0; }
    QString forFrame(int frame) const; // the same for every frame if this is no sequence

private:
    QString m_before, m_after;
    int m_width = -1;
};

} // namespace clothlab::cli
