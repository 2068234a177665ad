// Which springs are drawn, by type, with their numbers. Physics is untouched by it.
#pragma once

#include "app/document/document.h"

#include <QCheckBox>
#include <QLabel>
#include <QWidget>

#include <array>

namespace clothlab {

class SpringsPanel : public QWidget {
    Q_OBJECT

public:
    explicit SpringsPanel(Document& document, QWidget* parent = nullptr);

    QCheckBox* typeBox(SpringType type) const { return m_types[std::size_t(type)]; }
    QCheckBox* overSurfaceBox() const { return m_overSurface; }

protected:
    void changeEvent(QEvent* event) override;

private:
    void showScene();
    void colorBoxes();

    Document& m_document;
    std::array<QCheckBox*, kSpringTypes> m_types{};
    std::array<QLabel*, kSpringTypes> m_counts{};
    QCheckBox* m_overSurface = nullptr;
    QCheckBox* m_byStrain = nullptr;
    QLabel* m_total = nullptr;
};

// One undo step: draw springs of a type, or not.
void setSpringsDrawn(Document& document, SpringType type, bool drawn);

} // namespace clothlab
