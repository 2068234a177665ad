// Files that are no scene, or one with something missing: told in words, and nothing is lost.
#include "tests/gui/dialog_answer.h"
#include "tests/gui/test_window.h"

#include <QJsonDocument>
#include <QJsonObject>

using namespace clothlab;

class TestBadScenes : public QObject {
    Q_OBJECT

private slots:
    void init() { m_window = std::make_unique<TestWindow>(); }
    void cleanup() { m_window.reset(); }

    void badScenesLeaveTheDocumentAsItWas_data();
    void badScenesLeaveTheDocumentAsItWas();
    void aSceneWithWarningsOpensAndTellsThem();
    void theMessageGoesAwayByAClickAndByOpeningAGoodScene();

private:
    MainWindow& window() { return **m_window; }
    void change() {
        m_window->typeInto(m_window->field("cloth.ks"), "777");
        m_window->key(Qt::Key_Return);
    }

    std::unique_ptr<TestWindow> m_window;
};

void TestBadScenes::badScenesLeaveTheDocumentAsItWas_data() {
    QTest::addColumn<QByteArray>("text");
    QTest::addColumn<QString>("says"); // the place in the file
    QTest::newRow("not JSON") << QByteArray("{\"cloth\": {") << QStringLiteral("bad.json");
    QTest::newRow("empty") << QByteArray() << QStringLiteral("bad.json");
    QTest::newRow("wrong type") << QByteArray(R"({"cloth": {"ks": "stiff"}})") << QStringLiteral("cloth.ks");
    QTest::newRow("out of range") << QByteArray(R"({"cloth": {"num_width_points": 1}})")
                                  << QStringLiteral("num_width_points");
    QTest::newRow("pin outside") << QByteArray(R"({"cloth": {"pinned": [[0, 900]]}})")
                                 << QStringLiteral("pinned[0]");
    QTest::newRow("no cloth") << QByteArray("[]") << QStringLiteral("bad.json");
}

void TestBadScenes::badScenesLeaveTheDocumentAsItWas() {
    QFETCH(const QByteArray, text);
    QFETCH(const QString, says);
    QVERIFY(m_window->load(smallScene()));
    change();
    QVERIFY(m_window->simulateTo(3));
    m_window->document().setSelection({{{Selection::Kind::Point, 3}}});
    const Scene before = m_window->scene();
    const QStringList recent = window().files().recentFiles();

    const QString bad = m_window->writeText("bad.json", text);
    for (const QString& path : {bad, m_window->path("not there.json"), m_window->path("")}) {
        DialogAnswer discard(QMessageBox::Discard);
        QVERIFY(!window().files().open(path));
        QVERIFY(window().messageBar().isVisible());
        const QString message = window().messageBar().text();
        QVERIFY2(message.startsWith("The scene was not opened. ") && message.contains(path.chopped(1)),
                 qPrintable(message));
        if (path == bad)
            QVERIFY2(message.contains(says), qPrintable(message));
        QVERIFY(m_window->output().contains(message.section('\n', 0, 0)));
        QVERIFY(m_window->scene() == before);
        QCOMPARE(m_window->document().displayName(), QStringLiteral("scene.json"));
        QCOMPARE(m_window->document().undoStack().count(), 1);
        QVERIFY(m_window->document().isModified());
        QCOMPARE(m_window->document().selection().items.size(), std::size_t(1));
        QCOMPARE(m_window->frameCount(), 4);
        QCOMPARE(m_window->frame(), 3);
        QCOMPARE(window().files().recentFiles(), recent);
    }
}

void TestBadScenes::aSceneWithWarningsOpensAndTellsThem() {
    QFile file(m_window->write("odd.json", smallScene()));
    QVERIFY(file.open(QIODevice::ReadOnly));
    QJsonObject scene = QJsonDocument::fromJson(file.readAll()).object();
    QJsonObject cloth = scene["cloth"].toObject();
    QVERIFY(cloth.contains("ks"));
    cloth.remove("ks");
    scene["cloth"] = cloth;
    const QString path = m_window->writeText("odd.json", QJsonDocument(scene).toJson());
    QVERIFY(window().files().open(path));
    QVERIFY2(m_window->output().contains("odd.json: cloth.ks: is missing"), qPrintable(m_window->output()));
    QVERIFY(window().statusBar()->currentMessage().contains("with warnings"));
    QCOMPARE(window().messageBar().text(), QString());
}

void TestBadScenes::theMessageGoesAwayByAClickAndByOpeningAGoodScene() {
    const QString bad = m_window->writeText("bad.json", "{");
    window().files().open(bad);
    QVERIFY(window().messageBar().isVisible());
    m_window->click(window().messageBar().findChild<QToolButton*>("closeMessage"));
    QVERIFY(!window().messageBar().isVisible());
    window().files().open(bad);
    QVERIFY(window().messageBar().isVisible());
    QVERIFY(m_window->load(smallScene()));
    QVERIFY(!window().messageBar().isVisible());
}

CLOTHLAB_GUI_TEST_MAIN(TestBadScenes)
#include "tst_bad_scenes.moc"
