#include "tests/support/in_rows.h"

#include <algorithm>
#include <sstream>

namespace clothlab {
namespace {

// With all around the points pinned.
std::vector<std::uint8_t> pinnedSlots(const RowLayout& layout, const std::vector<std::uint8_t>& pinned) {
    std::vector<std::uint8_t> mask(std::size_t(layout.slotCount() + 2 * layout.stride), 1);
    for (int y = 0; y < layout.height; ++y)
        for (int x = 0; x < layout.width; ++x)
            mask[std::size_t(layout.slot(x, y))] = pinned[std::size_t(y * layout.width + x)];
    return mask;
}

} // namespace

std::vector<InstructionSet> supportedInstructionSets() {
    std::vector<InstructionSet> sets;
    for (const InstructionSet set :
         {InstructionSet::Scalar, InstructionSet::Sse2, InstructionSet::Avx2, InstructionSet::Avx512})
        if (isSupported(set))
            sets.push_back(set);
    return sets;
}

std::string CloudLayout::describe() const {
    std::ostringstream text;
    text << name(instructionSet) << ", rows of " << width << ", " << bands << " bands";
    return text.str();
}

void CloudCollision::lay(int count) {
    const int width = m_layout.width > 0 && count % m_layout.width == 0 ? m_layout.width : count;
    if (m_collision && m_rows.width == width && m_rows.height == count / width)
        return;
    m_rows = RowLayout(Grid{width, count / width});
    m_arrays = RowArrays(m_rows, 6);
    const int bands = std::min(m_layout.bands, m_rows.height);
    m_bands.clear();
    for (int n = 0; n < bands; ++n)
        m_bands.push_back({m_rows.height * n / bands, m_rows.height * (n + 1) / bands});
    m_collision = std::make_unique<SelfCollision>(kernelsFor(m_layout.instructionSet));
    m_collision->setSheet(m_rows, m_bands);
}

int CloudCollision::corrections(const PointArray& position, const std::vector<std::uint8_t>& pinned,
                                double distance, double share, PointArray& correction) {
    if (position.size() == 0)
        return 0;
    lay(int(position.size()));
    const std::vector<std::uint8_t> mask = pinnedSlots(m_rows, pinned);
    m_collision->setPinned(mask.data());
    m_collision->setDistance(distance);
    const PointRows points = m_arrays.points(0);
    const PointRows moved = m_arrays.points(3); // from the origin, so that nothing is rounded away
    copyToRows(position, m_rows, points);
    copyToRows(PointArray(position.size()), m_rows, moved);

    const auto eachBand = [&](const auto& work) {
        for (int band = 0; band < int(m_bands.size()); ++band)
            work(band);
    };
    eachBand([&](int band) { m_collision->foretell(band, points, points); });
    eachBand([&](int band) { // in two parts
        const RowRange rows = m_bands[std::size_t(band)];
        const int middle = (rows.begin + rows.end + 1) / 2;
        m_collision->measure(band, points, {rows.begin, middle});
        m_collision->measure(band, points, {middle, rows.end});
    });
    bool hold = true;
    eachBand([&](int band) { hold = m_collision->listsHold(band) && hold; });
    if (!hold) {
        ++m_listings;
        m_collision->sortIntoCells(points);
        eachBand([&](int band) { m_collision->list(band, points); });
    }
    eachBand([&](int band) { m_collision->findPairs(band, points); });
    if (m_collision->anyPairs()) {
        eachBand([&](int band) { m_collision->addUp(band, points); });
        eachBand([&](int band) { m_collision->apply(band, moved, share); });
    }
    copyFromRows(moved, m_rows, correction);
    int count = 0;
    for (int i = 0; i < int(correction.size()); ++i)
        count += correction.at(i).isZero(0) ? 0 : 1;
    return count;
}

void collideWith(const Scene& scene, InstructionSet set, const std::vector<std::uint8_t>& pinned,
                 ClothState& state) {
    StepData data;
    data.layout = RowLayout(Grid{int(state.size()), 1});
    RowArrays arrays(data.layout, 6);
    data.position = arrays.points(0);
    data.last = arrays.points(3);
    copyToRows(state.position, data.layout, data.position);
    copyToRows(state.lastPosition, data.layout, data.last);
    const std::vector<std::uint8_t> mask = pinnedSlots(data.layout, pinned);
    data.pinned = mask.data();
    Colliders colliders;
    colliders.set(scene);
    colliders.collide(kernelsFor(set), data, {0, 1});
    copyFromRows(data.position, data.layout, state.position);
    copyFromRows(data.last, data.layout, state.lastPosition);
}

} // namespace clothlab
