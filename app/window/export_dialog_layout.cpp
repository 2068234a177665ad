// The part of the dialog that makes its fields and puts them where they are.
#include "app/widgets/number_field.h"
#include "app/window/export_dialog.h"
#include "app/window/export_progress.h"

#include <QComboBox>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>

namespace clothlab {
namespace {

QWidget* inOneRow(std::initializer_list<QWidget*> widgets) {
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(6);
    for (QWidget* widget : widgets)
        layout->addWidget(widget, qobject_cast<QLabel*>(widget) ? 0 : 1);
    return row;
}

} // namespace

void ExportDialog::makeFields() {
    for (int i = 0; i < kExportKinds; ++i)
        m_kind->addItem(title(ExportKind(i)));
    m_up->addItems({tr("Y is up"), tr("Z is up")});
    m_up->setToolTip(tr("Which axis points up in the files: (x, y, z) becomes (x, −z, y) for Z"));
    const auto number = [](NumberField* field, bool integer, double least, double most, double value,
                           const QString& name, const QString& toolTip) {
        field->setInteger(integer);
        field->setRange(least, most);
        field->setValue(value);
        field->setAccessibleName(name);
        field->setToolTip(toolTip);
    };
    number(m_first, true, 0, 0, 0, tr("First frame"), tr("First frame; 0 is the start"));
    number(m_last, true, 0, 0, 0, tr("Last frame"), tr("Last frame, which is written, too"));
    number(m_every, true, 1, 10000, 1, tr("Every how many frames"), tr("1 writes every frame, 3 each third"));
    number(m_scale, false, 1e-6, 1e6, 1, tr("Units per metre"), tr("100 writes centimetres"));
    m_scale->setUnit(tr("units per metre"));
    const QString sizes = tr("From 1 to %1 pixels; a video has even ones").arg(render::kGreatestPicture);
    number(m_width, true, 2, render::kGreatestPicture, 1280, tr("Width"), sizes);
    number(m_height, true, 2, render::kGreatestPicture, 720, tr("Height"), sizes);
    for (NumberField* field : {m_width, m_height})
        field->setUnit(tr("px"));
    number(m_framesPerSecond, false, 0.1, 240, 30, tr("Frames per second"),
           tr("Of the video; the summary below says how it compares with real time"));
    m_path->setAccessibleName(tr("File"));
    m_path->setToolTip(tr("Where it is written to; a sequence adds _0000 and so on"));
}

void ExportDialog::layOut() {
    m_placementRow = inOneRow({m_up, m_scale});
    m_sizeRow = inOneRow({m_width, new QLabel(QStringLiteral("×")), m_height});
    m_form = new QFormLayout;
    m_form->setLabelAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    m_form->addRow(tr("Format"), m_kind);
    auto* file = inOneRow({m_path});
    file->layout()->addWidget(m_choose);
    m_form->addRow(tr("File"), file);
    m_form->addRow(tr("Frames"),
                   inOneRow({m_first, new QLabel(tr("to")), m_last, new QLabel(tr("every")), m_every}));
    m_form->addRow(tr("Axes, units"), m_placementRow);
    m_form->addRow(tr("Size"), m_sizeRow);
    m_form->addRow(tr("Frames per second"), m_framesPerSecond);
    auto* holds = new QLabel(tr("Holds"));
    m_form->addRow(holds, m_summary);

    for (QLabel* label : {m_summary, m_result}) {
        label->setWordWrap(true);
        label->setTextFormat(Qt::PlainText);
        label->setTextInteractionFlags(Qt::TextSelectableByMouse);
    }
    for (QLabel* label : {holds, m_summary, m_result}) {
        label->setMinimumHeight(2 * fontMetrics().lineSpacing()); // so that the rest stays where it is
        label->setAlignment((label == holds ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignTop);
    }
    auto* close = new QPushButton(tr("Close"));
    close->setAutoDefault(false);
    m_choose->setAutoDefault(false);
    m_export->setDefault(true);
    connect(close, &QPushButton::clicked, this, &QDialog::close);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(m_export);
    buttons->addWidget(close);

    auto* layout = new QVBoxLayout(this);
    layout->addLayout(m_form);
    auto* outcome = new QWidget; // one or the other of the two
    outcome->setMinimumHeight(m_progress->sizeHint().height());
    auto* inOutcome = new QVBoxLayout(outcome);
    inOutcome->setContentsMargins(0, 0, 0, 0);
    inOutcome->addWidget(m_result);
    inOutcome->addWidget(m_progress);
    layout->addWidget(outcome);
    layout->addStretch(1);
    layout->addLayout(buttons);
    setMinimumWidth(50 * fontMetrics().horizontalAdvance('0') + 80);
}

void ExportDialog::connectFields() {
    connect(m_kind, &QComboBox::currentIndexChanged, this, [this] {
        // The name stays, the ending is that of the format.
        QString path = m_path->text();
        for (int i = 0; i < kExportKinds; ++i)
            if (const QString old = ending(ExportKind(i)); path.endsWith(old, Qt::CaseInsensitive)) {
                m_path->setText(path.chopped(old.size()) + ending(request().kind));
                break;
            }
        refresh();
    });
    connect(m_path, &QLineEdit::textEdited, this, [this] {
        m_pathChosen = true;
        refresh();
    });
    connect(m_choose, &QPushButton::clicked, this, &ExportDialog::chooseFile);
    const auto touched = [this](NumberField* field, bool* chosen) {
        connect(field, &NumberField::valueEdited, this, [this, chosen] {
            if (chosen)
                *chosen = true;
            refresh();
        });
    };
    touched(m_first, &m_firstChosen);
    touched(m_last, &m_lastChosen);
    touched(m_every, &m_everyChosen);
    touched(m_framesPerSecond, &m_paceChosen);
    for (NumberField* field : {m_scale, m_width, m_height})
        touched(field, nullptr);
    connect(m_export, &QPushButton::clicked, this, &ExportDialog::askForExport);
    connect(m_progress, &ExportProgress::cancelAsked, this, &ExportDialog::cancelAsked);
}

} // namespace clothlab
