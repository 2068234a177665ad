#include "simcore/collision/self_collision.h"

#include <algorithm>
#include <cmath>

namespace clothlab {
namespace {

// The skin, as a share of the distance, grows while lists do not last and shrinks while they do: it trades
// making them against going through them.
constexpr double kLeastSkin = 0.4;
constexpr double kGreatestSkin = 0.9;
constexpr int kShortLife = 12; // steps
constexpr int kLongLife = 40;
// Of the cells, as a share of the reach in which neighbours are listed: large ones hold more points that are
// out of reach, but there are fewer to go through. A crowded sheet fills any.
constexpr double kCellSize = 2;
constexpr double kCellSizeCrowded = 1;
// On average a block of points. A sheet that crowds more is looked through without lists, which would take
// too much memory.
constexpr std::size_t kMostListed = 192;
// Points of a band whose motion is foretold, along each side.
constexpr int kSamples = 4;

} // namespace

void selfCollisionBruteForce(const PointArray& position, const std::vector<std::uint8_t>& pinned,
                             double distance, double share, PointArray& correction) {
    for (int i = 0; i < int(position.size()); ++i) {
        Vec3 sum = Vec3::Zero();
        int count = 0;
        for (int j = 0; j < int(position.size()) && !pinned[std::size_t(i)]; ++j) {
            const Vec3 apart = position.at(i) - position.at(j);
            const double lengthSquared =
                apart.x() * apart.x() + apart.y() * apart.y() + apart.z() * apart.z();
            if (!(lengthSquared < distance * distance) || lengthSquared <= 0)
                continue;
            const double length = std::sqrt(lengthSquared);
            sum += (distance - length) / length * apart;
            ++count;
        }
        correction.set(i, count > 0 ? Vec3(sum * (share / count)) : Vec3(Vec3::Zero()));
    }
}

void SelfCollision::Pairs::reserve(std::size_t needed) {
    if (pairs.size() < needed)
        pairs.resize(std::max(2 * pairs.size(), needed));
}

void SelfCollision::setSheet(const RowLayout& layout, const std::vector<RowRange>& bands) {
    m_layout = layout;
    m_arrays = RowArrays(layout, 3);
    m_listedAt = m_arrays.points(0);
    m_push.assign(std::size_t(layout.slotCount()), Push{});
    m_bands.clear();
    m_bands.resize(bands.size());
    const std::size_t blocks = std::size_t(layout.width + RowLayout::kLanes - 1) / RowLayout::kLanes;
    for (std::size_t n = 0; n < bands.size(); ++n) {
        m_bands[n].rows = bands[n];
        m_bands[n].listEnd.resize(std::size_t(bands[n].end - bands[n].begin) * blocks);
        m_bands[n].adjacent.reserve(std::size_t(bands[n].end - bands[n].begin) * 4 *
                                    std::size_t(layout.width));
    }
}

// What all points move together brings none nearer to another, so a falling sheet keeps its lists. The mean
// of a sample is near enough, and so is a step like the one before: this is a guess at what serves best.
void SelfCollision::foretell(int band, ConstPointRows position, ConstPointRows last) {
    Band& b = m_bands[std::size_t(band)];
    b.foretold = {};
    for (int n = 0; n < kSamples * kSamples; ++n) {
        const int x = (n % kSamples * 2 + 1) * m_layout.width / (2 * kSamples);
        const int rows = b.rows.end - b.rows.begin;
        const int slot = m_layout.slot(x, b.rows.begin + (n / kSamples * 2 + 1) * rows / (2 * kSamples));
        b.foretold[0] += 2 * position.x[slot] - last.x[slot] - m_listedAt.x[slot];
        b.foretold[1] += 2 * position.y[slot] - last.y[slot] - m_listedAt.y[slot];
        b.foretold[2] += 2 * position.z[slot] - last.z[slot] - m_listedAt.z[slot];
    }
}

std::array<double, 3> SelfCollision::foretoldMotion() const {
    std::array<double, 3> mean{};
    for (const Band& band : m_bands)
        for (std::size_t axis = 0; axis < 3; ++axis)
            mean[axis] += band.foretold[axis] / (kSamples * kSamples * double(m_bands.size()));
    return mean;
}

void SelfCollision::measure(int band, ConstPointRows position, RowRange rows) {
    Band& b = m_bands[std::size_t(band)];
    if (rows.begin == b.rows.begin) {
        b.farthestSquared = 0;
        b.commonMotion = foretoldMotion();
    }
    b.farthestSquared = std::max(
        b.farthestSquared, m_kernels->farthestSquared(m_layout, rows, position, m_listedAt, b.commonMotion));
}

bool SelfCollision::listsHold(int band) {
    Band& mine = m_bands[std::size_t(band)];
    if (mine.listedDistance != m_distance)
        return false;
    double farthestSquared = 0;
    for (const Band& each : m_bands)
        farthestSquared = std::max(farthestSquared, each.farthestSquared);
    // A little less than half the skin, for the rounding of the differences.
    const std::array<double, 3>& motion = mine.commonMotion;
    const double rounding = 1e-12 * (std::abs(motion[0]) + std::abs(motion[1]) + std::abs(motion[2]));
    const double slack = 0.499 * mine.skin * m_distance - rounding;
    ++mine.age;
    return slack > 0 && farthestSquared < slack * slack;
}

void SelfCollision::sortIntoCells(ConstPointRows position) {
    if (m_bands.front().age < kShortLife)
        m_skin = std::min(m_skin * 1.25, kGreatestSkin);
    else if (m_bands.front().age > kLongLife)
        m_skin = std::max(m_skin * 0.8, kLeastSkin);
    const double cellSize = crowded() ? kCellSizeCrowded : kCellSize; // as when lists were made last
    m_cells.sort(position, m_layout, cellSize * (1 + m_skin) * m_distance);
}

void SelfCollision::list(int band, ConstPointRows position) {
    Band& b = m_bands[std::size_t(band)];
    b.crowded = false;
    b.listedDistance = m_distance;
    b.skin = m_skin;
    b.age = 0;
    const std::size_t most = kMostListed * b.listEnd.size();
    std::size_t count = 0, block = 0, longest = 0;
    m_cells.start(b.search, b.rows.begin);
    for (int y = b.rows.begin; y < b.rows.end && !b.crowded; ++y) {
        for (int x = 0; x < m_layout.width; x += RowLayout::kLanes) {
            const std::size_t end = listBlock(b, position, x, y, count);
            longest = std::max(longest, end - count);
            count = end;
            b.listEnd[block++] = std::uint32_t(count);
        }
        b.crowded = count > most;
        const int from = m_layout.slot(0, y);
        std::copy_n(position.x + from, m_layout.width, m_listedAt.x + from);
        std::copy_n(position.y + from, m_layout.width, m_listedAt.y + from);
        std::copy_n(position.z + from, m_layout.width, m_listedAt.z + from);
    }
    b.apart.reserve(RowLayout::kLanes * count);
    if (b.search.found.size() < longest + 1)
        b.search.found.resize(longest + 1);
}

// Writes the block's list to `listed` from `at` on; returns where it ends.
std::size_t SelfCollision::listBlock(Band& band, ConstPointRows position, int x, int y,
                                     std::size_t at) const {
    const auto first = std::uint32_t(m_layout.slot(x, y));
    const std::size_t found =
        m_cells.near(*m_kernels, position, x, y, (1 + band.skin) * m_distance, band.search);
    m_cells.pass(x, y, band.search);
    if (band.listed.size() < at + found + 1)
        band.listed.resize(2 * (at + found + 1));
    const unsigned points = (1U << unsigned(std::min(RowLayout::kLanes, m_layout.width - x))) - 1;
    for (std::size_t n = 0; n < found; ++n) {
        const NearBlock near = band.search.found[n];
        const std::uint32_t ahead = near.slot - first;
        const std::uint32_t row =
            ahead - std::uint32_t(m_layout.stride) + 1; // 0: below and left of the first
        const unsigned lower = ahead < RowLayout::kLanes ? (1U << ahead) - 1 : ~0U;
        const unsigned beside = ahead <= RowLayout::kLanes ? (1U << ahead) >> 1U : 0;
        const unsigned below = row <= RowLayout::kLanes + 1 ? (7U << row) >> 2U : 0;
        band.listed[at] = {near.slot, near.lanes & points & lower & ~(beside | below)};
        at += band.listed[at].lanes != 0 ? 1 : 0; // without a branch that nothing could predict
    }
    return at;
}

bool SelfCollision::crowded() const {
    return std::ranges::any_of(m_bands, [](const Band& band) { return band.crowded; });
}

void SelfCollision::findPairs(int band, ConstPointRows position) {
    Band& b = m_bands[std::size_t(band)];
    if (crowded()) {
        b.listedDistance = -1;
        b.adjacent.count = b.apart.count = 0;
        return;
    }
    b.adjacent.count =
        m_kernels->adjacentPairs(m_layout, b.rows, position, m_distance, b.adjacent.pairs.data());
    b.apart.count = m_kernels->listedPairs(m_layout, b.rows, {b.listEnd.data(), b.listed.data()}, position,
                                           m_distance, b.search.found.data(), b.apart.pairs.data());
}

bool SelfCollision::anyPairs() const {
    return crowded() || std::ranges::any_of(m_bands, [](const Band& band) {
               return band.adjacent.count + band.apart.count > 0;
           });
}

bool SelfCollision::owns(const Band& band, std::uint32_t slot) const {
    return int(slot) >= m_layout.slot(0, band.rows.begin) && int(slot) < m_layout.slot(0, band.rows.end);
}

// What two points that are too near ask of each other differs in sign only, to the last bit.
void SelfCollision::add(ConstPointRows position, std::uint32_t a, std::uint32_t b, bool toA, bool toB) {
    const double dx = position.x[a] - position.x[b];
    const double dy = position.y[a] - position.y[b];
    const double dz = position.z[a] - position.z[b];
    const double lengthSquared = dx * dx + dy * dy + dz * dz;
    if (lengthSquared <= 0)
        return;
    const double length = std::sqrt(lengthSquared);
    const double scale = (m_distance - length) / length;
    const Push asked{scale * dx, scale * dy, scale * dz, 1};
    if (toA) {
        Push& push = m_push[a];
        push = {push.x + asked.x, push.y + asked.y, push.z + asked.z, push.neighbours + 1};
    }
    if (toB) {
        Push& push = m_push[b];
        push = {push.x - asked.x, push.y - asked.y, push.z - asked.z, push.neighbours + 1};
    }
}

void SelfCollision::addUp(int band, ConstPointRows position) {
    Band& mine = m_bands[std::size_t(band)];
    if (crowded()) {
        addUpCrowded(mine, position);
        return;
    }
    const auto take = [&](const SlotPair& pair) {
        const bool toA = owns(mine, pair.a);
        const bool toB = owns(mine, pair.b);
        if (toA || toB)
            add(position, pair.a, pair.b, toA, toB);
    };
    const auto key = [](const SlotPair& pair) { return std::uint64_t(pair.a) << 32U | pair.b; };
    for (const Band& from : m_bands) { // both kinds of pairs, merged
        const SlotPair* adjacent = from.adjacent.pairs.data();
        const SlotPair* const adjacentEnd = adjacent + from.adjacent.count;
        const SlotPair* apart = from.apart.pairs.data();
        const SlotPair* const apartEnd = apart + from.apart.count;
        while (adjacent != adjacentEnd && apart != apartEnd)
            take(key(*adjacent) < key(*apart) ? *adjacent++ : *apart++);
        std::for_each(adjacent, adjacentEnd, take);
        std::for_each(apart, apartEnd, take);
    }
}

void SelfCollision::addUpCrowded(Band& band, ConstPointRows position) {
    std::vector<std::uint32_t>& near = band.neighbours;
    m_cells.start(band.search);
    for (int y = band.rows.begin; y < band.rows.end; ++y)
        for (int x = 0; x < m_layout.width; x += RowLayout::kLanes) {
            const std::size_t found = m_cells.near(*m_kernels, position, x, y, m_distance, band.search);
            for (int lane = 0; lane < std::min(RowLayout::kLanes, m_layout.width - x); ++lane) {
                const auto point = std::uint32_t(m_layout.slot(x + lane, y));
                near.clear();
                for (std::size_t n = 0; n < found; ++n)
                    if ((band.search.found[n].lanes >> unsigned(lane) & 1U) != 0)
                        near.push_back(band.search.found[n].slot);
                std::ranges::sort(near);
                for (const std::uint32_t other : near)
                    add(position, point, other, true, false); // itself is at the same place
            }
        }
}

void SelfCollision::move(std::uint32_t slot, PointRows position, double share) {
    Push& push = m_push[slot];
    if (push.neighbours > 0 && m_pinned[slot] == 0) {
        const double scale = share / push.neighbours;
        position.x[slot] += push.x * scale;
        position.y[slot] += push.y * scale;
        position.z[slot] += push.z * scale;
    }
    push = Push{};
}

// So many that going through all points is faster than through the pairs' ends.
bool SelfCollision::manyPairs() const {
    std::size_t pairs = 0;
    for (const Band& band : m_bands)
        pairs += band.adjacent.count + band.apart.count;
    return crowded() || pairs > m_push.size() / 4;
}

void SelfCollision::apply(int band, PointRows position, double share) {
    const Band& mine = m_bands[std::size_t(band)];
    if (manyPairs()) {
        for (int slot = m_layout.slot(0, mine.rows.begin); slot < m_layout.slot(0, mine.rows.end); ++slot)
            move(std::uint32_t(slot), position, share);
        return;
    }
    for (const Band& from : m_bands)
        for (const Pairs* pairs : {&from.adjacent, &from.apart})
            for (std::size_t n = 0; n < pairs->count; ++n)
                for (const std::uint32_t end : {pairs->pairs[n].a, pairs->pairs[n].b})
                    if (owns(mine, end))
                        move(end, position, share);
}

std::size_t SelfCollision::bytes() const {
    std::size_t sum = m_arrays.bytes() + m_push.size() * sizeof(Push) + m_cells.bytes();
    for (const Band& band : m_bands)
        sum += sizeof band + sizeof(std::uint32_t) * band.search.begin.capacity() +
               sizeof(NearBlock) * (band.listed.capacity() + band.search.found.capacity()) +
               sizeof(SlotPair) * (band.adjacent.pairs.size() + band.apart.pairs.size());
    return sum;
}

} // namespace clothlab
