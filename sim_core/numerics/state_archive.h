// SPDX-License-Identifier: Apache-2.0
// State as bytes, and back: key frames of a replay are made of it.
//
// The bytes are those of the machine's memory, so only the same build reads them: Eigen's and the compiler's
// layout are part of them. They say their own layout (a hash over the sizes of all that was written, in
// order), and reading checks it.
//
// Tables have room for all that an attempt may still cut; what was never used is the same entry over and over
// at their end. It is written once, so that a state has the size of what is used. Every bit comes back.
//
// What can be written: types that own nothing (trivially destructible, no virtual functions), vectors,
// arrays and optionals of what can be written, and types with a member template
// `void fields(Visit&& visit)` that calls visit(a, b, ...) once with every member that is state. A pointer in
// a type that owns nothing is written as an address: the owner puts its own pointer there after reading.
//
// Any thread, one at a time. Not for the real-time path: writing allocates.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <stdexcept>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim_core/numerics/worded_error.h"

namespace fulcrum {

/// Bytes that are not a state of this scene in this build.
class StateArchiveError : public WordedError {
  public:
    using WordedError::WordedError;
};

class StateArchive {
  public:
    /// Appends to `bytes`. `starts`, if given, gets the place in it at which the entries of each vector
    /// begin: two states of one scene are compared from there, however much of a table is used.
    explicit StateArchive(std::vector<std::uint8_t>& bytes, std::vector<std::uint32_t>* starts = nullptr)
        : out_(&bytes), starts_(starts) {}
    /// Reads `size` bytes at `bytes`, which must outlive it.
    StateArchive(const std::uint8_t* bytes, std::size_t size) : in_(bytes), left_(size) {}

    bool reads() const { return out_ == nullptr; }

    /// Writes or reads each member. Reading throws StateArchiveError where the bytes end too early.
    template <typename... Members>
    void operator()(Members&... members) {
        (transfer(members), ...);
    }
    /// The end: writes the layout, or checks it and that nothing is left. Throws StateArchiveError.
    void finish() {
        std::uint64_t layout = layout_;
        raw(&layout, sizeof layout);
        if (reads() && (layout != layout_ || left_ != 0))
            throw StateArchiveError(QT_TRANSLATE_NOOP(
                "errors",
                "the stored state was written by another version of the program, or for another scene"));
    }

  private:
    template <typename Type, typename = void>
    struct has_fields : std::false_type {};
    template <typename Type>
    struct has_fields<Type,
                      std::void_t<decltype(std::declval<Type&>().fields(std::declval<StateArchive&>()))>>
        : std::true_type {};
    template <typename Type>
    static constexpr bool owns_nothing =
        std::is_trivially_destructible_v<Type> && !std::is_polymorphic_v<Type> && !std::is_pointer_v<Type>;

