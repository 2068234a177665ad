// Colours for the text of shaders.
#pragma once

#include <QSyntaxHighlighter>

namespace clothlab {

// Comments, directives, words of the language, and numbers. Takes the colours of the theme; after another one
// was applied, rehighlight().
class GlslHighlighter : public QSyntaxHighlighter {
    Q_OBJECT

public:
    using QSyntaxHighlighter::QSyntaxHighlighter;

protected:
    void highlightBlock(const QString& text) override;

private:
    void colorWords(const QString& text);
    void colorComments(const QString& text);
};

} // namespace clothlab
