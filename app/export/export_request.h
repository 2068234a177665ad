// What is to be exported, and into which files.
#pragma once

#include "app/export/ffmpeg.h"
#include "app/export/frame_painter.h"
#include "simcore/export/run_export.h"

#include <QStringList>

#include <atomic>

namespace clothlab {

enum class ExportKind { ObjFiles, PlyFiles, CsvFiles, Measures, Pc2, Mdd, Glb, PngFiles, Mp4, WebM };
inline constexpr int kExportKinds = 10;

QString title(ExportKind kind);     // "OBJ, a file a frame"
QString ending(ExportKind kind);    // ".obj"
QString about(ExportKind kind);     // what is in it and what it is for, in a sentence
bool isSequence(ExportKind kind);   // a file a frame
bool isVideo(ExportKind kind);      // what ffmpeg makes
bool hasPictures(ExportKind kind);  // which need OpenGL
bool hasPlacement(ExportKind kind); // axes and units can be chosen
QString whyNot(ExportKind kind);    // it cannot be had here, in words; empty if it can

struct ExportRequest {
    ExportKind kind = ExportKind::ObjFiles;
    QString path; // with ending(); of a sequence: without the numbers
    ExportRange frames;
    Placement placement;         // if hasPlacement()
    QSize size{1280, 720};       // pixels, if hasPictures()
    double framesPerSecond = 30; // if isVideo()
};

// The n-th file of a sequence of so many, from 0: "a/run_0003.obj" for "a/run.obj".
QString sequencePath(const QString& path, int number, int count);

// All files that it writes.
QStringList filesOf(const ExportRequest& request);

// Of all files together, about; 0 where nobody knows before.
double estimatedBytes(const ExportRequest& request, const Grid& grid);

// What of a recording with so many frames a second goes into a video: each n-th frame, so that there are no
// more than about 30 a second where there are more than 60.
int videoStep(int framesPerSecond);

// The painter is taken if hasPictures(). The files are there as a whole once the writer has finished, or not
// at all. stop: as for makeVideoWriter().
std::unique_ptr<FrameWriter> makeWriter(const ExportRequest& request, std::unique_ptr<FramePainter> painter,
                                        const std::atomic<bool>& stop);

} // namespace clothlab
