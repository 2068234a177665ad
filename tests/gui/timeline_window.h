// The timeline of a window under test, and where things are on it.
#pragma once

#include "tests/gui/test_window.h"

#include <QComboBox>

namespace clothlab {

class TimelineWindow : public TestWindow {
public:
    TimelineWindow() {
        if (!load(smallScene()))
            qFatal("the scene cannot be opened");
    }

    TimelinePanel& timeline() { return (*this)->timelinePanel(); }
    Scrubber& scrubber() { return *timeline().scrubber(); }
    Actions& actions() { return (*this)->actions(); }
    QPoint onBar(double frame) { return {qRound(scrubber().positionOf(frame)), scrubber().height() - 10}; }
    QPoint onMarks(double frame) {
        return {qRound(scrubber().positionOf(frame)), qRound(scrubber().marksRow().center().y())};
    }
    QComboBox* choice(const char* name) { return timeline().findChild<QComboBox*>(name); }
    // As the user does, from the list.
    void choose(const char* name, const QString& text) {
        QComboBox* box = choice(name);
        box->setCurrentIndex(box->findText(text));
        emit box->activated(box->currentIndex());
    }
    std::vector<int> markers() {
        std::vector<int> frames;
        for (const Marker& marker : simulation().marks().markers)
            frames.push_back(marker.frame);
        return frames;
    }
};

} // namespace clothlab
