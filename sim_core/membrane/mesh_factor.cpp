// SPDX-License-Identifier: Apache-2.0
#include "sim_core/membrane/mesh_factor.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {
namespace {

std::size_t at(std::int32_t i) {
    return static_cast<std::size_t>(i);
}
std::size_t at(std::int64_t i) {
    return static_cast<std::size_t>(i);
}

// Recursive bisection along the longest extent; the nodes of the first half that touch the second separate
// them.
class Dissection {
  public:
    Dissection(const std::vector<Vector3>& positions, const std::vector<GraphEdge>& edges)
        : positions_(positions), offsets_(positions.size() + 1, 0), side_(positions.size(), 0) {
        for (const GraphEdge& e : edges) {
            ++offsets_[at(e[0]) + 1];
            ++offsets_[at(e[1]) + 1];
        }
        for (std::size_t i = 1; i < offsets_.size(); ++i) offsets_[i] += offsets_[i - 1];
        neighbours_.resize(at(offsets_.back()));
        std::vector<std::int32_t> next(offsets_.begin(), offsets_.end() - 1);
        for (const GraphEdge& e : edges) {
            neighbours_[at(next[at(e[0])]++)] = e[1];
            neighbours_[at(next[at(e[1])]++)] = e[0];
        }
        order_.resize(positions.size());
        for (std::size_t i = 0; i < order_.size(); ++i) order_[i] = static_cast<std::int32_t>(i);
        split(0, order_.size());
    }
    std::vector<std::int32_t> take() { return std::move(order_); }

  private:
    static constexpr std::size_t leaf = 12;
    int longest_axis(std::size_t begin, std::size_t end) const {
        Vector3 low = positions_[at(order_[begin])], high = low;
        for (std::size_t i = begin; i < end; ++i) {
            low = low.cwiseMin(positions_[at(order_[i])]);
            high = high.cwiseMax(positions_[at(order_[i])]);
        }
        int axis = 0;
        (high - low).maxCoeff(&axis);
        return axis;
    }
    void split(std::size_t begin, std::size_t end) {
        const int axis = longest_axis(begin, end);
        const auto before = [&](std::int32_t a, std::int32_t b) {
            const double x = positions_[at(a)][axis], y = positions_[at(b)][axis];
            return x != y ? x < y : a < b;
        };
        const auto first = order_.begin() + static_cast<std::ptrdiff_t>(begin);
        const auto last = order_.begin() + static_cast<std::ptrdiff_t>(end);
        if (end - begin <= leaf) {
            std::sort(first, last, before);
            return;
        }
        const std::size_t middle = (begin + end) / 2;
        std::nth_element(first, order_.begin() + static_cast<std::ptrdiff_t>(middle), last, before);
        const int mark = ++mark_;
        for (std::size_t i = middle; i < end; ++i) side_[at(order_[i])] = mark;
        const auto touches = [&](std::int32_t v) {
            for (std::int32_t k = offsets_[at(v)]; k < offsets_[at(v) + 1]; ++k) {
                if (side_[at(neighbours_[at(k)])] == mark) return true;
            }
            return false;
        };
        // first half without the separator | second half | separator
        const auto half = order_.begin() + static_cast<std::ptrdiff_t>(middle);
        const auto separator =
            std::stable_partition(first, half, [&](std::int32_t v) { return !touches(v); });
        const auto inner = static_cast<std::size_t>(separator - order_.begin());
        const std::size_t separating = middle - inner;
        std::rotate(separator, half, last);
        const std::size_t second_end = end - separating;
        if (inner > begin) split(begin, inner);
        if (second_end > inner) split(inner, second_end);
        if (separating > 0) {
            const int along = longest_axis(second_end, end);
            std::sort(order_.begin() + static_cast<std::ptrdiff_t>(second_end), last,
                      [&](std::int32_t a, std::int32_t b) {
                          const double x = positions_[at(a)][along], y = positions_[at(b)][along];
                          return x != y ? x < y : a < b;
                      });
        }
    }

    const std::vector<Vector3>& positions_;
    std::vector<std::int32_t> offsets_, neighbours_, order_;
    std::vector<int> side_;
    int mark_ = 0;
};

}  // namespace

std::vector<std::int32_t> dissection_order(const std::vector<Vector3>& positions,
                                           const std::vector<GraphEdge>& edges) {
    if (positions.empty()) return {};
    return Dissection(positions, edges).take();
}

