#include "simcore/base/shared_file.h"

#include "simcore/base/posix_file.h"

#include <limits>

#include <fcntl.h>
#include <sys/stat.h>

namespace clothlab {

SharedFile::~SharedFile() {
    ::close(m_fd);
}

SharedFile::Opening SharedFile::open(const std::string& path) {
    if (path.empty() || path.find('\0') != std::string::npos)
        return {nullptr, "is not a name of a file; give a name that is not empty and holds no zero byte"};
    // A pipe without a writer would keep us waiting.
    FileDescriptor fd(
        withoutInterruption([&] { return ::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK); }));
    if (fd.get() < 0)
        return {nullptr, sentence(describe(errno))};
    struct stat info {};
    if (::fstat(fd.get(), &info) != 0)
        return {nullptr, sentence(describe(errno))};
    if (!S_ISREG(info.st_mode))
        return {nullptr, sentence(describeKind(info.st_mode))};
    return {std::shared_ptr<const SharedFile>(new SharedFile(fd.release())), {}};
}

std::uint64_t SharedFile::size() const {
    struct stat info {};
    return ::fstat(m_fd, &info) == 0 && info.st_size > 0 ? std::uint64_t(info.st_size) : 0;
}

bool SharedFile::read(std::uint64_t offset, char* to, std::size_t count) const {
    if (offset > std::uint64_t(std::numeric_limits<off_t>::max()) - count)
        return false;
    while (count > 0) {
        const ssize_t got = withoutInterruption([&] { return ::pread(m_fd, to, count, off_t(offset)); });
        if (got <= 0)
            return false;
        to += got;
        offset += std::uint64_t(got);
        count -= std::size_t(got);
    }
    return true;
}

} // namespace clothlab
