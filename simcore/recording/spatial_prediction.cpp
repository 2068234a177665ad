#include "simcore/recording/spatial_prediction.h"

#include <Eigen/Cholesky>
#include <Eigen/Core>

#include <algorithm>
#include <cmath>

namespace clothlab {
namespace {

using Word = std::uint32_t; // whose sums and products are modulo 2^32 without being undefined

constexpr Word kRound = Word(1) << (PointWeights::kShift - 1);
constexpr int kMostFittedRows = 16;

constexpr Word word(std::int32_t value) {
    return static_cast<Word>(value);
}

std::int32_t scaled(Word sum) {
    return static_cast<std::int32_t>(sum) >> PointWeights::kShift;
}

// Sums over all points of products of what predicts them and what they are.
struct Moments {
    Eigen::Matrix4f products = Eigen::Matrix4f::Zero();
    Eigen::Vector4f withValue = Eigen::Vector4f::Zero();
};

void addRow(int width, const std::int32_t* above, const std::int32_t* row, std::vector<float>& scratch,
            Moments& moments) {
    const auto n = std::size_t(width);
    scratch.resize(5 * n);
    float* const known = scratch.data(); // left, above, above left, above right, then the value itself
    for (std::size_t x = 0; x < n; ++x) {
        known[x] = float(x == 0 ? above[0] : row[x - 1]);
        known[n + x] = float(above[x]);
        known[2 * n + x] = float(above[x == 0 ? 0 : x - 1]);
        known[3 * n + x] = float(above[std::min(x + 1, n - 1)]);
        known[4 * n + x] = float(row[x]);
    }
    const Eigen::Map<const Eigen::MatrixXf> columns(known, width, 5);
    moments.products.noalias() += columns.leftCols<4>().transpose() * columns.leftCols<4>();
    moments.withValue.noalias() += columns.leftCols<4>().transpose() * columns.col(4);
}

std::int8_t weight(float value) {
    const float steps = value * float(1 << PointWeights::kShift);
    return static_cast<std::int8_t>(std::lround(std::clamp(steps, -127.0F, 127.0F)));
}

} // namespace

PointWeights fitWeights(const Grid& grid, const std::int32_t* values) {
    Moments moments;
    std::vector<float> scratch;
    const int stride = std::max(1, (grid.height + kMostFittedRows - 1) / kMostFittedRows);
    for (int y = 1; y < grid.height; y += stride) {
        const std::int32_t* row = values + std::size_t(y) * std::size_t(grid.width);
        addRow(grid.width, row - grid.width, row, scratch, moments);
    }
    // Weights that differ hardly in their errors should rather be small.
    moments.products.diagonal().array() += 1e-4F * moments.products.diagonal().maxCoeff() + 1;
    const Eigen::Vector4f w = moments.products.ldlt().solve(moments.withValue);
    if (!w.allFinite())
        return {};
    return {weight(w[0]), weight(w[1]), weight(w[2]), weight(w[3])};
}

void RowAbove::set(const std::int32_t* row) {
    std::copy_n(row, m_values.size() - 2, m_values.data() + 1);
    m_values.front() = row[0];
    m_values.back() = row[m_values.size() - 3];
}

void predictRow(const PointWeights& weights, int width, const RowAbove* above, const std::int32_t* row,
                std::int32_t* errors) {
    if (above == nullptr) {
        errors[0] = row[0];
        for (int x = 1; x < width; ++x)
            errors[x] = static_cast<std::int32_t>(word(row[x]) - word(row[x - 1]));
        return;
    }
    const std::int32_t* const a = above->begin();
    const Word wl = word(weights.left), wa = word(weights.above), wal = word(weights.aboveLeft),
               war = word(weights.aboveRight);
    errors[0] = static_cast<std::int32_t>(
        word(row[0]) - word(scaled((wl + wa) * word(a[0]) + wal * word(a[-1]) + war * word(a[1]) + kRound)));
    for (int x = 1; x < width; ++x)
        errors[x] = static_cast<std::int32_t>(
            word(row[x]) - word(scaled(wl * word(row[x - 1]) + wa * word(a[x]) + wal * word(a[x - 1]) +
                                       war * word(a[x + 1]) + kRound)));
}

namespace {

void restoreFirstRow(int width, std::int32_t* row) {
    for (int x = 1; x < width; ++x)
        row[x] = static_cast<std::int32_t>(word(row[x]) + word(row[x - 1]));
}

// What the row above says of each point.
void sumAbove(const PointWeights& weights, int width, const std::int32_t* above, std::int32_t* sums) {
    const Word wa = word(weights.above), wal = word(weights.aboveLeft), war = word(weights.aboveRight);
    for (int x = 0; x < width; ++x)
        sums[x] = static_cast<std::int32_t>(wa * word(above[x]) + wal * word(above[x - 1]) +
                                            war * word(above[x + 1]) + kRound);
}

} // namespace

void restoreRows(const std::array<PointWeights, 3>& weights, int width, const std::array<RowAbove, 3>* above,
                 const std::array<std::int32_t*, 3>& rows) {
    if (above == nullptr) {
        for (std::int32_t* row : rows)
            restoreFirstRow(width, row);
        return;
    }
    thread_local std::array<std::vector<std::int32_t>, 3> sums;
    std::array<Word, 3> left{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        sums[axis].resize(std::size_t(width));
        sumAbove(weights[axis], width, (*above)[axis].begin(), sums[axis].data());
        left[axis] = word((*above)[axis].begin()[0]);
    }
    const std::array<const std::int32_t*, 3> sum{sums[0].data(), sums[1].data(), sums[2].data()};
    const std::array<Word, 3> w{word(weights[0].left), word(weights[1].left), word(weights[2].left)};
    for (int x = 0; x < width; ++x)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            left[axis] = word(rows[axis][x]) + word(scaled(w[axis] * left[axis] + word(sum[axis][x])));
            rows[axis][x] = static_cast<std::int32_t>(left[axis]);
        }
}

} // namespace clothlab
