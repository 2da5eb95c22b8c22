// SPDX-License-Identifier: GPL-3.0-or-later
// Ghosts that were made, by scene and task; kept while the program runs.
#pragma once

#include <atomic>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "assessment/attempt/ghost.h"
#include "database/scoring/loaded_task.h"

namespace fulcrum::app {

class Ghosts {
  public:
    explicit Ghosts(std::uint64_t seed) : seed_(seed) {}
    /// Makes the ghost of a task, unless it was made before; may outlive this object, on any thread.
    std::function<std::shared_ptr<const GhostPath>(const std::atomic<bool>&)> maker(
        const LoadedTask& loaded) const {
        return [loaded, kept = kept_, seed = seed_](const std::atomic<bool>& stop) {
            const std::string key = loaded.task.id + '\n' + loaded.scene_text;
            {
                const std::lock_guard<std::mutex> lock(kept->mutex);
                if (const auto found = kept->made.find(key); found != kept->made.end()) return found->second;
            }
            auto made = make_ghost(loaded.scene, loaded.task, seed, [&stop] { return !stop.load(); });
            const std::lock_guard<std::mutex> lock(kept->mutex);
            if (made != nullptr) kept->made[key] = made;
            return made;
        };
    }

  private:
    struct Kept {
        std::mutex mutex;
        std::map<std::string, std::shared_ptr<const GhostPath>> made;
    };
    std::uint64_t seed_;
    std::shared_ptr<Kept> kept_ = std::make_shared<Kept>();
};

}  // namespace fulcrum::app
