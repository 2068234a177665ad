// What a .glb says of its own bytes.
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

namespace clothlab {

struct Bounds {
    std::array<float, 3> least = filled(std::numeric_limits<float>::infinity());
    std::array<float, 3> greatest = filled(-std::numeric_limits<float>::infinity());

private:
    static std::array<float, 3> filled(float value) { return {value, value, value}; }
};

struct GlbContent {
    int points = 0, triangles = 0;
    std::string about;
    // One a frame: of the first frame its positions, of another what it differs by from them.
    std::vector<Bounds> bounds;
    std::vector<float> times; // s, one a frame
};

// A stretch of the binary chunk. In the order in which they are there.
struct GlbView {
    std::uint64_t offset = 0, bytes = 0;
};
struct GlbLayout {
    GlbView indices, textureCoordinates, normals, positions, targets, times, weights;
    std::uint64_t bytes = 0;
};
// The last three are empty if there is one frame.
GlbLayout layoutOf(const GlbContent& content, int frames);

// Of all of content.times.
std::string jsonOf(const GlbContent& content);

// What jsonOf() takes at most for so many frames; a multiple of four.
std::uint64_t mostJsonBytes(int frames);

} // namespace clothlab
