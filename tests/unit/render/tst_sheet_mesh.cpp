#include "app/render/axes_gizmo.h"
#include "app/render/shader_log.h"
#include "app/render/shapes.h"
#include "app/render/sheet_mesh.h"
#include "app/render/springs.h"
#include "app/render/vector_math.h"
#include "app/render/view_metrics.h"

#include <QTest>

#include <algorithm>
#include <limits>
#include <numbers>
#include <set>

using namespace clothlab::render;

namespace {

template <typename Place>
SheetShape makeSheet(int width, int height, Place place) {
    SheetShape sheet;
    sheet.width = width;
    sheet.height = height;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const Vec3 p = place(width > 1 ? static_cast<float>(x) / static_cast<float>(width - 1) : 0.0F,
                                 height > 1 ? static_cast<float>(y) / static_cast<float>(height - 1) : 0.0F);
            for (const float coordinate : p)
                sheet.positions.push_back(coordinate);
        }
    }
    return sheet;
}

Vec3 flat(float u, float v) {
    return {u, 0, v};
}

Vec3 direction(const std::array<float, 4>& a) {
    return {a[0], a[1], a[2]};
}

float length(const Vec3& a) {
    return std::sqrt(dot(a, a));
}

SurfaceMesh whole(const SheetMesh& mesh) {
    SurfaceMesh all{std::vector<SurfaceVertex>(mesh.size()), mesh.uvs(), mesh.indices()};
    mesh.writeVertices(all.vertices);
    return all;
}

bool areUnitAndPerpendicular(const SurfaceMesh& mesh) {
    return std::all_of(mesh.vertices.begin(), mesh.vertices.end(), [](const SurfaceVertex& vertex) {
        const Vec3 n = direction(vertex.normal);
        const Vec3 t = direction(vertex.tangent);
        return std::abs(length(n) - 1) < 1e-4F && std::abs(length(t) - 1) < 1e-4F &&
               std::abs(dot(n, t)) < 1e-4F && vertex.normal[3] == 0 && vertex.tangent[3] == 0;
    });
}

// Smallest cosine between a triangle's own normal and those of its vertices.
float worstWinding(const SurfaceMesh& mesh) {
    float worst = 1;
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
        const SurfaceVertex& a = mesh.vertices[mesh.indices[i]];
        const SurfaceVertex& b = mesh.vertices[mesh.indices[i + 1]];
        const SurfaceVertex& c = mesh.vertices[mesh.indices[i + 2]];
        const Vec3 n = normalizedOr(cross(b.position - a.position, c.position - a.position), {0, 0, 0});
        for (const SurfaceVertex* vertex : {&a, &b, &c})
            worst = std::min(worst, dot(n, direction(vertex->normal)));
    }
    return worst;
}

} // namespace

class SheetMeshTest : public QObject {
    Q_OBJECT

private slots:
    void flatSheetPointsUp();
    void normalsAreWeightedByAngle();
    void normalsOfASphericalSheet();
    void tangentsFollowTheRows();
    void textureCoordinatesSpanTheSheet();
    void degenerateSheetsHaveUnitDirections();
    void notANumberStaysWhereItIs();
    void onlyWhatChangedIsReported();
    void misfitIsEmpty();
    void memoryIsReused();
    void springsAreThoseOfTheStencils();
    void sphereIsClosedAndFacesOutward();
    void planeFollowsItsNormal();
    void shaderLogsOfAllDrivers();
    void pixelSizeOfBothProjections();
    void gizmoShowsTheView();
};

void SheetMeshTest::flatSheetPointsUp() {
    SheetMesh mesh;
    QCOMPARE(mesh.update(makeSheet(4, 3, flat)), SheetMesh::Change::Size);
    QCOMPARE(mesh.size(), std::size_t(12));
    QCOMPARE(mesh.indices().size(), std::size_t(3 * 2 * 3 * 2));
    const SurfaceMesh all = whole(mesh);
    for (const SurfaceVertex& vertex : all.vertices)
        QVERIFY(length(direction(vertex.normal) - Vec3{0, 1, 0}) < 1e-6F);
    QCOMPARE(worstWinding(whole(mesh)), 1.0F);
}

