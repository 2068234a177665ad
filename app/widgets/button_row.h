// One row of a panel for what is chosen in a window of its own: a colour or a file.
#pragma once

#include <QColor>
#include <QString>
#include <QWidget>

#include <optional>

class QColorDialog;
class QToolButton;

namespace clothlab {

class DragLabel;

// Label, a button that says what is chosen, and one that goes back to the default. Beside ParameterRows its
// labels stand in one column with theirs.
class ButtonRow : public QWidget {
    Q_OBJECT

public:
    ButtonRow(const QString& label, const QString& toolTip, QWidget* parent = nullptr);

    void setLabelWidth(int width);
    int labelWidthHint() const;
    QToolButton* button() const { return m_button; }
    QToolButton* resetButton() const { return m_reset; }

signals:
    void resetAsked();

protected:
    void showChoice(const QString& text, bool isDefault);
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    virtual void refresh() = 0; // the theme is another one

private:
    void elide();

    QString m_labelText;
    QString m_choice; // in full
    DragLabel* m_label;
    QToolButton* m_button;
    QToolButton* m_reset;
};

class ColorRow : public ButtonRow {
    Q_OBJECT

public:
    // byDefault: in words, what is shown without a colour; empty if there always is one, which cannot be
    // reset.
    ColorRow(const QString& label, const QString& toolTip, const QString& byDefault,
             QWidget* parent = nullptr);

    // Emits nothing.
    void setColor(const std::optional<QColor>& color, bool isDefault);
    std::optional<QColor> color() const { return m_color; }

signals:
    // By the user. Colours of one gesture are one visit to the chooser and may become one undo step.
    void edited(const QColor& color, int gesture);

protected:
    void refresh() override;

private:
    void choose();

    QString m_byDefault;
    std::optional<QColor> m_color;
    bool m_isDefault = true;
    QColorDialog* m_dialog = nullptr;
    int m_gesture = 0;
};

class FileRow : public ButtonRow {
    Q_OBJECT

public:
    enum class Kind { Picture, Folder };
    FileRow(const QString& label, const QString& toolTip, const QString& byDefault, Kind kind,
            QWidget* parent = nullptr);

    // Empty: the default. Emits nothing. folder: where a chooser begins.
    void setFile(const QString& path, const QString& folder);

signals:
    void chosen(const QString& path); // by the user

protected:
    void refresh() override;

private:
    void choose();

    QString m_byDefault;
    Kind m_kind;
    QString m_path;
    QString m_folder;
};

} // namespace clothlab
