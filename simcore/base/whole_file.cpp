#include "simcore/base/whole_file.h"

#include "simcore/base/posix_file.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <exception>
#include <ostream>
#include <streambuf>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace clothlab {
namespace {

// Writes to a file descriptor and remembers the first error.
class DescriptorBuffer : public std::streambuf {
public:
    explicit DescriptorBuffer(int fd) : m_fd(fd) { setp(m_buffer.data(), m_buffer.data() + m_buffer.size()); }
    int error() const { return m_error; }

protected:
    int_type overflow(int_type c) override {
        if (!drain())
            return traits_type::eof();
        if (!traits_type::eq_int_type(c, traits_type::eof()))
            sputc(traits_type::to_char_type(c));
        return traits_type::not_eof(c);
    }
    int sync() override { return drain() ? 0 : -1; }

private:
    bool drain() {
        const char* from = pbase();
        while (m_error == 0 && from < pptr()) {
            const auto count = static_cast<std::size_t>(pptr() - from);
            const ssize_t written = withoutInterruption([&] { return ::write(m_fd, from, count); });
            if (written < 0)
                m_error = errno;
            else
                from += written;
        }
        setp(m_buffer.data(), m_buffer.data() + m_buffer.size());
        return m_error == 0;
    }

    int m_fd;
    int m_error = 0;
    std::array<char, 1 << 16> m_buffer{};
};

std::string folderOf(const std::string& path) {
    const std::size_t slash = path.rfind('/');
    return slash == std::string::npos ? "." : path.substr(0, slash + 1);
}

// Where the symbolic links of the last part of path lead, whether or not there is a file yet.
// Writes the system's error number.
std::string followLinks(std::string path, int& error) {
    constexpr int kMaxLinks = 40; // as the Linux kernel
    for (int i = 0; i < kMaxLinks; ++i) {
        struct stat info {};
        if (::lstat(path.c_str(), &info) != 0 || !S_ISLNK(info.st_mode))
            return path;
        std::string target(4096, '\0');
        const ssize_t length = ::readlink(path.c_str(), target.data(), target.size());
        if (length < 0) {
            error = errno;
            return path;
        }
        target.resize(static_cast<std::size_t>(length));
        path = target.starts_with('/') ? target : folderOf(path) + "/" + target;
    }
    error = ELOOP;
    return path;
}

// A new file in a folder, gone again unless it is renamed.
class TemporaryFile {
public:
    // Opened for writing; get() is negative if that failed, with the reason in errno.
    TemporaryFile(const std::string& folder, mode_t mode) : m_file(create(folder, mode)) {}
    ~TemporaryFile() {
        if (!m_path.empty())
            ::unlink(m_path.c_str());
    }
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    int get() const { return m_file.get(); }
    const std::string& path() const { return m_path; }

    bool renameTo(const std::string& path) {
        // Without fsync a crash soon after could leave the new name with nothing in it.
        if (withoutInterruption([&] { return ::fsync(get()); }) != 0 || !m_file.close())
            return false;
        if (::rename(m_path.c_str(), path.c_str()) != 0)
            return false;
        m_path.clear();
        return true;
    }

private:
    int create(const std::string& folder, mode_t mode) {
        static std::atomic<unsigned> counter{0};
        constexpr int kAttempts = 1000; // leftovers of crashed programs with the same process number
        for (int i = 0; i < kAttempts; ++i) {
            m_path = folder + "/.clothlab-" + std::to_string(::getpid()) + "-" + std::to_string(counter++) +
                     ".tmp";
            const int fd = withoutInterruption(
                [&] { return ::open(m_path.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, mode); });
            if (fd >= 0)
                return fd;
            if (errno != EEXIST)
                break;
        }
        const int error = errno;
        m_path.clear(); // it is not ours to remove
        errno = error;
        return -1;
    }

