// Shader files and what they include.
#include "app/render/shader_source.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

using namespace clothlab::render;

class ShaderSourceTest : public QObject {
    Q_OBJECT

private slots:
    void init();

    void aFileAlone();
    void linesKeepFilesAndNumbers();
    void includesOfIncludes();
    void eachFileOnce();
    void cyclesEnd();
    void besideBeforeBuiltIn();
    void spellings_data();
    void spellings();
    void linesOfEditorsElsewhere();
    void whatCannotBeRead();
    void tooMany();
    void tooLarge();

private:
    void write(const QString& name, const QByteArray& text);
    QString path(const QString& name) const { return m_directory->filePath(name); }
    std::optional<ShaderSource> read(const QString& name);
    QByteArray text(const QString& name);
    int lineWith(const QByteArray& text, const QByteArray& word, int& file) const;

    std::unique_ptr<QTemporaryDir> m_directory;
    Problems m_problems;
};

void ShaderSourceTest::init() {
    m_directory = std::make_unique<QTemporaryDir>();
    QVERIFY(m_directory->isValid());
    QVERIFY(QDir(m_directory->path()).mkdir(QStringLiteral("builtin")));
}

void ShaderSourceTest::write(const QString& name, const QByteArray& text) {
    QFile file(path(name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(text), text.size());
}

std::optional<ShaderSource> ShaderSourceTest::read(const QString& name) {
    m_problems.clear();
    return readShaderSource(path(name), path(QStringLiteral("builtin/")), m_problems);
}

QByteArray ShaderSourceTest::text(const QString& name) {
    const std::optional<ShaderSource> source = read(name);
    return source ? source->text : QByteArray();
}

// The line that a compiler would name for the first line that is `word`, and the number of its file.
int ShaderSourceTest::lineWith(const QByteArray& source, const QByteArray& word, int& file) const {
    int line = 0;
    file = 0;
    for (const QByteArray& each : source.split('\n')) {
        ++line;
        if (each == word)
            return line;
        if (each.startsWith("#line ")) {
            const QList<QByteArray> parts = each.split(' ');
            line = parts[1].toInt() % kLinesPerFile - 1;
            file = parts[2].toInt();
            if (parts[1].toInt() / kLinesPerFile != file)
                return -1;
        }
    }
    return -1;
}

void ShaderSourceTest::aFileAlone() {
    write(QStringLiteral("a.frag"), "#version 330\nvoid main() {}\n");
    const std::optional<ShaderSource> source = read(QStringLiteral("a.frag"));
    QVERIFY(source);
    QVERIFY(m_problems.isEmpty());
    QCOMPARE(source->text.trimmed(), QByteArray("#version 330\nvoid main() {}"));
    QCOMPARE(source->files, QStringList(path(QStringLiteral("a.frag"))));
    write(QStringLiteral("empty.frag"), "");
    QVERIFY(read(QStringLiteral("empty.frag")));
    QVERIFY(m_problems.isEmpty());
}

void ShaderSourceTest::linesKeepFilesAndNumbers() {
    write(QStringLiteral("a.frag"), "#version 330\n#include \"one.glsl\"\nA\n\n#include \"two.glsl\"\nB");
    write(QStringLiteral("one.glsl"), "first\nC\n");
    write(QStringLiteral("two.glsl"), "D\nfirst of two lines");
    const std::optional<ShaderSource> source = read(QStringLiteral("a.frag"));
    QVERIFY(source);
    QCOMPARE(source->files, QStringList({path(QStringLiteral("a.frag")), path(QStringLiteral("one.glsl")),
                                         path(QStringLiteral("two.glsl"))}));
    int file = 0;
    QCOMPARE(lineWith(source->text, "A", file), 3);
    QCOMPARE(file, 0);
    QCOMPARE(lineWith(source->text, "B", file), 6);
    QCOMPARE(file, 0);
    QCOMPARE(lineWith(source->text, "C", file), 2);
    QCOMPARE(file, 1);
    QCOMPARE(lineWith(source->text, "D", file), 1);
    QCOMPARE(file, 2);
    QVERIFY(source->text.startsWith("#version 330\n")); // nothing may come before it
}

void ShaderSourceTest::includesOfIncludes() {
    write(QStringLiteral("a.frag"), "#include \"b.glsl\"\nA\n");
    write(QStringLiteral("b.glsl"), "\n#include \"c.glsl\"\nB\n");
    write(QStringLiteral("c.glsl"), "C\n");
    const QByteArray source = text(QStringLiteral("a.frag"));
    int file = 0;
    QCOMPARE(lineWith(source, "A", file), 2);
    QCOMPARE(file, 0);
    QCOMPARE(lineWith(source, "B", file), 3);
    QCOMPARE(file, 1);
    QCOMPARE(lineWith(source, "C", file), 1);
    QCOMPARE(file, 2);
}

void ShaderSourceTest::eachFileOnce() {
    write(QStringLiteral("a.frag"), "#include \"b.glsl\"\n#include \"c.glsl\"\n#include \"b.glsl\"\nA\n");
    write(QStringLiteral("b.glsl"), "#include \"c.glsl\"\nB\n");
    write(QStringLiteral("c.glsl"), "C\n");
    const QByteArray source = text(QStringLiteral("a.frag"));
    QCOMPARE(source.count("C\n"), 1);
    QCOMPARE(source.count("B\n"), 1);
    int file = 0;
    QCOMPARE(lineWith(source, "A", file), 4);
    QCOMPARE(file, 0);
}

void ShaderSourceTest::cyclesEnd() {
    write(QStringLiteral("a.frag"), "A\n#include \"b.glsl\"\n");
    write(QStringLiteral("b.glsl"), "B\n#include \"a.frag\"\n#include \"b.glsl\"\n");
    const QByteArray source = text(QStringLiteral("a.frag"));
    QVERIFY(m_problems.isEmpty());
    QCOMPARE(source.count("A\n"), 1);
    QCOMPARE(source.count("B\n"), 1);
}

void ShaderSourceTest::besideBeforeBuiltIn() {
    write(QStringLiteral("builtin/light.glsl"), "builtin light\n");
    write(QStringLiteral("a.frag"), "#include \"light.glsl\"\n");
    QVERIFY(text(QStringLiteral("a.frag")).contains("builtin light"));
    write(QStringLiteral("light.glsl"), "own light\n");
    QVERIFY(text(QStringLiteral("a.frag")).contains("own light"));
    QVERIFY(!text(QStringLiteral("a.frag")).contains("builtin"));
}

void ShaderSourceTest::spellings_data() {
    QTest::addColumn<QByteArray>("line");
    QTest::addColumn<bool>("includes");
    QTest::newRow("plain") << QByteArray("#include \"b.glsl\"") << true;
    QTest::newRow("spaces") << QByteArray(" \t# include   \"b.glsl\"  ") << true;
    QTest::newRow("comment") << QByteArray("#include \"b.glsl\" // light") << true;
    QTest::newRow("commented out") << QByteArray("// #include \"b.glsl\"") << false;
    QTest::newRow("brackets") << QByteArray("#include <b.glsl>") << false;
    QTest::newRow("folders") << QByteArray("#include \"../b.glsl\"") << false;
    QTest::newRow("no quote") << QByteArray("#include b.glsl") << false;
    QTest::newRow("nothing") << QByteArray("#include \"\"") << false;
    QTest::newRow("within a line") << QByteArray("int a; #include \"b.glsl\"") << false;
}

void ShaderSourceTest::spellings() {
    QFETCH(QByteArray, line);
    QFETCH(bool, includes);
    write(QStringLiteral("b.glsl"), "included\n");
    write(QStringLiteral("a.frag"), line + '\n');
    const QByteArray source = text(QStringLiteral("a.frag"));
    QCOMPARE(source.contains("included"), includes);
    QCOMPARE(source.contains(line), !includes); // what it is not is left to the compiler
}

void ShaderSourceTest::linesOfEditorsElsewhere() {
    write(QStringLiteral("a.frag"), "\xEF\xBB\xBF#version 330\r\n#include \"b.glsl\"\r\nA\r\n");
    write(QStringLiteral("b.glsl"), "\xEF\xBB\xBF"
                                    "B\r\n");
    const QByteArray source = text(QStringLiteral("a.frag"));
    QVERIFY(source.startsWith("#version 330\n"));
    QVERIFY(!source.contains('\r') && !source.contains('\xEF'));
    int file = 0;
    QCOMPARE(lineWith(source, "B", file), 1);
    QCOMPARE(lineWith(source, "A", file), 3);
    write(QStringLiteral("old.frag"), "#version 330\rvoid main() {}\r");
    QVERIFY(read(QStringLiteral("old.frag")));
}

void ShaderSourceTest::whatCannotBeRead() {
    QVERIFY(!read(QStringLiteral("none.frag")));
    QCOMPARE(m_problems.size(), 1);
    QCOMPARE(m_problems[0].path, path(QStringLiteral("none.frag")));
    QCOMPARE(m_problems[0].line, 0);
    QVERIFY(!read(QStringLiteral("builtin")));
    QCOMPARE(m_problems.size(), 1);

    write(QStringLiteral("a.frag"), "A\n\n#include \"b.glsl\"\n");
    write(QStringLiteral("b.glsl"), "#include \"none.glsl\"\n");
    QVERIFY(!read(QStringLiteral("a.frag")));
    QCOMPARE(m_problems.size(), 1);
    QCOMPARE(m_problems[0].path, path(QStringLiteral("b.glsl")));
    QCOMPARE(m_problems[0].line, 1);
    QVERIFY(m_problems[0].text.contains(QStringLiteral("none.glsl")));

    QVERIFY(QDir(m_directory->path()).mkdir(QStringLiteral("folder.glsl")));
    write(QStringLiteral("c.frag"), "#include \"folder.glsl\"\n");
    QVERIFY(!read(QStringLiteral("c.frag")));
    QCOMPARE(m_problems.size(), 1);
    QCOMPARE(m_problems[0].path, path(QStringLiteral("folder.glsl")));

    // It would never end.
    QCOMPARE(::mkfifo(qPrintable(path(QStringLiteral("pipe.glsl"))), 0600), 0);
    write(QStringLiteral("d.frag"), "#include \"pipe.glsl\"\n");
    QVERIFY(!read(QStringLiteral("d.frag")));
    QCOMPARE(m_problems[0].path, path(QStringLiteral("pipe.glsl")));
}

void ShaderSourceTest::tooMany() {
    const auto name = [](int i) { return QStringLiteral("part_%1.glsl").arg(i); };
    for (int i = 0; i < 70; ++i)
        write(name(i), "#include \"" + name(i + 1).toLatin1() + "\"\n");
    write(name(70), "last\n");
    QVERIFY(!read(name(0)));
    QCOMPARE(m_problems.size(), 1);
    QCOMPARE(m_problems[0].line, 1);
    QVERIFY(read(name(10))); // 61 files are not too many
}

void ShaderSourceTest::tooLarge() {
    write(QStringLiteral("a.frag"), QByteArray((1 << 20) + 1, ' '));
    QVERIFY(!read(QStringLiteral("a.frag")));
    QCOMPARE(m_problems.size(), 1);
    write(QStringLiteral("a.frag"), QByteArray(1 << 20, ' '));
    QVERIFY(read(QStringLiteral("a.frag")));
}

QTEST_APPLESS_MAIN(ShaderSourceTest)
#include "tst_shader_source.moc"