// A cell folded along its diagonal: each end of the diagonal has angles of a right triangle on both sides, so
// its normal is the plain mean of both; the other two corners have the normal of their own triangle.
void SheetMeshTest::normalsAreWeightedByAngle() {
    SheetShape sheet = makeSheet(2, 2, flat);
    sheet.positions[1] = 1; // the first corner, lifted
    SheetMesh mesh;
    mesh.update(sheet);
    const std::vector<SurfaceVertex> v = whole(mesh).vertices;
    const Vec3 lifted = normalizedOr(cross(v[2].position - v[0].position, v[1].position - v[0].position), {});
    const Vec3 flatNormal{0, 1, 0};
    // Corners of the lifted triangle: sides sqrt 2 all three, so 60 degrees; of the flat one 45 at the
    // diagonal.
    const Vec3 expected = normalizedOr(60.0F * lifted + 45.0F * flatNormal, {});
    for (const std::size_t corner : {1U, 2U})
        QVERIFY(length(direction(v[corner].normal) - expected) < 2e-4F);
    QVERIFY(length(direction(v[0].normal) - lifted) < 1e-5F);
    QVERIFY(length(direction(v[3].normal) - flatNormal) < 1e-5F);
}

void SheetMeshTest::normalsOfASphericalSheet() {
    const auto onSphere = [](float u, float v) { return normalizedOr({u - 0.5F, 1, v - 0.5F}, {}); };
    SheetMesh mesh;
    mesh.update(makeSheet(65, 65, onSphere));
    QVERIFY(areUnitAndPerpendicular(whole(mesh)));
    const SurfaceMesh all = whole(mesh);
    for (int y = 1; y < 64; ++y) {
        for (int x = 1; x < 64; ++x) {
            const SurfaceVertex& vertex = all.vertices[static_cast<std::size_t>(y * 65 + x)];
            QVERIFY(length(direction(vertex.normal) - vertex.position) < 2e-3F);
        }
    }
}

void SheetMeshTest::tangentsFollowTheRows() {
    SheetMesh mesh;
    mesh.update(makeSheet(5, 4, [](float u, float v) { return Vec3{0, 2 * u, 3 * v}; }));
    QVERIFY(areUnitAndPerpendicular(whole(mesh)));
    const SurfaceMesh all = whole(mesh);
    for (const SurfaceVertex& vertex : all.vertices)
        QVERIFY(length(direction(vertex.tangent) - Vec3{0, 1, 0}) < 1e-6F);
}

void SheetMeshTest::textureCoordinatesSpanTheSheet() {
    SheetMesh mesh;
    mesh.update(makeSheet(5, 3, flat));
    for (int y = 0; y < 3; ++y)
        for (int x = 0; x < 5; ++x)
            QCOMPARE(mesh.uvs()[static_cast<std::size_t>(y * 5 + x)],
                     (std::array<float, 2>{static_cast<float>(x) / 4, static_cast<float>(y) / 2}));
}

void SheetMeshTest::degenerateSheetsHaveUnitDirections() {
    const std::array sheets{makeSheet(3, 3,
                                      [](float, float) {
                                          return Vec3{1, 2, 3};
                                      }),
                            makeSheet(3, 3,
                                      [](float u, float v) {
                                          return Vec3{u + v, 0, 0};
                                      }),
                            makeSheet(1, 1, flat),
                            makeSheet(1, 5, flat),
                            makeSheet(5, 1, flat),
                            makeSheet(2, 2, [](float u, float v) {
                                return Vec3{1e-12F * u, 0, 1e-12F * v};
                            })};
    for (const SheetShape& sheet : sheets) {
        SheetMesh mesh;
        mesh.update(sheet);
        QVERIFY(areUnitAndPerpendicular(whole(mesh)));
        QCOMPARE(mesh.size(), sheet.positions.size() / 3);
        QVERIFY(sheet.width > 1 && sheet.height > 1 ? true : mesh.indices().empty());
    }
}

// A simulation that blew up at one point must not take the normals of all others with it.
void SheetMeshTest::notANumberStaysWhereItIs() {
    for (const float bad :
         {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 3e30F}) {
        SheetShape sheet = makeSheet(8, 8, flat);
        sheet.positions[1] = bad;
        SheetMesh mesh;
        mesh.update(sheet);
        QVERIFY(areUnitAndPerpendicular(whole(mesh)));
    }
}

void SheetMeshTest::onlyWhatChangedIsReported() {
    SheetMesh mesh;
    SheetShape sheet = makeSheet(4, 4, flat);
    QCOMPARE(mesh.update(sheet), SheetMesh::Change::Size);
    QCOMPARE(mesh.update(sheet), SheetMesh::Change::Nothing);
    sheet.positions[7] += 0.5F;
    QCOMPARE(mesh.update(sheet), SheetMesh::Change::Positions);
    QCOMPARE(whole(mesh).vertices[2].position[1], 0.5F);
    // As many points, in another grid.
    sheet.width = 2;
    sheet.height = 8;
    QCOMPARE(mesh.update(sheet), SheetMesh::Change::Size);
    QCOMPARE(mesh.indices().size(), std::size_t(7 * 6));
    QCOMPARE(mesh.update(SheetShape()), SheetMesh::Change::Size);
    QCOMPARE(mesh.update(SheetShape()), SheetMesh::Change::Nothing);
}

