#include "simcore/recording/recording.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace clothlab {
namespace {

bool moveAlike(const Scene& a, const Scene& b) {
    return &a == &b || compareScenes(a, b) <= SceneChange::Appearance;
}

} // namespace

Recording::Recording(std::shared_ptr<const Scene> scene) {
    reset(std::move(scene));
}

void Recording::reset(std::shared_ptr<const Scene> scene) {
    m_takes.clear();
    m_all.clear();
    m_left.clear();
    m_kept.clear();
    m_lastId = 0;
    m_scene = std::move(scene);
    open(beginTake(), 0);
}

void Recording::load(std::vector<TakePointer> takes, const TakePointer& openTake) {
    m_takes = std::move(takes);
    m_all.clear();
    m_left.clear();
    m_kept.clear();
    m_lastId = 0;
    for (TakePointer take : m_takes)
        for (; take; take = take->parent()) {
            m_all[take->id()] = take;
            m_lastId = std::max(m_lastId, take->id());
        }
    m_scene = lastScene(*openTake);
    open(openTake, openTake->lastFrame());
}

void Recording::restart() {
    if (isEmpty(*m_open))
        std::erase(m_takes, m_open);
    open(beginTake(), 0);
}

TakePointer Recording::beginTake() {
    auto take = std::make_shared<Take>(++m_lastId, freeName(), startFrame(m_scene));
    list(take);
    return take;
}

void Recording::list(const TakePointer& take) {
    m_takes.push_back(take);
    m_all[take->id()] = take;
}

void Recording::open(const TakePointer& take, int frame) {
    m_open = take;
    m_shown = frame;
    m_firstStale = kNone;
    m_staleEdits.clear();
}

bool Recording::isEmpty(const Take& take) const {
    return take.frameCount() == 1;
}

std::string Recording::freeName() const {
    for (int number = 1;; ++number) {
        std::string name = "Take " + std::to_string(number);
        if (std::ranges::none_of(m_takes, [&](const TakePointer& take) { return take->name() == name; }))
            return name;
    }
}

Recording::Effect Recording::setScene(std::shared_ptr<const Scene> scene) {
    auto before = std::exchange(m_scene, std::move(scene));
    switch (compareScenes(*before, *m_scene)) {
    case SceneChange::Start:
        return changeStart();
    case SceneChange::Motion:
        return changeMotion(std::move(before));
    case SceneChange::Appearance:
    case SceneChange::None:
        break;
    }
    return Effect::None;
}

Recording::Effect Recording::changeStart() {
    if (isEmpty(*m_open))
        std::erase(m_takes, m_open);
    else
        m_left.push_back({m_open, m_shown});
    const auto sameStart = [&](const Left& left) {
        return isListed(*left.take) &&
               compareScenes(*left.take->frame(0).scene, *m_scene) != SceneChange::Start;
    };
    const auto back = std::find_if(m_left.rbegin(), m_left.rend(), sameStart);
    if (back == m_left.rend()) {
        open(beginTake(), 0);
        return Effect::OtherTake;
    }
    const Left left = *back;
    m_left.erase(std::prev(back.base()));
    open(left.take, left.frame);
    if (!moveAlike(*lastScene(*m_open), *m_scene))
        changeMotion(lastScene(*m_open));
    return Effect::OtherTake;
}

Recording::Effect Recording::changeMotion(std::shared_ptr<const Scene> before) {
    // Frames before the one shown stay what they are: how the run came to be here.
    const int candidate = std::min(firstStaleFrame(), m_shown + 1);
    const auto undone = std::ranges::find_if(
        m_staleEdits, [&](const StaleEdit& edit) { return moveAlike(*edit.before, *m_scene); });
    if (undone != m_staleEdits.end()) {
        m_firstStale = undone->firstStale;
        m_staleEdits.erase(undone, m_staleEdits.end());
    } else if (areComputedAs(*m_scene, candidate)) {
        m_firstStale = kNone;
    } else {
        if (candidate < firstStaleFrame())
            m_staleEdits.push_back({std::move(before), m_firstStale});
        m_firstStale = candidate;
    }
    return Effect::Staleness;
}

bool Recording::areComputedAs(const Scene& scene, int first) const {
    const Scene* checked = nullptr; // most frames share theirs with the one before
    for (int i = first; i < frameCount(); ++i) {
        const Scene* other = frame(i).scene.get();
        if (other != checked && !moveAlike(*other, scene))
            return false;
        checked = other;
    }
    return true;
}

int Recording::firstStaleFrame() const {
    return std::min(m_firstStale, frameCount());
}

const Scene& Recording::shownScene() const {
    const int next = m_shown + 1;
    if (next < frameCount() && next != m_firstStale)
        return *frame(next).scene;
    return isStale(m_shown) ? *frame(m_shown).scene : *m_scene;
}

bool Recording::append(FramePointer frame) {
    const int last = endOfRun();
    const bool branches = last < lastFrame();
    if (branches) {
        list(std::make_shared<Take>(++m_lastId, freeName(), ownerOf(m_open, last), last));
        open(m_takes.back(), std::min(m_shown, last));
    }
    m_firstStale = kNone;
    m_staleEdits.clear();
    RecordedFrame recorded;
    recorded.scene = frame->scene;
    recorded.time = frame->time;
    m_open->append(std::move(recorded));
    keep(m_open, lastFrame(), std::move(frame));
    return branches;
}

void Recording::keep(const TakePointer& take, int frame, FramePointer exact) {
    m_kept.keep(ownerOf(take, frame), frame, std::move(exact));
}

TakePointer Recording::findTake(TakeId id) const {
    const auto found = std::ranges::find(m_takes, id, [](const TakePointer& t) { return t->id(); });
    return found == m_takes.end() ? nullptr : *found;
}

TakePointer Recording::findAnyTake(TakeId id) const {
    const auto found = m_all.find(id);
    return found == m_all.end() ? nullptr : found->second.lock();
}

bool Recording::isListed(const Take& take) const {
    return findTake(take.id()) != nullptr;
}

TakePointer Recording::listedParent(const Take& take) const {
    TakePointer parent = take.parent();
    while (parent && !isListed(*parent))
        parent = parent->parent();
    return parent;
}

bool Recording::remove(const TakePointer& take) {
    return take != m_open && std::erase(m_takes, take) > 0;
}

void Recording::insert(const TakePointer& take) {
    if (isListed(*take))
        return;
    const auto place =
        std::ranges::lower_bound(m_takes, take->id(), {}, [](const TakePointer& t) { return t->id(); });
    m_takes.insert(place, take);
}

Recording::View Recording::view() const {
    return {m_open, m_scene, m_shown, m_firstStale, m_staleEdits};
}

Recording::View Recording::viewOf(const TakePointer& take) const {
    auto scene = std::make_shared<Scene>(*lastScene(*take));
    scene->appearance = m_scene->appearance;
    scene->camera = m_scene->camera;
    return {take, std::move(scene), std::min(m_shown, take->lastFrame()), kNone, {}};
}

void Recording::setView(View view) {
    insert(view.take);
    m_scene = std::move(view.scene);
    m_open = std::move(view.take);
    m_shown = view.frame;
    m_firstStale = view.firstStale;
    m_staleEdits = std::move(view.staleEdits);
}

} // namespace clothlab
