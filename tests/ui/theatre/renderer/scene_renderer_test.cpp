// SPDX-License-Identifier: GPL-3.0-or-later
// Tests the measurable statements of docs/QUALITY.md, Look. Needs a display with
// OpenGL.
#include "ui/theatre/renderer/scene_renderer.h"

#include <gtest/gtest.h>

#include <QColor>
#include <algorithm>
#include <cmath>

#include "ui/theatre/renderer/offscreen.h"

namespace fulcrum::ui {
namespace {

constexpr int width = 640, height = 360;
const QSize frame_size(width, height);

CameraPose look(const Vector3& from, const Vector3& at) {
    const Vector3 z = (from - at).normalized(), x = Vector3(0, -0.3, 1).cross(z).normalized();
    Matrix3 axes;
    axes.col(0) = x;
    axes.col(1) = z.cross(x);
    axes.col(2) = z;
    CameraPose camera;
    camera.position = from;
    camera.orientation = Quaternion(axes);
    camera.field_of_view = 1.22;
    return camera;
}

DrawnTool tool_at(const Vector3& tip, double jaw_angle) {
    DrawnTool tool;
    tool.pose.trocar = Vector3(0.09, 0.10, 0.09);
    tool.pose.tip = tip;
    tool.pose.axis = (tip - tool.pose.trocar).normalized();
    tool.pose.orientation = Quaternion::FromTwoVectors(Vector3::UnitZ(), tool.pose.axis);
    tool.pose.jaw_angle = jaw_angle;
    tool.pose.inside = true;
    return tool;
}

double luminance(const QColor& c) {
    return 0.2126 * c.redF() + 0.7152 * c.greenF() + 0.0722 * c.blueF();
}

// Mean luminance of the pixels whose distance from the centre is between two shares of the image's radius.
double ring_luminance(const QImage& image, double low, double high) {
    double sum = 0;
    int count = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            const double r = std::hypot(x + 0.5 - 0.5 * image.width(), y + 0.5 - 0.5 * image.height()) /
                             (0.5 * image.height());
            if (r < low || r >= high) continue;
            sum += luminance(image.pixelColor(x, y));
            ++count;
        }
    }
    return sum / count;
}

int different_pixels(const QImage& a, const QImage& b) {
    int count = 0;
    for (int y = 0; y < a.height(); ++y) {
        for (int x = 0; x < a.width(); ++x) {
            const QColor p = a.pixelColor(x, y), q = b.pixelColor(x, y);
            count += std::abs(p.red() - q.red()) + std::abs(p.green() - q.green()) +
                                 std::abs(p.blue() - q.blue()) >
                             24
                         ? 1
                         : 0;
        }
    }
    return count;
}

class Renderer : public testing::Test {
  protected:
    static RendererOptions options() {
        RendererOptions o;
        o.texture_size = 256;
        o.resolution = 1;
        return o;
    }
    Renderer() : renderer_(options()) {}
    ~Renderer() override {
        stage_.make_current();
        renderer_.release();
    }
    QImage picture(const SceneFrame& frame) { return stage_.picture(renderer_, frame, frame_size); }

    OffscreenStage stage_;
    SceneRenderer renderer_;
};

TEST_F(Renderer, RoundImageInABlackFrameBrightInTheMiddle) {
    renderer_.set_cavity(make_cavity({}));
    SceneFrame frame;
    frame.camera = look({0, 0.10, 0.05}, {0, 0.08, -0.07});
    const QImage image = picture(frame);
    ASSERT_EQ(image.size(), frame_size);
    EXPECT_EQ(ring_luminance(image, 1.0, 2.0), 0.0);
    EXPECT_GT(ring_luminance(image, 0.0, 0.3), 0.15);
    EXPECT_GT(ring_luminance(image, 0.0, 0.3), 1.4 * ring_luminance(image, 0.85, 0.97));
}

TEST_F(Renderer, LightComesFromTheScopeAndFallsOffWithDistance) {
    renderer_.set_cavity(make_cavity({}));
    SceneFrame frame;
    double before = 2;
    for (const double distance : {0.05, 0.08, 0.12}) {
        frame.camera = look({0.03, 0.11, -0.075 + distance}, {0.03, 0.11, -0.075});
        const double lit = ring_luminance(picture(frame), 0.0, 0.4);
        EXPECT_LT(lit, 0.93 * before);
        before = lit;
    }
    frame.brightness = 0;
    EXPECT_LT(ring_luminance(picture(frame), 0.0, 0.9), 0.08);  // no ambient light to speak of
}

