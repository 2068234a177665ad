// Where `clothlab simulate` writes frames to, and how.
#pragma once

#include "simcore/export/frame_writer.h"

#include <QCommandLineParser>

#include <memory>
#include <vector>

namespace clothlab::cli {

using FrameWriters = std::vector<std::unique_ptr<FrameWriter>>;

void addOutputOptions(QCommandLineParser& parser);

// Makes the writers that the options of a parsed command line ask for. Returns what is wrong with them, in
// words; empty if nothing is.
QString readOutputs(const QCommandLineParser& parser, FrameWriters& writers);

} // namespace clothlab::cli
