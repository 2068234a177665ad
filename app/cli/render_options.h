// What `clothlab render` is asked for.
#pragma once

#include "app/cli/output_path.h"
#include "app/export/ffmpeg.h"
#include "app/render/offscreen_picture.h"

#include <QStringList>

namespace clothlab::cli {

inline const QString kAllShaders = QStringLiteral("all");

struct RenderOptions {
    QString scene;
    QString output;
    OutputPath path; // of output
    std::optional<VideoFormat> video;
    int frame = 90;                     // of one picture
    int frames = 90;                    // the last one of a sequence or a video
    std::optional<int> framesPerSecond; // of these
    std::optional<int> threads;
    QString shader; // empty: the scene's
    QSize size{1280, 800};
    bool fit = false;
    render::PictureSource source;

    bool isOnePicture() const { return !video && !path.isSequence(); }
};

// What is wrong with the arguments; empty if nothing is.
QString parseRender(const QStringList& arguments, RenderOptions& options);

} // namespace clothlab::cli
