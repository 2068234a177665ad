// What differs between two scenes, in words.
#include "simcore/scene/scene_differences.h"

#include <QtTest>

using namespace clothlab;

class TestSceneDifferences : public QObject {
    Q_OBJECT

private slots:
    void everyPartIsNamed() {
        const Scene before;
        Scene after = before;
        QVERIFY(motionDifferences(before, after).empty());
        after.appearance.shader = "Normal";
        after.appearance.samples = 1;
        QVERIFY(motionDifferences(before, after).empty()); // it moves no sheet
        after.cloth.ks = 4999.5;
        after.simulation.gravity.y() = 0;
        after.cloth.pinned = {{0, 0}};
        after.spheres.emplace_back();
        after.planes.emplace_back();
        const std::vector<std::string> expected{"cloth.ks 5000 -> 4999.5", "simulation.gravity[1] -9.8 -> 0",
                                                "the pins", "the spheres", "the planes"};
        std::vector<std::string> found;
        for (const SceneDifference& difference : motionDifferences(before, after))
            found.push_back(toText(difference));
        QVERIFY(found == expected);
    }
};

QTEST_APPLESS_MAIN(TestSceneDifferences)
#include "tst_scene_differences.moc"
