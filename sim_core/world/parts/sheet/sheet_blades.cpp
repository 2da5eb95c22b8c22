// SPDX-License-Identifier: Apache-2.0
#include "sim_core/world/parts/sheet/sheet_blades.h"

#include <algorithm>
#include <cmath>

#include "sim_core/geometry/closest_point.h"

namespace fulcrum {

using sheet_rows::at;

using namespace blade_law;

namespace {

constexpr double off_wall = 0.0005;         // m at rest from the muscularis that a blade keeps
constexpr double sample_spacing = 0.00015;  // m along a blade's step, where the tissue under it is looked for
constexpr double slit = 0.0006;             // m at rest across what one blade's way leaves open, at most
constexpr double fresh_by = 0.0001;         // m from where a blade is: ground that it has not been on

}  // namespace

struct SheetBlades::Follow {
    SheetBlades& blades;
    SheetBody& sheet;
    SheetHand& hand;
    int number;
    const SheetAction& action;
    const CuttingSpec* cutting;
    std::uint32_t tick;

    BladeContact contact() const {
        BladeContact at;
        at.here = sheet.place(hand.place);
        at.outward = hand.side * hand.normal;
        at.normal = hand.touch == BladeTouch::touching ? at.outward : hand.normal;
        at.reaction = hand.reaction;
        at.stiffness = sheet.tissue().stiffness;
        at.friction = hand.friction;
        at.grip = hand.cut_friction;
        at.ease = hand.ease;
        at.cutting = cutting;
        at.bites = button(action.tool) && action.instrument->cuts();
        return at;
    }
    void enter(const Vector3& here, const Vector3& along) { blades.enter(number, here, along, tick); }
    void slide(const Vector3& to) {
        const SheetPlace next = sheet.closest(to);
        if (next.fragment >= 0) hand.place = next;
    }
    void leave() { sheet.leave(number, tick); }
    Vector3 lead(const Vector3& by) const { return blades.keep_off_wall(hand.place, by); }
    void advance(const Vector3& /*here*/, const Vector3& by) { blades.advance(number, by, tick); }
};

void SheetBlades::follow(int number, const SheetAction& action, std::uint32_t tick) noexcept {
    SheetHand& hand = sheet_.state().hands[static_cast<std::size_t>(number)];
    hand.friction = sheet_.friction(action);
    hand.radius = action.instrument->tip_radius;
    const CuttingSpec* at_hand = hand.place.fragment >= 0 ? sheet_.cutting_at(hand.place) : nullptr;
    hand.ease = action.energised && at_hand != nullptr ? at_hand->energy_factor : 1.0;
    if (hand.touch == BladeTouch::cutting && hand.adrift) {
        const bool lost = hand.place.fragment < 0;
        if (lost || drawn_out(action.tool, action.instrument->tip_radius, sheet_.place(hand.place),
                              hand.side * hand.normal)) {
            sheet_.leave(number, tick);
        } else {
            drift(number, tick);
        }
        return;
    }
    if (hand.touch == BladeTouch::cutting && hand.linked && at_hand != nullptr)
        hand.cut_friction = hand.ease * at_hand->dynamic_friction;
    blade_law::follow(hand, action.tool, action.instrument->tip_radius,
                      Follow{*this, sheet_, hand, number, action, at_hand, tick});
}

void SheetBlades::enter(int number, const Vector3& here, const Vector3& along, std::uint32_t tick) noexcept {
    SheetHand& hand = sheet_.state().hands[static_cast<std::size_t>(number)];
    hand.touch = BladeTouch::cutting;
    hand.way = begin_of_way(hand.place, here - overlap * along.normalized(), hand.side * hand.normal);
    hand.cut_friction = hand.ease * sheet_.cutting_at(hand.place)->dynamic_friction;
    hand.linked = false;  // the blade is another link
    sheet_.begin_stroke();
    fibres_.begin_stroke(number);
    sheet_.add_place_event(tick, EventKind::cut_begin, number, hand.way);
}

void SheetBlades::advance(int number, const Vector3& excess, std::uint32_t tick) noexcept {
    SheetHand& hand = sheet_.state().hands[static_cast<std::size_t>(number)];
    const Vector3 here = sheet_.place(hand.place), way = excess.normalized();
    const double traction = sheet_.traction_at(here, way, hand.normal);
    const BladeStep blade = make_step(here, excess, hand.normal, sheet_.spec().blade_width,
                                      sheet_.surface().fragment(hand.place.fragment).root);
    BladeTrack track;
    follow_track(blade, track);
    if (!meets_tissue(hand.place, track)) {
        hand.adrift = true;
        hand.drifted = blade.to;
        hand.linked = false;
        drift(number, tick);
        return;
    }
    const CutReport report = sheet_.cut(blade);
    if (report.roll_backs > 0)
        sheet_.add_event(tick, EventKind::cut_rolled_back, number, 0, report.roll_backs);
    if (report.outcome == CutOutcome::full || report.outcome == CutOutcome::invalid) sheet_.note_fault(1);
    if (report.outcome != CutOutcome::cut && report.outcome != CutOutcome::nothing) return;
    const SheetPlace next = sheet_.closest(blade.to + ahead * way);
    const bool gone = next.fragment < 0 || (sheet_.place(next) - blade.to).norm() > off_by;
    if (report.outcome == CutOutcome::cut) report_track(number, track, traction, tick);
    if (gone) {
        sheet_.leave(number, tick);
    } else {
        hand.place = next;
        if (const CuttingSpec* cutting = sheet_.cutting_at(next))
            hand.cut_friction = hand.ease * cutting->dynamic_friction;
    }
}

// Between lips a blade is where the tool is, until its way comes upon tissue or leaves the slit.
void SheetBlades::drift(int number, std::uint32_t tick) noexcept {
    SheetHand& hand = sheet_.state().hands[static_cast<std::size_t>(number)];
    BladeStep blade;
    blade.from = hand.drifted;
    blade.to = hand.target;
    blade.normal = hand.normal;
    blade.width = sheet_.spec().blade_width;
    blade.depth = blade_reach;
    BladeTrack track;
    follow_track(blade, track);
    std::size_t met = 1;
    while (met < track.count && !over_tissue(track.samples[met])) ++met;
    hand.adrift = met == track.count;
    const double share = hand.adrift ? 1.0 : static_cast<double>(met) / static_cast<double>(track.count - 1);
    hand.drifted = blade.from + share * (blade.to - blade.from);
    const SheetPlace next = sheet_.closest(hand.drifted);
    if (next.fragment < 0 || (sheet_.place(next) - hand.drifted).norm() > off_by) {
        sheet_.leave(number, tick);
        return;
    }
    hand.place = next;
    if (const CuttingSpec* cutting = sheet_.cutting_at(next))
        hand.cut_friction = hand.ease * cutting->dynamic_friction;
}

void SheetBlades::report_cut(int number, const Vector3& reached, double traction,
                             std::uint32_t tick) noexcept {
    SheetHand& hand = sheet_.state().hands[static_cast<std::size_t>(number)];
    const double length = (reached - hand.way).norm();
    sheet_.mark_divided(hand.way, reached);
    fibres_.move_ends(number, hand.way, reached);
    sheet_.add_place_event(tick, EventKind::cut_advance, number, reached);
    sheet_.add_event(tick, EventKind::cut_traction, number, traction, 1e6 * length, sheet_.in_fat(reached));
    hand.way = reached;
}

// A blade's first step begins a little behind the place where it has entered.
Vector3 SheetBlades::begin_of_way(const SheetPlace& where, const Vector3& behind,
                                  const Vector3& normal) const noexcept {
    Vector3 entered = sheet_.on_septum(where, sheet_.rest(where));
    if (!behind.allFinite()) return entered;
    UnderBlade under;
    find_under(behind, normal, blade_reach, under);
    for (std::size_t k = 0; k < under.count; ++k) {
        const Vector3& first = under.layers[k].rest;
        if (sheet_.septum_at(first) == sheet_.septum_at(entered) && (first - entered).norm() <= slit)
            return first;
    }
    return entered;
}

void SheetBlades::find_under(const Vector3& point, const Vector3& normal, double depth,
                             UnderBlade& found) const noexcept {
    const Vector3 from = point - depth * normal, to = point + depth * normal;
    sheet_.visit_crossings(from, to, [&](std::int32_t t, double share) {
        const Vector3 where = from + share * (to - from);
        const Triangle& v = sheet_.surface().triangle(t).vertices;
        const Vector3 &a = sheet_.state().positions[at(v[0])], &b = sheet_.state().positions[at(v[1])],
                      &c = sheet_.state().positions[at(v[2])];
        add_under(sheet_.place_in(t, closest_point_on_triangle(where, a, b, c).barycentric),
                  std::abs(share - 0.5), found);
        return false;
    });
}

void SheetBlades::add_under(const SheetPlace& where, double away, UnderBlade& found) const noexcept {
    if (where.fragment < 0) return;
    std::size_t i = std::min(found.count, UnderBlade::capacity);
    if (i == UnderBlade::capacity && away >= found.layers[i - 1].away) return;
    if (i == UnderBlade::capacity) --i;
    for (; i > 0 && found.layers[i - 1].away > away; --i) found.layers[i] = found.layers[i - 1];
    found.layers[i] = {sheet_.on_septum(where, sheet_.rest(where)),
                       sheet_.surface().fragment(where.fragment).root, away};
    found.count = std::min(found.count + 1, UnderBlade::capacity);
}

// What lies under a blade before it is divided. Afterwards the nearest tissue may be the other lip, the rim
// that the blade has left, or the next septum.
void SheetBlades::follow_track(const BladeStep& blade, BladeTrack& track) const noexcept {
    const Vector3 way = blade.to - blade.from;
    const auto steps = static_cast<std::size_t>(
        std::clamp(std::ceil(way.norm() / sample_spacing), 1.0, double(BladeTrack::capacity - 1)));
    track.count = steps + 1;
    track.spacing = way.norm() / static_cast<double>(steps);
    for (std::size_t i = 0; i <= steps; ++i) {
        const Vector3 point = blade.from + static_cast<double>(i) / static_cast<double>(steps) * way;
        find_under(point, blade.normal, blade.depth, track.samples[i]);
        if (track.samples[i].count > 0) continue;
        // Tissue that lies along the normal has none over the point, but is in the blade's band.
        const SheetPlace there = sheet_.closest(point);
        if (there.fragment < 0) continue;
        const Vector3 off = sheet_.place(there) - point;
        const double along = std::abs(off.dot(blade.normal));
        const double across = std::sqrt(std::max(0.0, off.squaredNorm() - along * along));
        if (along > blade.depth || across > 0.5 * blade.width) continue;
        add_under(there, 0.5 * along / blade.depth, track.samples[i]);
        track.samples[i].across = across;
    }
}

// Not next to it, where a lip is.
bool SheetBlades::over_tissue(const UnderBlade& sample) noexcept {
    return sample.count > 0 && sample.across <= fresh_by;
}

// Whether a blade comes upon tissue before it. Its step begins a little behind it: where nothing is before
// it, only lips of its own cut would lose ground.
bool SheetBlades::meets_tissue(const SheetPlace& from, const BladeTrack& track) const noexcept {
    const Vector3 here = sheet_.rest(from);
    for (std::size_t i = 0; i < track.count; ++i) {
        const UnderBlade& sample = track.samples[i];
        if (static_cast<double>(i) * track.spacing <= overlap || !over_tissue(sample)) continue;
        for (std::size_t k = 0; k < sample.count; ++k) {
            if ((sample.layers[k].rest - here).norm() > fresh_by) return true;
        }
    }
    return false;
}

// Of the layers under the blade the nearest that lost ground; none where there was none.
const SheetBlades::UnderBlade::Layer* SheetBlades::divided_of(const UnderBlade& sample) const noexcept {
    const auto& roots = sheet_.surface().touched_roots();
    for (std::size_t k = 0; k < sample.count; ++k) {
        if (std::find(roots.begin(), roots.end(), sample.layers[k].root) != roots.end())
            return &sample.layers[k];
    }
    return nullptr;
}

// Whether what lies between two samples of a track is the tissue between them: of one triangle as it was made
// or of two that touch, or no farther than a slit is wide.
bool SheetBlades::joined(const UnderBlade::Layer& a, const UnderBlade::Layer& b) const noexcept {
    if (sheet_.septum_at(a.rest) != sheet_.septum_at(b.rest)) return false;
    if ((a.rest - b.rest).norm() <= slit) return true;
    const Triangle &first = sheet_.layout().mesh.triangles[at(a.root)],
                   &second = sheet_.layout().mesh.triangles[at(b.root)];
    return std::find_first_of(first.begin(), first.end(), second.begin(), second.end()) != first.end();
}

// A cut is reported where tissue was under the blade without a break; between two such paths it ends and
// begins.
void SheetBlades::report_track(int number, const BladeTrack& track, double traction,
                               std::uint32_t tick) noexcept {
    SheetHand& hand = sheet_.state().hands[static_cast<std::size_t>(number)];
    const UnderBlade::Layer* last = nullptr;  // of the way that is open
    for (std::size_t i = 0; i < track.count; ++i) {
        const UnderBlade::Layer* here = divided_of(track.samples[i]);
        if (last != nullptr && (here == nullptr || !joined(*last, *here))) {
            if (last->rest != hand.way) report_cut(number, last->rest, traction, tick);
            last = nullptr;
        }
        if (here == nullptr) continue;
        // What was left between here and the end of the way before is the slit that the blade came in.
        if (last == nullptr && (sheet_.septum_at(hand.way) != sheet_.septum_at(here->rest) ||
                                (here->rest - hand.way).norm() > slit)) {
            sheet_.add_place_event(tick, EventKind::cut_end, number, hand.way);
            hand.way = here->rest;
            sheet_.add_place_event(tick, EventKind::cut_begin, number, hand.way);
        }
        last = here;
    }
    if (last != nullptr && last->rest != hand.way) report_cut(number, last->rest, traction, tick);
}

// The muscularis of the rectum is not cut: a blade that would come to it is led along it.
Vector3 SheetBlades::keep_off_wall(const SheetPlace& where, const Vector3& way) const noexcept {
    if (!sheet_.septa() || where.fragment < 0) return way;
    const std::int32_t root = sheet_.surface().fragment(where.fragment).root;
    const Triangle& corners = sheet_.layout().mesh.triangles[at(root)];
    const auto& nodes = sheet_.state().membrane.pieces[at(where.fragment)].nodes;
    const auto now = [&](std::size_t c) -> const Vector3& {
        return sheet_.state().membrane.positions[at(nodes[c])];
    };
    const auto before = [&](std::size_t c) -> const Vector3& { return sheet_.layout().rest[at(corners[c])]; };
    // Height at rest as a function of the place now.
    const Vector3 u = now(1) - now(0), v = now(2) - now(0), n = u.cross(v);
    const double area = n.squaredNorm();
    if (!(area > 1e-30)) return Vector3::Zero();
    const Vector3 slope =
        ((before(1).y() - before(0).y()) * v.cross(n) + (before(2).y() - before(0).y()) * n.cross(u)) / area;
    const double rise = way.dot(slope), most = sheet_.septa()->fat_height - sheet_.septa()->plane_height -
                                               off_wall - sheet_.rest(where).y();
    if (rise <= most) return way;
    return way - (rise - std::max(0.0, most)) / slope.squaredNorm() * slope;
}

}  // namespace fulcrum
