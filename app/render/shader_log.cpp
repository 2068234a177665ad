#include "app/render/shader_log.h"

#include <QRegularExpression>

namespace clothlab::render {
namespace {

QString readableLine(const QString& file, const QString& line) {
    static const QRegularExpression mesaOrNvidia(
        QStringLiteral(R"(^\d+(?::(\d+)(?:\(\d+\))?|\((\d+)\))\s*:\s*(.*)$)"));
    static const QRegularExpression leadingWord(QStringLiteral(R"(^(ERROR|WARNING):\s*\d+:(\d+):\s*(.*)$)"));

    if (const auto match = mesaOrNvidia.match(line); match.hasMatch()) {
        const QString number = match.captured(1).isEmpty() ? match.captured(2) : match.captured(1);
        return QStringLiteral("%1:%2: %3").arg(file, number, match.captured(3));
    }
    if (const auto match = leadingWord.match(line); match.hasMatch())
        return QStringLiteral("%1:%2: %3: %4")
            .arg(file, match.captured(2), match.captured(1).toLower(), match.captured(3));
    return QStringLiteral("%1: %2").arg(file, line);
}

} // namespace

QStringList readableShaderLog(const QString& file, const QString& log) {
    QStringList readable;
    const QStringList lines = log.split(u'\n', Qt::SkipEmptyParts);
    for (const QString& line : lines)
        if (const QString trimmed = line.trimmed(); !trimmed.isEmpty())
            readable.append(readableLine(file, trimmed));
    return readable;
}

} // namespace clothlab::render
