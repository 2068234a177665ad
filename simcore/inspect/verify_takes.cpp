#include "simcore/inspect/verify_takes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <set>

namespace clothlab {
namespace {

std::string hex(std::uint64_t hash) {
    std::array<char, 20> text{};
    std::snprintf(text.data(), text.size(), "%016llx", static_cast<unsigned long long>(hash));
    return text.data();
}

double greatestDifference(const PointArray& a, const PointArray& b) {
    double greatest = 0;
    for (const auto axis : {&PointArray::x, &PointArray::y, &PointArray::z})
        for (std::size_t i = 0; i < a.size(); ++i)
            greatest = std::max(greatest, std::abs((a.*axis)[i] - (b.*axis)[i]));
    return greatest;
}

// The state of a frame of a take, from which a branch goes on.
using BranchStates = std::map<std::pair<TakeId, int>, ClothState>;

class Verifier {
public:
    Verifier(const TakeFileContents& contents, const SolverSettings& settings, const std::atomic<bool>& stop)
        : m_contents(contents), m_settings(settings), m_stop(stop) {
        for (const RecordedTake& take : contents.takes)
            if (take.info.parent != 0)
                if (const FrameGroup* group = findGroup(contents, take.info.parent, take.info.branchFrame))
                    m_branchFrames.insert({group->take, take.info.branchFrame});
    }

    Verification run() {
        for (const RecordedTake& take : m_contents.takes)
            if (!m_stop)
                verify(take);
        m_result.stopped = m_stop;
        return std::move(m_result);
    }

private:
    // Where a take goes on from; nothing if that was not reached.
    std::optional<ClothState> startOf(const RecordedTake& take) {
        if (take.info.parent == 0)
            return startState(*sceneOf(take.groups.front().frames.front()));
        const FrameGroup* group = findGroup(m_contents, take.info.parent, take.info.branchFrame);
        const auto found =
            group == nullptr ? m_states.end() : m_states.find({group->take, take.info.branchFrame});
        if (found == m_states.end())
            return std::nullopt;
        return found->second;
    }

    std::shared_ptr<const Scene> sceneOf(const FrameEntry& entry) const {
        return m_contents.scenes.at(entry.scene);
    }

    void differ(const RecordedTake& take, int frame, std::string what) {
        m_result.differences.push_back({take.info.id, frame, std::move(what)});
        m_differs = true;
    }

    void verify(const RecordedTake& take) {
        m_differs = false;
        if (take.groups.empty())
            return;
        std::optional<ClothState> state = startOf(take);
        const int first = take.info.firstOwnFrame();
        if (!state)
            return differ(take, first, "the frame it branched off could not be run again");
        std::vector<const FrameEntry*> entries;
        std::vector<std::shared_ptr<const Scene>> scenes;
        for (const FrameGroup& group : take.groups)
            for (const FrameEntry& entry : group.frames) {
                entries.push_back(&entry);
                scenes.push_back(sceneOf(entry));
            }
        std::size_t begin = 0;
        if (take.info.parent == 0) {
            compare(take, first, *entries[0], *state, nullptr);
            begin = 1;
        }
        VerletSolver solver(*scenes.front(), m_settings);
        const RepeatResult repeated =
            repeatFrames(solver, *state, std::span(scenes).subspan(begin), m_stop,
                         [&](std::size_t i, const ClothState& now, const FrameResult& result) {
                             compare(take, first + int(begin + i), *entries[begin + i], now, &result);
                             return !m_differs || isNeeded(take, first + int(begin + i));
                         });
        if (repeated.last.blowUp && !m_differs)
            differ(take, first + int(begin + repeated.frames), "the run blows up here");
    }

    // Whether a frame after this one is still branched off from.
    bool isNeeded(const RecordedTake& take, int frame) const {
        return m_branchFrames.lower_bound({take.info.id, frame + 1}) !=
               m_branchFrames.lower_bound({take.info.id + 1, 0});
    }

    void compare(const RecordedTake& take, int frame, const FrameEntry& entry, const ClothState& state,
                 const FrameResult* result) {
        if (m_branchFrames.contains({take.info.id, frame}))
            m_states[{take.info.id, frame}] = state;
        if (m_differs)
            return;
        ++m_result.frames;
        if (const std::uint64_t hash = stateHash(state); hash != entry.facts.stateHash)
            return differ(take, frame,
                          "the recorded state has the hash " + hex(entry.facts.stateHash) +
                              ", that of the run " + hex(hash));
        if (result != nullptr && result->strainLimitCorrections != entry.facts.strainLimitCorrections)
            return differ(take, frame, "the number of strain limit corrections is another in the run");
        comparePositions(take, frame, state);
        if (!m_differs)
            compareCheckpoint(take, frame, state);
    }

    void comparePositions(const RecordedTake& take, int frame, const ClothState& state) {
        const FrameGroup& group = *findGroup(m_contents, take.info.id, frame);
        const auto positions = m_reader.positionsOf(group, frame);
        if (!positions)
            return differ(take, frame, "its positions cannot be read: they are damaged");
        const bool exact = group.error == 0 && *positions == state.position;
        if (!exact && !(greatestDifference(*positions, state.position) <= group.error))
            differ(take, frame, "its positions are not within the stated error of those of the run");
    }

    void compareCheckpoint(const RecordedTake& take, int frame, const ClothState& state) {
        for (const Checkpoint& checkpoint : take.checkpoints) {
            if (checkpoint.frame != frame)
                continue;
            const auto kept = stateOf(checkpoint);
            if (!kept)
                differ(take, frame, "its checkpoint cannot be read: it is damaged");
            else if (stateHash(*kept) != stateHash(state))
                differ(take, frame, "its checkpoint is not the state of the run");
        }
    }

    const TakeFileContents& m_contents;
    SolverSettings m_settings;
    const std::atomic<bool>& m_stop;
    std::set<std::pair<TakeId, int>> m_branchFrames; // of the takes that own them
    BranchStates m_states;
    GroupReader m_reader;
    Verification m_result;
    bool m_differs = false; // the take at hand
};

} // namespace

Verification verifyTakes(const TakeFileContents& contents, const SolverSettings& settings,
                         const std::atomic<bool>& stop) {
    return Verifier(contents, settings, stop).run();
}

} // namespace clothlab
