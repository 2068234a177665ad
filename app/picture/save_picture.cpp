#include "app/picture/save_picture.h"

#include <QCoreApplication>
#include <QSaveFile>

namespace clothlab {

std::optional<QString> savePicture(const QImage& image, const QString& path) {
    QSaveFile file(path);
    if (file.open(QIODevice::WriteOnly) && image.save(&file, "PNG") && file.commit())
        return std::nullopt;
    return QCoreApplication::translate("Picture", "%1: the picture could not be written: %2")
        .arg(path, file.errorString());
}

} // namespace clothlab
