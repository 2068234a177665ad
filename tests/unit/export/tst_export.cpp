// OBJ, PLY and CSV read back by readers of their own, and files that cannot be written.
#include "simcore/export/export.h"
#include "simcore/inspect/inspect.h"
#include "tests/support/export_frames.h"

#include <QtTest>

#include <bit>
#include <cstdlib>
#include <locale>
#include <map>
#include <sstream>

using namespace clothlab;
using test::FileSizeLimit;
using test::sampleFrame;

namespace {

template <typename Write>
std::string textOf(Write write, const Frame& frame) {
    std::ostringstream out;
    write(out, frame, Placement{});
    return out.str();
}

std::vector<std::string> split(const std::string& text, char separator) {
    std::vector<std::string> parts;
    std::istringstream in(text);
    for (std::string part; std::getline(in, part, separator);)
        parts.push_back(part);
    return parts;
}

struct Obj {
    std::vector<Vec3> vertices, normals;
    std::vector<std::array<double, 2>> textureCoordinates;
    std::vector<std::array<int, 3>> faces; // from 0
    bool broken = false;
};

Obj readObj(const std::string& text) {
    Obj obj;
    for (const std::string& line : split(text, '\n')) {
        std::istringstream in(line);
        std::string key;
        in >> key;
        double x = 0;
        double y = 0;
        double z = 0;
        if (key == "v" || key == "vn") {
            in >> x >> y >> z;
            (key == "v" ? obj.vertices : obj.normals).emplace_back(x, y, z);
        } else if (key == "vt") {
            in >> x >> y;
            obj.textureCoordinates.push_back({x, y});
        } else if (key == "f") {
            std::array<int, 3> face{};
            for (int& corner : face) {
                std::string text3;
                in >> text3;
                const std::vector<std::string> indices = split(text3, '/');
                corner = std::atoi(indices.at(0).c_str()) - 1;
                obj.broken = obj.broken || indices != std::vector<std::string>(3, indices[0]);
            }
            obj.faces.push_back(face);
        } else if (key != "o" && key != "g" && key != "s" && !key.starts_with('#')) {
            obj.broken = obj.broken || !line.empty();
        }
        obj.broken = obj.broken || in.fail();
    }
    return obj;
}

bool sameBits(double a, double b) {
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool sameBits(const Vec3& a, const Vec3& b) {
    return sameBits(a.x(), b.x()) && sameBits(a.y(), b.y()) && sameBits(a.z(), b.z());
}

Vec3 vectorAt(const std::vector<std::string>& cells, std::size_t column) {
    return {std::strtod(cells.at(column).c_str(), nullptr),
            std::strtod(cells.at(column + 1).c_str(), nullptr),
            std::strtod(cells.at(column + 2).c_str(), nullptr)};
}

// What a program that knows PLY, but not ours, would read.
struct Ply {
    std::vector<std::string> header; // without "end_header"
    std::vector<std::array<float, 8>> vertices;
    std::vector<std::array<int, 3>> faces; // from 0
    bool broken = false;
};

Ply readPly(const std::string& text) {
    const std::string ending = "end_header\n";
    const std::size_t end = text.find(ending);
    Ply ply;
    ply.header = split(text.substr(0, end), '\n');
    std::map<std::string, int> counts;
    for (const std::string& line : ply.header)
        if (const auto words = split(line, ' '); words.at(0) == "element")
            counts[words.at(1)] = std::atoi(words.at(2).c_str());
    test::ByteReader bytes(text, end + ending.size());
    for (int i = 0; i < counts["vertex"]; ++i)
        for (float& number : ply.vertices.emplace_back())
            number = bytes.littleFloat();
    for (int i = 0; i < counts["face"]; ++i) {
        ply.broken = ply.broken || bytes.text(1) != "\3";
        for (int& corner : ply.faces.emplace_back())
            corner = int(bytes.little());
    }
    ply.broken = ply.broken || !bytes.atEnd();
    return ply;
}

// (x, y, z) with z up, in centimetres.
Vec3 zUpInCentimetres(const Vec3& v) {
    return {100 * v.x(), 100 * -v.z(), 100 * v.y()};
}
const Placement kZUpInCentimetres{UpAxis::Z, 100};

QByteArray contents(const QString& path) {
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("(cannot be read)");
}

} // namespace

class TestExport : public QObject {
    Q_OBJECT

private slots:
    void objVerticesInIndexOrder();
    void objFacesCoverTheSheetOnce();
    void objFacesAndNormalsPointUp();
    void objTextureCoordinates();
    void objOfACollapsedSheet();
    void csvReadsBackToTheSameBits();
    void csvColumns();
    void axisAndScale();
    void numbersIgnoreTheLocale();
    void plyReadsBack();
    void plyWithAxisAndScale();
    void formatsByTheirEnding();
    void writesWhatTheStreamGets();
    void replacesAnExistingFile();
    void unwritableFolder();
    void existingFileSurvivesAFailure();
    void diskThatFillsUp();
};

void TestExport::objVerticesInIndexOrder() {
    const Frame frame = sampleFrame();
    const Obj obj = readObj(textOf(writeObj, frame));
    QVERIFY(!obj.broken);
    QCOMPARE(int(obj.vertices.size()), 20);
    QCOMPARE(int(obj.normals.size()), 20);
    for (int i = 0; i < 20; ++i) {
        QVERIFY(sameBits(obj.vertices[std::size_t(i)], frame.state.position.at(i)));
        QVERIFY(std::abs(obj.normals[std::size_t(i)].norm() - 1) < 1e-12);
    }
}

void TestExport::objFacesCoverTheSheetOnce() {
    Frame frame = sampleFrame();
    frame.state = startState(*frame.scene);
    const Obj obj = readObj(textOf(writeObj, frame));
    QCOMPARE(int(obj.faces.size()), 2 * 4 * 3);
    double area = 0;
    for (const std::array<int, 3>& face : obj.faces) {
        for (const int corner : face)
            QVERIFY(corner >= 0 && corner < 20);
        const Vec3& a = obj.vertices[std::size_t(face[0])];
        area +=
            (obj.vertices[std::size_t(face[1])] - a).cross(obj.vertices[std::size_t(face[2])] - a).norm() / 2;
    }
    QVERIFY(std::abs(area - 1) < 1e-12); // with no more faces than two a cell, so none twice
}

void TestExport::objFacesAndNormalsPointUp() {
    Frame frame = sampleFrame();
    frame.state = startState(*frame.scene);
    const Obj obj = readObj(textOf(writeObj, frame));
    for (const Vec3& normal : obj.normals)
        QVERIFY((normal - Vec3(0, 1, 0)).norm() < 1e-12);
    for (const std::array<int, 3>& face : obj.faces) {
        const Vec3& a = obj.vertices[std::size_t(face[0])];
        const Vec3 up =
            (obj.vertices[std::size_t(face[1])] - a).cross(obj.vertices[std::size_t(face[2])] - a);
        QVERIFY(up.y() > 0);
    }
}

void TestExport::objTextureCoordinates() {
    const Obj obj = readObj(textOf(writeObj, sampleFrame()));
    QCOMPARE(int(obj.textureCoordinates.size()), 20);
    for (int i = 0; i < 20; ++i) {
        QVERIFY(std::abs(obj.textureCoordinates[std::size_t(i)][0] - i % 5 / 4.0) < 1e-15);
        QVERIFY(std::abs(obj.textureCoordinates[std::size_t(i)][1] - i / 5 / 3.0) < 1e-15);
    }
}

void TestExport::objOfACollapsedSheet() {
    Frame frame = sampleFrame(2, 2);
    frame.state = {PointArray(4), PointArray(4)};
    const Obj obj = readObj(textOf(writeObj, frame));
    QVERIFY(!obj.broken);
    for (const Vec3& normal : obj.normals)
        QCOMPARE(normal, Vec3(0, 1, 0));
}

void TestExport::csvReadsBackToTheSameBits() {
    const Frame frame = sampleFrame();
    const std::vector<std::string> lines = split(textOf(writeCsv, frame), '\n');
    QCOMPARE(int(lines.size()), 21);
    for (int i = 0; i < 20; ++i) {
        const std::vector<std::string> cells = split(lines[std::size_t(i + 1)], ',');
        QCOMPARE(int(cells.size()), 13);
        QCOMPARE(cells[0], std::to_string(i));
        QCOMPARE(cells[1], std::to_string(i % 5));
        QCOMPARE(cells[2], std::to_string(i / 5));
        QVERIFY(sameBits(vectorAt(cells, 3), frame.state.position.at(i)));
        QVERIFY(sameBits(vectorAt(cells, 6), frame.state.lastPosition.at(i)));
        QVERIFY(sameBits(vectorAt(cells, 9), velocity(frame.state, i, frame.scene->simulation.timeStep())));
        QCOMPARE(cells[12], std::string(i == 1 || i == 5 ? "1" : "0"));
    }
}

void TestExport::csvColumns() {
    const std::string text = textOf(writeCsv, sampleFrame());
    QCOMPARE(text.substr(0, text.find('\n')),
             std::string("index,x,y,position_x,position_y,position_z,last_position_x,last_position_y,"
                         "last_position_z,velocity_x,velocity_y,velocity_z,pinned"));
}

void TestExport::axisAndScale() {
    const Frame frame = sampleFrame();
    std::ostringstream objText;
    std::ostringstream csvText;
    writeObj(objText, frame, kZUpInCentimetres);
    writeCsv(csvText, frame, kZUpInCentimetres);
    QVERIFY(objText.str().starts_with("# ClothLab, 100 units per metre, z up, time 0.1 s\n"));
    QVERIFY(textOf(writeObj, frame).starts_with("# ClothLab, metres, y up, time 0.1 s\n"));
    const Obj obj = readObj(objText.str());
    const Obj plain = readObj(textOf(writeObj, frame));
    const std::vector<std::string> lines = split(csvText.str(), '\n');
    for (int i = 0; i < 20; ++i) {
        const std::vector<std::string> cells = split(lines[std::size_t(i + 1)], ',');
        const Vec3& normal = plain.normals[std::size_t(i)];
        QCOMPARE(obj.vertices[std::size_t(i)], zUpInCentimetres(frame.state.position.at(i)));
        QCOMPARE(obj.normals[std::size_t(i)], Vec3(normal.x(), -normal.z(), normal.y())); // of length 1
        QCOMPARE(vectorAt(cells, 3), zUpInCentimetres(frame.state.position.at(i)));
        QCOMPARE(vectorAt(cells, 6), zUpInCentimetres(frame.state.lastPosition.at(i)));
        QCOMPARE(vectorAt(cells, 9),
                 zUpInCentimetres(velocity(frame.state, i, frame.scene->simulation.timeStep())));
    }
    QVERIFY(obj.faces == plain.faces);
}

void TestExport::plyReadsBack() {
    const Frame frame = sampleFrame();
    const Obj obj = readObj(textOf(writeObj, frame));
    const Ply ply = readPly(textOf(writePly, frame));
    QVERIFY(!ply.broken);
    const std::vector<std::string> header{"ply",
                                          "format binary_little_endian 1.0",
                                          "comment ClothLab, metres, y up, time 0.1 s",
                                          "element vertex 20",
                                          "property float x",
                                          "property float y",
                                          "property float z",
                                          "property float nx",
                                          "property float ny",
                                          "property float nz",
                                          "property float s",
                                          "property float t",
                                          "element face 24",
                                          "property list uchar int vertex_indices"};
    QVERIFY(ply.header == header);
    for (std::size_t i = 0; i < 20; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto a = Eigen::Index(axis);
            QVERIFY(test::sameFloat(ply.vertices[i][axis], float(frame.state.position.at(int(i))[a])));
            QVERIFY(test::sameFloat(ply.vertices[i][axis + 3], float(obj.normals[i][a])));
            if (axis < 2)
                QVERIFY(test::sameFloat(ply.vertices[i][axis + 6], float(obj.textureCoordinates[i][axis])));
        }
    QVERIFY(ply.faces == obj.faces);
}

void TestExport::plyWithAxisAndScale() {
    const Frame frame = sampleFrame();
    std::ostringstream text;
    writePly(text, frame, kZUpInCentimetres);
    const Ply ply = readPly(text.str());
    const Ply plain = readPly(textOf(writePly, frame));
    QVERIFY(!ply.broken && ply.vertices.size() == 20);
    QCOMPARE(ply.header.at(2), std::string("comment ClothLab, 100 units per metre, z up, time 0.1 s"));
    for (std::size_t i = 0; i < 20; ++i) {
        const Vec3 place = zUpInCentimetres(frame.state.position.at(int(i)));
        for (std::size_t axis = 0; axis < 3; ++axis)
            QVERIFY(test::sameFloat(ply.vertices[i][axis], float(place[Eigen::Index(axis)])));
        QVERIFY(test::sameFloat(ply.vertices[i][3], plain.vertices[i][3]));
        QVERIFY(test::sameFloat(ply.vertices[i][4], -plain.vertices[i][5]));
        QVERIFY(test::sameFloat(ply.vertices[i][5], plain.vertices[i][4]));
    }
}

void TestExport::numbersIgnoreTheLocale() {
    const std::string obj = textOf(writeObj, sampleFrame());
    struct German : std::numpunct<char> {
        char do_decimal_point() const override { return ','; }
        char do_thousands_sep() const override { return '.'; }
        std::string do_grouping() const override { return "\3"; }
    };
    const std::locale before = std::locale::global(std::locale(std::locale::classic(), new German));
    const std::string obj2 = textOf(writeObj, sampleFrame());
    Frame large = sampleFrame(60, 40); // indices above a thousand
    const std::string csv = textOf(writeCsv, large);
    const Ply ply = readPly(textOf(writePly, large));
    const std::string text = textOf(writeObj, large);
    std::locale::global(before);
    QCOMPARE(obj2, obj);
    QVERIFY(csv == textOf(writeCsv, large));
    QVERIFY(!ply.broken && ply.vertices.size() == 2400);
    QVERIFY(!readObj(text).broken);
    QCOMPARE(int(readObj(text).vertices.size()), 2400);
    for (const std::array<int, 3>& face : readObj(text).faces)
        QVERIFY(face[0] >= 0 && face[0] < 2400);
}

void TestExport::formatsByTheirEnding() {
    QVERIFY(exportFormat("a.obj") == ExportFormat::Obj);
    QVERIFY(exportFormat("/x.csv/Frame.OBJ") == ExportFormat::Obj);
    QVERIFY(exportFormat("b.c.CsV") == ExportFormat::Csv);
    QVERIFY(exportFormat("a.ply") == ExportFormat::Ply);
    QVERIFY(exportFormat("a.pc2") == ExportFormat::Pc2);
    QVERIFY(exportFormat("a.MDD") == ExportFormat::Mdd);
    QVERIFY(exportFormat("a.glb") == ExportFormat::Glb);
    for (const ExportFormat format : {ExportFormat::Obj, ExportFormat::Csv, ExportFormat::Ply})
        QVERIFY(!holdsAllFrames(format));
    for (const ExportFormat format : {ExportFormat::Pc2, ExportFormat::Mdd, ExportFormat::Glb})
        QVERIFY(holdsAllFrames(format));
    for (const char* path : {"", "obj", "a.ob", "a.objx", "a.obj/", "a"})
        QVERIFY2(!exportFormat(path), path);
}

void TestExport::writesWhatTheStreamGets() {
    const QTemporaryDir folder;
    const Frame frame = sampleFrame();
    const QString obj = folder.filePath("frame.obj");
    const QString csv = folder.filePath("frame.csv");
    QVERIFY(!exportFrame(frame, ExportFormat::Obj, obj.toStdString()));
    QVERIFY(!exportFrame(frame, ExportFormat::Csv, csv.toStdString()));
    QCOMPARE(contents(obj).toStdString(), textOf(writeObj, frame));
    QCOMPARE(contents(csv).toStdString(), textOf(writeCsv, frame));
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden).size(), 2);
}

