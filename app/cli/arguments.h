// What the commands share about their arguments and their end.
#pragma once

#include "app/cli/exit_status.h"

#include <QCommandLineParser>
#include <QSize>
#include <QString>

#include <optional>

namespace clothlab::cli {

// Says it on standard error; returns the status.
int fail(ExitStatus status, const QString& message);

// The value of an option that takes a whole number, or what is wrong with it, in words; empty if nothing is.
QString readInteger(const QCommandLineParser& parser, const QString& option, int minimum, int maximum,
                    std::optional<int>& value);

// The same of an option that takes a number.
QString readNumber(const QCommandLineParser& parser, const QString& option, double minimum, double maximum,
                   double& value);

// "1280x800"; nothing if it is anything else.
std::optional<QSize> readSize(const QString& text);

} // namespace clothlab::cli
