#include "app/window/message_bar.h"

#include "app/widgets/icons.h"
#include "app/widgets/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QToolButton>

namespace clothlab {

MessageBar::MessageBar(QWidget* parent) : QWidget(parent), m_icon(new QLabel), m_text(new QLabel) {
    setObjectName("messageBar");
    setAutoFillBackground(true);
    m_text->setWordWrap(true);
    m_text->setTextFormat(Qt::PlainText);
    m_text->setTextInteractionFlags(Qt::TextSelectableByMouse);
    auto* close = new QToolButton;
    close->setObjectName("closeMessage");
    close->setIcon(themedIcon("close"));
    close->setAutoRaise(true);
    close->setFocusPolicy(Qt::NoFocus);
    close->setToolTip(tr("Close this message. It stays in Output."));
    connect(close, &QToolButton::clicked, this, &QWidget::hide);

    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(10, 6, 6, 6);
    layout->addWidget(m_icon);
    layout->addWidget(m_text, 1);
    layout->addWidget(close);
    colorText();
    hide();
}

void MessageBar::colorText() {
    m_icon->setPixmap(themedIcon("error").pixmap(20, 20));
}

void MessageBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && m_icon)
        colorText();
    QWidget::changeEvent(event);
}

void MessageBar::showProblem(const QString& text) {
    m_text->setText(text);
    show();
}

} // namespace clothlab
