#include "app/docks/scene_difference.h"

#include "app/docks/text.h"
#include "app/widgets/number_text.h"
#include "simcore/scene/parameters.h"

#include <QCoreApplication>

namespace clothlab {
namespace {

QString valueText(const Parameter& parameter, double value) {
    if (parameter.kind == Parameter::Kind::Boolean)
        return value == 0 ? QCoreApplication::translate("Parameter", "off")
                          : QCoreApplication::translate("Parameter", "on");
    return shortText(value / parameter.panelDivisor);
}

QString difference(const Parameter& parameter, double before, double after) {
    const QString label = QCoreApplication::translate("Parameter", std::string(parameter.label).c_str());
    QString text =
        QStringLiteral("%1 %2 → %3").arg(label, valueText(parameter, before), valueText(parameter, after));
    if (!parameter.unit.empty())
        text += QChar(0x202F) + toQString(parameter.unit);
    return text;
}

} // namespace

QStringList differences(const Scene& before, const Scene& after) {
    QStringList texts;
    for (const Parameter& parameter : parameters())
        if (parameter.object() != "appearance" && parameter.get(before) != parameter.get(after))
            texts << difference(parameter, parameter.get(before), parameter.get(after));
    if (before.cloth.pinned != after.cloth.pinned)
        texts << QCoreApplication::translate("Parameter", "other pins");
    if (before.spheres != after.spheres || before.planes != after.planes)
        texts << QCoreApplication::translate("Parameter", "other colliders");
    return texts;
}

} // namespace clothlab
