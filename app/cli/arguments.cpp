#include "app/cli/arguments.h"

#include <QRegularExpression>

#include <cstdio>

namespace clothlab::cli {

int fail(ExitStatus status, const QString& message) {
    std::fprintf(stderr, "clothlab: %s\n", qPrintable(message));
    return status;
}

QString readInteger(const QCommandLineParser& parser, const QString& option, int minimum, int maximum,
                    std::optional<int>& value) {
    if (!parser.isSet(option))
        return {};
    bool ok = false;
    const int number = parser.value(option).toInt(&ok);
    if (!ok || number < minimum || number > maximum)
        return QStringLiteral("--%1 takes a whole number from %2 to %3, not '%4'")
            .arg(option)
            .arg(minimum)
            .arg(maximum)
            .arg(parser.value(option));
    value = number;
    return {};
}

QString readNumber(const QCommandLineParser& parser, const QString& option, double minimum, double maximum,
                   double& value) {
    if (!parser.isSet(option))
        return {};
    bool ok = false;
    const double number = parser.value(option).toDouble(&ok);
    if (!ok || !(number >= minimum && number <= maximum))
        return QStringLiteral("--%1 takes a number from %2 to %3, not '%4'")
            .arg(option)
            .arg(minimum)
            .arg(maximum)
            .arg(parser.value(option));
    value = number;
    return {};
}

std::optional<QSize> readSize(const QString& text) {
    static const QRegularExpression pattern("^([1-9]\\d{1,4})x([1-9]\\d{1,4})$");
    const QRegularExpressionMatch match = pattern.match(text);
    if (!match.hasMatch())
        return std::nullopt;
    return QSize(match.captured(1).toInt(), match.captured(2).toInt());
}

} // namespace clothlab::cli
