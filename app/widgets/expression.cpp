#include "app/widgets/expression.h"

#include <QByteArray>
#include <QCoreApplication>

#include <charconv>
#include <cmath>
#include <numbers>

namespace clothlab {

namespace {

constexpr int kMaximumDepth = 64; // a text of a million parentheses must not end the program
constexpr qsizetype kMaximumLength = 1000;

QString tr(const char* text) {
    return QCoreApplication::translate("Expression", text);
}

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

bool isLetter(char c) {
    return c >= 'a' && c <= 'z';
}

// Recursive descent, one function a level of precedence. After the first error every function returns 0 and
// nothing is read any more.
class Parser {
public:
    explicit Parser(const QByteArray& text) : m_text(text) {}

    ExpressionResult run() {
        const double value = sum();
        if (!failed() && !atEnd()) {
            fail(tr("“%1” is not expected here").arg(QLatin1Char(peek())));
        }
        if (!failed() && !std::isfinite(value)) {
            fail(tr("the result is not a finite number"));
        }
        return {failed() ? 0 : value, m_error};
    }

private:
    double sum() {
        double value = product();
        while (!failed()) {
            if (take('+')) {
                value += product();
            } else if (take('-')) {
                value -= product();
            } else {
                break;
            }
        }
        return value;
    }

    double product() {
        double value = signedPower();
        while (!failed()) {
            if (take('*')) {
                value *= signedPower();
            } else if (take('/')) {
                value /= signedPower();
            } else {
                break;
            }
        }
        return value;
    }

    double signedPower() {
        const Nesting nesting(*this);
        if (failed()) {
            return 0;
        }
        if (take('-')) {
            return -signedPower();
        }
        if (take('+')) {
            return signedPower();
        }
        const double base = primary();
        // The exponent may carry a sign of its own and goes first: 2^3^2 is 2^9.
        return take('^') ? std::pow(base, signedPower()) : base;
    }

    double primary() {
        if (take('(')) {
            const double value = sum();
            expectClosing();
            return value;
        }
        const char c = peek();
        if (isDigit(c) || c == '.') {
            return number();
        }
        if (isLetter(c)) {
            return name();
        }
        fail(atEnd() ? tr("a number is missing at the end")
                     : tr("“%1” is not expected here").arg(QLatin1Char(c)));
        return 0;
    }

    double number() {
        double value = 0;
        const char* begin = m_text.constData() + m_position;
        const char* end = m_text.constData() + m_text.size();
        const auto [next, status] = std::from_chars(begin, end, value);
        if (status == std::errc::result_out_of_range) {
            fail(tr("a number is too large or too small"));
        } else if (status != std::errc()) {
            fail(tr("“%1” is not a number").arg(QLatin1Char(*begin)));
        }
        m_position += next - begin;
        return value;
    }

    double name() {
        const qsizetype start = m_position;
        while (isLetter(peek())) {
            ++m_position;
        }
        const QByteArray word = m_text.mid(start, m_position - start);
        if (word == "pi") {
            return std::numbers::pi;
        }
        if (word == "e") {
            return std::numbers::e;
        }
        if (word == "sqrt" && take('(')) {
            const double argument = sum();
            expectClosing();
            return std::sqrt(argument);
        }
        fail(word == "sqrt" ? tr("“sqrt” needs a number in parentheses")
                            : tr("“%1” is not known").arg(QString::fromLatin1(word)));
        return 0;
    }

    void expectClosing() {
        if (!failed() && !take(')')) {
            fail(tr("a “)” is missing"));
        }
    }

    // Every recursion passes through signedPower(), so counting there bounds the stack.
    struct Nesting {
        explicit Nesting(Parser& owner) : parser(owner) {
            if (++parser.m_depth > kMaximumDepth) {
                parser.fail(tr("it is nested too deeply"));
            }
        }
        ~Nesting() { --parser.m_depth; }
        Nesting(const Nesting&) = delete;
        Nesting& operator=(const Nesting&) = delete;
        Parser& parser;
    };

    bool atEnd() const { return m_position >= m_text.size(); }
    char peek() const { return atEnd() ? '\0' : m_text[m_position]; }
    bool failed() const { return !m_error.isEmpty(); }

    bool take(char c) {
        if (failed() || peek() != c) {
            return false;
        }
        ++m_position;
        return true;
    }

    void fail(const QString& error) {
        if (!failed()) {
            m_error = error;
        }
    }

    QByteArray m_text;
    qsizetype m_position = 0;
    int m_depth = 0;
    QString m_error;
};

struct PlainText {
    QByteArray text;
    QString error;
};

// Without spaces and with a decimal point. Pasted text may hold a typographic minus or the letter pi; both
// are clear. "1 2" may be meant as 12 or as two numbers, so it is neither.
PlainText toPlainText(const QString& text) {
    const auto isWord = [](QChar c) { return c.isLetterOrNumber() || c == u'.' || c == u','; };
    QByteArray plain;
    QChar previous;
    bool gap = false;
    for (const QChar c : text) {
        if (c.isSpace()) {
            gap = true;
            continue;
        }
        const bool known = c.unicode() > 32 && c.unicode() < 127;
        if ((gap && isWord(previous) && isWord(c)) || (!known && c != QChar(0x2212) && c != QChar(0x03C0))) {
            return {{}, tr("“%1” is not expected here").arg(c)};
        }
        plain += c == QChar(0x2212) ? "-" : c == QChar(0x03C0) ? "pi" : c == u',' ? "." : "";
        if (known && c != u',') {
            plain += c.toLatin1();
        }
        previous = c;
        gap = false;
    }
    return {plain, {}};
}

} // namespace

ExpressionResult evaluateExpression(const QString& text) {
    if (text.trimmed().isEmpty()) {
        return {0, tr("a number is missing")};
    }
    if (text.size() > kMaximumLength) {
        return {0, tr("it is too long")};
    }
    const PlainText plain = toPlainText(text.toLower());
    return plain.error.isEmpty() ? Parser(plain.text).run() : ExpressionResult{0, plain.error};
}

} // namespace clothlab
