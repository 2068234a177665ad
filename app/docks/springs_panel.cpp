#include "app/docks/springs_panel.h"

#include "app/docks/text.h"
#include "app/widgets/check_box.h"

#include <QEvent>
#include <QGridLayout>
#include <QPixmap>

namespace clothlab {

void setSpringsDrawn(Document& document, SpringType type, bool drawn) {
    Scene after = document.scene();
    after.appearance.springsDrawn[std::size_t(type)] = drawn;
    const QString name = typeName(type).toLower();
    document.edit(drawn ? SpringsPanel::tr("show %1 springs").arg(name)
                        : SpringsPanel::tr("hide %1 springs").arg(name),
                  std::move(after));
}

SpringsPanel::SpringsPanel(Document& document, QWidget* parent) : QWidget(parent), m_document(document) {
    auto* layout = new QGridLayout(this);
    layout->setContentsMargins(10, 8, 10, 8);
    layout->setColumnStretch(0, 1);
    int row = 0;
    for (const SpringType type : {SpringType::Structural, SpringType::Shearing, SpringType::Bending}) {
        auto* box = new CheckBox(typeName(type));
        box->setObjectName("draw_" + typeName(type).toLower());
        connect(box, &QCheckBox::clicked, this,
                [this, type](bool checked) { setSpringsDrawn(m_document, type, checked); });
        auto* count = new QLabel;
        count->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
        count->setAccessibleName(tr("Number of %1 springs").arg(typeName(type).toLower()));
        layout->addWidget(box, row, 0);
        layout->addWidget(count, row++, 1);
        m_types[std::size_t(type)] = box;
        m_counts[std::size_t(type)] = count;
    }
    m_total = new QLabel;
    m_total->setAlignment(Qt::AlignRight);
    layout->addWidget(new QLabel(tr("All")), row, 0);
    layout->addWidget(m_total, row++, 1);

    m_overSurface = new CheckBox(tr("Over shaded surfaces too"));
    m_overSurface->setToolTip(tr("Draw the springs with every shader, not only with Wireframe."));
    connect(m_overSurface, &QCheckBox::clicked, this, [this](bool checked) {
        Scene after = m_document.scene();
        after.appearance.springsOverSurface = checked;
        m_document.edit(tr("change springs over the surface"), std::move(after));
    });
    layout->addWidget(m_overSurface, row++, 0, 1, 2);
    m_byStrain = new CheckBox(tr("Colour by strain"));
    m_byStrain->setObjectName("colorByStrain");
    m_byStrain->setToolTip(
        tr("Colour each spring by how far it is stretched or compressed, instead of by its type."));
    connect(m_byStrain, &QCheckBox::clicked, this, [this](bool checked) {
        Scene after = m_document.scene();
        after.appearance.springColoring = checked ? SpringColoring::ByStrain : SpringColoring::ByType;
        m_document.edit(tr("change the colours of springs"), std::move(after));
    });
    layout->addWidget(m_byStrain, row++, 0, 1, 2);
    layout->setRowStretch(row, 1);

    colorBoxes();
    connect(&document, &Document::sceneChanged, this, &SpringsPanel::showScene);
    connect(&document, &Document::sceneReplaced, this, &SpringsPanel::showScene);
    showScene();
}

void SpringsPanel::colorBoxes() {
    for (const SpringType type : {SpringType::Structural, SpringType::Shearing, SpringType::Bending}) {
        QPixmap swatch(24, 24);
        swatch.fill(typeColor(type));
        m_types[std::size_t(type)]->setIcon(swatch);
        m_types[std::size_t(type)]->setIconSize({12, 12});
    }
}

void SpringsPanel::changeEvent(QEvent* event) {
    if (event->type() == QEvent::PaletteChange && m_total)
        colorBoxes();
    QWidget::changeEvent(event);
}

void SpringsPanel::showScene() {
    const Appearance& appearance = m_document.scene().appearance;
    const bool visible = appearance.shader == "Wireframe" || appearance.springsOverSurface;
    for (const SpringType type : {SpringType::Structural, SpringType::Shearing, SpringType::Bending}) {
        QCheckBox* box = m_types[std::size_t(type)];
        box->setChecked(appearance.springsDrawn[std::size_t(type)]);
        box->setEnabled(visible);
        box->setToolTip(
            visible ? tr("Draw %1 springs. What they do to the cloth stays the same.")
                          .arg(typeName(type).toLower())
                    : tr("Springs are drawn by the shader Wireframe, or with \"Over shaded surfaces too\"."));
        m_counts[std::size_t(type)]->setText(groupedNumber(m_document.grid().springCount(type)));
    }
    m_overSurface->setChecked(appearance.springsOverSurface);
    m_byStrain->setChecked(appearance.springColoring == SpringColoring::ByStrain);
    m_total->setText(groupedNumber(m_document.grid().springCount()));
}

} // namespace clothlab
