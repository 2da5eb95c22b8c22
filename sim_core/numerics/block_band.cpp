// SPDX-License-Identifier: Apache-2.0
#include "sim_core/numerics/block_band.h"

namespace fulcrum {
namespace {

constexpr Block4 zero_block{{Lanes{0, 0, 0, 0}, Lanes{0, 0, 0, 0}, Lanes{0, 0, 0, 0}, Lanes{0, 0, 0, 0}}};

// w = block * lower^-T, column by column.
inline void eliminate(const Block4& block, const Block4& lower, Block4& w) {
    w.column[0] = block.column[0];
    w.column[1] = block.column[1] - w.column[0] * lower.column[0][1];
    w.column[2] = block.column[2] - w.column[0] * lower.column[0][2] - w.column[1] * lower.column[1][2];
    w.column[3] = block.column[3] - w.column[0] * lower.column[0][3] - w.column[1] * lower.column[1][3] -
                  w.column[2] * lower.column[2][3];
}

// target -= v * w^T
inline void subtract_product(Block4& target, const Block4& v, const Block4& w) {
    for (int q = 0; q < 4; ++q) {
        target.column[q] -= (v.column[0] * w.column[0][q] + v.column[1] * w.column[1][q]) +
                            (v.column[2] * w.column[2][q] + v.column[3] * w.column[3][q]);
    }
}

// Sums the lanes of four vectors into one.
inline Lanes column_sums(Lanes a, Lanes b, Lanes c, Lanes d) {
    transpose_lanes(a, b, c, d);
    return (a + b) + (c + d);
}

}  // namespace

BlockBand::BlockBand(std::size_t blocks)
    : diagonal(blocks, zero_block), first(blocks, zero_block), second(blocks, zero_block) {}

std::size_t BlockBand::bytes() const {
    return 3 * diagonal.capacity() * sizeof(Block4);
}

void BlockBand::set_zero() {
    for (std::size_t i = 0; i < diagonal.size(); ++i) diagonal[i] = first[i] = second[i] = zero_block;
}

BlockBandFactor::BlockBandFactor(std::size_t blocks)
    : lower_(blocks, zero_block),
      first_(blocks, zero_block),
      second_(blocks, zero_block),
      inverse_pivot_(4 * blocks, 1.0) {}

std::size_t BlockBandFactor::bytes() const {
    return 3 * lower_.capacity() * sizeof(Block4) + inverse_pivot_.capacity() * sizeof(double);
}

bool BlockBandFactor::factor(const BlockBand& matrix, double shift, const double* weights, double smallest) {
    const std::size_t n = blocks();
    if (n == 0) return true;
    // Contribution of the two previous rows to the blocks that are still to be factored.
    Block4 now = matrix.diagonal[0];
    Block4 next = n > 1 ? matrix.diagonal[1] : zero_block;
    Block4 below = matrix.first[0];
    for (std::size_t i = 0; i < n; ++i) {
        Lanes pivot_floor = all_lanes(smallest);
        for (int k = 0; k < 4; ++k) {
            const double entry = matrix.diagonal[i].column[k][k];
            pivot_floor[k] *= entry > 0 ? entry : 1.0;
            if (weights != nullptr) now.column[k][k] += shift * weights[4 * i + static_cast<std::size_t>(k)];
        }
        // 4 x 4 L D L^T, columns below the diagonal scaled.
        Block4& lower = lower_[i];
        Lanes inverse;
        const double d0 = now.column[0][0];
        const double i0 = 1.0 / d0;
        const Lanes l0 = now.column[0] * i0;
        const Lanes c1 = now.column[1] - l0 * now.column[0][1];
        const double d1 = c1[1];
        const double i1 = 1.0 / d1;
        const Lanes l1 = c1 * i1;
        const Lanes c2 = (now.column[2] - l0 * now.column[0][2]) - l1 * c1[2];
        const double d2 = c2[2];
        const double i2 = 1.0 / d2;
        const Lanes l2 = c2 * i2;
        const Lanes c3 = ((now.column[3] - l0 * now.column[0][3]) - l1 * c1[3]) - l2 * c2[3];
        const double d3 = c3[3];
        inverse = Lanes{i0, i1, i2, 1.0 / d3};
        if (!(d0 > pivot_floor[0] && d1 > pivot_floor[1] && d2 > pivot_floor[2] && d3 > pivot_floor[3]))
            return false;
        if (!(d0 < 1e300 && d1 < 1e300 && d2 < 1e300 && d3 < 1e300)) return false;
        lower.column[0] = l0;
        lower.column[1] = l1;
        lower.column[2] = l2;
        store_lanes(&inverse_pivot_[4 * i], inverse);
        if (i + 1 == n) break;

        Block4 w1, w2;
        eliminate(below, lower, w1);
        Block4& v1 = first_[i];
        for (int k = 0; k < 4; ++k) v1.column[k] = w1.column[k] * inverse[k];
        subtract_product(next, v1, w1);
        now = next;
        if (i + 2 == n) continue;
        eliminate(matrix.second[i], lower, w2);
        Block4& v2 = second_[i];
        for (int k = 0; k < 4; ++k) v2.column[k] = w2.column[k] * inverse[k];
        below = matrix.first[i + 1];
        subtract_product(below, v2, w1);
        next = matrix.diagonal[i + 2];
        subtract_product(next, v2, w2);
    }
    return true;
}

// block * y, y given by its four entries.
static inline Lanes product(const Block4& block, const Lanes& y) {
    return (block.column[0] * y[0] + block.column[1] * y[1]) +
           (block.column[2] * y[2] + block.column[3] * y[3]);
}

void BlockBandFactor::solve(double* x) const {
    const std::size_t n = blocks();
    Lanes now = load_lanes(x), next = n > 1 ? load_lanes(x + 4) : all_lanes(0);
    for (std::size_t i = 0; i < n; ++i) {
        Lanes y = now;
        const Block4& lower = lower_[i];
        // Lanes at or above the column's own index keep their value.
        y -= Lanes{0, lower.column[0][1], lower.column[0][2], lower.column[0][3]} * y[0];
        y -= Lanes{0, 0, lower.column[1][2], lower.column[1][3]} * y[1];
        y -= Lanes{0, 0, 0, lower.column[2][3]} * y[2];
        store_lanes(x + 4 * i, y);
        if (i + 1 == n) break;
        now = next - product(first_[i], y);
        if (i + 2 < n) next = load_lanes(x + 4 * (i + 2)) - product(second_[i], y);
    }
    Lanes after = all_lanes(0), second_after = all_lanes(0);
    for (std::size_t i = n; i-- > 0;) {
        Lanes y = load_lanes(x + 4 * i) * load_lanes(&inverse_pivot_[4 * i]);
        const Block4 &v = first_[i], &u = second_[i];  // zero in the last rows
        y -= column_sums(v.column[0] * after + u.column[0] * second_after,
                         v.column[1] * after + u.column[1] * second_after,
                         v.column[2] * after + u.column[2] * second_after,
                         v.column[3] * after + u.column[3] * second_after);
        const Block4& lower = lower_[i];
        const double y3 = y[3];
        const double y2 = y[2] - lower.column[2][3] * y3;
        const double y1 = (y[1] - lower.column[1][3] * y3) - lower.column[1][2] * y2;
        const double y0 =
            ((y[0] - lower.column[0][3] * y3) - lower.column[0][2] * y2) - lower.column[0][1] * y1;
        second_after = after;
        after = Lanes{y0, y1, y2, y3};
        store_lanes(x + 4 * i, after);
    }
}

void multiply(const BlockBand& matrix, const double* x, double* y) {
    const std::size_t n = matrix.blocks();
    for (std::size_t i = 0; i < n; ++i) {
        const Lanes here = load_lanes(x + 4 * i);
        Lanes sum = product(matrix.diagonal[i], here);
        if (i >= 1) sum += product(matrix.first[i - 1], load_lanes(x + 4 * (i - 1)));
        if (i >= 2) sum += product(matrix.second[i - 2], load_lanes(x + 4 * (i - 2)));
        const Block4 &v = matrix.first[i], &u = matrix.second[i];
        const Lanes p = i + 1 < n ? load_lanes(x + 4 * (i + 1)) : all_lanes(0);
        const Lanes q = i + 2 < n ? load_lanes(x + 4 * (i + 2)) : all_lanes(0);
        sum += column_sums(v.column[0] * p + u.column[0] * q, v.column[1] * p + u.column[1] * q,
                           v.column[2] * p + u.column[2] * q, v.column[3] * p + u.column[3] * q);
        store_lanes(y + 4 * i, sum);
    }
}

}  // namespace fulcrum
