// What the window asks of the session that it is started in.
#include "app/window/system_theme.h"

#include <QGuiApplication>
#include <QTemporaryDir>
#include <QTest>

using namespace clothlab;

class TestSystemTheme : public QObject {
    Q_OBJECT

private slots:
    void noBusIsStartedWhereASessionHasNone();
};

// The D-Bus library would run dbus-launch, and wait for it.
void TestSystemTheme::noBusIsStartedWhereASessionHasNone() {
    const QTemporaryDir folder;
    QFile launcher(folder.filePath("dbus-launch"));
    QVERIFY(launcher.open(QIODevice::WriteOnly));
    const QString trace = folder.filePath("was launched");
    launcher.write("#!/bin/sh\ntouch '" + trace.toUtf8() + "'\nexit 1\n");
    launcher.close();
    QVERIFY(launcher.setPermissions(QFile::ReadOwner | QFile::ExeOwner));
    qputenv("PATH", folder.path().toUtf8() + ':' + qgetenv("PATH"));
    qputenv("XDG_RUNTIME_DIR", folder.path().toUtf8());
    qunsetenv("DBUS_SESSION_BUS_ADDRESS");
    qputenv("DISPLAY", ":none"); // where there is one, it looks there first

    const SystemTheme theme;
    QVERIFY(!QFile::exists(trace));
    QVERIFY(!theme.preference());
}

QTEST_MAIN(TestSystemTheme)
#include "tst_system_theme.moc"
