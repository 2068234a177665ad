#include "app/window/message_bar.h"

#include "app/widgets/icons.h"
#include "app/widgets/theme.h"

#include <QEvent>
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
    m_answers = new QHBoxLayout;
    layout->addLayout(m_answers);
    layout->addWidget(close);
    colorText();
    hide();
}

void MessageBar::colorText() {
    m_icon->setPixmap(themedIcon(m_offers ? "info" : "error").pixmap(20, 20));
}

void MessageBar::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && m_icon)
        colorText();
    QWidget::changeEvent(event);
}

void MessageBar::showProblem(const QString& text) {
    m_offers = false;
    showText(text, {});
}

void MessageBar::closeProblem() {
    if (!m_offers)
        hide();
}

void MessageBar::offer(const QString& text, const QList<QAction*>& answers) {
    m_offers = true;
    showText(text, answers);
}

void MessageBar::showText(const QString& text, const QList<QAction*>& answers) {
    while (QLayoutItem* item = m_answers->takeAt(0)) {
        item->widget()->deleteLater(); // it may have been clicked just now
        delete item;
    }
    for (QAction* answer : answers) {
        auto* button = new QToolButton;
        answer->setParent(button);
        button->setDefaultAction(answer);
        button->setObjectName(answer->objectName());
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        button->setFocusPolicy(Qt::NoFocus);
        connect(answer, &QAction::triggered, this, &QWidget::hide);
        m_answers->addWidget(button);
    }
    colorText();
    m_text->setText(text);
    show();
}

} // namespace clothlab
