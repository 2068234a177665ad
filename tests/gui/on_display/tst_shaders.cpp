// On a real display: a folder of shaders that is edited while it is drawn.
#include "app/docks/shader_controls.h"
#include "app/widgets/code_edit.h"
#include "tests/gui/on_display/display.h"

#include <QComboBox>
#include <QDir>
#include <QElapsedTimer>
#include <QLayout>
#include <QScreen>
#include <QTextBlock>

using namespace clothlab;

class TestShaders : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { CLOTHLAB_NEEDS_PICTURE(); }
    void init();
    void cleanup();

    void aBrokenShaderKeepsThePictureAndSaysWhere();
    void aMendedShaderIsDrawnSoon();
    void aHeaderIsWatchedToo();
    void aNewShaderIsInBothSelectors();
    void aUniformGetsItsControlAndMovesThePicture();
    void thePictureStaysWhereverTheViewIs_data();
    void thePictureStaysWhereverTheViewIs();

private:
    // What the user sees of the view: the pixels on the screen.
    QImage seen() {
        const QWidget& view = m_window->viewport();
        const QPoint corner = view.mapTo(view.window(), QPoint());
        return view.screen()
            ->grabWindow(view.window()->winId(), corner.x(), corner.y(), view.width(), view.height())
            .toImage()
            .convertToFormat(QImage::Format_RGB32);
    }
    QColor middle() { return seen().pixelColor(m_window->viewport().rect().center()); }
    QString shader(const QString& name) { return m_shaders->filePath(name); }
    QByteArray read(const QString& name) {
        QFile file(shader(name));
        return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
    }
    void write(const QString& name, const QByteArray& text) {
        QFile file(shader(name));
        QVERIFY(file.open(QIODevice::WriteOnly));
        QCOMPARE(file.write(text), text.size());
    }
    static QByteArray plain(const QByteArray& color, const QByteArray& before = {}) {
        return "#version 330\n" + before + "out vec4 out_color;\nvoid main() {\n    out_color = " + color +
               ";\n}\n";
    }

    std::unique_ptr<QTemporaryDir> m_shaders;
    std::unique_ptr<TestWindow> m_window;
};

void TestShaders::init() {
    m_shaders = std::make_unique<QTemporaryDir>();
    const QDir from(CLOTHLAB_SOURCE_DIR "/shaders");
    for (const QString& name : from.entryList(QDir::Files))
        QVERIFY(QFile::copy(from.filePath(name), shader(name)));
    m_window = std::make_unique<TestWindow>(QSize(1300, 900), m_shaders->path());
    QVERIFY(m_window->load(smallScene()));
    m_window->key(Qt::Key_7); // the sheet is in the middle
    TRY_VERIFY(middle().lightness() > 60);
    TRY_VERIFY(!(*m_window)->appearancePanel().shaderControls()->uniforms().empty());
    QApplication::processEvents();
}

void TestShaders::cleanup() {
    m_window.reset();
    m_shaders.reset();
}

void TestShaders::aBrokenShaderKeepsThePictureAndSaysWhere() {
    const QImage before = seen();
    QByteArray text = read("Phong.frag");
    const qsizetype place = text.indexOf("void main()");
    QVERIFY(place > 0);
    const auto line = int(text.left(place).count('\n')) + 1;
    text.insert(place, "this is no GLSL\n");
    write("Phong.frag", text);
    const QString where = QStringLiteral("Phong.frag:%1").arg(line);
    TRY_VERIFY((*m_window)->messageBar().isVisible());
    const QString words = (*m_window)->messageBar().text();
    QVERIFY2(words.startsWith(where + ':'), qPrintable(words));
    QVERIFY2(m_window->output().contains(where + ": "), qPrintable(m_window->output()));
    // The message takes place from the view; closed, all is where it was.
    m_window->click((*m_window)->messageBar().findChild<QWidget*>("closeMessage"));
    TRY_COMPARE(seen().size(), before.size());
    TRY_COMPARE(seen(), before);

    OutputPanel& output = (*m_window)->outputPanel();
    (*m_window)->dock("output")->raise();
    TRY_VERIFY(output.isVisible());
    QTextCursor link = output.document()->find(where);
    link.setPosition(link.selectionStart() + 3);
    m_window->click(output.viewport(), output.cursorRect(link).center());
    ShaderEditor& editor = (*m_window)->shaderEditor();
    TRY_VERIFY(editor.isVisible());
    QCOMPARE(editor.path(), shader("Phong.frag"));
    QCOMPARE(editor.edit().textCursor().blockNumber() + 1, line);
    QVERIFY(editor.edit().markedLines().contains(line));

    // Mended there, it is drawn again, and nothing is marked.
    editor.edit().moveCursor(QTextCursor::StartOfLine);
    editor.edit().moveCursor(QTextCursor::EndOfLine, QTextCursor::KeepAnchor);
    m_window->key(Qt::Key_Delete);
    m_window->key(Qt::Key_S, Qt::ControlModifier);
    TRY_VERIFY(editor.edit().markedLines().isEmpty());
    TRY_VERIFY(m_window->output().contains("Shaders and textures are in order."));
    QVERIFY(!(*m_window)->messageBar().isVisible());
}

void TestShaders::aMendedShaderIsDrawnSoon() {
    write("Phong.frag", "broken");
    TRY_VERIFY((*m_window)->messageBar().isVisible());
    QElapsedTimer timer;
    timer.start();
    write("Phong.frag", plain("vec4(0, 1, 0, 1)"));
    QVERIFY(QTest::qWaitFor([&] { return middle() == QColor(0, 255, 0); }, kPatience));
    const qint64 milliseconds = timer.elapsed();
    qInfo("drawn %lld ms after it was saved", milliseconds);
    if (milliseconds > 500)
        qWarning("that is more than half a second");
    QVERIFY(!(*m_window)->messageBar().isVisible());
}

