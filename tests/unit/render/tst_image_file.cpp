// Pictures from files, good ones and all kinds of others.
#include "app/render/image_file.h"

#include <QDir>
#include <QFile>
#include <QImage>
#include <QTemporaryDir>
#include <QTest>

#include <sys/stat.h>

using namespace clothlab::render;

namespace {

QImage pattern(QImage::Format format) {
    QImage image(5, 3, format);
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 5; ++x)
            image.setPixelColor(x, y,
                                QColor(50 * x, 80 * y, 10 + x + y, image.hasAlphaChannel() ? 100 : 255));
    return image;
}

} // namespace

class ImageFileTest : public QObject {
    Q_OBJECT

private slots:
    void pngIsExact_data();
    void pngIsExact();
    void jpegIsClose();
    void theProgramsOwnTextures();
    void refused_data();
    void refused();
    void noPictureFileAtAll();
    void largestFileAndSide();
    void aJpegCutAnywhere();
    void checkerIsSeen();

private:
    QString path(const char* name) const { return m_directory.filePath(QLatin1String(name)); }
    bool write(const char* name, const QByteArray& bytes) const;
    QByteArray bytesOf(const char* name) const;

    QTemporaryDir m_directory;
};

bool ImageFileTest::write(const char* name, const QByteArray& bytes) const {
    QFile file(path(name));
    return file.open(QIODevice::WriteOnly) && file.write(bytes) == bytes.size();
}

