// SPDX-License-Identifier: Apache-2.0
// The newest value of something in memory that two processes share: one writer, any number of readers.
//
// Neither side waits for the other. A reader gives up after a few tries, so a writer that died in the middle
// of a write does not stop it. What is read is what bytes were there: a reader that does not trust the writer
// checks the values. No lock, allocation, system call or exception; haptic threads.
#pragma once

#include <array>
#include <atomic>
#include <cstdint>
#include <cstring>
#include <type_traits>

namespace fulcrum {

template <typename T>
class SharedLatest {
    static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(std::uint64_t) == 0);
    static constexpr std::size_t count = sizeof(T) / sizeof(std::uint64_t);

  public:
    /// The one writer.
    void write(const T& value) noexcept {
        std::array<std::uint64_t, count> words;
        std::memcpy(words.data(), &value, sizeof(T));
        const std::uint64_t version = version_.load(std::memory_order_relaxed) | 1U;
        version_.store(version, std::memory_order_relaxed);
        // A reader that sees one of the new words then also sees the odd version.
        for (std::size_t i = 0; i < count; ++i) words_[i].store(words[i], std::memory_order_release);
        version_.store(version + 1, std::memory_order_release);
    }
    /// False, with `value` unchanged, before the first write and where every try met a write.
    bool read(T& value) const noexcept {
        for (int attempt = 0; attempt < tries; ++attempt) {
            const std::uint64_t version = version_.load(std::memory_order_acquire);
            if (version == 0) return false;
            if (version % 2 != 0) continue;
            std::array<std::uint64_t, count> words;
            for (std::size_t i = 0; i < count; ++i) words[i] = words_[i].load(std::memory_order_acquire);
            if (version_.load(std::memory_order_relaxed) != version) continue;
            std::memcpy(static_cast<void*>(&value), words.data(), sizeof(T));
            return true;
        }
        return false;
    }

  private:
    static constexpr int tries = 16;
    std::atomic<std::uint64_t> version_{0};  // odd while it is written
    std::array<std::atomic<std::uint64_t>, count> words_{};
    static_assert(std::atomic<std::uint64_t>::is_always_lock_free);
};

}  // namespace fulcrum
