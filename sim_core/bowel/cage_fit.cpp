// SPDX-License-Identifier: Apache-2.0
// Fitting the rings to the surface in the rest pose: push out to the surface, add the margin, check
// enclosure.
#include <algorithm>
#include <cmath>

#include "sim_core/bowel/cage.h"
#include "sim_core/geometry/closest_point.h"
#include "sim_core/numerics/functions.h"
#include "sim_core/numerics/input_error.h"

namespace fulcrum {
namespace {

constexpr double pi = 3.14159265358979323846;

[[noreturn]] void refuse(const std::string& wrong, const std::string& hint) {
    throw InputError("bowel surface", "", wrong, hint);
}

// Finds items whose x-range may overlap a given range, through equal slabs along the tube.
class Slabs {
  public:
    Slabs(double begin, double end, int count)
        : begin_(begin), width_((end - begin) / count), slabs_(static_cast<std::size_t>(count)) {}
    int slab_of(double x) const {
        return std::clamp(static_cast<int>((x - begin_) / width_), 0, static_cast<int>(slabs_.size()) - 1);
    }
    void add(double low, double high, std::int32_t item) {
        for (int i = slab_of(low); i <= slab_of(high); ++i)
            slabs_[static_cast<std::size_t>(i)].push_back(item);
    }
    template <typename Visit>
    void visit(double low, double high, Visit&& visit_item) const {
        for (int i = slab_of(low); i <= slab_of(high); ++i) {
            for (const auto item : slabs_[static_cast<std::size_t>(i)]) visit_item(item);
        }
    }

