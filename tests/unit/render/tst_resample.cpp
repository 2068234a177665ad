// Finer and coarser grids of the same sheet.
#include "app/render/resample.h"

#include <QTest>

#include <cmath>

using namespace clothlab::render;

namespace {

using Point = std::array<float, 3>;

template <typename Place>
SheetShape sheetOf(int width, int height, Place place) {
    SheetShape sheet;
    sheet.width = width;
    sheet.height = height;
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const Point p = place(width > 1 ? float(x) / float(width - 1) : 0.0F,
                                  height > 1 ? float(y) / float(height - 1) : 0.0F);
            sheet.positions.insert(sheet.positions.end(), p.begin(), p.end());
            sheet.strains.push_back(p[0] + 2 * p[2]);
        }
    return sheet;
}

Point linear(float u, float v) {
    return {3 * u - 1, u - 2 * v + 0.5F, 0.25F + v};
}

Point quadratic(float u, float v) {
    return {u, u * u - v * v + 0.5F * u * v, v};
}

Point pointOf(const SheetShape& sheet, int x, int y) {
    const auto i = static_cast<std::size_t>(3 * (y * sheet.width + x));
    return {sheet.positions[i], sheet.positions[i + 1], sheet.positions[i + 2]};
}

// The greatest distance from `place`, `margin` cells away from the edges.
template <typename Place>
float worst(const SheetShape& sheet, Place place, float margin = 0) {
    float far = 0;
    for (int y = 0; y < sheet.height; ++y)
        for (int x = 0; x < sheet.width; ++x) {
            const float u = float(x) / float(sheet.width - 1);
            const float v = float(y) / float(sheet.height - 1);
            if (std::min({u, v, 1 - u, 1 - v}) < margin)
                continue;
            const Point expected = place(u, v);
            const Point got = pointOf(sheet, x, y);
            for (std::size_t c = 0; c < 3; ++c)
                far = std::isfinite(got[c]) ? std::max(far, std::abs(got[c] - expected[c])) : 1e30F;
        }
    return far;
}

} // namespace

class ResampleTest : public QObject {
    Q_OBJECT

private slots:
    void linearIsExact_data();
    void linearIsExact();
    void quadraticIsExactInside();
    void pointsStayWhereTheyAre();
    void coarserTakesFromTheSheet();
    void strainsAreLinear();
    void thinSheets();
    void misfitsAreEmpty();
    void theLastContentIsReplaced();
    void nothingOfPinsAndRest();
};

void ResampleTest::linearIsExact_data() {
    QTest::addColumn<int>("width");
    QTest::addColumn<int>("height");
    QTest::addColumn<int>("cells");
    for (const int width : {2, 3, 4, 5, 17})
        for (const int height : {2, 3, 4, 9})
            for (const int cells : {1, 2, 3, 7, 16, 50})
                QTest::addRow("%d by %d to %d", width, height, cells) << width << height << cells;
}

void ResampleTest::linearIsExact() {
    QFETCH(int, width);
    QFETCH(int, height);
    QFETCH(int, cells);
    SheetShape out;
    resample(sheetOf(width, height, linear), cells, out);
    QCOMPARE(out.width, cells + 1);
    QCOMPARE(out.height, cells + 1);
    QCOMPARE(out.positions.size(), static_cast<std::size_t>(3 * (cells + 1) * (cells + 1)));
    QVERIFY(worst(out, linear) < 5e-6F);
    QCOMPARE(pointOf(out, 0, 0), linear(0, 0));
    const Point end = pointOf(out, cells, cells);
    for (std::size_t c = 0; c < 3; ++c)
        QVERIFY(std::abs(end[c] - linear(1, 1)[c]) < 1e-6F);
}

// Catmull and Rom's curves hold parabolas; only the last cells, which end straight, do not.
void ResampleTest::quadraticIsExactInside() {
    SheetShape out;
    resample(sheetOf(11, 9, quadratic), 40, out);
    QVERIFY(worst(out, quadratic, 0.13F) < 5e-6F);
    QVERIFY(worst(out, quadratic) < 0.003F);
    QVERIFY(worst(out, quadratic) > 1e-5F);
}

