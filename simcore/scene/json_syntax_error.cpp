#include "simcore/scene/json_syntax_error.h"

#include "simcore/scene/json_check.h"
#include "simcore/scene/json_text.h"

#include <algorithm>
#include <array>

namespace clothlab::json {
namespace {

constexpr std::string_view kSpace = " \t\r\n";
constexpr std::string_view kEndOfWord = " \t\r\n,:[]{}\"";

// A token of text that need not be JSON: a mark, a string that may lack its end, or a word.
struct Token {
    std::size_t begin = 0;
    std::size_t end = 0;
    char before = 0; // the last character of the token before it
};

std::size_t endOfToken(std::string_view text, std::size_t begin) {
    if (text[begin] == '"') {
        std::size_t at = begin + 1;
        while (at < text.size() && text[at] != '"')
            at += text[at] == '\\' ? 2 : 1;
        return std::min(at + 1, text.size());
    }
    if (kEndOfWord.find(text[begin]) != std::string_view::npos)
        return begin + 1;
    return std::min(text.find_first_of(kEndOfWord, begin), text.size());
}

// The token that holds the last byte read; an empty one at the end of the text if there is none.
Token tokenAt(std::string_view text, std::size_t position) {
    Token token;
    for (;;) {
        if (token.end > 0)
            token.before = text[token.end - 1];
        token.begin = std::min(text.find_first_not_of(kSpace, token.end), text.size());
        if (token.begin == text.size()) {
            token.end = token.begin;
            return token;
        }
        token.end = endOfToken(text, token.begin);
        if (token.end >= position)
            return token;
    }
}

struct Words {
    std::string message;
    std::string remedy;
};

bool startsLikeNumber(std::string_view word) {
    return std::string_view("+-.0123456789").find(word.front()) != std::string_view::npos;
}

Words describeWord(std::string_view word) {
    const std::string shown = shortened(word);
    std::string lower(word.substr(0, 16));
    std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) {
        return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : char(c);
    });
    if (lower.find("nan") != std::string::npos || lower.find("inf") != std::string::npos)
        return {shown + " is not a number that a scene can hold", "write a finite number"};
    if (word.front() == '/' || word.front() == '#')
        return {"a comment is not part of JSON", "remove the comment"};
    if (word.front() == '\'')
        return {"text in single quotes is not part of JSON", "write double quotes"};
    if (startsLikeNumber(word))
        return {shown + " is not written as JSON writes a number",
                "write it like 5, -0.5 or 1e-3: digits before and after the point, no leading zeros, no plus "
                "sign"};
    return {"the word " + shown + " has no meaning here",
            "write true, false or null in small letters, or put text into double quotes"};
}

// position - 1 is the byte inside the string that the parser did not accept.
Words describeString(std::string_view text, const Token& token, std::size_t position) {
    const std::size_t at = std::min(position, text.size()) - 1;
    const bool closed = token.end - token.begin >= 2 && text[token.end - 1] == '"';
    if (!closed && position >= text.size())
        return {"text in double quotes does not end", "write the missing double quotes"};
    if (at + 1 < token.end && static_cast<unsigned char>(text[at]) < 0x20)
        return {"text in double quotes goes over the end of its line or holds a control character",
                "write the missing double quotes, or \\n for a new line"};
    if (at + 1 < token.end)
        return {"text in double quotes holds a \\ that starts no character",
                "write \\\\ for a backslash, or \\u and four hexadecimal digits"};
    return {"unexpected text " + shortened(text.substr(token.begin, token.end - token.begin)),
            "write the comma or colon that is missing before it"};
}

Words describeMark(char mark, char before) {
    const std::string shown(1, mark);
    if ((mark == '}' || mark == ']') && before == ',')
        return {"a comma stands before " + shown, "remove the comma"};
    if (mark == '}' || mark == ']')
        return {"unexpected " + shown, "close what was opened last, with " +
                                           std::string(mark == '}' ? "]" : "}") +
                                           " or a value that is missing"};
    if (mark == '{' || mark == '[')
        return {"unexpected " + shown, "write the comma or colon that is missing before it, or a key"};
    return {"unexpected " + shown, "write the value or key that is missing before it"};
}

Words describe(std::string_view text, const Token& token, std::size_t position) {
    const std::string_view word = text.substr(token.begin, token.end - token.begin);
    if (word.front() == '"')
        return describeString(text, token, position);
    if (kEndOfWord.find(word.front()) != std::string_view::npos)
        return describeMark(word.front(), token.before);
    constexpr std::array<std::string_view, 3> kWords{"true", "false", "null"};
    const bool value = std::find(kWords.begin(), kWords.end(), word) != kWords.end() ||
                       (startsLikeNumber(word) && position >= token.end && word.front() != '+' &&
                        word.find_first_not_of("+-.0123456789eE") == std::string_view::npos);
    if (value && token.before != ':' && token.before != ',' && token.before != '[')
        return {"unexpected " + shortened(word), "write the comma, colon or key that is missing before it"};
    return describeWord(word);
}

} // namespace

Diagnostic describeSyntaxError(std::string_view text, std::size_t position, bool finished) {
    const Token token = tokenAt(text, position);
    Words words;
    if (token.begin == text.size())
        words = {"the text ends in the middle of the scene",
                 "check that the file is complete; every { and [ needs its } and ]"};
    else if (finished)
        words = {"there is more text after the end of the scene", "remove it, or the } before it"};
    else
        words = describe(text, token, position);
    return {Severity::Error, placeOf(text, token.begin), words.message, words.remedy};
}

Diagnostic describeNumberOverflow(std::string_view text, std::size_t position) {
    const Token token = tokenAt(text, position);
    return {Severity::Error, placeOf(text, token.begin),
            "number out of range: " + shortened(text.substr(token.begin, token.end - token.begin)),
            "write a number nearer to zero"};
}

} // namespace clothlab::json
