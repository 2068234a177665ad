#include "simcore/recording/take_assembly.h"

#include "simcore/scene/scene_io.h"

#include <algorithm>

namespace clothlab {
namespace {

std::string quotedName(const TakeInfo& info) {
    return "take '" + (info.name.empty() ? std::to_string(info.id) : info.name) + "'";
}

std::string frames(int count) {
    return std::to_string(count) + (count == 1 ? " frame" : " frames");
}

} // namespace

void TakeAssembly::warn(std::string message, std::string remedy) {
    m_diagnostics.push_back({Severity::Warning, "", std::move(message), std::move(remedy)});
}

void TakeAssembly::addScene(const SceneHead& head) {
    SceneReading reading = readScene(head.json);
    for (Diagnostic& problem : reading.diagnostics)
        if (problem.severity == Severity::Error) {
            problem.severity = Severity::Warning;
            problem.place =
                "scene " + std::to_string(head.id) + (problem.place.empty() ? "" : ": ") + problem.place;
            m_diagnostics.push_back(std::move(problem));
        }
    if (reading.scene)
        m_scenes.emplace(head.id, std::make_shared<const Scene>(std::move(*reading.scene)));
}

void TakeAssembly::add(const FoundChunk& chunk) {
    const auto payload = [&] {
        return std::make_shared<Payload>(m_file, chunk.payloadAt, chunk.payloadLength);
    };
    bool good = true;
    if (chunk.type == ChunkType::Scene) {
        const auto scene = readSceneHead(chunk.head);
        good = scene.has_value();
        if (scene)
            addScene(*scene);
    } else if (chunk.type == ChunkType::Take) {
        const auto head = readTakeHead(chunk.head);
        good = head.has_value();
        if (head) {
            Loose& take = m_takes[head->info.id];
            take.info = head->info;
            take.named = true;
            take.removed = head->removed;
        }
    } else if (chunk.type == ChunkType::Frames) {
        auto group = readFramesHead(chunk.head, chunk.payloadLength);
        good = group.has_value();
        if (group) {
            group->payload = payload();
            m_lastTake = group->take;
            m_lastFrame = group->end() - 1;
            m_takes[group->take].info.id = group->take;
            m_takes[group->take].groups.push_back(std::move(*group));
        }
    } else if (chunk.type == ChunkType::Checkpoint) {
        auto checkpoint = readCheckpointHead(chunk.head, chunk.payloadLength);
        good = checkpoint.has_value();
        if (checkpoint) {
            checkpoint->payload = payload();
            m_takes[checkpoint->take].info.id = checkpoint->take;
            m_takes[checkpoint->take].checkpoints.push_back(std::move(*checkpoint));
        }
    } else if (chunk.type == ChunkType::Meta) {
        auto meta = readMeta(chunk.head);
        good = meta.has_value();
        if (meta)
            m_meta = std::move(meta);
    } // other types are the index, and those of versions to come that this one may ignore
    if (!good)
        warn("the chunk at byte " + std::to_string(chunk.at) + " is not what its type says; it was left out");
}

std::string TakeAssembly::lastFrameAdded() const {
    const auto take = m_takes.find(m_lastTake);
    if (take == m_takes.end() || m_lastFrame < 0)
        return {};
    return "after frame " + std::to_string(m_lastFrame) + " of " + quotedName(take->second.info);
}

// Of two groups with the same first frame the later one counts; where a group reaches into the next, the
// next.
void TakeAssembly::putInOrder(Loose& take) {
    std::stable_sort(take.groups.begin(), take.groups.end(),
                     [](const FrameGroup& a, const FrameGroup& b) { return a.first < b.first; });
    std::vector<FrameGroup> kept;
    for (FrameGroup& group : take.groups) {
        if (!kept.empty() && kept.back().first == group.first)
            kept.back() = std::move(group);
        else
            kept.push_back(std::move(group));
    }
    for (std::size_t i = 0; i + 1 < kept.size(); ++i)
        if (kept[i].end() > kept[i + 1].first)
            trimGroup(kept[i], kept[i + 1].first - kept[i].first);
    take.groups = std::move(kept);
}

// How many of its frames name a scene that is there, of the same sheet. sheet: any scene of the take so far.
int TakeAssembly::goodFrames(const FrameGroup& group, std::shared_ptr<const Scene>& sheet) {
    int good = 0;
    for (const FrameEntry& entry : group.frames) {
        const auto scene = m_scenes.find(entry.scene);
        if (scene == m_scenes.end() || gridOf(scene->second->cloth) != group.grid)
            break;
        if (sheet && sheet != scene->second && compareScenes(*sheet, *scene->second) == SceneChange::Start)
            break;
        sheet = scene->second;
        ++good;
    }
    return good;
}

void TakeAssembly::cutAtGap(Loose& take, std::shared_ptr<const Scene> sheet) {
    int next = take.info.firstOwnFrame();
    std::size_t kept = 0;
    int lost = 0;
    for (; kept < take.groups.size() && take.groups[kept].first == next; ++kept) {
        FrameGroup& group = take.groups[kept];
        const int good = goodFrames(group, sheet);
        if (good == 0)
            break;
        next += good;
        if (good < int(group.frames.size())) {
            lost += int(group.frames.size()) - good;
            trimGroup(group, good);
            ++kept;
            break;
        }
    }
    for (std::size_t i = kept; i < take.groups.size(); ++i)
        lost += int(take.groups[i].frames.size());
    take.groups.resize(kept);
    m_sheetOf[take.info.id] = sheet;
    if (lost > 0)
        warn("frame " + std::to_string(next) + " of " + quotedName(take.info) + " is missing or damaged; " +
                 frames(lost) + " after it were left out",
             "what is before it was opened");
}

void TakeAssembly::keepCheckpoints(Loose& take) {
    const int end = endOf(take);
    std::map<int, Checkpoint> kept; // the last of each frame
    const auto sheet = m_sheetOf[take.info.id];
    for (Checkpoint& checkpoint : take.checkpoints)
        if (checkpoint.frame >= take.info.firstOwnFrame() && checkpoint.frame < end && sheet &&
            gridOf(sheet->cloth) == checkpoint.grid)
            kept[checkpoint.frame] = std::move(checkpoint);
    take.checkpoints.clear();
    for (auto& [frame, checkpoint] : kept)
        take.checkpoints.push_back(std::move(checkpoint));
}

// Its parent is settled already, if it is there.
bool TakeAssembly::isWhole(Loose& take) {
    putInOrder(take);
    if (take.info.parent == 0) {
        cutAtGap(take, nullptr);
        if (take.groups.empty())
            warn(quotedName(take.info) + " has lost its first frame; it was left out");
        return !take.groups.empty();
    }
    const auto parent = m_takes.find(take.info.parent);
    const bool parentIsThere = parent != m_takes.end() && m_settled[take.info.parent];
    if (!parentIsThere || take.info.branchFrame >= endOf(parent->second)) {
        warn(quotedName(take.info) + " branches off a frame that is not there; it was left out");
        return false;
    }
    cutAtGap(take, m_sheetOf[take.info.parent]);
    return true;
}

// The take and, before it, those it descends from. Takes that descend from themselves are not there.
void TakeAssembly::settle(TakeId id) {
    std::vector<TakeId> line;
    std::set<TakeId> seen;
    for (auto take = m_takes.find(id);
         take != m_takes.end() && !m_settled.contains(take->first) && seen.insert(take->first).second;
         take = m_takes.find(take->second.info.parent))
        line.push_back(take->first);
    std::reverse(line.begin(), line.end());
    for (const TakeId number : line) {
        Loose& take = m_takes[number];
        const bool whole = !take.removed && isWhole(take);
        m_settled[number] = whole;
        if (!whole)
            continue;
        keepCheckpoints(take);
        m_order.push_back(number);
    }
}

void TakeAssembly::keep(Loose& take, TakeFileContents& contents) const {
    for (const FrameGroup& group : take.groups)
        for (const FrameEntry& entry : group.frames)
            contents.scenes.insert(*m_scenes.find(entry.scene));
    contents.takes.push_back({take.info, std::move(take.groups), std::move(take.checkpoints)});
}

// A marker or a range must not name what is not there.
void TakeAssembly::checkMeta(TakeFileContents& contents) {
    TakeMeta& meta = contents.meta;
    const auto endOf = [&](TakeId id) {
        const RecordedTake* take = findTake(contents, id);
        return take == nullptr ? 0 : take->end();
    };
    if (endOf(meta.activeTake) == 0)
        meta.activeTake = contents.takes.empty() ? 0 : contents.takes.front().info.id;
    meta.shownFrame = std::clamp(meta.shownFrame, 0, std::max(0, endOf(meta.activeTake) - 1));
    const std::size_t markers = meta.markers.size();
    std::erase_if(meta.markers, [&](const FrameMarker& m) { return m.frame >= endOf(m.take); });
    if (const std::size_t lost = markers - meta.markers.size(); lost > 0)
        warn(std::to_string(lost) + (lost == 1 ? " marker" : " markers") +
             " of frames that are not there were left out");
    std::erase_if(meta.ranges, [&](const PlayRange& r) { return r.in >= endOf(r.take); });
    for (PlayRange& range : meta.ranges)
        if (range.out != kOpenEnd)
            range.out = std::min(range.out, endOf(range.take) - 1);
}

TakeFileContents TakeAssembly::finish(Diagnostics& diagnostics) {
    // Frames tell where a take begins even if nothing else does.
    for (auto& [id, take] : m_takes)
        if (!take.named && !take.removed)
            warn("take " + std::to_string(id) +
                 " has lost its name and where it branched off; it counts as one of its own");
    for (auto& [id, take] : m_takes)
        settle(id);
    TakeFileContents contents;
    for (const TakeId id : m_order)
        keep(m_takes[id], contents);
    contents.meta = m_meta.value_or(TakeMeta());
    if (const auto own = m_scenes.find(contents.meta.scene); own != m_scenes.end())
        contents.scenes.insert(*own); // which may not have been run yet
    else
        contents.meta.scene = 0;
    checkMeta(contents);
    diagnostics.insert(diagnostics.end(), m_diagnostics.begin(), m_diagnostics.end());
    return contents;
}

} // namespace clothlab
