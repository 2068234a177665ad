// A file that any number of threads read at any place, and that may grow meanwhile.
#pragma once

#include <cstdint>
#include <memory>
#include <string>

namespace clothlab {

class SharedFile {
public:
    // What is open, or what went wrong, in words: "there is no such file or folder; check …".
    struct Opening;
    static Opening open(const std::string& path);
    ~SharedFile();
    SharedFile(const SharedFile&) = delete;
    SharedFile& operator=(const SharedFile&) = delete;

    std::uint64_t size() const; // now; 0 if the system does not say
    // Exactly so many bytes from there. False if there are not as many, or the disk has a fault.
    bool read(std::uint64_t offset, char* to, std::size_t count) const;

private:
    explicit SharedFile(int fd) : m_fd(fd) {}
    int m_fd;
};

struct SharedFile::Opening {
    std::shared_ptr<const SharedFile> file; // null if it could not be opened
    std::string problem;
};

} // namespace clothlab
