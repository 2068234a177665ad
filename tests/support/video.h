// Videos in tests: reading back what is in one, and programs that stand for ffmpeg.
#pragma once

#include <QByteArray>
#include <QSize>
#include <QString>
#include <QTest>

namespace clothlab::test {

// Skips a test where there is no ffmpeg, or fails where CLOTHLAB_REQUIRE_FFMPEG is 1.
#define CLOTHLAB_NEEDS_FFMPEG()                                                                              \
    do {                                                                                                     \
        const bool there = clothlab::test::hasFfmpeg();                                                      \
        const bool required = qEnvironmentVariable("CLOTHLAB_REQUIRE_FFMPEG") == "1";                        \
        QVERIFY2(there || !required, "CLOTHLAB_REQUIRE_FFMPEG is 1, and there is no ffmpeg or no ffprobe");  \
        if (!there)                                                                                          \
            QSKIP("There is no ffmpeg here; on Debian and Ubuntu: apt-get install ffmpeg");                  \
    } while (false)

bool hasFfmpeg(); // and ffprobe

struct Video {
    QString codec, pixelFormat;
    QSize size;
    int frames = 0;
    double framesPerSecond = 0;
    double seconds = 0;
};
Video probe(const QString& path); // frames are counted by decoding them; all zero if it is none

// The middle pixel of each frame, decoded: red, green, blue.
QByteArray middlePixels(const QString& path, QSize size);

// While it lives, the only ffmpeg in PATH is this shell script; none if it is empty.
class FakeFfmpeg {
public:
    FakeFfmpeg(const QString& folder, const QByteArray& script);
    ~FakeFfmpeg();
    FakeFfmpeg(const FakeFfmpeg&) = delete;
    FakeFfmpeg& operator=(const FakeFfmpeg&) = delete;

private:
    QByteArray m_path; // as it was
};

} // namespace clothlab::test
