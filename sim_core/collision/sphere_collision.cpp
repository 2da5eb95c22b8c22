// SPDX-License-Identifier: Apache-2.0
#include "sim_core/collision/sphere_collision.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

constexpr double no_move = 1e-8;       // m: shallower overlaps are solver rounding and are not projected
constexpr double everywhere = 1e6;     // m
constexpr double on_time = 0.9;        // fraction of the list margin by which every sphere has been relisted
constexpr double too_early = 0.1;      // fraction below which a scheduled sphere is skipped
constexpr int direct_capacity = 4096;  // maximum number of packets found by one listing

std::size_t index(int i) {
    return static_cast<std::size_t>(i);
}

// Limits the margins so that a sphere cannot pass through the wall while its list is valid.
SphereCollisionOptions within_radii(SphereCollisionOptions options, const std::vector<double>& radii) {
    for (const double radius : radii) {
        if (radius > 0) options.list_margin = std::min(options.list_margin, 0.5 * radius);
    }
    return options;
}

// True if a centre can be looked up: finite, also in single precision.
bool usable(const Vector3& centre) {
    return centre.allFinite() && centre.cwiseAbs().maxCoeff() < everywhere;
}

}  // namespace

SphereCollision::SphereCollision(const CavityModel* cavity, SphereChainShape chain,
                                 SphereCollisionOptions options)
    : cavity_(cavity),
      chain_(std::move(chain)),
      options_(within_radii(options, chain_.radii)),
      pairs_(chain_.arc_lengths, chain_.radii, options_.rest_exclusion, options_.list_margin,
             options_.contact_margin, options_.near_row_capacity) {
    if (chain_.radii.size() != chain_.arc_lengths.size()) {
        throw InputError("sphere chain", "radii",
                         "the number of radii differs from the number of arc lengths",
                         "give one radius and one arc length per sphere");
    }
    for (std::size_t i = 0; i < chain_.radii.size(); ++i) {
        if (!(chain_.radii[i] > 0) || !std::isfinite(chain_.radii[i]) ||
            !std::isfinite(chain_.arc_lengths[i])) {
            throw InputError("sphere chain", std::to_string(i),
                             "a radius is not positive or a value is not finite",
                             "give radii in metres, above 0");
        }
    }
}

SphereContacts SphereCollision::make_contacts() const {
    SphereContacts contacts;
    if (cavity_ != nullptr) contacts.cavity.resize(index(spheres()) * index(options_.planes_per_sphere));
    contacts.pairs.resize(index(options_.pair_capacity));
    return contacts;
}

SphereCollision::Lists SphereCollision::make_lists() const {
    Lists lists;
    const std::size_t count = index(spheres());
    if (cavity_ != nullptr) {
        lists.packets.resize(count * index(options_.list_capacity));
        lists.band_ends.resize(count * index(bands));
        lists.band.assign(count, 1.0);
        lists.direct.resize(direct_capacity);
        lists.counts.assign(count, never_listed);
        lists.listed_at.assign(count, Vector3::Zero());
        lists.free_motion.assign(count, 0);
        lists.last_at.assign(count, Vector3::Zero());
    }
    lists.pairs = pairs_.make_lists();
    lists.projected.assign(count, Vector3::Zero());
    lists.moved.assign(count, 0);
    lists.depth.assign(count, 0);
    return lists;
}

std::size_t SphereCollision::bytes() const {
    const std::size_t count = index(spheres());
    const std::size_t a_sphere =
        index(options_.list_capacity + bands) * sizeof(std::int32_t) + 3 * sizeof(Vector3) +
        index(options_.planes_per_sphere) * sizeof(CavityContact) + 6 * sizeof(double);
    return sizeof(*this) + count * a_sphere + pairs_.bytes() +
           index(options_.pair_capacity) * sizeof(SphereContact);
}

