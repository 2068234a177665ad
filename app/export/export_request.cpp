#include "app/export/export_request.h"

#include "app/export/picture_writers.h"
#include "app/export/staged_sequence.h"
#include "simcore/export/sheet_mesh.h"

#include <QCoreApplication>

#include <array>
#include <cmath>

namespace clothlab {
namespace {

struct KindRow {
    const char* title;
    const char* ending;
    const char* about;
    bool sequence, video, pictures, placement;
};

// In the order of ExportKind.
constexpr std::array<KindRow, kExportKinds> kKinds{{
    {"OBJ, a file a frame", ".obj", "Mesh with texture coordinates and normals, as text", true, false, false,
     true},
    {"PLY, a file a frame", ".ply", "The same mesh, binary", true, false, false, true},
    {"CSV, a file a frame", ".csv", "A row a point: positions, velocities, pins", true, false, false, true},
    {"CSV of measures over time", ".csv", "A row a frame: energies, greatest strains, corrections", false,
     false, false, false},
    {"PC2 point cache, with its OBJ", ".pc2", "All frames for Blender and 3ds Max; the mesh is beside it",
     false, false, false, true},
    {"MDD point cache, with its OBJ", ".mdd", "All frames for Blender and LightWave; the mesh is beside it",
     false, false, false, true},
    {"glTF 2.0 binary, animated", ".glb", "Mesh and animation in one file, always in metres with y up", false,
     false, false, false},
    {"PNG pictures, one a frame", ".png", "The view's camera and the look of the scene as they are now", true,
     false, true, false},
    {"MP4 video", ".mp4", "The view's camera and the look of the scene as they are now", false, true, true,
     false},
    {"WebM video", ".webm", "The view's camera and the look of the scene as they are now", false, true, true,
     false},
}};

const KindRow& rowOf(ExportKind kind) {
    return kKinds[std::size_t(kind)];
}

ExportFormat formatOf(ExportKind kind) {
    return *exportFormat("a" + ending(kind).toStdString());
}

QString withoutEnding(const QString& path, ExportKind kind) {
    return path.endsWith(ending(kind), Qt::CaseInsensitive) ? path.chopped(ending(kind).size()) : path;
}

} // namespace

QString title(ExportKind kind) {
    return QCoreApplication::translate("Export", rowOf(kind).title);
}

QString ending(ExportKind kind) {
    return QString::fromLatin1(rowOf(kind).ending);
}

QString about(ExportKind kind) {
    return QCoreApplication::translate("Export", rowOf(kind).about);
}

bool isSequence(ExportKind kind) {
    return rowOf(kind).sequence;
}

bool isVideo(ExportKind kind) {
    return rowOf(kind).video;
}

bool hasPictures(ExportKind kind) {
    return rowOf(kind).pictures;
}

bool hasPlacement(ExportKind kind) {
    return rowOf(kind).placement;
}

QString whyNot(ExportKind kind) {
    return isVideo(kind) && findFfmpeg().isEmpty() ? howToGetFfmpeg() : QString();
}

QString sequencePath(const QString& path, int number, int count) {
    const auto dot = path.lastIndexOf('.');
    const auto digits = std::max<qsizetype>(4, QString::number(std::max(count - 1, 0)).size());
    return path.left(dot) + '_' + QString::number(number).rightJustified(digits, '0') + path.mid(dot);
}

QStringList filesOf(const ExportRequest& request) {
    if (!isSequence(request.kind)) {
        QStringList files{request.path};
        if (request.kind == ExportKind::Pc2 || request.kind == ExportKind::Mdd)
            files << withoutEnding(request.path, request.kind) + ".obj";
        return files;
    }
    QStringList files;
    const int count = request.frames.count();
    for (int i = 0; i < count; ++i)
        files << sequencePath(request.path, i, count);
    return files;
}

double estimatedBytes(const ExportRequest& request, const Grid& grid) {
    const double points = grid.pointCount();
    const double triangles = triangleCount(grid);
    const double frames = request.frames.count();
    const double obj = 155 * points + 42 * triangles; // as measured
    switch (request.kind) {
    case ExportKind::ObjFiles:
        return frames * obj;
    case ExportKind::PlyFiles:
        return frames * (300 + 32 * points + 13 * triangles);
    case ExportKind::CsvFiles:
        return frames * 190 * points;
    case ExportKind::Measures:
        return frames * 120;
    case ExportKind::Pc2:
    case ExportKind::Mdd:
        return frames * 12 * points + obj;
    case ExportKind::Glb:
        return frames * (12 * points + 4 * frames) + 20 * points + 12 * triangles;
    case ExportKind::PngFiles:
    case ExportKind::Mp4:
    case ExportKind::WebM:
        break;
    }
    return 0;
}

int videoStep(int framesPerSecond) {
    constexpr int most = 60;
    return framesPerSecond > most ? int(std::lround(framesPerSecond / 30.0)) : 1;
}

std::unique_ptr<FrameWriter> makeWriter(const ExportRequest& request, std::unique_ptr<FramePainter> painter,
                                        const std::atomic<bool>& stop) {
    const std::string path = request.path.toStdString();
    const auto pathOf = [base = request.path, count = request.frames.count()](int frame) {
        return sequencePath(base, frame, count).toStdString();
    };
    switch (request.kind) {
    case ExportKind::Measures:
        return makeMeasuresWriter(path);
    case ExportKind::Mp4:
    case ExportKind::WebM:
        return makeVideoWriter(path, request.kind == ExportKind::Mp4 ? VideoFormat::Mp4 : VideoFormat::WebM,
                               request.framesPerSecond, std::move(painter), stop);
    case ExportKind::PngFiles:
        return makeStagedSequence(pathOf, [&painter](std::function<std::string(int)> staged) {
            return makePngWriter(std::move(staged), std::move(painter));
        });
    case ExportKind::ObjFiles:
    case ExportKind::PlyFiles:
    case ExportKind::CsvFiles:
        return makeStagedSequence(pathOf, [&request](std::function<std::string(int)> staged) {
            return makeSequenceWriter(formatOf(request.kind), std::move(staged), request.placement);
        });
    case ExportKind::Pc2:
    case ExportKind::Mdd:
    case ExportKind::Glb:
        break;
    }
    return makeFrameWriter(formatOf(request.kind), path,
                           {hasPlacement(request.kind) ? request.placement : Placement{}, true});
}

} // namespace clothlab
