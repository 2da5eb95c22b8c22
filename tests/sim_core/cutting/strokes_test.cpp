// SPDX-License-Identifier: Apache-2.0
// Random strokes on sphere, tube, sheet and bowel, at rest and while the shape moves: every step is
// validated where it touched, and every tenth stroke the whole surface is checked from scratch. 5,000
// strokes; FULCRUM_STROKES=N runs N and prints what they did.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <iostream>

#include "sim_core/anatomy/anatomy.h"
#include "sim_core/numerics/random.h"
#include "tests/sim_core/cutting/surfaces.h"
#include "tests/support/extremes.h"

namespace fulcrum {
namespace {

using test::between;
using test::Surface;

int strokes_asked() {
    const char* text = std::getenv("FULCRUM_STROKES");
    return text != nullptr ? std::atoi(text) : 5000;
}

struct Tally {
    int strokes = 0, steps = 0, cuts = 0, nothing = 0, roll_backs = 0, left_uncut = 0, full = 0,
        violations = 0;
    int pieces_dropped = 0;
    double worst_us = 0, worst_area_error = 0;
    std::int32_t worst_met = 0;
};

struct Kind {
    const char* name;
    TriangleMesh (*make)();
};

TriangleMesh sheet() {
    return test::cut_sheet(24, 24, 0.004);
}
TriangleMesh sphere() {
    return test::cut_sphere(3, 0.04);
}
TriangleMesh tube() {
    return test::make_tube(0.12, 30, 20, test::plain_radius(0.016));
}
TriangleMesh bowel() {
    BowelParameters parameters;
    parameters.vertices = 1000;
    return make_bowel(parameters, PelvisParameters()).surface;
}

// A smooth shape that moves with time: stretches of up to a third, bends, turns.
Vector3 moved(const Vector3& rest, double time) {
    const double wave = 0.2 * std::sin(25 * rest.x() + 1.3 * time),
                 sway = 0.15 * std::cos(31 * rest.y() + time);
    return Vector3(rest.x() * (1 + sway) + 0.3 * rest.z(), rest.y() * (1 + wave) - 0.2 * rest.x(),
                   rest.z() + 0.01 * std::sin(20 * rest.x() + time) + 0.008 * std::cos(27 * rest.y() - time));
}

class Strokes {
  public:
    Strokes(const TriangleMesh& shape, bool deform, std::uint64_t seed)
        : surface_(shape, some_fixed(shape), 900), random_(seed), deform_(deform), seed_(seed) {}

    void run(int strokes, Tally& tally) {
        for (int i = 0; i < strokes; ++i) {
            if (i % 150 == 0 || surface_.mesh.area_visible() < 0.4 * surface_.mesh.area_before())
                surface_.mesh.reset();
            time_ += 0.05;
            place();
            stroke(tally);
            ++tally.strokes;
            if (i % 10 != 9 && i + 1 < strokes) continue;
            const CutCheck check = surface_.check();
            tally.worst_area_error = std::max(tally.worst_area_error, check.area_error);
            if (!check.passed()) {
                ++tally.violations;
                ADD_FAILURE() << "seed " << seed_ << " stroke " << i << ": " << check.complaint() << " at "
                              << check.first_bad;
                return;
            }
            drop(tally);
        }
    }

