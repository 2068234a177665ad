#include "simcore/recording/take.h"

#include <cassert>
#include <utility>

namespace clothlab {

Take::Take(TakeId id, std::string name, FramePointer start)
    : m_id(id), m_name(std::move(name)),
      m_sheet(std::make_shared<const Sheet>(Sheet{gridOf(start->scene->cloth), start->state.position})) {
    RecordedFrame first;
    first.scene = start->scene;
    first.exact = std::move(start);
    append(std::move(first));
}

Take::Take(TakeId id, std::string name, std::shared_ptr<Take> parent, int branchFrame)
    : m_id(id), m_name(std::move(name)), m_parent(std::move(parent)), m_sheet(m_parent->m_sheet),
      m_firstOwn(branchFrame + 1) {
    assert(branchFrame >= m_parent->m_firstOwn && branchFrame < m_parent->frameCount());
}

const RecordedFrame& Take::frame(int index) const {
    assert(index >= 0 && index < frameCount());
    const Take* owner = this;
    while (index < owner->m_firstOwn)
        owner = owner->m_parent.get();
    return owner->m_own[std::size_t(index - owner->m_firstOwn)];
}

RecordedFrame& Take::frame(int index) {
    return const_cast<RecordedFrame&>(std::as_const(*this).frame(index));
}

TakePointer ownerOf(TakePointer take, int frame) {
    while (frame <= take->branchFrame())
        take = take->parent();
    return take;
}

FramePointer exactFrame(const RecordedFrame& recorded) {
    if (recorded.exact || !recorded.checkpoint)
        return recorded.exact;
    std::optional<ClothState> state = stateOf(*recorded.checkpoint);
    if (!state)
        return nullptr;
    Frame frame;
    frame.state = std::move(*state);
    frame.scene = recorded.scene;
    frame.time = recorded.time;
    return std::make_shared<const Frame>(std::move(frame));
}

const FrameFacts* factsOf(const Take& take, int frame) {
    const FrameGroup* group = take.frame(frame).group.get();
    return group ? &group->frames[std::size_t(frame - group->first)].facts : nullptr;
}

const std::shared_ptr<const Scene>& lastScene(const Take& take) {
    return take.frame(take.lastFrame()).scene;
}

} // namespace clothlab
