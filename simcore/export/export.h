// Frames for other programs. SI units, y up, as in the scene.
#pragma once

#include "simcore/recording/recording.h"

#include <optional>
#include <ostream>
#include <string>

namespace clothlab {

// One mesh: vertices in index order, texture coordinates, normals, two triangles a grid cell.
void writeObj(std::ostream& out, const Frame& frame);

// A row a point: index,x,y,position_x,…,last_position_x,…,velocity_x,…,pinned. Numbers read back as the same
// bits.
void writeCsv(std::ostream& out, const Frame& frame);

enum class ExportFormat { Obj, Csv };
std::optional<ExportFormat> exportFormat(const std::string& path); // by its ending, in either case

// Whole or not at all. Returns what went wrong, in words.
std::optional<std::string> exportFrame(const Frame& frame, ExportFormat format, const std::string& path);

} // namespace clothlab
