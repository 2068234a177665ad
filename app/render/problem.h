// What is wrong with a file that a picture is made of.
#pragma once

#include <QFileInfo>
#include <QList>
#include <QMetaType>
#include <QString>

namespace clothlab::render {

struct Problem {
    QString path;
    int line = 0; // from 1; 0: the file as a whole
    QString text;
    friend bool operator==(const Problem&, const Problem&) = default;
};

using Problems = QList<Problem>;

// "Phong.frag:12: reason", with the file's name only.
inline QString words(const Problem& problem) {
    const QString file = QFileInfo(problem.path).fileName();
    const QString place = problem.line > 0 ? QStringLiteral("%1:%2").arg(file).arg(problem.line) : file;
    return QStringLiteral("%1: %2").arg(place, problem.text);
}

} // namespace clothlab::render

Q_DECLARE_METATYPE(clothlab::render::Problem)