MeshFactorPattern::MeshFactorPattern(std::int32_t nodes, const std::vector<GraphEdge>& edges)
    : nodes_(nodes), edges_(edges), group_of_(at(nodes), -1), parent_(at(nodes), -1) {
    column_edge_offsets_.assign(at(nodes) + 1, 0);
    for (GraphEdge& e : edges_) {
        if (e[0] > e[1]) std::swap(e[0], e[1]);
        ++column_edge_offsets_[at(e[0]) + 1];
    }
    for (std::size_t i = 1; i < column_edge_offsets_.size(); ++i)
        column_edge_offsets_[i] += column_edge_offsets_[i - 1];
    column_edges_.resize(edges_.size());
    std::vector<std::int32_t> next(column_edge_offsets_.begin(), column_edge_offsets_.end() - 1);
    for (std::size_t k = 0; k < edges_.size(); ++k)
        column_edges_[at(next[at(edges_[k][0])]++)] = static_cast<std::int32_t>(k);

    // Structure of column j: its own edges and what its children hand on.
    std::vector<std::vector<std::int32_t>> structure(at(nodes)), children(at(nodes));
    std::vector<std::int32_t> seen(at(nodes), -1);
    for (std::int32_t j = 0; j < nodes; ++j) {
        auto& column = structure[at(j)];
        seen[at(j)] = j;
        const auto add = [&](std::int32_t i) {
            if (seen[at(i)] == j) return;
            seen[at(i)] = j;
            column.push_back(i);
        };
        for (std::int32_t k = column_edge_offsets_[at(j)]; k < column_edge_offsets_[at(j) + 1]; ++k)
            add(edges_[at(column_edges_[at(k)])][1]);
        for (const std::int32_t c : children[at(j)]) {
            for (const std::int32_t i : structure[at(c)]) add(i);
        }
        std::sort(column.begin(), column.end());
        if (!column.empty()) {
            parent_[at(j)] = column.front();
            children[at(column.front())].push_back(j);
        }
        factor_operations_ += static_cast<std::int64_t>(column.size() * (column.size() + 3) / 2);
    }
    for (std::int32_t j = 0; j < nodes;) {
        std::int32_t width = 1;
        while (width < widest && j + width < nodes && parent_[at(j + width - 1)] == j + width &&
               structure[at(j + width - 1)].size() == structure[at(j + width)].size() + 1) {
            ++width;
        }
        Group group;
        group.first = j;
        group.width = width;
        const auto& below = structure[at(j + width - 1)];
        group.rows = static_cast<std::int32_t>(below.size());
        group.rows_begin = static_cast<std::int32_t>(rows_.size());
        group.values_begin = values_;
        group.triangle_begin = triangles_;
        values_ += static_cast<std::int64_t>(below.size()) * width;
        triangles_ += width * (width - 1) / 2;
        rows_.insert(rows_.end(), below.begin(), below.end());
        for (std::int32_t c = 0; c < width; ++c)
            group_of_[at(j + c)] = static_cast<std::int32_t>(groups_.size());
        groups_.push_back(group);
        j += width;
    }
    use_offsets_.assign(at(nodes) + 1, 0);
    for (const std::int32_t row : rows_) ++use_offsets_[at(row) + 1];
    for (std::size_t i = 1; i < use_offsets_.size(); ++i) use_offsets_[i] += use_offsets_[i - 1];
    uses_.resize(rows_.size());
    next.assign(use_offsets_.begin(), use_offsets_.end() - 1);
    for (std::size_t g = 0; g < groups_.size(); ++g) {
        for (std::int32_t q = 0; q < groups_[g].rows; ++q) {
            const std::int32_t row = rows_[at(groups_[g].rows_begin + q)];
            uses_[at(next[at(row)]++)] = {static_cast<std::int32_t>(g), q};
        }
    }
}

std::size_t MeshFactorPattern::bytes() const {
    return sizeof(std::int32_t) * (rows_.size() + group_of_.size() + parent_.size() + use_offsets_.size() +
                                   column_edge_offsets_.size() + column_edges_.size()) +
           sizeof(Group) * groups_.size() + sizeof(RowUse) * uses_.size() + sizeof(GraphEdge) * edges_.size();
}