    std::string m_path; // before m_file, whose initialisation sets it
    FileDescriptor m_file;
};

std::optional<std::string> troubleOf(const DescriptorBuffer& buffer, const std::ostream& out) {
    if (buffer.error() != 0)
        return sentence(describe(buffer.error()));
    if (!out)
        return "its content could not be made; try again";
    return std::nullopt;
}

bool writeAt(int fd, const char* from, std::size_t count, off_t offset) {
    while (count > 0) {
        const ssize_t written = withoutInterruption([&] { return ::pwrite(fd, from, count, offset); });
        if (written < 0)
            return false;
        from += written;
        count -= static_cast<std::size_t>(written);
        offset += written;
    }
    return true;
}

// Moves what is from `from` to the end of the file to `to`, before it, and ends the file there.
bool moveUp(int fd, off_t from, off_t to) {
    std::string block(std::size_t(1) << 20U, '\0');
    for (;;) {
        const ssize_t got =
            withoutInterruption([&] { return ::pread(fd, block.data(), block.size(), from); });
        if (got <= 0)
            return got == 0 && ::ftruncate(fd, to) == 0 && ::lseek(fd, to, SEEK_SET) == to;
        if (!writeAt(fd, block.data(), static_cast<std::size_t>(got), to))
            return false;
        from += got;
        to += got;
    }
}

// Where a file is to be written, and what is there now.
struct Place {
    std::string target; // behind all links
    bool exists = false;
    struct stat old {};
};

std::optional<std::string> findPlace(const std::string& path, Place& place) {
    if (!isUsableName(path))
        return sentence(describeUnusableName());
    int error = 0;
    place.target = followLinks(path, error);
    if (error != 0)
        return sentence(describe(error));
    place.exists = ::stat(place.target.c_str(), &place.old) == 0;
    if (place.exists && !S_ISREG(place.old.st_mode))
        return sentence(describeKind(place.old.st_mode));
    // Renaming would replace a file that its owner has protected from writing.
    if (place.exists && ::access(place.target.c_str(), W_OK) != 0)
        return sentence(describe(errno));
    return std::nullopt;
}

std::optional<std::string> replaceFile(const std::string& path,
                                       const std::function<void(std::ostream&)>& write) {
    WholeFile file;
    if (auto trouble = file.open(path))
        return trouble;
    write(file.out());
    return file.finish();
}

} // namespace

struct WholeFile::Open {
    explicit Open(Place p)
        : place(std::move(p)), file(folderOf(place.target), place.exists ? 0600 : 0666), buffer(file.get()) {}

    Place place;
    TemporaryFile file;
    DescriptorBuffer buffer;
    std::ostream out{&buffer};
};

WholeFile::WholeFile() = default;
WholeFile::~WholeFile() = default;

std::optional<std::string> WholeFile::open(const std::string& path) {
    m_file.reset();
    Place place;
    if (auto trouble = findPlace(path, place))
        return trouble;
    auto file = std::make_unique<Open>(std::move(place));
    if (file->file.get() < 0)
        return sentence(describe(errno));
    m_file = std::move(file);
    return std::nullopt;
}

std::ostream& WholeFile::out() {
    return m_file->out;
}

const std::string& WholeFile::temporaryPath() const {
    return m_file->file.path();
}

std::optional<std::string> WholeFile::trouble() const {
    return troubleOf(m_file->buffer, m_file->out);
}

std::optional<std::string> WholeFile::skip(std::uint64_t count) {
    m_file->out.flush();
    if (auto before = trouble())
        return before;
    const off_t end = ::lseek(m_file->file.get(), static_cast<off_t>(count), SEEK_CUR);
    if (end < 0 || ::ftruncate(m_file->file.get(), end) != 0)
        return sentence(describe(errno));
    return std::nullopt;
}

std::optional<std::string> WholeFile::replace(std::uint64_t offset, std::string_view bytes) {
    m_file->out.flush();
    if (auto before = trouble())
        return before;
    if (!writeAt(m_file->file.get(), bytes.data(), bytes.size(), static_cast<off_t>(offset)))
        return sentence(describe(errno));
    return std::nullopt;
}

std::optional<std::string> WholeFile::remove(std::uint64_t offset, std::uint64_t count) {
    m_file->out.flush();
    if (auto before = trouble())
        return before;
    if (count > 0 &&
        !moveUp(m_file->file.get(), static_cast<off_t>(offset + count), static_cast<off_t>(offset)))
        return sentence(describe(errno));
    return std::nullopt;
}

std::optional<std::string> WholeFile::finish() {
    const std::unique_ptr<Open> open = std::move(m_file); // gone in any case
    open->out.flush();
    if (auto trouble = troubleOf(open->buffer, open->out))
        return trouble;
    const Place& place = open->place;
    if (place.exists) {
        // Only a privileged user can give a file away; to others the file becomes theirs.
        [[maybe_unused]] const int owner = ::fchown(open->file.get(), place.old.st_uid, place.old.st_gid);
        if (::fchmod(open->file.get(), place.old.st_mode & 07777) != 0)
            return sentence(describe(errno));
    }
    if (!open->file.renameTo(place.target))
        return sentence(describe(errno));

    // The file is complete either way; this only makes the rename outlast a loss of power.
    const FileDescriptor folder(::open(folderOf(place.target).c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (folder.get() >= 0)
        ::fsync(folder.get());
    return std::nullopt;
}

std::optional<std::string> writeFileWhole(const std::string& path,
                                          const std::function<void(std::ostream&)>& write) {
    try {
        return replaceFile(path, write);
    } catch (const std::exception& e) {
        return std::string("its content could not be made (") + e.what() + "); try again";
    } catch (...) {
        return "its content could not be made; try again";
    }
}

} // namespace clothlab
