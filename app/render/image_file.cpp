#include "app/render/image_file.h"
#include "app/render/words.h"

#include <QFile>
#include <QFileInfo>

#include <memory>

// The implementation comes with its own warnings, and the functions that are not used.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#pragma GCC diagnostic ignored "-Wsign-compare"
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 8192
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#include <stb/stb_image.h>
#pragma GCC diagnostic pop

namespace clothlab::render {
namespace {

constexpr qint64 kMostImageBytes = 64 << 20;
constexpr int kRgba = 4;

} // namespace

std::optional<Image> readImage(const QString& path, QString& reason) {
    const auto fail = [&](const QString& why) {
        reason = why;
        return std::nullopt;
    };
    QFile file(path);
    const QFileInfo info(path);
    if (info.isDir())
        return fail(tr("is a folder; choose a PNG or JPEG file"));
    if (info.exists() && !info.isFile()) // a pipe or a device, which may never end
        return fail(tr("is no ordinary file; choose a PNG or JPEG file"));
    if (!file.open(QIODevice::ReadOnly))
        return fail(tr("cannot be read: %1").arg(file.errorString()));
    if (file.size() > kMostImageBytes)
        return fail(tr("is larger than 64 MiB; choose a smaller picture"));
    const QByteArray bytes = file.readAll();
    Image image;
    int channels = 0;
    const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
        stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.constData()),
                              static_cast<int>(bytes.size()), &image.width, &image.height, &channels, kRgba),
        &stbi_image_free);
    if (!pixels)
        return fail(
            tr("is no PNG or JPEG picture that can be read (%1); choose another one, of up to 8192 pixels "
               "along a side")
                .arg(QString::fromLatin1(stbi_failure_reason())));
    image.rgba.assign(pixels.get(),
                      pixels.get() + static_cast<std::ptrdiff_t>(kRgba) * image.width * image.height);
    return image;
}

Image checker() {
    constexpr int side = 64;
    constexpr int square = 8;
    Image image{side, side, {}};
    for (int y = 0; y < side; ++y) {
        for (int x = 0; x < side; ++x) {
            const bool magenta = (x / square + y / square) % 2 == 0;
            const std::uint8_t green = magenta ? 40 : 90;
            const std::uint8_t other = magenta ? 220 : 90;
            image.rgba.insert(image.rgba.end(), {other, green, other, 255});
        }
    }
    return image;
}

} // namespace clothlab::render