MeshFactor::MeshFactor(std::shared_ptr<const MeshFactorPattern> pattern)
    : pattern_(std::move(pattern)),
      values_(at(pattern_->values()), 0.0),
      triangle_(at(pattern_->triangles()), 0.0),
      pivot_(at(pattern_->nodes()), 1.0),
      inverse_pivot_(at(pattern_->nodes()), 1.0),
      work_(at(pattern_->nodes()), 0.0) {}

std::size_t MeshFactor::bytes() const {
    return sizeof(double) *
           (values_.size() + triangle_.size() + pivot_.size() + inverse_pivot_.size() + work_.size());
}

bool MeshFactor::factor(const double* diagonal, const double* edge_weight) noexcept {
    const MeshFactorPattern& p = *pattern_;
    std::fill(work_.begin(), work_.end(), 0.0);
    double* full = inverse_pivot_.data();  // the matrix's own diagonal, until the pivots are inverted
    for (std::int32_t j = 0; j < p.nodes(); ++j) full[j] = diagonal[j];
    for (std::size_t k = 0; k < p.edges().size(); ++k) {
        full[p.edges()[k][0]] += edge_weight[k];
        full[p.edges()[k][1]] += edge_weight[k];
    }
    for (const auto& target : p.groups()) {
        for (std::int32_t c = 0; c < target.width; ++c) {
            const std::int32_t j = target.first + c;
            double* w = work_.data();
            w[j] = full[j];
            for (std::int32_t k = p.column_edge_offsets()[at(j)]; k < p.column_edge_offsets()[at(j) + 1];
                 ++k) {
                const std::int32_t e = p.column_edges()[at(k)];
                w[p.edges()[at(e)][1]] -= edge_weight[e];
            }
            for (std::int32_t u = p.use_offsets()[at(j)]; u < p.use_offsets()[at(j) + 1]; ++u) {
                const auto& use = p.uses()[at(u)];
                const auto& g = p.groups()[at(use.group)];
                const double* value =
                    values_.data() + g.values_begin + static_cast<std::int64_t>(use.position) * g.width;
                double scaled[MeshFactorPattern::widest];
                for (std::int32_t k = 0; k < g.width; ++k) scaled[k] = value[k] * pivot_[at(g.first + k)];
                const std::int32_t* row = p.rows().data() + g.rows_begin;
                if (g.width == 4) {
                    for (std::int32_t q = use.position; q < g.rows; ++q, value += 4)
                        w[row[q]] -= (value[0] * scaled[0] + value[1] * scaled[1]) +
                                     (value[2] * scaled[2] + value[3] * scaled[3]);
                } else {
                    for (std::int32_t q = use.position; q < g.rows; ++q, value += g.width) {
                        for (std::int32_t k = 0; k < g.width; ++k) w[row[q]] -= value[k] * scaled[k];
                    }
                }
            }
            double* triangle = triangle_.data() + target.triangle_begin;
            double* own = values_.data() + target.values_begin;
            const std::int32_t* row = p.rows().data() + target.rows_begin;
            for (std::int32_t k = 0; k < c; ++k) {
                const double scaled = triangle[c * (c - 1) / 2 + k] * pivot_[at(target.first + k)];
                w[j] -= scaled * triangle[c * (c - 1) / 2 + k];
                for (std::int32_t d = c + 1; d < target.width; ++d)
                    w[target.first + d] -= scaled * triangle[d * (d - 1) / 2 + k];
                for (std::int32_t q = 0; q < target.rows; ++q)
                    w[row[q]] -= scaled * own[q * target.width + k];
            }
            const double pivot = w[j];
            if (!(pivot > 1e-13 * full[j]) || !std::isfinite(pivot)) return false;
            pivot_[at(j)] = pivot;
            w[j] = 0;
            const double inverse = 1 / pivot;
            for (std::int32_t d = c + 1; d < target.width; ++d) {
                triangle[d * (d - 1) / 2 + c] = w[target.first + d] * inverse;
                w[target.first + d] = 0;
            }
            for (std::int32_t q = 0; q < target.rows; ++q) {
                own[q * target.width + c] = w[row[q]] * inverse;
                w[row[q]] = 0;
            }
        }
    }
    for (std::size_t j = 0; j < pivot_.size(); ++j) inverse_pivot_[j] = 1 / pivot_[j];
    return true;
}

