// SPDX-License-Identifier: Apache-2.0
// A membrane that can be cut (docs/THEORY.md, sections 3 and 5): nodes, springs and masses are part of the
// state.
//
// Virtual nodes: every piece that a cut leaves of a root triangle keeps a copy of the root's three nodes;
// copies of pieces that still meet along an edge are one node. A piece of area share a has a times the root's
// mass and a times its part of each spring; a spring across an edge has the share of the edge along which
// both sides still meet. So a cut can only lower the stored energy, moves nothing and changes no velocity,
// and no frequency rises above safe_frequency() however thin a sliver: stiffness and mass shrink together,
// element by element.
//
// Symplectic Euler, with substeps as safe_frequency() requires. Model (const) / state (copyable) / scratch
// (one per thread). part and step do not allocate, lock or throw, and give the same output bits for the same
// input bits. SI units; patient frame.
#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "sim_core/geometry/mesh.h"
#include "sim_core/membrane/membrane.h"
#include "sim_core/membrane/springs.h"
#include "sim_core/numerics/lanes.h"

namespace fulcrum {

/// A piece of a root triangle after a cut.
struct MembranePiece {
    std::int32_t slot = -1;  ///< its number, chosen by the caller: free, or that of a piece of a touched root
    std::int32_t root = -1;
    std::int32_t from = -1;    ///< piece of this root that it was part of before the cut
    double share = 0;          ///< of the root's area, above 0
    std::uint8_t corners = 0;  ///< bit c: it contains the root's corner c
    std::uint8_t edges = 0;    ///< bit e: it contains a part of root edge e (corner e to e + 1)
};

/// Contact of two pieces along an edge of two roots.
struct PieceContact {
    std::int32_t first = -1, second = -1;  ///< pieces
    std::int32_t edge = -1;                ///< root edge of the first's root: 0, 1, 2
    double share = 0;                      ///< of the edge's length
};

/// Result of a cut for the springs. It lists every present piece of a touched root, and every contact along
/// an edge of one, once.
struct MembraneCut {
    std::vector<std::int32_t> roots;  ///< touched, each once
    std::vector<MembranePiece> pieces;
    std::vector<PieceContact> contacts;
    void clear() {
        roots.clear();
        pieces.clear();
        contacts.clear();
    }
};

/// Complete state of a membrane that can be cut. Copyable; copies of the same capacity do not allocate.
struct CutMembraneState {
    struct Piece {
        std::int32_t root = -1;  ///< -1: the slot is free
        std::int32_t next = -1;  ///< next piece of the same root
        double share = 0;
        std::array<std::int32_t, 3> nodes = {-1, -1, -1};
        std::uint8_t corners = 0, edges = 0;
        bool isolated = false;  ///< no path to any attachment
    };
    struct Contact {
        std::int32_t next = -1, first = -1, second = -1;  ///< first: of the edge's first root
        double share = 0;
    };
    std::vector<Vector3> positions, velocities;  ///< m, m/s, by node
    std::vector<double> masses;                  ///< kg; 0: the node is not in use
    std::vector<std::int32_t> vertex;            ///< mesh vertex that it is a copy of; -1 not in use
    std::vector<std::uint8_t> held;              ///< 1: the node keeps the vertex's attachment
    std::vector<std::uint8_t> isolated;
    std::vector<Piece> pieces;
    std::vector<std::int32_t> first_piece;  ///< by root, -1 none
    std::vector<Contact> contacts;
    std::vector<std::int32_t> first_contact;  ///< by root edge of the mesh
    // Springs by slot; an unused one has no stiffness.
    std::vector<std::int32_t> first, second, next_spring;
    std::vector<double> stiffness, rest;
    std::vector<std::int32_t> first_spring;  ///< by spring of the uncut sheet
    std::int32_t spring_end = 0;             ///< slots from this one on were never used; a multiple of four
    // Free slots, taken from the end.
    std::vector<std::int32_t> free_nodes, free_contacts, free_springs;
    std::int32_t free_node_count = 0, free_contact_count = 0, free_spring_count = 0;
    std::uint32_t topology = 0;
    double removed_mass = 0;      ///< kg
    std::int32_t node_end = 0;    ///< nodes from this one on were never used
    std::int32_t bend_count = 0;  ///< bend springs in use
    template <typename Visit>
    void fields(Visit&& visit) {
        visit(positions, velocities, masses, vertex, held, isolated, pieces, first_piece, contacts,
              first_contact, first, second, next_spring, stiffness, rest, first_spring, spring_end,
              free_nodes, free_contacts, free_springs, free_node_count, free_contact_count, free_spring_count,
              topology, removed_mass, node_end, bend_count);
    }
    std::size_t bytes() const;  ///< that its tables own
};

/// A spring between a point on a piece and an external object: jaws, the tip of a tool, a blade.
struct CutMembraneLink {
    std::int32_t piece = -1;  ///< slot
    Vector3 barycentric = Vector3::Constant(1.0 / 3);
    double stiffness = 0;                                       ///< N/m
    Vector3 start = Vector3::Zero(), target = Vector3::Zero();  ///< m, at the step's start and end
    /// Unit, or zero. If not zero, the link only pushes along it, towards -normal, and its part across is at
    /// most `grip` + friction times the push. Zero: the total force is at most `grip`.
    Vector3 normal = Vector3::Zero();
    double friction = 0;
    double grip = 0;                     ///< N; infinity: no limit
    bool push = true;                    ///< with a normal: false omits the force along it
    Vector3 reaction = Vector3::Zero();  ///< out: N, mean over the step, on the membrane
};

/// A rigidly held vertex with a prescribed motion over a step. Every node that is still held there moves with
/// it.
struct DrivenVertex {
    std::int32_t vertex = -1;          ///< with an attachment of infinite stiffness
    Vector3 target = Vector3::Zero();  ///< m, at the step's end
    Vector3 reaction =
        Vector3::Zero();  ///< out: N, mean over the step, support on the membrane, inertia included
};

struct CutMembraneInputs {
    Vector3 gravity = Vector3::Zero();           ///< m/s2, of attached parts
    Vector3 isolated_gravity = Vector3::Zero();  ///< m/s2, of isolated parts
    std::vector<CutMembraneLink> links;
    std::vector<DrivenVertex> driven;  ///< each vertex once; vertices not listed stay where they are
};

class CutMembraneScratch;

class CutMembrane {
  public:
    /// Attachment of a vertex: infinite stiffness fixes it; finite is a zero-length spring to its position at
    /// rest.
    struct Attachment {
        std::int32_t vertex = -1;
        double stiffness = 0;  ///< N/m, above 0
    };
    /// most_pieces: capacity, at least one per triangle. Throws InputError on a bad mesh (a triangle without
    /// area, an edge with three triangles), material, attachment or capacity.
    CutMembrane(const TriangleMesh& mesh, const MembraneMaterial& material,
                const std::vector<Attachment>& attachments, std::int32_t most_pieces);

