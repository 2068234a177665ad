// Checksums: those that are published, and the same in pieces.
#include "simcore/base/checksum.h"

#include <QtTest>

#include <string>
#include <vector>

using namespace clothlab;

class TestChecksum : public QObject {
    Q_OBJECT

private slots:
    void isXxh3() { QCOMPARE(checksum(""), std::uint64_t(0x2D06800538D394C2U)); }
    void piecesAreTheSameAsTheWhole() {
        std::string bytes;
        for (int i = 0; i < 5000; ++i)
            bytes += static_cast<char>(i * i % 251);
        for (const std::size_t length : {1U, 17U, 200U, 241U, 5000U}) {
            const std::string_view part = std::string_view(bytes).substr(0, length);
            Checksum pieces;
            for (std::size_t at = 0; at < length; at += 7)
                pieces.add(part.substr(at, 7));
            QCOMPARE(pieces.value(), checksum(part));
        }
    }
    void numbersAreTheirBitsLittleEndian() {
        Checksum numbers;
        numbers.add(std::vector<double>{1.0, -2.0});
        const std::string bytes("\0\0\0\0\0\0\xF0\x3F\0\0\0\0\0\0\0\xC0", 16);
        QCOMPARE(numbers.value(), checksum(bytes));
    }
};

QTEST_APPLESS_MAIN(TestChecksum)
#include "tst_checksum.moc"
