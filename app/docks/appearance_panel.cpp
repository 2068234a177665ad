#include "app/docks/appearance_panel.h"

#include "app/widgets/parameter_row.h"
#include "app/widgets/theme.h"

#include <QColorDialog>
#include <QFormLayout>
#include <QPainter>

namespace clothlab {
namespace {

QColor colorOf(const Appearance& appearance) {
    return QColor::fromRgbF(float(appearance.color[0]), float(appearance.color[1]),
                            float(appearance.color[2]));
}

} // namespace

void setShader(Document& document, const QString& shader) {
    Scene after = document.scene();
    after.appearance.shader = shader.toStdString();
    document.edit(AppearancePanel::tr("shader %1").arg(shader), std::move(after));
}

void showShader(QComboBox& box, const QString& shader) {
    if (box.findText(shader) < 0)
        box.addItem(shader);
    box.setCurrentText(shader);
}

AppearancePanel::AppearancePanel(Document& document, const QStringList& shaders, QWidget* parent)
    : QWidget(parent), m_document(document), m_shader(new QComboBox), m_color(new QToolButton) {
    auto* layout = new QFormLayout(this);
    layout->setContentsMargins(10, 8, 10, 8);
    layout->setLabelAlignment(Qt::AlignRight);

    m_shader->addItems(shaders);
    m_shader->setAccessibleName(tr("Shader"));
    m_shader->setToolTip(tr("The .frag files in the folder of shaders. Wireframe draws the springs."));
    connect(m_shader, &QComboBox::textActivated, this,
            [this](const QString& shader) { setShader(m_document, shader); });
    layout->addRow(tr("Shader"), m_shader);

    m_color->setObjectName("sheetColor");
    m_color->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    m_color->setAccessibleName(tr("Colour of the sheet"));
    m_color->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_color->setToolTip(tr("Colour of the sheet, u_color of the shaders."));
    connect(m_color, &QToolButton::clicked, this, &AppearancePanel::chooseColor);
    layout->addRow(tr("Colour"), m_color);

    connect(&document, &Document::sceneChanged, this, &AppearancePanel::showScene);
    connect(&document, &Document::sceneReplaced, this, &AppearancePanel::showScene);
    showScene();
}

void AppearancePanel::chooseColor() {
    if (!m_dialog) {
        m_dialog = new QColorDialog(this);
        m_dialog->setWindowTitle(tr("Colour of the sheet"));
        m_dialog->setOptions(QColorDialog::NoButtons | QColorDialog::DontUseNativeDialog);
        m_dialog->setModal(false);
        // What is chosen while the dialog stays open is one undo step.
        connect(m_dialog, &QColorDialog::currentColorChanged, this,
                [this](const QColor& color) { setColor(color, m_dialog->property("gesture").toInt()); });
    }
    m_dialog->setProperty("gesture", ParameterRow::newGesture());
    m_dialog->setCurrentColor(colorOf(m_document.scene().appearance));
    m_dialog->show();
    m_dialog->raise();
}

void AppearancePanel::setColor(const QColor& color, int gesture) {
    // The dialog also tells of colours that it was given.
    if (color.rgb() == colorOf(m_document.scene().appearance).rgb())
        return;
    Scene after = m_document.scene();
    after.appearance.color = {color.red() / 255.0, color.green() / 255.0, color.blue() / 255.0};
    m_document.edit(tr("change colour"), std::move(after), gesture);
}

void AppearancePanel::showScene() {
    const Appearance& appearance = m_document.scene().appearance;
    showShader(*m_shader, QString::fromStdString(appearance.shader));
    // Framed, so that white is seen on a light panel.
    QPixmap swatch(40, 24);
    swatch.fill(themeColors().dimText);
    QPainter(&swatch).fillRect(swatch.rect().adjusted(2, 2, -2, -2), colorOf(appearance));
    m_color->setIcon(swatch);
    m_color->setText(colorOf(appearance).name());
    if (m_dialog && m_dialog->isVisible())
        m_dialog->setCurrentColor(colorOf(appearance));
}

} // namespace clothlab
