// SPDX-License-Identifier: Apache-2.0
// Blades in the sheet: Eqs. 6 and 7, the steps of a cut, and what becomes of it in springs, places and
// pieces.
#include <algorithm>
#include <cmath>

#include "sim_core/world/parts/sheet/sheet_part.h"

namespace fulcrum {

using namespace blade_law;

namespace {

constexpr double line_reach = 0.012;  // m from the marked line within which a cut divides the sheet across it
constexpr double off_wall = 0.0005;   // m at rest from the muscularis that a blade keeps
constexpr double off_rim =
    1e-6;  // m: places are reported as being this far from the rim of a septum at least
constexpr double sample_spacing = 0.00015;  // m along a blade's step, where the tissue under it is looked for
constexpr double slit = 0.0006;             // m at rest across what one blade's way leaves open, at most
constexpr double fresh_by = 0.0001;         // m from where a blade is: ground that it has not been on
constexpr double kept_slack = 1e-6;

std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
}

}  // namespace

void SheetPart::leave(int number, std::uint32_t tick) noexcept {
    HandState& hand = state_.hands[static_cast<std::size_t>(number)];
    add_place_event(tick, EventKind::cut_end, number, hand.way);
    hand.touch = BladeTouch::clearing;
    hand.linked = hand.adrift = false;
    hand.cover = 0;
    hand.reaction.setZero();
}

struct SheetPart::Follow {
    SheetPart& sheet;
    HandState& hand;
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
        at.stiffness = sheet.tissue_.stiffness;
        at.friction = hand.friction;
        at.grip = hand.cut_friction;
        at.ease = hand.ease;
        at.cutting = cutting;
        at.bites = button(action.tool) && action.instrument->cuts();
        return at;
    }
    void enter(const Vector3& here, const Vector3& along) { sheet.enter(number, here, along, tick); }
    void slide(const Vector3& to) {
        const SheetPlace next = sheet.closest(to);
        if (next.fragment >= 0) hand.place = next;
    }
    void leave() { sheet.leave(number, tick); }
    Vector3 lead(const Vector3& by) const { return sheet.keep_off_wall(hand.place, by); }
    void advance(const Vector3& /*here*/, const Vector3& by) { sheet.advance(number, by, tick); }
};

void SheetPart::follow(int number, const SheetAction& action, std::uint32_t tick) noexcept {
    HandState& hand = state_.hands[static_cast<std::size_t>(number)];
    hand.friction = friction(action);
    hand.radius = action.instrument->tip_radius;
    const CuttingSpec* at_hand = hand.place.fragment >= 0 ? cutting_at(hand.place) : nullptr;
    hand.ease = action.energised && at_hand != nullptr ? at_hand->energy_factor : 1.0;
    if (hand.touch == BladeTouch::cutting && hand.adrift) {
        const bool lost = hand.place.fragment < 0;
        if (lost || drawn_out(action.tool, action.instrument->tip_radius, place(hand.place),
                              hand.side * hand.normal)) {
            leave(number, tick);
        } else {
            drift(number, tick);
        }
        return;
    }
    if (hand.touch == BladeTouch::cutting && hand.linked && at_hand != nullptr)
        hand.cut_friction = hand.ease * at_hand->dynamic_friction;
    blade_law::follow(hand, action.tool, action.instrument->tip_radius,
                      Follow{*this, hand, number, action, at_hand, tick});
}

void SheetPart::enter(int number, const Vector3& here, const Vector3& along, std::uint32_t tick) noexcept {
    HandState& hand = state_.hands[static_cast<std::size_t>(number)];
    hand.touch = BladeTouch::cutting;
    hand.way = begin_of_way(hand.place, here - overlap * along.normalized(), hand.side * hand.normal);
    hand.cut_friction = hand.ease * cutting_at(hand.place)->dynamic_friction;
    hand.linked = false;  // the blade is another link
    surface_.begin_stroke();
    begin_ends(number);
    add_place_event(tick, EventKind::cut_begin, number, hand.way);
}

