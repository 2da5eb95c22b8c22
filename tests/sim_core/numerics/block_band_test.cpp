// SPDX-License-Identifier: Apache-2.0
#include "sim_core/numerics/block_band.h"

#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <random>

namespace fulcrum {
namespace {

// A random positive definite matrix of the band's pattern: G G^T with G lower block-bidiagonal of the same
// reach.
void fill(std::size_t blocks, std::uint64_t seed, BlockBand& band, Eigen::MatrixXd& dense) {
    std::mt19937_64 random(seed);
    std::uniform_real_distribution<double> uniform(-1, 1);
    const Eigen::Index n = static_cast<Eigen::Index>(4 * blocks);
    Eigen::MatrixXd g = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
        for (Eigen::Index j = std::max<Eigen::Index>(0, 4 * (i / 4) - 8); j <= i; ++j)
            g(i, j) = uniform(random);
        g(i, i) += 3;
    }
    dense = g * g.transpose();
    for (std::size_t b = 0; b < blocks; ++b) {
        for (int r = 0; r < 4; ++r) {
            for (int c = 0; c < 4; ++c) {
                const auto at = [&](std::size_t row) {
                    return row < blocks ? dense(static_cast<Eigen::Index>(4 * row) + r,
                                                static_cast<Eigen::Index>(4 * b) + c)
                                        : 0.0;
                };
                band.diagonal[b].column[c][r] = at(b);
                band.first[b].column[c][r] = at(b + 1);
                band.second[b].column[c][r] = at(b + 2);
            }
        }
    }
}

TEST(BlockBand, AgreesWithADenseFactorisation) {
    for (const std::size_t blocks : {1u, 2u, 3u, 4u, 17u, 64u}) {
        BlockBand band(blocks);
        Eigen::MatrixXd dense;
        fill(blocks, blocks, band, dense);
        BlockBandFactor factor(blocks);
        ASSERT_TRUE(factor.factor(band));
        const Eigen::VectorXd b = Eigen::VectorXd::LinSpaced(static_cast<Eigen::Index>(4 * blocks), -1, 2);
        Eigen::VectorXd x = b, product(b.size());
        factor.solve(x.data());
        EXPECT_LT((dense * x - b).norm(), 1e-10 * b.norm()) << blocks;
        multiply(band, x.data(), product.data());
        EXPECT_LT((product - b).norm(), 1e-10 * b.norm()) << blocks;
    }
}

TEST(BlockBand, RefusesAnIndefiniteMatrixAndAcceptsItShifted) {
    BlockBand band(20);
    Eigen::MatrixXd dense;
    fill(20, 3, band, dense);
    band.diagonal[11].column[2][2] -= 60;
    BlockBandFactor factor(20);
    EXPECT_FALSE(factor.factor(band));
    const std::vector<double> weights(80, 1.0);
    EXPECT_TRUE(factor.factor(band, 200, weights.data()));
}

TEST(BlockBand, RefusesNan) {
    BlockBand band(5);
    Eigen::MatrixXd dense;
    fill(5, 4, band, dense);
    band.first[2].column[1][1] = std::nan("");
    BlockBandFactor factor(5);
    EXPECT_FALSE(factor.factor(band));
}

}  // namespace
}  // namespace fulcrum
