#include "simcore/export/export.h"
#include "simcore/export/number.h"
#include "simcore/inspect/inspect.h"

namespace clothlab {

void writeCsv(std::ostream& out, const Frame& frame, const Placement& placement) {
    const Scene& scene = *frame.scene;
    const Grid grid = gridOf(scene.cloth);
    const std::vector<std::uint8_t> pinned = pinnedMask(scene.cloth);
    out << "index,x,y,position_x,position_y,position_z,last_position_x,last_position_y,last_position_z,"
           "velocity_x,velocity_y,velocity_z,pinned\n";
    for (int i = 0; i < grid.pointCount(); ++i) {
        const GridPoint p = grid.place(i);
        out << Number{i} << ',' << Number{p.x} << ',' << Number{p.y} << ',';
        writeVector(out, placed(placement, frame.state.position.at(i)), ',');
        out << ',';
        writeVector(out, placed(placement, frame.state.lastPosition.at(i)), ',');
        out << ',';
        writeVector(out, placed(placement, velocity(frame.state, i, scene.simulation.timeStep())), ',');
        out << ',' << int(pinned[std::size_t(i)]) << '\n';
    }
}

} // namespace clothlab
