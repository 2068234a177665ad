// The panel Shader: the text of a shader is opened, changed, saved and dropped; nothing typed is lost
// unasked.
#include "tests/gui/dialog_answer.h"
#include "tests/gui/test_window.h"

#include "app/render/shader_folder.h"
#include "app/widgets/code_edit.h"

#include <QDir>
#include <QLabel>
#include <QSignalSpy>
#include <QTextBlock>

using namespace clothlab;

Q_DECLARE_METATYPE(QMessageBox::StandardButton)

class TestShaderEditor : public QObject {
    Q_OBJECT

private slots:
    void init();
    void cleanup() { m_window.reset(); }

    void theShaderThatIsDrawnIsOpened();
    void aFileIsOpenedAtALine();
    void aFileThatIsNotThereIsToldInWords();
    void whatIsTypedIsSaved_data();
    void whatIsTypedIsSaved();
    void aFileIsSavedAsItWasRead_data();
    void aFileIsSavedAsItWasRead();
    void keysInTheTextAreTheTexts();
    void revertDropsChanges();
    void aFolderThatCannotBeWrittenLosesNothing();
    void aChangeOnDiskIsShown();
    void aChangeOnDiskDoesNotDropWhatIsTyped();
    void anotherFileWaitsUntilTheTextIsSaved();
    void linesWithProblemsAreMarked();
    void linksInOutputOpenTheirPlace();
    void closingAsksAboutTheText_data();
    void closingAsksAboutTheText();
    void aSaveThatFailsKeepsTheWindow();

private:
    ShaderEditor& editor() { return (*m_window)->shaderEditor(); }
    CodeEdit& edit() { return editor().edit(); }
    int line() { return edit().textCursor().blockNumber() + 1; }
    QString shader(const QString& name) { return m_folder->filePath(name); }
    static QByteArray read(const QString& path) {
        QFile file(path);
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("cannot be read");
    }
    static void write(const QString& path, const QByteArray& text) {
        QFile file(path);
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(text), text.size());
    }
    // Ctrl+E, and types at the front.
    void openAndType(const QString& text) {
        m_window->key(Qt::Key_E, Qt::ControlModifier);
        TRY_VERIFY(edit().isVisible() && edit().hasFocus());
        edit().moveCursor(QTextCursor::Start);
        m_window->type(text);
    }

    const QByteArray m_text = "#version 330\n// one\n// two\nout vec4 out_color;\nvoid main() {\n"
                              "    out_color = vec4(1);\n}\n";
    std::unique_ptr<QTemporaryDir> m_folder;
    std::unique_ptr<TestWindow> m_window;
};

void TestShaderEditor::init() {
    m_folder = std::make_unique<QTemporaryDir>();
    for (const char* name : {"Phong.frag", "Felt.frag"})
        write(shader(name), m_text);
    m_window = std::make_unique<TestWindow>(QSize(1440, 900), m_folder->path());
    QVERIFY(m_window->load(smallScene()));
}

void TestShaderEditor::theShaderThatIsDrawnIsOpened() {
    QVERIFY(edit().isReadOnly() && edit().toPlainText().isEmpty());
    QVERIFY(!editor().saveButton()->isEnabled());
    m_window->click((*m_window)->appearancePanel().findChild<QWidget*>("editShader"));
    TRY_VERIFY(edit().isVisible() && edit().hasFocus());
    QCOMPARE(editor().path(), shader("Phong.frag"));
    QCOMPARE(edit().toPlainText().toUtf8(), m_text);
    QVERIFY(!edit().isReadOnly() && !editor().isModified());
    QVERIFY(!editor().saveButton()->isEnabled() && !editor().revertButton()->isEnabled());
}

void TestShaderEditor::aFileIsOpenedAtALine() {
    QVERIFY(editor().open(shader("Felt.frag"), 6));
    QCOMPARE(line(), 6);
    QVERIFY(editor().open(shader("Felt.frag"), 0)); // where the cursor was
    QCOMPARE(line(), 6);
    QVERIFY(editor().open(shader("Felt.frag"), 1000)); // there is no such line
    QCOMPARE(editor().path(), shader("Felt.frag"));
}

void TestShaderEditor::aFileThatIsNotThereIsToldInWords() {
    QVERIFY(!editor().open(shader("None.frag"), 3));
    QVERIFY((*m_window)->messageBar().text().contains("None.frag"));
    QVERIFY(editor().path().isEmpty() && edit().isReadOnly());
}

void TestShaderEditor::whatIsTypedIsSaved_data() {
    QTest::addColumn<bool>("byKey");
    QTest::newRow("by Ctrl+S in the text") << true;
    QTest::newRow("by the button") << false;
}

