#pragma once

#include <QColor>
#include <QRect>
#include <QString>
#include <QWidget>

#include <optional>
#include <vector>

namespace clothlab {

// Words over the picture: badges top centre, a legend top right, a hint bottom centre, the box of a
// selection, and what stands in the place of the picture if there is none. Lets every mouse event through.
class Overlay : public QWidget {
    Q_OBJECT

public:
    struct Badge {
        QString text;
        QColor color;
        friend bool operator==(const Badge&, const Badge&) = default;
    };

    // Of the colours of strain: the strain at both of their ends, and the least and greatest in the picture.
    struct Legend {
        double range = 0;
        double least = 0;
        double greatest = 0;
        friend bool operator==(const Legend&, const Legend&) = default;
    };

    explicit Overlay(QWidget* parent);

    void setBadges(std::vector<Badge> badges);
    void setHint(const QString& hint);
    void setLegend(const std::optional<Legend>& legend); // top right; none: no strain is seen
    void setSelectionBox(const QRect& box);              // null: none
    void setPlaceholder(const QString& title, const QString& reason);

    const std::vector<Badge>& badges() const { return m_badges; }
    const std::optional<Legend>& legend() const { return m_legend; }
    QString placeholder() const { return m_placeholderTitle; }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void paintBadges(QPainter& painter) const;
    void paintHint(QPainter& painter) const;
    void paintLegend(QPainter& painter) const;
    void paintPlaceholder(QPainter& painter) const;

    std::vector<Badge> m_badges;
    QString m_hint;
    std::optional<Legend> m_legend;
    QRect m_box;
    QString m_placeholderTitle, m_placeholderReason;
};

} // namespace clothlab
