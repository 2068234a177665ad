// Frames for other programs. SI units and y up, as in the scene, unless a Placement says otherwise.
// docs/export.md says what is in the files.
#pragma once

#include "simcore/export/placement.h"
#include "simcore/recording/frame.h"

#include <optional>
#include <ostream>
#include <string>

namespace clothlab {

// One mesh: vertices in index order, texture coordinates, normals, two triangles a grid cell.
void writeObj(std::ostream& out, const Frame& frame, const Placement& placement = {});

// The same in binary, numbers as floats.
void writePly(std::ostream& out, const Frame& frame, const Placement& placement = {});

// A row a point: index,x,y,position_x,…,last_position_x,…,velocity_x,…,pinned. Numbers read back as the same
// bits.
void writeCsv(std::ostream& out, const Frame& frame, const Placement& placement = {});

// Obj, Csv and Ply hold one frame a file; Pc2, Mdd and Glb all of them.
enum class ExportFormat { Obj, Csv, Ply, Pc2, Mdd, Glb };
std::optional<ExportFormat> exportFormat(const std::string& path); // by its ending, in either case
bool holdsAllFrames(ExportFormat format);

// Whole or not at all. Returns what went wrong, in words.
// Precondition: !holdsAllFrames(format).
std::optional<std::string> exportFrame(const Frame& frame, ExportFormat format, const std::string& path,
                                       const Placement& placement = {});

} // namespace clothlab
