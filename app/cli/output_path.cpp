#include "app/cli/output_path.h"

#include <QRegularExpression>

namespace clothlab::cli {

std::optional<OutputPath> OutputPath::parse(const QString& text) {
    static const QRegularExpression conversion("%(%|(?:0([1-9]))?d)?");
    OutputPath path;
    qsizetype end = 0;
    for (auto it = conversion.globalMatch(text); it.hasNext();) {
        const QRegularExpressionMatch match = it.next();
        QString& part = path.isSequence() ? path.m_after : path.m_before;
        part += text.mid(end, match.capturedStart() - end);
        end = match.capturedEnd();
        if (match.captured(1) == "%")
            part += '%';
        else if (match.captured(1).isEmpty() || path.isSequence())
            return std::nullopt;
        else
            path.m_width = match.captured(2).toInt();
    }
    (path.isSequence() ? path.m_after : path.m_before) += text.mid(end);
    return path;
}

QString OutputPath::forFrame(int frame) const {
    if (!isSequence())
        return m_before;
    return m_before + QString::number(frame).rightJustified(m_width, '0') + m_after;
}

} // namespace clothlab::cli
