#include "simcore/base/checksum.h"

#include <array>
#include <bit>
#include <cstring>

#define XXH_INLINE_ALL // compiled here, for the vectors that the compiler may use
#include <xxhash.h>

namespace clothlab {

std::uint64_t checksum(std::string_view bytes) {
    return XXH3_64bits(bytes.data(), bytes.size());
}

struct Checksum::State {
    XXH3_state_t xxh3;
};

Checksum::Checksum() : m_state(std::make_unique<State>()) {
    XXH3_64bits_reset(&m_state->xxh3);
}

Checksum::~Checksum() = default;

void Checksum::add(std::string_view bytes) {
    if (!bytes.empty())
        XXH3_64bits_update(&m_state->xxh3, bytes.data(), bytes.size());
}

void Checksum::add(std::span<const double> values) {
    if constexpr (std::endian::native == std::endian::little) {
        add(std::string_view(reinterpret_cast<const char*>(values.data()), values.size_bytes()));
    } else {
        for (const double value : values) {
            const auto bits = std::bit_cast<std::uint64_t>(value);
            std::array<char, 8> bytes{};
            for (unsigned i = 0; i < 8; ++i)
                bytes[i] = static_cast<char>(bits >> (8 * i) & 0xFFU);
            add(std::string_view(bytes.data(), bytes.size()));
        }
    }
}

std::uint64_t Checksum::value() const {
    return XXH3_64bits_digest(&m_state->xxh3);
}

} // namespace clothlab
