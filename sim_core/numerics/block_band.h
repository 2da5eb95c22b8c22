// SPDX-License-Identifier: Apache-2.0
// Symmetric block-pentadiagonal matrix of 4 x 4 blocks and its L D L^T factorisation: O(n), no allocation
// after construction. Block row i couples with rows i - 1 and i - 2 only, as in a chain whose energy terms
// span three neighbours.
#pragma once

#include <cstddef>
#include <vector>

#include "sim_core/numerics/lanes.h"

namespace fulcrum {

/// 4 x 4 block by columns: column[k][r] is row r of column k.
struct Block4 {
    Lanes column[4];
};

class BlockBand {
  public:
    explicit BlockBand(std::size_t blocks = 0);

    std::size_t blocks() const { return diagonal.size(); }
    std::size_t bytes() const;
    void set_zero();

    std::vector<Block4> diagonal;  ///< block (i, i), both triangles
    std::vector<Block4> first;     ///< block (i + 1, i)
    std::vector<Block4> second;    ///< block (i + 2, i)

    template <typename Visit>
    void fields(Visit&& visit) {
        visit(diagonal, first, second);
    }
};

/// Factor of a BlockBand. Stored separately, so that the matrix itself stays available for products and
/// reactions.
class BlockBandFactor {
  public:
    explicit BlockBandFactor(std::size_t blocks = 0);

    /// Factors matrix + shift * diag(weights) (4 blocks() entries; null: no shift). Returns false at the
    /// first pivot that is not finite or not above `smallest` times its original diagonal entry: the matrix
    /// is then not positive definite to working accuracy.
    bool factor(const BlockBand& matrix, double shift = 0, const double* weights = nullptr,
                double smallest = 1e-14);
    /// x = A^-1 b in place; 4 blocks() entries.
    void solve(double* x) const;
    std::size_t blocks() const { return lower_.size(); }
    std::size_t bytes() const;
    template <typename Visit>
    void fields(Visit&& visit) {
        visit(lower_, first_, second_, inverse_pivot_);
    }

  private:
    std::vector<Block4> lower_;           // unit lower triangle of each diagonal block
    std::vector<Block4> first_, second_;  // blocks of L below it
    std::vector<double> inverse_pivot_;
};

/// y = A x. x and y: 4 blocks() entries, distinct.
void multiply(const BlockBand& matrix, const double* x, double* y);

}  // namespace fulcrum
