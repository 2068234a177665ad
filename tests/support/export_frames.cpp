#include "tests/support/export_frames.h"

#include "tests/support/random.h"

#include <bit>
#include <cmath>
#include <fstream>
#include <iterator>

namespace clothlab::test {

Frame sampleFrame(int nx, int ny) {
    Scene scene;
    scene.cloth.numWidthPoints = nx;
    scene.cloth.numHeightPoints = ny;
    scene.cloth.pinned = {{1, 0}, {0, 1}};
    Frame frame;
    frame.state = startState(scene);
    SplitMix64 random(5);
    for (PointArray* points : {&frame.state.position, &frame.state.lastPosition})
        for (int i = 0; i < int(points->size()); ++i) {
            const double size = std::pow(10, random.real(-12, 3));
            points->set(i, Vec3(random.real(-size, size), 1.0 / 3 * size, points->z[std::size_t(i)] + 0.1));
        }
    frame.scene = std::make_shared<const Scene>(scene);
    frame.time = 0.1;
    return frame;
}

std::vector<FramePointer> sampleFrames(int count, int nx, int ny) {
    const Frame first = sampleFrame(nx, ny);
    std::vector<FramePointer> frames;
    SplitMix64 random(7);
    for (int i = 0; i < count; ++i) {
        Frame frame = first;
        for (int p = 0; p < int(frame.state.size()); ++p)
            frame.state.position.set(p, Vec3(random.real(-2, 2), random.real(-2, 2), random.real(-2, 2)));
        frame.time = i / 90.0;
        frame.strainLimitCorrections = 3 * i;
        frames.push_back(std::make_shared<const Frame>(std::move(frame)));
    }
    return frames;
}

Sheet sheetOf(const Frame& frame) {
    return {gridOf(frame.scene->cloth), startState(*frame.scene).position};
}

std::uint32_t ByteReader::byte() {
    if (m_at >= m_bytes.size()) {
        m_failed = true;
        return 0;
    }
    return static_cast<unsigned char>(m_bytes[m_at++]);
}

std::uint32_t ByteReader::little() {
    std::uint32_t value = 0;
    for (unsigned i = 0; i < 4; ++i)
        value += byte() << 8 * i;
    return value;
}

std::uint32_t ByteReader::big() {
    std::uint32_t value = 0;
    for (unsigned i = 0; i < 4; ++i)
        value = value * 256 + byte();
    return value;
}

float ByteReader::littleFloat() {
    return std::bit_cast<float>(little());
}

float ByteReader::bigFloat() {
    return std::bit_cast<float>(big());
}

std::string ByteReader::text(std::size_t size) {
    std::string text;
    while (text.size() < size)
        text += static_cast<char>(byte());
    return text;
}

bool sameFloat(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

std::string bytesOfFile(const std::string& path) {
    std::ifstream in(path, std::ios::binary);
    return in ? std::string(std::istreambuf_iterator<char>(in), {}) : "(cannot be read)";
}

} // namespace clothlab::test
