#include "app/window/picture_dialog.h"

#include "app/picture/save_picture.h"
#include "app/render/offscreen_picture.h"
#include "app/viewport/viewport.h"
#include "app/widgets/number_field.h"

#include <QDialogButtonBox>
#include <QDir>
#include <QFileDialog>
#include <QFormLayout>
#include <QPushButton>

namespace clothlab {

PictureDialog::PictureDialog(Viewport& viewport, const QString& shaders, const QString& textures,
                             QWidget* parent)
    : QDialog(parent), m_viewport(viewport), m_shaders(shaders), m_textures(textures),
      m_width(new NumberField), m_height(new NumberField) {
    setWindowTitle(tr("Picture of the View"));
    auto* layout = new QFormLayout(this);
    const auto add = [&](const QString& label, NumberField* field, int pixels) {
        field->setInteger(true);
        field->setRange(1, render::kGreatestPicture);
        field->setUnit(tr("px"));
        field->setAccessibleName(label);
        field->setToolTip(tr("From 1 to %1 pixels").arg(render::kGreatestPicture));
        field->setValue(pixels);
        layout->addRow(label, field);
    };
    add(tr("Width"), m_width, 1920);
    add(tr("Height"), m_height, 1080);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Save | QDialogButtonBox::Close);
    connect(buttons, &QDialogButtonBox::accepted, this, &PictureDialog::chooseAndSave);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::close);
    layout->addRow(buttons);
}

std::optional<QString> PictureDialog::save(const QString& path) const {
    const QSize size(int(m_width->value()), int(m_height->value()));
    render::Problems problems;
    QString reason;
    const auto image =
        render::renderPicture(m_viewport.frameFor(size), size, {m_shaders, m_textures}, problems, reason);
    if (!image)
        return tr("The picture was not made: %1").arg(reason);
    return savePicture(*image, path);
}

void PictureDialog::chooseAndSave() {
    for (NumberField* field : {m_width, m_height})
        field->commit();
    QString path = QFileDialog::getSaveFileName(this, tr("Save a picture of the view"),
                                                QDir::homePath() + "/cloth.png", tr("Pictures (*.png)"));
    if (path.isEmpty())
        return;
    if (!path.endsWith(QLatin1String(".png"), Qt::CaseInsensitive))
        path += QLatin1String(".png");
    if (const auto error = save(path))
        emit problem(*error);
    else
        emit saved(path);
}

} // namespace clothlab
