#include "simcore/base/read_file.h"

#include "simcore/base/posix_file.h"

#include <algorithm>
#include <cerrno>
#include <exception>
#include <utility>

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

namespace clothlab {
namespace {

FileText unreadableFile(std::string message, std::string remedy) {
    return {std::nullopt, {{Severity::Error, "", std::move(message), std::move(remedy)}}};
}

FileText unreadableFile(const Words& words) {
    return unreadableFile(words.message, words.remedy);
}

FileText tooLarge(std::uint64_t maxBytes) {
    return unreadableFile("is larger than the " + std::to_string(maxBytes) + " bytes that are read at most",
                          "check that it is the right file, or make it smaller");
}

// The size a file states is only a hint: it may grow, and some files state 0.
FileText readAll(int fd, std::uint64_t statedSize, std::uint64_t maxBytes) {
    std::string text;
    std::size_t used = 0;
    text.resize(static_cast<std::size_t>(statedSize) + 1);
    for (;;) {
        if (used == text.size())
            text.resize(static_cast<std::size_t>(std::min<std::uint64_t>(2 * used + 4096, maxBytes + 1)));
        const ssize_t got = withoutInterruption([&] { return ::read(fd, &text[used], text.size() - used); });
        if (got < 0)
            return unreadableFile(describe(errno));
        if (got == 0)
            break;
        used += static_cast<std::size_t>(got);
        if (used > maxBytes)
            return tooLarge(maxBytes);
    }
    text.resize(used);
    return {std::move(text), {}};
}

FileText readRegularFile(const std::string& path, std::uint64_t maxBytes) {
    struct stat info {};
    // Before it is opened, as opening a device can already do something.
    if (::stat(path.c_str(), &info) != 0)
        return unreadableFile(describe(errno));
    if (!S_ISREG(info.st_mode))
        return unreadableFile(describeKind(info.st_mode));

    // The file may have been replaced since, so opening must not block and its kind is asked again.
    FileDescriptor file(withoutInterruption(
        [&] { return ::open(path.c_str(), O_RDONLY | O_NONBLOCK | O_NOCTTY | O_CLOEXEC); }));
    if (file.get() < 0 || ::fstat(file.get(), &info) != 0)
        return unreadableFile(describe(errno));
    if (!S_ISREG(info.st_mode))
        return unreadableFile(describeKind(info.st_mode));
    const auto size = static_cast<std::uint64_t>(std::max<off_t>(info.st_size, 0));
    return size > maxBytes ? tooLarge(maxBytes) : readAll(file.get(), size, maxBytes);
}

} // namespace

FileText readFile(const std::string& path, std::uint64_t maxBytes) {
    if (!isUsableName(path))
        return unreadableFile(describeUnusableName());
    try {
        return readRegularFile(path, maxBytes);
    } catch (const std::exception&) {
        return unreadableFile("does not fit into the memory",
                              "close other programs or make the file smaller");
    }
}

} // namespace clothlab
