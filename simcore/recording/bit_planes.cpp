#include "simcore/recording/bit_planes.h"

#include "simcore/base/little_endian.h"
#include "simcore/recording/compression.h"

namespace clothlab {

void appendPlanes(std::string& out, const std::vector<std::uint64_t>& numbers) {
    std::string plane(numbers.size(), '\0');
    std::string packed;
    for (unsigned shift = 0; shift < 64; shift += 8) {
        for (std::size_t i = 0; i < numbers.size(); ++i)
            plane[i] = static_cast<char>(numbers[i] >> shift & 0xFFU);
        packed.clear();
        appendCompressed(packed, plane);
        const bool smaller = packed.size() < plane.size();
        const std::string& kept = smaller ? packed : plane;
        appendLittleEndian(out, std::uint32_t(kept.size()));
        out += kept;
    }
}

bool readPlanes(std::string_view& bytes, std::vector<std::uint64_t>& numbers) {
    LittleEndianReader reader(bytes);
    std::string unpacked(numbers.size(), '\0');
    numbers.assign(numbers.size(), 0);
    for (unsigned shift = 0; shift < 64; shift += 8) {
        const auto length = reader.read<std::uint32_t>();
        std::string_view plane = reader.readBytes(length);
        if (!reader.good())
            return false;
        if (plane.size() != numbers.size()) {
            if (!decompress(plane, unpacked.data(), unpacked.size()))
                return false;
            plane = unpacked;
        }
        for (std::size_t i = 0; i < numbers.size(); ++i)
            numbers[i] |= std::uint64_t(static_cast<unsigned char>(plane[i])) << shift;
    }
    bytes = reader.rest();
    return true;
}

} // namespace clothlab