void ResampleTest::pointsStayWhereTheyAre() {
    const auto rough = [](float u, float v) {
        return Point{u + 0.05F * std::sin(40 * v), std::sin(9 * u) * std::cos(30 * v), v};
    };
    const SheetShape sheet = sheetOf(9, 9, rough);
    SheetShape out;
    resample(sheet, 8, out);
    QVERIFY(worst(out, rough) < 1e-5F);
    resample(sheet, 24, out); // each third is one of them
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 9; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                QVERIFY(std::abs(pointOf(out, 3 * x, 3 * y)[c] - pointOf(sheet, x, y)[c]) < 1e-5F);
}

void ResampleTest::coarserTakesFromTheSheet() {
    const SheetShape sheet = sheetOf(17, 17, quadratic);
    SheetShape out;
    resample(sheet, 4, out);
    for (int y = 0; y <= 4; ++y)
        for (int x = 0; x <= 4; ++x)
            for (std::size_t c = 0; c < 3; ++c)
                QVERIFY(std::abs(pointOf(out, x, y)[c] - pointOf(sheet, 4 * x, 4 * y)[c]) < 1e-6F);
    resample(sheet, 1, out);
    QCOMPARE(pointOf(out, 1, 0), pointOf(sheet, 16, 0));
}

void ResampleTest::strainsAreLinear() {
    SheetShape sheet = sheetOf(5, 5, linear);
    sheet.strains.assign(25, 0);
    sheet.strains[12] = 1; // a peak in the middle, which a cubic would overshoot
    SheetShape out;
    resample(sheet, 16, out);
    QCOMPARE(out.strains.size(), std::size_t(17 * 17));
    for (int y = 0; y <= 16; ++y)
        for (int x = 0; x <= 16; ++x) {
            const float expected = std::max(0.0F, 1 - float(std::abs(x - 8)) / 4) *
                                   std::max(0.0F, 1 - float(std::abs(y - 8)) / 4);
            QVERIFY(std::abs(out.strains[static_cast<std::size_t>(y * 17 + x)] - expected) < 1e-6F);
        }
    sheet.strains.pop_back(); // of another size: none
    resample(sheet, 16, out);
    QVERIFY(out.strains.empty());
}

void ResampleTest::thinSheets() {
    for (const auto& [width, height] : {std::pair(1, 5), std::pair(5, 1), std::pair(1, 1), std::pair(1, 2)}) {
        const SheetShape sheet = sheetOf(width, height, linear);
        SheetShape out;
        resample(sheet, 6, out);
        QCOMPARE(out.positions.size(), std::size_t(3 * 49));
        const auto across = [&](float u, float v) { return linear(width > 1 ? u : 0, height > 1 ? v : 0); };
        QVERIFY(worst(out, across) < 1e-5F);
    }
}

void ResampleTest::misfitsAreEmpty() {
    SheetShape out;
    const auto isEmpty = [&](const SheetShape& sheet) {
        resample(sheetOf(3, 3, linear), 4, out); // something to be replaced
        resample(sheet, 4, out);
        return out.width == 0 && out.height == 0 && out.positions.empty() && out.strains.empty();
    };
    QVERIFY(isEmpty(SheetShape()));
    SheetShape sheet = sheetOf(3, 3, linear);
    sheet.positions.pop_back();
    QVERIFY(isEmpty(sheet));
    sheet = sheetOf(3, 3, linear);
    sheet.width = sheet.height = -3;
    QVERIFY(isEmpty(sheet));
    sheet = sheetOf(3, 3, linear);
    sheet.height = 4;
    QVERIFY(isEmpty(sheet));
}

void ResampleTest::theLastContentIsReplaced() {
    SheetShape out;
    resample(sheetOf(9, 9, quadratic), 30, out);
    resample(sheetOf(4, 6, linear), 5, out);
    SheetShape fresh;
    resample(sheetOf(4, 6, linear), 5, fresh);
    QCOMPARE(out.positions, fresh.positions);
    QCOMPARE(out.strains, fresh.strains);
    QCOMPARE(out.width, fresh.width);
}

void ResampleTest::nothingOfPinsAndRest() {
    SheetShape sheet = sheetOf(4, 4, linear);
    sheet.pinned = {0, 15};
    sheet.restPositions = std::make_shared<std::vector<float>>(sheet.positions);
    SheetShape out;
    resample(sheet, 5, out);
    QVERIFY(out.pinned.empty());
    QVERIFY(!out.restPositions);
}

QTEST_APPLESS_MAIN(ResampleTest)
#include "tst_resample.moc"
