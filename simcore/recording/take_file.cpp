#include "simcore/recording/take_file.h"

#include "simcore/base/whole_file.h"
#include "simcore/recording/take_assembly.h"

#include <algorithm>
#include <exception>

namespace clothlab {
namespace {

TakeFileReading unreadable(std::string message, std::string remedy) {
    TakeFileReading reading;
    reading.diagnostics.push_back({Severity::Error, "", std::move(message), std::move(remedy)});
    return reading;
}

// Nothing if the file begins as a recording does.
std::optional<TakeFileReading> refuse(const SharedFile& file, std::uint32_t& version) {
    std::string header(std::size_t(std::min(file.size(), kFileHeaderBytes)), '\0');
    if (!file.read(0, header.data(), header.size()))
        return unreadable("the disk reports a fault", "check the disk and try again");
    switch (checkFileHeader(header, version)) {
    case FileHeaderCheck::Good:
        return std::nullopt;
    case FileHeaderCheck::TooShort:
        return unreadable("is cut off before its first frame", "there is nothing in it to open");
    case FileHeaderCheck::NoTakeFile:
        return unreadable("is no recording", "open a .clothtake file that ClothLab has saved");
    case FileHeaderCheck::Newer:
        return unreadable("is a recording of version " + std::to_string(version) + ", newer than version " +
                              std::to_string(kTakeFileVersion) + ", which this program reads",
                          "open it with a newer ClothLab");
    case FileHeaderCheck::Damaged:
        break;
    }
    return unreadable("has a damaged header", "open a copy of it");
}

void sayWhatIsMissing(const ChunkWalk& walk, std::uint64_t size, const TakeAssembly& assembly,
                      Diagnostics& diagnostics) {
    const auto warn = [&](std::string message, std::string remedy) {
        diagnostics.push_back({Severity::Warning, "", std::move(message), std::move(remedy)});
    };
    for (const DamagedPart& part : walk.damaged)
        if (part.end < size)
            warn("the chunk at byte " + std::to_string(part.begin) + " is damaged",
                 "what is in it was left out");
    if (walk.finished)
        return;
    const std::string after = assembly.lastFrameAdded();
    warn("is cut off " + (after.empty() ? "before its first frame" : after), "what is there was opened");
}

TakeFileReading readFrom(const std::shared_ptr<const SharedFile>& file) {
    std::uint32_t version = 0;
    if (auto refused = refuse(*file, version)) {
        refused->bytes = file->size();
        refused->version = version;
        return std::move(*refused);
    }
    TakeFileReading reading;
    reading.bytes = file->size();
    reading.version = version;
    TakeAssembly assembly(file);
    const ChunkWalk walk = walkChunks(*file, [&](const FoundChunk& chunk) {
        if (chunk.type != ChunkType::Index)
            reading.chunks.push_back(chunk.at);
        assembly.add(chunk);
    });
    reading.finished = walk.finished;
    reading.end = walk.end;
    sayWhatIsMissing(walk, reading.bytes, assembly, reading.diagnostics);
    TakeFileContents contents = assembly.finish(reading.diagnostics);
    if (contents.takes.empty())
        reading.diagnostics.push_back(
            {Severity::Error, "", "holds no frame that can be opened", "open a copy of it"});
    else
        reading.contents = std::move(contents);
    return reading;
}

// Chunks into a file, with progress told and cancelling heeded.
class Saving {
public:
    Saving(WholeFile& file, const TakeFileContents& contents, const SaveProgress& progress)
        : m_file(file), m_writer(file.out()), m_progress(progress) {
        for (const RecordedTake& take : contents.takes) {
            for (const FrameGroup& group : take.groups)
                m_total += group.payload->length();
            for (const Checkpoint& checkpoint : take.checkpoints)
                m_total += checkpoint.payload->length();
        }
    }

    std::optional<std::string> save(const TakeFileContents& contents) {
        for (const auto& [id, scene] : contents.scenes)
            m_writer.add(sceneChunk(id, *scene));
        for (const RecordedTake& take : contents.takes)
            m_writer.add(takeChunk(take.info));
        m_writer.add(metaChunk(contents.meta));
        for (const RecordedTake& take : contents.takes) {
            for (const FrameGroup& group : take.groups)
                if (auto trouble = add(chunkOf(group), take.info, group.first))
                    return trouble;
            for (const Checkpoint& checkpoint : take.checkpoints)
                if (auto trouble = add(chunkOf(checkpoint), take.info, checkpoint.frame))
                    return trouble;
        }
        m_writer.finish();
        return std::nullopt;
    }

private:
    std::optional<std::string> add(const std::optional<Chunk>& chunk, const TakeInfo& take, int frame) {
        if (!chunk)
            return "frame " + std::to_string(frame) + " of take '" + take.name +
                   "' cannot be read back from the disk; delete the take or check the disk";
        m_writer.add(*chunk);
        if (auto trouble = m_file.trouble())
            return trouble;
        m_done += chunk->payload.size();
        if (m_progress && !m_progress(double(m_done) / double(std::max<std::uint64_t>(m_total, 1))))
            return "";
        return std::nullopt;
    }

    WholeFile& m_file;
    TakeFileWriter m_writer;
    const SaveProgress& m_progress;
    std::uint64_t m_done = 0, m_total = 0; // bytes of payloads
};

std::optional<std::string> writeTo(const std::string& path, const TakeFileContents& contents,
                                   const SaveProgress& progress) {
    WholeFile file;
    if (auto trouble = file.open(path))
        return trouble;
    if (auto trouble = Saving(file, contents, progress).save(contents))
        return trouble;
    return file.finish();
}

} // namespace

TakeFileReading readTakeFile(const std::string& path) {
    const SharedFile::Opening opening = SharedFile::open(path);
    if (!opening.file)
        return unreadable(opening.problem, {});
    try {
        return readFrom(opening.file);
    } catch (const std::exception&) {
        return unreadable("does not fit into the memory", "close other programs and try again");
    }
}

std::optional<std::string> writeTakeFile(const std::string& path, const TakeFileContents& contents,
                                         const SaveProgress& progress) {
    try {
        return writeTo(path, contents, progress);
    } catch (const std::exception& e) {
        return std::string("its content could not be made (") + e.what() + "); try again";
    }
}

const RecordedTake* findTake(const TakeFileContents& contents, TakeId take) {
    const auto found = std::find_if(contents.takes.begin(), contents.takes.end(),
                                    [&](const RecordedTake& t) { return t.info.id == take; });
    return found == contents.takes.end() ? nullptr : &*found;
}

const FrameGroup* findGroup(const TakeFileContents& contents, TakeId take, int frame) {
    const RecordedTake* owner = findTake(contents, take);
    while (owner != nullptr && frame < owner->info.firstOwnFrame())
        owner = findTake(contents, owner->info.parent);
    if (owner == nullptr)
        return nullptr;
    const auto after = std::upper_bound(owner->groups.begin(), owner->groups.end(), frame,
                                        [](int f, const FrameGroup& group) { return f < group.first; });
    if (after == owner->groups.begin() || !std::prev(after)->holds(frame))
        return nullptr;
    return &*std::prev(after);
}

} // namespace clothlab
