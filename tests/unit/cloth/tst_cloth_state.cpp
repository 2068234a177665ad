// Where a sheet starts, its rest lengths and masses, and the hash of a state.
#include "simcore/base/checksum.h"
#include "simcore/cloth/cloth_state.h"
#include "tests/support/random.h"

#include <QtTest>

#include <bit>
#include <cmath>

using namespace clothlab;

namespace {

Scene sheetScene(Orientation orientation) {
    Scene scene;
    scene.cloth.numWidthPoints = 7;
    scene.cloth.numHeightPoints = 4;
    scene.cloth.width = 1.2;
    scene.cloth.height = 0.9;
    scene.cloth.orientation = orientation;
    return scene;
}

// Each number's lowest byte first.
std::string bytesOf(const std::vector<double>& values) {
    std::string bytes;
    for (const double value : values)
        for (unsigned shift = 0; shift < 64; shift += 8)
            bytes += static_cast<char>(std::bit_cast<std::uint64_t>(value) >> shift & 0xFFU);
    return bytes;
}

double flipped(double value, unsigned bit) {
    return std::bit_cast<double>(std::bit_cast<std::uint64_t>(value) ^ (std::uint64_t(1) << bit));
}

} // namespace

class TestClothState : public QObject {
    Q_OBJECT

private slots:
    void horizontalStart();
    void verticalStart();
    void unevennessIsSplitMix64();
    void seedsRepeatAndDiffer();
    void horizontalTakesNoSeed();
    void restLengths();
    void restLengthsOfAnUnevenSheet();
    void massAndStiffness();
    void pinnedPoints();
    void hashIsThatOfTheBits();
    void hashChangesWithEveryBit();
};

void TestClothState::horizontalStart() {
    const ClothState state = startState(sheetScene(Orientation::Horizontal));
    QCOMPARE(int(state.size()), 28);
    for (int i = 0; i < 28; ++i)
        QVERIFY((state.position.at(i) - Vec3(i % 7 * 0.2, 1, i / 7 * 0.3)).norm() < 1e-15);
    QCOMPARE(state.lastPosition, state.position);
}

void TestClothState::verticalStart() {
    Scene scene = sheetScene(Orientation::Vertical);
    double least = 1;
    double greatest = -1;
    for (std::uint32_t seed = 0; seed < 100; ++seed) {
        scene.simulation.seed = seed;
        const ClothState state = startState(scene);
        QCOMPARE(state.lastPosition, state.position);
        for (int i = 0; i < 28; ++i) {
            const Vec3 p = state.position.at(i);
            QVERIFY((p - Vec3(i % 7 * 0.2, i / 7 * 0.3, p.z())).norm() < 1e-15);
            least = std::min(least, p.z());
            greatest = std::max(greatest, p.z());
        }
    }
    QVERIFY(least >= -0.001 && least < -0.00098);
    QVERIFY(greatest <= 0.001 && greatest > 0.00098);
}

// The generator's published first outputs for seed 0.
void TestClothState::unevennessIsSplitMix64() {
    const ClothState state = startState(sheetScene(Orientation::Vertical));
    const std::uint64_t outputs[] = {0xE220A8397B1DCDAFU, 0x6E789E6AA1B965F4U, 0x06C45D188009454FU};
    SplitMix64 random(0);
    for (std::size_t i = 0; i < std::size(outputs); ++i) {
        QCOMPARE(random.next(), outputs[i]);
        const double u = std::ldexp(double(outputs[i] >> 11U), -53);
        QCOMPARE(std::bit_cast<std::uint64_t>(state.position.z[i]),
                 std::bit_cast<std::uint64_t>(-0.001 + 0.002 * u));
    }
}

void TestClothState::seedsRepeatAndDiffer() {
    Scene scene = sheetScene(Orientation::Vertical);
    const ClothState first = startState(scene);
    QCOMPARE(startState(scene), first);
    scene.simulation.seed = 1;
    QVERIFY(!(startState(scene) == first));
    scene.simulation.seed = 4294967295U;
    QCOMPARE(startState(scene), startState(scene));
}

