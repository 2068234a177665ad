#include "app/docks/stability_readout.h"

#include "app/widgets/icons.h"
#include "app/widgets/theme.h"

#include <QEvent>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>

#include <algorithm>

namespace clothlab {
namespace {

QString stepsOf(const Stability& stability) {
    if (!stability.stableStepsPerFrame)
        return StabilityReadout::tr("no number of steps up to %1").arg(maxStepsPerFrame());
    const int steps = *stability.stableStepsPerFrame;
    return steps == 1 ? StabilityReadout::tr("1 step per frame")
                      : StabilityReadout::tr("%1 steps per frame").arg(steps);
}

} // namespace

StabilityReadout::StabilityReadout(QWidget* parent)
    : QWidget(parent), m_dtOmegaLabel(new QLabel(QStringLiteral("dt·ω"))), m_sign(new QLabel),
      m_dtOmega(new QLabel), m_stepsLabel(new QLabel(tr("Stable from"))), m_steps(new QLabel) {
    setObjectName("stability");
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(0, 2, 0, 0);
    layout->setHorizontalSpacing(5);
    layout->setVerticalSpacing(3);
    layout->setColumnStretch(1, 1);
    for (QLabel* label : {m_dtOmegaLabel, m_stepsLabel})
        label->setAlignment(Qt::AlignRight | Qt::AlignTop);
    for (QLabel* value : {m_dtOmega, m_steps})
        value->setWordWrap(true); // in a narrow panel
    auto* value = new QHBoxLayout;
    value->setSpacing(5);
    value->addWidget(m_sign, 0, Qt::AlignTop);
    value->addWidget(m_dtOmega, 1);
    layout->addWidget(m_dtOmegaLabel, 0, 0);
    layout->addLayout(value, 0, 1);
    layout->addWidget(m_stepsLabel, 1, 0);
    layout->addWidget(m_steps, 1, 1);
    m_dtOmega->installEventFilter(this);
    setToolTip(
        tr("<b>Stability</b><br>Time step dt times the fastest angular frequency ω of the springs: a bound "
           "from stiffness and mass, for the flat sheet at rest. Beyond the limit (2, or less with strong "
           "damping) each step multiplies the fastest oscillation: the sheet trembles or blows up. More "
           "steps or frames, a lower ks or a higher density make it smaller. Colliders, self-collision, "
           "folds and strain are not in it."));
    color();
}

void StabilityReadout::showStability(const Stability& stability) {
    const StabilityText text = textOf(stability);
    const QString value =
        tr("%1 of %2").arg(QString::fromStdString(text.dtOmega), QString::fromStdString(text.limit));
    m_dtOmega->setText(stability.stable() ? value : tr("%1 – unstable").arg(value));
    m_steps->setText(stepsOf(stability));
    setAccessibleName(tr("Stability: dt·ω %1, stable from %2").arg(m_dtOmega->text(), m_steps->text()));
    m_stable = stability.stable();
    color();
}

QString StabilityReadout::dtOmegaText() const {
    return m_dtOmega->text();
}

QString StabilityReadout::stepsText() const {
    return m_steps->text();
}

void StabilityReadout::color() {
    m_sign->setHidden(m_stable);
    const int size = fontMetrics().height();
    m_sign->setPixmap(themedIcon("warning").pixmap(QSize(size, size), devicePixelRatioF()));
    QPalette palette; // the theme's, where nothing is set
    if (!m_stable)
        palette.setColor(QPalette::WindowText, themeColors().warning);
    m_dtOmega->setPalette(palette);
}

// A style sheet that is applied takes the colour from the label, and says so when it has.
bool StabilityReadout::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_dtOmega && event->type() == QEvent::StyleChange)
        color();
    return QWidget::eventFilter(watched, event);
}

void StabilityReadout::setLabelWidth(int width) {
    m_dtOmegaLabel->setFixedWidth(width);
    m_stepsLabel->setFixedWidth(width);
}

int StabilityReadout::labelWidthHint() const {
    const auto widthOf = [](const QLabel* label) {
        return label->fontMetrics().horizontalAdvance(label->text());
    };
    return std::max(widthOf(m_dtOmegaLabel), widthOf(m_stepsLabel)) + 1;
}

} // namespace clothlab
