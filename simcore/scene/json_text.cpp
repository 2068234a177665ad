#include "simcore/scene/json_text.h"

#include <nlohmann/json.hpp>

#include <array>
#include <charconv>
#include <cmath>

namespace clothlab::json {
namespace {

std::string_view trimmed(std::string_view text) {
    return text.substr(skipSpace(text, 0));
}

// Where the string that text starts with ends, quotes included.
std::size_t stringLength(std::string_view text) {
    std::size_t at = 1;
    while (at < text.size() && text[at] != '"')
        at += text[at] == '\\' ? 2 : 1;
    return std::min(at + 1, text.size());
}

std::size_t nestedLength(std::string_view text) {
    int depth = 0;
    std::size_t at = 0;
    do {
        const char c = text[at];
        if (c == '"') {
            at += stringLength(text.substr(at));
            continue;
        }
        depth += c == '[' || c == '{' ? 1 : c == ']' || c == '}' ? -1 : 0;
        ++at;
    } while (depth > 0 && at < text.size());
    return at;
}

// Cuts the value off that text starts with, and what space follows it.
Value take(std::string_view& text) {
    std::size_t length = 0;
    switch (text.front()) {
    case '"':
        length = stringLength(text);
        break;
    case '[':
    case '{':
        length = nestedLength(text);
        break;
    default:
        length = skipWord(text, 0);
    }
    const Value value{text.substr(0, length)};
    text = trimmed(text.substr(length));
    return value;
}

// Cuts off a comma, a colon or nothing.
void skip(std::string_view& text, char mark) {
    if (!text.empty() && text.front() == mark)
        text = trimmed(text.substr(1));
}

std::string respaced(std::string_view text, bool spaces) {
    std::string result;
    result.reserve(text.size());
    for (std::size_t at = 0; at < text.size();) {
        const char c = text[at];
        const std::size_t length = c == '"' ? stringLength(text.substr(at)) : 1;
        if (!isSpace(c))
            result += text.substr(at, length);
        if (spaces && (c == ',' || c == ':'))
            result += ' ';
        at += length;
    }
    return result;
}

} // namespace

std::size_t skipSpace(std::string_view text, std::size_t at) {
    while (at < text.size() && isSpace(text[at]))
        ++at;
    return at;
}

std::size_t skipWord(std::string_view text, std::size_t at) {
    while (at < text.size() && !endsWord(text[at]))
        ++at;
    return at;
}

Type Value::type() const {
    switch (text.front()) {
    case 'n':
        return Type::Null;
    case 't':
    case 'f':
        return Type::Boolean;
    case '"':
        return Type::String;
    case '[':
        return Type::Array;
    case '{':
        return Type::Object;
    default:
        return Type::Number;
    }
}

double Value::number() const {
    double value = 0;
    const auto result = std::from_chars(text.data(), text.data() + text.size(), value);
    return result.ec == std::errc{} ? value : 0; // checkJson() refuses what is too large
}

std::string Value::string() const {
    if (text.find('\\') == std::string_view::npos)
        return std::string(text.substr(1, text.size() - 2));
    return nlohmann::json::parse(text).get<std::string>();
}

Value parse(std::string_view text) {
    std::string_view rest = trimmed(text);
    return take(rest);
}

std::vector<Member> members(Value object) {
    std::vector<Member> result;
    std::string_view rest = trimmed(object.text.substr(1));
    while (!rest.empty() && rest.front() != '}') {
        const Value key = take(rest);
        skip(rest, ':');
        const Value value = take(rest);
        skip(rest, ',');
        result.push_back({key.string(), key.text, value});
    }
    return result;
}

std::optional<Value> Elements::next() {
    m_rest = trimmed(m_rest);
    if (m_rest.empty() || m_rest.front() == ']')
        return std::nullopt;
    const Value value = take(m_rest);
    skip(m_rest, ',');
    return value;
}

std::string compact(std::string_view text) {
    return respaced(text, false);
}

std::string spaced(std::string_view text) {
    return respaced(text, true);
}

std::string quoted(std::string_view utf8) {
    using Json = nlohmann::json;
    return Json(utf8).dump(-1, ' ', false, Json::error_handler_t::replace);
}

std::string numberText(double finite) {
    // The very shortest form would write 100000 as 1e+05.
    const double size = std::abs(finite);
    const bool plain = size == 0 || (size >= 1e-5 && size < 1e15);
    std::array<char, 64> buffer{};
    const auto format = plain ? std::chars_format::fixed : std::chars_format::scientific;
    const auto result = std::to_chars(buffer.data(), buffer.data() + buffer.size(), finite, format);
    return {buffer.data(), result.ptr};
}

} // namespace clothlab::json
