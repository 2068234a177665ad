#pragma once

#include "app/docks/frame_plot.h"
#include "app/simulation/simulation.h"

#include <QElapsedTimer>
#include <QPixmap>
#include <QTimer>
#include <QWidget>

#include <optional>
#include <vector>

class QLineEdit;

namespace clothlab {

class FramePreview;

// The strip of recorded frames: a click or drag asks for a frame, and if frames cannot be shown as fast as
// the mouse moves, the newest wins. Its length grows by doubling, so that the cursor moves while a run is
// recorded. From top to bottom: numbers and times; markers, in and out point, which can be dragged; the plot
// of a quantity; a bar that says what is kept of the frames.
//
// To paint it takes no longer for many frames than for few.
class Scrubber : public QWidget {
    Q_OBJECT

public:
    Scrubber(Document& document, Simulation& simulation, QWidget* parent = nullptr);

    int span() const { return m_span; }    // frame at the right end
    int frameAt(double x) const;           // nearest that is recorded
    double positionOf(double frame) const; // x
    QRectF marksRow() const;               // where markers, in and out point are
    FramePreview& preview() { return *m_preview; }

    void setQuantity(PlotQuantity quantity);
    const FramePlot& plot() const { return m_plot; }

    void renameMarker(int frame); // opens a field for its name
    QString legend() const;       // what the colours say, as rich text

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;

signals:
    void frameRequested(int frame);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    enum class Handle { None, In, Out };
    enum class Part { Recorded, Spilled, Stale, Live };
    struct Hit {
        Handle handle = Handle::None;
        std::optional<int> marker; // its frame
    };

    void readRecording();
    void readPlaying();
    void forgetPicture(); // of what changes seldom
    void ask(int frame);
    void deliver(); // what was asked for last
    Hit hitAt(QPointF position) const;
    void dragHandle(double x);
    void hover(QPointF position);
    void finishRenaming(bool keep);

    QRectF track() const; // bar and plot have the same ends
    QRectF bar() const;
    QRectF plotArea() const;
    double timeOf(int frame) const; // also of one that is not recorded yet
    Part partOf(int frame) const;
    QString describe(int frame) const;
    QColor colorOf(Part part) const;
    QString nameOf(Part part) const;

    void paintPicture();
    void paintTicks(QPainter& painter) const;
    void paintPlot(QPainter& painter) const;
    void paintBar(QPainter& painter);
    void paintRange(QPainter& painter) const;
    void paintMarkers(QPainter& painter) const;
    void findSpilled();

    Document& m_document;
    Simulation& m_simulation;
    FramePreview* m_preview;
    FramePlot m_plot;
    int m_span = 90;
    int m_liveFrom = -1; // what is recorded while it plays; -1: nothing is
    TakeId m_take = 0;

    QPixmap m_picture;           // ticks and plot; null: to be painted
    std::vector<bool> m_spilled; // a pixel column of the bar
    QElapsedTimer m_sinceSpilled;

    std::optional<int> m_asked; // and not delivered
    QTimer m_delivery;
    Handle m_dragged = Handle::None;
    bool m_scrubbing = false;
    int m_gesture = 0;
    std::optional<int> m_selected; // frame of the marker
    QLineEdit* m_nameField = nullptr;
};

} // namespace clothlab
