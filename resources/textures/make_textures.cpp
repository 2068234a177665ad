// Writes the textures that come with ClothLab: make_textures FOLDER

#include "textures.h"

#include <zlib.h>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <fstream>
#include <functional>
#include <stdexcept>
#include <string>
#include <vector>

namespace {

// stb's own packer makes files larger by a fifth to a half. stb frees what this returns.
unsigned char* deflateForStb(unsigned char* data, int length, int* packedLength, int /*quality*/) {
    uLongf size = compressBound(static_cast<uLong>(length));
    auto* packed = static_cast<unsigned char*>(std::malloc(size));
    if (!packed || compress2(packed, &size, data, static_cast<uLong>(length), Z_BEST_COMPRESSION) != Z_OK) {
        std::free(packed);
        return nullptr;
    }
    *packedLength = static_cast<int>(size);
    return packed;
}

} // namespace

#define STBIW_ZLIB_COMPRESS deflateForStb
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#include <stb/stb_image_write.h>

namespace {

using namespace clothlab::textures;

constexpr int kTextureSize = 1024;
constexpr int kCubeSize = 512;
constexpr int kSamples = 4;
constexpr int kJpegQuality = 92;

using Picture = std::vector<Colour>;
using Bytes = std::vector<unsigned char>;

// Takes the mean of a grid of samples in every pixel. The painter gets a place in the unit square, top row
// first.
Picture paint(int size, const std::function<Colour(float, float)>& painter) {
    Picture picture(static_cast<std::size_t>(size) * size);
    const float step = 1.0f / static_cast<float>(size * kSamples);
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            Colour sum;
            for (int s = 0; s < kSamples * kSamples; ++s) {
                const int column = x * kSamples + s % kSamples;
                const int row = y * kSamples + s / kSamples;
                const float u = (static_cast<float>(column) + 0.5f) * step;
                const float v = (static_cast<float>(row) + 0.5f) * step;
                sum = sum + painter(u, v);
            }
            picture[static_cast<std::size_t>(y) * size + x] = sum * (1.0f / (kSamples * kSamples));
        }
    }
    return picture;
}

unsigned char toByte(float value) {
    return static_cast<unsigned char>(std::clamp(std::floor(value + 0.5f), 0.0f, 255.0f));
}

Bytes encodeColours(const Picture& picture) {
    Bytes bytes;
    bytes.reserve(picture.size() * 3);
    for (const Colour& colour : picture) {
        for (const float channel : {colour.r, colour.g, colour.b}) {
            bytes.push_back(toByte(255.0f * toEncoded(std::clamp(channel, 0.0f, 1.0f))));
        }
    }
    return bytes;
}

// A little blur across the seam too: a slope taken between two texels must not jump.
std::vector<float> softened(const Picture& picture, int size) {
    std::vector<float> result(picture.size());
    const auto at = [&](int x, int y) {
        return picture[static_cast<std::size_t>(wrap(y, size)) * size + wrap(x, size)].r;
    };
    constexpr std::array<float, 3> kWeights{0.25f, 0.5f, 0.25f};
    for (int y = 0; y < size; ++y) {
        for (int x = 0; x < size; ++x) {
            float sum = 0.0f;
            for (int k = 0; k < 9; ++k) {
                sum += kWeights[k % 3] * kWeights[k / 3] * at(x + k % 3 - 1, y + k / 3 - 1);
            }
            result[static_cast<std::size_t>(y) * size + x] = sum;
        }
    }
    return result;
}

// Noise without low frequencies: it hides the steps between the 256 heights and vanishes when a texture is
// filtered.
float dither(int x, int y, int size) {
    const auto at = [=](int i, int j) { return hashUnit(wrap(i, size), wrap(j, size), 77u); };
    const float around = at(x - 1, y) + at(x + 1, y) + at(x, y - 1) + at(x, y + 1);
    return 0.6f * (at(x, y) - 0.25f * around);
}

