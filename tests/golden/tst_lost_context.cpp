// A context goes with its window; the picture comes back in the next one.
#include "app/render/shader_library.h"
#include "tests/golden/canvas.h"

#include <optional>

using namespace clothlab::render;

namespace {

// Every pass and every kind of GL object has a part in it.
RenderFrame fullFrame() {
    RenderFrame frame = flatFrame(12);
    frame.groundGrid = true;
    frame.axes = true;
    frame.springs.overSurface = true;
    frame.springs.coloredByStrain = true;
    frame.surface.meshResolution = 20;
    frame.light.shadows = true;
    frame.samples = 4;
    frame.sheet.pinned = {0, 11};
    frame.sheet.strains.assign(144, 0.05F);
    frame.sheet.restPositions = std::make_shared<std::vector<float>>(frame.sheet.positions);
    frame.spheres = {{QVector3D(0.5F, 0.3F, 0.5F), 0.3F}};
    frame.planes = {{QVector3D(0, 0, 0), QVector3D(0, 1, 0)}};
    frame.highlight.points = {QVector3D(0.2F, 0.5F, 0.2F)};
    frame.highlight.segments = {{QVector3D(0.3F, 0.5F, 0.5F), QVector3D(0.7F, 0.5F, 0.5F)}};
    return frame;
}

} // namespace

class LostContextTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { SKIP_WITHOUT_OPENGL(); }
    void init() { QVERIFY(m_studio.emplace().isGood()); }
    void cleanup() { m_studio.reset(); }

    void survivesALostContext_data();
    void survivesALostContext();
    void choicesOutliveTheContext();
    void aBrokenShaderStillShowsWhatWasGood();

private:
    std::optional<Studio> m_studio;
};

void LostContextTest::survivesALostContext_data() {
    QTest::addColumn<QString>("shader");
    for (const QString& name : listShaders(kShaders))
        QTest::newRow(qPrintable(name)) << name;
}

void LostContextTest::survivesALostContext() {
    QFETCH(QString, shader);
    RenderFrame frame = fullFrame();
    frame.surface.shader = shader;
    const QImage first = m_studio->draw(frame);
    QVERIFY(!first.isNull());
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));

    m_studio->renderer.release();
    QVERIFY(!m_studio->renderer.isInitialized());
    QVERIFY(m_studio->beginNewContext());
    QCOMPARE(m_studio->draw(frame), first);

    QVERIFY(m_studio->beginNewContext()); // the last one gone without a chance to release
    QCOMPARE(m_studio->draw(frame), first);
    QCOMPARE(m_studio->draw(frame), first);
}

// Files that a user chose, and a value that a user set, are used again in the new context.
void LostContextTest::choicesOutliveTheContext() {
    RenderFrame frame = fullFrame();
    frame.surface.shader = QStringLiteral("Texture");
    const QImage plain = m_studio->draw(frame);
    frame.surface.textures[0] = QStringLiteral("texture_4.png");
    frame.surface.uniforms[frame.surface.shader][QStringLiteral("u_tiles")] = {2, {3, 2}, {}};
    const QImage chosen = m_studio->draw(frame);
    QVERIFY(chosen != plain);
    m_studio->loseContext();
    QVERIFY(m_studio->beginNewContext());
    QCOMPARE(m_studio->draw(frame), chosen);
}

void LostContextTest::aBrokenShaderStillShowsWhatWasGood() {
    const ShaderDirectory directory;
    const QByteArray head = "#version 330\nin vec2 v_uv; out vec4 out_color;\n";
    QVERIFY(directory.write(QStringLiteral("Mine.frag"),
                            head + "void main() { out_color = vec4(v_uv, 1, 1); }\n"));
    m_studio->renderer.setShaderDirectory(directory.path());
    RenderFrame frame = fullFrame();
    frame.surface.shader = QStringLiteral("Mine");
    const QImage good = m_studio->draw(frame);
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
    QVERIFY(directory.write(QStringLiteral("Mine.frag"), head + "void main() { out_color = nothing; }\n"));
    m_studio->renderer.reloadFiles();
    QCOMPARE(m_studio->draw(frame), good);
    for (const bool released : {true, false}) {
        if (released)
            m_studio->renderer.release();
        m_studio->loseContext();
        QVERIFY(m_studio->beginNewContext());
        QCOMPARE(m_studio->draw(frame), good);
        QVERIFY(m_studio->faults().contains(QStringLiteral("Mine.frag:3")));
    }
}

int main(int argc, char** argv) {
    return runOnDisplay<LostContextTest>(argc, argv);
}
#include "tst_lost_context.moc"
