#include "app/docks/frame_preview.h"

#include "app/picture/thumbnail.h"
#include "app/widgets/theme.h"

#include <QPainter>
#include <QScreen>

#include <algorithm>
#include <utility>

namespace clothlab {
namespace {

constexpr QSize kPicture{176, 110};
constexpr int kPadding = 6;
constexpr std::size_t kMostKept = 16;

} // namespace

FramePreview::FramePreview(Simulation& simulation, QWidget* parent)
    : QWidget(parent, Qt::ToolTip | Qt::FramelessWindowHint), m_simulation(simulation) {
    setObjectName("framePreview");
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_ShowWithoutActivating);
    setFocusPolicy(Qt::NoFocus);
    m_delay.setSingleShot(true);
    connect(&m_delay, &QTimer::timeout, this, &FramePreview::appear);
    connect(&simulation, &Simulation::takesChanged, this, [this] {
        m_kept.clear(); // a number may be that of another take now
        dismiss();
    });
}

bool FramePreview::Key::isOf(const Key& other) const {
    return take == other.take && frame == other.frame && camera.view == other.camera.view &&
           camera.orthographic == other.camera.orthographic && pixelRatio == other.pixelRatio;
}

FramePreview::Key FramePreview::keyOf(int frame) const {
    Camera camera;
    if (m_camera)
        camera = m_camera();
    else
        camera.view = m_simulation.shownScene().camera.value_or(homeView(m_simulation.shownScene().cloth));
    return {m_simulation.recording().take()->id(), frame, camera, devicePixelRatioF()};
}

const QImage* FramePreview::find(const Key& key) const {
    const auto found = std::ranges::find_if(m_kept, [&](const Kept& kept) { return kept.key.isOf(key); });
    return found == m_kept.end() ? nullptr : &found->picture;
}

void FramePreview::ask(int frame, const QString& words, QPoint place) {
    constexpr int milliseconds = 120;
    constexpr int followingMilliseconds = 25; // once it is there, it goes with the mouse
    const bool another = frame != m_frame;
    m_frame = frame;
    m_words = words;
    m_place = place;
    if (isVisible() && (!another || find(keyOf(frame))))
        appear();
    else if (another || !m_delay.isActive())
        m_delay.start(isVisible() ? followingMilliseconds : milliseconds);
}

void FramePreview::dismiss() {
    m_delay.stop();
    m_frame = -1;
    hide();
}

void FramePreview::appear() {
    if (m_frame < 0 || m_frame > m_simulation.recording().lastFrame()) {
        dismiss();
        return;
    }
    const Key key = keyOf(m_frame);
    if (const QImage* kept = find(key)) {
        m_picture = *kept;
    } else {
        const FramePointer frame = m_simulation.look(m_frame);
        const ThemeColors& dark = themeColors(Theme::Dark); // as the view
        m_picture = thumbnail(*frame->scene, m_simulation.sheet().grid, frame->state.position, key.camera,
                              kPicture * key.pixelRatio,
                              {dark.field, QColor(0xD8DCE2), QColor(0x8FA3BC), QColor(0x6B7077)});
        m_picture.setDevicePixelRatio(key.pixelRatio);
        m_kept.push_front({key, m_picture});
        if (m_kept.size() > kMostKept)
            m_kept.pop_back();
    }
    m_shown = m_frame;
    const QSize words = fontMetrics().size(0, m_words);
    resize(std::max(kPicture.width(), words.width()) + 2 * kPadding,
           kPicture.height() + words.height() + 3 * kPadding);
    QRect box(m_place - QPoint(width() / 2, height() + 2 * kPadding), size());
    if (const QScreen* screen = parentWidget()->screen()) {
        const QRect there = screen->geometry();
        box.moveLeft(std::clamp(box.left(), there.left(), std::max(there.left(), there.right() - width())));
        box.moveTop(std::max(box.top(), there.top()));
    }
    move(box.topLeft());
    show();
    update();
}

void FramePreview::paintEvent(QPaintEvent* /*event*/) {
    QPainter painter(this);
    const ThemeColors& colors = themeColors();
    painter.fillRect(rect(), colors.toolTip);
    painter.setPen(colors.border);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
    painter.drawImage(QPoint((width() - kPicture.width()) / 2, kPadding), m_picture);
    painter.setPen(colors.text);
    painter.drawText(rect().adjusted(kPadding, kPicture.height() + 2 * kPadding, -kPadding, -kPadding),
                     Qt::AlignCenter, m_words);
}

} // namespace clothlab
