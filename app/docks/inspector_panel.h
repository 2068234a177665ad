// The numbers behind what is selected, in the frame that is shown.
#pragma once

#include "app/document/document.h"
#include "app/simulation/simulation.h"

#include <QLabel>
#include <QStackedWidget>
#include <QTableWidget>
#include <QWidget>

#include <utility>
#include <vector>

class QFormLayout;

namespace clothlab {

class InspectorPanel : public QWidget {
    Q_OBJECT

public:
    InspectorPanel(Document& document, Simulation& simulation, QWidget* parent = nullptr);

    // Name and value of each line shown, top down; empty if nothing is selected.
    std::vector<std::pair<QString, QString>> lines() const;
    QTableWidget* springTable() const { return m_table; }

protected:
    void showEvent(QShowEvent* event) override;

private:
    using Lines = std::vector<std::pair<QString, QString>>;

    void refresh();
    QString exactly(const QString& number) const;
    void showPoint(int point);
    void showSpring(int number);
    void showLines(const Lines& lines);
    void fillTable(const std::vector<int>& springs, int point);
    void selectRow(int row);

    Document& m_document;
    Simulation& m_simulation;
    QStackedWidget* m_pages;
    QLabel* m_title;
    QFormLayout* m_form;
    std::vector<std::pair<QLabel*, QLabel*>> m_rows;
    QTableWidget* m_table;
    std::vector<int> m_tableSprings; // the spring of each row
};

} // namespace clothlab