    CutMembraneState make_state() const;
    CutMembraneScratch make_scratch() const;

    /// True if the state has room for the cut.
    bool fits(const CutMembraneState& state, const MembraneCut& cut) const noexcept;
    /// Applies a cut; false (and no change) if it does not fit.
    bool part(CutMembraneState& state, const MembraneCut& cut, CutMembraneScratch& scratch) const noexcept;

    /// One step; its report has no energy. Substepping is not a fault. refused: input not finite, or more
    /// than most_substeps needed; frozen: the result was not finite, the sheet keeps its previous positions.
    MembraneReport step(CutMembraneState& state, CutMembraneInputs& inputs, double dt,
                        CutMembraneScratch& scratch, int most_substeps = 4096) const noexcept;

    MembraneEnergy energy(const CutMembraneState& state) const;
    double mass(const CutMembraneState& state) const;
    Vector3 momentum(const CutMembraneState& state) const;
    /// Bound on every frequency, in every shape, after every cut, rad/s.
    double safe_frequency() const { return safe_frequency_; }
    double safe_time_step() const;  ///< s
    /// Position of a point of a root in a piece's nodes, m.
    static Vector3 point(const CutMembraneState& state, std::int32_t piece,
                         const Vector3& barycentric) noexcept;
    static Vector3 velocity(const CutMembraneState& state, std::int32_t piece,
                            const Vector3& barycentric) noexcept;
    /// Sum of x (x) force of the springs within `radius` (m) of a position, over the area of root triangles
    /// there: line tension, N/m, symmetric. Zero if there are none.
    Matrix3 tension(const CutMembraneState& state, const Vector3& place, double radius) const noexcept;

    const std::vector<Triangle>& triangles() const { return triangles_; }
    const std::vector<Vector3>& rest() const { return rest_; }
    const std::vector<MembraneSpring>& springs() const { return springs_; }
    const MembraneMaterial& material() const { return material_; }
    double root_mass(std::int32_t root) const { return root_mass_[static_cast<std::size_t>(root)]; }
    double density() const { return density_; }  ///< kg/m2
    std::int32_t most_nodes() const { return most_nodes_; }
    std::int32_t most_pieces() const { return most_pieces_; }
    std::size_t bytes() const;