// Stores the result of a listing in the sphere's list, in bands of sleep distance. If there are too many, the
// free motion of the sphere ends before the first dropped packet could wake.
void SphereCollision::bin(int sphere, int count, Lists& lists) const {
    const std::size_t i = index(sphere);
    const int capacity = options_.list_capacity;
    ListedPacket* found = lists.direct.data();
    if (count > capacity) {
        std::nth_element(found, found + capacity, found + count,
                         [](const ListedPacket& a, const ListedPacket& b) { return a.sleep < b.sleep; });
        lists.free_motion[i] = std::min(lists.free_motion[i], static_cast<double>(found[capacity].sleep));
        count = capacity;
        if (!(lists.free_motion[i] > 0)) {
            lists.counts[i] = overflowed;
            return;
        }
    }
    lists.counts[i] = count;
    lists.band[i] = std::max(lists.free_motion[i], 1e-9) / bands;
    const auto per_width = static_cast<float>(1.0 / lists.band[i]);
    std::int32_t* ends = lists.band_ends.data() + i * index(bands);
    std::int32_t* packets = lists.packets.data() + i * index(capacity);
    // Rounded down: a packet may wake early, never late.
    const auto band_of = [&](float sleep) {
        return std::clamp(static_cast<int>(sleep * per_width * (1 - 1e-5F)), 0, bands - 1);
    };
    std::fill(ends, ends + bands, 0);
    for (int k = 0; k < count; ++k) ++ends[band_of(found[k].sleep)];
    for (int b = 1; b < bands; ++b) ends[b] += ends[b - 1];
    for (int k = count - 1; k >= 0; --k) packets[--ends[band_of(found[k].sleep)]] = found[k].packet;
    // Filling advanced every end to the next band's start.
    for (int b = 0; b + 1 < bands; ++b) ends[b] = ends[b + 1];
    ends[bands - 1] = count;
}

// Relists a sphere from the hierarchy if it has moved further than the given fraction of its list's validity
// range.
bool SphereCollision::refresh(int sphere, const Vector3& centre, Lists& lists, double good_for) const {
    const std::size_t i = index(sphere);
    const double motion2 = (centre - lists.listed_at[i]).squaredNorm();
    const double free = good_for * lists.free_motion[i];
    if (lists.counts[i] != never_listed && motion2 < free * free) return false;
    // In front of the wall at the last listing and moved by less than the radius since: if it is behind the
    // wall now, it is near enough for gather() to detect it. (Without packets and without free motion it was
    // far behind.)
    const bool known_in_front =
        lists.counts[i] >= 0 && lists.free_motion[i] > 0 && motion2 < chain_.radii[i] * chain_.radii[i];
    const double reach = chain_.radii[i] + options_.contact_margin;
    lists.listed_at[i] = centre;
    lists.free_motion[i] = options_.list_margin;
    // If the wall is too fine for the work space, the margin is reduced.
    int boxes = 0, count = 0;
    for (double margin = options_.list_margin;; margin *= 0.5) {
        lists.free_motion[i] = margin;
        count = cavity_->list(centre, reach, margin, lists.direct.data(), direct_capacity, boxes);
        lists.counts_so_far.listed += static_cast<std::uint64_t>(boxes);
        if (count <= direct_capacity) break;
        if (margin < 1e-5) {
            lists.counts[i] = overflowed;
            lists.free_motion[i] = 0;
            return true;
        }
    }
    if (boxes == 0) {
        // Far from the wall: free until it could come near. Far behind the wall: queried at every step.
        const CavityPoint wall = cavity_->closest(centre, everywhere);
        lists.counts[i] = 0;
        lists.band[i] = everywhere;
        std::fill_n(lists.band_ends.begin() + static_cast<std::ptrdiff_t>(i) * bands, bands, 0);
        lists.free_motion[i] = std::max(0.0, wall.distance - reach);
        return true;
    }
    // A sphere listed in front of the wall stays within reach of the wall while its list is valid. Behind the
    // wall it may be anywhere, and only the path back matters.
    if (!known_in_front && cavity_->closest(centre, everywhere).distance < 0) {
        lists.counts[i] = behind_wall;
        lists.free_motion[i] = 0;
        return true;
    }
    bin(sphere, count, lists);
    return true;
}

