// Takes put together from chunks, in the order in which those were written.
#pragma once

#include "simcore/recording/chunk_walk.h"
#include "simcore/recording/take_file.h"

#include <map>
#include <set>

namespace clothlab {

// Collects what chunks say, then makes of it what TakeFileContents promises, and says what is left out.
class TakeAssembly {
public:
    explicit TakeAssembly(std::shared_ptr<const SharedFile> file) : m_file(std::move(file)) {}

    void add(const FoundChunk& chunk);
    TakeFileContents finish(Diagnostics& diagnostics);

    // "after frame 239 of take 'Take 1'", of the frames that were added last; empty if there are none.
    std::string lastFrameAdded() const;

private:
    struct Loose {
        TakeInfo info;
        bool named = false; // there was a chunk for it
        bool removed = false;
        std::vector<FrameGroup> groups; // as they came
        std::vector<Checkpoint> checkpoints;
    };
    void addScene(const SceneHead& head);
    void warn(std::string message, std::string remedy = {});

    void putInOrder(Loose& take);
    int goodFrames(const FrameGroup& group, std::shared_ptr<const Scene>& sheet);
    void cutAtGap(Loose& take, std::shared_ptr<const Scene> sheet);
    void keepCheckpoints(Loose& take);
    static int endOf(const Loose& take) {
        return take.groups.empty() ? take.info.firstOwnFrame() : take.groups.back().end();
    }
    bool isWhole(Loose& take);
    void settle(TakeId id);
    void keep(Loose& take, TakeFileContents& contents) const;
    void checkMeta(TakeFileContents& contents);

    std::shared_ptr<const SharedFile> m_file;
    std::map<TakeId, Loose> m_takes;
    std::map<TakeId, bool> m_settled;                         // whether it is to be had
    std::map<TakeId, std::shared_ptr<const Scene>> m_sheetOf; // a scene of the take
    std::vector<TakeId> m_order;                              // parents first
    SceneMap m_scenes;
    std::optional<TakeMeta> m_meta;
    TakeId m_lastTake = 0;
    int m_lastFrame = -1;
    Diagnostics m_diagnostics;
};

} // namespace clothlab