void SheetMeshTest::misfitIsEmpty() {
    SheetMesh mesh;
    SheetShape sheet = makeSheet(3, 3, flat);
    sheet.positions.pop_back();
    mesh.update(sheet);
    QVERIFY(mesh.isEmpty());
    sheet = makeSheet(3, 3, flat);
    sheet.width = -3;
    sheet.height = -3;
    mesh.update(sheet);
    QVERIFY(mesh.isEmpty());
}

void SheetMeshTest::memoryIsReused() {
    SheetMesh mesh;
    SheetShape sheet = makeSheet(16, 16, flat);
    mesh.update(sheet);
    const float* positions = mesh.positions().x.data();
    const std::uint32_t* indices = mesh.indices().data();
    for (int i = 0; i < 3; ++i) {
        sheet.positions[1] += 1;
        mesh.update(sheet);
        QCOMPARE(mesh.positions().x.data(), positions);
        QCOMPARE(mesh.indices().data(), indices);
    }
}

void SheetMeshTest::springsAreThoseOfTheStencils() {
    const int w = 7;
    const int h = 5;
    const std::array<std::size_t, kSpringTypes> expected{(w - 1) * h + w * (h - 1), 2 * (w - 1) * (h - 1),
                                                         (w - 2) * h + w * (h - 2)};
    for (int type = 0; type < kSpringTypes; ++type) {
        const auto indices = springIndices(w, h, static_cast<SpringType>(type));
        std::set<std::pair<std::uint32_t, std::uint32_t>> pairs;
        for (std::size_t i = 0; i < indices.size(); i += 2) {
            const int dx = std::abs(static_cast<int>(indices[i] % w) - static_cast<int>(indices[i + 1] % w));
            const int dy = std::abs(static_cast<int>(indices[i] / w) - static_cast<int>(indices[i + 1] / w));
            const std::array<bool, kSpringTypes> fits{dx + dy == 1, dx == 1 && dy == 1,
                                                      dx + dy == 2 && dx * dy == 0};
            QVERIFY(fits[static_cast<std::size_t>(type)]);
            pairs.insert(std::minmax(indices[i], indices[i + 1]));
        }
        QCOMPARE(pairs.size(), expected[static_cast<std::size_t>(type)]);
        QCOMPARE(indices.size(), 2 * pairs.size());
        QVERIFY(springIndices(1, 1, static_cast<SpringType>(type)).empty());
        QVERIFY(springIndices(0, 0, static_cast<SpringType>(type)).empty());
    }
}

void SheetMeshTest::sphereIsClosedAndFacesOutward() {
    const SurfaceMesh sphere = makeUnitSphere(64, 32);
    QVERIFY(areUnitAndPerpendicular(sphere));
    QVERIFY(worstWinding(sphere) > 0.9F);
    double volume = 0; // of the tetrahedra from the centre
    for (std::size_t i = 0; i < sphere.indices.size(); i += 3)
        volume += static_cast<double>(dot(sphere.vertices[sphere.indices[i]].position,
                                          cross(sphere.vertices[sphere.indices[i + 1]].position,
                                                sphere.vertices[sphere.indices[i + 2]].position))) /
                  6;
    QVERIFY(std::abs(volume - 4 * std::numbers::pi / 3) < 0.02);
    QCOMPARE(sphere.uvs.front(), (std::array<float, 2>{0, 0}));
    QCOMPARE(sphere.vertices.front().position[1], 1.0F);
    QCOMPARE(sphere.uvs.back(), (std::array<float, 2>{1, 1}));
    QVERIFY(makeUnitSphere(0, -1).indices.size() >= 3 * 6);

    const QMatrix4x4 model = sphereModel({QVector3D(1, 2, 3), 0.5F});
    QVERIFY((model.map(QVector3D(0, 1, 0)) - QVector3D(1, 2 + 0.92F * 0.5F, 3)).length() < 1e-6F);
}

void SheetMeshTest::planeFollowsItsNormal() {
    const SurfaceMesh square = makePlaneSquare();
    QVERIFY(areUnitAndPerpendicular(square));
    QCOMPARE(worstWinding(square), 1.0F);
    for (const QVector3D normal :
         {QVector3D(0, 1, 0), QVector3D(0, -2, 0), QVector3D(3, 4, 0), QVector3D(0, 0, -0.1F)}) {
        const QMatrix4x4 model = planeModel({QVector3D(1, 2, 3), normal});
        QVERIFY((model.mapVector(QVector3D(0, 1, 0)) - normal.normalized()).length() < 1e-5F);
        QVERIFY((model.map(QVector3D()) - QVector3D(1, 2, 3)).length() < 1e-6F);
    }
    QCOMPARE(planeModel({QVector3D(1, 0, 0), QVector3D()}).map(QVector3D(0, 1, 0)), QVector3D(1, 1, 0));
}