  private:
    double begin_, width_;
    std::vector<std::vector<std::int32_t>> slabs_;
};

// The cage in the rest pose as vertices and triangles.
struct RestCage {
    std::vector<Vector3> vertices;
    std::vector<Triangle> triangles;
    const Vector3& corner(const Triangle& triangle, std::size_t i) const {
        return vertices[static_cast<std::size_t>(triangle[i])];
    }
};

RestCage place(const Cage& cage) {
    std::vector<RingFrame> frames;
    for (const double s : cage.arc_lengths) frames.push_back(rest_frame(s));
    return {cage_vertices(cage, frames.data()), cage_triangles(cage.rings())};
}

struct Range {
    double low, high;
};

Range range_of(const Vector3& a, const Vector3& b, const Vector3& c) {
    return {std::min({a.x(), b.x(), c.x()}), std::max({a.x(), b.x(), c.x()})};
}

// Signed volume test: does the open segment pq cross triangle abc? Touching counts.
bool crosses(const Vector3& p, const Vector3& q, const Vector3& a, const Vector3& b, const Vector3& c) {
    const Vector3 normal = area_vector(a, b, c);
    const double above = normal.dot(p - a), below = normal.dot(q - a);
    if ((above > 0.0 && below > 0.0) || (above < 0.0 && below < 0.0)) return false;
    const Vector3 along = q - p;
    const double u = along.dot((a - p).cross(b - p)), v = along.dot((b - p).cross(c - p)),
                 w = along.dot((c - p).cross(a - p));
    return (u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0);
}

// Farthest intersection of the surface with the ray from the axis at x in direction (cos, sin) of the y, z
// plane; negative if there is none.
double farthest_hit(const TriangleMesh& surface, const Slabs& slabs, double x, double cosine, double sine) {
    const Vector3 origin(x, 0.0, 0.0), direction(0.0, cosine, sine);
    double farthest = -1.0;
    slabs.visit(x, x, [&](std::int32_t t) {
        const Triangle& triangle = surface.triangles[static_cast<std::size_t>(t)];
        const Vector3 &a = surface.vertices[static_cast<std::size_t>(triangle[0])],
                      &b = surface.vertices[static_cast<std::size_t>(triangle[1])],
                      &c = surface.vertices[static_cast<std::size_t>(triangle[2])];
        const Vector3 normal = area_vector(a, b, c);
        const double slope = normal.dot(direction);
        if (slope == 0.0) return;
        const double distance = normal.dot(a - origin) / slope;
        if (distance <= farthest) return;
        const double u = direction.dot((a - origin).cross(b - origin)),
                     v = direction.dot((b - origin).cross(c - origin)),
                     w = direction.dot((c - origin).cross(a - origin));
        if ((u >= 0.0 && v >= 0.0 && w >= 0.0) || (u <= 0.0 && v <= 0.0 && w <= 0.0)) farthest = distance;
    });
    return farthest;
}

// Radius at which the ray from the axis through the point leaves the cage triangle; negative if it misses.
double leaving_radius(const Vector3& point, double radius, const Vector3& a, const Vector3& b,
                      const Vector3& c) {
    const Vector3 origin(point.x(), 0.0, 0.0);
    const Vector3 direction(0.0, point.y() / radius, point.z() / radius);
    const double u = direction.dot((a - origin).cross(b - origin)),
                 v = direction.dot((b - origin).cross(c - origin)),
                 w = direction.dot((c - origin).cross(a - origin));
    constexpr double slack = -1e-15;  // a ray through a shared edge must meet one of its triangles
    if (u < slack || v < slack || w < slack) return -1.0;
    const Vector3 normal = area_vector(a, b, c);
    const double slope = normal.dot(direction);
    return slope > 0.0 ? normal.dot(a - origin) / slope : -1.0;
}

void scale_corner(Cage& cage, RestCage& rest, std::int32_t vertex, double factor) {
    const auto v = static_cast<std::size_t>(vertex);
    Vector3& x = cage.templates[v / ring_size][v % ring_size];
    x.x() *= factor;
    x.y() *= factor;
    rest.vertices[v].y() *= factor;
    rest.vertices[v].z() *= factor;
}

// Scales cage triangles outward about the axis until each surface vertex has the required gap along its ray.
// Scaling a triangle's corners by f scales its own hit radius by f and moves no other triangle's hit inward,
// so one pass is enough.
void push_past_vertices(const TriangleMesh& surface, double gap, Cage& cage, RestCage& rest) {
    const int per_gap = 2 * ring_size;
    for (const auto& vertex : surface.vertices) {
        const double radius = std::hypot(vertex.y(), vertex.z());
        if (radius <= 0.0) continue;
        int j = 0;
        while (j + 2 < cage.rings() &&
               rest.vertices[static_cast<std::size_t>((j + 1) * ring_size)].x() <= vertex.x())
            ++j;
        for (int t = j * per_gap; t < (j + 1) * per_gap; ++t) {
            const Triangle& triangle = rest.triangles[static_cast<std::size_t>(t)];
            const double leaves = leaving_radius(vertex, radius, rest.corner(triangle, 0),
                                                 rest.corner(triangle, 1), rest.corner(triangle, 2));
            if (leaves < 0.0 || leaves >= radius + gap) continue;
            for (const auto corner : triangle) scale_corner(cage, rest, corner, (radius + gap) / leaves);
        }
    }
}

// Finds cage triangles that intersect an edge of the surface, or whose edge intersects the surface, and
// scales them outward.
int push_past_edges(const TriangleMesh& surface, const Slabs& slabs, Cage& cage, RestCage& rest) {
    int pushed = 0;
    const auto tube_triangles = static_cast<std::size_t>(2 * ring_size * (cage.rings() - 1));
    for (std::size_t t = 0; t < rest.triangles.size(); ++t) {
        const Triangle triangle = rest.triangles[t];
        const Vector3 &a = rest.corner(triangle, 0), &b = rest.corner(triangle, 1),
                      &c = rest.corner(triangle, 2);
        const Range range = range_of(a, b, c);
        bool hit = false;
        slabs.visit(range.low, range.high, [&](std::int32_t s) {
            if (hit) return;
            const Triangle& other = surface.triangles[static_cast<std::size_t>(s)];
            const Vector3 &p = surface.vertices[static_cast<std::size_t>(other[0])],
                          &q = surface.vertices[static_cast<std::size_t>(other[1])],
                          &r = surface.vertices[static_cast<std::size_t>(other[2])];
            const Vector3 normal = area_vector(a, b, c);
            // The usual case: the whole surface triangle lies behind the cage triangle's plane.
            if (normal.dot(p - a) < 0.0 && normal.dot(q - a) < 0.0 && normal.dot(r - a) < 0.0) return;
            hit = crosses(p, q, a, b, c) || crosses(q, r, a, b, c) || crosses(r, p, a, b, c) ||
                  crosses(a, b, p, q, r) || crosses(b, c, p, q, r) || crosses(c, a, p, q, r);
        });
        if (!hit) continue;
        ++pushed;
        if (t >= tube_triangles)
            refuse("the surface passes through an end of its cage", "end the tube within its length");
        for (const auto corner : triangle) scale_corner(cage, rest, corner, 1.02);
    }
    return pushed;
}

double least_distance(const TriangleMesh& surface, const RestCage& rest, double reach) {
    const auto [low, high] =
        std::minmax_element(rest.vertices.begin(), rest.vertices.end(),
                            [](const Vector3& p, const Vector3& q) { return p.x() < q.x(); });
    Slabs slabs(low->x(), high->x() + 1e-9, static_cast<int>(rest.triangles.size() / (2 * ring_size)) + 1);
    for (std::size_t t = 0; t < rest.triangles.size(); ++t) {
        const Range range = range_of(rest.corner(rest.triangles[t], 0), rest.corner(rest.triangles[t], 1),
                                     rest.corner(rest.triangles[t], 2));
        slabs.add(range.low, range.high, static_cast<std::int32_t>(t));
    }
    double least = reach;
    for (const auto& vertex : surface.vertices) {
        slabs.visit(vertex.x() - least, vertex.x() + least, [&](std::int32_t t) {
            const Triangle& triangle = rest.triangles[static_cast<std::size_t>(t)];
            const Vector3& a = rest.corner(triangle, 0);
            const Vector3 normal =
                area_vector(a, rest.corner(triangle, 1), rest.corner(triangle, 2)).normalized();
            if (std::abs(normal.dot(vertex - a)) >= least)
                return;  // farther from the plane implies farther from the triangle
            const Vector3 closest =
                closest_point_on_triangle(vertex, a, rest.corner(triangle, 1), rest.corner(triangle, 2))
                    .position;
            least = std::min(least, (closest - vertex).norm());
        });
    }
    return least;
}

void check_surface(const TriangleMesh& surface, double length) {
    const MeshReport report = check_mesh(surface);
    if (!report.watertight())
        refuse(report.complaint(), "give a closed surface, counterclockwise seen from outside");
    if (report.volume <= 0.0)
        refuse("the surface is inside out", "reverse the order of each triangle's vertices");
    double low = surface.vertices[0].x(), high = low;
    for (const auto& vertex : surface.vertices) {
        low = std::min(low, vertex.x());
        high = std::max(high, vertex.x());
    }
    const double slack = 0.25 * length;
    if (low < -slack || high > length + slack || high - low < 0.5 * length) {
        refuse("the surface does not extend along +x from 0 to the bowel's length",
               "give the straight tube in metres");
    }
}

}  // namespace

Cage build_cage(const TriangleMesh& surface, double length, const SphereChain& spheres,
                const CageOptions& options) {
    check_surface(surface, length);
    double low = 0.0, high = length, widest = 0.0;
    for (const auto& vertex : surface.vertices) {
        low = std::min(low, vertex.x());
        high = std::max(high, vertex.x());
        widest = std::max(widest, std::hypot(vertex.y(), vertex.z()));
    }
    const std::size_t rings = 2 * spheres.arc_lengths.size() - 1;
    Slabs slabs(low, high, static_cast<int>(rings));
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const Triangle& triangle = surface.triangles[t];
        const Range range = range_of(surface.vertices[static_cast<std::size_t>(triangle[0])],
                                     surface.vertices[static_cast<std::size_t>(triangle[1])],
                                     surface.vertices[static_cast<std::size_t>(triangle[2])]);
        slabs.add(range.low, range.high, static_cast<std::int32_t>(t));
    }

