#include "simcore/export/export.h"
#include "simcore/export/number.h"
#include "simcore/export/sheet_mesh.h"

namespace clothlab {

void writeObj(std::ostream& out, const Frame& frame, const Placement& placement) {
    const Grid grid = gridOf(frame.scene->cloth);
    const PointArray& position = frame.state.position;
    out << "# ClothLab, " << describe(placement) << ", time " << Number{frame.time} << " s\no cloth\n";
    for (int i = 0; i < grid.pointCount(); ++i) {
        out << "v ";
        writeVector(out, placed(placement, position.at(i)), ' ');
        out << '\n';
    }
    for (int i = 0; i < grid.pointCount(); ++i) {
        const auto [u, v] = textureCoordinate(grid, grid.place(i));
        out << "vt " << Number{u} << ' ' << Number{v} << '\n';
    }
    for (int i = 0; i < grid.pointCount(); ++i) {
        out << "vn ";
        writeVector(out, turned(placement, pointNormal(grid, position, grid.place(i))), ' ');
        out << '\n';
    }
    const auto corner = [](int index) {
        const std::string number = std::to_string(index + 1);
        return ' ' + number + '/' + number + '/' + number;
    };
    forEachTriangle(grid,
                    [&](int a, int b, int c) { out << 'f' << corner(a) << corner(b) << corner(c) << '\n'; });
}

} // namespace clothlab
