// SPDX-License-Identifier: GPL-3.0-or-later
// A sheet with thickness: closed, with the right volume and a cut face along each rim; and its appearance.
#include "ui/theatre/renderer/sheet_mesh.h"

#include <gtest/gtest.h>

#include <QColor>
#include <cmath>
#include <map>

#include "ui/theatre/renderer/offscreen.h"
#include "ui/theatre/renderer/scene_renderer.h"

namespace fulcrum::ui {
namespace {

struct Grid {
    std::vector<Vector3> rest, positions;
    std::vector<Triangle> triangles;
    SheetSurface surface() const {
        return {positions.data(), rest.data(), positions.size(), triangles.data(), triangles.size(), 0.0012};
    }
};

// 120 x 60 mm of 2 mm cells; triangles whose cell `gone` names are left out.
template <typename Gone>
Grid grid(Gone&& gone) {
    Grid g;
    constexpr int columns = 60, rows = 30;
    for (int j = 0; j <= rows; ++j) {
        for (int i = 0; i <= columns; ++i) g.rest.emplace_back(0.002 * i, 0.002 * j, 0);
    }
    g.positions = g.rest;
    for (int j = 0; j < rows; ++j) {
        for (int i = 0; i < columns; ++i) {
            if (gone(i, j)) continue;
            const int a = j * (columns + 1) + i, b = a + 1, c = a + columns + 1, d = c + 1;
            g.triangles.push_back({a, b, d});
            g.triangles.push_back({a, d, c});
        }
    }
    return g;
}

Vector3 vertex(const SheetMesh& mesh, std::uint32_t index) {
    const float* p = mesh.vertices().data() + SheetMesh::floats * index;
    return Vector3(p[0], p[1], p[2]);
}

TEST(SheetMesh, IsClosedAndHoldsAreaTimesThickness) {
    const Grid g = grid([](int i, int j) { return j == 15 && i > 10 && i < 50; });
    SheetMesh mesh;
    mesh.build(g.surface());
    EXPECT_EQ(mesh.rim_edges(), 2U * (60 + 30) + 2U * (39 + 1));
    // Each edge, identified by the positions of its ends, occurs equally often in both directions.
    std::map<std::array<std::array<long, 3>, 2>, int> passed;
    const auto place = [&mesh](std::uint32_t index) {
        const Vector3 p = vertex(mesh, index);
        return std::array<long, 3>{std::lround(p.x() * 1e7), std::lround(p.y() * 1e7),
                                   std::lround(p.z() * 1e7)};
    };
    double volume = 0;
    for (std::size_t k = 0; k < mesh.indices().size(); k += 3) {
        const std::uint32_t* t = mesh.indices().data() + k;
        volume += vertex(mesh, t[0]).dot(vertex(mesh, t[1]).cross(vertex(mesh, t[2]))) / 6;
        for (std::size_t c = 0; c < 3; ++c) {
            const auto from = place(t[c]), to = place(t[(c + 1) % 3]);
            passed[{std::min(from, to), std::max(from, to)}] += from < to ? 1 : -1;
        }
    }
    for (const auto& [edge, balance] : passed) ASSERT_EQ(balance, 0);
    EXPECT_NEAR(volume, (60 * 30 - 39) * 4e-6 * 0.0012, 1e-12);
}

TEST(SheetMesh, SkipsInvalidTrianglesAndAcceptsAnEmptySheet) {
    Grid g = grid([](int, int) { return false; });
    SheetMesh mesh;
    mesh.build(g.surface());
    const std::size_t whole = mesh.indices().size();
    g.triangles.push_back({0, 1, 100000});
    g.triangles.push_back({0, -1, 5});
    mesh.build(g.surface());
    EXPECT_EQ(mesh.indices().size(), whole);
    mesh.build({});
    EXPECT_TRUE(mesh.indices().empty());
    EXPECT_TRUE(mesh.vertices().empty());
}

TEST(SheetMesh, CutGapesIsPalerInsideAndInkLineIsDark) {
    Grid g = grid([](int i, int j) { return j == 15 && i > 8 && i < 32; });
    for (Vector3& p : g.positions) {
        // Fixed at the back, pulled towards the camera at the front, the lips of the cut apart.
        const double side = p.y() < 0.031 ? -1 : 1,
                     apart = std::max(0.0, 1 - std::pow((p.x() - 0.041) / 0.022, 2));
        p.y() += side * 0.004 * apart * std::exp(-std::pow((p.y() - 0.031) / 0.012, 2));
        p.z() = -0.03 + 0.006 * std::sin(40 * p.x()) * (p.y() / 0.06);
        p.x() -= 0.06;
        p.y() -= 0.03;
    }
    SceneRenderer renderer({512, 1.0, false});
    renderer.set_sheet_texture(std::make_shared<TissueTexture>(make_areolar_texture(3, 256)));
    SceneFrame frame;
    frame.camera.position = Vector3(0, -0.055, 0.045);
    const Vector3 z = (frame.camera.position - Vector3(0, 0, -0.03)).normalized(), x = Vector3::UnitX();
    Matrix3 axes;
    axes << x, z.cross(x), z;
    frame.camera.orientation = Quaternion(axes);
    DrawnSheet sheet;
    sheet.surface = g.surface();
    sheet.mark_from = Vector3(0.010, 0.031, 0);
    sheet.mark_to = Vector3(0.110, 0.031, 0);
    frame.sheets.push_back(sheet);
    const QSize size(640, 480);
    const QImage image = render_offscreen(renderer, frame, size);
    const QString folder = qEnvironmentVariable("FULCRUM_PICTURES");
    if (!folder.isEmpty()) image.save(folder + QStringLiteral("/sheet.png"));
    const auto at = [&](double rest_x, double rest_y, double z_off) {
        const int i = static_cast<int>(std::lround(rest_x / 0.002)),
                  j = static_cast<int>(std::lround(rest_y / 0.002));
        const QVector3D p = SceneRenderer::project(
            frame.camera, g.positions[static_cast<std::size_t>(j * 61 + i)] + Vector3(0, 0, z_off), size);
        return image.pixelColor(static_cast<int>(p.x()), static_cast<int>(p.y()));
    };
    // The far lip's cut face is seen from the front; ink is bluer than tissue.
    int ink = 0, tissue = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x_at = 0; x_at < image.width(); ++x_at) {
            const QColor c = image.pixelColor(x_at, y);
            if (c.blue() > c.red() + 10 && c.blue() > 40) ++ink;
            if (c.red() > c.blue() + 20 && c.red() > 120) ++tissue;
        }
    }
    EXPECT_GT(ink, 100);
    EXPECT_GT(tissue, 20000);
    const QColor face = at(0.042, 0.032, 0), film = at(0.042, 0.044, 0.0006);
    EXPECT_GT(face.red(), face.blue() + 15);
    EXPECT_NE(face, film);
}

}  // namespace
}  // namespace fulcrum::ui
