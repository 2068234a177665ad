// A panel of parameters of the scene, made from their table.
#pragma once

#include "app/document/document.h"

#include <QCheckBox>
#include <QHash>
#include <QWidget>

namespace clothlab {

class ButtonRow;
class FoldableGroup;
class ParameterRow;

class ParameterPanel : public QWidget {
    Q_OBJECT

public:
    // By Parameter::id; null if the panel does not have it.
    ParameterRow* row(const QString& id) const { return m_rows.value(id); }
    QCheckBox* checkBox(const QString& id) const { return m_checkBoxes.value(id); }

signals:
    void rejected(const QString& message); // a typed value that cannot be taken, in words

protected:
    explicit ParameterPanel(Document& document, QWidget* parent);

    FoldableGroup* addGroup(const QString& title, std::initializer_list<const char*> ids,
                            bool folded = false);
    void add(FoldableGroup& group, std::initializer_list<const char*> ids);

    // One column of labels at least that wide, and one of fields, wide enough for that text.
    void alignRows(const QString& widest, int leastLabelWidth = 0);
    int labelWidth() const { return m_labelWidth; }

    // Shows the values of the scene. Called for every change of it.
    virtual void showScene();

    Document& document() const { return m_document; }

private:
    QWidget* makeRow(const Parameter& parameter);
    QWidget* makeCheckBox(const Parameter& parameter);
    void setParameter(const Parameter& parameter, double value, int gesture);

    Document& m_document;
    QHash<QString, ParameterRow*> m_rows;
    QHash<QString, QCheckBox*> m_checkBoxes;
    int m_labelWidth = 0;
};

// Name in the file, unit, range, default, and what it does to cloth.
QString parameterToolTip(const Parameter& parameter);

} // namespace clothlab
