#include "simcore/recording/state_codec.h"

#include "simcore/recording/bit_planes.h"

#include <bit>

namespace clothlab {
namespace {

std::uint64_t bitsOf(double value) {
    return std::bit_cast<std::uint64_t>(value);
}

} // namespace

// Of each coordinate the positions, each from the one before, and the last positions, each from its position.
std::string packState(const Grid& grid, const ClothState& state) {
    std::string out;
    std::vector<std::uint64_t> numbers(std::size_t(grid.pointCount()));
    for (const auto axis : {&PointArray::x, &PointArray::y, &PointArray::z}) {
        const std::vector<double>& position = state.position.*axis;
        const std::vector<double>& last = state.lastPosition.*axis;
        std::uint64_t before = 0;
        for (std::size_t i = 0; i < numbers.size(); ++i) {
            numbers[i] = foldedDifference(bitsOf(position[i]), before);
            before = bitsOf(position[i]);
        }
        appendPlanes(out, numbers);
        for (std::size_t i = 0; i < numbers.size(); ++i)
            numbers[i] = foldedDifference(bitsOf(last[i]), bitsOf(position[i]));
        appendPlanes(out, numbers);
    }
    return out;
}

std::optional<ClothState> unpackState(const Grid& grid, std::string_view bytes) {
    const auto n = std::size_t(grid.pointCount());
    ClothState state{PointArray(n), PointArray(n)};
    std::vector<std::uint64_t> numbers(n);
    for (const auto axis : {&PointArray::x, &PointArray::y, &PointArray::z}) {
        std::vector<double>& position = state.position.*axis;
        std::vector<double>& last = state.lastPosition.*axis;
        if (!readPlanes(bytes, numbers))
            return std::nullopt;
        std::uint64_t before = 0;
        for (std::size_t i = 0; i < n; ++i) {
            before = unfoldedSum(numbers[i], before);
            position[i] = std::bit_cast<double>(before);
        }
        if (!readPlanes(bytes, numbers))
            return std::nullopt;
        for (std::size_t i = 0; i < n; ++i)
            last[i] = std::bit_cast<double>(unfoldedSum(numbers[i], bitsOf(position[i])));
    }
    if (!bytes.empty())
        return std::nullopt;
    return state;
}

} // namespace clothlab
