// zstd for what the codecs make: bytes whose frequencies say all, and that hardly ever repeat.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace clothlab {

void appendCompressed(std::string& out, std::string_view bytes);

// Exactly `count` bytes. False if that is not what was compressed; then what is at `to` means nothing.
bool decompress(std::string_view compressed, char* to, std::size_t count);

// With their number in front, as text is compressed. Nothing if they are more than `most`.
std::string compressedText(std::string_view text);
bool decompressText(std::string_view compressed, std::size_t most, std::string& text);

} // namespace clothlab