// Relists spheres in rotation before they must be, as many per step as their motion requires; otherwise a
// chain that moves as a rigid body would be relisted in a single step.
int SphereCollision::refresh_early(const Vector3* centres, Lists& lists) const {
    double sum2 = 0;
    for (int i = 0; i < spheres(); ++i) {
        const double motion2 = (centres[i] - lists.last_at[index(i)]).squaredNorm();
        if (std::isfinite(motion2)) sum2 += motion2;
        lists.last_at[index(i)] = centres[i];
    }
    const double turns =
        std::sqrt(sum2 / std::max(1, spheres())) / (on_time * std::max(options_.list_margin, 1e-9));
    if (!(turns < 1)) return 0;  // motion too fast for coherence
    const auto quota = static_cast<int>(std::ceil(turns * spheres()));
    int relisted = 0;
    for (int k = 0; k < spheres() && relisted < quota; ++k) {
        const int i = lists.turn;
        lists.turn = i + 1 < spheres() ? i + 1 : 0;
        if (!usable(centres[i]) || !(lists.free_motion[index(i)] > 0)) continue;
        relisted += refresh(i, centres[i], lists, too_early) ? 1 : 0;
    }
    return relisted;
}

// All patches of the wall within the radius and the contact margin, nearest first; only the nearest if
// only_nearest is set.
void SphereCollision::gather(int sphere, const Vector3& centre, Lists& lists, bool only_nearest,
                             Candidates& found) const {
    const std::size_t i = index(sphere);
    found.count = 0;
    found.overflow = false;
    const double reach = chain_.radii[i] + options_.contact_margin;
    const double reach2 = reach * reach;
    int count = lists.counts[i];
    if (count == overflowed) {
        // Without a valid list it queries the hierarchy.
        int boxes = 0;
        count = cavity_->list(centre, reach, 0.0, lists.direct.data(), direct_capacity, boxes);
        found.overflow = count > direct_capacity;
    } else if (count == behind_wall || (count == 0 && !(lists.free_motion[i] > 0))) {
        // Behind the wall: find the exit only.
        const CavityPoint wall = cavity_->closest(centre, everywhere);
        if (wall.triangle >= 0 && wall.distance < reach) found.points[found.count++] = wall;
        return;
    } else {
        const double drift = (centre - lists.listed_at[i]).norm();
        const int band = std::min(static_cast<int>(drift / lists.band[i]), bands - 1);
        count = lists.band_ends[i * index(bands) + index(band)];
    }
    CavityPoint nearest;
    double nearest2 = std::numeric_limits<double>::infinity();
    const FloatPoint at(centre);
    const bool direct = lists.counts[i] == overflowed;
    const std::int32_t* packets = lists.packets.data() + i * index(options_.list_capacity);
    for (int k = 0; k < std::min(count, direct_capacity); ++k) {
        ++lists.counts_so_far.packets;
        const TrianglePacket& packet = cavity_->packet(direct ? lists.direct[index(k)].packet : packets[k]);
        float concern[packet_size];
        for_each_lane(packet.concern(at, static_cast<float>(reach), 0.0F, concern), [&](int lane) {
            if (!cavity_->confirms(packet, lane, at)) return;
            ++lists.counts_so_far.triangles;
            if (only_nearest) {
                const CavityTriangle& t =
                    cavity_->triangles()[static_cast<std::size_t>(packet.triangle[lane])];
                const double distance2 =
                    (centre - closest_point_on_triangle(centre, t.a, t.b, t.c).position).squaredNorm();
                if (!(distance2 <= reach2)) return;
                if (distance2 < nearest2 ||
                    (distance2 <= nearest2 && packet.triangle[lane] < nearest.triangle)) {
                    nearest2 = distance2;
                    nearest.triangle = packet.triangle[lane];
                }
                return;
            }
            CavityPoint point;
            bool own_patch = false;
            if (!cavity_->examine(packet.triangle[lane], centre, reach2, point, own_patch)) return;
            const double distance2 = point.distance * point.distance;
            if (distance2 < nearest2 || (distance2 <= nearest2 && point.triangle < nearest.triangle)) {
                nearest2 = distance2;
                nearest = point;
            }
            if (!own_patch || point.distance < 0) return;
            if (found.count == candidate_capacity) {
                found.overflow = true;
                return;
            }
            found.points[found.count++] = point;
        });
    }
    if (nearest.triangle < 0) return;
    if (only_nearest) {
        found.points[found.count++] = cavity_->closest_on(nearest.triangle, centre);
        return;
    }
    if (nearest.distance < 0) found.count = 0;  // behind the wall only the exit matters
    if (found.count == candidate_capacity) --found.count;
    found.points[found.count++] = nearest;
    keep_distinct(found);
}

