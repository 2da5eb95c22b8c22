// SPDX-License-Identifier: Apache-2.0
// A vector of a view of which only the first entries have a meaning.
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace fulcrum {

/// A vector of fixed size of which the first `used` entries have a meaning: assignment copies only those, so
/// that room for what an attempt may still cut costs nothing in each step.
template <typename T>
class UsedVector : public std::vector<T> {
  public:
    UsedVector() = default;
    UsedVector(const UsedVector&) = default;
    UsedVector(UsedVector&&) noexcept = default;
    UsedVector& operator=(UsedVector&&) noexcept = default;
    ~UsedVector() = default;
    UsedVector& operator=(const UsedVector& other) {
        if (this == &other) return *this;
        if (this->size() != other.size()) this->resize(other.size());
        used = other.used;
        std::copy_n(other.begin(), std::min(used, other.size()), this->begin());
        return *this;
    }
    /// A replay's key frame keeps it whole.
    template <typename Visit>
    void fields(Visit&& visit) {
        visit(static_cast<std::vector<T>&>(*this), used);
    }
    std::size_t used = 0;
};

}  // namespace fulcrum