Bytes encodeHeights(const Picture& picture, int size) {
    const std::vector<float> heights = softened(picture, size);
    const auto [low, high] = std::minmax_element(heights.begin(), heights.end());
    const float scale = 255.0f / (*high - *low);
    Bytes bytes(heights.size());
    for (std::size_t i = 0; i < heights.size(); ++i) {
        const int x = static_cast<int>(i) % size;
        const int y = static_cast<int>(i) / size;
        bytes[i] = toByte((heights[i] - *low) * scale + dither(x, y, size));
    }
    return bytes;
}

void append(void* file, void* data, int size) {
    static_cast<std::string*>(file)->append(static_cast<const char*>(data), static_cast<std::size_t>(size));
}

// stb would not notice a full disk.
void save(const std::filesystem::path& path, const std::string& file) {
    std::ofstream stream(path, std::ios::binary);
    stream.write(file.data(), static_cast<std::streamsize>(file.size()));
    stream.close();
    if (!stream)
        throw std::runtime_error("cannot write " + path.string());
    std::printf("%s (%zu bytes)\n", path.string().c_str(), file.size());
}

void writePng(const std::filesystem::path& path, int channels, const Bytes& bytes) {
    std::string file;
    if (!stbi_write_png_to_func(append, &file, kTextureSize, kTextureSize, channels, bytes.data(),
                                kTextureSize * channels))
        throw std::runtime_error("no memory to pack " + path.string());
    save(path, file);
}

void writeJpeg(const std::filesystem::path& path, const Bytes& bytes) {
    std::string file;
    if (!stbi_write_jpg_to_func(append, &file, kCubeSize, kCubeSize, 3, bytes.data(), kJpegQuality))
        throw std::runtime_error("no memory to pack " + path.string());
    save(path, file);
}

void writeTextures(const std::filesystem::path& folder) {
    writePng(folder / "texture_1.png", 3, encodeColours(paint(kTextureSize, tartan)));
    writePng(folder / "texture_2.png", 1, encodeHeights(paint(kTextureSize, basketHeight), kTextureSize));
    writePng(folder / "texture_3.png", 1, encodeHeights(paint(kTextureSize, quiltHeight), kTextureSize));
    writePng(folder / "texture_4.png", 3, encodeColours(paint(kTextureSize, print)));
    writePng(folder / "texture_5.png", 3, encodeColours(paint(kTextureSize, damask)));
}

struct Face {
    const char* name;
    // The direction is forward + s * right + t * down, as OpenGL's table of cube map faces has it.
    std::array<float, 3> forward;
    std::array<float, 3> right;
    std::array<float, 3> down;
};

constexpr std::array<Face, 6> kFaces{{{"posx", {1, 0, 0}, {0, 0, -1}, {0, -1, 0}},
                                      {"negx", {-1, 0, 0}, {0, 0, 1}, {0, -1, 0}},
                                      {"posy", {0, 1, 0}, {1, 0, 0}, {0, 0, 1}},
                                      {"negy", {0, -1, 0}, {1, 0, 0}, {0, 0, -1}},
                                      {"posz", {0, 0, 1}, {1, 0, 0}, {0, -1, 0}},
                                      {"negz", {0, 0, -1}, {-1, 0, 0}, {0, -1, 0}}}};

void writeCubeMap(const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder);
    for (const Face& face : kFaces) {
        const auto painter = [&face](float u, float v) {
            const float s = 2.0f * u - 1.0f;
            const float t = 2.0f * v - 1.0f;
            std::array<float, 3> d{};
            for (std::size_t i = 0; i < 3; ++i) {
                d[i] = face.forward[i] + s * face.right[i] + t * face.down[i];
            }
            return studio(d[0], d[1], d[2]);
        };
        writeJpeg(folder / (std::string(face.name) + ".jpg"), encodeColours(paint(kCubeSize, painter)));
    }
}

} // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: make_textures FOLDER\n");
        return EXIT_FAILURE;
    }
    try {
        const std::filesystem::path folder = argv[1];
        std::filesystem::create_directories(folder);
        writeTextures(folder);
        writeCubeMap(folder / "cubemap");
    } catch (const std::exception& error) {
        std::fprintf(stderr, "make_textures: %s\n", error.what());
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
}
