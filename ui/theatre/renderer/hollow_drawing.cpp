// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theatre/renderer/hollow_drawing.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <map>
#include <utility>

#include "sim_core/anatomy/scene_anatomy.h"

namespace fulcrum::ui {
namespace {

constexpr double pi = 3.14159265358979323846;
constexpr double side_wall = 0.046,
                 front_wall = 0.040;  // m from the rectum's centre line: narrow, as the pelvis is
constexpr double beyond = 0.024,
                 levator = 0.030;     // m of wall past the rectum's cranial end, and of the floor below
constexpr double open_from = 0.85;    // of the rectum's length: above it lies the abdomen
constexpr double behind = 1.0;        // rad either side of straight behind that the fascia covers
constexpr double step = 0.008;        // m between the walls' vertices
constexpr double surrounding = 0.15;  // m of what lies round about
constexpr double wraps = 2.35;        // rad from straight behind that the fat reaches round

/// Surfaces that never change still must not be taken for those of the scene before.
std::uint64_t fresh_version() {
    static std::atomic<std::uint64_t> last{1U << 20U};
    return ++last;
}

/// From 0 at `from` to 1 at `to`, which may lie below it.
double smooth(double from, double to, double x) {
    const double t = std::clamp((x - from) / (to - from), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

template <typename Surface>
void close_grid(Surface& surface, int rows, int columns) {
    for (int r = 0; r + 1 < rows; ++r) {
        for (int c = 0; c + 1 < columns; ++c) {
            const std::int32_t a = r * columns + c, b = a + 1, d = a + columns, e = d + 1;
            surface.triangles.push_back({a, b, e});
            surface.triangles.push_back({a, e, d});
        }
    }
}

/// What lies round about a surface's rims, straight away from the rectum's centre line: no one shall see
/// where the drawn pelvis ends. It has vertices of its own: a normal blended over so sharp an edge would
/// shine along all of it.
template <typename Surface>
void surround(Surface& surface, const SacralCurve& curve) {
    std::map<std::pair<std::int32_t, std::int32_t>, int> sides;
    for (const Triangle& t : surface.triangles) {
        for (int c = 0; c < 3; ++c) {
            const auto a = t[c], b = t[(c + 1) % 3];
            sides[{std::min(a, b), std::max(a, b)}] += a < b ? 1 : 2;
        }
    }
    std::map<std::int32_t, std::int32_t> made;  // the rim's copy; what lies far out follows it
    const auto copy = [&](std::int32_t v) {
        const auto next = static_cast<std::int32_t>(surface.positions.size());
        const auto [found, fresh] = made.emplace(v, next);
        if (!fresh) return found->second;
        const auto k = static_cast<std::size_t>(v);
        const Vector3 p = surface.positions[k], rest = surface.rest[k];
        Vector3 from = p - curve.centre;
        from.x() = 0;
        const Vector3 way = (p - curve.centre - curve.curve_radius * from.normalized()).normalized();
        surface.positions.push_back(p);
        surface.rest.push_back(rest);
        surface.positions.push_back(p + surrounding * way);
        surface.rest.push_back(rest + Vector3(surrounding, 0, 0));
        return next;
    };
    for (const auto& [edge, side] : sides) {
        if (side == 3) continue;
        const std::int32_t a = copy(side == 1 ? edge.first : edge.second),
                           b = copy(side == 1 ? edge.second : edge.first);
        surface.triangles.push_back({b, a, a + 1});
        surface.triangles.push_back({b, a + 1, b + 1});
    }
}

/// A grid's rows and columns, of the triangles {a, a + 1, ...} that close_grid lays.
struct Grid {
    int rows = 0, columns = 0;
    std::size_t at(int row, int column) const { return static_cast<std::size_t>(row * columns + column); }
};

/// Sharp folds of a grid, over a few vertices either side of them: bone under tissue is round, and a fold of
/// one row shines like a wire. Elsewhere the wall stays as instruments feel it.
void round_folds(const Grid& grid, std::vector<Vector3>& positions) {
    constexpr int passes = 40, reach = 6, span = 2;
    constexpr double sharp = 0.3;  // rad between edges of two steps: more than what is uneven anyway
    const auto fold = [&](std::size_t before, std::size_t at, std::size_t after) {
        const Vector3 to = positions[at] - positions[before], from = positions[after] - positions[at];
        return std::atan2(to.cross(from).norm(), to.dot(from)) > sharp;
    };
    std::vector<double> share(positions.size(), 0);
    const auto near = [&](int row, int column, int rows, int columns) {
        for (int d = -reach; d <= reach; ++d) {
            const int r = row + d * rows, c = column + d * columns;
            if (r < 0 || r >= grid.rows || c < 0 || c >= grid.columns) continue;
            double& own = share[grid.at(r, c)];
            own = std::max(own, smooth(1, 0, std::abs(d) / (reach + 1.0)));
        }
    };
    for (int r = span; r + span < grid.rows; ++r) {
        for (int c = span; c + span < grid.columns; ++c) {
            if (fold(grid.at(r - span, c), grid.at(r, c), grid.at(r + span, c))) near(r, c, 1, 0);
            if (fold(grid.at(r, c - span), grid.at(r, c), grid.at(r, c + span))) near(r, c, 0, 1);
        }
    }
    for (int pass = 0; pass < passes; ++pass) {
        const std::vector<Vector3> before = positions;
        for (int r = 1; r + 1 < grid.rows; ++r) {
            for (int c = 1; c + 1 < grid.columns; ++c) {
                const Vector3 mean = 0.25 * (before[grid.at(r - 1, c)] + before[grid.at(r + 1, c)] +
                                             before[grid.at(r, c - 1)] + before[grid.at(r, c + 1)]);
                positions[grid.at(r, c)] += 0.7 * share[grid.at(r, c)] * (mean - before[grid.at(r, c)]);
            }
        }
    }
}

/// Of so many rows or columns both rims with their neighbours, and between them about every third: as many
/// on one side of the middle as on the other.
std::vector<int> thinned(int count) {
    constexpr int stride = 3;
    const int last = count - 1, steps = std::max(1, (count - 3 + stride) / (2 * stride));
    std::vector<int> kept = {0};
    const auto keep = [&kept](int k) {
        if (k > kept.back()) kept.push_back(k);
    };
    for (int i = 0; i <= steps; ++i) keep(1 + i * (last / 2 - 1) / steps);
    for (std::size_t k = kept.size(); k-- > 0;) keep(last - kept[k]);
    return kept;
}

/// Leaves some of a grid's rows and columns: as the wall is felt it is finer than eyes need, and a picture
/// that a processor draws costs what its triangles touch.
template <typename Surface>
Grid thin(const Grid& grid, Surface& surface) {
    const std::vector<int> rows = thinned(grid.rows), columns = thinned(grid.columns);
    for (std::vector<Vector3>* values : {&surface.positions, &surface.rest}) {
        std::vector<Vector3> kept;
        for (const int r : rows) {
            for (const int c : columns) kept.push_back((*values)[grid.at(r, c)]);
        }
        values->swap(kept);
    }
    return {static_cast<int>(rows.size()), static_cast<int>(columns.size())};
}

}  // namespace

HollowDrawing::HollowDrawing(const Scene& scene, const WorldSnapshot& first)
    : skin_radius_(scene.bowel->outer_radius), mesorectum_(scene.presacral->gap) {
    const RectumParameters rectum = rectum_parameters(scene);
    if (scene.septa) {
        mesorectum_ -= scene.septa->areolar_height;
        for (int k = scene.septa->count - 1; k >= 0; --k)
            septum_at_.push_back(septum_arc_length(*scene.septa, rectum.curve, k));
    }
    lay_walls(rectum);
    learn_septa(first.sheet);
}

// The fascia as instruments feel it; beyond its rims the side walls and what lies in front, drawn only.
void HollowDrawing::lay_walls(const RectumParameters& rectum) {
    const SacralCurve& curve = rectum.curve;
    const TriangleMesh posterior = make_presacral_wall(rectum);
    Grid felt;
    felt.columns = posterior.triangles.empty() ? 1 : posterior.triangles[0][2] - 1;
    felt.rows = static_cast<int>(posterior.vertices.size()) / felt.columns;
    std::vector<Vector3> positions = posterior.vertices;
    round_folds(felt, positions);
    // It continues beyond its rims with the shape that it has there, so that its end is not visible.
    const Grid grid{felt.rows + 2, felt.columns + 2};
    const auto beyond_rim = [&](const std::vector<Vector3>& of, int r, int c) {
        const int row = std::clamp(r, 0, felt.rows - 1), column = std::clamp(c, 0, felt.columns - 1);
        const int inner_row = row + (row - r), inner_column = column + (column - c);
        const double run =
            (positions[felt.at(row, column)] - positions[felt.at(inner_row, inner_column)]).norm();
        const Vector3 edge = of[felt.at(row, column)];
        if (!(run > 0)) return edge;
        return Vector3(edge + surrounding / run * (edge - of[felt.at(inner_row, inner_column)]));
    };
    std::vector<Vector3> rest;
    for (const Vector3& p : positions) {
        const double y = std::hypot(p.y() - curve.centre.y(), p.z() - curve.centre.z());
        const double along = std::atan2(p.y() - curve.centre.y(), curve.centre.z() - p.z());
        rest.emplace_back(y * along, curve.fascia_radius() * std::atan2(p.x(), y - curve.curve_radius), 0);
    }
    for (int r = -1; r <= felt.rows; ++r) {
        for (int c = -1; c <= felt.columns; ++c) {
            fascia_.positions.push_back(beyond_rim(positions, r, c));
            fascia_.rest.push_back(beyond_rim(rest, r, c));
        }
    }
    const Grid shown = thin(grid, fascia_);
    close_grid(fascia_, shown.rows, shown.columns);
    // The scope looks from the cranial end: what lies there is drawn first and hides the rest.
    std::reverse(fascia_.triangles.begin(), fascia_.triangles.end());
    fascia_.version = fresh_version();

    // Open behind, where the fascia lies, and towards the abdomen, where it widens.
    const double cranial = open_from * rectum.length, length = cranial + beyond;
    const int rows = static_cast<int>(std::ceil(length / step)) + 1, floor_rows = 5, around = 40;
    for (int r = -floor_rows; r < rows; ++r) {
        const double s = length * std::max(r, 0) / (rows - 1) - beyond;
        // The floor closes like a dome.
        const double down = r < 0 ? static_cast<double>(-r) / floor_rows : 0;
        const double narrow = std::sqrt(std::max(0.0, 1 - down * down));
        const double wide = 0.05 * smooth(0.45 * cranial, 1.3 * cranial, s);
        for (int k = 0; k <= around; ++k) {
            // In the floor all round; above it from one rim of the fascia over the front to the other.
            const double turn = (r < 0 ? pi : pi - behind) * (2.0 * k / around - 1) + pi;
            const double from_behind = pi - std::abs(turn - pi);
            const double front = smooth(1.9, 3.0, from_behind);
            const double rear = r < 0 ? smooth(1.4, 0.8, from_behind) : 0;
            double radius = side_wall + front * (front_wall - side_wall) + wide;
            radius += rear * (curve.fascia_radius() + 0.0006 - side_wall);
            radius += 0.0016 * std::sin(7 * turn + 90 * s);
            const Vector3 p = curve.point(s, turn, curve.fascia_radius() - narrow * radius);
            walls_.positions.push_back(p - down * levator * curve.cranial(s));
            walls_.rest.emplace_back(s - down * levator, side_wall * turn, 0);
        }
    }
    close_grid(walls_, rows + floor_rows, around + 1);
    surround(walls_, curve);
    std::reverse(walls_.triangles.begin(), walls_.triangles.end());
    walls_.version = fresh_version();
}

// Fat all round but in front, from where the septa's fat begins to the wall of the bowel. Row by row along
// the rectum's rings; between septa what lies either side is blended in the ring's own frame.
void HollowDrawing::lay_envelope(const WorldSnapshot& snapshot) {
    const SheetView& view = snapshot.sheet;
    const auto columns = static_cast<std::size_t>(view.envelope_columns);
    const std::size_t septa = columns == 0 ? 0 : view.envelope.size() / columns;
    const std::size_t rings = std::min(snapshot.bowel.rings.size(), snapshot.bowel.ring_arc_lengths.size());
    envelope_.positions.clear();
    if (septa == 0 || septa != septum_at_.size() || rings < 3 || columns < 2) return;
    const auto ring_near = [&](double s) {
        const auto found = std::lower_bound(snapshot.bowel.ring_arc_lengths.begin(),
                                            snapshot.bowel.ring_arc_lengths.end(), s);
        return std::min(static_cast<std::size_t>(found - snapshot.bowel.ring_arc_lengths.begin()), rings - 1);
    };
    // Angle about the ring and distance from it, septum by septum, caudal first.
    std::vector<double> distance(septa * columns), angle(septa * columns);
    for (std::size_t k = 0; k < septa; ++k) {
        const RingFrame& ring = snapshot.bowel.rings[ring_near(septum_at_[k])];
        for (std::size_t c = 0; c < columns; ++c) {
            const Vector3 local =
                ring.rotation.transpose() * (view.envelope[(septa - 1 - k) * columns + c] - ring.position);
            distance[k * columns + c] =
                std::clamp(std::hypot(local.x(), local.y()), skin_radius_, 3 * skin_radius_);
            double own = std::atan2(local.y(), local.x());
            if (c > 0) own += 2 * pi * std::round((angle[k * columns + c - 1] - own) / (2 * pi));
            angle[k * columns + c] = own;
        }
        if (k > 0) {  // no turn of a whole circle between one septum and the next
            const double whole =
                2 * pi * std::round((angle[(k - 1) * columns] - angle[k * columns]) / (2 * pi));
            for (std::size_t c = 0; c < columns; ++c) angle[k * columns + c] += whole;
        }
    }
    constexpr int flank = 9;  // columns on either side that lead round to the bowel
    const std::size_t width = columns + 2 * flank;
    constexpr std::size_t closing = 4;  // rows that lead from the cranial rim in to the bowel: solid fat
    for (std::size_t row = 0; row < rings + closing; ++row) {
        const std::size_t r = std::min(row, rings - 1);
        const double inwards = static_cast<double>(row - r) / closing;
        const double s = snapshot.bowel.ring_arc_lengths[r];
        const auto above = std::lower_bound(septum_at_.begin(), septum_at_.end(), s);
        const auto after = std::min(static_cast<std::size_t>(above - septum_at_.begin()), septa - 1);
        const std::size_t before = after == 0 ? 0 : after - 1;
        const double run = septum_at_[after] - septum_at_[before];
        const double share = run > 0 ? smooth(0, 1, (s - septum_at_[before]) / run) : 0;
        const auto at = [&](const std::vector<double>& values, std::size_t c) {
            return values[before * columns + c] +
                   share * (values[after * columns + c] - values[before * columns + c]);
        };
        const double first = at(angle, 0), last = at(angle, columns - 1), middle = 0.5 * (first + last);
        const double sense = last > first ? 1.0 : -1.0;
        const RingFrame& ring = snapshot.bowel.rings[r];
        const auto add = [&](double about, double rim) {
            const double away = rim + inwards * (std::min(rim, 0.95 * skin_radius_) - rim);
            // Lobules: what a normal map alone leaves flat.
            const double lobes = 0.0007 * std::sin(310 * s + 2.3 * about) * std::sin(9 * about - 120 * s);
            const double far = away > skin_radius_ * 1.05 ? away + lobes : away;
            envelope_.positions.push_back(
                ring.position + ring.rotation * Vector3(far * std::cos(about), far * std::sin(about), 0));
            envelope_.rest.emplace_back(s + rim - away,
                                        (skin_radius_ + mesorectum_) * (about - middle) * sense, 0);
        };
        const auto lead = [&](double edge_angle, double edge_distance, double side, int i) {
            const double t = static_cast<double>(i) / flank;
            const double end = middle + side * wraps;
            add(edge_angle + t * (end - edge_angle),
                edge_distance + smooth(0.1, 1, t) * (0.95 * skin_radius_ - edge_distance));
        };
        if (row == 0) envelope_.rest.clear();
        for (int i = flank; i > 0; --i) lead(first, at(distance, 0), -sense, i);
        for (std::size_t c = 0; c < columns; ++c) add(at(angle, c), at(distance, c));
        for (int i = 1; i <= flank; ++i) lead(last, at(distance, columns - 1), sense, i);
    }
    if (envelope_.triangles.empty())
        close_grid(envelope_, static_cast<int>(rings + closing), static_cast<int>(width));
}

// The vertices as they were made lie on a grid of rest coordinates; char is kept by triangle as they were
// made.
void HollowDrawing::learn_septa(const SheetView& view) {
    if (view.septum_length <= 0 || view.envelope_columns < 2 || view.triangle_count == 0) return;
    grid_x_ = view.septum_length / (view.envelope_columns - 1);
    grid_y_ = 0.001;
    double highest = -1;
    lowest_ = 1;
    for (std::int32_t v = 0; v < view.vertex_count; ++v) {
        lowest_ = std::min(lowest_, view.rest[static_cast<std::size_t>(v)].y());
        highest = std::max(highest, view.rest[static_cast<std::size_t>(v)].y());
    }
    const auto septa = static_cast<int>(view.envelope.size()) / view.envelope_columns;
    grid_columns_ = septa * (view.envelope_columns - 1) + 1;
    grid_rows_ = static_cast<int>(std::ceil((highest - lowest_) / grid_y_)) + 1;
    triangles_at_.assign(static_cast<std::size_t>(grid_columns_) * static_cast<std::size_t>(grid_rows_), {});
    for (std::int32_t t = 0; t < view.triangle_count; ++t) {
        const Triangle& triangle = view.triangles[static_cast<std::size_t>(t)];
        double low_x = 1e9, high_x = -1e9, low_y = 1e9, high_y = -1e9;
        for (const std::int32_t v : triangle) {
            const Vector3& p = view.rest[static_cast<std::size_t>(v)];
            low_x = std::min(low_x, p.x()), high_x = std::max(high_x, p.x());
            low_y = std::min(low_y, p.y()), high_y = std::max(high_y, p.y());
        }
        const int c0 = std::max(0, static_cast<int>(std::floor(low_x / grid_x_ + 0.01)));
        const int c1 = std::min(grid_columns_ - 1, static_cast<int>(std::ceil(high_x / grid_x_ - 0.01)));
        const int r0 = std::max(0, static_cast<int>((low_y - lowest_) / grid_y_));
        const int r1 = std::min(grid_rows_ - 1, static_cast<int>(std::ceil((high_y - lowest_) / grid_y_)));
        for (int r = r0; r <= r1; ++r) {
            for (int c = c0; c <= c1; ++c)
                triangles_at_[static_cast<std::size_t>(r * grid_columns_ + c)].push_back(t);
        }
    }
}

void HollowDrawing::blacken(const WorldSnapshot& snapshot) {
    burnt_.clear();
    if (grid_columns_ == 0) return;
    const std::vector<float>& by_triangle = snapshot.structures.sheet_char;
    if (std::none_of(by_triangle.begin(), by_triangle.end(), [](float c) { return c > 0; })) return;
    char_at_.assign(triangles_at_.size(), 0);
    for (std::size_t place = 0; place < triangles_at_.size(); ++place) {
        for (const std::int32_t t : triangles_at_[place]) {
            if (static_cast<std::size_t>(t) < by_triangle.size())
                char_at_[place] = std::max(char_at_[place], by_triangle[static_cast<std::size_t>(t)]);
        }
    }
    const SheetView& view = snapshot.sheet;
    burnt_.resize(static_cast<std::size_t>(view.vertex_count));
    for (std::size_t v = 0; v < burnt_.size(); ++v) {
        const Vector3& p = view.rest[v];
        const int c = std::clamp(static_cast<int>(std::lround(p.x() / grid_x_)), 0, grid_columns_ - 1);
        const int r =
            std::clamp(static_cast<int>(std::lround((p.y() - lowest_) / grid_y_)), 0, grid_rows_ - 1);
        burnt_[v] = char_at_[static_cast<std::size_t>(r * grid_columns_ + c)];
    }
}

DrawnSheet HollowDrawing::drawn(const Surface& surface, SheetWear wear) {
    DrawnSheet sheet;
    sheet.surface = {surface.positions.data(), surface.rest.data(),      surface.positions.size(),
                     surface.triangles.data(), surface.triangles.size(), 0};
    sheet.version = surface.version;
    sheet.wear = wear;
    return sheet;
}

void HollowDrawing::add(const WorldSnapshot& snapshot, SceneFrame& frame) {
    frame.enclosed = true;
    DrawnSheet fascia = drawn(fascia_, SheetWear::peritoneum);
    // Greyish white and glossy, what lies beneath shows through.
    fascia.tint = QVector3D(0.66F, 0.50F, 0.47F);
    fascia.tint_share = 0.50F;
    fascia.relief = 0.5F;
    fascia.large = true;
    fascia.order = 2;
    frame.sheets.push_back(fascia);
    DrawnSheet walls = drawn(walls_, SheetWear::peritoneum);
    walls.large = true;
    walls.order = 3;
    frame.sheets.push_back(walls);
    lay_envelope(snapshot);
    if (!envelope_.positions.empty()) {
        DrawnSheet fat = drawn(envelope_, SheetWear::fat);
        fat.version = 0;
        fat.relief = 0.8F;
        frame.sheets.push_back(fat);
    }
    blacken(snapshot);
    for (DrawnSheet& sheet : frame.sheets) {
        if (sheet.surface.positions != snapshot.sheet.positions.data()) continue;
        sheet.fibres = true;
        sheet.fat_from = snapshot.sheet.fat_from;
        sheet.order = 1;
        sheet.surface.burnt = burnt_.empty() ? nullptr : burnt_.data();
    }
}

}  // namespace fulcrum::ui
