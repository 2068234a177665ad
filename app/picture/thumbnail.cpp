#include "app/picture/thumbnail.h"

#include <QVector4D>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

namespace clothlab {
namespace {

constexpr int kMostCells = 56; // of the drawn sheet along a side
constexpr std::size_t kMostSpheres = 24;
constexpr int kSamples = 2; // along a side of a pixel

struct Corner {
    QVector3D place; // metres
    float x = 0;     // samples
    float y = 0;
    float depth = 0;
    bool visible = false;
};

// A picture with depths, several samples to a pixel.
class Canvas {
public:
    Canvas(const Camera& camera, QSize pixels, const QColor& background)
        : m_image(pixels * kSamples, QImage::Format_RGB32), m_matrix(camera.viewProjection(pixels)),
          m_toCamera(camera.orthographic ? (camera.eye() - camera.target()).normalized() : QVector3D()),
          m_eye(camera.eye()), m_depth(std::size_t(m_image.width()) * std::size_t(m_image.height()),
                                       std::numeric_limits<float>::max()) {
        m_image.fill(background);
    }

    Corner corner(const QVector3D& place) const {
        const QVector4D clip = m_matrix * QVector4D(place, 1);
        if (!(clip.w() > 1e-6F))
            return {};
        const float x = (clip.x() / clip.w() + 1) / 2 * float(m_image.width());
        const float y = (1 - clip.y() / clip.w()) / 2 * float(m_image.height());
        const bool visible = std::abs(x) < 1e6F && std::abs(y) < 1e6F; // and is a number
        return {place, x, y, clip.z() / clip.w(), visible};
    }

    void triangle(const Corner& a, const Corner& b, const Corner& c, const QColor& front,
                  const QColor& back) {
        if (!a.visible || !b.visible || !c.visible)
            return;
        const float area = (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
        if (!(std::abs(area) > 1e-4F))
            return;
        fill(a, b, c, area, shade(a, b, c, front, back));
    }

    QImage picture() const {
        return m_image.scaled(m_image.size() / kSamples, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    }

private:
    QRgb shade(const Corner& a, const Corner& b, const Corner& c, const QColor& front,
               const QColor& back) const {
        const QVector3D normal = QVector3D::normal(a.place, b.place, c.place);
        const QVector3D toCamera = m_toCamera.isNull() ? (m_eye - a.place).normalized() : m_toCamera;
        const float facing = QVector3D::dotProduct(normal, toCamera);
        const QColor& color = facing >= 0 ? front : back;
        const float light = 0.4F + 0.6F * std::abs(facing);
        const auto part = [light](int value) { return std::clamp(int(float(value) * light), 0, 255); };
        return qRgb(part(color.red()), part(color.green()), part(color.blue()));
    }

    void fill(const Corner& a, const Corner& b, const Corner& c, float area, QRgb color) {
        const auto from = [](float least) { return std::max(0, int(std::ceil(least - 0.5F))); };
        const auto [left, right] = std::minmax({a.x, b.x, c.x});
        const auto [top, bottom] = std::minmax({a.y, b.y, c.y});
        const int xEnd = std::min(m_image.width(), int(std::ceil(right + 0.5F)));
        const int yEnd = std::min(m_image.height(), int(std::ceil(bottom + 0.5F)));
        for (int y = from(top); y < yEnd; ++y) {
            auto* line = reinterpret_cast<QRgb*>(m_image.scanLine(y));
            float* depths = m_depth.data() + std::size_t(y) * std::size_t(m_image.width());
            const float py = float(y) + 0.5F;
            for (int x = from(left); x < xEnd; ++x) {
                const float px = float(x) + 0.5F;
                const float u = ((px - a.x) * (c.y - a.y) - (py - a.y) * (c.x - a.x)) / area;
                const float v = ((b.x - a.x) * (py - a.y) - (b.y - a.y) * (px - a.x)) / area;
                if (u < 0 || v < 0 || u + v > 1)
                    continue;
                const float depth = a.depth + u * (b.depth - a.depth) + v * (c.depth - a.depth);
                if (depth < depths[x] && depth >= -1) {
                    depths[x] = depth;
                    line[x] = color;
                }
            }
        }
    }

    QImage m_image;
    QMatrix4x4 m_matrix;
    QVector3D m_toCamera; // null: towards the eye
    QVector3D m_eye;
    std::vector<float> m_depth;
};

// So many of the numbers 0 … count - 1, both ends among them.
std::vector<int> some(int count, int most) {
    std::vector<int> chosen;
    const int cells = std::min(count - 1, most);
    for (int i = 0; i <= cells; ++i)
        chosen.push_back(cells == 0 ? 0 : int(std::int64_t(i) * (count - 1) / cells));
    return chosen;
}

// Cells between corners that stand in rows.
void drawCells(Canvas& canvas, const std::vector<Corner>& corners, std::size_t width, const QColor& front,
               const QColor& back) {
    for (std::size_t row = width; row < corners.size(); row += width)
        for (std::size_t i = row + 1; i < row + width; ++i) {
            const Corner& a = corners[i - width - 1];
            const Corner& b = corners[i - width];
            canvas.triangle(a, corners[i - 1], b, front, back);
            canvas.triangle(b, corners[i - 1], corners[i], front, back);
        }
}

void drawSheet(Canvas& canvas, const Grid& grid, const PointArray& position, const ThumbnailLook& look) {
    const std::vector<int> columns = some(grid.width, kMostCells);
    const std::vector<int> rows = some(grid.height, kMostCells);
    std::vector<Corner> corners;
    corners.reserve(columns.size() * rows.size());
    for (const int y : rows)
        for (const int x : columns) {
            const Vec3 p = position.at(grid.index(x, y));
            corners.push_back(canvas.corner({float(p.x()), float(p.y()), float(p.z())}));
        }
    drawCells(canvas, corners, columns.size(), look.front, look.back);
}

void drawSphere(Canvas& canvas, const Sphere& sphere, const QColor& color) {
    constexpr int around = 20;
    constexpr int upwards = 10;
    constexpr auto pi = std::numbers::pi_v<float>;
    const QVector3D origin(float(sphere.origin.x()), float(sphere.origin.y()), float(sphere.origin.z()));
    std::vector<Corner> corners;
    for (int i = 0; i <= upwards; ++i)
        for (int j = 0; j <= around; ++j) {
            const float polar = pi * float(i) / upwards;
            const float azimuth = 2 * pi * float(j) / around;
            const QVector3D direction(std::sin(polar) * std::cos(azimuth), std::cos(polar),
                                      std::sin(polar) * std::sin(azimuth));
            corners.push_back(canvas.corner(origin + float(sphere.radius) * direction));
        }
    drawCells(canvas, corners, around + 1, color, color);
}

} // namespace

QImage thumbnail(const Scene& scene, const Grid& grid, const PointArray& position, const Camera& camera,
                 QSize size, const ThumbnailLook& look) {
    Canvas canvas(camera, size, look.background);
    drawSheet(canvas, grid, position, look);
    for (std::size_t i = 0; i < std::min(scene.spheres.size(), kMostSpheres); ++i)
        drawSphere(canvas, scene.spheres[i], look.sphere);
    return canvas.picture();
}

} // namespace clothlab
