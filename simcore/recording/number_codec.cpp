#include "simcore/recording/number_codec.h"

#include "simcore/base/little_endian.h"
#include "simcore/recording/compression.h"

#include <algorithm>
#include <bit>
#include <cstring>

namespace clothlab {
namespace {

constexpr unsigned char kEscape = 255; // the number itself is among the escapes
constexpr int kMostBits = 31;
constexpr std::size_t kBytesReadAtOnce = 8;

// 0, -1, 1, -2, … as 0, 1, 2, 3, …
constexpr std::uint32_t folded(std::int32_t value) {
    return static_cast<std::uint32_t>(value) << 1U ^ static_cast<std::uint32_t>(value >> 31);
}

constexpr std::int32_t unfolded(std::uint32_t value) {
    return static_cast<std::int32_t>(value >> 1U ^ (0U - (value & 1U)));
}

int blocksOf(int width) {
    return (width + kNumberBlock - 1) / kNumberBlock;
}

// As many lowest bits as are nearly noise: what is above them has about 3 bits.
int bitsFor(std::uint64_t sum, int count) {
    const int width = int(std::bit_width(sum / std::uint64_t(count)));
    return std::clamp(width - 3, 0, kMostBits);
}

std::uint64_t load(const char* bytes) {
    std::uint64_t value = 0;
    if constexpr (std::endian::native == std::endian::little) {
        std::memcpy(&value, bytes, sizeof(value));
    } else {
        for (unsigned i = 0; i < 8; ++i)
            value |= std::uint64_t(static_cast<unsigned char>(bytes[i])) << (8 * i);
    }
    return value;
}

} // namespace

NumberPacker::NumberPacker(const Grid& grid) : m_width(grid.width), m_folded(kNumberBlock) {}

void NumberPacker::begin() {
    for (std::string* stream : {&m_bitCounts, &m_quotients, &m_bits, &m_escapes})
        stream->clear();
    m_pending = 0;
    m_pendingCount = 0;
}

void NumberPacker::addRow(const std::int32_t* numbers) {
    for (int x = 0; x < m_width; x += kNumberBlock)
        addBlock(numbers + x, std::min(kNumberBlock, m_width - x));
}

void NumberPacker::addBlock(const std::int32_t* numbers, int count) {
    std::uint32_t* const z = m_folded.data();
    std::uint64_t sum = 0;
    for (int i = 0; i < count; ++i) {
        z[i] = folded(numbers[i]);
        sum += z[i];
    }
    const int bits = bitsFor(sum, count);
    m_bitCounts += static_cast<char>(bits);
    const std::size_t begin = m_quotients.size();
    m_quotients.resize(begin + std::size_t(count));
    auto* const quotients = reinterpret_cast<unsigned char*>(&m_quotients[begin]);
    bool anyEscape = false;
    for (int i = 0; i < count; ++i) {
        const std::uint32_t quotient = z[i] >> unsigned(bits);
        anyEscape |= quotient >= kEscape;
        quotients[i] = static_cast<unsigned char>(std::min<std::uint32_t>(quotient, kEscape));
    }
    if (anyEscape)
        for (int i = 0; i < count; ++i)
            if (quotients[i] == kEscape)
                appendLittleEndian(m_escapes, z[i]);
    if (bits > 0)
        for (int i = 0; i < count; ++i)
            addBits(z[i] & ((std::uint32_t(1) << unsigned(bits)) - 1), bits);
}

void NumberPacker::addBits(std::uint64_t bits, int count) {
    m_pending |= bits << unsigned(m_pendingCount);
    m_pendingCount += count;
    if (m_pendingCount < 32)
        return;
    appendLittleEndian(m_bits, static_cast<std::uint32_t>(m_pending));
    m_pending >>= 32U;
    m_pendingCount -= 32;
}

void NumberPacker::finish(std::string& out) {
    for (; m_pendingCount > 0; m_pendingCount -= 8, m_pending >>= 8U)
        m_bits += static_cast<char>(m_pending & 0xFFU);
    for (const std::string* stream : {&m_bitCounts, &m_quotients}) {
        const std::size_t length = out.size();
        appendLittleEndian(out, std::uint32_t(0));
        const std::size_t begin = out.size();
        appendCompressed(out, *stream);
        std::string bytes;
        appendLittleEndian(bytes, std::uint32_t(out.size() - begin));
        out.replace(length, bytes.size(), bytes);
    }
    out += m_bits;
    out += m_escapes;
}

NumberUnpacker::NumberUnpacker(const Grid& grid)
    : m_width(grid.width), m_rows(3 * grid.height), m_blocks(blocksOf(grid.width)) {}

bool NumberUnpacker::begin(std::string_view bytes) {
    LittleEndianReader reader(bytes);
    m_bitCounts.resize(std::size_t(m_rows) * std::size_t(m_blocks));
    m_quotients.resize(std::size_t(m_rows) * std::size_t(m_width));
    for (std::string* stream : {&m_bitCounts, &m_quotients}) {
        const auto length = reader.read<std::uint32_t>();
        if (!decompress(reader.readBytes(length), stream->data(), stream->size()))
            return false;
    }
    m_escapes = reader.rest();
    m_block = m_number = m_escape = 0;
    m_bit = 0;
    return reader.good() && measure();
}

// Cuts the rest into bits and escapes. False if it is not as long as they are.
bool NumberUnpacker::measure() {
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < m_bitCounts.size(); ++i) {
        const auto count = static_cast<unsigned char>(m_bitCounts[i]);
        const int x = int(i % std::size_t(m_blocks)) * kNumberBlock;
        if (count > kMostBits)
            return false;
        bits += std::uint64_t(count) * std::uint64_t(std::min(kNumberBlock, m_width - x));
    }
    const auto escapes = std::uint64_t(std::count(m_quotients.begin(), m_quotients.end(), char(kEscape)));
    const std::uint64_t bytes = (bits + 7) / 8;
    if (m_escapes.size() != bytes + 4 * escapes)
        return false;
    m_bits.assign(m_escapes.substr(0, std::size_t(bytes)));
    m_bits.append(kBytesReadAtOnce, '\0');
    m_escapes.remove_prefix(std::size_t(bytes));
    return true;
}

void NumberUnpacker::nextRow(std::int32_t* numbers) {
    for (int x = 0; x < m_width; x += kNumberBlock) {
        const int count = std::min(kNumberBlock, m_width - x);
        const auto bits = unsigned(static_cast<unsigned char>(m_bitCounts[m_block++]));
        const auto* quotients = reinterpret_cast<const unsigned char*>(&m_quotients[m_number]);
        m_number += std::size_t(count);
        const std::uint32_t mask = (std::uint32_t(1) << bits) - 1;
        bool anyEscape = false;
        for (int i = 0; i < count; ++i) {
            anyEscape |= quotients[i] == kEscape;
            const std::uint64_t at = m_bit + std::uint64_t(unsigned(i)) * bits;
            const auto low = static_cast<std::uint32_t>(load(&m_bits[std::size_t(at >> 3U)]) >> (at & 7U));
            numbers[x + i] = unfolded(std::uint32_t(quotients[i]) << bits | (low & mask));
        }
        m_bit += std::uint64_t(unsigned(count)) * bits;
        if (!anyEscape)
            continue;
        for (int i = 0; i < count; ++i)
            if (quotients[i] == kEscape) {
                LittleEndianReader escape(m_escapes.substr(m_escape, 4));
                numbers[x + i] = unfolded(escape.read<std::uint32_t>());
                m_escape += 4;
            }
    }
}

} // namespace clothlab