// Sorts by distance and merges patches that face the same way. Independent of the order of the list.
void SphereCollision::keep_distinct(Candidates& found) const {
    std::sort(found.points, found.points + found.count, [](const CavityPoint& a, const CavityPoint& b) {
        return a.distance < b.distance || (a.distance <= b.distance && a.triangle < b.triangle);
    });
    int kept = 0;
    for (int i = 0; i < found.count; ++i) {
        bool distinct = true;
        for (int k = 0; k < kept && distinct; ++k) {
            distinct = found.points[i].normal.dot(found.points[k].normal) < options_.distinct_cosine;
        }
        if (distinct) found.points[kept++] = found.points[i];
    }
    found.count = kept;
}

int SphereCollision::depths(const Vector3* centres, Lists& lists, SphereDepth* results) const {
    int relisted = cavity_ != nullptr ? refresh_early(centres, lists) : 0;
    Candidates found;
    for (int i = 0; i < spheres(); ++i) {
        results[i] = SphereDepth{};
        if (cavity_ == nullptr || !usable(centres[i])) continue;
        relisted += refresh(i, centres[i], lists) ? 1 : 0;
        gather(i, centres[i], lists, true, found);
        if (found.count == 0) continue;
        results[i].closest = found.points[0];
        results[i].depth = chain_.radii[index(i)] - found.points[0].distance;
    }
    return relisted;
}

// Adds a sphere's patches as planes, with the gap at the start; only_new skips planes that it already has.
void SphereCollision::add_planes(int sphere, const Vector3& start, const Candidates& found, bool only_new,
                                 SphereContacts& contacts) const {
    if (found.overflow) contacts.plane_overflow = true;
    for (int k = 0; k < found.count; ++k) {
        const CavityPoint& wall = found.points[k];
        int planes = 0;
        bool known = false;
        for (int c = 0; c < contacts.cavity_count && only_new; ++c) {
            const CavityContact& other = contacts.cavity[index(c)];
            if (other.sphere != sphere) continue;
            ++planes;
            known = known || other.normal.dot(wall.normal) >= options_.distinct_cosine;
        }
        if (known) continue;
        if (!only_new) planes = k;
        if (planes >= options_.planes_per_sphere) {
            contacts.plane_overflow = true;
            return;
        }
        CavityContact& contact = contacts.cavity[index(contacts.cavity_count++)];
        contact.sphere = sphere;
        contact.triangle = wall.triangle;
        contact.normal = wall.normal;
        contact.point = wall.position;
        contact.gap = wall.normal.dot(start - wall.position) - chain_.radii[index(sphere)];
    }
}

void SphereCollision::touching_pairs(const Vector3* centres, Lists& lists, SphereContacts& contacts) const {
    const int count = pairs_.find(centres, lists.pairs, contacts.pairs.data(), options_.pair_capacity,
                                  contacts.deepest_pair);
    contacts.pair_count = std::min(count, options_.pair_capacity);
    contacts.pair_overflow = lists.pairs.overflow || count > options_.pair_capacity;
}

