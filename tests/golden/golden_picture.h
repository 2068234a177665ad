// Comparing a picture with the one that is kept of it.
#pragma once

#include <QDir>
#include <QFileInfo>
#include <QImage>
#include <QString>

#include <algorithm>
#include <cmath>

namespace clothlab::render {

// The tolerance of all golden pictures: a pixel is wrong if a channel is off by more than kChannel of 255,
// and of all pixels this part may be wrong. Drivers round differently, and edges fall on one pixel or the
// next.
inline constexpr int kChannelTolerance = 8;
inline constexpr double kWrongPart = 0.005;

inline bool isWrong(QRgb a, QRgb b) {
    return std::abs(qRed(a) - qRed(b)) > kChannelTolerance ||
           std::abs(qGreen(a) - qGreen(b)) > kChannelTolerance ||
           std::abs(qBlue(a) - qBlue(b)) > kChannelTolerance;
}

// Wrong pixels in red over a dim copy of the picture.
inline QImage differenceOf(const QImage& actual, const QImage& expected, int& wrong) {
    QImage difference(actual.size(), QImage::Format_RGB32);
    wrong = 0;
    for (int y = 0; y < actual.height(); ++y)
        for (int x = 0; x < actual.width(); ++x) {
            const bool off = isWrong(actual.pixel(x, y), expected.pixel(x, y));
            wrong += off ? 1 : 0;
            const int grey = qGray(actual.pixel(x, y)) / 4;
            difference.setPixel(x, y, off ? qRgb(255, 0, 0) : qRgb(grey, grey, grey));
        }
    return difference;
}

// Where golden pictures are, and where those that failed go.
struct GoldenFolders {
    QString golden;
    QString failed;
    bool write = false; // replaces golden pictures instead of comparing with them
};

// Empty if the picture is as it should be; else what is wrong with it, and where it can be seen.
inline QString compareWithGolden(const QImage& actual, const QString& name, const GoldenFolders& folders) {
    const QString path = QDir(folders.golden).filePath(name + QStringLiteral(".png"));
    const auto save = [](const QImage& image, const QString& file) {
        return QDir().mkpath(QFileInfo(file).path()) && image.save(file);
    };
    if (folders.write)
        return save(actual.convertToFormat(QImage::Format_RGB888), path)
                   ? QString()
                   : QStringLiteral("%1 cannot be written").arg(path);
    const QString actualPath = QDir(folders.failed).filePath(name + QStringLiteral("_actual.png"));
    const auto fail = [&](const QString& reason) {
        save(actual, actualPath);
        return QStringLiteral("%1: %2; the picture is in %3").arg(name, reason, folders.failed);
    };
    const QImage expected(path);
    if (expected.isNull())
        return fail(
            QStringLiteral("there is no golden picture %1 (CLOTHLAB_WRITE_GOLDEN=1 writes it)").arg(path));
    if (expected.size() != actual.size())
        return fail(QStringLiteral("%1 by %2 pixels instead of %3 by %4")
                        .arg(actual.width())
                        .arg(actual.height())
                        .arg(expected.width())
                        .arg(expected.height()));
    int wrong = 0;
    const QImage difference = differenceOf(actual, expected, wrong);
    const double part = double(wrong) / (actual.width() * actual.height());
    if (part <= kWrongPart)
        return {};
    save(difference, QDir(folders.failed).filePath(name + QStringLiteral("_difference.png")));
    return fail(QStringLiteral("%1 of %2 pixels are off by more than %3")
                    .arg(wrong)
                    .arg(actual.width() * actual.height())
                    .arg(kChannelTolerance));
}

} // namespace clothlab::render
