#pragma once

#include "simcore/scene/json_text.h"
#include "simcore/scene/known_keys.h"
#include "simcore/scene/range.h"
#include "simcore/scene/report.h"

#include <optional>
#include <string>
#include <vector>

namespace clothlab {

// A value in a file, where it is, and who is told what is wrong with it. Each function gives nothing after
// it has reported an error. wanted: what to write there, in words.
class ValueReader {
public:
    ValueReader(json::Value value, std::string place, Report& report)
        : m_value(value), m_place(std::move(place)), m_report(report) {}

    json::Type type() const { return m_value.type(); }
    json::Value value() const { return m_value; }
    const std::string& place() const { return m_place; }
    ValueReader element(json::Value value, std::size_t index) const;
    ValueReader member(json::Value value, std::string_view key) const;

    std::optional<double> number(std::string_view wanted) const;
    std::optional<double> number(const Range& range) const;
    std::optional<bool> boolean() const; // 0 and 1 with a warning
    std::optional<std::string> string(std::string_view wanted) const;
    // From `least` to `most` numbers, of any size.
    std::optional<std::vector<double>> numbers(std::size_t least, std::size_t most,
                                               std::string_view wanted) const;
    std::optional<std::vector<double>> numbers(std::size_t count, std::string_view wanted) const {
        return numbers(count, count, wanted);
    }
    std::optional<GridPoint> gridPoint() const; // as toGridPoint()

    bool require(json::Type type, std::string_view wanted) const;
    void error(std::string message, std::string remedy) const;
    void warn(std::string message, std::string remedy) const;

private:
    json::Value m_value;
    std::string m_place;
    Report& m_report;
};

// The members of an object in a file; of none if the value is something else, which is an error.
class ObjectReader {
public:
    ObjectReader(const ValueReader& object, Keys known, Report& report);

    std::optional<ValueReader> find(std::string_view key) const;
    // As find(); a missing key is an error.
    std::optional<ValueReader> require(std::string_view key, std::string_view wanted) const;
    // As find(); a missing key is a warning that says which value it has now.
    std::optional<ValueReader> expect(std::string_view key, std::string_view usedInstead) const;

    // Into target, where the key is there and right.
    void readNumber(std::string_view key, const Range& range, double& target) const;
    void readBoolean(std::string_view key, bool& target) const;
    void readString(std::string_view key, std::string_view wanted, std::string& target) const;
    void readVector(std::string_view key, std::string_view wanted, Vec3& target) const;

    // Warns about each key that is not known and returns them as the text of an object; empty if there are
    // none.
    std::string unknownKeys() const;

private:
    std::string placeOf(std::string_view key) const;

    std::vector<json::Member> m_members;
    std::string m_place;
    Keys m_known;
    Report& m_report;
};

// The parameters of the table that are in this object of a scene, where they are there and right; without the
// elements of lists.
void readParameters(const ObjectReader& object, std::string_view name, Scene& scene);

// Two whole numbers in a list; nothing, and no words, if the value is anything else.
std::optional<GridPoint> toGridPoint(json::Value value);

// A vector from three numbers that were read.
Vec3 toVec3(const std::vector<double>& numbers);

} // namespace clothlab
