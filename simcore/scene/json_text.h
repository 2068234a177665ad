// Values inside JSON text, read where they stand. No tree is built, so a file needs little more memory than
// its own size, and what this version does not know is kept to the letter: 1.50 stays 1.50.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace clothlab::json {

constexpr bool isSpace(char c) {
    return c == ' ' || c == '\n' || c == '\t' || c == '\r';
}
// Whether c cannot be part of a number or of true, false and null.
constexpr bool endsWord(char c) {
    return isSpace(c) || c == ',' || c == ':' || c == '[' || c == ']' || c == '{' || c == '}' || c == '"';
}
// Where the space at a place of text ends, and where the word there does.
std::size_t skipSpace(std::string_view text, std::size_t at);
std::size_t skipWord(std::string_view text, std::size_t at);

enum class Type { Null, Boolean, Number, String, Array, Object };

// The text of one value, without space around it. Everything here relies on text that checkJson() found no
// fault with, and on the type that a function asks for.
struct Value {
    std::string_view text;

    Type type() const;
    bool boolean() const { return text == "true"; }
    double number() const;      // 0 if it is too small for a double
    std::string string() const; // UTF-8
};

struct Member {
    std::string key;          // UTF-8
    std::string_view keyText; // as it stands in the file, with quotes
    Value value;
};

Value parse(std::string_view text); // the one value of a whole text
std::vector<Member> members(Value object);

// Goes through the elements of an array.
class Elements {
public:
    explicit Elements(Value array) : m_rest(array.text.substr(1)) {}
    std::optional<Value> next();

private:
    std::string_view m_rest;
};

std::string compact(std::string_view text); // without space outside strings
std::string spaced(std::string_view text);  // compact text with a space after each comma and colon

std::string quoted(std::string_view utf8);
std::string numberText(double finite); // the shortest that reads back as the same bits

} // namespace clothlab::json
