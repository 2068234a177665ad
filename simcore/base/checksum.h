// Checksums of bytes: XXH3 with 64 bits (Collet, github.com/Cyan4973/xxHash, "xxhash_spec").
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

namespace clothlab {

std::uint64_t checksum(std::string_view bytes);

// The same of bytes that come piece by piece.
class Checksum {
public:
    Checksum();
    ~Checksum();
    Checksum(const Checksum&) = delete;
    Checksum& operator=(const Checksum&) = delete;

    void add(std::string_view bytes);
    void add(std::span<const double> values); // their bits, little endian on every machine
    std::uint64_t value() const;              // of all so far

private:
    struct State;
    std::unique_ptr<State> m_state;
};

} // namespace clothlab
