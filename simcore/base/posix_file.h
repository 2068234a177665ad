// What all code shares that calls the operating system for files (POSIX): in this folder.
#pragma once

#include <cerrno>
#include <string>
#include <utility>

#include <sys/types.h>
#include <unistd.h>

namespace clothlab {

class FileDescriptor {
public:
    explicit FileDescriptor(int fd) : m_fd(fd) {}
    ~FileDescriptor() { close(); }
    FileDescriptor(const FileDescriptor&) = delete;
    FileDescriptor& operator=(const FileDescriptor&) = delete;

    int get() const { return m_fd; }
    int release() { return std::exchange(m_fd, -1); }
    bool close() {
        const int fd = std::exchange(m_fd, -1);
        return fd < 0 || ::close(fd) == 0;
    }

private:
    int m_fd;
};

template <typename Call>
auto withoutInterruption(Call call) {
    auto result = call();
    while (result < 0 && errno == EINTR)
        result = call();
    return result;
}

struct Words {
    std::string message;
    std::string remedy;
};

bool isUsableName(const std::string& path); // the system would take others for their first part
Words describeUnusableName();
Words describe(int error); // of errno
std::string sentence(const Words& words);
Words describeKind(mode_t mode); // of what is no regular file

} // namespace clothlab
