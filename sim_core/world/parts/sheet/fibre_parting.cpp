// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/sheet/fibre_parting.h"

#include <algorithm>
#include <cmath>

#include "sim_core/geometry/closest_point.h"

namespace fulcrum {

using sheet_rows::at;
namespace {

constexpr double least_run = 0.00035;    // m that gather before they part
constexpr double parted_width = 0.0002;  // m of ground that is lost with them
constexpr double parted_reach = 0.003;   // m along the normal to either side
constexpr double overlap = 0.0003;       // m by which a parting begins in the cut behind it
constexpr double beyond = 0.0002;        // m from an end to the tissue that it is known by
constexpr double probe = 0.004;  // m ahead of an end, where the tension is measured: all of it is whole there
constexpr double off_by = 0.002;  // m from the nearest tissue: the end has run over the rim
constexpr double kept_slack = 1e-6;

}  // namespace

bool FibreParting::along_line(const SheetPlace& where, Vector3& way, Vector3& normal) const noexcept {
    // The line's direction at rest, carried with the root's triangle.
    if (where.fragment < 0 || sheet_.state().membrane.pieces[at(where.fragment)].root < 0) return false;
    const auto& nodes = sheet_.state().membrane.pieces[at(where.fragment)].nodes;
    SheetPlace corner = where;
    Vector3 before[3];
    for (int c = 0; c < 3; ++c) {
        corner.barycentric = Vector3::Unit(c);
        before[c] = sheet_.rest(corner);
    }
    const Vector3 u = before[1] - before[0], v = before[2] - before[0];
    const double area = u.x() * v.y() - u.y() * v.x();
    const Vector3& origin = sheet_.state().membrane.positions[at(nodes[0])];
    const Vector3 un = sheet_.state().membrane.positions[at(nodes[1])] - origin,
                  vn = sheet_.state().membrane.positions[at(nodes[2])] - origin;
    normal = un.cross(vn);
    if (!(std::abs(area) > 0)) return false;
    way = (v.y() * un - u.y() * vn) / area;
    const double length = way.norm(), size = normal.norm();
    if (!(length > 1e-9) || !(size > 0)) return false;
    way /= length;
    normal /= size;
    return true;
}

void FibreParting::begin_stroke(int number) noexcept {
    if (!sheet_.spec().fibres) return;
    const auto hand = static_cast<std::size_t>(number);
    sheet_.state().fibres.back[hand] = sheet_.state().fibres.front[hand] = -1;
}

void FibreParting::move_ends(int number, const Vector3& from, const Vector3& reached) noexcept {
    if (!sheet_.spec().fibres || reached.x() == from.x()) return;
    const auto hand = static_cast<std::size_t>(number);
    SheetFibres& fibres = sheet_.state().fibres;
    const double direction = reached.x() > from.x() ? 1 : -1;
    if (fibres.front[hand] < 0) {
        fibres.back[hand] = fibres.add(find_end(from, -direction));
        fibres.front[hand] = fibres.add({});
    }
    fibres.tips[at(fibres.front[hand])] = find_end(reached, direction);
}

SheetFibres::Tip FibreParting::find_end(const Vector3& reached, double direction) const noexcept {
    SheetFibres::Tip tip;
    tip.direction = direction;
    const Vector3 wanted = reached + direction * beyond * Vector3::UnitX();
    double nearest = off_by * off_by;
    for (const SheetBody::VisibleTriangle& t : sheet_.visible()) {
        // By places at rest: what is next to the cut now may come from its other lip.
        const Triangle& corners = t.vertices;
        Vector3 points[3];
        for (std::size_t c = 0; c < 3; ++c) points[c] = sheet_.rest(sheet_.state().bindings[at(corners[c])]);
        const TrianglePoint foot = closest_point_on_triangle(wanted, points[0], points[1], points[2]);
        const double distance = (foot.position - wanted).squaredNorm();
        if (!(distance < nearest)) continue;
        const SheetPlace found = sheet_.place_in(t.number, foot.barycentric);
        if (found.fragment < 0) continue;
        nearest = distance;
        tip.root = sheet_.surface().fragment(found.fragment).root;
        tip.barycentric = found.barycentric;
    }
    return tip;
}

void FibreParting::step(std::uint32_t tick, double dt) noexcept {
    if (!sheet_.spec().fibres) return;
    SheetFibres& fibres = sheet_.state().fibres;
    const auto stations = static_cast<std::int32_t>(sheet_.state().line.size());
    if (stations > 0 && open_fibres((sheet_.state().next_station + stations - 1) % stations, tick)) return;
    // One end a step; each gets the time of all.
    std::int32_t ends = 0, chosen = -1;
    for (std::int32_t k = 0; k < SheetFibres::capacity; ++k) {
        const std::int32_t i = (fibres.looked + k) % SheetFibres::capacity;
        bool blade = false;
        for (std::size_t h = 0; h < hand_count; ++h)
            blade = blade || (sheet_.state().hands[h].touch == BladeTouch::cutting && fibres.front[h] == i);
        if (fibres.tips[at(i)].root < 0 || blade) continue;
        ++ends;
        if (chosen < 0) chosen = i;
    }
    if (chosen < 0) return;
    fibres.looked = (chosen + 1) % SheetFibres::capacity;
    SheetFibres::Tip& tip = fibres.tips[at(chosen)];
    const SheetPlace here = sheet_.find_in_root(tip.root, tip.barycentric, kept_slack);
    if (here.fragment < 0 || sheet_.state().loose[at(here.fragment)] != 0 ||
        sheet_.in_fat(sheet_.rest(here))) {
        tip.root = -1;  // cut away, or come to tissue that does not part
        return;
    }
    Vector3 way, normal;
    if (!along_line(here, way, normal)) return;
    way *= tip.direction;
    const Vector3 from = sheet_.place(here);
    const double traction = sheet_.traction_at(from + probe * way, way, normal);
    const double excess = traction / sheet_.spec().fibres->strength - 1;
    if (!(excess > 0)) {
        tip.gathered = 0;
        return;
    }
    tip.gathered = std::min(tip.gathered + sheet_.spec().fibres->speed * std::min(1.0, excess) * dt * ends,
                            2 * least_run);
    if (tip.gathered < least_run) return;
    const double run = tip.gathered, direction = tip.direction;
    tip = SheetFibres::Tip();
    Vector3 reached;
    const Vector3 begin = sheet_.rest(here) - direction * beyond * Vector3::UnitX();  // the end itself
    if (part(here, begin, way, normal, run, traction, tick, reached)) tip = find_end(reached, direction);
}

// begin: at rest, from where on the ground is reported as parted.
bool FibreParting::part(const SheetPlace& here, const Vector3& begin, const Vector3& way,
                        const Vector3& normal, double run, double traction, std::uint32_t tick,
                        Vector3& reached) noexcept {
    const Vector3 from = sheet_.place(here);
    BladeStep blade;
    blade.from = from - overlap * way;
    blade.to = from + run * way;
    blade.normal = normal;
    blade.width = parted_width;
    blade.depth = parted_reach;
    blade.root = sheet_.surface().fragment(here.fragment).root;
    SheetPlace end = sheet_.closest(blade.to);
    const bool gone = end.fragment < 0 || (sheet_.place(end) - blade.to).norm() > off_by;
    reached = sheet_.rest(end);
    const CutReport report = sheet_.cut(blade);
    if (report.roll_backs > 0) sheet_.add_event(tick, EventKind::cut_rolled_back, -1, 0, report.roll_backs);
    if (report.outcome == CutOutcome::full || report.outcome == CutOutcome::invalid) sheet_.note_fault(1);
    if (report.outcome != CutOutcome::cut) return false;
    sheet_.mark_divided(begin, reached);
    sheet_.add_place_event(tick, EventKind::fibres_parted, -1, begin);
    sheet_.add_place_event(tick, EventKind::cut_advance, -1, reached);
    sheet_.add_event(tick, EventKind::cut_traction, -1, traction, 1e6 * (reached - begin).norm(),
                     sheet_.in_fat(reached));
    return !gone;
}

bool FibreParting::open_fibres(std::int32_t station, std::uint32_t tick) noexcept {
    // Away from every cut: a slit opens whose two ends then run.
    const double traction = sheet_.state().traction[at(station)];
    if (!(traction > sheet_.spec().fibres->strength)) return false;
    const SheetPlace here = sheet_.state().line[at(station)];
    Vector3 way, normal, reached;
    if (!along_line(here, way, normal)) return false;
    const Vector3 begin = sheet_.rest(here) - overlap * Vector3::UnitX();
    const bool goes_on = part(here, begin, way, normal, least_run, traction, tick, reached);
    if (goes_on) sheet_.state().fibres.add(find_end(reached, 1));
    if (goes_on) sheet_.state().fibres.add(find_end(begin, -1));
    sheet_.state().traction[at(station)] = 0;
    return true;
}

}  // namespace fulcrum