void TestShaderEditor::whatIsTypedIsSaved() {
    QFETCH(const bool, byKey);
    openAndType("// new");
    m_window->key(Qt::Key_Return);
    QVERIFY(editor().isModified());
    QCOMPARE(read(shader("Phong.frag")), m_text);
    QSignalSpy changed(&(*m_window)->shaderFolder(), &render::ShaderFolder::filesChanged);
    if (byKey)
        m_window->key(Qt::Key_S, Qt::ControlModifier);
    else
        m_window->click(editor().saveButton());
    QVERIFY(!editor().isModified());
    QCOMPARE(read(shader("Phong.frag")), "// new\n" + m_text);
    QCOMPARE(QDir(m_folder->path()).entryList(QDir::Files).size(), 2); // nothing half written
    TRY_COMPARE(changed.count(), 1);
    QCOMPARE(m_window->document().undoStack().count(), 0);
    QVERIFY(edit().document()->isUndoAvailable()); // the text was not read again
}

void TestShaderEditor::aFileIsSavedAsItWasRead_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::newRow("no last line end") << QByteArray("void main() {}");
    QTest::newRow("DOS") << QByteArray("// one\r\n// two\r\n");
    QTest::newRow("UTF-8") << QByteArray("// größe ✓\n");
    QTest::newRow("Latin-1") << QByteArray("// gr\xF6\xDF"
                                           "e\n");
    QTest::newRow("tabs") << QByteArray("\tvoid\n\n\n");
}

void TestShaderEditor::aFileIsSavedAsItWasRead() {
    QFETCH(const QByteArray, text);
    write(shader("Felt.frag"), text);
    QVERIFY(editor().open(shader("Felt.frag"), 1));
    QVERIFY(!editor().isModified());
    (*m_window)->dock("shader")->raise();
    TRY_VERIFY(edit().isVisible());
    edit().setFocus();
    edit().moveCursor(QTextCursor::Start);
    m_window->type("/**/");
    QVERIFY(editor().save());
    QCOMPARE(read(shader("Felt.frag")), "/**/" + text);
    TRY_VERIFY(!editor().isModified());
}

void TestShaderEditor::keysInTheTextAreTheTexts() {
    QVERIFY(m_window->simulateTo(3));
    const Camera camera = m_window->viewport().camera();
    const Scene before = m_window->scene();
    openAndType("p n r 1 7 ? .");
    for (const Qt::Key key : {Qt::Key_Left, Qt::Key_Right, Qt::Key_Home, Qt::Key_Tab, Qt::Key_End})
        m_window->key(key);
    m_window->key(Qt::Key_Left, Qt::ShiftModifier);
    m_window->key(Qt::Key_Home, Qt::ControlModifier);
    QCOMPARE(edit().toPlainText().section('\n', 0, 0), QStringLiteral("\tp n r 1 7 ? .#version 330"));
    QCOMPARE(m_window->frame(), 3);
    QVERIFY(!m_window->simulation().isPlaying());
    QVERIFY(m_window->viewport().camera().view == camera.view);
    // Undo is the text's there.
    while (edit().document()->isUndoAvailable())
        m_window->key(Qt::Key_Z, Qt::ControlModifier);
    QCOMPARE(edit().toPlainText().toUtf8(), m_text);
    QVERIFY(!editor().isModified());
    QVERIFY(m_window->scene() == before);
}

void TestShaderEditor::revertDropsChanges() {
    openAndType("nonsense");
    m_window->click(editor().revertButton());
    QCOMPARE(edit().toPlainText().toUtf8(), m_text);
    QVERIFY(!editor().isModified());
    QCOMPARE(read(shader("Phong.frag")), m_text);
}

void TestShaderEditor::aFolderThatCannotBeWrittenLosesNothing() {
    openAndType("// new ");
    const QString typed = edit().toPlainText();
    QVERIFY(QDir(m_folder->path()).removeRecursively()); // nobody can write there, root neither
    m_window->click(editor().saveButton());
    QVERIFY((*m_window)->messageBar().text().contains("Phong.frag"));
    QVERIFY((*m_window)->messageBar().isVisible());
    QCOMPARE(edit().toPlainText(), typed);
    QVERIFY(editor().isModified());
    // Nor does what happens on disk take it away.
    editor().fileMayHaveChanged();
    QCOMPARE(edit().toPlainText(), typed);
    QVERIFY(QDir().mkpath(m_folder->path()));
    m_window->click(editor().saveButton());
    QCOMPARE(read(shader("Phong.frag")), typed.toUtf8());
}

void TestShaderEditor::aChangeOnDiskIsShown() {
    QVERIFY(editor().open(shader("Phong.frag"), 3));
    write(shader("Phong.frag"), "// other\n" + m_text);
    TRY_COMPARE(edit().toPlainText().toUtf8(), "// other\n" + m_text);
    QVERIFY(!editor().isModified());
    QCOMPARE(line(), 3);
    // As editors do that write another file in its place.
    write(shader("Phong.frag.new"), "// third\n" + m_text);
    QVERIFY(QFile::remove(shader("Phong.frag")));
    QVERIFY(QFile::rename(shader("Phong.frag.new"), shader("Phong.frag")));
    TRY_COMPARE(edit().toPlainText().toUtf8(), "// third\n" + m_text);
    write(shader("Phong.frag"), "// fourth\n" + m_text); // it is watched still
    TRY_COMPARE(edit().toPlainText().toUtf8(), "// fourth\n" + m_text);
}

