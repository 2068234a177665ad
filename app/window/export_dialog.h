// Asks what is to be exported, and shows how far it is.
#pragma once

#include "app/export/export_request.h"

#include <QDialog>

class QComboBox;
class QFormLayout;
class QLabel;
class QLineEdit;
class QPushButton;

namespace clothlab {

class ExportProgress;
class NumberField;

// What there is to export.
struct ExportFacts {
    int lastFrame = 0;
    int in = 0, out = 0;      // what is exported if the user says nothing, both included
    int framesPerSecond = 90; // of the scene
    Grid grid;
    QString file;         // where exports go if the user says nothing: a path without an ending
    QString whyNoPicture; // in words; empty if pictures can be made
};

// Stays open beside the window. What the user has not touched follows the facts.
class ExportDialog : public QDialog {
    Q_OBJECT

public:
    explicit ExportDialog(QWidget* parent);

    void setFacts(const ExportFacts& facts);
    ExportRequest request() const; // as the fields are now
    QString summary() const;       // what the files will hold

    void begin(int frames); // an export is under way
    void showProgress(int written);
    void end(const QString& text, bool good);

    QComboBox* kindField() const { return m_kind; }
    QLineEdit* pathField() const { return m_path; }
    NumberField* firstField() const { return m_first; }
    NumberField* lastField() const { return m_last; }
    NumberField* everyField() const { return m_every; }
    NumberField* widthField() const { return m_width; }
    NumberField* heightField() const { return m_height; }
    NumberField* framesPerSecondField() const { return m_framesPerSecond; }
    QComboBox* upField() const { return m_up; }
    NumberField* scaleField() const { return m_scale; }
    QPushButton* exportButton() const { return m_export; }
    ExportProgress* progress() const { return m_progress; }
    QString resultText() const;

signals:
    void exportAsked(const clothlab::ExportRequest& request);
    void cancelAsked();
    void shownChanged(bool shown); // the dialog itself

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void makeFields();
    void layOut();
    void connectFields();
    void fillKinds(); // which can be used may have changed
    void chooseFile();
    void askForExport();
    void refresh();
    QString contents(const ExportRequest& request) const;
    QString pace(const ExportRequest& request) const;
    void colorResult();

    ExportFacts m_facts;
    QComboBox* m_kind;
    QLineEdit* m_path;
    QPushButton* m_choose;
    NumberField *m_first, *m_last, *m_every;
    QComboBox* m_up;
    NumberField* m_scale;
    NumberField *m_width, *m_height, *m_framesPerSecond;
    QLabel* m_summary;
    QLabel* m_result;
    ExportProgress* m_progress;
    QPushButton* m_export;
    QFormLayout* m_form = nullptr;
    QWidget *m_placementRow = nullptr, *m_sizeRow = nullptr;
    // Chosen by the user: stay as they are.
    bool m_pathChosen = false, m_firstChosen = false, m_lastChosen = false, m_everyChosen = false,
         m_paceChosen = false;
    bool m_running = false;
    bool m_resultGood = true;
};

} // namespace clothlab
