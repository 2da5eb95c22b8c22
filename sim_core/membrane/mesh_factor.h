// SPDX-License-Identifier: Apache-2.0
// L D L^T of a matrix diag + sum of w (e_i - e_j)(e_i - e_j)^T over the edges of a mesh: nested dissection by
// geometry, columns of like structure kept in groups of up to four, four right-hand sides at once. What a
// prefactored membrane solve lives on: solve is O(n log n), and a change of a few edges is taken into the
// factor along its elimination path (rank one each) instead of factoring anew.
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

#include "sim_core/numerics/lanes.h"
#include "sim_core/numerics/types.h"

namespace fulcrum {

using GraphEdge = std::array<std::int32_t, 2>;

/// Elimination order of `nodes` nodes: order[k] is the node eliminated k-th. Deterministic.
std::vector<std::int32_t> dissection_order(const std::vector<Vector3>& positions,
                                           const std::vector<GraphEdge>& edges);

/// Structure of the factor for nodes numbered in elimination order. Constant; any number of factors share it.
class MeshFactorPattern {
  public:
    static constexpr std::int32_t widest = 4;
    MeshFactorPattern(std::int32_t nodes, const std::vector<GraphEdge>& edges);

    /// Up to four columns with the same rows below them.
    struct Group {
        std::int32_t first = 0, width = 0;      ///< columns
        std::int32_t rows_begin = 0, rows = 0;  ///< into rows()
        std::int64_t values_begin = 0;          ///< [row][column of the group]
        std::int32_t triangle_begin = 0;        ///< (c', c) with c' > c at c'(c'-1)/2 + c
    };
    struct RowUse {
        std::int32_t group, position;  ///< the group has this row at that position
    };
    std::int32_t nodes() const { return nodes_; }
    const std::vector<Group>& groups() const { return groups_; }
    const std::vector<std::int32_t>& rows() const { return rows_; }
    const std::vector<std::int32_t>& group_of() const { return group_of_; }
    const std::vector<std::int32_t>& parent() const { return parent_; }
    std::int64_t values() const { return values_; }
    std::int32_t triangles() const { return triangles_; }
    const std::vector<std::int32_t>& use_offsets() const { return use_offsets_; }
    const std::vector<RowUse>& uses() const { return uses_; }
    const std::vector<GraphEdge>& edges() const { return edges_; }
    const std::vector<std::int32_t>& column_edge_offsets() const { return column_edge_offsets_; }
    const std::vector<std::int32_t>& column_edges() const { return column_edges_; }
    std::size_t bytes() const;
    /// Multiplications of one factorisation and of one solve, for the size sweep.
    std::int64_t factor_operations() const { return factor_operations_; }
    std::int64_t solve_operations() const { return 2 * (values_ + triangles_) + nodes_; }

  private:
    std::int32_t nodes_ = 0, triangles_ = 0;
    std::int64_t values_ = 0, factor_operations_ = 0;
    std::vector<GraphEdge> edges_;                                  // lower index first
    std::vector<std::int32_t> column_edge_offsets_, column_edges_;  // edges by their lower index
    std::vector<Group> groups_;
    std::vector<std::int32_t> rows_, group_of_, parent_, use_offsets_;
    std::vector<RowUse> uses_;
};

/// The numbers. Copyable; allocates only when made.
class MeshFactor {
  public:
    MeshFactor() = default;
    explicit MeshFactor(std::shared_ptr<const MeshFactorPattern> pattern);

    /// Factors; diagonal: nodes, edge_weight: one for each edge of the pattern (what joins a node to
    /// something held belongs into the diagonal). False where a pivot is not above 1e-13 of its diagonal
    /// entry or not finite; then the factor must not be used.
    bool factor(const double* diagonal, const double* edge_weight) noexcept;
    /// x = A^-1 x, four right-hand sides.
    void solve(Lanes* x) const noexcept;
    /// A += delta (e_i - e_j)(e_i - e_j)^T, or delta e_i e_i^T where j < 0; the pair must be an edge of the
    /// pattern. False where A would stop being positive definite (the factor is then unusable).
    bool update(std::int32_t i, std::int32_t j, double delta) noexcept;
    std::size_t bytes() const;

  private:
    std::shared_ptr<const MeshFactorPattern> pattern_;
    std::vector<double> values_, triangle_, pivot_, inverse_pivot_, work_;
};

}  // namespace fulcrum
