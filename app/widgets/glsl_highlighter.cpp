#include "app/widgets/glsl_highlighter.h"

#include "app/widgets/theme.h"

#include <QRegularExpression>

namespace clothlab {
namespace {

// What a block hands on to the next.
enum BlockState { Code = 0, InComment = 1 };

const QRegularExpression& words() {
    static const QRegularExpression expression(
        "\\b(?:uniform|in|out|inout|flat|noperspective|smooth|const|layout|struct|void|bool|u?int|float|"
        "double|"
        "[biu]?vec[234]|mat[234](?:x[234])?|[iu]?sampler(?:1D|2D|3D|Cube)(?:Array)?(?:Shadow)?|if|else|for|"
        "while|do|"
        "switch|case|default|break|continue|return|discard|true|false)\\b");
    return expression;
}

const QRegularExpression& numbers() {
    static const QRegularExpression expression("\\b(?:\\d+\\.?\\d*|\\.\\d+)(?:[eE][+-]?\\d+)?[fuFU]?\\b");
    return expression;
}

const QRegularExpression& directives() {
    static const QRegularExpression expression("^\\s*#.*$");
    return expression;
}

} // namespace

void GlslHighlighter::highlightBlock(const QString& text) {
    colorWords(text);
    colorComments(text);
}

void GlslHighlighter::colorWords(const QString& text) {
    const ThemeColors& colors = themeColors();
    const std::initializer_list<std::pair<const QRegularExpression&, QColor>> rules{
        {words(), colors.link}, {numbers(), colors.warning}, {directives(), colors.pinned}};
    for (const auto& [expression, color] : rules) {
        for (auto it = expression.globalMatch(text); it.hasNext();) {
            const QRegularExpressionMatch match = it.next();
            setFormat(int(match.capturedStart()), int(match.capturedLength()), color);
        }
    }
}

// Over everything else.
void GlslHighlighter::colorComments(const QString& text) {
    static const QRegularExpression start("//|/\\*");
    bool inside = previousBlockState() == InComment;
    setCurrentBlockState(inside && text.isEmpty() ? InComment : Code);
    qsizetype at = 0;
    while (at < text.size()) {
        const qsizetype begin = inside ? at : text.indexOf(start, at);
        if (begin < 0)
            return;
        const bool toLineEnd = !inside && text[begin + 1] == QLatin1Char('/');
        const qsizetype close = toLineEnd ? -1 : text.indexOf("*/", inside ? begin : begin + 2);
        if (!toLineEnd && close < 0)
            setCurrentBlockState(InComment);
        at = close < 0 ? text.size() : close + 2;
        setFormat(int(begin), int(at - begin), themeColors().dimText);
        inside = false;
    }
}

} // namespace clothlab
