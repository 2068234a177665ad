// Whether the system prefers dark or light windows.
#pragma once

#include "app/widgets/theme.h"

#include <QDBusVariant>
#include <QObject>

#include <optional>

namespace clothlab {

// Asks the desktop portal (org.freedesktop.appearance, color-scheme) and listens to it. Nothing where there
// is none, or no preference.
class SystemTheme : public QObject {
    Q_OBJECT

public:
    explicit SystemTheme(QObject* parent = nullptr);

    std::optional<Theme> preference() const { return m_preference; }

signals:
    void changed();

private slots:
    void onSettingChanged(const QString& space, const QString& key, const QDBusVariant& value);

private:
    void take(const QVariant& value);

    std::optional<Theme> m_preference;
};

} // namespace clothlab
