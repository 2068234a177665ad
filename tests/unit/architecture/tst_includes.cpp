// Which room of the source tree may know which, read from the include lines.
#include <QtTest>

#include <QLibraryInfo>

namespace {

struct Room {
    QString path;
    QStringList rooms;     // that it may include, besides itself; "*" after a slash: all below
    QStringList qtModules; // "*": any
    QStringList libraries; // folders of their headers
};

const QStringList kNoQt;

const QList<Room>& rooms() {
    static const QList<Room> table{
        {"simcore/base", {}, kNoQt, {"Eigen", "xxhash.h"}},
        {"simcore/scene", {"simcore/base"}, kNoQt, {"Eigen", "nlohmann"}},
        {"simcore/cloth", {"simcore/base", "simcore/scene"}, kNoQt, {"Eigen"}},
        {"simcore/kernels", {"simcore/base", "simcore/scene", "simcore/cloth"}, kNoQt, {}},
        {"simcore/collision",
         {"simcore/base", "simcore/scene", "simcore/cloth", "simcore/kernels"},
         kNoQt,
         {"Eigen"}},
        {"simcore/solver",
         {"simcore/base", "simcore/scene", "simcore/cloth", "simcore/kernels", "simcore/collision"},
         kNoQt,
         {"Eigen"}},
        {"simcore/recording", {"simcore/base", "simcore/scene", "simcore/cloth"}, kNoQt, {"Eigen", "zstd.h"}},
        {"simcore/inspect",
         {"simcore/base", "simcore/scene", "simcore/cloth", "simcore/kernels", "simcore/collision",
          "simcore/solver", "simcore/recording"},
         kNoQt,
         {"Eigen"}},
        // What a file says of a state is what the inspector says of it.
        {"simcore/export",
         {"simcore/base", "simcore/scene", "simcore/cloth", "simcore/recording", "simcore/inspect"},
         kNoQt,
         {"Eigen"}},
        {"app/widgets", {}, {"*"}, {}},
        {"app/document", {"simcore/*"}, {"QtCore", "QtGui"}, {}},
        {"app/simulation", {"simcore/*", "app/document"}, {"QtCore", "QtGui"}, {}},
        {"app/render", {}, {"QtCore", "QtGui", "QtOpenGL"}, {"stb"}},
        {"app/picture", {"simcore/*", "app/render", "app/widgets"}, {"QtCore", "QtGui"}, {"Eigen"}},
        {"app/export", {"simcore/*", "app/render", "app/picture"}, {"QtCore", "QtGui"}, {}},
        {"app/viewport",
         {"simcore/*", "app/document", "app/simulation", "app/render", "app/widgets", "app/picture"},
         {"*"},
         {"Eigen"}},
        {"app/docks",
         {"simcore/*", "app/document", "app/simulation", "app/render", "app/widgets", "app/picture"},
         {"*"},
         {}},
        {"app/window", {"simcore/*", "app/*"}, {"*"}, {}},
        {"app/cli",
         {"simcore/*", "app/document", "app/render", "app/picture", "app/export"},
         {"QtCore", "QtGui", "QtOpenGL"},
         {"nlohmann"}},
        {"app/main.cpp", {"app/*"}, {"*"}, {}},
    };
    return table;
}

const Room* roomOf(const QString& file) {
    for (const Room& room : rooms())
        if (file == room.path || file.startsWith(room.path + '/'))
            return &room;
    return nullptr;
}

// "QtWidgets" for "QWidget"; empty if it is not Qt's.
QString qtModule(const QString& header) {
    if (header.startsWith("Qt") && header.contains('/'))
        return header.section('/', 0, 0);
    const QDir all(QLibraryInfo::path(QLibraryInfo::HeadersPath));
    for (const QString& module : all.entryList({"Qt*"}, QDir::Dirs))
        if (QFileInfo(all.filePath(module + '/' + header)).isFile())
            return module;
    return {};
}

bool allows(const QStringList& list, const QString& name) {
    return list.contains("*") || list.contains(name) || list.contains(name.section('/', 0, 0) + "/*");
}

QString problemWithProjectHeader(const Room& room, const QString& header) {
    if (header.endsWith(".moc"))
        return {};
    const Room* other = roomOf(header);
    if (!other)
        return "is in no room; write the path from the top folder";
    return other == &room || allows(room.rooms, other->path) ? QString() : "is out of bounds";
}

QString problemWithSystemHeader(const Room& room, const QString& header) {
    if (roomOf(header))
        return "is ours; write it in quotes";
    if (const QString module = qtModule(header); !module.isEmpty())
        return allows(room.qtModules, module) ? QString() : module + " is out of bounds";
    static const QStringList guarded{"Eigen", "nlohmann", "stb", "xxhash.h", "zstd.h"};
    const QString library = header.section('/', 0, 0);
    return guarded.contains(library) && !room.libraries.contains(library) ? "is out of bounds" : QString();
}

// "app/render/a.cpp includes app/document/b.h, which is out of bounds", a line each.
QStringList problems(const QString& file, const QString& text) {
    const Room* room = roomOf(file);
    if (!room)
        return {file + " is in no room"};
    static const QRegularExpression line(R"(^\s*#\s*include\s*([<"])([^>"]+)[>"])",
                                         QRegularExpression::MultilineOption);
    QStringList found;
    for (const QRegularExpressionMatch& match : line.globalMatch(text)) {
        const QString header = match.captured(2);
        const QString problem = match.captured(1) == "\"" ? problemWithProjectHeader(*room, header)
                                                          : problemWithSystemHeader(*room, header);
        if (!problem.isEmpty())
            found << file + " includes " + header + ", which " + problem;
    }
    return found;
}

} // namespace