TEST_F(Renderer, ProjectionAgreesWithThePicture) {
    SceneFrame frame;
    frame.camera = look({0, 0.10, 0.07}, {0, 0.02, -0.02});
    const QImage empty = picture(frame);
    DrawnTarget target;
    target.centre = Vector3(0.02, 0.03, -0.01);
    target.look = TargetLook::current;
    frame.targets = {target};
    const QImage image = picture(frame);
    double x = 0, y = 0, count = 0;
    for (int j = 0; j < height; ++j) {
        for (int i = 0; i < width; ++i) {
            if (image.pixel(i, j) == empty.pixel(i, j)) continue;
            x += i + 0.5;
            y += j + 0.5;
            ++count;
        }
    }
    ASSERT_GT(count, 100);
    const QVector3D expected = SceneRenderer::project(frame.camera, target.centre, frame_size);
    EXPECT_NEAR(x / count, static_cast<double>(expected.x()), 1.5);
    EXPECT_NEAR(y / count, static_cast<double>(expected.y()), 1.5);
    EXPECT_NEAR(static_cast<double>(expected.z()),
                (target.centre - frame.camera.position).dot(frame.camera.orientation * -Vector3::UnitZ()),
                1e-6);
}

TEST_F(Renderer, JawsOpenAndATipNearTissueCastsAShadow) {
    const CavityShape cavity = make_cavity({});
    renderer_.set_cavity(cavity);
    // A tip 3 mm over the posterior wall, one 35 mm over it.
    Vector3 wall(0, 0, 1);
    double least = 1;
    for (const Vector3& v : cavity.mesh.vertices) {
        const double aside = std::hypot(v.x() - 0.04, v.y() - 0.10);
        if (v.z() > 0 || aside > least) continue;
        least = aside;
        wall = v;
    }
    const Vector3 near_tip = wall + Vector3(0, 0, 0.003), far_tip = wall + Vector3(0, 0, 0.035);
    SceneFrame frame;
    frame.camera = look({0, 0.13, 0.05}, near_tip);
    const QImage bare = picture(frame);
    frame.tools = {tool_at(far_tip, 0.0)};
    const QImage closed = picture(frame);
    EXPECT_GT(different_pixels(bare, closed), 500);
    frame.tools[0].pose.jaw_angle = 1.0;
    EXPECT_GT(different_pixels(closed, picture(frame)), 50);
    // A ghost of the tool casts no shadow; next to the real tool the tissue is darker than without it.
    frame.tools = {tool_at(near_tip, 0.0)};
    const QImage near_tissue = picture(frame);
    frame.tools[0].ghost = true;
    const QImage ghost = picture(frame);
    const QVector3D tip = SceneRenderer::project(frame.camera, near_tip, frame_size);
    double with = 0, without = 0;
    for (int dy = -9; dy <= 9; ++dy) {
        for (int dx = -9; dx <= 9; ++dx) {
            const int px = static_cast<int>(tip.x()) + dx, py = static_cast<int>(tip.y()) + dy;
            if (bare.pixel(px, py) != ghost.pixel(px, py)) continue;  // covered by the tool itself
            with += luminance(near_tissue.pixelColor(px, py));
            without += luminance(bare.pixelColor(px, py));
        }
    }
    ASSERT_GT(without, 0);
    EXPECT_LT(with, 0.9 * without);
}

