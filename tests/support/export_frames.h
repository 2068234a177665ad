// Frames to export, and a disk that fills up.
#pragma once

#include "simcore/recording/frame.h"

#include <string>
#include <vector>

#include <csignal>
#include <sys/resource.h>

namespace clothlab::test {

// Numbers of every size, so that a rounded one shows.
Frame sampleFrame(int nx = 5, int ny = 4);

// So many frames of a sheet, each with positions of its own, 1/90 s apart.
std::vector<FramePointer> sampleFrames(int count, int nx = 5, int ny = 4);

// The sheet that they are of.
Sheet sheetOf(const Frame& frame);

// While it lives, writing a file beyond so many bytes fails, whoever writes.
// While it lives, writing a file beyond so many bytes fails, whoever writes.
class FileSizeLimit {
public:
    explicit FileSizeLimit(rlim_t bytes) : m_handler(std::signal(SIGXFSZ, SIG_IGN)) {
        ::getrlimit(RLIMIT_FSIZE, &m_old);
        const rlimit limit{bytes, m_old.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileSizeLimit() {
        ::setrlimit(RLIMIT_FSIZE, &m_old);
        std::signal(SIGXFSZ, m_handler);
    }
    FileSizeLimit(const FileSizeLimit&) = delete;
    FileSizeLimit& operator=(const FileSizeLimit&) = delete;

private:
    void (*m_handler)(int);
    rlimit m_old{};
};

// Takes numbers out of the bytes of a file, one after the other. Past the end: fails, and zeros.
class ByteReader {
public:
    explicit ByteReader(std::string bytes, std::size_t at = 0) : m_bytes(std::move(bytes)), m_at(at) {}

    std::uint32_t little();
    std::uint32_t big();
    float littleFloat();
    float bigFloat();
    std::string text(std::size_t size);
    std::size_t at() const { return m_at; }
    bool failed() const { return m_failed; }
    bool atEnd() const { return m_at == m_bytes.size() && !m_failed; }

private:
    std::uint32_t byte();

    std::string m_bytes;
    std::size_t m_at;
    bool m_failed = false;
};

bool sameFloat(float a, float b); // to the last bit, where QCOMPARE lets pass what is nearly the same

std::string bytesOfFile(const std::string& path); // "(cannot be read)" if it cannot

} // namespace clothlab::test
