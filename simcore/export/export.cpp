#include "simcore/export/export.h"

#include "simcore/base/whole_file.h"
#include "simcore/export/number.h"

#include <algorithm>
#include <cctype>
#include <sstream>
#include <utility>

namespace clothlab {

std::string describe(const Placement& placement) {
    std::ostringstream text;
    if (placement.unitsPerMetre == 1)
        text << "metres";
    else
        text << Number{placement.unitsPerMetre} << " units per metre";
    text << (placement.up == UpAxis::Y ? ", y up" : ", z up");
    return text.str();
}

std::optional<ExportFormat> exportFormat(const std::string& path) {
    const auto endsWith = [&](std::string_view ending) {
        return path.size() > ending.size() &&
               std::equal(ending.rbegin(), ending.rend(), path.rbegin(), [](char a, char b) {
                   return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
               });
    };
    constexpr std::array<std::pair<std::string_view, ExportFormat>, 6> formats{{{".obj", ExportFormat::Obj},
                                                                                {".csv", ExportFormat::Csv},
                                                                                {".ply", ExportFormat::Ply},
                                                                                {".pc2", ExportFormat::Pc2},
                                                                                {".mdd", ExportFormat::Mdd},
                                                                                {".glb", ExportFormat::Glb}}};
    for (const auto& [ending, format] : formats)
        if (endsWith(ending))
            return format;
    return std::nullopt;
}

bool holdsAllFrames(ExportFormat format) {
    return format == ExportFormat::Pc2 || format == ExportFormat::Mdd || format == ExportFormat::Glb;
}

std::optional<std::string> exportFrame(const Frame& frame, ExportFormat format, const std::string& path,
                                       const Placement& placement) {
    return writeFileWhole(path, [&](std::ostream& out) {
        if (format == ExportFormat::Obj)
            writeObj(out, frame, placement);
        else if (format == ExportFormat::Ply)
            writePly(out, frame, placement);
        else
            writeCsv(out, frame, placement);
    });
}

} // namespace clothlab