TEST_F(Renderer, TissueIsPalerWhereItIsPressedAndNowhereElse) {
    const CavityShape cavity = make_cavity({});
    renderer_.set_cavity(cavity);
    Vector3 wall(0, 0, 1);
    double least = 1;
    for (const Vector3& v : cavity.mesh.vertices) {
        const double aside = std::hypot(v.x() - 0.04, v.y() - 0.10);
        if (v.z() > 0 || aside > least) continue;
        least = aside;
        wall = v;
    }
    SceneFrame frame;
    frame.camera = look({0, 0.13, 0.05}, wall);
    const QImage bare = picture(frame);
    frame.tools = {tool_at(wall + Vector3(0, 0, 0.002), 0.0)};
    const QImage touched = picture(frame);
    frame.tools[0].strain = 1;
    const QImage pressed = picture(frame);
    frame.tools[0].strain = 0.5;
    const QImage half = picture(frame);
    const QVector3D tip = SceneRenderer::project(frame.camera, wall, frame_size);
    // Share of the colour that is white: the least of red, green and blue over the largest.
    const auto whiteness = [](const QColor& c) {
        return std::min({c.redF(), c.greenF(), c.blueF()}) /
               std::max(0.01, std::max({c.redF(), c.greenF(), c.blueF()}));
    };
    double before = 0, with_half = 0, after = 0;
    int near = 0, far_changed = 0;
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const double away =
                std::hypot(x - static_cast<double>(tip.x()), y - static_cast<double>(tip.y()));
            if (away > 90) far_changed += pressed.pixel(x, y) != touched.pixel(x, y) ? 1 : 0;
            if (away > 18 || luminance(bare.pixelColor(x, y)) == 0) continue;
            ++near;
            before += whiteness(touched.pixelColor(x, y));
            with_half += whiteness(half.pixelColor(x, y));
            after += whiteness(pressed.pixelColor(x, y));
        }
    }
    ASSERT_GT(near, 500);
    EXPECT_GT(after, 1.05 * before) << "paler under the tip";
    EXPECT_GT(with_half, before);
    EXPECT_GT(after, with_half) << "the more the stronger";
    EXPECT_EQ(far_changed, 0);
}

TEST_F(Renderer, BowelIsPinkMesenteryYellowAndWetGlintsMove) {
    const CavityShape cavity = make_cavity({});
    const BowelShape bowel = make_bowel({}, cavity);
    renderer_.set_bowel(bowel.surface, bowel.taenia);
    std::vector<float> positions, normals;
    for (const Vector3& v : bowel.surface.vertices) {
        for (int c = 0; c < 3; ++c) positions.push_back(static_cast<float>(v[c]));
    }
    for (const Vector3& n : vertex_normals(bowel.surface)) {
        for (int c = 0; c < 3; ++c) normals.push_back(static_cast<float>(n[c]));
    }
    SceneFrame frame;
    frame.bowel_positions = positions.data();
    frame.bowel_normals = normals.data();
    // The straight tube along +x from above.
    frame.camera = look({0.45, 0.0, 0.08}, {0.45, 0.0, 0.0});
    const QImage image = picture(frame);
    double red = 0, green = 0, blue = 0;
    int glints = 0;
    for (int i = -60; i <= 60; ++i) {
        const QColor c = image.pixelColor(width / 2, height / 2 + i);
        const QColor d = image.pixelColor(width / 2 + i, height / 2);
        for (const QColor& e : {c, d}) {
            red += e.redF();
            green += e.greenF();
            blue += e.blueF();
            glints += e.greenF() > 0.9 && e.blueF() > 0.85 ? 1 : 0;
        }
    }
    EXPECT_GT(red, 1.1 * green);
    EXPECT_GT(red, 1.1 * blue);
    EXPECT_GT(glints, 0);
    // The camera moves 4 mm along a tube whose tissue stays: the glint stays in the middle of the image.
    frame.camera = look({0.454, 0.0, 0.08}, {0.454, 0.0, 0.0});
    const QImage moved = picture(frame);
    double centre = 0;
    for (int i = -8; i <= 8; ++i)
        centre = std::max(centre, luminance(moved.pixelColor(width / 2 + i, height / 2)));
    EXPECT_GT(centre, 0.7);
}

TEST_F(Renderer, PauseHidesTheScene) {
    SceneFrame frame;
    frame.camera = look({0, 0.10, 0.07}, {0, 0.02, -0.02});
    EXPECT_GT(ring_luminance(picture(frame), 0, 0.5), 0.01);
    frame.notice = QStringLiteral("paused");
    EXPECT_EQ(ring_luminance(picture(frame), 0, 2), 0.0);
}

TEST_F(Renderer, SameFrameGivesTheSamePictureAlsoAfterReleasingTheRenderer) {
    renderer_.set_cavity(make_cavity({}));
    SceneFrame frame;
    frame.camera = look({0, 0.12, 0.08}, {0, 0.02, -0.03});
    frame.tools = {tool_at({0.03, 0.05, -0.01}, 0.4)};
    const QImage first = picture(frame);
    EXPECT_EQ(first, picture(frame));
    stage_.make_current();
    renderer_.release();
    EXPECT_EQ(first, picture(frame));
    SceneRenderer other(options());
    other.set_cavity(make_cavity({}));
    EXPECT_EQ(first, render_offscreen(other, frame, frame_size));
}

}  // namespace
}  // namespace fulcrum::ui