    template <typename Member>
    void transfer(Member& member) {
        static_assert(!std::is_const_v<Member>);
        if constexpr (has_fields<Member>::value) {
            member.fields(*this);
        } else {
            static_assert(owns_nothing<Member>, "give this type a member template fields()");
            note(sizeof member);
            raw(static_cast<void*>(&member), sizeof member);
        }
    }
    template <typename Entry, std::size_t Count>
    void transfer(std::array<Entry, Count>& member) {
        entries(member.data(), Count);
    }
    template <typename Entry, std::size_t Count>
    void transfer(Entry (&member)[Count]) {
        entries(&member[0], Count);
    }
    template <typename Entry>
    void transfer(std::vector<Entry>& member) {
        if constexpr (owns_nothing<Entry> && !has_fields<Entry>::value) {
            table(member);
        } else {
            member.resize(room(member.size(), 1));
            entries(member.data(), member.size());
        }
    }
    /// Its entries up to where only the last one repeats.
    template <typename Entry>
    void table(std::vector<Entry>& member) {
        constexpr std::size_t each = sizeof(Entry);
        note(each);
        std::uint64_t count = member.size();
        raw(&count, sizeof count);
        if (reads() && count > most_bytes / each) throw too_short();
        const auto size = static_cast<std::size_t>(count);
        const std::size_t used = room(reads() ? 0 : used_of(bytes_of(member), size, each), each);
        if (used > size || (used == 0 && size > 0)) throw too_short();
        if (starts_ != nullptr) starts_->push_back(static_cast<std::uint32_t>(out_->size()));
        if (reads()) member.resize(size);
        if (used == 0) return;
        if (!reads()) {
            raw(static_cast<void*>(member.data()), used * each);
            return;
        }
        // Most of the end is as it was: to look is faster than to write.
        const std::size_t repeats = used_of(bytes_of(member), size, each);
        raw(static_cast<void*>(member.data()), used * each);
        const std::uint8_t* last = bytes_of(member) + (used - 1) * each;
        const bool same =
            repeats < size && std::memcmp(bytes_of(member) + (size - 1) * each, last, each) == 0;
        fill(static_cast<void*>(member.data()), used, same ? std::max(used, repeats) : size, each);
    }
    template <typename Entry>
    static const std::uint8_t* bytes_of(const std::vector<Entry>& member) {
        return reinterpret_cast<const std::uint8_t*>(member.data());
    }
    /// Entries up to the first of those at the end that are all the same, and that one.
    static std::size_t used_of(const std::uint8_t* data, std::size_t count, std::size_t each) {
        std::size_t used = count;
        constexpr std::size_t stretch = 4096;
        const std::size_t at_once = std::max<std::size_t>(1, stretch / each);
        while (used > at_once + 1) {
            const std::uint8_t* from = data + (used - 1 - at_once) * each;
            if (std::memcmp(from, from + each, at_once * each) != 0) break;
            used -= at_once;
        }
        while (used > 1 && std::memcmp(data + (used - 2) * each, data + (used - 1) * each, each) == 0) --used;
        return used;
    }
    /// Entries `from` .. `to` - 1 become as the one before them.
    static void fill(void* data, std::size_t from, std::size_t to, std::size_t each) {
        auto* first = static_cast<std::uint8_t*>(data) + (from - 1) * each;
        std::size_t done = 1;
        const std::size_t all = to - from + 1;
        while (done < all) {
            const std::size_t more = std::min(done, all - done);
            std::memcpy(first + done * each, first, more * each);
            done += more;
        }
    }
    template <typename Value>
    void transfer(std::optional<Value>& member) {
        bool has = member.has_value();
        raw(&has, sizeof has);
        if (reads() && has != member.has_value()) {
            if (has) {
                member.emplace();
            } else {
                member.reset();
            }
        }
        if (has) transfer(*member);
    }
    template <typename Entry>
    void entries(Entry* first, std::size_t count) {
        if constexpr (owns_nothing<Entry> && !has_fields<Entry>::value) {
            note(sizeof(Entry));
            if (count > 0) raw(static_cast<void*>(first), count * sizeof(Entry));
        } else {
            for (std::size_t i = 0; i < count; ++i) transfer(first[i]);
        }
    }
    /// Number of entries: writes `size`; or reads one for which the bytes suffice.
    std::size_t room(std::size_t size, std::size_t least_bytes) {
        std::uint64_t count = size;
        raw(&count, sizeof count);
        if (reads() && count > left_ / least_bytes) throw too_short();
        return static_cast<std::size_t>(count);
    }
    void raw(void* data, std::size_t size) {
        if (!reads()) {
            const auto* bytes = static_cast<const std::uint8_t*>(data);
            out_->insert(out_->end(), bytes, bytes + size);
            return;
        }
        if (size > left_) throw too_short();
        std::memcpy(data, in_, size);
        in_ += size;
        left_ -= size;
    }
    void note(std::size_t size) { layout_ = (layout_ ^ size) * 0x100000001B3ULL; }
    static StateArchiveError too_short() {
        return StateArchiveError(QT_TRANSLATE_NOOP("errors",
                                                   "the stored state ends too early: it does not belong to "
                                                   "this scene in this version of the program"));
    }

    static constexpr std::size_t most_bytes = 256U << 20U;  ///< of one vector

    std::vector<std::uint8_t>* out_ = nullptr;
    std::vector<std::uint32_t>* starts_ = nullptr;
    const std::uint8_t* in_ = nullptr;
    std::size_t left_ = 0;
    std::uint64_t layout_ = 0xCBF29CE484222325ULL ^ 2;  ///< 2: tables up to where they are used
};

}  // namespace fulcrum
