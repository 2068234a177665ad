#include "app/widgets/button_row.h"

#include "app/widgets/drag_label.h"
#include "app/widgets/icons.h"
#include "app/widgets/parameter_row.h"
#include "app/widgets/theme.h"

#include <QColorDialog>
#include <QEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPainter>
#include <QToolButton>

#include <algorithm>

namespace clothlab {
namespace {

// Framed, so that white is seen on a light panel.
QPixmap swatch(const QColor& color) {
    QPixmap pixmap(40, 24);
    pixmap.fill(color.alpha() > 0 ? themeColors().dimText : color); // nothing, of the same size
    QPainter(&pixmap).fillRect(pixmap.rect().adjusted(2, 2, -2, -2), color);
    return pixmap;
}

} // namespace

ButtonRow::ButtonRow(const QString& label, const QString& toolTip, QWidget* parent)
    : QWidget(parent), m_labelText(label), m_label(new DragLabel(label, this)),
      m_button(new QToolButton(this)), m_reset(new QToolButton(this)) {
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(5);
    layout->addWidget(m_label);
    layout->addWidget(m_button, 1);
    layout->addWidget(m_reset);
    m_label->setCursor(Qt::ArrowCursor);   // here there is nothing to drag
    m_button->setProperty("choice", true); // for the style sheet: it looks like a field
    m_button->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed); // however long the name is
    m_button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_button->setAccessibleName(label);
    m_reset->setIcon(themedIcon("close"));
    m_reset->setIconSize({12, 12});
    m_reset->setAccessibleName(tr("%1: back to the default").arg(label));
    m_reset->setToolTip(tr("Back to the default"));
    // Where there is nothing to go back to, the other button keeps its width.
    QSizePolicy keeps = m_reset->sizePolicy();
    keeps.setRetainSizeWhenHidden(true);
    m_reset->setSizePolicy(keeps);
    m_reset->setFixedWidth(22);
    for (QToolButton* each : {m_button, m_reset})
        each->setFocusPolicy(Qt::TabFocus);
    for (QWidget* each :
         {static_cast<QWidget*>(this), static_cast<QWidget*>(m_label), static_cast<QWidget*>(m_button)})
        each->setToolTip(toolTip);
    connect(m_reset, &QToolButton::clicked, this, &ButtonRow::resetAsked);
}

void ButtonRow::setLabelWidth(int width) {
    m_label->setFixedWidth(width);
}

int ButtonRow::labelWidthHint() const {
    return m_label->fontMetrics().horizontalAdvance(m_labelText) + 1;
}

void ButtonRow::showChoice(const QString& text, bool isDefault) {
    m_choice = text;
    m_reset->setVisible(!isDefault);
    elide();
}

void ButtonRow::elide() {
    constexpr int frame = 18; // around the text
    const int room = m_button->width() - frame - m_button->iconSize().width();
    m_button->setText(m_button->fontMetrics().elidedText(m_choice, Qt::ElideMiddle, std::max(room, 0)));
}

void ButtonRow::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    layout()->activate();
    elide();
}

void ButtonRow::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange)
        refresh();
    QWidget::changeEvent(event);
}

ColorRow::ColorRow(const QString& label, const QString& toolTip, const QString& byDefault, QWidget* parent)
    : ButtonRow(label, toolTip, parent), m_byDefault(byDefault) {
    connect(button(), &QToolButton::clicked, this, &ColorRow::choose);
    ColorRow::refresh();
}

void ColorRow::setColor(const std::optional<QColor>& color, bool isDefault) {
    m_color = color;
    m_isDefault = isDefault;
    refresh();
    if (m_dialog && m_dialog->isVisible() && color && m_dialog->currentColor().rgb() != color->rgb())
        m_dialog->setCurrentColor(*color);
}

void ColorRow::refresh() {
    button()->setIcon(swatch(m_color.value_or(Qt::transparent)));
    showChoice(m_color ? m_color->name() : m_byDefault, m_isDefault);
}

void ColorRow::choose() {
    if (!m_dialog) {
        m_dialog = new QColorDialog(this);
        m_dialog->setWindowTitle(button()->accessibleName());
        m_dialog->setOptions(QColorDialog::NoButtons | QColorDialog::DontUseNativeDialog);
        m_dialog->setModal(false);
        connect(m_dialog, &QColorDialog::currentColorChanged, this, [this](const QColor& color) {
            // The dialog also tells of colours that it was given.
            if (m_dialog->isVisible() && (!m_color || color.rgb() != m_color->rgb()))
                emit edited(color, m_gesture);
        });
    }
    m_gesture = ParameterRow::newGesture();
    m_dialog->setCurrentColor(m_color.value_or(Qt::white));
    m_dialog->show();
    m_dialog->raise();
}

FileRow::FileRow(const QString& label, const QString& toolTip, const QString& byDefault, Kind kind,
                 QWidget* parent)
    : ButtonRow(label, toolTip, parent), m_byDefault(byDefault), m_kind(kind) {
    button()->setIcon(themedIcon("folder"));
    connect(button(), &QToolButton::clicked, this, &FileRow::choose);
    FileRow::refresh();
}

void FileRow::setFile(const QString& path, const QString& folder) {
    m_path = path;
    m_folder = folder;
    refresh();
}

void FileRow::refresh() {
    showChoice(m_path.isEmpty() ? m_byDefault : QFileInfo(m_path).fileName(), m_path.isEmpty());
}

void FileRow::choose() {
    const QString start = m_path.isEmpty() ? m_folder : m_path;
    const QString path =
        m_kind == Kind::Folder
            ? QFileDialog::getExistingDirectory(this, button()->accessibleName(), start)
            : QFileDialog::getOpenFileName(this, button()->accessibleName(), start,
                                           tr("Pictures (*.png *.jpg *.jpeg);;All files (*)"));
    if (!path.isEmpty())
        emit chosen(path);
}

} // namespace clothlab
