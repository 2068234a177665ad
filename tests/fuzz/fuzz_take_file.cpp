// libFuzzer. New inputs go to the first folder: fuzz_take_file /tmp/found tests/fuzz/corpus_take
#include "tests/support/take_file_invariants.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

#include <sys/mman.h>
#include <unistd.h>

// A file in memory, as readTakeFile() wants one with a name.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const int file = memfd_create("take", 0);
    static const std::string path = "/proc/self/fd/" + std::to_string(file);
    const std::string bytes = clothlab::test::withRightChecksums({reinterpret_cast<const char*>(data), size});
    if (ftruncate(file, 0) != 0 || pwrite(file, bytes.data(), size, 0) != ssize_t(size))
        return 0;
    const std::string broken = clothlab::test::brokenTakeFileInvariant(clothlab::readTakeFile(path));
    if (!broken.empty()) {
        std::fprintf(stderr, "%s\n", broken.c_str());
        std::abort();
    }
    return 0;
}