void TestShaderEditor::aChangeOnDiskDoesNotDropWhatIsTyped() {
    openAndType("// mine ");
    write(shader("Phong.frag"), "// other\n" + m_text);
    TRY_VERIFY(m_window->output().contains("Phong.frag was changed on disk"));
    QCOMPARE(edit().toPlainText().toUtf8(), "// mine " + m_text);
    QVERIFY(editor().isModified());
    m_window->click(editor().revertButton());
    QCOMPARE(edit().toPlainText().toUtf8(), "// other\n" + m_text);
}

void TestShaderEditor::anotherFileWaitsUntilTheTextIsSaved() {
    openAndType("// mine ");
    QVERIFY(!editor().open(shader("Felt.frag"), 2));
    QCOMPARE(editor().path(), shader("Phong.frag"));
    QVERIFY((*m_window)->messageBar().text().contains("Phong.frag has changes"));
    QVERIFY(editor().open(shader("Phong.frag"), 4)); // this one is open already
    QCOMPARE(line(), 4);
    m_window->click(editor().saveButton());
    QVERIFY(editor().open(shader("Felt.frag"), 2));
    QCOMPARE(edit().toPlainText().toUtf8(), m_text);
}

void TestShaderEditor::linesWithProblemsAreMarked() {
    const render::Problems problems{{shader("Phong.frag"), 3, "wrong"},
                                    {shader("Phong.frag"), 0, "as a whole"},
                                    {shader("Felt.frag"), 5, "elsewhere"}};
    editor().setProblems(problems);
    QVERIFY(editor().open(shader("Phong.frag"), 1));
    QCOMPARE(edit().markedLines(), QList<int>{3});
    QCOMPARE(edit().extraSelections().size(), 1);
    QCOMPARE(edit().extraSelections()[0].cursor.blockNumber(), 2);
    QVERIFY(editor().open(shader("Felt.frag"), 1));
    QCOMPARE(edit().markedLines(), QList<int>{5});
    editor().setProblems({});
    QVERIFY(edit().markedLines().isEmpty() && edit().extraSelections().isEmpty());
}

void TestShaderEditor::linksInOutputOpenTheirPlace() {
    OutputPanel& output = (*m_window)->outputPanel();
    output.add(render::Problem{shader("Felt.frag"), 5, "it is wrong"});
    QVERIFY(m_window->output().contains("Felt.frag:5: it is wrong"));
    (*m_window)->dock("output")->raise();
    TRY_VERIFY(output.isVisible());
    QTextCursor place = output.document()->find("Felt.frag:5");
    QVERIFY(!place.isNull());
    place.setPosition(place.selectionStart() + 3);
    m_window->click(output.viewport(), output.cursorRect(place).center());
    TRY_VERIFY(!(*m_window)->dock("shader")->visibleRegion().isEmpty());
    QCOMPARE(editor().path(), shader("Felt.frag"));
    QCOMPARE(line(), 5);
    QVERIFY(m_window->output().contains("it is wrong")); // it is no page that is left
}

void TestShaderEditor::closingAsksAboutTheText_data() {
    QTest::addColumn<QMessageBox::StandardButton>("answer");
    QTest::newRow("save") << QMessageBox::Save;
    QTest::newRow("discard") << QMessageBox::Discard;
    QTest::newRow("cancel") << QMessageBox::Cancel;
}

void TestShaderEditor::closingAsksAboutTheText() {
    QFETCH(const QMessageBox::StandardButton, answer);
    openAndType("// new ");
    const DialogAnswer given(answer);
    QCOMPARE((*m_window)->close(), answer != QMessageBox::Cancel);
    QVERIFY(given.asked() && given.text().contains("Phong.frag"));
    QCOMPARE(read(shader("Phong.frag")), (answer == QMessageBox::Save ? "// new " : "") + m_text);
    if (answer == QMessageBox::Cancel)
        QVERIFY(editor().isModified() && (*m_window)->isVisible());
}

void TestShaderEditor::aSaveThatFailsKeepsTheWindow() {
    openAndType("// new ");
    QVERIFY(QDir(m_folder->path()).removeRecursively());
    const DialogAnswer given(QMessageBox::Save);
    QVERIFY(!(*m_window)->close());
    QVERIFY(given.asked() && editor().isModified() && (*m_window)->isVisible());
    QVERIFY((*m_window)->messageBar().text().contains("Phong.frag"));
}

CLOTHLAB_GUI_TEST_MAIN(TestShaderEditor)
#include "tst_shader_editor.moc"
