#include "simcore/scene/json_syntax_error.h"

#include "simcore/scene/json_text.h"
#include "simcore/scene/utf8.h"

#include <algorithm>

namespace clothlab::json {
namespace {

struct Words {
    std::string message;
    std::string remedy;
};

Diagnostic error(std::string_view text, std::size_t offset, Words words) {
    return {Severity::Error, placeOf(text, offset), std::move(words.message), std::move(words.remedy)};
}

// The word, mark or string that starts at offset, as a message shows it.
std::string tokenAt(std::string_view text, std::size_t offset) {
    const bool isMark = endsWord(text[offset]);
    std::size_t end = offset + 1;
    if (text[offset] == '"')
        end = std::min(text.find_first_of("\"\n", end), text.size() - 1) + 1;
    else if (!isMark)
        end = skipWord(text, offset);
    return shortened(text.substr(offset, end - offset));
}

// The last mark before a place; 0 if there is none.
char markBefore(std::string_view text, std::size_t offset) {
    const std::size_t before =
        offset == 0 ? std::string_view::npos : text.find_last_not_of(" \t\r\n", offset - 1);
    return before == std::string_view::npos ? '\0' : text[before];
}

bool contains(std::string_view text, std::string_view lowerCaseWord) {
    const auto same = [](char a, char b) { return (a >= 'A' && a <= 'Z' ? char(a + ('a' - 'A')) : a) == b; };
    return std::search(text.begin(), text.end(), lowerCaseWord.begin(), lowerCaseWord.end(), same) !=
           text.end();
}

// What takes the place of a value or a key.
Words describeStranger(const std::string& token) {
    const char first = token.front();
    if (first == '/' || first == '#')
        return {"a comment is not part of JSON", "remove the comment"};
    if (first == '\'')
        return {"text in single quotes is not part of JSON", "write double quotes"};
    if (contains(token, "nan") || contains(token, "inf"))
        return {token + " is not a number that a scene can hold", "write a finite number"};
    if (std::string_view("+-.0123456789").find(first) != std::string_view::npos)
        return {token + " is not written as JSON writes a number",
                "write it like 5, -0.5 or 1e-3: digits on both sides of the point, no leading zeros, no plus "
                "sign"};
    return {"the word " + token + " has no meaning here",
            "write true, false or null in small letters, or put text into double quotes"};
}

Words describeMissingValue(const std::string& token, char before) {
    const char first = token.front();
    if ((first == ']' || first == '}') && before == ',')
        return {"a comma stands before " + token, "remove the comma"};
    if (endsWord(first))
        return {"a value is missing before " + token, "write the value, or remove what announces it"};
    return describeStranger(token);
}

Words describeMissingKey(const std::string& token, char before) {
    if (token.front() == '}' && before == ',')
        return {"a comma stands before " + token, "remove the comma"};
    if (std::string_view("/#'").find(token.front()) != std::string_view::npos)
        return describeStranger(token);
    return {"a key in double quotes is missing, there is " + token,
            "write the key, or put double quotes around it"};
}

Words describeMissingMark(const std::string& token, const std::string& mark) {
    if (token.front() == '/' || token.front() == '#')
        return describeStranger(token);
    return {"a " + mark + " is missing before " + token, "write the " + mark};
}

Words describe(const std::string& token, char before, Expected expected) {
    switch (expected) {
    case Expected::Value:
        return describeMissingValue(token, before);
    case Expected::Key:
        return describeMissingKey(token, before);
    case Expected::Colon:
        return describeMissingMark(token, "colon");
    case Expected::CommaOrBrace:
        return describeMissingMark(token, "comma or }");
    case Expected::CommaOrBracket:
        return describeMissingMark(token, "comma or ]");
    case Expected::End:
        break;
    }
    return {"there is more text after the end of the scene", "remove it, or the } before it"};
}

} // namespace

std::string placeOf(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, offset);
    const std::string_view line = before.substr(before.rfind('\n') + 1); // npos + 1 is 0
    return "line " + std::to_string(std::count(before.begin(), before.end(), '\n') + 1) + ", column " +
           std::to_string(characterCount(line) + 1);
}

Diagnostic describeUnexpected(std::string_view text, std::size_t offset, Expected expected) {
    if (offset >= text.size())
        return error(text, text.size(),
                     {"the text ends in the middle of the scene",
                      "check that the file is complete; every { and [ needs its } and ]"});
    return error(text, offset, describe(tokenAt(text, offset), markBefore(text, offset), expected));
}

Diagnostic describeUnclosedString(std::string_view text, std::size_t offset) {
    return error(text, offset,
                 {"the text ends inside double quotes",
                  "check that the file is complete, or write the missing double quotes"});
}

Diagnostic describeControlCharacter(std::string_view text, std::size_t offset) {
    return error(text, offset,
                 {"text in double quotes goes over the end of its line or holds a control character",
                  "write the missing double quotes, or \\n for a new line"});
}

Diagnostic describeEscape(std::string_view text, std::size_t offset) {
    return error(text, offset,
                 {"a \\ in double quotes starts no character",
                  "write \\\\ for a backslash, or \\u and four hexadecimal digits"});
}

Diagnostic describeNumberOverflow(std::string_view text, std::size_t offset) {
    return error(text, offset,
                 {"number out of range: " + tokenAt(text, offset), "write a number nearer to zero"});
}

} // namespace clothlab::json
