#include "app/cli/commands.h"

#include "app/cli/exit_status.h"
#include "app/cli/render_command.h"
#include "app/cli/simulate_command.h"
#include "app/cli/take_commands.h"
#include "simcore/inspect/stability.h"
#include "simcore/scene/scene_io.h"

#include <cstdio>

namespace clothlab::cli {
namespace {

int checkCommand(const QStringList& arguments) {
    if (arguments.size() != 1 || arguments[0].startsWith('-')) {
        std::fputs("clothlab: check takes one scene: clothlab check SCENE\n", stderr);
        return WrongUsage;
    }
    const std::string path = arguments[0].toStdString();
    SceneReading reading = loadScene(path);
    if (reading.scene)
        warnOfStep(*reading.scene, reading.diagnostics);
    for (const Diagnostic& diagnostic : reading.diagnostics)
        std::fprintf(diagnostic.severity == Severity::Error ? stderr : stdout, "%s\n",
                     toText(diagnostic, path).c_str());
    if (!reading.scene)
        return InvalidInput;
    if (!reading.diagnostics.empty())
        return CheckFoundWarnings;
    std::printf("%s: no problems\n", path.c_str());
    return Done;
}

} // namespace

QString helpText() {
    return QStringLiteral(
               R"(ClothLab %1, an editor and inspector for mass-spring cloth

  clothlab [SCENE]                      open the window
  clothlab [SCENE] --screenshot PNG     open the window, play, save a picture of it, quit
      --frames N                        frames to play first (default 90)
      --theme dark|light                theme of the window (also without --screenshot)
      --size WxH                        size of the window (default 1440x900)
      --shader-dir DIR                  folder of shaders (also without --screenshot)
  clothlab simulate SCENE               simulate without a window
      --frames N                        frames to simulate (default 90)
      --fps F                           frames per second instead of the scene's
      --steps S                         steps per frame instead of the scene's
      --threads T                       threads at most (automatic); the result is the same
      --output FILE                     write the last frame as .obj, .ply or .csv; with %04d in its
                                        name, every frame from 0, the start, a file each; or all
                                        frames in one .pc2, .mdd or .glb, or as a recording in a
                                        .clothtake; may be given several times
      --error METRES                    greatest error of positions in a .clothtake (default 0.00001);
                                        0 keeps their bits
      --axis y|z                        axis that is up in these files (default y)
      --scale S                         their units per metre (default 1)
      --measures FILE                   write energies and strains of every frame as .csv
      --report FILE|-                   write measures of the run as JSON
  clothlab render SCENE                 make pictures; needs an X server, like that of xvfb-run
      --output FILE                     the .png to write; with %04d in its name, every frame from 0, the
                                        start, a file each; or a video .mp4 or .webm, which needs ffmpeg
      --frame N                         frame to show in one picture (default 90)
      --frames N                        last frame of a sequence or a video (default 90)
      --fps F                           frames per second of these, in real time (default the scene's; of
                                        a video about 30, where the scene has more than 60)
      --shader NAME                     instead of the scene's; "all" for a sheet with every one
      --size WxH                        size of the picture (default 1280x800)
      --fit                             move the camera so that the cloth, in all frames, fills the picture
      --shader-dir DIR, --threads T     as above
  clothlab check SCENE                  say what is wrong or doubtful about a scene
  clothlab info RECORDING               say what is in a .clothtake: takes, changes, sizes
  clothlab verify RECORDING             run a .clothtake again and compare every frame
      --threads T                       as above
  clothlab --help | --version

Exit status: 0 done; 1 check, info or verify found warnings; 2 wrong usage; 3 the input is invalid or
unreadable; 4 the simulation blew up; 5 a recording is not what its run gives; 6 an output could not be
written; 130 interrupted
)")
        .arg(QStringLiteral(CLOTHLAB_VERSION));
}

bool isCommand(const QStringList& arguments) {
    static const QStringList words{"simulate", "render", "check", "info",
                                   "verify",   "--help", "-h",    "--version"};
    return !arguments.isEmpty() && words.contains(arguments[0]);
}

bool drawsPictures(const QStringList& arguments) {
    return arguments.value(0) == "render";
}

int runCommand(const QStringList& arguments) {
    const QString command = arguments.value(0);
    if (command == "simulate")
        return simulateCommand(arguments.mid(1));
    if (command == "render")
        return renderCommand(arguments.mid(1));
    if (command == "check")
        return checkCommand(arguments.mid(1));
    if (command == "info")
        return infoCommand(arguments.mid(1));
    if (command == "verify")
        return verifyCommand(arguments.mid(1));
    if (command == "--version")
        std::printf("clothlab %s\n", CLOTHLAB_VERSION);
    else
        std::fputs(qPrintable(helpText()), stdout);
    return Done;
}

} // namespace clothlab::cli
