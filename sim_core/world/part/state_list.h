// SPDX-License-Identifier: Apache-2.0
// The list of a part's state members. Each part names its members once, in Part::list_state(); hash, save,
// restore, bytes of a key frame and memory use all walk that list, so that none of them can forget a member.
//
// The order of the hashed members is the order in which they enter the hash that a replay is compared by.
// Changing it changes every state hash.
#pragma once

#include <any>
#include <array>
#include <cstddef>
#include <cstdint>
#include <type_traits>
#include <utility>
#include <vector>

#include "sim_core/numerics/state_archive.h"
#include "sim_core/numerics/state_hash.h"

namespace fulcrum {

class StateList {
  public:
    /// Copies of all members, in the order of the list.
    using Values = std::vector<std::any>;

    /// Adds the hashed members to `hash`. Reads members only; neither allocates nor throws.
    explicit StateList(StateHash& hash) : hash_(&hash) {}
    /// Appends a copy of every member to `values`. Reads members only.
    explicit StateList(Values& values) : save_(&values) {}
    /// Assigns to every member its copy. Throws std::bad_any_cast where they come from another list.
    explicit StateList(const Values& values) : restore_(&values) {}
    /// Writes or reads every member. Reading throws StateArchiveError.
    explicit StateList(StateArchive& archive) : archive_(&archive) {}
    /// Sums the memory that members own.
    explicit StateList(std::size_t& bytes) : bytes_(&bytes) {}

    /// A member that is saved but does not enter the hash.
    template <typename Member>
    StateList& kept(Member& member) {
        return visit(member, [](StateHash&) {});
    }
    /// A member whose numbers all enter the hash.
    template <typename Member>
    StateList& hashed(Member& member) {
        return visit(member, [&member](StateHash& hash) { add(hash, member); });
    }
    /// A member of which `enter(hash)` adds what enters the hash.
    template <typename Member, typename Enter>
    StateList& hashed(Member& member, Enter&& enter) {
        return visit(member, enter);
    }
    /// State behind an interface: get() returns a copy, set(copy) restores it, bytes() is its memory.
    template <typename Get, typename Set, typename Enter, typename Bytes>
    StateList& hashed_through(Get&& get, Set&& set, Enter&& enter, Bytes&& bytes) {
        using Value = std::decay_t<decltype(get())>;
        through(get, set, enter, bytes);
        if (archive_ != nullptr) {
            Value value = get();
            (*archive_)(value);
            if (archive_->reads()) set(value);
        }
        return *this;
    }
    /// As above, where `owner` has fields(): its bytes are written and read in place, without a copy.
    template <typename Get, typename Set, typename Enter, typename Bytes, typename Owner>
    StateList& hashed_through(Get&& get, Set&& set, Enter&& enter, Bytes&& bytes, Owner& owner) {
        through(get, set, enter, bytes);
        if (archive_ != nullptr) (*archive_)(owner);
        return *this;
    }
    /// What enters the hash at this place of members that are listed elsewhere.
    template <typename Enter>
    StateList& also_hashed(Enter&& enter) {
        if (hash_ != nullptr) enter(*hash_);
        return *this;
    }

  private:
    template <typename Get, typename Set, typename Enter, typename Bytes>
    void through(Get&& get, Set&& set, Enter&& enter, Bytes&& bytes) {
        using Value = std::decay_t<decltype(get())>;
        if (hash_ != nullptr) enter(*hash_);
        if (save_ != nullptr) save_->emplace_back(std::in_place_type<Value>, get());
        if (restore_ != nullptr) set(std::any_cast<const Value&>(restore_->at(next_++)));
        if (bytes_ != nullptr) *bytes_ += static_cast<std::size_t>(bytes());
    }
    template <typename Member, typename Enter>
    StateList& visit(Member& member, Enter&& enter) {
        if (hash_ != nullptr) enter(*hash_);
        if constexpr (std::is_array_v<Member>) {
            for (auto& entry : member) move(entry);
        } else {
            move(member);
        }
        return *this;
    }
    template <typename Member>
    void move(Member& member) {
        if (save_ != nullptr) save_->emplace_back(member);
        if (restore_ != nullptr) member = std::any_cast<const Member&>(restore_->at(next_++));
        if (archive_ != nullptr) (*archive_)(member);
        if (bytes_ != nullptr) *bytes_ += owned(member, 0);
    }
    template <typename Entry>
    static std::size_t owned(const std::vector<Entry>& member, int) {
        return member.capacity() * sizeof(Entry);
    }
    template <typename Member>
    static auto owned(const Member& member, int) -> decltype(static_cast<std::size_t>(member.bytes())) {
        return static_cast<std::size_t>(member.bytes());
    }
    template <typename Member>
    static std::size_t owned(const Member&, long) {
        return 0;
    }
    template <typename Number>
    static void add(StateHash& hash, const Number& number) {
        if constexpr (std::is_floating_point_v<Number>) {
            hash.add(static_cast<double>(number));
        } else if constexpr (std::is_integral_v<Number> || std::is_enum_v<Number>) {
            hash.add(static_cast<std::int64_t>(number));
        } else {
            hash.add(number);
        }
    }
    template <typename Entry>
    static void add(StateHash& hash, const std::vector<Entry>& member) {
        for (const Entry& entry : member) add(hash, entry);
    }
    template <typename Entry, std::size_t Count>
    static void add(StateHash& hash, const Entry (&member)[Count]) {
        for (const Entry& entry : member) add(hash, entry);
    }

    StateHash* hash_ = nullptr;
    Values* save_ = nullptr;
    const Values* restore_ = nullptr;
    StateArchive* archive_ = nullptr;
    std::size_t* bytes_ = nullptr;
    std::size_t next_ = 0;
};

}  // namespace fulcrum
