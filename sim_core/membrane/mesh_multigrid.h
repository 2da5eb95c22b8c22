// SPDX-License-Identifier: Apache-2.0
// Multigrid for a matrix diag + sum of w (e_i - e_j)(e_i - e_j)^T over the edges of a mesh, four right-hand
// sides at once: smoothed aggregation (Vanek, Mandel and Brezina 1996), Gauss-Seidel forward before and
// backward after the coarser level, which is visited twice (a W-cycle), so that a cycle is symmetric and
// positive definite. Used as approximate inverse in quasi-Newton and conjugate gradients. Building it and a
// cycle cost O(n); a change of a few edges or diagonal entries is applied to every level at once, O(1) work
// on each.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "sim_core/numerics/lanes.h"

namespace fulcrum {

using GraphEdge = std::array<std::int32_t, 2>;

/// An order of nodes for fast sweeps: by colour, with no two connected nodes of one colour, so that
/// consecutive steps of a sweep need not wait for each other; within a colour outward from the first node, so
/// that near nodes stay near in memory. Entry k is the node at position k. Deterministic.
std::vector<std::int32_t> sweep_order(std::int32_t nodes, const std::vector<GraphEdge>& edges);

/// Copyable; allocates only in the constructor. One thread at a time: solve works in the levels' own vectors.
class MeshMultigrid {
  public:
    MeshMultigrid() = default;
    /// For nodes 0 .. nodes-1 and these edges, all different. A matrix must be built before use.
    MeshMultigrid(std::int32_t nodes, const std::vector<GraphEdge>& edges);

    /// Sets the matrix; diagonal: one per node (including connections to attached nodes); edge_weight: one
    /// per edge, >= 0. False if a diagonal entry of the whole is not above 0 or not finite; then it must not
    /// be used.
    bool build(const double* diagonal, const double* edge_weight) noexcept;
    /// x = approximately A^-1 x: one cycle. Linear in x to rounding.
    void solve(Lanes* x) noexcept;
    /// A += delta (e_i - e_j)(e_i - e_j)^T, or delta e_i e_i^T if j < 0; the pair must be one of the edges.
    /// The aggregates stay unchanged. False if A would no longer be positive definite (it is then unusable
    /// until built again).
    bool update(std::int32_t i, std::int32_t j, double delta) noexcept;

    int levels() const { return static_cast<int>(used_); }
    std::size_t bytes() const;
    /// Multiplications, each of four lanes, in one cycle; of numbers, in the last build. For the size sweep.
    std::int64_t solve_operations() const;
    std::int64_t build_operations() const { return build_operations_; }

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(levels_, used_, edge_slots_, dense_, coarsest_behind_, coarsest_, aggregate_, mark_,
              row_offsets_, rows_, row_values_, sum_, build_operations_);
    }

  private:
    /// One level. Rows have a lower and an upper half, each padded to a multiple of four with entries of
    /// value 0 in the column after the last: loops without remainders are faster.
    struct Level {
        std::int32_t nodes = 0;
        std::vector<std::int32_t> offsets, middle, columns;  ///< columns ascend within a half
        std::vector<double> values, diagonal, inverse_diagonal;
        /// Interpolation from the next coarser level to this one: `widest` entries per row, none negative, of
        /// sum 1, padded as above; or of sum 0.
        std::vector<std::int32_t> gather_columns;
        std::vector<double> gather_values;
        std::vector<Lanes> solution, right, kept, first;
        void size(std::size_t nodes, std::size_t entries);

        template <typename Visit>
        void fields(Visit&& visit) {
            visit(nodes, offsets, middle, columns, values, diagonal, inverse_diagonal, gather_columns,
                  gather_values, solution, right, kept, first);
        }
    };
    static constexpr std::int32_t widest = 3;
    std::int32_t aggregate(const Level& level) noexcept;
    void smooth_gathering(Level& level, std::int32_t coarse_nodes) noexcept;
    bool form_coarse(const Level& fine, Level& coarse, std::int32_t nodes) noexcept;
    bool form_row(const Level& fine, Level& coarse, std::int32_t row, std::int32_t& used) noexcept;
    bool factor_coarsest() noexcept;
    void solve_coarsest(Lanes* right) const noexcept;
    void visit(std::size_t depth) noexcept;
    void cycle(std::size_t depth, Lanes* right) noexcept;

    std::vector<Level> levels_;
    std::size_t used_ = 0;
    std::vector<GraphEdge> edges_;
    std::vector<std::int32_t> edge_slots_;  ///< an edge's two indices in the finest level's values
    bool dense_ = false, coarsest_behind_ = false;
    std::vector<double> coarsest_;  ///< dense L D L^T of the coarsest level, inverse pivots on the diagonal
    // Work space of building: aggregate of a node; marks and sums by coarse node; the interpolation by
    // columns.
    std::vector<std::int32_t> aggregate_, mark_, row_offsets_, rows_;
    std::vector<double> row_values_, sum_;
    std::int64_t build_operations_ = 0;
};

}  // namespace fulcrum