    Cage cage;
    cage.length = length;
    // The edges of a regular octagon are at cos(pi/8) of its corner radius: this factor compensates for it.
    const double corner_factor = 1.0 / math::cos(pi / ring_size);
    for (std::size_t r = 0; r < rings; ++r) {
        const std::size_t i = r / 2;
        const bool on_sphere = r % 2 == 0;
        const double s =
            on_sphere ? spheres.arc_lengths[i] : 0.5 * (spheres.arc_lengths[i] + spheres.arc_lengths[i + 1]);
        const double sphere = on_sphere ? spheres.radii[i] : 0.5 * (spheres.radii[i] + spheres.radii[i + 1]);
        // The end rings stand off along the tube, in the direction of its cap normals.
        const double along =
            r == 0 ? low - options.margin - s : (r + 1 == rings ? high + options.margin - s : 0.0);
        std::array<Vector3, ring_size> ring;
        for (int k = 0; k < ring_size; ++k) {
            double sine = 0.0, cosine = 1.0;
            math::sin_cos(2.0 * pi * k / ring_size, sine, cosine);
            const double hit = farthest_hit(surface, slabs, s, cosine, sine);
            const double radius = (hit > 0.0 ? hit : sphere) * corner_factor + options.margin;
            ring[static_cast<std::size_t>(k)] = Vector3(radius * cosine, radius * sine, along);
        }
        cage.arc_lengths.push_back(s);
        cage.templates.push_back(ring);
    }

    RestCage rest = place(cage);
    // Measured along the ray the gap is slightly larger than the distance to the cage's slanted faces.
    push_past_vertices(surface, 1.2 * options.margin, cage, rest);
    rest = place(cage);
    constexpr int most_passes = 40;
    for (int pass = 0; push_past_edges(surface, slabs, cage, rest) > 0; ++pass) {
        if (pass == most_passes)
            refuse("no cage of rings encloses the surface", "give a tube that is star-shaped about its axis");
        rest = place(cage);
    }
    cage.clearance = least_distance(surface, rest, widest);
    return cage;
}

}  // namespace fulcrum
