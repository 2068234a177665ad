// Pictures from PNG and JPEG files.
#pragma once

#include <QString>

#include <cstdint>
#include <optional>
#include <vector>

namespace clothlab::render {

struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba; // 4 * width * height, the upper row first
};

// Nothing, with the reason in words, if the file is missing, too large (64 MiB, or 8192 pixels along a side),
// or neither PNG nor JPEG.
std::optional<Image> readImage(const QString& path, QString& reason);

// 64 by 64 in magenta and grey: stands where a picture could not be read.
Image checker();

} // namespace clothlab::render
