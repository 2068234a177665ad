#include "simcore/export/bytes.h"
#include "simcore/export/export.h"
#include "simcore/export/number.h"
#include "simcore/export/sheet_mesh.h"

namespace clothlab {

void writePly(std::ostream& out, const Frame& frame, const Placement& placement) {
    const Grid grid = gridOf(frame.scene->cloth);
    const PointArray& position = frame.state.position;
    out << "ply\nformat binary_little_endian 1.0\ncomment ClothLab, " << describe(placement) << ", time "
        << Number{frame.time} << " s\nelement vertex " << Number{grid.pointCount()} << '\n';
    for (const char* name : {"x", "y", "z", "nx", "ny", "nz", "s", "t"})
        out << "property float " << name << '\n';
    out << "element face " << Number{triangleCount(grid)}
        << "\nproperty list uchar int vertex_indices\nend_header\n";
    std::string bytes;
    for (int i = 0; i < grid.pointCount(); ++i) {
        const GridPoint p = grid.place(i);
        bytes.clear();
        appendLittle(bytes, placed(placement, position.at(i)));
        appendLittle(bytes, turned(placement, pointNormal(grid, position, p)));
        for (const double coordinate : textureCoordinate(grid, p))
            appendLittle(bytes, static_cast<float>(coordinate));
        out << bytes;
    }
    forEachTriangle(grid, [&](int a, int b, int c) {
        bytes.assign(1, '\3');
        for (const int corner : {a, b, c})
            appendLittle(bytes, static_cast<std::uint32_t>(corner));
        out << bytes;
    });
}

} // namespace clothlab