class TestIncludes : public QObject {
    Q_OBJECT

private slots:
    void everyIncludeIsAllowed();
    void badIncludesAreFound_data();
    void badIncludesAreFound();
    void goodIncludesPass_data();
    void goodIncludesPass();
    void roomsOfTheCoreHaveNoCircle();
};

void TestIncludes::everyIncludeIsAllowed() {
    const QDir top(CLOTHLAB_SOURCE_DIR);
    int files = 0;
    QStringList found;
    for (const char* tree : {"simcore", "app"}) {
        QDirIterator it(top.filePath(tree), {"*.h", "*.cpp"}, QDir::Files, QDirIterator::Subdirectories);
        while (it.hasNext()) {
            QFile file(it.next());
            QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.fileName()));
            found << problems(top.relativeFilePath(file.fileName()), QString::fromUtf8(file.readAll()));
            ++files;
        }
    }
    QVERIFY2(found.isEmpty(), qPrintable('\n' + found.join('\n')));
    QVERIFY(files > 20);
}

void TestIncludes::badIncludesAreFound_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("line");
    const auto row = [](const char* file, const char* line) {
        QTest::addRow("%s: %s", file, line) << QString(file) << QString(line);
    };
    row("simcore/scene/scene.h", "#include <QString>");
    row("simcore/solver/verlet_solver.cpp", "#include <QtCore/QString>");
    row("simcore/solver/verlet_solver.cpp", "#include \"app/document/document.h\"");
    row("simcore/base/whole_file.h", "#include \"simcore/scene/scene.h\"");
    row("simcore/cloth/grid.h", "#include \"simcore/solver/verlet_solver.h\"");
    row("simcore/cloth/grid.h", "#include <nlohmann/json.hpp>");
    row("simcore/cloth/cloth_state.cpp", "#include <xxhash.h>");
    row("simcore/base/checksum.cpp", "#include <zstd.h>");
    row("simcore/collision/colliders.h", "  #  include \"simcore/solver/verlet_solver.h\" // why not");
    row("simcore/recording/recording.h", "#include \"simcore/export/export.h\"");
    row("app/render/renderer.h", "#include \"app/document/document.h\"");
    row("app/render/renderer.h", "#include \"simcore/cloth/grid.h\"");
    row("app/render/renderer.h", "#include <QWidget>");
    row("app/widgets/slider.h", "#include \"simcore/scene/scene.h\"");
    row("app/widgets/slider.h", "#include \"app/document/document.h\"");
    row("app/document/document.h", "#include <QWidget>");
    row("app/document/document.h", "#include \"app/simulation/simulation.h\"");
    row("app/simulation/simulation.h", "#include \"app/viewport/viewport.h\"");
    row("app/docks/panel.h", "#include \"app/viewport/viewport.h\"");
    row("app/docks/panel.h", "#include \"app/window/main_window.h\"");
    row("app/picture/camera.h", "#include \"app/document/document.h\"");
    row("app/picture/camera.h", "#include \"app/viewport/viewport.h\"");
    row("app/picture/camera.h", "#include <QWidget>");
    row("app/cli/commands.h", "#include \"app/window/main_window.h\"");
    row("app/cli/commands.h", "#include \"app/docks/text.h\"");
    row("app/docks/panel.h", "#include \"other_panel.h\"");
    row("simcore/cloth/grid.h", "#include <simcore/scene/scene.h>");
    row("app/newroom/thing.h", "");
}

void TestIncludes::badIncludesAreFound() {
    QFETCH(QString, file);
    QFETCH(QString, line);
    const QString text = "#pragma once\n#include <vector>\n\n" + line + "\nint x;\n";
    QCOMPARE(problems(file, text).size(), 1);
}

void TestIncludes::goodIncludesPass_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("text");
    QTest::newRow("standard") << "simcore/base/whole_file.h"
                              << "#include <string>\n#include <string_view>\n";
    QTest::newRow("same room") << "app/docks/a.cpp"
                               << "#include \"app/docks/b.h\"\n";
    QTest::newRow("below") << "simcore/solver/a.cpp"
                           << "#include \"simcore/scene/scene.h\"\n#include <Eigen/Core>\n";
    QTest::newRow("Qt") << "app/document/a.h"
                        << "#include <QUndoStack>\n#include <QObject>\n";
    QTest::newRow("moc") << "app/docks/a.cpp"
                         << "#include \"a.moc\"\n";
    QTest::newRow("in a comment") << "simcore/base/a.h"
                                  << "// #include <QString>\n";
    QTest::newRow("window") << "app/window/a.h"
                            << "#include \"app/docks/b.h\"\n#include <QMainWindow>\n";
}

void TestIncludes::goodIncludesPass() {
    QFETCH(QString, file);
    QFETCH(QString, text);
    QCOMPARE(problems(file, text), QStringList());
}

// The table itself: a room lists only rooms above it in the table, so that none can come round to itself.
void TestIncludes::roomsOfTheCoreHaveNoCircle() {
    QStringList before;
    for (const Room& room : rooms()) {
        for (const QString& other : room.rooms)
            QVERIFY2(other.endsWith("/*") || before.contains(other),
                     qPrintable(room.path + " knows " + other));
        before << room.path;
    }
}

QTEST_APPLESS_MAIN(TestIncludes)
#include "tst_includes.moc"
