#pragma once

#include "app/picture/camera.h"
#include "app/simulation/simulation.h"

#include <QImage>
#include <QTimer>
#include <QWidget>

#include <deque>
#include <functional>

namespace clothlab {

// A small picture of a recorded frame with words under it, near the mouse. It takes no focus and no clicks.
class FramePreview : public QWidget {
    Q_OBJECT

public:
    FramePreview(Simulation& simulation, QWidget* parent);

    // Whose view it draws; without it, how the scene opens.
    void setCamera(std::function<Camera()> camera) { m_camera = std::move(camera); }

    // A moment later, above the place; at once if it is in the cache. Another call takes the place of the
    // one before.
    void ask(int frame, const QString& words, QPoint place); // on the screen
    void dismiss();

    int shownFrame() const { return isVisible() ? m_shown : -1; }
    const QImage& picture() const { return m_picture; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    // What a picture depends on.
    struct Key {
        TakeId take = 0;
        int frame = 0;
        Camera camera;
        qreal pixelRatio = 1;
        bool isOf(const Key& other) const;
    };
    struct Kept {
        Key key;
        QImage picture;
    };

    Key keyOf(int frame) const;
    const QImage* find(const Key& key) const;
    void appear();

    Simulation& m_simulation;
    std::function<Camera()> m_camera;
    QTimer m_delay;
    int m_frame = -1; // asked for
    int m_shown = -1;
    QString m_words;
    QPoint m_place;
    QImage m_picture;
    std::deque<Kept> m_kept; // the newest first
};

} // namespace clothlab
