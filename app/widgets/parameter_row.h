// One parameter of a panel: label, slider, number, and a dot when it was changed.
#pragma once

#include <QString>
#include <QWidget>

#include <limits>

namespace clothlab {

class DragLabel;
class NumberField;
class ValueSlider;

struct ParameterSpec {
    QString label{};
    QString unit{}; // of all numbers here
    QString toolTip{};
    double minimum = -std::numeric_limits<double>::infinity(); // what the field accepts, ends included
    double maximum = std::numeric_limits<double>::infinity();
    double leastButZero = 0;  // above 0: steps and drags pass over what is between 0 and this
    double sliderMinimum = 0; // what is sensible; also sets how far a drag of the label goes
    double sliderMaximum = 1; // > sliderMinimum
    double defaultValue = 0;
    bool integer = false;
    bool logarithmic = false; // needs sliderMinimum > 0
    bool slider = true;
};

// Edits one number of the document without knowing it. Dragging the label sideways changes the value
// (Shift ten times as fast, Ctrl a tenth), a double click on it restores the default.
class ParameterRow : public QWidget {
    Q_OBJECT

public:
    explicit ParameterRow(const ParameterSpec& spec, QWidget* parent = nullptr);

    const ParameterSpec& spec() const { return m_spec; }
    double value() const;

    // Shows the document's value. Emits nothing, and doesn't disturb what is being typed or dragged.
    void setValue(double value);

    // Rows of one panel share one width of labels and one of fields. A label too long ends in an ellipsis.
    void setLabelWidth(int width);
    void setFieldWidth(int width);
    int labelWidthHint() const;

    // Disables the row and says in the tooltip why; an empty reason enables it again.
    void setDisabledReason(const QString& reason);

    NumberField* field() const { return m_field; }

    // A number no other gesture has, never 0; for whatever else merges its edits.
    static int newGesture();

signals:
    // By the user. Edits with the same gesture are one drag or one run of steps and may become one undo
    // step; 0 stands alone.
    void edited(double value, int gesture);
    void rejected(const QString& message);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    class Dot;

    void buildSlider();
    void connectLabel();
    void connectField();
    void settleField();
    void startDrag();
    double valueAfterDrag(double pixels) const;
    double passedOver(double value) const;
    void change(double value, int gesture);
    void refresh();
    void updateToolTips();

    ParameterSpec m_spec;
    DragLabel* m_label;
    ValueSlider* m_slider = nullptr;
    NumberField* m_field;
    Dot* m_dot;
    QString m_disabledReason;
    double m_shown = 0; // as of the last refresh()
    double m_dragStart = 0;
    int m_dragGesture = 0;
    int m_stepGesture = 0; // 0: the next step begins a run
};

} // namespace clothlab