  private:
    static std::vector<std::int32_t> some_fixed(const TriangleMesh& shape) {
        std::vector<std::int32_t> fixed;
        for (std::size_t v = 0; v < shape.vertices.size(); v += 37)
            fixed.push_back(static_cast<std::int32_t>(v));
        return fixed;
    }
    void place() {
        for (std::int32_t v = 0; v < surface_.mesh.vertex_count(); ++v) {
            const Vector3& rest = surface_.mesh.vertex(v).rest;
            surface_.positions[static_cast<std::size_t>(v)] = deform_ ? moved(rest, time_) : rest;
        }
    }
    const Vector3& at(std::int32_t v) const { return surface_.positions[static_cast<std::size_t>(v)]; }
    Vector3 normal_of(std::int32_t t) const {
        const Triangle& v = surface_.mesh.triangle(t).vertices;
        return area_vector(at(v[0]), at(v[1]), at(v[2]));
    }
    std::int32_t any_visible() {
        for (;;) {
            const auto t = static_cast<std::int32_t>(
                random_.below(static_cast<std::uint32_t>(surface_.mesh.triangle_count())));
            if (surface_.mesh.visible(t)) return t;
        }
    }
    Vector3 tangent(const Vector3& normal) {
        const Vector3 d = test::direction(random_);
        const Vector3 n = normal.normalized();
        return (d - n.dot(d) * n).normalized();
    }
    void stroke(Tally& tally) {
        CutMesh& mesh = surface_.mesh;
        mesh.begin_stroke();
        const std::int32_t t = any_visible();
        const Triangle& corners = mesh.triangle(t).vertices;
        BladeStep step;
        step.width = between(random_, 0.0002, 0.006);
        step.depth = 2 * step.width;
        step.start = random_.below(2) == 0 ? BladeEnd::square : BladeEnd::round;
        step.end = random_.below(4) == 0 ? BladeEnd::round : BladeEnd::square;
        step.root = mesh.triangle(t).root;
        double u = random_.uniform(), w = random_.uniform();
        const auto where = random_.below(6);
        if (where == 0)
            u = w = 0;  // from a vertex
        else if (where == 1)
            w = 0;  // from an edge
        else if (u + w > 1)
            u = 1 - u, w = 1 - w;
        step.from =
            at(corners[0]) + u * (at(corners[1]) - at(corners[0])) + w * (at(corners[2]) - at(corners[0]));
        step.normal = normal_of(t);
        Vector3 direction = tangent(step.normal);
        if (where == 2) direction = (at(corners[1]) - at(corners[0])).normalized();  // along an edge
        if (where == 2) step.from = at(corners[0]);
        const int steps = static_cast<int>(1 + random_.below(4));
        const double length = between(random_, 0.0003, 0.02);
        for (int k = 0; k < steps; ++k) {
            step.to = step.from + length * direction;
            const auto begin = std::chrono::steady_clock::now();
            const CutReport report = surface_.cut(step);
            const double us =
                std::chrono::duration<double, std::micro>(std::chrono::steady_clock::now() - begin).count();
            if (us > tally.worst_us) {
                tally.worst_us = us;
                tally.worst_met = report.met;
            }
            ++tally.steps;
            tally.roll_backs += report.roll_backs;
            tally.left_uncut += report.outcome == CutOutcome::rolled_back ? 1 : 0;
            tally.full += report.outcome == CutOutcome::full ? 1 : 0;
            tally.cuts += report.outcome == CutOutcome::cut ? 1 : 0;
            tally.nothing += report.outcome == CutOutcome::nothing ? 1 : 0;
            if (mesh.visible_count() == 0) return;
            // Onwards along the surface, at times back.
            step.root = mesh.nearest_root(step.to, surface_.positions.data());
            const std::int32_t here = mesh.root(step.root).first_visible;
            step.normal = normal_of(here);
            step.from = step.to;
            step.start = BladeEnd::round;
            if (random_.below(5) == 0) direction = -direction;
            const Vector3 n = step.normal.normalized();
            direction += 0.4 * test::inside_unit_box(random_);
            direction -= n.dot(direction) * n;
            if (direction.norm() < 1e-3) direction = tangent(n);
            direction.normalize();
        }
    }
    void drop(Tally& tally) {
        const std::int32_t pieces = surface_.mesh.find_pieces();
        for (std::int32_t p = 0; p < pieces; ++p) {
            if (surface_.mesh.piece(p).fixed) continue;
            EXPECT_EQ(surface_.mesh.remove_piece(p, surface_.positions.data()).outcome, CutOutcome::cut);
            ++tally.pieces_dropped;
            return;
        }
    }

    Surface surface_;
    Random random_;
    bool deform_;
    std::uint64_t seed_;
    double time_ = 0;
};

TEST(CutStrokes, KeepEveryInvariant) {
    const Kind kinds[] = {{"sheet", sheet}, {"sphere", sphere}, {"tube", tube}, {"bowel", bowel}};
    const int each = std::max(1, strokes_asked() / 8);
    Tally all;
    for (const Kind& kind : kinds)
        for (const bool deform : {false, true}) {
            Tally tally;
            Strokes(kind.make(), deform, deform ? 11 : 7).run(each, tally);
            all.strokes += tally.strokes;
            all.steps += tally.steps;
            all.roll_backs += tally.roll_backs;
            all.left_uncut += tally.left_uncut;
            all.violations += tally.violations;
            EXPECT_GT(tally.cuts, tally.steps / 2);
            EXPECT_EQ(tally.full, 0);
            EXPECT_LE(tally.worst_area_error, 1e-9);
            if (std::getenv("FULCRUM_STROKES") != nullptr)
                std::cout << kind.name << (deform ? " moving" : " at rest") << ": " << tally.strokes
                          << " strokes, " << tally.steps << " steps, " << tally.cuts << " cut, "
                          << tally.nothing << " met nothing, " << tally.roll_backs << " rolled back, "
                          << tally.left_uncut << " left uncut, " << tally.pieces_dropped
                          << " pieces dropped, worst step " << tally.worst_us << " us (" << tally.worst_met
                          << " triangles met), worst area error " << tally.worst_area_error << "\n";
        }
    EXPECT_EQ(all.violations, 0);
    EXPECT_LT(all.roll_backs, 0.001 * all.steps) << all.roll_backs << " of " << all.steps << " steps";
}

}  // namespace
}  // namespace fulcrum
