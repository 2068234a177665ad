#include "app/render/shader_log.h"

#include "app/render/shader_source.h"

#include <QRegularExpression>

namespace clothlab::render {
namespace {

Problem readLine(const QStringList& files, const QString& line) {
    static const QRegularExpression mesaOrNvidia(
        QStringLiteral(R"(^(\d+)(?::(\d+)(?:\(\d+\))?|\((\d+)\))\s*:\s*(.*)$)"));
    static const QRegularExpression leadingWord(
        QStringLiteral(R"(^(ERROR|WARNING):\s*(\d+):(\d+):\s*(.*)$)"));
    const auto at = [&](const QString& file, const QString& number, const QString& text) {
        const int counted = number.toInt();
        const int index = counted >= kLinesPerFile ? counted / kLinesPerFile : file.toInt();
        return Problem{files.value(index, files.constFirst()), counted % kLinesPerFile, text};
    };

    if (const auto match = mesaOrNvidia.match(line); match.hasMatch())
        return at(match.captured(1), match.captured(2).isEmpty() ? match.captured(3) : match.captured(2),
                  match.captured(4));
    if (const auto match = leadingWord.match(line); match.hasMatch())
        return at(match.captured(2), match.captured(3),
                  QStringLiteral("%1: %2").arg(match.captured(1).toLower(), match.captured(4)));
    return {files.constFirst(), 0, line};
}

} // namespace

Problems readShaderLog(const QStringList& files, const QString& log) {
    Problems problems;
    const QStringList lines = log.split(u'\n', Qt::SkipEmptyParts);
    for (const QString& line : lines)
        if (const QString trimmed = line.trimmed(); !trimmed.isEmpty())
            problems.append(readLine(files, trimmed));
    return problems;
}

} // namespace clothlab::render