void TestClothState::horizontalTakesNoSeed() {
    Scene scene = sheetScene(Orientation::Horizontal);
    const ClothState first = startState(scene);
    scene.simulation.seed = 77;
    QCOMPARE(startState(scene), first);
}

void TestClothState::restLengths() {
    const Scene scene = sheetScene(Orientation::Horizontal);
    const Grid grid{7, 4};
    const Sheet sheet{grid, startState(scene).position};
    QCOMPARE(sheet.grid, grid);
    const double expected[] = {0.2, 0.3, std::hypot(0.2, 0.3), std::hypot(0.2, 0.3), 0.4, 0.6};
    for (int n = 0; n < grid.springCount(); ++n) {
        const Spring s = grid.spring(n);
        QVERIFY(std::abs(sheet.restLengthOf(s) - expected[s.stencil]) < 1e-15);
    }
}

void TestClothState::restLengthsOfAnUnevenSheet() {
    const Scene scene = sheetScene(Orientation::Vertical);
    const Grid grid{7, 4};
    const PointArray start = startState(scene).position;
    const Sheet sheet{grid, start};
    for (int n = 0; n < grid.springCount(); ++n) {
        const Spring spring = grid.spring(n);
        const double expected = (start.at(spring.a) - start.at(spring.b)).norm();
        QVERIFY(std::abs(sheet.restLengthOf(spring) - expected) < 1e-16);
    }
}

void TestClothState::massAndStiffness() {
    Cloth cloth;
    QVERIFY(std::abs(pointMass(cloth) - 0.06) < 1e-17);
    cloth.width = 2;
    cloth.numHeightPoints = 10;
    QVERIFY(std::abs(pointMass(cloth) - 0.6) < 1e-16);
    cloth.enableBending = false; // its stiffness is what it would be
    QCOMPARE(stiffness(cloth, SpringType::Structural), 5000.0);
    QCOMPARE(stiffness(cloth, SpringType::Shearing), 5000.0);
    QCOMPARE(stiffness(cloth, SpringType::Bending), 1000.0);
}

void TestClothState::pinnedPoints() {
    Cloth cloth = sheetScene(Orientation::Horizontal).cloth;
    cloth.pinned = {{0, 0}, {6, 3}, {2, 1}, {2, 1}};
    const std::vector<std::uint8_t> mask = pinnedMask(cloth);
    QCOMPARE(int(mask.size()), 28);
    for (int i = 0; i < 28; ++i)
        QCOMPARE(int(mask[std::size_t(i)]), i == 0 || i == 27 || i == 9 ? 1 : 0);
}

void TestClothState::hashIsThatOfTheBits() {
    ClothState state{PointArray(2), PointArray(2)};
    std::vector<double> values;
    for (PointArray* points : {&state.position, &state.lastPosition})
        for (std::vector<double>* coordinates : {&points->x, &points->y, &points->z})
            for (double& coordinate : *coordinates) {
                coordinate = double(values.size()) * 1e9 + 0.1;
                values.push_back(coordinate);
            }
    QCOMPARE(stateHash(state), checksum(bytesOf(values)));
    QCOMPARE(stateHash(ClothState{}), checksum(""));
}

void TestClothState::hashChangesWithEveryBit() {
    const ClothState state = startState(sheetScene(Orientation::Vertical));
    const std::uint64_t hash = stateHash(state);
    const ClothState copy = state;
    QCOMPARE(stateHash(copy), hash);
    for (std::vector<double> PointArray::*axis : {&PointArray::x, &PointArray::y, &PointArray::z})
        for (PointArray ClothState::*points : {&ClothState::position, &ClothState::lastPosition})
            for (const std::size_t i : {std::size_t(0), std::size_t(13), std::size_t(27)})
                for (unsigned bit = 0; bit < 64; ++bit) {
                    ClothState changed = state;
                    double& value = (changed.*points.*axis)[i];
                    value = flipped(value, bit);
                    QVERIFY(stateHash(changed) != hash);
                }
}

QTEST_APPLESS_MAIN(TestClothState)
#include "tst_cloth_state.moc"
