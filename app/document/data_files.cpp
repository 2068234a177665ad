#include "app/document/data_files.h"

#include <QCoreApplication>
#include <QDir>

namespace clothlab {

QString dataDirectory(const QString& name) {
    const QString program = QCoreApplication::applicationDirPath();
    const QString source = QStringLiteral(CLOTHLAB_SOURCE_DIR);
    QStringList candidates{program + "/../share/clothlab/" + name};
    if (QDir(program).absolutePath().startsWith(QDir(source).absolutePath())) {
        candidates.prepend(source + "/resources/" + name);
        candidates.prepend(source + "/" + name);
    }
    for (const QString& candidate : candidates)
        if (QDir(candidate).exists())
            return QDir(candidate).absolutePath();
    return {};
}

} // namespace clothlab
