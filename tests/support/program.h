// Runs the real program, as a user without a display does.
#pragma once

#include <nlohmann/json.hpp>

#include <QProcess>
#include <QStringList>

namespace clothlab::test {

struct ProgramResult {
    int status = -1; // -1: it crashed, hung or could not be started
    QString out, err;
};

inline constexpr int kProgramHangs = 240'000; // ms; longer than any run here takes on any machine

// An environment without a display. QProcess::setProcessEnvironment() takes it.
QProcessEnvironment noDisplay();

// Prepares a run of the program without starting it.
void prepare(QProcess& process, const QStringList& arguments);

// Waits for the end of a started run.
ProgramResult finish(QProcess& process);

// Further variables of its environment as "NAME=value".
ProgramResult runProgram(const QStringList& arguments, const QStringList& environment = {});

// The report that a run printed or wrote; discarded if it is not JSON.
nlohmann::json report(const QString& text);

} // namespace clothlab::test