void SheetMeshTest::shaderLogsOfAllDrivers() {
    const QString main = QStringLiteral("/my/My.frag");
    const QString part = QStringLiteral("/my/part.glsl");
    const auto read = [&](const char* log) { return readShaderLog({main, part}, QString::fromLatin1(log)); };
    QCOMPARE(read("0:12(5): error: syntax error\n"),
             Problems({{main, 12, QStringLiteral("error: syntax error")}}));
    QCOMPARE(read("1:2(5): error: in the part\n"),
             Problems({{part, 2, QStringLiteral("error: in the part")}}));
    // Mesa leaves out the number of the file now and then.
    QCOMPARE(read("0:1000003(5): error: in the part\n"),
             Problems({{part, 3, QStringLiteral("error: in the part")}}));
    QCOMPARE(read("0:9000003(5): error: of no file\n"),
             Problems({{main, 3, QStringLiteral("error: of no file")}}));
    QCOMPARE(read("7:2(5): error: of no file\n"), Problems({{main, 2, QStringLiteral("error: of no file")}}));
    QCOMPARE(read("0(7) : error C1008: undefined variable \"x\"\r\n\n"),
             Problems({{main, 7, QStringLiteral("error C1008: undefined variable \"x\"")}}));
    QCOMPARE(read("1(7) : error C1008: too"), Problems({{part, 7, QStringLiteral("error C1008: too")}}));
    QCOMPARE(read("ERROR: 0:3: 'y' : undeclared\nWARNING: 1:4: unused"),
             Problems({{main, 3, QStringLiteral("error: 'y' : undeclared")},
                       {part, 4, QStringLiteral("warning: unused")}}));
    QCOMPARE(read("out of memory"), Problems({{main, 0, QStringLiteral("out of memory")}}));
    QCOMPARE(read("99999999999:99999999999(1): x"), Problems({{main, 0, QStringLiteral("x")}}));
    QVERIFY(read("").isEmpty());
    QCOMPARE(words({main, 12, QStringLiteral("reason")}), QStringLiteral("My.frag:12: reason"));
    QCOMPARE(words({main, 0, QStringLiteral("reason")}), QStringLiteral("My.frag: reason"));
}

void SheetMeshTest::pixelSizeOfBothProjections() {
    QMatrix4x4 perspective;
    perspective.perspective(90, 2, 0.1F, 100);
    QVERIFY(std::abs(pixelSize(perspective, {200, 100}) - 0.02F) < 1e-6F); // 2 m over 100 pixels at 1 m
    QVERIFY(std::abs(depthSlope(perspective).y() - 1) < 1e-6F);
    QMatrix4x4 orthographic;
    orthographic.ortho(-2, 2, -1, 1, 0, 10);
    orthographic.rotate(40, 1, 2, 3);
    QVERIFY(std::abs(pixelSize(orthographic, {200, 100}) - 0.02F) < 1e-6F);
    QVERIFY(std::abs(depthSlope(orthographic).x() - 0.2F) < 1e-6F);
    QCOMPARE(depthSlope(orthographic).y(), 0.0F);
    QCOMPARE(pixelSize(orthographic, {0, 0}), 0.0F);
}

void SheetMeshTest::gizmoShowsTheView() {
    QMatrix4x4 view;
    view.perspective(35, 1.5F, 0.01F, 100);
    view.lookAt(QVector3D(0, 0, 5), QVector3D(), QVector3D(0, 1, 0));
    std::array<GizmoAxis, 3> axes;
    makeAxesGizmo(view, 2, axes);
    QVERIFY(axes[0].depth >= axes[1].depth && axes[1].depth >= axes[2].depth);
    // z points at the viewer: the nearest, with no length on the screen. x goes right, y up, equally far.
    QVERIFY(axes[2].lines[1].length() < 1e-4F && axes[2].color.z() > 0.9F);
    for (const GizmoAxis& axis : axes) {
        for (const QVector3D& point : axis.lines)
            QVERIFY(point.length() <= 2 * kGizmoRadius);
        if (axis.color.x() > 0.8F)
            QVERIFY(axis.lines[1].x() > 20 && std::abs(axis.lines[1].y()) < 1e-4F);
    }
    makeAxesGizmo(QMatrix4x4() * 0.0F, 1, axes); // nothing to see, and nothing to divide by
    QCOMPARE(axes[0].lines[1], QVector3D());
}

QTEST_APPLESS_MAIN(SheetMeshTest)
#include "tst_sheet_mesh.moc"
