// Colours of a shader's text.
#include "app/widgets/glsl_highlighter.h"
#include "app/widgets/theme.h"

#include <QTest>
#include <QTextBlock>
#include <QTextDocument>
#include <QTextLayout>

using namespace clothlab;

class TestGlslHighlighter : public QObject {
    Q_OBJECT

private slots:
    void wordsAndNumbersAndDirectives() {
        QCOMPARE(marked("#version 330"), "############");
        QCOMPARE(marked("uniform vec3 u_x;"), "wwwwwww wwww     ");
        QCOMPARE(marked("float f2 = 2.5e-3;"), "wwwww      nnnnnn ");
        QCOMPARE(marked("my_uniform = vec31;"), "                   ");
    }

    void commentsCoverEverything() {
        QCOMPARE(marked("x; // float 3"), "   cccccccccc");
        QCOMPARE(marked("a /* b */ c /* d */ // e"), "  ccccccc   ccccccc cccc");
        QCOMPARE(marked("a /*/ b"), "  ccccc");
        QCOMPARE(marked("/* a // b */ 1"), "cccccccccccc n");
    }

    void commentsGoOnOverLines() { QCOMPARE(marked("a /* b\n\nfloat\n*/ 1\n2"), "  cccc\n\nccccc\ncc n\nn"); }

private:
    // A letter for each character: w word, n number, # directive, c comment.
    static QString marked(const QString& text) {
        const ThemeColors& colors = themeColors();
        QTextDocument document;
        GlslHighlighter highlighter(&document);
        document.setPlainText(text);
        highlighter.rehighlight();
        QStringList lines;
        for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
            QString line(block.text().size(), ' ');
            for (const QTextLayout::FormatRange& range : block.layout()->formats()) {
                const QColor color = range.format.foreground().color();
                const char letter = color == colors.link      ? 'w'
                                    : color == colors.warning ? 'n'
                                    : color == colors.pinned  ? '#'
                                    : color == colors.dimText ? 'c'
                                                              : '?';
                line.replace(range.start, range.length, QString(range.length, letter));
            }
            lines << line;
        }
        return lines.join('\n');
    }
};

QTEST_MAIN(TestGlslHighlighter)
#include "tst_glsl_highlighter.moc"
