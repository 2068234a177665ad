#include "app/render/uniform_spec.h"

#include <QColor>
#include <QRegularExpression>

#include <algorithm>

namespace clothlab::render {
namespace {

const QString kNumber = QStringLiteral(R"([+-]?(?:\d+\.?\d*|\.\d+)(?:[eE][+-]?\d+)?)");

QRegularExpression anchored(const QString& pattern) {
    return QRegularExpression(u'^' + pattern + QStringLiteral(R"(\s*)"));
}

// u_sheen_tint is shown as "Sheen tint".
QString inWords(const QString& name) {
    QString words = name.startsWith(QLatin1String("u_")) ? name.mid(2) : name;
    words.replace(u'_', u' ');
    if (!words.isEmpty())
        words[0] = words[0].toUpper();
    return words;
}

bool namesAColor(const QString& name) {
    return name.endsWith(QLatin1String("color"), Qt::CaseInsensitive) ||
           name.endsWith(QLatin1String("colour"), Qt::CaseInsensitive);
}

// Takes what it understands from the front of a comment, until nothing more is.
class CommentReader {
public:
    CommentReader(UniformSpec& spec, const QString& text) : m_spec(spec), m_rest(text.trimmed()) {}

    void read() {
        while (!m_rest.isEmpty() && !m_labelled &&
               (readLabel() || readRange() || readWord() || readHexColor() || readTuple() || readNumber() ||
                readFile()))
            ;
        m_spec.help = m_rest;
    }

private:
    bool take(const QRegularExpression& expression) {
        m_match = expression.match(m_rest);
        if (m_match.hasMatch())
            m_rest.remove(0, m_match.capturedLength());
        return m_match.hasMatch();
    }

    bool readLabel() {
        static const QRegularExpression label = anchored(QStringLiteral(R"re("([^"]+)")re"));
        if (!take(label))
            return false;
        m_spec.label = m_match.captured(1);
        m_labelled = true;
        return true;
    }

    bool readRange() {
        static const QRegularExpression range =
            anchored(QStringLiteral(R"(\[\s*(%1)\s*,\s*(%1)\s*\])").arg(kNumber));
        if (!take(range))
            return false;
        const float low = m_match.captured(1).toFloat();
        const float high = m_match.captured(2).toFloat();
        if (low < high)
            m_spec.range = {low, high};
        return true;
    }

    bool readWord() {
        static const QRegularExpression word = anchored(
            QStringLiteral(R"((color|colour|srgb|true|false)\b(?!\s+(?!color|colour|srgb)[a-z]+(?:\s|$)))"));
        if (!take(word))
            return false;
        const QString taken = m_match.captured(1);
        if (taken == QLatin1String("srgb"))
            m_spec.srgb = true;
        else if (taken.startsWith(QLatin1String("colo")))
            m_spec.color = true;
        else
            m_spec.initial.numbers[0] = taken == QLatin1String("true") ? 1 : 0;
        return true;
    }

    bool readHexColor() {
        static const QRegularExpression hex = anchored(QStringLiteral(R"((#[0-9A-Fa-f]{6})\b)"));
        if (componentsOf(m_spec.type) < 3 || !take(hex))
            return false;
        const QColor color(m_match.captured(1));
        m_spec.initial.numbers = {color.redF(), color.greenF(), color.blueF(), 1};
        m_spec.color = true;
        return true;
    }

    bool readTuple() {
        static const QRegularExpression tuple =
            anchored(QStringLiteral(R"(\(\s*(%1(?:\s*,\s*%1){1,3})\s*\))").arg(kNumber));
        if (!take(tuple))
            return false;
        const QStringList numbers = m_match.captured(1).split(u',');
        if (numbers.size() == m_spec.initial.components)
            for (qsizetype i = 0; i < numbers.size(); ++i)
                m_spec.initial.numbers[static_cast<std::size_t>(i)] = numbers[i].trimmed().toFloat();
        return true;
    }

    bool readNumber() {
        static const QRegularExpression number = anchored(QStringLiteral(R"((%1)(?![\w.]))").arg(kNumber));
        if (m_spec.initial.components != 1 || !take(number))
            return false;
        m_spec.initial.numbers[0] = m_match.captured(1).toFloat();
        return true;
    }

    bool readFile() {
        static const QRegularExpression file = anchored(QStringLiteral(R"(([^\s"]+\.(?:png|jpg|jpeg)))"));
        if (m_spec.type != UniformSpec::Type::Sampler2D || !take(file))
            return false;
        m_spec.initial.file = m_match.captured(1);
        return true;
    }

    UniformSpec& m_spec;
    QString m_rest;
    bool m_labelled = false;
    QRegularExpressionMatch m_match;
};

} // namespace

int componentsOf(UniformSpec::Type type) {
    switch (type) {
    case UniformSpec::Type::Bool:
    case UniformSpec::Type::Int:
    case UniformSpec::Type::Float:
        return 1;
    case UniformSpec::Type::Vec2:
        return 2;
    case UniformSpec::Type::Vec3:
        return 3;
    case UniformSpec::Type::Vec4:
        return 4;
    case UniformSpec::Type::Sampler2D:
        return 0;
    }
    return 0;
}

void annotate(UniformSpec& spec, const std::vector<QByteArray>& sources) {
    spec.initial.components = componentsOf(spec.type);
    const QRegularExpression declaration(
        QStringLiteral(R"(^[ \t]*uniform[ \t]+\w+[ \t]+%1[ \t]*(?:=[^;\n]*)?;[ \t]*//(.*)$)")
            .arg(QRegularExpression::escape(spec.name)),
        QRegularExpression::MultilineOption);
    QRegularExpressionMatch match;
    if (std::any_of(sources.rbegin(), sources.rend(), [&](const QByteArray& source) {
            match = declaration.match(QString::fromUtf8(source));
            return match.hasMatch();
        }))
        CommentReader(spec, match.captured(1)).read();
    if (spec.label.isEmpty())
        spec.label = inWords(spec.name);
    const int components = componentsOf(spec.type);
    spec.color = components >= 3 && (spec.color || namesAColor(spec.name));
}

} // namespace clothlab::render
