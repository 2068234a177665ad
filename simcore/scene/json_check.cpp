#include "simcore/scene/json_check.h"

#include "simcore/scene/json_syntax_error.h"
#include "simcore/scene/json_text.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <set>

namespace clothlab::json {
namespace {

using Json = nlohmann::json;

Diagnostic error(std::string place, std::string message, std::string remedy) {
    return {Severity::Error, std::move(place), std::move(message), std::move(remedy)};
}

// Length of the UTF-8 character that text starts with, 0 if it is none (Unicode 15, table 3-7).
std::size_t characterLength(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return i < text.size() ? static_cast<unsigned char>(text[i]) : 0U;
    };
    const auto continues = [&](std::size_t i) { return (byte(i) & 0xC0U) == 0x80U; };
    const unsigned first = byte(0);
    if (first < 0x80)
        return first == 0 ? 0 : 1;
    if (first < 0xC2 || first > 0xF4)
        return 0;
    if (first < 0xE0)
        return continues(1) ? 2 : 0;
    const unsigned second = byte(1);
    if (first < 0xF0) {
        const bool good = (first != 0xE0 || second >= 0xA0) && (first != 0xED || second < 0xA0);
        return good && continues(1) && continues(2) ? 3 : 0;
    }
    const bool good = (first != 0xF0 || second >= 0x90) && (first != 0xF4 || second < 0x90);
    return good && continues(1) && continues(2) && continues(3) ? 4 : 0;
}

std::size_t firstNotUtf8(std::string_view text) {
    std::size_t at = 0;
    while (at < text.size()) {
        const std::size_t length = characterLength(text.substr(at));
        if (length == 0)
            break;
        at += length;
    }
    return at;
}

// Walks through the text with the library's parser and stops at the first fault.
class Checker final : public nlohmann::json_sax<Json> {
public:
    explicit Checker(std::string_view text) : m_text(text) {}
    std::optional<Diagnostic> fault;

    bool null() override { return value(); }
    bool boolean(bool) override { return value(); }
    bool number_integer(number_integer_t) override { return value(); }
    bool number_unsigned(number_unsigned_t) override { return value(); }
    bool number_float(number_float_t, const string_t&) override { return value(); }
    bool string(string_t&) override { return value(); }
    bool binary(binary_t&) override { return value(); }
    bool start_object(std::size_t) override { return open(false); }
    bool start_array(std::size_t) override { return open(true); }
    bool end_object() override { return close(); }
    bool end_array() override { return close(); }

    bool key(string_t& key) override {
        Level& level = m_levels.back();
        level.key = shortened(key);
        if (!level.keys.insert(std::move(key)).second)
            return fail("is there twice in the same object", "remove one of the two");
        if (++m_openKeys > kMaxKeys)
            return fail("is one key too many: there are more than " + std::to_string(kMaxKeys),
                        "check that it is the right file");
        return true;
    }

    bool parse_error(std::size_t position, const std::string&,
                     const nlohmann::detail::exception& e) override {
        constexpr int kNumberOverflow = 406;
        fault = e.id == kNumberOverflow ? describeNumberOverflow(m_text, position)
                                        : describeSyntaxError(m_text, position, m_finished);
        return false;
    }

private:
    struct Level {
        bool isArray = false;
        std::size_t index = 0; // of the value to come
        std::string key;       // of the value at hand
        std::set<std::string> keys;
    };

    bool value() {
        if (m_levels.empty())
            m_finished = true;
        else
            ++m_levels.back().index;
        return true;
    }

    bool open(bool isArray) {
        if (m_levels.size() == kMaxLevels)
            return fail("is nested more than " + std::to_string(kMaxLevels) + " levels deep",
                        "check that it is the right file, or nest its lists and objects less");
        m_levels.push_back({isArray, 0, {}, {}});
        return true;
    }

    bool close() {
        m_openKeys -= m_levels.back().keys.size();
        m_levels.pop_back();
        return value();
    }

    bool fail(std::string message, std::string remedy) {
        fault = error(path(), std::move(message), std::move(remedy));
        return false;
    }

    std::string path() const {
        constexpr std::size_t kShownLevels = 8;
        std::string path;
        for (std::size_t i = 0; i < std::min(m_levels.size(), kShownLevels); ++i) {
            const Level& level = m_levels[i];
            if (level.isArray)
                path.append("[").append(std::to_string(level.index)).append("]");
            else
                path.append(path.empty() ? "" : ".").append(level.key);
        }
        return m_levels.size() > kShownLevels ? path + "…" : path;
    }

    std::string_view m_text;
    std::vector<Level> m_levels;
    std::size_t m_openKeys = 0;
    bool m_finished = false; // the one value of the text is complete
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

bool isUtf8(std::string_view text) {
    return firstNotUtf8(text) == text.size();
}

std::string placeOf(std::string_view text, std::size_t offset) {
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    const std::size_t newline = before.rfind('\n');
    const std::string_view line = newline == std::string_view::npos ? before : before.substr(newline + 1);
    const auto isStart = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) != 0x80U; };
    return "line " + std::to_string(std::count(before.begin(), before.end(), '\n') + 1) + ", column " +
           std::to_string(std::count_if(line.begin(), line.end(), isStart) + 1);
}

std::optional<Diagnostic> checkJson(std::string_view text) {
    const std::size_t offset = firstNotUtf8(text);
    if (offset < text.size())
        return describeEncoding(text, offset);
    if (text.find_first_not_of(" \t\r\n") == std::string_view::npos)
        return error("", "is empty", "check that it is the right file, or save the scene again");
    Checker checker(text);
    Json::sax_parse(text.begin(), text.end(), &checker);
    return std::move(checker.fault);
}

} // namespace clothlab::json
