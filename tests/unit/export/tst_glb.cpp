// glTF binary read back by a reader that goes by the specification.
#include "simcore/export/export.h"
#include "simcore/export/frame_writer.h"
#include "simcore/export/glb_json.h"
#include "tests/support/export_frames.h"

#include <nlohmann/json.hpp>

#include <QtTest>

#include <cmath>

using namespace clothlab;
using nlohmann::json;
using test::ByteReader;

namespace {

struct Glb {
    json description;
    std::string binary;
    bool broken = false;
};

Glb readGlb(const std::string& bytes) {
    ByteReader reader(bytes);
    Glb glb;
    glb.broken = reader.text(4) != "glTF" || reader.little() != 2 || reader.little() != bytes.size();
    const std::uint32_t jsonSize = reader.little();
    glb.broken = glb.broken || reader.text(4) != "JSON" || jsonSize % 4 != 0 || jsonSize > bytes.size();
    if (glb.broken)
        return glb;
    glb.description = json::parse(reader.text(jsonSize), nullptr, false);
    const std::uint32_t binarySize = reader.little();
    glb.broken = reader.text(4) != std::string("BIN\0", 4) || glb.description.is_discarded() ||
                 binarySize % 4 != 0 || binarySize != bytes.size() - reader.at();
    glb.binary = bytes.substr(reader.at());
    return glb;
}

// The bytes of an accessor from its first number on; broken if it is not within its view, and that not within
// the buffer.
ByteReader accessor(Glb& glb, const json& number, int component, const char* type, std::size_t count) {
    const json& it = glb.description.at("accessors").at(number.get<std::size_t>());
    const json& view = glb.description.at("bufferViews").at(it.at("bufferView").get<std::size_t>());
    const std::size_t numbers = type == std::string("SCALAR") ? 1 : std::size_t(type[3] - '0');
    const std::size_t size = 4 * numbers * count;
    const std::size_t offset = it.value("byteOffset", std::size_t(0));
    const auto start = view.at("byteOffset").get<std::size_t>();
    const auto length = view.at("byteLength").get<std::size_t>();
    glb.broken = glb.broken || it.at("componentType") != component || it.at("type") != type ||
                 it.at("count") != count || offset + size > length || start + length > glb.binary.size() ||
                 (view.contains("byteStride") && view.at("byteStride") != 4 * numbers) ||
                 glb.description.at("buffers").at(0).at("byteLength") != glb.binary.size();
    return ByteReader(glb.binary.substr(start + offset, size));
}

constexpr int kFloat = 5126;
constexpr int kUnsigned = 5125;

// x y z of a target or of the first frame, with what the accessor says of their range checked.
std::vector<float> positions(Glb& glb, const json& number, std::size_t points) {
    ByteReader reader = accessor(glb, number, kFloat, "VEC3", points);
    std::vector<float> values(3 * points);
    std::array<float, 3> least{1e9F, 1e9F, 1e9F};
    std::array<float, 3> greatest{-1e9F, -1e9F, -1e9F};
    for (std::size_t i = 0; i < values.size(); ++i) {
        values[i] = reader.littleFloat();
        least[i % 3] = std::min(least[i % 3], values[i]);
        greatest[i % 3] = std::max(greatest[i % 3], values[i]);
    }
    const json& it = glb.description.at("accessors").at(number.get<std::size_t>());
    glb.broken = glb.broken ||
                 it.at("min").get<std::vector<float>>() != std::vector(least.begin(), least.end()) ||
                 it.at("max").get<std::vector<float>>() != std::vector(greatest.begin(), greatest.end());
    return values;
}

} // namespace