QByteArray ImageFileTest::bytesOf(const char* name) const {
    QFile file(path(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

void ImageFileTest::pngIsExact_data() {
    QTest::addColumn<QImage::Format>("format");
    QTest::newRow("rgb") << QImage::Format_RGB888;
    QTest::newRow("rgba") << QImage::Format_RGBA8888;
    QTest::newRow("grey") << QImage::Format_Grayscale8;
    QTest::newRow("16 bits") << QImage::Format_RGBX64;
    QTest::newRow("palette") << QImage::Format_Indexed8;
}

void ImageFileTest::pngIsExact() {
    QFETCH(QImage::Format, format);
    const QImage image = format == QImage::Format_Indexed8
                             ? pattern(QImage::Format_RGB888).convertToFormat(format)
                             : pattern(format);
    QVERIFY(image.save(path("a.png")));
    QString reason;
    const std::optional<Image> read = readImage(path("a.png"), reason);
    QVERIFY2(read, qPrintable(reason));
    QVERIFY(reason.isEmpty());
    QCOMPARE(read->width, 5);
    QCOMPARE(read->height, 3);
    QCOMPARE(read->rgba.size(), std::size_t(60));
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 5; ++x) {
            const QColor color = image.pixelColor(x, y);
            const std::uint8_t* texel = read->rgba.data() + 4 * (5 * y + x);
            QCOMPARE(QColor(texel[0], texel[1], texel[2], texel[3]).rgba(), color.rgba());
        }
}

void ImageFileTest::jpegIsClose() {
    QImage image(32, 16, QImage::Format_RGB888);
    image.fill(QColor(200, 100, 50));
    QVERIFY(image.save(path("a.jpg"), "JPEG", 95));
    QVERIFY(image.save(path("really_a_jpeg.png"), "JPEG", 95)); // the name says nothing
    for (const char* name : {"a.jpg", "really_a_jpeg.png"}) {
        QString reason;
        const std::optional<Image> read = readImage(path(name), reason);
        QVERIFY2(read, qPrintable(reason));
        QCOMPARE(read->width, 32);
        QCOMPARE(read->height, 16);
        for (std::size_t i = 0; i < read->rgba.size(); i += 4) {
            QVERIFY(std::abs(read->rgba[i] - 200) < 6 && std::abs(read->rgba[i + 1] - 100) < 6 &&
                    std::abs(read->rgba[i + 2] - 50) < 6);
            QCOMPARE(int(read->rgba[i + 3]), 255);
        }
    }
}

void ImageFileTest::theProgramsOwnTextures() {
    const QDir directory(QStringLiteral(CLOTHLAB_SOURCE_DIR "/resources/textures"));
    for (const QString& name : directory.entryList({QStringLiteral("*.png")})) {
        QString reason;
        QVERIFY2(readImage(directory.filePath(name), reason), qPrintable(name + reason));
    }
}

void ImageFileTest::refused_data() {
    QTest::addColumn<QByteArray>("bytes");
    QImage noise(64, 64, QImage::Format_RGB888);
    for (int y = 0; y < 64; ++y)
        for (int x = 0; x < 64; ++x)
            noise.setPixelColor(x, y, QColor((x * y * 7) % 256, (x * 31 + y * 17) % 256, (x ^ y) * 3 % 256));
    QVERIFY(noise.save(path("good.png")));
    const QByteArray png = bytesOf("good.png");
    QTest::newRow("no bytes") << QByteArray();
    QTest::newRow("one byte") << QByteArray("\x89");
    QTest::newRow("text") << QByteArray("This is not a picture.");
    QTest::newRow("only zeros") << QByteArray(1000, '\0');
    QTest::newRow("signature") << png.left(8);
    QTest::newRow("header") << png.left(33);
    QTest::newRow("half") << png.left(png.size() / 2);
    QTest::newRow("gif") << QByteArray("GIF89a\x01\x00\x01\x00\x80\x00\x00\xff\xff\xff\x00\x00\x00,", 20);
    QTest::newRow("start of a jpeg") << QByteArray("\xFF\xD8\xFF\xE0\x00\x10JFIF", 10);
    QByteArray huge = png;
    huge.replace(16, 8, QByteArray("\x00\x00\x23\x28\x00\x00\x00\x01", 8)); // 9000 by 1
    QTest::newRow("9000 pixels wide") << huge;
    huge.replace(16, 8, QByteArray("\x7F\xFF\xFF\xFF\x7F\xFF\xFF\xFF", 8));
    QTest::newRow("as large as can be") << huge;
    huge.replace(16, 8, QByteArray(8, '\0'));
    QTest::newRow("no size") << huge;
    QByteArray broken = png;
    for (qsizetype i = 50; i < broken.size() - 20; i += 3)
        broken[i] = static_cast<char>(broken[i] + 85);
    QTest::newRow("damaged") << broken;
}

void ImageFileTest::refused() {
    QFETCH(QByteArray, bytes);
    QVERIFY(write("a.png", bytes));
    QString reason;
    QVERIFY(!readImage(path("a.png"), reason));
    QVERIFY2(reason.contains(QStringLiteral("PNG or JPEG")), qPrintable(reason));
    QVERIFY2(reason.contains(QStringLiteral("8192")), qPrintable(reason));
}

void ImageFileTest::noPictureFileAtAll() {
    QString reason;
    QVERIFY(!readImage(path("missing.png"), reason));
    QVERIFY2(reason.contains(QStringLiteral("cannot be read")), qPrintable(reason));
    QVERIFY(!readImage(m_directory.path(), reason));
    QVERIFY2(reason.contains(QStringLiteral("folder")), qPrintable(reason));
    // These would never end.
    QVERIFY(!readImage(QStringLiteral("/dev/zero"), reason));
    QVERIFY2(reason.contains(QStringLiteral("no ordinary file")), qPrintable(reason));
    QCOMPARE(::mkfifo(qPrintable(path("pipe.png")), 0600), 0);
    QVERIFY(!readImage(path("pipe.png"), reason));
    QVERIFY2(reason.contains(QStringLiteral("no ordinary file")), qPrintable(reason));
}

void ImageFileTest::largestFileAndSide() {
    QString reason;
    QFile large(path("large.png"));
    QVERIFY(large.open(QIODevice::WriteOnly) && large.resize((64 << 20) + 1)); // a hole: takes no room
    QVERIFY(!readImage(path("large.png"), reason));
    QVERIFY2(reason.contains(QStringLiteral("64 MiB")), qPrintable(reason));

    QVERIFY(QImage(8192, 1, QImage::Format_Grayscale8).save(path("wide.png")));
    reason.clear();
    const std::optional<Image> wide = readImage(path("wide.png"), reason);
    QVERIFY2(wide, qPrintable(reason));
    QCOMPARE(wide->width, 8192);
}

// What is left of a JPEG may be shown or refused, but has its size if it is shown.
void ImageFileTest::aJpegCutAnywhere() {
    QString reason;
    QVERIFY(pattern(QImage::Format_RGB888).scaled(200, 200).save(path("a.jpg")));
    const QByteArray bytes = bytesOf("a.jpg");
    for (qsizetype size = 0; size < bytes.size(); size += 97) {
        QVERIFY(write("cut.jpg", bytes.left(size)));
        if (const std::optional<Image> cut = readImage(path("cut.jpg"), reason))
            QCOMPARE(cut->rgba.size(), std::size_t(4 * 200 * 200));
    }
}

void ImageFileTest::checkerIsSeen() {
    const Image image = checker();
    QCOMPARE(image.rgba.size(), std::size_t(4 * image.width * image.height));
    QVERIFY(image.rgba[0] != image.rgba[4 * 8]);
    QCOMPARE(int(image.rgba[3]), 255);
}

QTEST_GUILESS_MAIN(ImageFileTest)
#include "tst_image_file.moc"
