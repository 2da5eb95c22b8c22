// SPDX-License-Identifier: GPL-3.0-or-later
// Figures: panels side by side, with contents in the right place and colour, lit equally at every distance.
#include "ui/theatre/renderer/picture.h"

#include <gtest/gtest.h>

#include <QColor>

namespace fulcrum::ui {
namespace {

TriangleMesh cube(double side) {
    TriangleMesh mesh;
    for (int corner = 0; corner < 8; ++corner)
        mesh.vertices.emplace_back(side * ((corner & 1) - 0.5), side * ((corner >> 1 & 1) - 0.5),
                                   side * ((corner >> 2 & 1) - 0.5));
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

PicturePanel panel(double side, double distance) {
    PicturePanel p;
    DrawnMesh mesh;
    mesh.mesh = cube(side);
    mesh.smooth = false;
    p.meshes = {mesh};
    p.eye = Vector3(0, -distance, 0);
    p.field_of_view = 0.5;
    return p;
}

QColor middle(const QImage& image, int column) {
    return image.pixelColor(12 + column * 212 + 100, 12 + 100);
}

TEST(Picture, PanelsShowTheirMeshesEquallyLitAtAnyDistance) {
    PicturePanel near = panel(0.02, 0.1), far = panel(0.2, 1.0), lines = panel(0.2, 1.0);
    near.title = QStringLiteral("near");
    lines.meshes[0].wireframe = true;
    lines.meshes[0].colour = {0, 0, 0};
    PictureOptions options;
    options.panel = QSize(200, 200);
    options.caption = QStringLiteral("Three cubes.");
    const QImage image = draw_picture({near, far, lines}, options);
    ASSERT_EQ(image.width(), 3 * 212 + 12);
    ASSERT_GT(image.height(), 200 + 12 + 30);
    for (int column = 0; column < 2; ++column) {
        const QColor c = middle(image, column);
        EXPECT_GT(c.red(), c.green() + 30) << column;
        EXPECT_GT(c.red(), 90) << column;
        EXPECT_EQ(image.pixelColor(12 + column * 212 + 3, 15), QColor(237, 240, 242)) << column;
    }
    EXPECT_NEAR(middle(image, 0).red(), middle(image, 1).red(), 25);
    // Lines let the background through between them and are dark where they are.
    int dark = 0, light = 0;
    for (int x = 0; x < 200; ++x) {
        const QColor c = image.pixelColor(12 + 2 * 212 + x, 12 + 90);
        (c.red() < 200 ? dark : light) += 1;
    }
    EXPECT_GT(dark, 1);
    EXPECT_LT(dark, 30);
    EXPECT_GT(light, 150);
}

TEST(Picture, AccentColoursOnlyTheAccentedVertices) {
    PicturePanel p = panel(0.02, 0.1);
    p.meshes[0].accent.assign(8, 1.0F);
    PictureOptions options;
    options.panel = QSize(200, 200);
    const QColor c = middle(draw_picture({p}, options), 0);
    EXPECT_GT(c.blue(), c.red() + 30);
}

TEST(Picture, CameraLooksAtItsTarget) {
    const CameraPose camera = camera_towards({0.1, -0.2, 0.3}, {0.05, 0.1, 0.0}, {0, 0, 1}, 0.6);
    const QVector3D at = SceneRenderer::project(camera, {0.05, 0.1, 0.0}, QSize(300, 300));
    EXPECT_NEAR(at.x(), 150, 0.01);
    EXPECT_NEAR(at.y(), 150, 0.01);
    EXPECT_LT(SceneRenderer::project(camera, {0.05, 0.1, 0.05}, QSize(300, 300)).y(), 140);
    // Straight down: any rotation is acceptable.
    EXPECT_TRUE(camera_towards({0, 0, 1}, {0, 0, 0}, {0, 0, 1}, 0.6).orientation.coeffs().allFinite());
}

}  // namespace
}  // namespace fulcrum::ui