// Moves overlapping spheres out along the planes' normals for a few iterations; also reports new planes
// encountered during the motion.
void SphereCollision::project(Lists& lists, SphereContacts& contacts, const Vector3* centres) const {
    Candidates found;
    for (int iteration = 0; iteration < options_.projection_iterations; ++iteration) {
        bool any = false;
        for (int c = 0; c < contacts.cavity_count; ++c) {
            const CavityContact& contact = contacts.cavity[index(c)];
            Vector3& centre = lists.projected[index(contact.sphere)];
            const double gap =
                contact.normal.dot(centre - contact.point) - chain_.radii[index(contact.sphere)];
            if (gap >= -no_move) continue;
            centre -= gap * contact.normal;
            lists.moved[index(contact.sphere)] = 1;
            any = true;
        }
        for (int k = 0; k < contacts.pair_count; ++k) {
            const SphereContact& contact = contacts.pairs[index(k)];
            if (contact.gap >= 0 &&
                lists.moved[index(contact.first)] + lists.moved[index(contact.second)] == 0)
                continue;  // already separated
            Vector3& first = lists.projected[index(contact.first)];
            Vector3& second = lists.projected[index(contact.second)];
            const Vector3 between = first - second;
            const double distance2 = between.squaredNorm();
            const double reach = chain_.radii[index(contact.first)] + chain_.radii[index(contact.second)];
            if (!(distance2 < reach * reach)) continue;
            const double distance = std::sqrt(distance2), overlap = reach - distance;
            if (overlap <= no_move) continue;
            const Vector3 normal = distance > 1e-12 ? Vector3(between / distance) : contact.normal;
            first += 0.5 * overlap * normal;
            second -= 0.5 * overlap * normal;
            lists.moved[index(contact.first)] = lists.moved[index(contact.second)] = 1;
            any = true;
        }
        if (!any) break;
        for (int i = 0; i < spheres() && cavity_ != nullptr; ++i) {
            if (lists.moved[index(i)] == 0) continue;
            const Vector3& centre = lists.projected[index(i)];
            contacts.relisted += refresh(i, centre, lists) ? 1 : 0;
            gather(i, centre, lists, false, found);
            lists.depth[index(i)] = found.count > 0 ? chain_.radii[index(i)] - found.points[0].distance : 0;
            add_planes(i, centres[i], found, true, contacts);
        }
    }
}

void SphereCollision::collide(const Vector3* centres, Lists& lists, SphereContacts& contacts) const {
    contacts.cavity_count = contacts.pair_count = contacts.relisted = 0;
    contacts.deepest_cavity = contacts.deepest_pair = contacts.residual_cavity = contacts.residual_pair = 0;
    contacts.list_overflow = contacts.plane_overflow = contacts.pair_overflow = false;
    if (cavity_ != nullptr) contacts.relisted = refresh_early(centres, lists);
    Candidates found;
    for (int i = 0; i < spheres(); ++i) {
        lists.projected[index(i)] = centres[i];
        lists.moved[index(i)] = 0;
        lists.depth[index(i)] = 0;
        if (cavity_ == nullptr || !usable(centres[i])) continue;
        contacts.relisted += refresh(i, centres[i], lists) ? 1 : 0;
        contacts.list_overflow = contacts.list_overflow || lists.counts[index(i)] == overflowed;
        gather(i, centres[i], lists, false, found);
        if (found.count > 0) lists.depth[index(i)] = chain_.radii[index(i)] - found.points[0].distance;
        contacts.deepest_cavity = std::max(contacts.deepest_cavity, lists.depth[index(i)]);
        add_planes(i, centres[i], found, false, contacts);
    }
    touching_pairs(centres, lists, contacts);
    project(lists, contacts, centres);
    for (const double depth : lists.depth)
        contacts.residual_cavity = std::max(contacts.residual_cavity, depth);
    for (int k = 0; k < contacts.pair_count; ++k) {
        const SphereContact& contact = contacts.pairs[index(k)];
        const double distance2 =
            (lists.projected[index(contact.first)] - lists.projected[index(contact.second)]).squaredNorm();
        const double reach = chain_.radii[index(contact.first)] + chain_.radii[index(contact.second)];
        if (!(distance2 < reach * reach)) continue;
        contacts.residual_pair = std::max(contacts.residual_pair, reach - std::sqrt(distance2));
    }
    std::sort(contacts.cavity.begin(), contacts.cavity.begin() + contacts.cavity_count,
              [](const CavityContact& a, const CavityContact& b) {
                  if (a.sphere != b.sphere) return a.sphere < b.sphere;
                  return a.gap < b.gap || (a.gap <= b.gap && a.triangle < b.triangle);
              });
}

}  // namespace fulcrum
