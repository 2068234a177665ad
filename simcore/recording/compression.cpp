#include "simcore/recording/compression.h"

#include <memory>

#include <zstd.h>

namespace clothlab {
namespace {

struct FreeCompressor {
    void operator()(ZSTD_CCtx* context) const { ZSTD_freeCCtx(context); }
};
struct FreeDecompressor {
    void operator()(ZSTD_DCtx* context) const { ZSTD_freeDCtx(context); }
};

// The few chance repetitions that a search would find cost more than they save, and spoil the frequencies:
// only long ones count, and little is looked for.
ZSTD_CCtx* compressor() {
    thread_local const std::unique_ptr<ZSTD_CCtx, FreeCompressor> context = [] {
        std::unique_ptr<ZSTD_CCtx, FreeCompressor> made(ZSTD_createCCtx());
        if (!made)
            throw std::bad_alloc();
        ZSTD_CCtx_setParameter(made.get(), ZSTD_c_compressionLevel, 1);
        ZSTD_CCtx_setParameter(made.get(), ZSTD_c_minMatch, 7);
        ZSTD_CCtx_setParameter(made.get(), ZSTD_c_hashLog, 6);
        ZSTD_CCtx_setParameter(made.get(), ZSTD_c_contentSizeFlag, 0);
        return made;
    }();
    return context.get();
}

ZSTD_DCtx* decompressor() {
    thread_local const std::unique_ptr<ZSTD_DCtx, FreeDecompressor> context = [] {
        std::unique_ptr<ZSTD_DCtx, FreeDecompressor> made(ZSTD_createDCtx());
        if (!made)
            throw std::bad_alloc();
        return made;
    }();
    return context.get();
}

constexpr int kTextLevel = 6;

} // namespace

void appendCompressed(std::string& out, std::string_view bytes) {
    const std::size_t begin = out.size();
    out.resize(begin + ZSTD_compressBound(bytes.size()));
    const std::size_t size =
        ZSTD_compress2(compressor(), &out[begin], out.size() - begin, bytes.data(), bytes.size());
    out.resize(begin + (ZSTD_isError(size) != 0 ? 0 : size));
}

bool decompress(std::string_view compressed, char* to, std::size_t count) {
    const std::size_t size =
        ZSTD_decompressDCtx(decompressor(), to, count, compressed.data(), compressed.size());
    return ZSTD_isError(size) == 0 && size == count;
}

std::string compressedText(std::string_view text) {
    std::string out(ZSTD_compressBound(text.size()), '\0');
    const std::size_t size = ZSTD_compress(out.data(), out.size(), text.data(), text.size(), kTextLevel);
    out.resize(ZSTD_isError(size) != 0 ? 0 : size);
    return out;
}

bool decompressText(std::string_view compressed, std::size_t most, std::string& text) {
    const unsigned long long stated = ZSTD_getFrameContentSize(compressed.data(), compressed.size());
    if (stated > most) // unknown and wrong sizes are huge
        return false;
    text.resize(std::size_t(stated));
    return decompress(compressed, text.data(), text.size());
}

} // namespace clothlab
