#include "tests/support/program.h"

#include <QProcessEnvironment>

namespace clothlab::test {

QProcessEnvironment noDisplay() {
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char* name : {"DISPLAY", "WAYLAND_DISPLAY", "QT_QPA_PLATFORM"})
        environment.remove(name);
    return environment;
}

void prepare(QProcess& process, const QStringList& arguments) {
    process.setProcessEnvironment(noDisplay());
    process.setProgram(CLOTHLAB_PROGRAM);
    process.setArguments(arguments);
}

ProgramResult finish(QProcess& process) {
    ProgramResult result;
    const bool ended = process.waitForFinished(kProgramHangs);
    result.out = QString::fromUtf8(process.readAllStandardOutput());
    result.err = QString::fromUtf8(process.readAllStandardError());
    if (ended && process.exitStatus() == QProcess::NormalExit)
        result.status = process.exitCode();
    return result;
}

ProgramResult runProgram(const QStringList& arguments, const QStringList& environment) {
    QProcess process;
    prepare(process, arguments);
    QProcessEnvironment variables = process.processEnvironment();
    for (const QString& variable : environment)
        variables.insert(variable.section('=', 0, 0), variable.section('=', 1));
    process.setProcessEnvironment(variables);
    process.start();
    return finish(process);
}

nlohmann::json report(const QString& text) {
    return nlohmann::json::parse(text.toStdString(), nullptr, false);
}

} // namespace clothlab::test
