#pragma once

#include "app/document/document.h"

#include <QComboBox>
#include <QToolButton>
#include <QWidget>

class QColorDialog;

namespace clothlab {

// How the sheet looks: shader and colour.
class AppearancePanel : public QWidget {
    Q_OBJECT

public:
    AppearancePanel(Document& document, const QStringList& shaders, QWidget* parent = nullptr);

    QComboBox* shaderBox() const { return m_shader; }
    QToolButton* colorButton() const { return m_color; }

private:
    void chooseColor();
    void setColor(const QColor& color, int gesture);
    void showScene();

    Document& m_document;
    QComboBox* m_shader;
    QToolButton* m_color;
    QColorDialog* m_dialog = nullptr;
};

// One undo step: draw with another shader.
void setShader(Document& document, const QString& shader);

// Shows `shader` in a selector that lists `shaders`, also one that is not there.
void showShader(QComboBox& box, const QString& shader);

} // namespace clothlab
