// Shaders broken while they are drawn, in all ways that an editor makes: the picture stays, the fault is
// named with file and line, and mending is seen.
#include "tests/golden/canvas.h"

#include <functional>
#include <optional>

using namespace clothlab::render;

namespace {

constexpr const char* kVertices = "#version 330\n"
                                  "uniform mat4 u_model;\n"
                                  "uniform mat4 u_view_projection;\n"
                                  "in vec4 in_position;\n"
                                  "out vec4 v_position;\n"
                                  "void main() {\n"
                                  "    v_position = u_model * in_position;\n"
                                  "    gl_Position = u_view_projection * v_position;\n"
                                  "}\n";
constexpr const char* kFragments = "#version 330\n"
                                   "#include \"part.glsl\"\n"
                                   "in vec4 v_position;\n"
                                   "out vec4 out_color;\n"
                                   "void main() {\n"
                                   "    out_color = vec4(tint(v_position.xyz), 1.0);\n"
                                   "}\n";
constexpr const char* kPart = "uniform float u_shade; // 0.75 [0, 1] \"Shade\"\n"
                              "vec3 tint(vec3 p) {\n"
                              "    return u_shade * fract(4.0 * p);\n"
                              "}\n";

// What is done to a file, and which file and line are to be named; line 0: none, -1: any; kMayLink: a driver
// may also take it, with varyings that have no value, as Mesa does.
constexpr int kMayLink = -2;
struct Break {
    const char* name;
    const char* file;
    std::function<QByteArray(QByteArray)> text;
    const char* blamed;
    int line;
};

std::function<QByteArray(QByteArray)> replaced(const char* from, const QByteArray& to) {
    return [from, to](QByteArray text) { return text.replace(from, to); };
}

std::function<QByteArray(QByteArray)> only(const QByteArray& text) {
    return [text](const QByteArray&) { return text; };
}

QByteArray manySamplers(int count) {
    QByteArray text = "#version 330\nin vec4 v_position; out vec4 out_color;\n";
    QByteArray sum = "vec4(0.0)";
    for (int i = 0; i < count; ++i) {
        text += "uniform sampler2D u_map_" + QByteArray::number(i) + ";\n";
        sum += " + texture(u_map_" + QByteArray::number(i) + ", v_position.xz)";
    }
    return text + "void main() { out_color = " + sum + "; }\n";
}

constexpr const char* kMain = "    out_color = vec4(tint(v_position.xyz), 1.0);";

const std::vector<Break> kBreaks{
    {"syntax error", "Mine.frag", replaced(kMain, "    out_color = = 1;"), "Mine.frag", 6},
    {"no main", "Mine.frag", replaced("void main()", "void other()"), "Mine.frag", 0},
    {"unknown name", "Mine.frag", replaced(kMain, "\n    out_color = colour;"), "Mine.frag", 7},
    {"unknown function", "Mine.frag", replaced("tint(", "tints("), "Mine.frag", 6},
    {"wrong type", "Mine.frag", replaced(kMain, "    out_color = v_position.xyz;"), "Mine.frag", 6},
    {"no semicolon", "Mine.frag", replaced("1.0);", "1.0)"), "Mine.frag", 7},
    {"unclosed brace", "Mine.frag", replaced("1.0);\n}", "1.0);\n"), "Mine.frag", -1},
    {"unclosed comment", "Mine.frag", replaced("in vec4 v_position;", "/* in vec4"), "Mine.frag", -1},
    {"version there is not", "Mine.frag", replaced("330", "999"), "Mine.frag", 1},
    {"version that is too old", "Mine.frag", replaced("330", "110"), "Mine.frag", -1},
    {"no version", "Mine.frag", replaced("#version 330\n", "\n"), "Mine.frag", -1},
    {"#error", "Mine.frag", replaced("in vec4 v_position;", "#error no\nin vec4 v_position;"), "Mine.frag",
     3},
    {"varying nobody writes", "Mine.frag", replaced("tint(v_position.xyz)", "v_missing"), "Mine.frag", 6},
    {"varying not in the .vert", "Mine.frag",
     [](QByteArray text) {
         return text.replace("in vec4 v_position;", "in vec4 v_position; in vec3 v_missing;")
             .replace("tint(v_position.xyz)", "v_missing");
     },
     "Mine.frag", kMayLink},
    {"varying of another type", "Mine.frag",
     [](QByteArray text) {
         return text.replace("in vec4 v_position;", "in vec3 v_position;").replace(".xyz", "");
     },
     "Mine.frag", 0},
    {"function without a body", "Mine.frag", replaced("#include \"part.glsl\"", "vec3 tint(vec3 p);"),
     "Mine.frag", 0},
    {"function that calls itself", "Mine.frag",
     replaced("#include \"part.glsl\"", "vec3 tint(vec3 p) { return p.x > 9.0 ? p : tint(p + 1.0); }"),
     "Mine.frag", 0},
    {"empty", "Mine.frag", only(""), "Mine.frag", -1},
    {"binary junk", "Mine.frag",
     only(QByteArray("\x7F"
                     "ELF\x02\x01\x01\0\0\0\xFF\xFE\x80\x81\n\0\x03",
                     18)),
     "Mine.frag", -1},
    {"NUL bytes", "Mine.frag", only(QByteArray(300, '\0')), "Mine.frag", -1},
    {"NUL within", "Mine.frag", replaced("    out_color", QByteArray("  \0  out_color", 14)), "Mine.frag",
     -1},
    {"not UTF-8", "Mine.frag",
     replaced("tint(v", "t\xE4\xFF"
                        "nt(v"),
     "Mine.frag", 6},
    {"2 MB", "Mine.frag", [](const QByteArray& text) { return text + QByteArray(2 << 20, ' '); }, "Mine.frag",
     0},
    {"too many samplers", "Mine.frag", only(manySamplers(400)), "Mine.frag", 0},
    {"too many uniforms", "Mine.frag",
     [](QByteArray text) {
         return text.replace("out vec4 out_color;", "out vec4 out_color; uniform vec4 u_many[99999];")
             .replace("1.0)", "1.0) + u_many[int(v_position.x * 99999.0)]");
     },
     "Mine.frag", 0},
    {"missing include", "Mine.frag", replaced("part.glsl", "gone.glsl"), "Mine.frag", 2},
    {"error in the .vert", "Mine.vert", replaced("v_position = u_model", "v_position = u_modell"),
     "Mine.vert", 7},
    {"the .vert is empty", "Mine.vert", only(""), "Mine.vert", -1},
    {"the .vert writes less", "Mine.vert",
     [](QByteArray text) { return text.replace("out vec4 v_position;", "vec4 v_position;"); }, "Mine.frag",
     kMayLink},
    {"error in an included file", "part.glsl", replaced("fract(4.0 * p)", "frct(4.0 * p)"), "part.glsl", 3},
    {"included file lacks a brace", "part.glsl", replaced("p);\n}", "p);\n"), nullptr, -1},
    {"included file includes none", "part.glsl", replaced("vec3 tint", "\n#include \"no.glsl\"\nvec3 tint"),
     "part.glsl", 3},
    {"included file is binary", "part.glsl", only(QByteArray("\xFF\xFE\0\x80 \x01", 6)), "part.glsl", -1},
};

} // namespace

class BrokenShadersTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { SKIP_WITHOUT_OPENGL(); }
    void init();
    void cleanup() { m_studio.reset(); }

    void texts_data();
    void texts();
    void files_data();
    void files();
    void cyclesAreHarmless();
    void brokenFromTheStart();
    void moreSamplersThanUnits();
    void samplersThatAreNotSet();

private:
    bool mend();
    void stays(const char* blamed, int line);
    void mendsAndChanges();

    std::optional<ShaderDirectory> m_directory;
    std::optional<Studio> m_studio;
    RenderFrame m_frame;
    QImage m_before;
};

bool BrokenShadersTest::mend() {
    return m_directory->write(QStringLiteral("Mine.vert"), kVertices) &&
           m_directory->write(QStringLiteral("Mine.frag"), kFragments) &&
           m_directory->write(QStringLiteral("part.glsl"), kPart);
}

void BrokenShadersTest::init() {
    m_directory.emplace();
    QVERIFY(m_studio.emplace().isGood());
    m_studio->renderer.setShaderDirectory(m_directory->path());
    QVERIFY(mend());
    m_frame = flatFrame(8);
    m_frame.spheres = {{QVector3D(0.5F, 0.5F, 0.5F), 0.2F}};
    m_frame.surface.shader = QStringLiteral("Mine");
    m_before = m_studio->draw(m_frame);
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
    QVERIFY(countPixels(m_before, m_frame.background, 0) < kSize.width() * kSize.height() - 5000);
    QCOMPARE(m_studio->renderer.uniforms().size(), std::size_t(1));
}