namespace {

template <int width>
void forward(const MeshFactorPattern::Group& g, const std::int32_t* row, const double* value,
             const double* triangle, Lanes* x) {
    Lanes own[width];
    for (int c = 0; c < width; ++c) {
        own[c] = x[g.first + c];
        for (int k = 0; k < c; ++k) own[c] -= all_lanes(triangle[c * (c - 1) / 2 + k]) * own[k];
        x[g.first + c] = own[c];
    }
    for (std::int32_t q = 0; q < g.rows; ++q, value += width) {
        Lanes sum = all_lanes(value[0]) * own[0];
        for (int c = 1; c < width; ++c) sum += all_lanes(value[c]) * own[c];
        x[row[q]] -= sum;
    }
}

template <int width>
void backward(const MeshFactorPattern::Group& g, const std::int32_t* row, const double* value,
              const double* triangle, Lanes* x) {
    Lanes sum[width];
    for (int c = 0; c < width; ++c) sum[c] = x[g.first + c];
    for (std::int32_t q = 0; q < g.rows; ++q, value += width) {
        const Lanes below = x[row[q]];
        for (int c = 0; c < width; ++c) sum[c] -= all_lanes(value[c]) * below;
    }
    for (int c = width - 1; c >= 0; --c) {
        for (int d = c + 1; d < width; ++d) sum[c] -= all_lanes(triangle[d * (d - 1) / 2 + c]) * sum[d];
        x[g.first + c] = sum[c];
    }
}

}  // namespace

void MeshFactor::solve(Lanes* x) const noexcept {
    const MeshFactorPattern& p = *pattern_;
    const auto& groups = p.groups();
    for (const auto& g : groups) {
        const std::int32_t* row = p.rows().data() + g.rows_begin;
        const double* value = values_.data() + g.values_begin;
        const double* triangle = triangle_.data() + g.triangle_begin;
        switch (g.width) {
            case 1:
                forward<1>(g, row, value, triangle, x);
                break;
            case 2:
                forward<2>(g, row, value, triangle, x);
                break;
            case 3:
                forward<3>(g, row, value, triangle, x);
                break;
            default:
                forward<4>(g, row, value, triangle, x);
                break;
        }
    }
    for (std::size_t j = 0; j < inverse_pivot_.size(); ++j) x[j] *= all_lanes(inverse_pivot_[j]);
    for (auto g = groups.rbegin(); g != groups.rend(); ++g) {
        const std::int32_t* row = p.rows().data() + g->rows_begin;
        const double* value = values_.data() + g->values_begin;
        const double* triangle = triangle_.data() + g->triangle_begin;
        switch (g->width) {
            case 1:
                backward<1>(*g, row, value, triangle, x);
                break;
            case 2:
                backward<2>(*g, row, value, triangle, x);
                break;
            case 3:
                backward<3>(*g, row, value, triangle, x);
                break;
            default:
                backward<4>(*g, row, value, triangle, x);
                break;
        }
    }
}

bool MeshFactor::update(std::int32_t i, std::int32_t j, double delta) noexcept {
    // Gill, Golub, Murray and Saunders 1974, method C1, along the path of the elimination tree.
    const MeshFactorPattern& p = *pattern_;
    double* w = work_.data();
    w[i] = 1;
    if (j >= 0) w[j] = -1;
    double factor = delta;
    bool good = true;
    for (std::int32_t k = j >= 0 ? std::min(i, j) : i; k >= 0; k = p.parent()[at(k)]) {
        const double value = w[k];
        w[k] = 0;
        if (value == 0 || !good) continue;
        const double old = pivot_[at(k)];
        const double pivot = old + factor * value * value;
        if (!(pivot > 1e-10 * old) || !std::isfinite(pivot)) {
            good = false;
            continue;
        }
        const double beta = value * factor / pivot;
        factor *= old / pivot;
        pivot_[at(k)] = pivot;
        inverse_pivot_[at(k)] = 1 / pivot;
        const auto& g = p.groups()[at(p.group_of()[at(k)])];
        const std::int32_t c = k - g.first;
        for (std::int32_t d = c + 1; d < g.width; ++d) {
            double& entry = triangle_[at(g.triangle_begin + d * (d - 1) / 2 + c)];
            w[g.first + d] -= value * entry;
            entry += beta * w[g.first + d];
        }
        const std::int32_t* row = p.rows().data() + g.rows_begin;
        double* own = values_.data() + g.values_begin + c;
        for (std::int32_t q = 0; q < g.rows; ++q) {
            double& entry = own[q * g.width];
            w[row[q]] -= value * entry;
            entry += beta * w[row[q]];
        }
    }
    return good;
}

}  // namespace fulcrum
