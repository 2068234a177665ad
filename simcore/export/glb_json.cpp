#include "simcore/export/glb_json.h"

#include "simcore/export/number.h"

#include <sstream>

namespace clothlab {
namespace {

// Numbers of accessors.
enum Accessor { Indices, TextureCoordinates, Normals, Positions, Times, Weights, Targets };
// And of views.
enum View { IndexView, TextureCoordinateView, NormalView, PositionView, TargetView, TimeView, WeightView };

constexpr int kFloat = 5126, kUnsigned = 5125; // component types
constexpr int kVertexBuffer = 34962, kIndexBuffer = 34963;

void writeArray(std::ostream& out, const std::array<float, 3>& values) {
    out << '[' << Number{values[0]} << ',' << Number{values[1]} << ',' << Number{values[2]} << ']';
}

// Left open for what else there is to say of it.
void beginAccessor(std::ostream& out, int view, int component, std::uint64_t count, const char* type) {
    out << "{\"bufferView\":" << Number{view} << ",\"componentType\":" << Number{component}
        << ",\"count\":" << Number{count} << ",\"type\":\"" << type << '"';
}

void writePositions(std::ostream& out, int view, std::uint64_t offset, int points, const Bounds& bounds) {
    beginAccessor(out, view, kFloat, std::uint64_t(points), "VEC3");
    out << ",\"byteOffset\":" << Number{offset} << ",\"min\":";
    writeArray(out, bounds.least);
    out << ",\"max\":";
    writeArray(out, bounds.greatest);
    out << '}';
}

void writeAccessors(std::ostream& out, const GlbContent& content) {
    const std::uint64_t frames = content.times.size();
    const auto points = std::uint64_t(content.points);
    out << R"("accessors":[)";
    beginAccessor(out, IndexView, kUnsigned, 3 * std::uint64_t(content.triangles), "SCALAR");
    out << "},";
    beginAccessor(out, TextureCoordinateView, kFloat, points, "VEC2");
    out << "},";
    beginAccessor(out, NormalView, kFloat, points, "VEC3");
    out << "},";
    writePositions(out, PositionView, 0, content.points, content.bounds.front());
    if (frames > 1) {
        out << ',';
        beginAccessor(out, TimeView, kFloat, frames, "SCALAR");
        out << ",\"min\":[" << Number{content.times.front()} << "],\"max\":[" << Number{content.times.back()}
            << "]},";
        beginAccessor(out, WeightView, kFloat, frames * (frames - 1), "SCALAR");
        out << '}';
        for (std::uint64_t target = 0; target + 1 < frames; ++target) {
            out << ",\n";
            writePositions(out, TargetView, 12 * points * target, content.points, content.bounds[target + 1]);
        }
    }
    out << "],\n";
}

void writeViews(std::ostream& out, const GlbLayout& layout) {
    const auto view = [&](const char* before, const GlbView& place, int target, int stride) {
        out << before << "{\"buffer\":0,\"byteOffset\":" << Number{place.offset}
            << ",\"byteLength\":" << Number{place.bytes};
        if (target != 0)
            out << ",\"target\":" << Number{target};
        if (stride != 0)
            out << ",\"byteStride\":" << Number{stride};
        out << '}';
    };
    out << R"("bufferViews":[)";
    view("", layout.indices, kIndexBuffer, 0);
    view(",", layout.textureCoordinates, kVertexBuffer, 0);
    view(",", layout.normals, kVertexBuffer, 0);
    view(",", layout.positions, kVertexBuffer, 0);
    if (layout.targets.bytes > 0) {
        view(",", layout.targets, kVertexBuffer, 12); // has to be said where several share it
        view(",", layout.times, 0, 0);
        view(",", layout.weights, 0, 0);
    }
    out << "],\n\"buffers\":[{\"byteLength\":" << Number{layout.bytes} << "}]}\n";
}

void writeMesh(std::ostream& out, int targets) {
    out << R"("meshes":[{"name":"cloth","primitives":[{"attributes":{"POSITION":3,"NORMAL":2,"TEXCOORD_0":1},)"
        << R"("indices":0,"material":0)";
    for (int i = 0; i < targets; ++i)
        out << (i == 0 ? ",\"targets\":[" : ",") << "{\"POSITION\":" << Number{Targets + i} << '}';
    out << (targets > 0 ? "]}]" : "}]");
    for (int i = 0; i < targets; ++i)
        out << (i == 0 ? R"(,"extras":{"targetNames":[)" : ",") << "\"frame " << Number{i + 1} << '"';
    out << (targets > 0 ? "]}}],\n" : "}],\n");
}

} // namespace

GlbLayout layoutOf(const GlbContent& content, int frames) {
    GlbLayout layout;
    const auto place = [&](GlbView& view, std::uint64_t numbers) {
        view = {layout.bytes, 4 * numbers};
        layout.bytes += view.bytes;
    };
    const auto points = std::uint64_t(content.points);
    const std::uint64_t targets = std::uint64_t(frames) - 1;
    place(layout.indices, 3 * std::uint64_t(content.triangles));
    place(layout.textureCoordinates, 2 * points);
    place(layout.normals, 3 * points);
    place(layout.positions, 3 * points);
    place(layout.targets, 3 * points * targets);
    place(layout.times, targets > 0 ? std::uint64_t(frames) : 0);
    place(layout.weights, targets * std::uint64_t(frames));
    return layout;
}

std::string jsonOf(const GlbContent& content) {
    const int frames = int(content.times.size());
    std::ostringstream out;
    out << R"({"asset":{"version":"2.0","generator":")" << content.about << "\"},\n"
        << R"("scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"name":"cloth","mesh":0}],)" << '\n'
        << R"("materials":[{"name":"cloth","doubleSided":true,)"
        << R"("pbrMetallicRoughness":{"metallicFactor":0,"roughnessFactor":0.9}}],)" << '\n';
    writeMesh(out, frames - 1);
    if (frames > 1)
        out << R"("animations":[{"name":"cloth","channels":[{"sampler":0,"target":{"node":0,"path":"weights"}}],)"
            << R"("samplers":[{"input":4,"interpolation":"LINEAR","output":5}]}],)" << '\n';
    writeAccessors(out, content);
    writeViews(out, layoutOf(content, frames));
    return out.str();
}

std::uint64_t mostJsonBytes(int frames) {
    return 4096 + 400 * std::uint64_t(frames);
}

} // namespace clothlab
