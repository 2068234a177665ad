#include "app/docks/text.h"

#include "app/widgets/theme.h"

#include <QCoreApplication>

namespace clothlab {

QString typeName(SpringType type) {
    switch (type) {
    case SpringType::Structural:
        return QCoreApplication::translate("SpringType", "Structural");
    case SpringType::Shearing:
        return QCoreApplication::translate("SpringType", "Shearing");
    case SpringType::Bending:
        break;
    }
    return QCoreApplication::translate("SpringType", "Bending");
}

QColor typeColor(SpringType type) {
    const ThemeColors& colors = themeColors();
    const std::array<QColor, kSpringTypes> byType{colors.structural, colors.shearing, colors.bending};
    return byType[std::size_t(type)];
}

QString significant(double value) {
    return QString::number(value, 'g', 6);
}

QString vectorText(const Vec3& v) {
    return QStringLiteral("(%1, %2, %3)").arg(significant(v.x()), significant(v.y()), significant(v.z()));
}

QString groupedNumber(qint64 value) {
    QString text = QString::number(value);
    for (qsizetype i = text.size() - 3; i > (value < 0 ? 1 : 0); i -= 3)
        text.insert(i, QChar(0x202F));
    return text;
}

} // namespace clothlab
