// The files that a scene names: relative to it on disk, absolute in memory.
#include "app/document/document.h"
#include "simcore/scene/range.h"
#include "simcore/scene/scene_io.h"
#include "tests/support/tiny_scene.h"

#include <QDir>
#include <QTemporaryDir>
#include <QTest>

using namespace clothlab;

namespace {

std::string text(const QString& path) {
    return path.toStdString();
}

// Of the file at `path`, as it is there.
Scene onDisk(const QString& path) {
    const SceneReading reading = loadScene(path.toStdString());
    if (!reading.scene)
        qFatal("%s holds no scene", qPrintable(path));
    return *reading.scene;
}

const UniformValue& uniform(const Scene& scene, const char* name) {
    return scene.appearance.uniforms.at("Fur").find(name)->second;
}

} // namespace

class TestSceneFiles : public QObject {
    Q_OBJECT
private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(QDir(m_folder->path()).mkpath("scenes/textures"));
        QVERIFY(QDir(m_folder->path()).mkpath("elsewhere/deep"));
        m_scene = test::tinyScene();
        m_scene.appearance.textures = {"textures/linen.png", "", "../wool.jpg", "größe ✓.png"};
        m_scene.appearance.cubemap = "sky";
        m_scene.appearance.uniforms["Fur"] = {{"u_map", UniformValue("textures/fur.png")},
                                              {"u_none", UniformValue(std::string())},
                                              {"u_length", UniformValue(0.25)},
                                              {"u_tint", UniformValue(std::vector<double>{1, 0, 0})}};
        m_path = in("scenes/a.json");
        QVERIFY(!saveScene(m_scene, text(m_path)));
    }

    void filesAreAbsoluteInMemory() {
        Document document;
        QVERIFY(!hasErrors(document.open(m_path)));
        const Appearance& appearance = document.scene().appearance;
        QCOMPARE(appearance.textures[0], text(in("scenes/textures/linen.png")));
        QCOMPARE(appearance.textures[1], std::string()); // what comes with the program
        QCOMPARE(appearance.textures[2], text(in("wool.jpg")));
        QCOMPARE(appearance.textures[3], text(in("scenes/größe ✓.png")));
        QCOMPARE(appearance.cubemap, text(in("scenes/sky")));
        QVERIFY(uniform(document.scene(), "u_map") == UniformValue(text(in("scenes/textures/fur.png"))));
        QVERIFY(uniform(document.scene(), "u_none") == UniformValue(std::string()));
        for (const char* name : {"u_length", "u_tint"})
            QVERIFY(uniform(document.scene(), name) == uniform(m_scene, name));
        QVERIFY(!document.isModified());
        QCOMPARE(document.undoStack().count(), 0);
        QVERIFY(validate(document.scene()).empty());
    }

    void savedInItsPlaceItIsAsItWas() {
        Document document;
        QVERIFY(!hasErrors(document.open(m_path)));
        const Scene before = document.scene();
        QVERIFY(!document.save(m_path));
        QVERIFY(onDisk(m_path) == m_scene);
        QVERIFY(document.scene() == before);
    }

    void savedElsewhereItStillNamesTheSameFiles_data() {
        QTest::addColumn<QString>("place");
        QTest::addColumn<QString>("linen");
        QTest::newRow("above") << "b.json"
                               << "scenes/textures/linen.png";
        QTest::newRow("below") << "scenes/textures/b.json"
                               << "linen.png";
        QTest::newRow("beside") << "elsewhere/b.json"
                                << "../scenes/textures/linen.png";
        QTest::newRow("far") << "elsewhere/deep/b.json"
                             << "../../scenes/textures/linen.png";
    }
    void savedElsewhereItStillNamesTheSameFiles() {
        QFETCH(QString, place);
        QFETCH(QString, linen);
        Document document;
        QVERIFY(!hasErrors(document.open(m_path)));
        const Scene before = document.scene();
        QVERIFY(!document.save(in(place)));
        QVERIFY(document.scene() == before);
        QCOMPARE(onDisk(in(place)).appearance.textures[0], text(linen));
        QVERIFY(onDisk(m_path) == m_scene); // the first file is left alone
        Document other;
        QVERIFY(!hasErrors(other.open(in(place))));
        QVERIFY(other.scene() == before);
    }

    void undoGoesOnAfterSavingElsewhere() {
        Document document;
        QVERIFY(!hasErrors(document.open(m_path)));
        const Scene before = document.scene();
        Scene after = before;
        after.appearance.textures[1] = text(in("wool.jpg"));
        document.edit("change Texture 2", after);
        QVERIFY(!document.save(in("elsewhere/b.json")));
        QVERIFY(!document.isModified());
        document.undoStack().undo();
        QVERIFY(document.scene() == before);
        QVERIFY(document.isModified());
        document.undoStack().redo();
        QVERIFY(document.scene() == after);
        QVERIFY(!document.isModified());
        // And what undo brought back is written relative to the new place.
        document.undoStack().undo();
        QVERIFY(!document.save(document.path()));
        QCOMPARE(onDisk(document.path()).appearance.cubemap, std::string("../scenes/sky"));
        QCOMPARE(onDisk(document.path()).appearance.textures[1], std::string());
    }

    void aNewSceneIsSavedRelativeToItsFirstPlace() {
        Document document;
        Scene after = document.scene();
        after.appearance.textures[0] = text(in("scenes/textures/linen.png"));
        document.edit("change Texture 1", after);
        const QString before = QDir::currentPath();
        QVERIFY(QDir::setCurrent(in("elsewhere")));
        const auto error = document.save("new.json");
        QVERIFY(QDir::setCurrent(before));
        QVERIFY2(!error, qPrintable(error.value_or("")));
        QCOMPARE(onDisk(in("elsewhere/new.json")).appearance.textures[0],
                 std::string("../scenes/textures/linen.png"));
    }

    void aSceneThatWasMovedWithItsFilesFindsThem() {
        QVERIFY(QDir().rename(in("scenes"), in("moved")));
        Document document;
        QVERIFY(!hasErrors(document.open(in("moved/a.json"))));
        QCOMPARE(document.scene().appearance.textures[0], text(in("moved/textures/linen.png")));
    }

    void anAbsoluteNameStays() {
        m_scene.appearance.cubemap = text(in("elsewhere/deep"));
        QVERIFY(!saveScene(m_scene, text(m_path)));
        Document document;
        QVERIFY(!hasErrors(document.open(m_path)));
        QCOMPARE(document.scene().appearance.cubemap, text(in("elsewhere/deep")));
    }

    void aSaveThatFailsLeavesTheNames() {
        Document document;
        QVERIFY(!hasErrors(document.open(m_path)));
        const Scene before = document.scene();
        QVERIFY(document.save(in("none/b.json")).has_value());
        QVERIFY(document.scene() == before);
        QCOMPARE(document.path(), m_path);
    }

    // An edit needs a scene that is valid.
    void aNameThatWouldBecomeTooLongStays() {
        const std::string longest(kMaxFileNameBytes, 'x');
        m_scene.appearance.textures[0] = longest;
        QVERIFY(!saveScene(m_scene, text(m_path)));
        Document document;
        QVERIFY(!hasErrors(document.open(m_path)));
        QCOMPARE(document.scene().appearance.textures[0], longest);
        QVERIFY(!document.setParameter(*findParameter("cloth.ks"), 100));
    }

private:
    QString in(const QString& name) const { return m_folder->filePath(name); }

    std::unique_ptr<QTemporaryDir> m_folder;
    Scene m_scene;
    QString m_path;
};

QTEST_GUILESS_MAIN(TestSceneFiles)
#include "tst_scene_files.moc"
