#include "simcore/scene/json_check.h"

#include "simcore/scene/json_syntax_error.h"
#include "simcore/scene/json_text.h"
#include "simcore/scene/utf8.h"

#include <algorithm>
#include <charconv>
#include <set>
#include <vector>

namespace clothlab::json {
namespace {

Diagnostic error(std::string place, std::string message, std::string remedy) {
    return {Severity::Error, std::move(place), std::move(message), std::move(remedy)};
}

bool isDigit(char c) {
    return c >= '0' && c <= '9';
}

bool isNumber(std::string_view text) {
    const auto digits = [&text] {
        const std::size_t count = std::find_if_not(text.begin(), text.end(), isDigit) - text.begin();
        text.remove_prefix(count);
        return count > 0;
    };
    const auto skip = [&text](std::string_view marks) {
        const bool found = !text.empty() && marks.find(text.front()) != std::string_view::npos;
        text.remove_prefix(found ? 1 : 0);
        return found;
    };
    skip("-");
    if (!skip("0") && !digits())
        return false;
    if (skip(".") && !digits())
        return false;
    if (skip("eE")) {
        skip("+-");
        if (!digits())
            return false;
    }
    return text.empty();
}

// e of a number d.ddd · 10^e, up to one. Of a number that is not zero.
std::int64_t decimalExponent(std::string_view number) {
    constexpr std::int64_t kHuge = std::int64_t(1) << 60;
    std::int64_t exponent = 0;
    const std::size_t mark = std::min(number.find_first_of("eE"), number.size());
    if (mark < number.size()) {
        std::string_view digits = number.substr(mark + 1);
        const bool isNegative = digits.front() == '-';
        digits.remove_prefix(isNegative || digits.front() == '+' ? 1 : 0);
        const auto result = std::from_chars(digits.data(), digits.data() + digits.size(), exponent);
        exponent = result.ec == std::errc{} ? std::min(exponent, kHuge) : kHuge;
        exponent = isNegative ? -exponent : exponent;
    }
    const std::string_view mantissa = number.substr(0, mark);
    const auto point = static_cast<std::int64_t>(std::min(mantissa.find('.'), mantissa.size()));
    const auto leading = static_cast<std::int64_t>(mantissa.find_first_of("123456789"));
    return exponent + point - leading;
}

// Whether a number or word is more than a double can hold.
bool isTooLarge(std::string_view text) {
    constexpr std::size_t kNeverTooLong = 300; // digits
    double value = 0;
    if (text.size() <= kNeverTooLong && text.find_first_of("eE") == std::string_view::npos)
        return false;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    return result.ec == std::errc::result_out_of_range && decimalExponent(text) > 0;
}

// Walks through UTF-8 text by the grammar of RFC 8259 and stops at the first fault. A library's parser would
// do, but the ones at hand keep what they read for their messages: up to half a gigabyte for a file of 16 MB.
// A test compares this one with theirs.
class Checker {
public:
    explicit Checker(std::string_view text) : m_text(text) {}

    std::optional<Diagnostic> check() {
        if (value()) {
            skipSpace();
            if (m_at < m_text.size())
                unexpected(Expected::End);
        }
        return std::move(m_fault);
    }

private:
    struct Level {
        bool isArray = false;
        std::size_t index = 0; // of the value at hand
        std::string key;       // of the value at hand
        std::set<std::string> keys;
    };

    char peek() const { return m_at < m_text.size() ? m_text[m_at] : '\0'; }

    bool accept(char c) {
        if (peek() != c)
            return false;
        ++m_at;
        return true;
    }

    void skipSpace() { m_at = json::skipSpace(m_text, m_at); }

    bool value() {
        skipSpace();
        switch (peek()) {
        case '{':
            return nested(false);
        case '[':
            return nested(true);
        case '"':
            return string();
        default:
            return word();
        }
    }

    bool nested(bool isArray) {
        if (m_levels.size() == kMaxLevels)
            return fail("is nested more than " + std::to_string(kMaxLevels) + " levels deep",
                        "check that it is the right file, or nest its lists and objects less");
        m_levels.push_back({isArray, 0, {}, {}});
        ++m_at;
        if (!(isArray ? elements() : members()))
            return false;
        m_openKeys -= m_levels.back().keys.size();
        m_levels.pop_back();
        return true;
    }

    bool elements() {
        skipSpace();
        if (accept(']'))
            return true;
        for (;; ++m_levels.back().index) {
            if (!value())
                return false;
            skipSpace();
            if (accept(']'))
                return true;
            if (!accept(','))
                return unexpected(Expected::CommaOrBracket);
        }
    }

    bool members() {
        skipSpace();
        if (accept('}'))
            return true;
        for (;;) {
            if (!key() || !value())
                return false;
            skipSpace();
            if (accept('}'))
                return true;
            if (!accept(','))
                return unexpected(Expected::CommaOrBrace);
        }
    }

