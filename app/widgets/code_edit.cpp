#include "app/widgets/code_edit.h"

#include "app/widgets/glsl_highlighter.h"
#include "app/widgets/theme.h"

#include <QFontDatabase>
#include <QKeyEvent>
#include <QPainter>
#include <QTextBlock>

#include <algorithm>
#include <utility>

namespace clothlab {
namespace {

constexpr int kMarginPadding = 6;

} // namespace

class CodeEdit::Margin : public QWidget {
public:
    explicit Margin(CodeEdit* edit) : QWidget(edit), m_edit(edit) {}

protected:
    void paintEvent(QPaintEvent* event) override { m_edit->paintMargin(event); }

private:
    CodeEdit* m_edit;
};

CodeEdit::CodeEdit(QWidget* parent)
    : QPlainTextEdit(parent), m_margin(new Margin(this)), m_highlighter(new GlslHighlighter(document())) {
    setFont(QFontDatabase::systemFont(QFontDatabase::FixedFont));
    setLineWrapMode(NoWrap);
    constexpr int tabColumns = 4;
    setTabStopDistance(tabColumns * fontMetrics().horizontalAdvance(QLatin1Char(' ')));
    connect(this, &QPlainTextEdit::blockCountChanged, this, &CodeEdit::placeMargin);
    connect(this, &QPlainTextEdit::updateRequest, this, [this](const QRect& rect, int dy) {
        if (dy != 0)
            m_margin->scroll(0, dy);
        else
            m_margin->update(0, rect.y(), m_margin->width(), rect.height());
    });
    placeMargin();
}

void CodeEdit::goToLine(int line) {
    const QTextBlock block = document()->findBlockByNumber(line - 1);
    if (!block.isValid())
        return;
    setTextCursor(QTextCursor(block));
    centerCursor();
}

void CodeEdit::setMarkedLines(QList<int> lines) {
    m_marked = std::move(lines);
    markLines();
    m_margin->update();
}

void CodeEdit::markLines() {
    QList<QTextEdit::ExtraSelection> selections;
    for (const int line : m_marked) {
        QTextEdit::ExtraSelection selection;
        selection.cursor = QTextCursor(document()->findBlockByNumber(line - 1));
        QColor color = themeColors().error;
        color.setAlpha(50);
        selection.format.setBackground(color);
        selection.format.setProperty(QTextFormat::FullWidthSelection, true);
        selections.append(selection);
    }
    setExtraSelections(selections);
}

int CodeEdit::marginWidth() const {
    const auto digits = QString::number(std::max(blockCount(), 99)).size();
    return 2 * kMarginPadding + int(digits) * fontMetrics().horizontalAdvance(QLatin1Char('9'));
}

void CodeEdit::placeMargin() {
    setViewportMargins(marginWidth(), 0, 0, 0);
    const QRect inside = contentsRect();
    m_margin->setGeometry(inside.left(), inside.top(), marginWidth(), inside.height());
}

void CodeEdit::paintMargin(QPaintEvent* event) {
    const ThemeColors& colors = themeColors();
    QPainter painter(m_margin);
    painter.setFont(font());
    painter.fillRect(event->rect(), colors.window);
    for (QTextBlock block = firstVisibleBlock(); block.isValid(); block = block.next()) {
        const QRectF place = blockBoundingGeometry(block).translated(contentOffset());
        if (place.top() > event->rect().bottom())
            break;
        const int line = block.blockNumber() + 1;
        painter.setPen(m_marked.contains(line) ? colors.error : colors.dimText);
        painter.drawText(QRectF(0, place.top(), m_margin->width() - kMarginPadding, place.height()),
                         Qt::AlignRight, QString::number(line));
    }
}

bool CodeEdit::event(QEvent* event) {
    // Before the window's own key of that name.
    if (event->type() == QEvent::ShortcutOverride &&
        static_cast<QKeyEvent*>(event)->matches(QKeySequence::Save)) {
        event->accept();
        return true;
    }
    if (event->type() == QEvent::KeyPress && static_cast<QKeyEvent*>(event)->matches(QKeySequence::Save)) {
        emit saveAsked();
        return true;
    }
    return QPlainTextEdit::event(event);
}

void CodeEdit::resizeEvent(QResizeEvent* event) {
    QPlainTextEdit::resizeEvent(event);
    placeMargin();
}

void CodeEdit::changeEvent(QEvent* event) {
    QPlainTextEdit::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_margin) {
        m_highlighter->rehighlight();
        markLines();
    }
    if (event->type() == QEvent::FontChange && m_margin)
        placeMargin();
}

} // namespace clothlab