  private:
    friend class CutMembraneScratch;
    /// Origin of a spring: structural: an edge; shear: the corners across an edge; bend: two consecutive
    /// edges.
    struct Source {
        std::int32_t edge = -1;  ///< structural and shear
        /// bend: per side, the roots of the two edges, with the number of the far corner and of the middle in
        /// each.
        struct Side {
            std::int32_t near = -1, far = -1;
            std::int8_t near_corner = 0, near_middle = 0, far_corner = 0, far_middle = 0;
        };
        std::array<Side, 2> sides;
        std::int8_t side_count = 0;
    };
    struct Edge {
        std::array<std::int32_t, 2> vertices, roots = {-1, -1};
        std::array<std::int8_t, 2> local = {0, 0};
    };
    void derive_edges();
    void derive_sources();
    void bound_frequency();
    void make_springs(CutMembraneState& state, std::size_t spring) const noexcept;
    void add_spring(CutMembraneState& state, std::size_t spring, std::int32_t a, std::int32_t b,
                    double stiffness) const noexcept;
    void make_bend(CutMembraneState& state, std::size_t spring) const noexcept;
    template <typename Call>
    void for_pieces(const CutMembraneState& state, std::int32_t root, Call&& call) const noexcept {
        for (std::int32_t p = state.first_piece[static_cast<std::size_t>(root)]; p >= 0;
             p = state.pieces[static_cast<std::size_t>(p)].next)
            call(p, state.pieces[static_cast<std::size_t>(p)]);
    }
    void find_isolated(CutMembraneState& state, CutMembraneScratch& scratch) const noexcept;
    void collect(const CutMembraneState& state, std::int32_t vertex,
                 CutMembraneScratch& scratch) const noexcept;
    /// The steps of part(), in order. Removes the pieces and contacts of a root; the scratch remembers the
    /// pieces' nodes by slot, and the root's vertices.
    void remove_pieces(CutMembraneState& state, std::int32_t root,
                       CutMembraneScratch& scratch) const noexcept;
    void add_pieces(CutMembraneState& state, const MembraneCut& cut,
                    const CutMembraneScratch& scratch) const noexcept;
    /// Frees the nodes at the remembered vertices that no piece uses any more.
    void free_unused_nodes(CutMembraneState& state, CutMembraneScratch& scratch) const noexcept;
    void split_vertex(CutMembraneState& state, std::int32_t vertex,
                      CutMembraneScratch& scratch) const noexcept;
    /// Makes every spring around the remembered vertices again.
    void remake_springs(CutMembraneState& state, CutMembraneScratch& scratch) const noexcept;

    std::vector<Triangle> triangles_;
    std::vector<Vector3> rest_;
    std::vector<double> root_area_, root_mass_;
    std::vector<double> attachment_;  ///< by vertex: 0 free, infinite fixed
    MembraneMaterial material_;
    double density_ = 0;
    std::vector<Edge> edges_;
    std::vector<std::array<std::int32_t, 3>> root_edges_;
    std::vector<std::int32_t> around_offsets_, around_;  ///< roots around each vertex
    std::vector<MembraneSpring> springs_;
    std::vector<Source> sources_;
    std::vector<std::int32_t> use_offsets_, uses_;  ///< springs that depend on a root
    double safe_frequency_ = 0;
    std::vector<double> vertex_mass_;
    std::int32_t most_nodes_ = 0, most_pieces_ = 0, most_contacts_ = 0, most_springs_ = 0, most_bends_ = 0;
};

/// Work space of one thread. Made by CutMembrane::make_scratch.
class CutMembraneScratch {
  private:
    friend class CutMembrane;
    std::vector<Lanes> position_, velocity_, gradient_;
    std::vector<double> inverse_mass_, anchor_;
    std::vector<Vector3> good_;
    std::vector<std::int32_t> driven_;                                 ///< by vertex, -1
    std::vector<std::pair<std::int32_t, std::int32_t>> driven_nodes_;  ///< node, number in the inputs
    // Of part().
    struct Incidence {
        std::int32_t piece, corner, parent, node, new_node;
        double mass;
        bool held;
    };
    std::vector<Incidence> incidences_;
    std::vector<std::int32_t> vertices_, parent_;
    std::vector<std::uint32_t> vertex_stamp_, spring_stamp_, node_stamp_;
    std::vector<std::int32_t> place_of_piece_;
    std::vector<std::array<std::int32_t, 3>> old_nodes_;
    std::uint32_t stamp_ = 0;
};

}  // namespace fulcrum
