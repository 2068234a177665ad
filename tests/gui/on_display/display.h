// A test of the window on a real display, with OpenGL.
#pragma once

#include "tests/gui/test_window.h"

#include <QSurfaceFormat>

namespace clothlab {

// In initTestCase(): skips without a display or OpenGL, or fails where CLOTHLAB_REQUIRE_GL is 1.
#define CLOTHLAB_NEEDS_PICTURE()                                                                             \
    do {                                                                                                     \
        TestWindow probe;                                                                                    \
        const bool there = probe.viewport().hasPicture();                                                    \
        const bool required = qEnvironmentVariable("CLOTHLAB_REQUIRE_GL") == "1";                            \
        QVERIFY2(there || !required, "CLOTHLAB_REQUIRE_GL is 1, and there is no display or no OpenGL");      \
        if (!there)                                                                                          \
            QSKIP("There is no display or no OpenGL.");                                                      \
    } while (false)

// Without a display the default platform would abort, where a test wants to say what is missing. The format
// is the one that the program asks for.
inline void prepareDisplay() {
    if (!qEnvironmentVariableIsSet("QT_QPA_PLATFORM") && !qEnvironmentVariableIsSet("DISPLAY") &&
        !qEnvironmentVariableIsSet("WAYLAND_DISPLAY"))
        qputenv("QT_QPA_PLATFORM", "offscreen");
    QSurfaceFormat format;
    format.setVersion(3, 3);
    format.setProfile(QSurfaceFormat::CoreProfile);
    format.setDepthBufferSize(24);
    QSurfaceFormat::setDefaultFormat(format);
}

#define CLOTHLAB_DISPLAY_TEST_MAIN(Test)                                                                     \
    int main(int argc, char** argv) {                                                                        \
        prepareDisplay();                                                                                    \
        QApplication application(argc, argv);                                                                \
        Test test;                                                                                           \
        return QTest::qExec(&test, argc, argv);                                                              \
    }

} // namespace clothlab
