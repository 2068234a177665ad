// Numbers as bytes, the lowest first, on any machine.
#pragma once

#include <bit>
#include <concepts>
#include <cstdint>
#include <string>
#include <string_view>
#include <type_traits>

namespace clothlab {

template <std::integral Int>
void appendLittleEndian(std::string& bytes, Int value) {
    for (unsigned shift = 0; shift < 8 * sizeof(Int); shift += 8)
        bytes += static_cast<char>(static_cast<std::make_unsigned_t<Int>>(value) >> shift & 0xFFU);
}

inline void appendLittleEndian(std::string& bytes, double value) {
    appendLittleEndian(bytes, std::bit_cast<std::uint64_t>(value));
}

// Reads one number after another. Beyond the end all numbers are 0, and good() says so.
class LittleEndianReader {
public:
    explicit LittleEndianReader(std::string_view bytes) : m_bytes(bytes) {}

    template <typename Number>
    Number read() {
        if constexpr (std::is_same_v<Number, double>) {
            return std::bit_cast<double>(read<std::uint64_t>());
        } else {
            using Unsigned = std::make_unsigned_t<Number>;
            const std::string_view part = readBytes(sizeof(Number));
            Unsigned value = 0;
            for (std::size_t i = 0; i < part.size(); ++i)
                value = Unsigned(value | Unsigned(Unsigned(static_cast<unsigned char>(part[i])) << (8 * i)));
            return static_cast<Number>(value);
        }
    }
    // All or nothing.
    std::string_view readBytes(std::uint64_t count) {
        if (count > m_bytes.size()) {
            m_good = false;
            m_bytes = {};
            return {};
        }
        const std::string_view part = m_bytes.substr(0, std::size_t(count));
        m_bytes.remove_prefix(std::size_t(count));
        return part;
    }

    std::string_view rest() const { return m_bytes; }
    bool good() const { return m_good; }
    bool atEnd() const { return m_good && m_bytes.empty(); }

private:
    std::string_view m_bytes;
    bool m_good = true;
};

} // namespace clothlab