// Drawn with what was good before, more than once, and the fault is named.
void BrokenShadersTest::stays(const char* blamed, int line) {
    m_studio->renderer.reloadFiles();
    for (int i = 0; i < 2; ++i) {
        QCOMPARE(m_studio->draw(m_frame), m_before);
        const Problems& problems = m_studio->renderer.problems();
        QVERIFY(!problems.isEmpty());
        const Problem first = problems.constFirst();
        QVERIFY2(!first.text.trimmed().isEmpty(), qPrintable(m_studio->faults()));
        if (blamed)
            QVERIFY2(first.path == m_directory->path(QLatin1String(blamed)), qPrintable(m_studio->faults()));
        if (line >= 0)
            QVERIFY2(first.line == line, qPrintable(m_studio->faults()));
        QCOMPARE(m_studio->renderer.shaderInUse(), QStringLiteral("Mine"));
        QCOMPARE(m_studio->renderer.uniforms().size(), std::size_t(1));
    }
    // What the user sets still has its effect.
    RenderFrame darker = m_frame;
    darker.surface.uniforms[darker.surface.shader][QStringLiteral("u_shade")] = number(0.3F);
    QVERIFY(m_studio->draw(darker) != m_before);
}

void BrokenShadersTest::mendsAndChanges() {
    QVERIFY(mend());
    m_studio->renderer.reloadFiles();
    QCOMPARE(m_studio->draw(m_frame), m_before);
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
    QVERIFY(m_directory->write(QStringLiteral("part.glsl"), QByteArray(kPart).replace("4.0", "2.0")));
    const int builds = m_studio->renderer.builds();
    m_studio->renderer.reloadFiles();
    QVERIFY(m_studio->draw(m_frame) != m_before);
    QVERIFY(m_studio->renderer.builds() > builds);
    QVERIFY(m_studio->renderer.problems().isEmpty());
}

void BrokenShadersTest::texts_data() {
    QTest::addColumn<int>("index");
    for (std::size_t i = 0; i < kBreaks.size(); ++i)
        QTest::newRow(kBreaks[i].name) << int(i);
}

void BrokenShadersTest::texts() {
    QFETCH(int, index);
    const Break& broken = kBreaks[static_cast<std::size_t>(index)];
    const QString file = QLatin1String(broken.file);
    const QByteArray good = file.endsWith(QLatin1String("vert"))   ? kVertices
                            : file.endsWith(QLatin1String("frag")) ? kFragments
                                                                   : kPart;
    const QByteArray bad = broken.text(good);
    QVERIFY(bad != good);
    QVERIFY(m_directory->write(file, bad));
    m_studio->renderer.reloadFiles();
    QVERIFY(!m_studio->draw(m_frame).isNull());
    if (broken.line != kMayLink || !m_studio->renderer.problems().isEmpty())
        stays(broken.blamed, std::max(broken.line, -1));
    if (!QTest::currentTestFailed())
        mendsAndChanges();
}

void BrokenShadersTest::files_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<QString>("how");
    for (const char* file : {"Mine.frag", "part.glsl"})
        for (const char* how : {"deleted", "a folder", "unreadable", "a link to nothing"})
            QTest::addRow("%s is %s", file, how) << QString::fromLatin1(file) << QString::fromLatin1(how);
    QTest::newRow("Mine.vert is a folder") << QStringLiteral("Mine.vert") << QStringLiteral("a folder");
}

