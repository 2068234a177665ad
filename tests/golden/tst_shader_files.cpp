// Which files a shader is made of, and when they are read.
#include "app/render/shader_library.h"
#include "tests/golden/canvas.h"

#include <optional>

using namespace clothlab::render;

class ShaderFilesTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() { SKIP_WITHOUT_OPENGL(); }
    void init() { QVERIFY(m_studio.emplace().isGood()); }
    void cleanup() { m_studio.reset(); }

    void listsShadersOnly();
    void brokenShaderKeepsDrawing();
    void problemsAreOfWhatIsDrawn();
    void editedShaderIsReadAgain();
    void directoryCanChange();
    void shaderWithItsOwnVertexShader();
    void directoryWithoutAnyShader();

private:
    std::optional<Studio> m_studio;
};

void ShaderFilesTest::listsShadersOnly() {
    QCOMPARE(listShaders(kShaders).first(), QStringLiteral("Wireframe"));
    for (const char* name : {"Diffuse", "Normal", "Phong"})
        QVERIFY(listShaders(kShaders).contains(QLatin1String(name)));
    QVERIFY(!listShaders(kShaders).contains(QStringLiteral("line")));
    QVERIFY(listShaders(QStringLiteral("/nowhere")).isEmpty());
    QVERIFY(listShaders(QString()).isEmpty());

    ShaderDirectory directory;
    for (const char* name : {"b.frag", "A.frag", "Wireframe.frag", "Default.vert", "notes.txt"})
        QVERIFY(directory.write(QLatin1String(name), " "));
    QCOMPARE(listShaders(directory.path()),
             QStringList({QStringLiteral("Wireframe"), QStringLiteral("A"), QStringLiteral("b")}));
}

void ShaderFilesTest::brokenShaderKeepsDrawing() {
    ShaderDirectory directory;
    QVERIFY(directory.write(QStringLiteral("Red.frag"), kRedShader));
    QVERIFY(
        directory.write(QStringLiteral("Broken.frag"),
                        "#version 330\nout vec4 out_color;\nvoid main() {\n  out_color = nonsense;\n}\n"));
    QVERIFY(directory.write(
        QStringLiteral("Unlinked.frag"),
        "#version 330\nvec4 elsewhere();\nout vec4 out_color;\nvoid main() { out_color = elsewhere(); }\n"));
    QVERIFY(directory.write(QStringLiteral("Wireframe.frag"), "#version 330\nvoid main() { ! }\n"));
    m_studio->renderer.setShaderDirectory(directory.path());
    RenderFrame frame = flatFrame(5);
    const QPoint middle = toPixel(frame, QVector3D(0.4F, 0.5F, 0.4F));

    frame.surface.shader = QStringLiteral("Broken"); // nothing was good before: plain
    QVERIFY(qRed(m_studio->draw(frame).pixel(middle)) > 150);
    QVERIFY2(m_studio->faults().startsWith(QStringLiteral("Broken.frag:4: ")),
             qPrintable(m_studio->faults()));

    frame.surface.shader = QStringLiteral("Red");
    QVERIFY(isNear(m_studio->draw(frame).pixel(middle), qRgb(255, 0, 0), 0));
    QVERIFY(m_studio->renderer.problems().isEmpty());

    for (const char* name : {"Broken", "Unlinked", "Missing"}) {
        frame.surface.shader = QLatin1String(name);
        QVERIFY(isNear(m_studio->draw(frame).pixel(middle), qRgb(255, 0, 0), 0));
        QVERIFY2(m_studio->faults().contains(frame.surface.shader + QStringLiteral(".frag")),
                 qPrintable(m_studio->faults()));
    }

    frame.surface.shader = QStringLiteral("Wireframe");
    QVERIFY(countPixels(m_studio->draw(frame), frame.springs.colors[0], 40) > 50);
    QVERIFY2(m_studio->faults().contains(QStringLiteral("Wireframe.frag:2: ")),
             qPrintable(m_studio->faults()));
}

void ShaderFilesTest::problemsAreOfWhatIsDrawn() {
    ShaderDirectory directory;
    QVERIFY(directory.write(QStringLiteral("Red.frag"), kRedShader));
    QVERIFY(directory.write(QStringLiteral("Broken.frag"), "#version 330\nvoid main() { ! }\n"));
    m_studio->renderer.setShaderDirectory(directory.path());
    RenderFrame frame = flatFrame(5);
    for (const char* name : {"Broken", "Wireframe", "Red"}) {
        frame.surface.shader = QLatin1String(name);
        m_studio->draw(frame);
        QCOMPARE(m_studio->renderer.problems().isEmpty(), frame.surface.shader != QLatin1String("Broken"));
    }
    QVERIFY(directory.write(QStringLiteral("Wireframe.frag"), "#version 330\nvoid main() { ! }\n"));
    m_studio->renderer.reloadFiles();
    for (const bool shown : {false, true, false}) {
        frame.springs.overSurface = shown;
        m_studio->draw(frame);
        QCOMPARE(!m_studio->renderer.problems().isEmpty(), shown);
    }
}

