// SPDX-License-Identifier: Apache-2.0
// The two hand-offs between threads: a fixed single-producer single-consumer ring, and a triple buffer for
// the latest value.
#pragma once

#include <readerwriterqueue/readerwriterqueue.h>

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#if defined(__SANITIZE_THREAD__)
// The queue orders its two threads by fences, which ThreadSanitizer does not see: each ring tells it what
// they promise.
extern "C" {
void AnnotateHappensBefore(const char* file, int line, const volatile void* address);
void AnnotateHappensAfter(const char* file, int line, const volatile void* address);
}
#endif

namespace fulcrum {

/// Fixed-capacity ring, one producer thread, one consumer thread. push() never blocks or allocates: a full
/// ring counts what it refuses.
template <typename T>
class Ring {
  public:
    /// Touches all its memory: no push() meets a page that is not there yet.
    explicit Ring(std::size_t capacity) : queue_(capacity) {
        T value{};
        while (queue_.try_enqueue(value)) {
        }
        while (queue_.try_dequeue(value)) {
        }
    }
    /// Producer. False (and counted) when full.
    bool push(const T& value) noexcept {
        observe(&popped_);
        promise(&pushed_);
        if (queue_.try_enqueue(value)) return true;
        lost_.fetch_add(1, std::memory_order_relaxed);
        return false;
    }
    /// Consumer. False when empty.
    bool pop(T& value) noexcept {
        if (!queue_.try_dequeue(value)) return false;
        observe(&pushed_);
        promise(&popped_);
        return true;
    }
    /// How many values were refused so far; any thread.
    std::uint64_t lost() const noexcept { return lost_.load(std::memory_order_relaxed); }

  private:
#if defined(__SANITIZE_THREAD__)
    static void promise(const char* what) noexcept {
        AnnotateHappensBefore(__FILE__, __LINE__, what);
    }
    static void observe(const char* what) noexcept {
        AnnotateHappensAfter(__FILE__, __LINE__, what);
    }
#else
    static void promise(const char* /*what*/) noexcept {}
    static void observe(const char* /*what*/) noexcept {}
#endif
    moodycamel::ReaderWriterQueue<T> queue_;
    std::atomic<std::uint64_t> lost_{0};
    char pushed_ = 0, popped_ = 0;  // their addresses name the two promises
};

/// Latest value from one writer thread to one reader thread, wait-free both ways. T is copied by the writer
/// into write_slot() and published; the reader sees the newest published value and keeps it until it asks
/// again.
template <typename T>
class TripleBuffer {
  public:
    /// Writer: the slot to fill; its content is an older value, not the newest.
    T& write_slot() noexcept { return slots_[write_]; }
    /// Writer: makes the filled slot the newest.
    void publish() noexcept {
        write_ = shared_.exchange(write_ | fresh_bit, std::memory_order_acq_rel) & index_mask;
    }
    /// Reader: takes the newest value if there is a fresh one; true if the value changed.
    bool update() noexcept {
        if ((shared_.load(std::memory_order_acquire) & fresh_bit) == 0U) return false;
        read_ = shared_.exchange(read_, std::memory_order_acq_rel) & index_mask;
        return true;
    }
    /// Reader: the value last taken by update().
    const T& value() const noexcept { return slots_[read_]; }
    /// Before the threads start: gives every slot the same value (and so its capacity).
    void fill(const T& value) {
        for (auto& slot : slots_) slot = value;
    }

  private:
    static constexpr std::uint32_t fresh_bit = 4, index_mask = 3;
    std::array<T, 3> slots_{};
    std::atomic<std::uint32_t> shared_{1};
    std::uint32_t write_ = 0, read_ = 2;
};

}  // namespace fulcrum