void TestExport::replacesAnExistingFile() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("frame.csv");
    QVERIFY(!exportFrame(sampleFrame(30, 20), ExportFormat::Csv, path.toStdString()));
    QVERIFY(!exportFrame(sampleFrame(2, 2), ExportFormat::Csv, path.toStdString()));
    QCOMPARE(contents(path).toStdString(), textOf(writeCsv, sampleFrame(2, 2)));
}

void TestExport::unwritableFolder() {
    const QTemporaryDir folder;
    const QString path = folder.filePath("missing/frame.obj");
    const std::optional<std::string> problem =
        exportFrame(sampleFrame(), ExportFormat::Obj, path.toStdString());
    QVERIFY(problem.has_value());
    QVERIFY2(problem->size() > 10, problem->c_str());
    QVERIFY(QDir(folder.path()).isEmpty(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden));

    // Nor under a file taken for a folder, where even root cannot write.
    const QString file = folder.filePath("file");
    QVERIFY(!exportFrame(sampleFrame(), ExportFormat::Csv, file.toStdString()));
    QVERIFY(exportFrame(sampleFrame(), ExportFormat::Csv, (file + "/frame.csv").toStdString()).has_value());
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden), QStringList{"file"});
}

void TestExport::existingFileSurvivesAFailure() {
    // A folder stands where the file should go: the new file can be written beside it but not put there.
    const QTemporaryDir folder;
    QVERIFY(QDir(folder.path()).mkdir("frame.csv"));
    const std::string path = folder.filePath("frame.csv").toStdString();
    QVERIFY(exportFrame(sampleFrame(), ExportFormat::Csv, path).has_value());
    const auto everything = QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden;
    QCOMPARE(QDir(folder.path()).entryList(everything), QStringList{"frame.csv"});

    // A folder that may not be written holds a file that may.
    const QString file = folder.filePath("kept.csv");
    QVERIFY(!exportFrame(sampleFrame(2, 2), ExportFormat::Csv, file.toStdString()));
    const QByteArray before = contents(file);
    QFile(folder.path()).setPermissions(QFile::ReadOwner | QFile::ExeOwner);
    const auto problem = exportFrame(sampleFrame(9, 9), ExportFormat::Csv, file.toStdString());
    const QByteArray after = contents(file);
    QFile(folder.path()).setPermissions(QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner);
    if (problem) // root may write there all the same
        QCOMPARE(after, before);
    QCOMPARE(QDir(folder.path()).entryList(everything).size(), 2);
}

void TestExport::diskThatFillsUp() {
    const QTemporaryDir folder;
    const QString kept = folder.filePath("kept.obj");
    QVERIFY(!exportFrame(sampleFrame(2, 2), ExportFormat::Obj, kept.toStdString()));
    const QByteArray before = contents(kept);
    const Frame large = sampleFrame(60, 60);
    std::optional<std::string> overOld;
    std::optional<std::string> fresh;
    {
        const FileSizeLimit limit(5000);
        overOld = exportFrame(large, ExportFormat::Obj, kept.toStdString());
        fresh = exportFrame(large, ExportFormat::Csv, folder.filePath("new.csv").toStdString());
    }
    QVERIFY(overOld && !overOld->empty());
    QVERIFY(fresh && !fresh->empty());
    QCOMPARE(contents(kept), before);
    QCOMPARE(QDir(folder.path()).entryList(QDir::Files | QDir::Hidden), QStringList{"kept.obj"});
}

QTEST_APPLESS_MAIN(TestExport)
#include "tst_export.moc"
