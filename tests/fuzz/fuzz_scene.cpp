// libFuzzer. New inputs go to the first folder: fuzz_scene /tmp/found tests/fuzz/corpus_scene
#include "tests/support/scene_invariants.h"

#include <cstdint>
#include <cstdio>
#include <cstdlib>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string broken = clothlab::test::brokenInvariant({reinterpret_cast<const char*>(data), size});
    if (!broken.empty()) {
        std::fprintf(stderr, "%s\n", broken.c_str());
        std::abort();
    }
    return 0;
}
