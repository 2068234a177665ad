// Saves the view as a picture of any size.
#pragma once

#include <QDialog>

#include <optional>

namespace clothlab {

class NumberField;
class Viewport;

// Stays open beside the window; what it saves is what the view shows then.
class PictureDialog : public QDialog {
    Q_OBJECT

public:
    PictureDialog(Viewport& viewport, const QString& shaders, const QString& textures, QWidget* parent);

    NumberField* widthField() const { return m_width; }
    NumberField* heightField() const { return m_height; }

    // What went wrong, in words; nothing if the file was written.
    std::optional<QString> save(const QString& path) const;

signals:
    void saved(const QString& path);
    void problem(const QString& text);

private:
    void chooseAndSave();

    Viewport& m_viewport;
    QString m_shaders;
    QString m_textures;
    NumberField* m_width;
    NumberField* m_height;
};

} // namespace clothlab
