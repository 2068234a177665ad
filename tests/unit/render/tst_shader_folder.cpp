// What is written to a folder of shaders is noticed.
#include "app/render/shader_folder.h"

#include <QFile>
#include <QSaveFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

#include <memory>
#include <optional>

using namespace clothlab::render;

namespace {

constexpr int kPatience = 10'000; // milliseconds; signals come within a tenth of one second

bool comes(QSignalSpy& spy) {
    return !spy.isEmpty() || spy.wait(kPatience);
}

} // namespace

class ShaderFolderTest : public QObject {
    Q_OBJECT

private slots:
    void init();

    void namesAreListed();
    void writtenInPlace();
    void replacedByRename();
    void replacedTwice();
    void newAndDeletedFiles();
    void includedFilesAndVertexShaders();
    void unchangedContentIsNoChange();
    void otherFilesAreNobodysConcern();
    void noFolder();

private:
    void write(const char* name, const QByteArray& text);
    void replace(const char* name, const QByteArray& text);
    QString path(const char* name) const { return m_directory->filePath(QLatin1String(name)); }
    void watch();

    std::unique_ptr<QTemporaryDir> m_directory;
    std::unique_ptr<ShaderFolder> m_folder;
    std::unique_ptr<QSignalSpy> m_files;
    std::unique_ptr<QSignalSpy> m_names;
};

void ShaderFolderTest::init() {
    m_folder.reset();
    m_directory = std::make_unique<QTemporaryDir>();
    write("A.frag", "one");
    write("Wireframe.frag", "two");
    watch();
}

void ShaderFolderTest::watch() {
    m_folder = std::make_unique<ShaderFolder>(m_directory->path());
    m_files = std::make_unique<QSignalSpy>(m_folder.get(), &ShaderFolder::filesChanged);
    m_names = std::make_unique<QSignalSpy>(m_folder.get(), &ShaderFolder::namesChanged);
}

void ShaderFolderTest::write(const char* name, const QByteArray& text) {
    QFile file(path(name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(text), text.size());
}

// As most editors save: a new file takes the place of the old one.
void ShaderFolderTest::replace(const char* name, const QByteArray& text) {
    QSaveFile file(path(name));
    QVERIFY(file.open(QIODevice::WriteOnly));
    QCOMPARE(file.write(text), text.size());
    QVERIFY(file.commit());
}

void ShaderFolderTest::namesAreListed() {
    QCOMPARE(m_folder->names(), QStringList({QStringLiteral("Wireframe"), QStringLiteral("A")}));
    QCOMPARE(m_folder->path(), m_directory->path());
    QCOMPARE(m_folder->fileOf(QStringLiteral("A")), path("A.frag"));
}

void ShaderFolderTest::writtenInPlace() {
    write("A.frag", "another text");
    QVERIFY(comes(*m_files));
    QVERIFY(m_names->isEmpty());
}

void ShaderFolderTest::replacedByRename() {
    replace("A.frag", "another text");
    QVERIFY(comes(*m_files));
    QVERIFY(m_names->isEmpty());
}

// The file that took the place of the first one is watched, too, however it is changed.
void ShaderFolderTest::replacedTwice() {
    for (const char* text : {"first", "second", "third"}) {
        m_files->clear();
        replace("A.frag", text);
        QVERIFY(comes(*m_files));
    }
    m_files->clear();
    write("A.frag", "fourth, in place");
    QVERIFY(comes(*m_files));
    QVERIFY(m_names->isEmpty());
}

void ShaderFolderTest::newAndDeletedFiles() {
    write("B.frag", "new");
    QVERIFY(comes(*m_names));
    QVERIFY(comes(*m_files));
    QVERIFY(m_folder->names().contains(QStringLiteral("B")));

    m_files->clear();
    m_names->clear();
    write("B.frag", "changed"); // it is watched from now on
    QVERIFY(comes(*m_files));
    QVERIFY(m_names->isEmpty());

    m_files->clear();
    QVERIFY(QFile::remove(path("B.frag")));
    QVERIFY(comes(*m_names));
    QVERIFY(comes(*m_files));
    QVERIFY(!m_folder->names().contains(QStringLiteral("B")));

    m_files->clear();
    m_names->clear();
    write("B.frag", "here again");
    QVERIFY(comes(*m_names));
    QVERIFY(comes(*m_files));
}

void ShaderFolderTest::includedFilesAndVertexShaders() {
    for (const char* name : {"part.glsl", "A.vert"}) {
        for (const char* text : {"new", "changed"}) {
            m_files->clear();
            write(name, text);
            QVERIFY(comes(*m_files));
        }
    }
    QVERIFY(m_names->isEmpty());
}

void ShaderFolderTest::unchangedContentIsNoChange() {
    replace("A.frag", "one");
    QVERIFY(!m_files->wait(300));
    write("Wireframe.frag", "three");
    QVERIFY(comes(*m_files));
    QCOMPARE(m_files->size(), 1);
}

void ShaderFolderTest::otherFilesAreNobodysConcern() {
    write("notes.txt", "text");
    write("A.frag~", "text");
    QVERIFY(!m_files->wait(300));
}

void ShaderFolderTest::noFolder() {
    ShaderFolder none{QString()};
    QVERIFY(none.names().isEmpty());
    ShaderFolder gone(path("not_there"));
    QVERIFY(gone.names().isEmpty());
}

QTEST_GUILESS_MAIN(ShaderFolderTest)
#include "tst_shader_folder.moc"
