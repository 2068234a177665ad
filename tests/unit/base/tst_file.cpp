#include "simcore/base/read_file.h"
#include "simcore/base/whole_file.h"

#include <QTemporaryDir>
#include <QTest>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <ostream>
#include <set>
#include <stdexcept>

#include <sys/resource.h>
#include <sys/stat.h>
#include <unistd.h>

using namespace clothlab;
namespace fs = std::filesystem;

namespace {

void put(const fs::path& path, const std::string& text) {
    std::ofstream(path, std::ios::binary) << text;
}

std::string get(const fs::path& path) {
    std::ifstream in(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(in), {}};
}

std::optional<std::string> write(const fs::path& path, const std::string& text) {
    return writeFileWhole(path.string(), [&](std::ostream& out) { out << text; });
}

mode_t modeOf(const fs::path& path) {
    struct stat info {};
    return ::stat(path.c_str(), &info) == 0 ? info.st_mode & 07777 : 0;
}

std::set<std::string> namesIn(const fs::path& folder) {
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

// No file of this process grows beyond a size for as long as this lives.
class SizeLimit {
public:
    explicit SizeLimit(rlim_t bytes) {
        std::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &m_before);
        const struct rlimit limit { bytes, m_before.rlim_max };
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~SizeLimit() { ::setrlimit(RLIMIT_FSIZE, &m_before); }

private:
    struct rlimit m_before {};
};

} // namespace

class TestFile : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        m_path = fs::path(m_folder->path().toStdString()) / "file";
    }

    void readsEveryByte() {
        const std::string text("a\0b\r\n\xFF", 6);
        put(m_path, text);
        const FileText file = readFile(m_path.string(), 100);
        QVERIFY(file.text == text);
        QVERIFY(file.diagnostics.empty());
        put(m_path, "");
        QVERIFY(readFile(m_path.string(), 100).text == "");
    }

    void readsUpToTheLimitAndNoFurther() {
        put(m_path, std::string(1000, 'a'));
        QVERIFY(readFile(m_path.string(), 1000).text.has_value());
        const FileText file = readFile(m_path.string(), 999);
        QVERIFY(!file.text);
        QVERIFY(file.diagnostics.at(0).message.find("999") != std::string::npos);
    }

    void aFileThatStatesNoSizeIsReadWhole() {
        const std::string path = "/proc/self/status"; // its size is given as 0
        if (!fs::exists(path))
            QSKIP("no /proc here");
        QVERIFY(readFile(path, 1 << 20).text.value_or("").size() > 100);
        QVERIFY(!readFile(path, 100).text);
    }

    void readsThroughALink() {
        put(m_path, "text");
        fs::create_symlink("file", m_path.parent_path() / "link");
        QVERIFY(readFile((m_path.parent_path() / "link").string(), 100).text == "text");
    }

    void saysWhyItCannotRead_data() {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("words");
        QTest::newRow("missing") << "missing"
                                 << "no such file";
        QTest::newRow("folder") << "folder"
                                << "folder";
        QTest::newRow("pipe without a writer") << "pipe"
                                               << "pipe";
        QTest::newRow("device without an end") << "device"
                                               << "device";
        QTest::newRow("no name") << "none"
                                 << "not a name";
        QTest::newRow("file as a folder") << "through"
                                          << "not a folder";
        QTest::newRow("circle of links") << "circle"
                                         << "circle";
    }
    void saysWhyItCannotRead() {
        QFETCH(QString, kind);
        QFETCH(QString, words);
        fs::path path = m_path;
        if (kind == "folder")
            path = m_path.parent_path();
        else if (kind == "pipe")
            QCOMPARE(::mkfifo(path.c_str(), 0600), 0);
        else if (kind == "device")
            path = "/dev/zero";
        else if (kind == "none")
            path.clear();
        else if (kind == "circle")
            fs::create_symlink("file", m_path);
        else if (kind == "through") {
            put(m_path, "");
            path = m_path / "file";
        }
        const FileText file = readFile(path.string(), 1000);
        QVERIFY(!file.text);
        QCOMPARE(file.diagnostics.size(), std::size_t(1));
        const Diagnostic& d = file.diagnostics[0];
        QVERIFY2(d.message.find(words.toStdString()) != std::string::npos, d.message.c_str());
        QVERIFY(d.severity == Severity::Error && !d.remedy.empty());
    }

    void writesANewFileAsTheUserWouldHaveIt() {
        const mode_t mask = ::umask(027);
        const auto trouble = write(m_path, "text");
        ::umask(mask);
        QVERIFY2(!trouble, trouble.value_or("").c_str());
        QCOMPARE(get(m_path), "text");
        QCOMPARE(modeOf(m_path), mode_t(0640));
        QCOMPARE(namesIn(m_path.parent_path()).size(), std::size_t(1));
    }

    void writesMoreThanABufferHolds() {
        std::string text;
        for (int i = 0; i < 100'000; ++i)
            text += std::to_string(i) + "\n";
        QVERIFY(!write(m_path, text));
        QVERIFY(get(m_path) == text);
    }

    void replacesAFileAndKeepsItsPermissions() {
        put(m_path, "before");
        fs::permissions(m_path, fs::perms(0604));
        QVERIFY(!write(m_path, "after"));
        QCOMPARE(get(m_path), "after");
        QCOMPARE(modeOf(m_path), mode_t(0604));
    }

    void whoReadsSeesTheOldFileOrTheNewOne() {
        put(m_path, "before");
        std::ifstream reader(m_path);
        const auto trouble = writeFileWhole(m_path.string(), [&](std::ostream& out) {
            out << std::string(1 << 20, 'a') << std::flush;
            QCOMPARE(get(m_path), "before"); // while it is being written
        });
        QVERIFY(!trouble);
        QCOMPARE(std::string(std::istreambuf_iterator<char>(reader), {}), "before");
        QCOMPARE(get(m_path).size(), std::size_t(1 << 20));
    }

    void followsLinksAndLeavesThemThere() {
        const fs::path folder = m_path.parent_path();
        fs::create_directory(folder / "there");
        fs::create_symlink("there/target", folder / "second");
        fs::create_symlink("second", folder / "first");
        for (const char* text : {"to a file that is not there yet", "to one that is"}) {
            const auto trouble = write(folder / "first", text);
            QVERIFY2(!trouble, trouble.value_or("").c_str());
            QCOMPARE(get(folder / "there" / "target"), text);
            QVERIFY(fs::is_symlink(folder / "first") && fs::is_symlink(folder / "second"));
        }
        QCOMPARE(namesIn(folder / "there").size(), std::size_t(1));
    }

    void aFileInTheWorkingFolderNeedsNoFolderInItsName() {
        const fs::path before = fs::current_path();
        fs::current_path(m_path.parent_path());
        const auto trouble = write("file", "text");
        fs::current_path(before);
        QVERIFY2(!trouble, trouble.value_or("").c_str());
        QCOMPARE(get(m_path), "text");
    }

    void whatFailsLeavesEverythingAsItWas_data() {
        QTest::addColumn<QString>("kind");
        for (const char* kind : {"stream fails", "exception", "exception of another kind", "disk is full"})
            QTest::newRow(kind) << kind;
    }
    void whatFailsLeavesEverythingAsItWas() {
        QFETCH(QString, kind);
        put(m_path, "before");
        std::optional<std::string> trouble;
        {
            std::optional<SizeLimit> limit;
            if (kind == "disk is full")
                limit.emplace(100'000);
            trouble = writeFileWhole(m_path.string(), [&](std::ostream& out) {
                out << "half";
                if (kind == "stream fails")
                    out.setstate(std::ios::failbit);
                else if (kind == "exception")
                    throw std::runtime_error("no more ideas");
                else if (kind == "exception of another kind")
                    throw 7;
                else
                    out << std::string(1 << 20, 'a');
            });
        }
        QVERIFY(trouble && !trouble->empty());
        QCOMPARE(get(m_path), "before");
        QCOMPARE(namesIn(m_path.parent_path()).size(), std::size_t(1));
    }

    void growsPieceByPiece() {
        const fs::path path = folder() / "a.txt";
        put(path, "before");
        const std::string large(300'000, 'x'); // more than any buffer holds
        WholeFile file;
        QVERIFY(!file.open(path.string()));
        file.out() << "head....";
        QVERIFY(!file.skip(1000));
        file.out() << large << "tail";
        QVERIFY(!file.trouble());
        QVERIFY(!file.replace(4, "1234"));
        QVERIFY(!file.remove(8, 1000));
        file.out() << "end";
        QCOMPARE(get(path), std::string("before"));
        QVERIFY(!file.finish());
        QVERIFY(get(path) == "head1234" + large + "tailend");
        QCOMPARE(namesIn(folder()), std::set<std::string>{"a.txt"});
    }

    void skippedBytesAreZero() {
        WholeFile file;
        QVERIFY(!file.open((folder() / "a").string()));
        file.out() << 'a';
        QVERIFY(!file.skip(3));
        QVERIFY(!file.replace(2, "b"));
        QVERIFY(!file.finish());
        QCOMPARE(get(folder() / "a"), std::string("a\0b\0", 4));
    }

    void whatIsNotFinishedIsGone() {
        put(folder() / "old", "before");
        for (const char* name : {"old", "new"}) {
            WholeFile file;
            QVERIFY(!file.open((folder() / name).string()));
            file.out() << "after" << std::flush;
        }
        QCOMPARE(get(folder() / "old"), std::string("before"));
        QCOMPARE(namesIn(folder()), std::set<std::string>{"old"});
        WholeFile file;
        QVERIFY(file.open((folder() / "none" / "a").string()).has_value());
    }

    void aPieceThatDoesNotFitIsTold() {
        const SizeLimit limit(5000);
        {
            WholeFile file;
            QVERIFY(!file.open((folder() / "a").string()));
            file.out() << std::string(100'000, 'x') << std::flush;
            QVERIFY(file.trouble().has_value());
            QVERIFY(file.replace(0, "y").has_value() && file.remove(0, 1).has_value());
            QVERIFY(file.finish().has_value());
            QVERIFY(namesIn(folder()).empty());
        }
        WholeFile file;
        QVERIFY(!file.open((folder() / "a").string()));
        QVERIFY(file.skip(6000).has_value());
        QVERIFY(!file.replace(0, std::string(5000, 'y')));
        QVERIFY(file.replace(1, std::string(5000, 'y')).has_value());
    }

    void saysWhyItCannotWrite_data() {
        QTest::addColumn<QString>("kind");
        QTest::addColumn<QString>("words");
        QTest::newRow("folder is missing") << "missing"
                                           << "no such file or folder";
        QTest::newRow("is a folder") << "folder"
                                     << "is a folder";
        QTest::newRow("is a device") << "device"
                                     << "device";
        QTest::newRow("no name") << "none"
                                 << "not a name";
        QTest::newRow("zero byte") << "zero"
                                   << "not a name";
        QTest::newRow("circle of links") << "circle"
                                         << "circle";
        QTest::newRow("long name") << "long"
                                   << "too long";
        QTest::newRow("may only be read") << "read-only"
                                          << "permissions";
        QTest::newRow("folder may only be read") << "read-only folder"
                                                 << "permissions";
    }
    void saysWhyItCannotWrite() {
        QFETCH(QString, kind);
        QFETCH(QString, words);
        std::string path = m_path.string();
        if (kind.startsWith("read-only") && ::geteuid() == 0)
            QSKIP("this user may write every file");
        if (kind == "missing")
            path += "/a/b";
        else if (kind == "folder")
            path = m_path.parent_path().string();
        else if (kind == "device")
            path = "/dev/null";
        else if (kind == "none")
            path.clear();
        else if (kind == "zero")
            path += std::string("\0a", 2);
        else if (kind == "circle")
            fs::create_symlink("file", m_path);
        else if (kind == "long")
            path += std::string(300, 'a');
        else if (kind == "read-only") {
            put(m_path, "before");
            fs::permissions(m_path, fs::perms(0444));
        } else
            fs::permissions(m_path.parent_path(), fs::perms(0555));
        const auto before = namesIn(m_path.parent_path());
        const auto trouble = write(path, "text");
        QVERIFY2(trouble && trouble->find(words.toStdString()) != std::string::npos,
                 trouble.value_or("").c_str());
        QVERIFY(namesIn(m_path.parent_path()) == before);
        fs::permissions(m_path.parent_path(), fs::perms(0755));
    }

private:
    fs::path folder() const { return m_path.parent_path(); }

    std::unique_ptr<QTemporaryDir> m_folder;
    fs::path m_path;
};

QTEST_APPLESS_MAIN(TestFile)
#include "tst_file.moc"
