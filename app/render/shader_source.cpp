#include "app/render/shader_source.h"
#include "app/render/words.h"

#include <QFile>
#include <QFileInfo>
#include <QRegularExpression>

namespace clothlab::render {
namespace {

constexpr qint64 kMostShaderBytes = 1 << 20;
constexpr int kMostFiles = 64;

class Reader {
public:
    Reader(ShaderSource& source, const QString& builtIn, Problems& problems)
        : m_source(source), m_builtIn(builtIn), m_problems(problems) {}

    bool add(const QString& path) {
        QFile file(path);
        if (const QFileInfo info(path); info.exists() && !info.isFile()) // a folder, pipe or device
            return fail(path, 0, tr("is no ordinary file"));
        if (!file.open(QIODevice::ReadOnly))
            return fail(path, 0, tr("cannot be read: %1").arg(file.errorString()));
        if (file.size() > kMostShaderBytes)
            return fail(path, 0, tr("is larger than 1 MiB"));
        QByteArray text = file.readAll();
        if (text.startsWith("\xEF\xBB\xBF"))
            text.remove(0, 3); // some editors write a byte order mark, and GLSL wants #version first
        const auto number = m_source.files.size();
        m_source.files.append(path);
        if (number > 0)
            addLineDirective(1, number);
        return addLines(path, text, number);
    }

private:
    bool addLines(const QString& path, const QByteArray& text, qsizetype number) {
        static const QRegularExpression include(
            QStringLiteral(R"re(^\s*#\s*include\s+"([^"/\\]+)"\s*(?://.*)?$)re"));
        int line = 0;
        for (QByteArray each : text.split('\n')) {
            ++line;
            if (each.endsWith('\r'))
                each.chop(1);
            const QRegularExpressionMatch match = include.match(QString::fromUtf8(each));
            if (!match.hasMatch()) {
                m_source.text += each + '\n';
                continue;
            }
            if (m_source.files.size() >= kMostFiles)
                return fail(path, line, tr("too many files are included; do they include each other?"));
            const QString included = find(path, match.captured(1));
            if (included.isEmpty())
                return fail(path, line,
                            tr("there is no file %1 beside it to include").arg(match.captured(1)));
            if (!m_source.files.contains(included) && !add(included))
                return false;
            addLineDirective(line + 1, number);
        }
        return true;
    }

    QString find(const QString& from, const QString& name) const {
        for (const QString& candidate : {QFileInfo(from).path() + u'/' + name, m_builtIn + name})
            if (QFileInfo::exists(candidate))
                return candidate;
        return {};
    }

    void addLineDirective(int line, qsizetype number) {
        m_source.text += "#line " + QByteArray::number(number * kLinesPerFile + line) + ' ' +
                         QByteArray::number(number) + '\n';
    }

    bool fail(const QString& path, int line, const QString& reason) {
        m_problems.append({path, line, reason});
        return false;
    }

    ShaderSource& m_source;
    QString m_builtIn;
    Problems& m_problems;
};

} // namespace

std::optional<ShaderSource> readShaderSource(const QString& path, const QString& builtIn,
                                             Problems& problems) {
    ShaderSource source;
    if (!Reader(source, builtIn, problems).add(path))
        return std::nullopt;
    return source;
}

} // namespace clothlab::render