void ShaderFilesTest::editedShaderIsReadAgain() {
    ShaderDirectory directory;
    const QString file = QStringLiteral("Mine.frag");
    QVERIFY(directory.write(file, kRedShader));
    m_studio->renderer.setShaderDirectory(directory.path());
    RenderFrame frame = flatFrame(5);
    frame.surface.shader = QStringLiteral("Mine");
    const QPoint middle = toPixel(frame, QVector3D(0.4F, 0.5F, 0.4F));
    QVERIFY(isNear(m_studio->draw(frame).pixel(middle), qRgb(255, 0, 0), 0));

    QVERIFY(directory.write(file, QByteArray("\xEF\xBB\xBF") +
                                      QByteArray(kRedShader).replace("1, 0, 0", "0, 0, 1")));
    QVERIFY(isNear(m_studio->draw(frame).pixel(middle), qRgb(255, 0, 0), 0));
    m_studio->renderer.reloadFiles();
    QVERIFY(isNear(m_studio->draw(frame).pixel(middle), qRgb(0, 0, 255), 0));
    QVERIFY(directory.write(file, "#version 330\n\nsyntax!\n"));
    m_studio->renderer.reloadFiles();
    QVERIFY(isNear(m_studio->draw(frame).pixel(middle), qRgb(0, 0, 255), 0));
    QVERIFY(m_studio->faults().startsWith(QStringLiteral("Mine.frag:3: ")));
}

void ShaderFilesTest::directoryCanChange() {
    ShaderDirectory red;
    ShaderDirectory blue;
    QVERIFY(red.write(QStringLiteral("Mine.frag"), kRedShader));
    QVERIFY(blue.write(QStringLiteral("Mine.frag"), QByteArray(kRedShader).replace("1, 0, 0", "0, 0, 1")));
    RenderFrame frame = flatFrame(5);
    frame.surface.shader = QStringLiteral("Mine");
    const QPoint middle = toPixel(frame, QVector3D(0.4F, 0.5F, 0.4F));
    m_studio->renderer.setShaderDirectory(red.path());
    QVERIFY(isNear(m_studio->draw(frame).pixel(middle), qRgb(255, 0, 0), 0));
    m_studio->renderer.setShaderDirectory(blue.path());
    QVERIFY(isNear(m_studio->draw(frame).pixel(middle), qRgb(0, 0, 255), 0));
}

void ShaderFilesTest::shaderWithItsOwnVertexShader() {
    ShaderDirectory directory;
    QVERIFY(directory.write(QStringLiteral("Moved.frag"), kRedShader));
    QVERIFY(directory.write(
        QStringLiteral("Moved.vert"),
        "#version 330\nuniform mat4 u_view_projection; uniform float u_height_scaling;\n"
        "in vec4 in_position;\nvoid main() {\n"
        "  gl_Position = u_view_projection * (in_position + vec4(20.0 * u_height_scaling, 0, 0, 0));\n}\n"));
    m_studio->renderer.setShaderDirectory(directory.path());
    RenderFrame frame = flatFrame(5);
    frame.surface.shader = QStringLiteral("Moved"); // 2 m aside: out of the picture
    QCOMPARE(countPixels(m_studio->draw(frame), frame.background, 0), kSize.width() * kSize.height());
    QVERIFY2(m_studio->faults().isEmpty(), qPrintable(m_studio->faults()));
}

void ShaderFilesTest::directoryWithoutAnyShader() {
    m_studio->renderer.setShaderDirectory(QStringLiteral("/nowhere"));
    RenderFrame frame = flatFrame(5);
    frame.springs.overSurface = true;
    const QImage image = m_studio->draw(frame);
    QVERIFY(qRed(image.pixel(toPixel(frame, QVector3D(0.44F, 0.5F, 0.36F)))) > 100);
    QVERIFY(countPixels(image, frame.springs.colors[0], 40) > 25);
    QCOMPARE(m_studio->renderer.problems().size(), 1);
}

int main(int argc, char** argv) {
    return runOnDisplay<ShaderFilesTest>(argc, argv);
}
#include "tst_shader_files.moc"