void SheetPart::advance(int number, const Vector3& excess, std::uint32_t tick) noexcept {
    HandState& hand = state_.hands[static_cast<std::size_t>(number)];
    const Vector3 here = place(hand.place), way = excess.normalized();
    const double traction = traction_at(here, way, hand.normal);
    const BladeStep blade =
        make_step(here, excess, hand.normal, spec_.blade_width, surface_.fragment(hand.place.fragment).root);
    BladeTrack track;
    follow_track(blade, track);
    if (!meets_tissue(hand.place, track)) {
        hand.adrift = true;
        hand.drifted = blade.to;
        hand.linked = false;
        drift(number, tick);
        return;
    }
    const CutReport report = cut(blade);
    if (report.roll_backs > 0) add_event(tick, EventKind::cut_rolled_back, number, 0, report.roll_backs);
    if (report.outcome == CutOutcome::full || report.outcome == CutOutcome::invalid)
        faults_ = std::max(faults_, 1U);
    if (report.outcome != CutOutcome::cut && report.outcome != CutOutcome::nothing) return;
    const SheetPlace next = closest(blade.to + ahead * way);
    const bool gone = next.fragment < 0 || (place(next) - blade.to).norm() > off_by;
    if (report.outcome == CutOutcome::cut) report_track(number, track, traction, tick);
    if (gone) {
        leave(number, tick);
    } else {
        hand.place = next;
        if (const CuttingSpec* cutting = cutting_at(next))
            hand.cut_friction = hand.ease * cutting->dynamic_friction;
    }
}

// Between lips a blade is where the tool is, until its way comes upon tissue or leaves the slit.
void SheetPart::drift(int number, std::uint32_t tick) noexcept {
    HandState& hand = state_.hands[static_cast<std::size_t>(number)];
    BladeStep blade;
    blade.from = hand.drifted;
    blade.to = hand.target;
    blade.normal = hand.normal;
    blade.width = spec_.blade_width;
    blade.depth = blade_reach;
    BladeTrack track;
    follow_track(blade, track);
    std::size_t met = 1;
    while (met < track.count && !over_tissue(track.samples[met])) ++met;
    hand.adrift = met == track.count;
    const double share = hand.adrift ? 1.0 : static_cast<double>(met) / static_cast<double>(track.count - 1);
    hand.drifted = blade.from + share * (blade.to - blade.from);
    const SheetPlace next = closest(hand.drifted);
    if (next.fragment < 0 || (place(next) - hand.drifted).norm() > off_by) {
        leave(number, tick);
        return;
    }
    hand.place = next;
    if (const CuttingSpec* cutting = cutting_at(next))
        hand.cut_friction = hand.ease * cutting->dynamic_friction;
}

void SheetPart::report_cut(int number, const Vector3& reached, double traction, std::uint32_t tick) noexcept {
    HandState& hand = state_.hands[static_cast<std::size_t>(number)];
    const double length = (reached - hand.way).norm();
    mark_divided(hand.way, reached);
    move_ends(number, hand.way, reached);
    add_place_event(tick, EventKind::cut_advance, number, reached);
    add_event(tick, EventKind::cut_traction, number, traction, 1e6 * length, in_fat(reached));
    hand.way = reached;
}

// A blade's first step begins a little behind the place where it has entered.
Vector3 SheetPart::begin_of_way(const SheetPlace& where, const Vector3& behind,
                                const Vector3& normal) const noexcept {
    Vector3 entered = on_septum(where, rest(where));
    if (!behind.allFinite()) return entered;
    UnderBlade under;
    find_under(behind, normal, blade_reach, under);
    for (std::size_t k = 0; k < under.count; ++k) {
        const Vector3& first = under.layers[k].rest;
        if (septum_at(first) == septum_at(entered) && (first - entered).norm() <= slit) return first;
    }
    return entered;
}

