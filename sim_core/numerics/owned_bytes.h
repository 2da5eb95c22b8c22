// SPDX-License-Identifier: Apache-2.0
// Memory that a value owns next to its own size: its vectors, found by the same member template fields() that
// StateArchive walks. Any thread.
#pragma once

#include <cstddef>
#include <type_traits>
#include <utility>
#include <vector>

namespace fulcrum {

class OwnedBytes {
  public:
    /// Members are only read.
    template <typename... Members>
    void operator()(Members&... members) {
        (add(members), ...);
    }
    std::size_t bytes() const { return bytes_; }

  private:
    template <typename Type, typename = void>
    struct has_fields : std::false_type {};
    template <typename Type>
    struct has_fields<Type, std::void_t<decltype(std::declval<Type&>().fields(std::declval<OwnedBytes&>()))>>
        : std::true_type {};

    template <typename Member>
    void add(Member& member) {
        if constexpr (has_fields<Member>::value) {
            member.fields(*this);
        } else {
            static_assert(std::is_trivially_destructible_v<Member>, "give this type a member fields()");
        }
    }
    template <typename Entry>
    void add(std::vector<Entry>& member) {
        bytes_ += member.capacity() * sizeof(Entry);
        for (Entry& entry : member) add(entry);
    }
    template <typename Entry, std::size_t Count>
    void add(Entry (&member)[Count]) {
        for (Entry& entry : member) add(entry);
    }

    std::size_t bytes_ = 0;
};

/// Of a value with fields().
template <typename Value>
std::size_t owned_bytes(const Value& value) {
    OwnedBytes owned;
    const_cast<Value&>(value).fields(owned);  // sizes are read only
    return owned.bytes();
}

}  // namespace fulcrum
