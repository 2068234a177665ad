// The grid's points and springs against a listing by brute force.
#include "simcore/cloth/grid.h"

#include <QtTest>

#include <algorithm>

using namespace clothlab;

namespace {

// In the order of the strain limit, as the model's text has it.
std::vector<Spring> listSprings(const Grid& grid) {
    constexpr int kSteps[6][2] = {{-1, 0}, {0, -1}, {-1, -1}, {1, -1}, {-2, 0}, {0, -2}};
    std::vector<Spring> springs;
    for (int stencil = 0; stencil < 6; ++stencil)
        for (int y = 0; y < grid.height; ++y)
            for (int x = 0; x < grid.width; ++x) {
                const int otherX = x + kSteps[stencil][0];
                const int otherY = y + kSteps[stencil][1];
                if (otherX >= 0 && otherX < grid.width && otherY >= 0)
                    springs.push_back({stencil, y * grid.width + x, otherY * grid.width + otherX});
            }
    return springs;
}

template <typename Check>
void forEachGrid(Check check) {
    for (int height = 1; height <= 7; ++height)
        for (int width = 1; width <= 7; ++width)
            check(Grid{width, height});
}

int count(const std::vector<Spring>& springs, SpringType type) {
    return int(
        std::count_if(springs.begin(), springs.end(), [&](const Spring& s) { return s.type() == type; }));
}

} // namespace

class TestGrid : public QObject {
    Q_OBJECT

private slots:
    void countsOfTheModel();
    void countsMatchTheListing();
    void springsMatchTheListing();
    void numberAndSpringRoundTrip();
    void noSuchSpring();
    void springsOfAPoint();
    void placesAndIndices();
    void names();
};

void TestGrid::countsOfTheModel() {
    const Grid grid{50, 50};
    QCOMPARE(grid.springCount(SpringType::Structural), 4900);
    QCOMPARE(grid.springCount(SpringType::Shearing), 4802);
    QCOMPARE(grid.springCount(SpringType::Bending), 4800);
    QCOMPARE(grid.springCount(), 14502);
    for (int nx = 2; nx < 9; ++nx)
        for (int ny = 2; ny < 9; ++ny) {
            const Grid g{nx, ny};
            QCOMPARE(g.springCount(SpringType::Structural), 2 * nx * ny - nx - ny);
            QCOMPARE(g.springCount(SpringType::Shearing), 2 * (nx - 1) * (ny - 1));
            QCOMPARE(g.springCount(SpringType::Bending), 2 * nx * ny - 2 * nx - 2 * ny);
        }
}

void TestGrid::countsMatchTheListing() {
    forEachGrid([](const Grid& grid) {
        const std::vector<Spring> all = listSprings(grid);
        QCOMPARE(grid.springCount(), int(all.size()));
        for (const SpringType type : {SpringType::Structural, SpringType::Shearing, SpringType::Bending})
            QCOMPARE(grid.springCount(type), count(all, type));
    });
}

void TestGrid::springsMatchTheListing() {
    forEachGrid([](const Grid& grid) {
        const std::vector<Spring> all = listSprings(grid);
        for (int n = 0; n < int(all.size()); ++n) {
            const Spring s = grid.spring(n);
            QCOMPARE(s.stencil, all[std::size_t(n)].stencil);
            QCOMPARE(s.a, all[std::size_t(n)].a);
            QCOMPARE(s.b, all[std::size_t(n)].b);
        }
    });
}

void TestGrid::numberAndSpringRoundTrip() {
    forEachGrid([](const Grid& grid) {
        for (int n = 0; n < grid.springCount(); ++n) {
            const Spring s = grid.spring(n);
            QCOMPARE(grid.springNumber(s.stencil, s.a), n);
        }
    });
}

void TestGrid::noSuchSpring() {
    forEachGrid([](const Grid& grid) {
        const std::vector<Spring> all = listSprings(grid);
        for (int stencil = 0; stencil < 6; ++stencil)
            for (int a = 0; a < grid.pointCount(); ++a) {
                const bool exists = std::any_of(all.begin(), all.end(), [&](const Spring& s) {
                    return s.stencil == stencil && s.a == a;
                });
                QCOMPARE(grid.springNumber(stencil, a) >= 0, exists);
                QVERIFY(exists || grid.springNumber(stencil, a) == -1);
            }
    });
}

void TestGrid::springsOfAPoint() {
    forEachGrid([](const Grid& grid) {
        const std::vector<Spring> all = listSprings(grid);
        for (int point = 0; point < grid.pointCount(); ++point) {
            std::vector<int> expected;
            for (int n = 0; n < int(all.size()); ++n)
                if (all[std::size_t(n)].a == point || all[std::size_t(n)].b == point)
                    expected.push_back(n);
            QCOMPARE(grid.springsOf(point), expected);
        }
    });
    const Grid grid{50, 50};
    QCOMPARE(int(grid.springsOf(grid.index(20, 20)).size()), 12);
}

void TestGrid::placesAndIndices() {
    forEachGrid([](const Grid& grid) {
        QCOMPARE(grid.pointCount(), grid.width * grid.height);
        for (int i = 0; i < grid.pointCount(); ++i) {
            QCOMPARE(grid.index(grid.place(i)), i);
            QCOMPARE(grid.place(i).x, i % grid.width);
        }
    });
}

void TestGrid::names() {
    QCOMPARE(name(SpringType::Structural), std::string_view("structural"));
    QCOMPARE(name(SpringType::Shearing), std::string_view("shearing"));
    QCOMPARE(name(SpringType::Bending), std::string_view("bending"));
}

QTEST_APPLESS_MAIN(TestGrid)
#include "tst_grid.moc"
