// Whole numbers that are mostly near 0, as bytes: of each block of a row the lowest bits as they are, and
// what is above them, a byte each, compressed by their frequencies. docs/clothtake.md has the format.
#pragma once

#include "simcore/cloth/grid.h"

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace clothlab {

inline constexpr int kNumberBlock = 32; // columns of a row that have the same number of lowest bits

// Three numbers a point, row after row, in a row one coordinate after the other.
class NumberPacker {
public:
    explicit NumberPacker(const Grid& grid);

    void begin();
    void addRow(const std::int32_t* numbers); // of one coordinate; width of them
    void finish(std::string& out);            // appends

private:
    void addBlock(const std::int32_t* numbers, int count);
    void addBits(std::uint64_t bits, int count);

    int m_width;
    std::vector<std::uint32_t> m_folded; // of a block
    std::string m_bitCounts, m_quotients, m_bits, m_escapes;
    std::uint64_t m_pending = 0; // bits that are no whole byte yet
    int m_pendingCount = 0;
};

class NumberUnpacker {
public:
    explicit NumberUnpacker(const Grid& grid);

    // False if the bytes cannot be such numbers.
    bool begin(std::string_view bytes);
    // The next row of a coordinate, up to height * 3 of them.
    void nextRow(std::int32_t* numbers);

private:
    bool measure();

    int m_width, m_rows, m_blocks; // blocks of a row
    std::string m_bitCounts, m_quotients, m_bits;
    std::string_view m_escapes;
    std::size_t m_block = 0, m_number = 0, m_escape = 0;
    std::uint64_t m_bit = 0;
};

} // namespace clothlab