void BrokenShadersTest::files() {
    QFETCH(QString, file);
    QFETCH(QString, how);
    const QString path = m_directory->path(file);
    if (how == QLatin1String("unreadable")) {
        QVERIFY(QFile::setPermissions(path, QFileDevice::WriteOwner));
        QFile test(path);
        if (test.open(QIODevice::ReadOnly))
            QSKIP("This user may read every file.");
    } else {
        QVERIFY(QFile::remove(path));
    }
    if (how == QLatin1String("a folder"))
        QVERIFY(QDir().mkdir(path));
    if (how == QLatin1String("a link to nothing"))
        QVERIFY(QFile::link(m_directory->path(QStringLiteral("nothing")), path));
    // A file that is included but not there is the fault of the line that includes it.
    const bool isGone = how == QLatin1String("deleted") || how == QLatin1String("a link to nothing");
    const bool included = file == QLatin1String("part.glsl");
    stays(included && isGone ? "Mine.frag" : qPrintable(file), included && isGone ? 2 : 0);
    if (how == QLatin1String("a folder"))
        QVERIFY(QDir().rmdir(path));
    QFile::setPermissions(path, QFileDevice::ReadOwner | QFileDevice::WriteOwner);
    QFile::remove(path);
    if (!QTest::currentTestFailed())
        mendsAndChanges();
}

// A file that includes itself, or is included twice, is there once.
void BrokenShadersTest::cyclesAreHarmless() {
    QVERIFY(m_directory->write(QStringLiteral("part.glsl"),
                               QByteArray("#include \"Mine.frag\"\n#include \"part.glsl\"\n") + kPart));
    m_studio->renderer.reloadFiles();
    QCOMPARE(m_studio->draw(m_frame), m_before);
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
}

// Where nothing was good before there is a plain picture, not an empty one.
void BrokenShadersTest::brokenFromTheStart() {
    QVERIFY(m_directory->write(QStringLiteral("Other.frag"), "#version 330\nvoid main() { ! }\n"));
    m_studio.emplace();
    m_studio->renderer.setShaderDirectory(m_directory->path());
    m_frame.surface.shader = QStringLiteral("Other");
    const QImage image = m_studio->draw(m_frame);
    QVERIFY(countPixels(image, m_frame.background, 0) < kSize.width() * kSize.height() - 5000);
    QVERIFY(m_studio->renderer.shaderInUse().isEmpty());
    QVERIFY(m_studio->faults().startsWith(QStringLiteral("Other.frag:2: ")));
}

// A driver may link more samplers than OpenGL 3.3 promises and the renderer binds: then that is said.
void BrokenShadersTest::moreSamplersThanUnits() {
    QVERIFY(m_directory->write(QStringLiteral("Mine.frag"), manySamplers(14)));
    m_studio->renderer.reloadFiles();
    QVERIFY(!m_studio->draw(m_frame).isNull());
    QVERIFY(!m_studio->renderer.problems().isEmpty());
}

// Two kinds of sampler at one texture unit would make OpenGL refuse to draw.
void BrokenShadersTest::samplersThatAreNotSet() {
    QVERIFY(m_directory->write(QStringLiteral("Mine.frag"),
                               "#version 330\nuniform sampler2D u_texture_1; uniform samplerCube u_mine;\n"
                               "in vec4 v_position; out vec4 out_color;\n"
                               "void main() { out_color = 0.5 * texture(u_texture_1, v_position.xz)"
                               " + texture(u_mine, v_position.xyz) + vec4(0.2); }\n"));
    m_studio->renderer.reloadFiles();
    const QImage image = m_studio->draw(m_frame);
    QVERIFY2(!image.isNull(), "OpenGL has refused to draw");
    QVERIFY(countPixels(image, m_frame.background, 0) < kSize.width() * kSize.height() - 5000);
    QVERIFY(m_studio->faults().contains(QStringLiteral("u_mine")));
}

int main(int argc, char** argv) {
    return runOnDisplay<BrokenShadersTest>(argc, argv);
}
#include "tst_broken_shaders.moc"