    bool key() {
        skipSpace();
        const std::size_t begin = m_at;
        if (peek() != '"')
            return unexpected(Expected::Key);
        if (!string())
            return false;
        Level& level = m_levels.back();
        std::string key = Value{m_text.substr(begin, m_at - begin)}.string();
        level.key = shortened(key);
        if (!level.keys.insert(std::move(key)).second)
            return fail("is there twice in the same object", "remove one of the two");
        if (++m_openKeys > kMaxKeys)
            return fail("is one key too many: there are more than " + std::to_string(kMaxKeys),
                        "check that it is the right file");
        skipSpace();
        return accept(':') || unexpected(Expected::Colon);
    }

    bool string() {
        const std::size_t begin = m_at++;
        while (m_at < m_text.size() && m_text[m_at] != '"') {
            const auto c = static_cast<unsigned char>(m_text[m_at]);
            if (c < 0x20)
                return fault(describeControlCharacter(m_text, begin));
            if (c == '\\' && !escape())
                return fault(describeEscape(m_text, m_at));
            m_at += c == '\\' ? 0 : 1;
        }
        return accept('"') || fault(describeUnclosedString(m_text, begin));
    }

    // Leaves m_at behind the character, or at it if it is none.
    bool escape() {
        const char kind = m_at + 1 < m_text.size() ? m_text[m_at + 1] : '\0';
        if (kind != 'u') {
            m_at += 2;
            const bool known = std::string_view("\"\\/bfnrt").find(kind) != std::string_view::npos;
            m_at -= known ? 0 : 2;
            return known;
        }
        const std::optional<unsigned> first = codeUnit(m_at);
        const bool isHigh = first && *first >= 0xD800 && *first < 0xDC00;
        const bool isLow = first && *first >= 0xDC00 && *first < 0xE000;
        const std::optional<unsigned> second = isHigh ? codeUnit(m_at + 6) : std::nullopt;
        if (!first || isLow || (isHigh && !(second && *second >= 0xDC00 && *second < 0xE000)))
            return false;
        m_at += isHigh ? 12 : 6;
        return true;
    }

    // Of \uXXXX at a place.
    std::optional<unsigned> codeUnit(std::size_t at) const {
        if (m_text.size() < at + 6 || m_text.substr(at, 2) != "\\u")
            return std::nullopt;
        unsigned unit = 0;
        const char* begin = m_text.data() + at + 2;
        const auto result = std::from_chars(begin, begin + 4, unit, 16);
        return result.ptr == begin + 4 ? std::optional(unit) : std::nullopt;
    }

    bool word() {
        const std::size_t end = skipWord(m_text, m_at);
        const std::string_view text = m_text.substr(m_at, end - m_at);
        if (text == "true" || text == "false" || text == "null" || isNumber(text)) {
            if (isTooLarge(text))
                return fault(describeNumberOverflow(m_text, m_at));
            m_at = end;
            return true;
        }
        return unexpected(Expected::Value);
    }

    bool fault(Diagnostic diagnostic) {
        m_fault = std::move(diagnostic);
        return false;
    }

    bool unexpected(Expected expected) { return fault(describeUnexpected(m_text, m_at, expected)); }

    bool fail(std::string message, std::string remedy) {
        return fault(error(path(), std::move(message), std::move(remedy)));
    }

    std::string path() const {
        constexpr std::size_t kShownLevels = 8;
        std::string path;
        for (std::size_t i = 0; i < std::min(m_levels.size(), kShownLevels); ++i) {
            const Level& level = m_levels[i];
            if (level.isArray)
                path += "[" + std::to_string(level.index) + "]";
            else
                path += (path.empty() ? "" : ".") + level.key;
        }
        return m_levels.size() > kShownLevels ? path + "…" : path;
    }

    std::string_view m_text;
    std::size_t m_at = 0;
    std::vector<Level> m_levels;
    std::size_t m_openKeys = 0;
    std::optional<Diagnostic> m_fault;
};

Diagnostic describeEncoding(std::string_view text, std::size_t offset) {
    const std::string_view start = text.substr(0, 2);
    if (start == "\xFF\xFE" || start == "\xFE\xFF" || text.substr(0, 4).find('\0') != std::string_view::npos)
        return error("", "is not UTF-8 text; it looks like UTF-16 or a binary file",
                     "save it as UTF-8, or check that it is the right file");
    return error(placeOf(text, offset), "is not UTF-8 text from here on",
                 "save the file as UTF-8, or check that it is the right file");
}

} // namespace

std::optional<Diagnostic> checkJson(std::string_view text) {
    const std::size_t offset = firstNotUtf8(text);
    if (offset < text.size())
        return describeEncoding(text, offset);
    if (skipSpace(text, 0) == text.size())
        return error("", "is empty", "check that it is the right file, or save the scene again");
    return Checker(text).check();
}

} // namespace clothlab::json
