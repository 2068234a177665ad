#include "simcore/scene/object_reader.h"

#include "simcore/scene/utf8.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace clothlab {
namespace {

const char* describe(json::Type type) {
    switch (type) {
    case json::Type::Null:
        return "null";
    case json::Type::Boolean:
        return "true or false";
    case json::Type::Number:
        return "a number";
    case json::Type::String:
        return "text";
    case json::Type::Array:
        return "a list";
    case json::Type::Object:
        return "an object";
    }
    return "";
}

std::optional<int> toInt(const std::optional<json::Value>& value) {
    if (!value || value->type() != json::Type::Number)
        return std::nullopt;
    const double number = value->number();
    if (number != std::floor(number) || std::abs(number) > std::numeric_limits<int>::max())
        return std::nullopt;
    return static_cast<int>(number);
}

} // namespace

std::optional<GridPoint> toGridPoint(json::Value value) {
    if (value.type() != json::Type::Array)
        return std::nullopt;
    json::Elements elements(value);
    const std::optional<int> x = toInt(elements.next());
    const std::optional<int> y = toInt(elements.next());
    if (!x || !y || elements.next())
        return std::nullopt;
    return GridPoint{*x, *y};
}

ValueReader ValueReader::element(json::Value value, std::size_t index) const {
    return {value, m_place + "[" + std::to_string(index) + "]", m_report};
}

ValueReader ValueReader::member(json::Value value, std::string_view key) const {
    return {value, m_place + "." + shortened(key), m_report};
}

void ValueReader::error(std::string message, std::string remedy) const {
    m_report.error(m_place, std::move(message), std::move(remedy));
}

void ValueReader::warn(std::string message, std::string remedy) const {
    m_report.warn(m_place, std::move(message), std::move(remedy));
}

bool ValueReader::require(json::Type wantedType, std::string_view wanted) const {
    if (type() == wantedType)
        return true;
    error(std::string("must be ") + describe(wantedType) + ", is " + describe(type()),
          "give " + std::string(wanted));
    return false;
}

std::optional<double> ValueReader::number(std::string_view wanted) const {
    if (!require(json::Type::Number, wanted))
        return std::nullopt;
    return m_value.number();
}

std::optional<double> ValueReader::number(const Range& range) const {
    if (type() != json::Type::Number)
        return number(range.words());
    const double result = m_value.number();
    if (range.contains(result))
        return result;
    error(outOfRange(result), writeWithin(range));
    return std::nullopt;
}

std::optional<bool> ValueReader::boolean() const {
    if (type() == json::Type::Number && (m_value.number() == 0 || m_value.number() == 1)) {
        const bool result = m_value.number() == 1;
        warn(std::string("is a number, taken as ") + (result ? "true" : "false"), "write true or false");
        return result;
    }
    if (!require(json::Type::Boolean, "true or false"))
        return std::nullopt;
    return m_value.boolean();
}

std::optional<std::string> ValueReader::string(std::string_view wanted) const {
    if (!require(json::Type::String, wanted))
        return std::nullopt;
    return m_value.string();
}

std::optional<std::vector<double>> ValueReader::numbers(std::size_t least, std::size_t most,
                                                        std::string_view wanted) const {
    if (!require(json::Type::Array, wanted))
        return std::nullopt;
    std::vector<double> result;
    json::Elements elements(m_value);
    bool more = false;
    while (const auto next = elements.next()) {
        more = result.size() == most;
        if (more)
            break;
        if (next->type() != json::Type::Number) {
            element(*next, result.size()).require(json::Type::Number, "a number");
            return std::nullopt;
        }
        result.push_back(next->number());
    }
    if (!more && result.size() >= least)
        return result;
    const std::string count = (least < most ? std::to_string(least) + " to " : "") + std::to_string(most);
    error("must hold " + count + " numbers, holds " +
              (more ? std::string("more") : std::to_string(result.size())),
          "give " + std::string(wanted));
    return std::nullopt;
}

std::optional<GridPoint> ValueReader::gridPoint() const {
    if (const auto point = toGridPoint(m_value))
        return point;
    if (numbers(2, "a point of the grid, like [0, 49]"))
        error("is not a point of a grid", "give two whole numbers, like [0, 49]");
    return std::nullopt;
}

ObjectReader::ObjectReader(const ValueReader& object, Keys known, Report& report)
    : m_place(object.place()), m_known(known), m_report(report) {
    if (object.require(json::Type::Object, "an object, like {\"" + std::string(known.front()) + "\": …}"))
        m_members = json::members(object.value());
}

std::string ObjectReader::placeOf(std::string_view key) const {
    return (m_place.empty() ? "" : m_place + ".") + shortened(key);
}

std::optional<ValueReader> ObjectReader::find(std::string_view key) const {
    const auto found = std::ranges::find(m_members, key, &json::Member::key);
    if (found == m_members.end())
        return std::nullopt;
    return ValueReader(found->value, placeOf(key), m_report);
}

std::optional<ValueReader> ObjectReader::require(std::string_view key, std::string_view wanted) const {
    auto result = find(key);
    if (!result)
        m_report.error(placeOf(key), "is missing", "give " + std::string(wanted));
    return result;
}

std::optional<ValueReader> ObjectReader::expect(std::string_view key, std::string_view usedInstead) const {
    auto result = find(key);
    if (!result)
        m_report.warn(placeOf(key), "is missing, so it is " + std::string(usedInstead),
                      "write it down, as the course's simulator asks for it");
    return result;
}

void ObjectReader::readNumber(std::string_view key, const Range& range, double& target) const {
    if (const auto value = find(key))
        target = value->number(range).value_or(target);
}

void ObjectReader::readBoolean(std::string_view key, bool& target) const {
    if (const auto value = find(key))
        target = value->boolean().value_or(target);
}

void ObjectReader::readString(std::string_view key, std::string_view wanted, std::string& target) const {
    if (const auto value = find(key))
        target = value->string(wanted).value_or(std::move(target));
}

void ObjectReader::readVector(std::string_view key, std::string_view wanted, Vec3& target) const {
    if (const auto value = require(key, wanted)) {
        if (const auto numbers = value->numbers(3, wanted))
            target = toVec3(*numbers);
    }
}

std::string ObjectReader::unknownKeys() const {
    std::string text;
    for (const json::Member& member : m_members) {
        if (isKnown(member.key, m_known))
            continue;
        if (m_report.warnings() <= Report::kMaxOfEach) {
            const std::string_view closest = closestKey(member.key, m_known);
            m_report.warn(placeOf(member.key),
                          "is a key that this version does not know; it is kept but does nothing",
                          closest.empty() ? "" : "did you mean " + std::string(closest) + "?");
        }
        text += text.empty() ? "{" : ",";
        text += member.keyText;
        text += ':';
        text += json::compact(member.value.text);
    }
    return text.empty() ? text : text + "}";
}

void readParameters(const ObjectReader& object, std::string_view name, Scene& scene) {
    for (const Parameter& parameter : parameters()) {
        if (parameter.object() != name || parameter.key().ends_with(']'))
            continue;
        const auto value = object.find(parameter.key());
        if (!value)
            continue;
        if (parameter.kind == Parameter::Kind::Boolean)
            parameter.set(scene, value->boolean().value_or(false) ? 1 : 0);
        else if (const auto number = value->number(rangeOf(parameter)))
            parameter.set(scene, *number);
    }
}

Vec3 toVec3(const std::vector<double>& numbers) {
    return {numbers[0], numbers[1], numbers[2]};
}

} // namespace clothlab