void TestShaders::aHeaderIsWatchedToo() {
    const QImage before = seen();
    QByteArray text = read("blinn_phong.glsl");
    QVERIFY(read("Phong.frag").contains("blinn_phong.glsl"));
    write("blinn_phong.glsl", text + "\nthis is no GLSL\n");
    TRY_VERIFY((*m_window)->messageBar().text().contains("blinn_phong.glsl:"));
    write("blinn_phong.glsl", text);
    TRY_VERIFY(!(*m_window)->messageBar().isVisible());
    TRY_COMPARE(seen(), before);
}

void TestShaders::aNewShaderIsInBothSelectors() {
    auto* selector = (*m_window)->findChild<QComboBox*>("shaderSelector");
    QComboBox* box = (*m_window)->appearancePanel().shaderBox();
    QCOMPARE(box->findText("NEW"), -1);
    write("NEW.frag", plain("vec4(0, 0, 1, 1)"));
    TRY_VERIFY(box->findText("NEW") >= 0 && selector->findText("NEW") >= 0);
    QCOMPARE(box->currentText(), QStringLiteral("Phong")); // nothing else happens
    box->setFocus();
    while (box->currentText() != "NEW")
        m_window->key(box->currentIndex() > box->findText("NEW") ? Qt::Key_Up : Qt::Key_Down);
    TRY_COMPARE(middle(), QColor(0, 0, 255));
    QCOMPARE(selector->currentText(), QStringLiteral("NEW"));
    // Gone again, it is listed for as long as the scene names it.
    QVERIFY(QFile::remove(shader("NEW.frag")));
    TRY_VERIFY(m_window->output().contains("NEW.frag"));
    QVERIFY(box->findText("NEW") >= 0);
    m_window->document().newScene();
    TRY_COMPARE(box->findText("NEW"), -1);
    QCOMPARE(selector->findText("NEW"), -1);
}

void TestShaders::aUniformGetsItsControlAndMovesThePicture() {
    write("Phong.frag",
          plain("vec4(vec3(u_grey), 1)", "uniform float u_grey; // 0.2 [0, 1] \"Grey\" of all.\n"));
    ShaderControls& controls = *(*m_window)->appearancePanel().shaderControls();
    TRY_COMPARE(controls.uniforms().size(), std::size_t(1));
    ParameterRow* row = nullptr;
    TRY_VERIFY((row = controls.findChild<ParameterRow*>("u_grey")) && row->isVisible());
    QCOMPARE(row->spec().label, QStringLiteral("Grey"));
    QCOMPARE(row->value(), 0.2);
    TRY_COMPARE(middle(), QColor(51, 51, 51));
    const QImage before = seen();
    m_window->typeInto(row->field(), "0.6");
    m_window->key(Qt::Key_Return);
    TRY_COMPARE(middle(), QColor(153, 153, 153));
    QCOMPARE(m_window->document().undoStack().count(), 1);
    m_window->key(Qt::Key_Z, Qt::ControlModifier);
    TRY_COMPARE(seen(), before);
    // Another default in the file is the value of a scene that has none.
    write("Phong.frag",
          plain("vec4(vec3(u_grey), 1)", "uniform float u_grey; // 0.4 [0, 1] \"Grey\" of all.\n"));
    TRY_COMPARE(middle(), QColor(102, 102, 102));
    QVERIFY(!m_window->document().isModified());
}

void TestShaders::thePictureStaysWhereverTheViewIs_data() {
    QTest::addColumn<QString>("where");
    for (const char* where : {"in a window of its own", "full screen", "beside a floating panel", "hidden"})
        QTest::newRow(where) << QString(where);
}

void TestShaders::thePictureStaysWhereverTheViewIs() {
    QFETCH(const QString, where);
    MainWindow& window = **m_window;
    Viewport& view = m_window->viewport();
    write("Phong.frag", plain("u_color", "uniform vec4 u_color;\nuniform float u_other; // 1\n"));
    TRY_COMPARE(middle(), QColor(255, 255, 255));
    const QImage before = seen();
    if (where == "in a window of its own") {
        QWidget* home = view.parentWidget();
        view.setParent(nullptr);
        view.resize(500, 400);
        view.show();
        QVERIFY(QTest::qWaitForWindowExposed(&view, kPatience));
        TRY_COMPARE(middle(), QColor(255, 255, 255));
        home->layout()->addWidget(&view);
        view.show();
    } else if (where == "full screen") {
        window.actions().fullScreen->trigger();
        TRY_VERIFY(window.isFullScreen()); // as large as the screen only where there is a window manager
        TRY_COMPARE(middle(), QColor(255, 255, 255));
        window.actions().fullScreen->trigger();
    } else if (where == "beside a floating panel") {
        window.dock("appearance")->setFloating(true);
        QVERIFY(QTest::qWaitForWindowExposed(window.dock("appearance"), kPatience));
        window.dock("appearance")->setFloating(false);
    } else {
        window.hide();
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window, kPatience));
    }
    TRY_COMPARE(seen().size(), before.size());
    TRY_COMPARE(seen(), before);
    QVERIFY(!window.messageBar().isVisible());
    // It still hears of files.
    write("Phong.frag", plain("vec4(1, 0, 0, 1)"));
    TRY_COMPARE(middle(), QColor(255, 0, 0));
}

CLOTHLAB_DISPLAY_TEST_MAIN(TestShaders)
#include "tst_shaders.moc"
