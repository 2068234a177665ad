#include "simcore/export/export.h"

#include "simcore/base/file.h"
#include "simcore/inspect/inspect.h"

#include <algorithm>
#include <cctype>
#include <charconv>

namespace clothlab {
namespace {

// The shortest text that reads back as the same bits, whatever the locale.
struct Number {
    double value;
};

std::ostream& operator<<(std::ostream& out, Number number) {
    std::array<char, 32> text{};
    const auto end = std::to_chars(text.data(), text.data() + text.size(), number.value).ptr;
    return out.write(text.data(), end - text.data());
}

void writeVector(std::ostream& out, const Vec3& v, char separator) {
    out << Number{v.x()} << separator << Number{v.y()} << separator << Number{v.z()};
}

// Area-weighted normal of the cells around a point; +y where the sheet has shrunk to nothing.
Vec3 pointNormal(const Grid& grid, const PointArray& position, GridPoint p) {
    const auto at = [&](int x, int y) {
        return position.at(grid.index(std::clamp(x, 0, grid.width - 1), std::clamp(y, 0, grid.height - 1)));
    };
    const Vec3 across = at(p.x + 1, p.y) - at(p.x - 1, p.y);
    const Vec3 down = at(p.x, p.y + 1) - at(p.x, p.y - 1);
    const Vec3 normal = down.cross(across);
    return normal.norm() > 0 ? normal.normalized() : Vec3::UnitY();
}

} // namespace

void writeObj(std::ostream& out, const Frame& frame) {
    const Cloth& cloth = frame.scene->cloth;
    const Grid grid = gridOf(cloth);
    const PointArray& position = frame.state.position;
    out << "# ClothLab, metres, y up, time " << Number{frame.time} << " s\no cloth\n";
    for (int i = 0; i < grid.pointCount(); ++i) {
        out << "v ";
        writeVector(out, position.at(i), ' ');
        out << '\n';
    }
    for (int i = 0; i < grid.pointCount(); ++i) {
        const GridPoint p = grid.place(i);
        out << "vt " << Number{double(p.x) / (grid.width - 1)} << ' '
            << Number{double(p.y) / (grid.height - 1)} << '\n';
    }
    for (int i = 0; i < grid.pointCount(); ++i) {
        out << "vn ";
        writeVector(out, pointNormal(grid, position, grid.place(i)), ' ');
        out << '\n';
    }
    const auto corner = [&](int x, int y) {
        const std::string number = std::to_string(grid.index(x, y) + 1);
        return ' ' + number + '/' + number + '/' + number;
    };
    for (int y = 0; y + 1 < grid.height; ++y)
        for (int x = 0; x + 1 < grid.width; ++x) {
            out << 'f' << corner(x, y) << corner(x, y + 1) << corner(x + 1, y) << '\n';
            out << 'f' << corner(x + 1, y) << corner(x, y + 1) << corner(x + 1, y + 1) << '\n';
        }
}

void writeCsv(std::ostream& out, const Frame& frame) {
    const Scene& scene = *frame.scene;
    const Grid grid = gridOf(scene.cloth);
    const std::vector<std::uint8_t> pinned = pinnedMask(scene.cloth);
    out << "index,x,y,position_x,position_y,position_z,last_position_x,last_position_y,last_position_z,"
           "velocity_x,velocity_y,velocity_z,pinned\n";
    for (int i = 0; i < grid.pointCount(); ++i) {
        const GridPoint p = grid.place(i);
        out << i << ',' << p.x << ',' << p.y << ',';
        writeVector(out, frame.state.position.at(i), ',');
        out << ',';
        writeVector(out, frame.state.lastPosition.at(i), ',');
        out << ',';
        writeVector(out, velocity(frame.state, i, scene.simulation.timeStep()), ',');
        out << ',' << int(pinned[std::size_t(i)]) << '\n';
    }
}

std::optional<ExportFormat> exportFormat(const std::string& path) {
    const auto endsWith = [&](std::string_view ending) {
        return path.size() > ending.size() &&
               std::equal(ending.rbegin(), ending.rend(), path.rbegin(), [](char a, char b) {
                   return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
               });
    };
    if (endsWith(".obj"))
        return ExportFormat::Obj;
    if (endsWith(".csv"))
        return ExportFormat::Csv;
    return std::nullopt;
}

std::optional<std::string> exportFrame(const Frame& frame, ExportFormat format, const std::string& path) {
    return writeFileWhole(path, [&](std::ostream& out) {
        if (format == ExportFormat::Obj)
            writeObj(out, frame);
        else
            writeCsv(out, frame);
    });
}

} // namespace clothlab