class TestGlb : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = m_folder->filePath("a.glb").toStdString();
    }

    void everyFrameReadsBack_data() {
        QTest::addColumn<int>("count");
        QTest::addColumn<int>("expected");
        QTest::addColumn<bool>("turned");
        QTest::newRow("as announced") << 6 << 6 << false;
        QTest::newRow("fewer, z up, in centimetres") << 4 << 1000 << true;
        QTest::newRow("two") << 2 << 2 << false;
    }
    void everyFrameReadsBack() {
        QFETCH(int, count);
        QFETCH(int, expected);
        QFETCH(bool, turned);
        const Placement placement = turned ? Placement{UpAxis::Z, 100} : Placement{};
        const auto frames = test::sampleFrames(count);
        write(frames, expected, placement);
        Glb glb = readGlb(test::bytesOfFile(m_path));
        QVERIFY(!glb.broken);
        const json& mesh = glb.description.at("meshes").at(0);
        const json& primitive = mesh.at("primitives").at(0);
        const auto first = positions(glb, primitive.at("attributes").at("POSITION"), 20);
        QCOMPARE(int(primitive.at("targets").size()), count - 1);
        for (int frame = 0; frame < count; ++frame) {
            std::vector<float> delta(60);
            if (frame > 0)
                delta = positions(glb, primitive.at("targets").at(std::size_t(frame - 1)).at("POSITION"), 20);
            for (std::size_t i = 0; i < 60; ++i) {
                const Vec3 p = frames[std::size_t(frame)]->state.position.at(int(i) / 3);
                const Vec3 wanted = turned ? Vec3(100 * p.x(), -100 * p.z(), 100 * p.y()) : p;
                const double is = double(first[i]) + double(delta[i]);
                // Of the first frame exactly; of others the difference is rounded once more.
                const double allowed = frame == 0 ? 0 : (turned ? 100 : 1) * 4.8e-7;
                QVERIFY(std::abs(is - double(float(wanted[Eigen::Index(i % 3)]))) <= allowed);
            }
        }
        QVERIFY(!glb.broken);
        QCOMPARE(mesh.at("extras").at("targetNames").size(), std::size_t(count - 1));
        QCOMPARE(mesh.at("extras").at("targetNames").at(0).get<std::string>(), std::string("frame 1"));
        QCOMPARE(glb.description.at("asset").at("version").get<std::string>(), std::string("2.0"));
        QCOMPARE(glb.description.at("asset").at("generator").get<std::string>(),
                 "ClothLab, " + describe(placement));
    }

    void theAnimationShowsOneFrameAtATime() {
        const std::size_t count = 5;
        write(test::sampleFrames(int(count)), int(count));
        Glb glb = readGlb(test::bytesOfFile(m_path));
        QVERIFY(!glb.broken);
        const json& animation = glb.description.at("animations").at(0);
        const json& channel = animation.at("channels").at(0);
        QCOMPARE(channel.at("target").at("path").get<std::string>(), std::string("weights"));
        const json& node = glb.description.at("nodes").at(channel.at("target").at("node").get<std::size_t>());
        QCOMPARE(node.at("mesh").get<int>(), 0);
        const json& sampler = animation.at("samplers").at(channel.at("sampler").get<std::size_t>());
        QCOMPARE(sampler.at("interpolation").get<std::string>(), std::string("LINEAR"));
        ByteReader times = accessor(glb, sampler.at("input"), kFloat, "SCALAR", count);
        ByteReader weights = accessor(glb, sampler.at("output"), kFloat, "SCALAR", count * (count - 1));
        QVERIFY(!glb.broken);
        for (std::size_t frame = 0; frame < count; ++frame) {
            QVERIFY(test::sameFloat(times.littleFloat(), float(double(frame) / 90.0)));
            for (std::size_t target = 1; target < count; ++target)
                QVERIFY(test::sameFloat(weights.littleFloat(), frame == target ? 1.0F : 0.0F));
        }
        const json& it = glb.description.at("accessors").at(sampler.at("input").get<std::size_t>());
        QVERIFY(test::sameFloat(it.at("min").at(0).get<float>(), 0.0F));
        QVERIFY(test::sameFloat(it.at("max").at(0).get<float>(), float(4 / 90.0)));
    }

    void theMeshIsThatOfTheObj() {
        const auto frames = test::sampleFrames(2);
        write(frames, 2);
        Glb glb = readGlb(test::bytesOfFile(m_path));
        QVERIFY(!glb.broken);
        const json& primitive = glb.description.at("meshes").at(0).at("primitives").at(0);
        QVERIFY(primitive.value("mode", 4) == 4); // triangles
        ByteReader indices = accessor(glb, primitive.at("indices"), kUnsigned, "SCALAR", 72);
        const json& attributes = primitive.at("attributes");
        ByteReader normals = accessor(glb, attributes.at("NORMAL"), kFloat, "VEC3", 20);
        ByteReader uv = accessor(glb, attributes.at("TEXCOORD_0"), kFloat, "VEC2", 20);
        QVERIFY(!glb.broken);
        std::ostringstream text;
        writeObj(text, *frames.front());
        for (const QString& line : QString::fromStdString(text.str()).split('\n')) {
            const QStringList words = line.split(' ');
            if (words[0] == "vt") {
                QVERIFY(test::sameFloat(uv.littleFloat(), words[1].toFloat()));
                QVERIFY(std::abs(uv.littleFloat() - (1 - words[2].toFloat())) < 1e-6F); // from above, here
            }
            for (int i = 1; i <= 3 && words[0] == "vn"; ++i)
                QVERIFY(test::sameFloat(normals.littleFloat(), float(words[i].toDouble())));
            for (int i = 1; i <= 3 && words[0] == "f"; ++i)
                QCOMPARE(int(indices.little()) + 1, words[i].section('/', 0, 0).toInt());
        }
        QVERIFY(indices.atEnd() && normals.atEnd() && uv.atEnd());
    }

    void aSingleFrameIsAMeshAlone() {
        write(test::sampleFrames(1), 1);
        Glb glb = readGlb(test::bytesOfFile(m_path));
        QVERIFY(!glb.broken);
        QVERIFY(!glb.description.contains("animations"));
        const json& primitive = glb.description.at("meshes").at(0).at("primitives").at(0);
        QVERIFY(!primitive.contains("targets"));
        QCOMPARE(positions(glb, primitive.at("attributes").at("POSITION"), 20).size(), std::size_t(60));
        QVERIFY(!glb.broken);
    }

    // The room for what describes the frames is enough with the longest numbers that there are.
    void theRoomIsEnough() {
        for (const int frames : {1, 2, 10, 1000}) {
            GlbContent content;
            content.points = 0x7fffffff / 12;
            content.triangles = 2 * content.points;
            content.about = "ClothLab, " + describe({UpAxis::Z, 1.2345678901234567e-6});
            Bounds bounds;
            bounds.least.fill(-1.17549435e-38F);
            bounds.greatest.fill(-1.17549435e-38F);
            content.bounds.assign(std::size_t(frames), bounds);
            content.times.assign(std::size_t(frames), 1.17549435e-38F);
            QVERIFY(jsonOf(content).size() <= mostJsonBytes(frames));
            QCOMPARE(mostJsonBytes(frames) % 4, 0U);
        }
    }

    void whatIsTooLargeIsRefusedAtOnce() {
        const auto refusal = [&](int width, int height, int frames) {
            const Sheet sheet{{width, height}, {}};
            return makeFrameWriter(ExportFormat::Glb, m_path)->begin(sheet, frames).value_or("");
        };
        const auto has = [](const std::string& text, const char* words) {
            return text.find(words) != std::string::npos;
        };
        const std::string frames = refusal(5, 4, 1001);
        QVERIFY2(has(frames, "a.glb: 1001 frames are more than the 1000") && has(frames, ".pc2"),
                 frames.c_str());
        const std::string bytes = refusal(512, 512, 800);
        QVERIFY2(has(bytes, "800 frames of 262144 points make 2.4 GiB") && has(bytes, "fewer"),
                 bytes.c_str());
        QVERIFY(!refusal(512, 512, 100'000'001).empty());
        QCOMPARE(refusal(512, 512, 600), std::string());
        QCOMPARE(refusal(5, 4, 1000), std::string());
        QVERIFY(QDir(m_folder->path()).isEmpty(QDir::AllEntries | QDir::NoDotAndDotDot | QDir::Hidden));
    }

private:
    void write(const std::vector<FramePointer>& frames, int expected, const Placement& placement = {}) const {
        const auto writer = makeFrameWriter(ExportFormat::Glb, m_path, {placement, true});
        QVERIFY(!writer->begin(test::sheetOf(*frames.front()), expected));
        for (const FramePointer& frame : frames)
            QVERIFY(!writer->add(frame));
        QVERIFY(!writer->finish());
        QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files | QDir::Hidden), QStringList{"a.glb"});
    }

    std::unique_ptr<QTemporaryDir> m_folder;
    std::string m_path;
};

QTEST_APPLESS_MAIN(TestGlb)
#include "tst_glb.moc"
