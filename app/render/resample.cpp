#include "app/render/resample.h"

#include <algorithm>
#include <cmath>

namespace clothlab::render {
namespace {

// What a point between others is made of: four neighbours, from first on, some of which may lie beyond an
// end.
struct Sample {
    int first;
    std::array<float, 4> weights;
};

// Where a point would be beyond an end is extrapolated from the two before: p(-1) = 2 p(0) - p(1).
void foldEnds(Sample& sample, int count) {
    std::array<float, 4>& w = sample.weights;
    if (sample.first < 0) {
        w = {2 * w[0] + w[1], w[2] - w[0], w[3], 0};
        sample.first = 0;
    }
    if (sample.first + 3 >= count) {
        // The last of the four is beyond; move everything one place down.
        w = {0, w[0], w[1] - w[3], w[2] + 2 * w[3]};
        --sample.first;
    }
}

std::vector<Sample> samplesOf(int count, int cells, bool linear) {
    std::vector<Sample> samples;
    for (int i = 0; i <= cells; ++i) {
        const float place = static_cast<float>(i) * static_cast<float>(count - 1) / static_cast<float>(cells);
        const int below = std::clamp(static_cast<int>(place), 0, std::max(count - 2, 0));
        const float t = place - static_cast<float>(below);
        if (linear || count < 4) {
            samples.push_back({below, {1 - t, count > 1 ? t : 0, 0, 0}});
            continue;
        }
        Sample sample{below - 1,
                      {((2 - t) * t - 1) * t / 2, ((3 * t - 5) * t * t + 2) / 2,
                       ((4 - 3 * t) * t + 1) * t / 2, (t - 1) * t * t / 2}};
        foldEnds(sample, count);
        samples.push_back(sample);
    }
    return samples;
}

// Rows or columns of `components` numbers, `stride` apart.
float weighted(const float* from, std::ptrdiff_t stride, int count, const Sample& sample) {
    float sum = 0;
    for (int k = 0; k < 4; ++k) {
        const int index = std::clamp(sample.first + k, 0, count - 1);
        sum += sample.weights[static_cast<std::size_t>(k)] * from[index * stride];
    }
    return sum;
}

// First along the rows, then along the columns.
void resampleGrid(const std::vector<float>& from, int width, int height, int components, int cells,
                  bool linear, std::vector<float>& to) {
    const std::ptrdiff_t columns = cells + 1;
    std::vector<float> rows(static_cast<std::size_t>(columns * height * components));
    const std::vector<Sample> across = samplesOf(width, cells, linear);
    for (std::ptrdiff_t y = 0; y < height; ++y)
        for (std::ptrdiff_t x = 0; x < columns; ++x)
            for (std::ptrdiff_t c = 0; c < components; ++c)
                rows[static_cast<std::size_t>((y * columns + x) * components + c)] =
                    weighted(from.data() + y * width * components + c, components, width,
                             across[static_cast<std::size_t>(x)]);
    to.resize(static_cast<std::size_t>(columns * columns * components));
    const std::vector<Sample> down = samplesOf(height, cells, linear);
    const std::ptrdiff_t stride = columns * components;
    for (std::ptrdiff_t y = 0; y < columns; ++y)
        for (std::ptrdiff_t k = 0; k < stride; ++k)
            to[static_cast<std::size_t>(y * stride + k)] =
                weighted(rows.data() + k, stride, height, down[static_cast<std::size_t>(y)]);
}

} // namespace

void resample(const SheetShape& sheet, int cells, SheetShape& out) {
    const std::size_t count = static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height);
    const bool fits = sheet.width > 0 && sheet.height > 0 && sheet.positions.size() == 3 * count;
    out.width = fits ? cells + 1 : 0;
    out.height = out.width;
    out.positions.clear();
    out.strains.clear();
    if (!fits)
        return;
    resampleGrid(sheet.positions, sheet.width, sheet.height, 3, cells, false, out.positions);
    if (sheet.strains.size() == count)
        resampleGrid(sheet.strains, sheet.width, sheet.height, 1, cells, true, out.strains);
}

} // namespace clothlab::render
