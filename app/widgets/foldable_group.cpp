#include "app/widgets/foldable_group.h"

#include "app/widgets/theme.h"

#include <QKeyEvent>
#include <QPainter>
#include <QPainterPath>
#include <QToolButton>
#include <QVBoxLayout>

namespace clothlab {

namespace {

constexpr int kArrowLeft = 6;
constexpr int kTextLeft = 20;

class Header : public QToolButton {
public:
    explicit Header(QWidget* parent) : QToolButton(parent) {
        setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        setFocusPolicy(Qt::TabFocus);
        setCheckable(true); // checked is open, which assistive tools can tell
        setChecked(true);
    }

    QSize sizeHint() const override {
        return {kTextLeft + fontMetrics().horizontalAdvance(text()) + 8, fontMetrics().height() + 7};
    }
    QSize minimumSizeHint() const override { return {kTextLeft, sizeHint().height()}; }

protected:
    void keyPressEvent(QKeyEvent* event) override {
        if (event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) {
            click();
        } else {
            event->ignore();
        }
    }

    void paintEvent(QPaintEvent*) override {
        const ThemeColors& colors = themeColors();
        QPainter painter(this);
        painter.fillRect(rect(), underMouse() && isEnabled() ? colors.hover : colors.window);
        painter.setPen(isEnabled() ? colors.text : colors.disabledText);
        const QRect textRect = rect().adjusted(kTextLeft, 0, -4, 0);
        painter.drawText(textRect, Qt::AlignLeft | Qt::AlignVCenter,
                         fontMetrics().elidedText(text(), Qt::ElideRight, textRect.width()));
        painter.setRenderHint(QPainter::Antialiasing);
        paintArrow(painter, isEnabled() ? colors.dimText : colors.disabledText);
        if (hasFocus()) {
            painter.setPen(colors.accent);
            painter.setBrush(Qt::NoBrush);
            painter.drawRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5));
        }
    }

private:
    // To the right when folded, down when open.
    void paintArrow(QPainter& painter, const QColor& color) const {
        painter.save();
        painter.translate(kArrowLeft + 4, height() / 2.0);
        painter.rotate(isChecked() ? 90 : 0);
        painter.setPen(QPen(color, 1.6, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPolyline(QPolygonF({{-1.8, -3.6}, {1.8, 0}, {-1.8, 3.6}}));
        painter.restore();
    }
};

} // namespace

FoldableGroup::FoldableGroup(const QString& title, QWidget* parent)
    : QWidget(parent), m_header(new Header(this)), m_content(new QWidget(this)),
      m_contentLayout(new QVBoxLayout(m_content)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_header);
    layout->addWidget(m_content);
    m_contentLayout->setContentsMargins(8, 5, 6, 7);
    m_contentLayout->setSpacing(3);
    setTitle(title);
    connect(m_header, &QToolButton::toggled, this, [this](bool open) { setFolded(!open); });
}

QString FoldableGroup::title() const {
    return m_header->text();
}

void FoldableGroup::setTitle(const QString& title) {
    m_header->setText(title);
    m_header->setAccessibleName(title);
}

void FoldableGroup::setFolded(bool folded) {
    if (folded == m_folded) {
        return;
    }
    m_folded = folded;
    m_content->setVisible(!folded);
    m_header->setChecked(!folded);
    emit foldedChanged(folded);
}

} // namespace clothlab