// What lies under a blade before it is divided. Afterwards the nearest tissue may be the other lip, the rim
// that the blade has left, or the next septum.
void SheetPart::follow_track(const BladeStep& blade, BladeTrack& track) const noexcept {
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
        const SheetPlace there = closest(point);
        if (there.fragment < 0) continue;
        const Vector3 off = place(there) - point;
        const double along = std::abs(off.dot(blade.normal));
        const double beside = std::sqrt(std::max(0.0, off.squaredNorm() - along * along));
        if (along > blade.depth || beside > 0.5 * blade.width) continue;
        add_under(there, 0.5 * along / blade.depth, track.samples[i]);
        track.samples[i].beside = beside;
    }
}

// Not next to it, where a lip is.
bool SheetPart::over_tissue(const UnderBlade& sample) noexcept {
    return sample.count > 0 && sample.beside <= fresh_by;
}

// Whether a blade comes upon tissue before it. Its step begins a little behind it: where nothing is before
// it, only lips of its own cut would lose ground.
bool SheetPart::meets_tissue(const SheetPlace& from, const BladeTrack& track) const noexcept {
    const Vector3 here = rest(from);
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
const SheetPart::UnderBlade::Layer* SheetPart::divided_of(const UnderBlade& sample) const noexcept {
    const auto& roots = surface_.touched_roots();
    for (std::size_t k = 0; k < sample.count; ++k) {
        if (std::find(roots.begin(), roots.end(), sample.layers[k].root) != roots.end())
            return &sample.layers[k];
    }
    return nullptr;
}

// Whether what lies between two samples of a track is the tissue between them: of one triangle as it was made
// or of two that touch, or no farther than a slit is wide.
bool SheetPart::joined(const UnderBlade::Layer& a, const UnderBlade::Layer& b) const noexcept {
    if (septum_at(a.rest) != septum_at(b.rest)) return false;
    if ((a.rest - b.rest).norm() <= slit) return true;
    const Triangle &first = layout_.mesh.triangles[at(a.root)], &second = layout_.mesh.triangles[at(b.root)];
    return std::find_first_of(first.begin(), first.end(), second.begin(), second.end()) != first.end();
}

// A cut is reported where tissue was under the blade without a break; between two such paths it ends and
// begins.
void SheetPart::report_track(int number, const BladeTrack& track, double traction,
                             std::uint32_t tick) noexcept {
    HandState& hand = state_.hands[static_cast<std::size_t>(number)];
    const UnderBlade::Layer* last = nullptr;  // of the way that is open
    for (std::size_t i = 0; i < track.count; ++i) {
        const UnderBlade::Layer* here = divided_of(track.samples[i]);
        if (last != nullptr && (here == nullptr || !joined(*last, *here))) {
            if (last->rest != hand.way) report_cut(number, last->rest, traction, tick);
            last = nullptr;
        }
        if (here == nullptr) continue;
        // What was left between here and the end of the way before is the slit that the blade came in.
        if (last == nullptr &&
            (septum_at(hand.way) != septum_at(here->rest) || (here->rest - hand.way).norm() > slit)) {
            add_place_event(tick, EventKind::cut_end, number, hand.way);
            hand.way = here->rest;
            add_place_event(tick, EventKind::cut_begin, number, hand.way);
        }
        last = here;
    }
    if (last != nullptr && last->rest != hand.way) report_cut(number, last->rest, traction, tick);
}

const CuttingSpec* SheetPart::cutting_at(const SheetPlace& where) const noexcept {
    const TissueSpec& tissue = in_fat(rest(where)) ? fat_ : tissue_;
    return tissue.cutting ? &*tissue.cutting : nullptr;
}

// Lines lie end to end: what runs over the rim of one septum is not on the next.
Vector3 SheetPart::on_septum(const SheetPlace& where, Vector3 rest) const noexcept {
    if (!septa_ || where.fragment < 0) return rest;
    const double first = septum_of(where) * septa_->width;
    rest.x() = std::clamp(rest.x(), first + off_rim, first + septa_->width - off_rim);
    return rest;
}

// The muscularis of the rectum is not cut: a blade that would come to it is led along it.
Vector3 SheetPart::keep_off_wall(const SheetPlace& where, const Vector3& way) const noexcept {
    if (!septa_ || where.fragment < 0) return way;
    const std::int32_t root = surface_.fragment(where.fragment).root;
    const Triangle& corners = layout_.mesh.triangles[at(root)];
    const auto& nodes = state_.membrane.pieces[at(where.fragment)].nodes;
    const auto now = [&](std::size_t c) -> const Vector3& { return state_.membrane.positions[at(nodes[c])]; };
    const auto before = [&](std::size_t c) -> const Vector3& { return layout_.rest[at(corners[c])]; };
    // Height at rest as a function of the place now.
    const Vector3 u = now(1) - now(0), v = now(2) - now(0), n = u.cross(v);
    const double area = n.squaredNorm();
    if (!(area > 1e-30)) return Vector3::Zero();
    const Vector3 slope =
        ((before(1).y() - before(0).y()) * v.cross(n) + (before(2).y() - before(0).y()) * n.cross(u)) / area;
    const double rise = way.dot(slope),
                 most = septa_->fat_height - septa_->plane_height - off_wall - rest(where).y();
    if (rise <= most) return way;
    return way - (rise - std::max(0.0, most)) / slope.squaredNorm() * slope;
}

CutReport SheetPart::cut(const BladeStep& blade) noexcept {
    const CutReport report = surface_.cut(blade, state_.positions.data());
    if (report.outcome == CutOutcome::cut) {
        take_over();
        note_loose(tick_);
    }
    return report;
}

void SheetPart::remake_pieces() noexcept {
    cut_.clear();
    for (const std::int32_t root : surface_.touched_roots()) {
        cut_.roots.push_back(root);
        touched_[at(root)] = 1;
    }
    for (const std::int32_t root : surface_.touched_roots()) {
        for (std::int32_t f = root; f >= 0; f = surface_.fragment(f).next_of_root) {
            const CutFragment& row = surface_.fragment(f);
            if (row.triangles == 0) continue;
            MembranePiece piece;
            piece.slot = f;
            piece.root = root;
            piece.share = row.share;
            piece.from = f;
            while (state_.membrane.pieces[at(piece.from)].root < 0)
                piece.from = surface_.fragment(piece.from).from;
            if (piece.from != f) state_.loose[at(f)] = state_.loose[at(piece.from)];
            for (std::int32_t t = surface_.root(root).first_visible; t >= 0;
                 t = surface_.triangle(t).next_in_root) {
                if (surface_.fragment_of_triangle(t) != f) continue;
                for (const std::int32_t v : surface_.triangle(t).vertices) {
                    Vector3 b;
                    if (!barycentric_in(surface_.model(), surface_.vertex(v), root, b)) continue;
                    for (int c = 0; c < 3; ++c) {
                        if (b[c] == 1) piece.corners = static_cast<std::uint8_t>(piece.corners | 1 << c);
                    }
                }
            }
            FragmentContact contacts[32];
            const std::int32_t count = std::min(surface_.contacts_of(f, contacts, 32), 32);
            for (std::int32_t c = 0; c < count; ++c) {
                const FragmentContact& contact = contacts[c];
                if (!(contact.length_share > 0)) continue;
                piece.edges = static_cast<std::uint8_t>(piece.edges | 1 << contact.edge);
                if (contact.other < 0) continue;
                const bool both = touched_[at(surface_.fragment(contact.other).root)] != 0;
                if (both && contact.other < f) continue;  // named by the other
                cut_.contacts.push_back({f, contact.other, contact.edge, contact.length_share});
            }
            cut_.pieces.push_back(piece);
        }
    }
    for (const std::int32_t root : cut_.roots) touched_[at(root)] = 0;
}

void SheetPart::take_over() noexcept {
    // Where tips are, before their tissue changes.
    std::array<Vector3, hand_count> tips;
    for (std::size_t h = 0; h < hand_count; ++h) tips[h] = place(state_.hands[h].place);
    remake_pieces();
    if (!membrane_.part(state_.membrane, cut_, scratch_)) faults_ = 2;
    list_visible();
    const MeshAdjacency& adjacency = surface_.model().adjacency;
    for (const std::int32_t root : cut_.roots) {
        for (const std::int32_t corner : layout_.mesh.triangles[at(root)]) {
            for (const std::int32_t near : adjacency.triangles_of(corner)) {
                for (std::int32_t t = surface_.root(near).first_visible; t >= 0;
                     t = surface_.triangle(t).next_in_root) {
                    for (const std::int32_t v : surface_.triangle(t).vertices) bind(v);
                }
            }
        }
    }
    // A vertex that is gone hangs on nothing: what it hung on may be gone too.
    for (std::int32_t v = 0; v < surface_.vertex_count(); ++v) {
        if (surface_.vertex(v).triangle < 0) state_.bindings[at(v)] = SheetPlace();
    }
    update_positions();
    for (const std::int32_t root : cut_.roots) touched_[at(root)] = 1;
    const auto changed = [&](const SheetPlace& where) {
        return where.fragment >= 0 && touched_[at(surface_.fragment(where.fragment).root)] != 0;
    };
    for (std::size_t h = 0; h < hand_count; ++h) {
        HandState& hand = state_.hands[h];
        if (changed(hand.place)) {
            hand.place = closest(tips[h]);
            if ((place(hand.place) - tips[h]).norm() > off_by) hand.place = SheetPlace();
            hand.linked = hand.linked && hand.place.fragment >= 0;
        }
        // Jaws keep what is still between them.
        std::size_t kept = 0;
        for (std::size_t g = 0; kept < static_cast<std::size_t>(hand.jaws.count()); ++g) {
            SheetPlace held = hand.held_at[g];
            if (changed(held))
                held = find_in_root(surface_.fragment(held.fragment).root, held.barycentric, kept_slack);
            if (held.fragment >= 0) {
                hand.held_at[kept++] = held;
            } else {
                hand.jaws.drop_point(static_cast<int>(kept));
            }
        }
    }
    for (SheetPlace& point : state_.line) {
        if (!changed(point)) continue;
        const SheetPlace found = find_in_root(surface_.fragment(point.fragment).root, point.barycentric, 1e9);
        point.fragment = found.fragment;
        point.triangle = found.triangle;
    }
    for (const std::int32_t root : cut_.roots) touched_[at(root)] = 0;
}

void SheetPart::note_loose(std::uint32_t tick) noexcept {
    state_.any_loose = 0;
    bool fresh = false;
    for (std::int32_t f = 0; f < surface_.fragment_count(); ++f) {
        if (surface_.fragment(f).triangles == 0 || !state_.membrane.pieces[at(f)].isolated) continue;
        ++state_.any_loose;
        fresh = fresh || state_.loose[at(f)] == 0;
    }
    if (!fresh) return;
    const std::int32_t pieces = surface_.find_pieces();
    for (std::int32_t p = 0; p < pieces; ++p) {
        const CutPiece& piece = surface_.piece(p);
        const std::int32_t fragment = surface_.fragment_of_triangle(piece.first);
        if (piece.fixed || state_.loose[at(fragment)] != 0) continue;
        add_event(tick, EventKind::piece_fallen, -1, piece.area, 0);
    }
    for (const VisibleTriangle& t : visible_) {
        const std::int32_t fragment = surface_.fragment_of_triangle(t.number);
        if (state_.membrane.pieces[at(fragment)].isolated && state_.loose[at(fragment)] == 0)
            state_.loose[at(fragment)] = 1;
    }
}

void SheetPart::mark_divided(const Vector3& from, const Vector3& to) noexcept {
    Vector3 way = to - from;
    const double length = way.norm();
    if (!(length > 0)) return;
    const Vector3 begin = from - overlap / length * way, end = to + overlap / length * way;
    for (std::size_t i = 0; i < state_.divided.size(); ++i) {
        const double x = line_positions_[i];
        if ((begin.x() - x) * (end.x() - x) > 0 || begin.x() == end.x()) continue;
        const double y = begin.y() + (x - begin.x()) / (end.x() - begin.x()) * (end.y() - begin.y());
        if (std::abs(y) < line_reach) state_.divided[i] = 1;
    }
}

}  // namespace fulcrum
